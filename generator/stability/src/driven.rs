//! The points of a controller with P at them. No weight, no loop.

use crate::drive::Value;
use crate::frequency::{Point, Points};
use crate::{Controller, Drive};
use std::f64::consts::PI;

/// A point with P at it.
pub(crate) type At = (Point, Value);

/// A controller with a drive.
#[derive(Clone)]
pub(crate) struct Driven<'a> {
    controller: &'a Controller<'a>,
    drive: Drive<'a>,
    pub(crate) points: &'a [Point],
    /// P at the points
    values: Vec<Value>,
}

impl<'a> Driven<'a> {
    pub(crate) fn new(Points { controller, points }: &'a Points<'a>, drive: Drive<'a>) -> Self {
        let values = points.iter().map(|point| drive.at(controller, point)).collect();
        Self { controller, drive, points, values }
    }

    pub(crate) fn is_uncertain(&self) -> bool {
        matches!(self.drive, Drive::Measured(_))
    }

    pub(crate) fn all(&self) -> impl Iterator<Item = At> {
        self.points.iter().copied().zip(self.values.iter().copied())
    }

    /// A frequency [Hz] as t.
    pub(crate) fn at_hz(&self, hz: f64) -> At {
        self.at_t(libm::tan(PI * hz * self.controller.cycle_time))
    }

    pub(crate) fn at_t(&self, t: f64) -> At {
        self.at(self.controller.at(t))
    }

    pub(crate) fn middle(&self, a: &Point, b: &Point) -> At {
        self.at(self.controller.middle(a, b))
    }

    fn at(&self, point: Point) -> At {
        (point, self.drive.at(self.controller, &point))
    }
}

//! The motion of one spindle or axis: jerk-limited, from any moving start, to a speed or a position, sample by sample.
//! Lengths are in the unit of the caller, times in seconds.
//!
//! The profiles are those of `rsruckig`, the fastest within the limits. It compares with absolute tolerances of about 1e-8,
//! so it gets velocities relative to the largest one, and positions relative to the start of the motion.

use portable::Extreme;
use rsruckig::prelude::{
    ControlInterface, DataArrayOrVec, InputParameter, Ruckig, RuckigResult, ThrowErrorHandler, Trajectory,
};
use std::fmt;

/// Limits of every motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// [1/s]
    pub velocity: f64,
    /// [1/s^2]
    pub acceleration: f64,
    /// [1/s^3]
    pub jerk: f64,
}

/// The state of a mover at the end of a cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    pub x: f64,
    pub v: f64,
    pub a: f64,
    /// jerk of the time that begins here; 0 at the end
    pub j: f64,
}

/// The reason why a motion cannot be planned.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// a number that is not finite, a limit or a cycle time that is not above 0, a speed above the limit: its name and its value
    Number { name: &'static str, value: f64 },
    /// the message of the library if it finds no profile
    NoProfile(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number { name, value } => write!(f, "{name} is {value}, which is out of its range"),
            Self::NoProfile(reason) => write!(f, "no jerk-limited profile: {reason}"),
        }
    }
}

impl std::error::Error for Error {}

/// One spindle or axis that moves.
#[derive(Clone, Debug)]
pub struct Mover {
    limits: Limits,
    cycle: f64,
    now: Sample,
    plan: Option<Plan>,
}

/// A motion from one sample on.
#[derive(Clone, Debug)]
struct Plan {
    sections: Vec<Section>,
    /// its exact end, because the last digit of a profile may be wrong
    end: Sample,
    /// cycles since its beginning
    cycles: u32,
}

/// A profile of the library.
#[derive(Clone, Debug)]
struct Section {
    profile: Box<Trajectory<1>>,
    /// origin of its positions
    from: f64,
    /// times of its beginning and its end, from the beginning of the motion [s]
    begin: f64,
    end: f64,
}

impl Mover {
    /// Moves at a speed, limited by `velocity`, until there is a target. The cycle time is in s.
    pub fn at(limits: Limits, cycle: f64, x: f64, v: f64) -> Result<Self, Error> {
        for (name, value) in [
            ("the limit of the velocity", limits.velocity),
            ("the limit of the acceleration", limits.acceleration),
            ("the limit of the jerk", limits.jerk),
            ("the cycle time", cycle),
        ] {
            within(name, value, value.is_finite() && value > 0.0)?;
        }
        within("the position", x, x.is_finite())?;
        within("the velocity", v, v.abs() <= limits.velocity)?;
        Ok(Self { limits, cycle, now: Sample { x, v, a: 0.0, j: 0.0 }, plan: None })
    }

    /// The present sample.
    pub fn now(&self) -> Sample {
        self.now
    }

    /// Plans a motion to a speed, which is then kept. After an error the motion is unchanged.
    pub fn turn(&mut self, v_target: f64) -> Result<(), Error> {
        within("the target velocity", v_target, v_target.abs() <= self.limits.velocity)?;
        let section = self.section(self.to_speed(self.now, v_target), self.now.x, 0.0)?;
        let x = self.position(&section, section.end);
        self.plan = Some(Plan { sections: vec![section], end: Sample { x, v: v_target, a: 0.0, j: 0.0 }, cycles: 0 });
        Ok(())
    }

    /// Plans a motion to a stop at a position, at most at `v_max`; it returns if the distance is too short to stop. From a
    /// speed above `v_max` it first slows down. After an error the motion is unchanged.
    pub fn go(&mut self, x_target: f64, v_max: f64) -> Result<(), Error> {
        within("the target position", x_target, x_target.is_finite())?;
        within("the velocity of the way", v_max, v_max > 0.0 && v_max <= self.limits.velocity)?;
        let mut sections = Vec::new();
        let mut start = self.now;
        // The speed when the acceleration has been reduced to 0. Above v_max the library would brake with the full
        // acceleration down to v_max, and then fall below it or even reverse before it stays at v_max.
        let reached = start.v + start.a * start.a.abs() / (2.0 * self.limits.jerk);
        if reached.abs() > v_max {
            let v = v_max.copysign(reached);
            let slower = self.section(self.to_speed(start, v), start.x, 0.0)?;
            let x = self.position(&slower, slower.end);
            // If the target cannot be reached from there without reversing, the library's fastest motion is used.
            if (x_target - x) * v.signum() >= self.stopping_distance(v_max) {
                start = Sample { x, v, a: 0.0, j: 0.0 };
                sections.push(slower);
            }
        }
        let mut input = self.input(start);
        input.target_position[0] = (x_target - start.x) / self.limits.velocity;
        input.max_velocity[0] = v_max / self.limits.velocity;
        sections.push(self.section(input, start.x, sections.last().map_or(0.0, |section| section.end))?);
        self.plan = Some(Plan { sections, end: Sample { x: x_target, ..Sample::default() }, cycles: 0 });
        Ok(())
    }

    /// Advances by one cycle.
    #[expect(clippy::should_implement_trait, reason = "a motion has no end that an iterator could have")]
    pub fn next(&mut self) -> Sample {
        let Some(plan) = &mut self.plan else {
            self.now.x += self.now.v * self.cycle;
            return self.now;
        };
        plan.cycles = plan.cycles.saturating_add(1);
        let time = f64::from(plan.cycles) * self.cycle;
        let Some(section) = plan.sections.iter().find(|section| time < section.end) else {
            let late = time - plan.sections.last().map_or(time, |section| section.end);
            self.now = Sample { x: plan.end.x + plan.end.v * late, ..plan.end };
            self.plan = None;
            return self.now;
        };
        let scale = self.limits.velocity;
        let Sample { x, v, a, j } = state(&section.profile, time - section.begin);
        self.now = Sample { x: section.from + x * scale, v: v * scale, a: a * scale, j: j * scale };
        self.now
    }

    /// Whether the target is reached; true without a target.
    pub fn is_done(&self) -> bool {
        self.plan.is_none()
    }

    /// The distance to stop from a speed: half of the speed for the time dv / a + a / j, with the reached acceleration.
    fn stopping_distance(&self, v: f64) -> f64 {
        let Limits { acceleration, jerk, .. } = self.limits;
        let reached = acceleration.smaller((v * jerk).sqrt());
        v / 2.0 * (v / reached + reached / jerk)
    }

    fn to_speed(&self, start: Sample, v: f64) -> InputParameter<1> {
        let mut input = self.input(start);
        input.control_interface = ControlInterface::Velocity;
        input.target_velocity[0] = v / self.limits.velocity;
        input
    }

    /// A sample with its position as 0, and the limits, in the form of the library.
    fn input(&self, start: Sample) -> InputParameter<1> {
        let Limits { velocity, acceleration, jerk } = self.limits;
        let mut input = InputParameter::new(None);
        input.current_velocity[0] = start.v / velocity;
        input.current_acceleration[0] = start.a / velocity;
        input.max_velocity[0] = 1.0;
        input.max_acceleration[0] = acceleration / velocity;
        input.max_jerk[0] = jerk / velocity;
        input
    }

    fn section(&self, input: InputParameter<1>, from: f64, begin: f64) -> Result<Section, Error> {
        let mut profile = Box::new(Trajectory::new(None));
        let result = Ruckig::<1, ThrowErrorHandler>::new(None, self.cycle)
            .calculate(&input, &mut profile)
            .map_err(|error| Error::NoProfile(error.to_string()))?;
        let duration = profile.get_duration();
        if result != RuckigResult::Working || !duration.is_finite() || !state(&profile, duration).x.is_finite() {
            return Err(Error::NoProfile(format!("{result:?} after {duration} s")));
        }
        Ok(Section { profile, from, begin, end: begin + duration })
    }

    fn position(&self, section: &Section, time: f64) -> f64 {
        section.from + state(&section.profile, time - section.begin).x * self.limits.velocity
    }
}

/// The state of a profile, in the units of the library.
fn state(profile: &Trajectory<1>, time: f64) -> Sample {
    let zero = || DataArrayOrVec::new(None, 0.0);
    let (mut x, mut v, mut a, mut j) = (zero(), zero(), zero(), zero());
    profile.at_time(time, &mut Some(&mut x), &mut Some(&mut v), &mut Some(&mut a), &mut Some(&mut j), &mut None);
    Sample { x: x[0], v: v[0], a: a[0], j: j[0] }
}

fn within(name: &'static str, value: f64, is_good: bool) -> Result<(), Error> {
    if is_good { Ok(()) } else { Err(Error::Number { name, value }) }
}

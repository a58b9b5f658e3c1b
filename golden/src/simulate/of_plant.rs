//! The loop of the demonstration plant: its response, and Ms.

use crate::drive::margins::margins;
use generator::analysis;
use generator::axis::{DriveModel, MeasuredDrive, Mode};
use generator::blocks::Designed;
use machine::Machine;
use machine::measure::fourier;
use machine::plant::Plant;
use portable::Extreme;
use stability::{Complex64, Curve, Response};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Cycles of the plant's impulse response: 16 s at 1 ms, in which all its vibrations decay.
const CYCLES: usize = 16_384;
/// Lines of its response, and the lowest one [Hz].
const LINES: u32 = 2_000;
const LOWEST: f64 = 0.5;
/// The plant without its mesh is linear: the size of the impulse does not matter [m/s].
const IMPULSE: f64 = 1.0;

/// A loop with a plant as drive: its position is measured, not the sum of its measured velocities.
pub(super) struct OfPlant {
    /// its response from v_cmd to the measured v_motor, and the gain of its position controller
    pub model: DriveModel,
    /// response from v_cmd to the change of the measured position in a cycle
    change: Response,
    cycle: f64,
}

impl OfPlant {
    /// From the plant's impulse response; the gain of the position controller is in 1/s.
    pub(super) fn new(plant: &Plant, position_gain: f64) -> Self {
        let mut running = plant.without_mesh().at_rest();
        let cycle = running.cycle();
        // The measurement in a cycle is the answer to the previous commands.
        let (mut v, mut change, mut x) = (vec![0.0], vec![0.0], 0.0);
        for n in 0..CYCLES {
            let measured = running.step(if n == 0 { IMPULSE } else { 0.0 });
            v.push(measured.v_motor / IMPULSE);
            change.push((measured.x - x) / cycle / IMPULSE);
            x = measured.x;
        }
        let response = |samples: &[f64]| {
            let hz = frequencies(cycle);
            let lines = hz.iter().map(|hz| fourier(samples, TAU * hz * cycle));
            let lines: Vec<Complex64> = lines.map(|[re, im]| Complex64::new(re, im)).collect();
            Response::new(&hz, &lines, &vec![0.0; hz.len()], cycle)
        };
        let file = "the demonstration plant".to_owned();
        let measured = MeasuredDrive { file, response: Arc::new(response(&v)), delay: 0.0 };
        let model =
            DriveModel { response: Some(measured), position_gain: Some(position_gain), ..DriveModel::default() };
        Self { model, change: response(&change), cycle }
    }

    /// Ms of the loop with the stages of an axis; `None` if it is unstable.
    pub(super) fn ms(&self, designed: &Designed) -> Option<f64> {
        if !margins(designed, &self.model).stable {
            return None;
        }
        let of_stages = analysis::analyze(designed, &self.model).drives.into_iter().next();
        let of_stages = of_stages.filter(|_| designed.axis.ipc.is_active());
        let nearest = match of_stages {
            Some(of) => of.curve.iter().map(|point| self.open(designed, point) + 1.0).collect(),
            None => frequencies(self.cycle).into_iter().map(|hz| self.position(hz) + 1.0).collect::<Vec<_>>(),
        };
        let nearest = nearest.iter().map(Complex64::norm_sqr);
        Some(1.0 / nearest.fold(f64::INFINITY, f64::smaller).sqrt())
    }

    /// The open loop with stages, with the measured position instead of the sum of the velocities.
    fn open(&self, designed: &Designed, point: &Curve) -> Complex64 {
        let modes = designed.axis.ipc.stage.iter().map(|stage| stage.as_ref().map(|stage| stage.mode));
        let sum = |through_position: bool| {
            let is_meant = |mode: &Option<Mode>| matches!(mode, Some(Mode::SetPoint { .. })) == through_position;
            let stages = point.stage.iter().zip(modes.clone()).filter(|(_, mode)| is_meant(mode));
            stages.map(|(stage, _)| stage).sum::<Complex64>()
        };
        let gain_t = self.model.position_gain.unwrap_or(0.0) * self.cycle;
        let controller = stability::position(gain_t, libm::tan(PI * point.hz * self.cycle));
        self.position(point.hz) * (1.0 - sum(true) / controller) - sum(false) * point.drive
    }

    /// The part of the open loop from the position loop.
    fn position(&self, hz: f64) -> Complex64 {
        let (sin, cos) = libm::sincos(TAU * hz * self.cycle);
        let gain = self.model.position_gain.unwrap_or(0.0) * self.cycle;
        self.change.value(hz) * gain / Complex64::new(1.0 - cos, sin)
    }
}

/// Frequencies from the lowest line to the Nyquist frequency, evenly on a logarithmic scale [Hz].
fn frequencies(cycle: f64) -> Vec<f64> {
    let part = |k: u32| f64::from(k) / f64::from(LINES - 1);
    (0..LINES).map(|k| LOWEST * libm::pow(0.5 / cycle / LOWEST, part(k))).collect()
}

//! Ms of the loop that is simulated: of the axis by its analysis, of the position loop alone, and the response of the demonstration plant.

use generator::analysis;
use generator::axis::{DriveModel, MeasuredDrive};
use generator::blocks::Designed;
use machine::Machine;
use machine::measure::fourier;
use machine::plant::Plant;
use stability::{Band, Complex64, Controller, Drive, Loop, Margins, Points, Response, STAGES};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Cycles of the plant's impulse response: 16 s at 1 ms, in which every vibration of it is gone.
const CYCLES: usize = 16_384;
/// Lines of its response, and the lowest one [Hz].
const LINES: u32 = 2_000;
const LOWEST: f64 = 0.5;
/// The plant is linear without its mesh: any impulse does [m/s].
const IMPULSE: f64 = 1.0;

/// The loop with the stages of an axis; without stages the position loop alone.
pub(super) fn margins(designed: &Designed, model: &DriveModel) -> Margins {
    match analysis::analyze(designed, model).drives.into_iter().next() {
        Some(of) if is_on(designed) => of.margins,
        _ => of_position(designed.axis.cycle_time(), model),
    }
}

/// Whether a stage acts.
fn is_on(designed: &Designed) -> bool {
    designed.axis.ipc.stage.iter().any(Option::is_some)
}

/// The position loop alone.
fn of_position(cycle_time: f64, model: &DriveModel) -> Margins {
    let drive = match &model.response {
        Some(measured) => Drive::Measured(&measured.response),
        None => Drive::Delay { cycles: model.delay_cycles.unwrap_or(1.0), time_constant: model.time_constant },
    };
    let nyquist = 0.5 / cycle_time;
    let controller = Controller {
        cycle_time,
        weight: [0.0; STAGES],
        stage: Box::new(|_| [Complex64::new(0.0, 0.0); STAGES]),
        // Where a position loop has its corner, about.
        bands: vec![Band { centre: nyquist / 50.0, width: nyquist / 50.0 }],
        position_gain: model.position_gain,
    };
    let points = Points::new(controller, &[drive]);
    Loop::new(&points, drive).margins()
}

/// The response of a plant from v_cmd to the measured v_motor, with the gain of its position controller [1/s].
pub(super) fn of_plant(plant: &Plant, position_gain: f64) -> DriveModel {
    let mut running = plant.without_mesh().at_rest();
    // What is measured in a cycle is the answer to the commands before.
    let mut impulse = vec![0.0];
    impulse.extend((0..CYCLES).map(|n| running.step(if n == 0 { IMPULSE } else { 0.0 }).v_motor / IMPULSE));
    let cycle = running.cycle();
    let nyquist = 0.5 / cycle;
    let part = |k: u32| f64::from(k) / f64::from(LINES - 1);
    let hz: Vec<f64> = (0..LINES).map(|k| LOWEST * libm::pow(nyquist / LOWEST, part(k))).collect();
    let lines = hz.iter().map(|hz| fourier(&impulse, TAU * hz * cycle));
    let lines: Vec<Complex64> = lines.map(|[re, im]| Complex64::new(re, im)).collect();
    let response = Response::new(&hz, &lines, &vec![0.0; hz.len()], cycle);
    let measured = MeasuredDrive { file: "the demonstration plant".to_owned(), response: Arc::new(response) };
    DriveModel { response: Some(measured), position_gain: Some(position_gain), ..DriveModel::default() }
}

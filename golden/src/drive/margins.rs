//! The loop that an axis closes with its drive: with stages from the analysis of their loop, without stages the position
//! loop alone.

use generator::analysis;
use generator::axis::{Axis, DriveModel};
use generator::blocks::Designed;
use stability::{Band, Complex64, Controller, Drive, Loop, Margins, Points, STAGES};

/// Ms of the loop with the stages of an axis; `None` if it is unstable, or may be.
pub(crate) fn ms(designed: &Designed, model: &DriveModel) -> Option<f64> {
    margins(designed, model).ms.map(|[ms, _]| ms)
}

/// The loop with the stages of an axis; without stages the position loop alone. A machine without mechanics has one velocity:
/// a stage with the input `v_direct` closes the loop like one with `v_motor`.
pub(crate) fn margins(designed: &Designed, model: &DriveModel) -> Margins {
    let designed = &*analysis::on_a_rigid_axis(designed);
    match analysis::analyze(designed, model).drives.into_iter().next() {
        Some(of) if designed.axis.ipc.is_active() => of.margins,
        _ => of_position(&designed.axis, model),
    }
}

/// The position loop alone.
fn of_position(axis: &Axis, model: &DriveModel) -> Margins {
    let (cycle_time, [position_gain, gain_in_drive]) = (axis.cycle_time(), axis.control.placed(model.position_gain));
    let drive = match &model.response {
        Some(measured) => Drive::Measured(&measured.response),
        None => Drive::Delay { cycles: model.delay_cycles.unwrap_or(1.0), time_constant: model.time_constant },
    };
    let nyquist = 0.5 / cycle_time;
    let controller = Controller {
        cycle_time,
        weight: [0.0; STAGES],
        stage: Box::new(|_| [Complex64::new(0.0, 0.0); STAGES]),
        // The approximate corner frequency of a position loop.
        bands: vec![Band { centre: nyquist / 50.0, width: nyquist / 50.0 }],
        position_gain,
        gain_in_drive,
    };
    let points = Points::new(controller, &[drive]);
    Loop::new(&points, drive).margins()
}

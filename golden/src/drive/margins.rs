//! The loop that an axis closes with its drive: with stages from the analysis of their loop, without stages the position
//! loop alone.

use generator::analysis;
use generator::axis::{Axis, DirectSource, DriveModel, Mode, Stage};
use generator::blocks::Designed;
use stability::{Band, Complex64, Controller, Drive, Loop, Margins, Points, STAGES};
use std::borrow::Cow;

/// Ms of the loop with the stages of an axis; `None` if it is unstable, or may be.
pub(crate) fn ms(designed: &Designed, model: &DriveModel) -> Option<f64> {
    margins(designed, model).ms.map(|[ms, _]| ms)
}

/// The loop with the stages of an axis; without stages the position loop alone. A machine without mechanics has one velocity:
/// a stage with the input `v_direct` closes the loop like one with `v_motor`.
pub(crate) fn margins(designed: &Designed, model: &DriveModel) -> Margins {
    let designed = &*of_motor(designed);
    match analysis::analyze(designed, model).drives.into_iter().next() {
        Some(of) if designed.axis.ipc.is_active() => of.margins,
        _ => of_position(&designed.axis, model),
    }
}

/// The axis with `v_motor` as the input of its stages that have `v_direct`.
fn of_motor(designed: &Designed) -> Cow<'_, Designed> {
    if !looks_at_load(designed) {
        return Cow::Borrowed(designed);
    }
    let mut axis = designed.axis.clone();
    let stages = axis.ipc.stage.iter_mut().flatten().filter(|stage| is_of_load(stage));
    stages.for_each(|stage| stage.mode = Mode::Direct { source: DirectSource::Motor });
    Cow::Owned(Designed::from(axis))
}

/// Whether a stage acts on the velocity of the load, `v_direct`.
pub(crate) fn looks_at_load(designed: &Designed) -> bool {
    designed.axis.ipc.stage.iter().flatten().any(is_of_load)
}

fn is_of_load(stage: &Stage) -> bool {
    matches!(stage.mode, Mode::Direct { source: DirectSource::Direct })
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

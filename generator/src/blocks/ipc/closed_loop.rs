//! The loop that the stages of an axis close through the velocity of the motor or the position controller: the controller of
//! the crate `stability`, and the drives for its analysis.

use super::stage::StageDesign;
use crate::axis::{Axis, Control, DirectSource, DriveModel, Filter, MeasuredDrive, Mode};
use crate::blocks::designed::Designed;
use crate::design::response;
use crate::number::significant;
use crate::parameters::Name;
use reference::stage::Coeffs;
use stability::{Band, Complex64, Controller, Drive, Points, STAGES};
use std::borrow::Cow;

/// Delay of a usual drive: one cycle for the command, and half a cycle for its hold.
const USUAL_DELAY: f64 = 1.5;
/// Time constant of a usual drive with a slow velocity controller [s].
const USUAL_TIME_CONSTANT: f64 = 0.003;

/// The drive of a loop.
#[derive(Clone, Debug, PartialEq)]
pub enum Known {
    /// a pure delay in cycles, and a time constant [s] after it
    Delay { cycles: f64, time_constant: Option<f64> },
    /// a measured response
    Measured(MeasuredDrive),
}

impl Known {
    /// The ideal drive: the motor does exactly what was commanded one cycle before.
    pub(crate) const IDEAL: Self = Self::Delay { cycles: 1.0, time_constant: None };

    /// The stated drive, if any. A measured response contains the time constant, and `drive.delay` too once it was read.
    pub(crate) fn stated(model: &DriveModel) -> Option<Self> {
        match &model.response {
            Some(measured) => Some(Self::Measured(measured.clone())),
            None if model.is_given() => Some(Self::Delay {
                cycles: model.delay_cycles.unwrap_or(USUAL_DELAY),
                time_constant: model.time_constant,
            }),
            None => None,
        }
    }

    /// The drives for the analysis of a loop: the stated one, else two usual ones.
    pub(crate) fn of(model: &DriveModel) -> Vec<Self> {
        let usual = || {
            [None, Some(USUAL_TIME_CONSTANT)].map(|time_constant| Self::Delay { cycles: USUAL_DELAY, time_constant })
        };
        Self::stated(model).map_or_else(|| usual().into(), |stated| vec![stated])
    }

    /// Its response.
    pub(crate) fn drive(&self) -> Drive<'_> {
        match self {
            Self::Delay { cycles, time_constant } => Drive::Delay { cycles: *cycles, time_constant: *time_constant },
            Self::Measured(measured) => Drive::Measured(&measured.response),
        }
    }

    /// Its numbers, or its file.
    #[must_use]
    pub fn short(&self) -> String {
        match self {
            Self::Delay { cycles, time_constant } => {
                let time = time_constant.map_or_else(String::new, |time| format!(", {}", milliseconds(time)));
                delay(*cycles) + &time
            }
            Self::Measured(measured) => measured.file.clone(),
        }
    }

    /// In words.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Delay { cycles, time_constant: None } => format!("a drive that only delays {}", delay(*cycles)),
            Self::Delay { cycles, time_constant: Some(time) } => {
                format!("a delay of {} and a time constant of {}", delay(*cycles), milliseconds(*time))
            }
            Self::Measured(measured) => format!("the drive of {}", measured.file),
        }
    }
}

fn delay(cycles: f64) -> String {
    format!("{} cycle{}", significant(cycles, 4), if cycles > 1.0 { "s" } else { "" })
}

fn milliseconds(time: f64) -> String {
    format!("{} ms", significant(time * 1e3, 4))
}

/// Whether a stage looks at the velocity of the motor.
#[must_use]
pub fn looks_at_motor(mode: Mode) -> bool {
    match mode {
        Mode::Direct { source: DirectSource::Motor } | Mode::Indirect { .. } => true,
        Mode::Direct { source: DirectSource::Direct } | Mode::SetPoint { .. } => false,
    }
}

/// Whether a stage looks at the velocity of the load. What lies between motor and load is not known.
#[must_use]
pub fn looks_at_load(mode: Mode) -> bool {
    mode == Mode::Direct { source: DirectSource::Direct }
}

/// The axis with a rigid load, on which `v_direct` is `v_motor`; the parameters stay as they are.
#[must_use]
pub fn on_a_rigid_axis(designed: &Designed) -> Cow<'_, Designed> {
    if !designed.stage.iter().flatten().any(|design| looks_at_load(design.stage.mode)) {
        return Cow::Borrowed(designed);
    }
    let mut rigid = designed.clone();
    for design in rigid.stage.iter_mut().flatten().filter(|design| looks_at_load(design.stage.mode)) {
        design.stage.mode = Mode::Direct { source: DirectSource::Motor };
    }
    Cow::Owned(rigid)
}

/// The stages that look at the load, which no analysis of the loop contains, in words.
pub(crate) fn not_judged(designed: &Designed) -> Option<String> {
    let stages = designed.stage.iter().flatten().filter(|design| looks_at_load(design.stage.mode));
    let stages: Vec<String> = stages.map(|design| design.index.to_string()).collect();
    (!stages.is_empty()).then(|| {
        format!(
            "stage {} looks at v_direct: it closes a loop through the load that is not judged here",
            stages.join(", ")
        )
    })
}

/// Whether a stage closes a loop through the position controller of the CNC, whose output it takes.
pub(crate) fn acts_through_position(control: &Control, mode: Mode) -> bool {
    match mode {
        Mode::SetPoint { .. } => control.commands_by_position(),
        Mode::Direct { .. } | Mode::Indirect { .. } => false,
    }
}

/// Whether a stage closes a loop; any other stage does not change the stability.
pub(crate) fn closes_loop(control: &Control, mode: Mode) -> bool {
    looks_at_motor(mode) || acts_through_position(control, mode)
}

/// The stages of an axis that close the loop.
pub(crate) fn stages(designed: &Designed) -> impl Iterator<Item = &StageDesign> {
    let control = &designed.axis.control;
    designed.stage.iter().flatten().filter(move |design| closes_loop(control, design.stage.mode))
}

/// Whether a stage of the axis acts through the position controller, so that the loop has one.
fn has_position_loop(designed: &Designed) -> bool {
    designed.stage.iter().flatten().any(|design| acts_through_position(&designed.axis.control, design.stage.mode))
}

/// The gain of the position controller around the stages [1/s]: the stated one. A stage that acts through the controller has
/// one in any case: that which a block uses, or the default.
fn position_gain(designed: &Designed, stated: Option<f64>) -> Option<f64> {
    let control = &designed.axis.control;
    let of_axis = || {
        let default = || Name::Kv.parameter().default_at([0; 2])?.parse().ok();
        control.kv.map(f64::from).or_else(default).map(|hundredths| hundredths / 100.0)
    };
    stated.or_else(|| if has_position_loop(designed) { of_axis() } else { None })
}

/// The position loop around the stages in words; what no parameter states is marked as assumed. `None` without a gain.
pub(crate) fn position_words(designed: &Designed) -> Option<String> {
    let Axis { control, drive, .. } = &designed.axis;
    let gain = significant(position_gain(designed, drive.position_gain)?, 4);
    let kv = format!("Kv {gain}/s{}", if drive.position_gain.is_none() { " assumed" } else { "" });
    Some(match (has_position_loop(designed), control.location) {
        (true, Some(_)) => format!("{kv}, position control in the CNC"),
        (true, None) => format!("{kv}, position control in the CNC assumed"),
        (false, Some(_)) if !control.commands_by_position() => format!("{kv}, position control in the drive"),
        (false, _) => kv,
    })
}

/// The controller of an axis, in a position loop with this gain [1/s], at the points of the frequency axis that these drives
/// need; `None` if no stage closes a loop.
pub(crate) fn points<'d>(designed: &'d Designed, drives: &[Known], stated_gain: Option<f64>) -> Option<Points<'d>> {
    let mut responses = [const { None }; STAGES];
    let mut weight = [0.0; STAGES];
    let mut bands = Vec::new();
    let cycle_time = designed.axis.cycle_time();
    let [position_gain, gain_in_drive] = designed.axis.control.placed(position_gain(designed, stated_gain));
    for design in stages(designed) {
        let response = response::Stage::new(&Coeffs { gain: -1.0, ..design.coeffs });
        // v_command = -Kv T/(z - 1) v_motor
        let gain_t = acts_through_position(&designed.axis.control, design.stage.mode)
            .then(|| -cycle_time * position_gain.unwrap_or_default());
        responses[design.index] = Some((response, gain_t));
        weight[design.index] = design.stage.weight();
        let filters = design.stage.filter.iter().filter_map(Filter::f0_and_q);
        bands.extend(filters.map(|[f0, q_factor]| Band { centre: f0, width: f0 / q_factor }));
    }
    if bands.is_empty() {
        return None;
    }
    let at = |(of, gain_t): &(response::Stage, Option<f64>), t: f64| {
        gain_t.map_or_else(|| of.at(t), |gain_t| of.at(t) * stability::position(gain_t, t))
    };
    let controller = Controller {
        cycle_time,
        weight,
        stage: Box::new(move |t| responses.each_ref().map(|of| of.as_ref().map_or(ZERO, |of| at(of, t)))),
        bands,
        position_gain,
        gain_in_drive,
    };
    Some(Points::new(controller, &drives.iter().map(Known::drive).collect::<Vec<_>>()))
}

const ZERO: Complex64 = Complex64::new(0.0, 0.0);

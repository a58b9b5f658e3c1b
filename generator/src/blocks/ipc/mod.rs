//! The block `ipc`: improved position control.

pub(crate) mod advice;
mod calmer;
pub mod certificate;
pub(crate) mod check;
pub(crate) mod closed_loop;
pub mod design;
mod details;
mod diff;
pub(crate) mod drive_model;
pub(crate) mod drive_response;
pub mod feasibility;
pub(crate) mod filter;
mod never_acts;
pub(crate) mod notes;
mod phase;
pub(crate) mod row;
mod set_point;
pub(crate) mod sets;
pub mod stage;
mod unstable;
mod usual;
pub(super) mod with_sets;

use super::products::VERIFIED;
use super::{BlockKind, Certified, Design, Details, Figure, Summary, Typed};
use crate::axis::{Axis, Stage};
use crate::blocks::designed::Designed;
use crate::design::rounding::literal;
use crate::parameters::words::{StageMode, Words};
use compiler::pass::Defect;
use compiler::program::Program;
use reference::ipc::{Coeffs, Ipc};
use reference::tunable_ipc::TunableIpc;

impl Design for Ipc {
    type Single = f32;

    fn design(designed: &Designed) -> Coeffs<f64> {
        designed.ipc
    }

    fn other(designed: &Designed) -> Option<&'static dyn Typed> {
        designed.axis.ipc.takes_sets().then_some(&TunableIpc)
    }
}

impl BlockKind for Ipc {
    /// An axis without any block gets this block, which outputs 0, and a warning.
    fn is_asked_for(&self, axis: &Axis) -> bool {
        axis.ipc.is_active() || axis.asks_for_nothing_else()
    }

    fn short_name(&self) -> &'static str {
        "ipc"
    }

    fn purpose(&self, designed: &Designed) -> String {
        purpose(designed)
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        with_sets::notes(designed, notes::notes(designed), ["", "ipc."])
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        let ipc = &designed.axis.ipc;
        let (limit, v_max) = (ipc.limit(), ipc.v_max);
        // A narrow band-pass passes little of the noise; much more noise would be a fault.
        [if limit > 0.0 { limit / 16.0 } else { v_max }, (64.0 * limit).clamp(v_max, 16.0 * v_max)]
    }

    /// The number of cycles of the fade.
    fn start_cycles(&self, designed: &Designed) -> usize {
        designed.ipc.fade_cycles as usize
    }

    fn summary(&self, designed: &Designed) -> Summary {
        let (ipc, fade_cycles) = (&designed.axis.ipc, designed.ipc.fade_cycles);
        let start = ipc.enable.name();
        let head = format!(", starts {start}, |v_add| <= {}, fades in {fade_cycles} cycles", ipc.limit());
        let line = |(index, stage): (usize, &Option<Stage>)| {
            let what = stage.as_ref().map_or_else(|| StageMode::NotActive.name().to_owned(), in_short);
            format!("stage[{index}] {what}")
        };
        let stages = ipc.stage.iter().enumerate().map(line);
        Summary { head, lines: stages.chain(ipc.takes_sets().then(|| with_sets::line(designed))).collect() }
    }

    fn details(&self, designed: &Designed) -> Details {
        // A gantry slave's block never acts.
        match designed.axis.control.master {
            Some(_) => Details::default(),
            None => details::details(designed),
        }
    }

    fn differences(&self, old: &Designed, new: &Designed) -> Vec<String> {
        diff::differences(old, new)
    }

    fn added(&self, designed: &Designed) -> Vec<String> {
        diff::added(designed)
    }

    /// The limit of the axis, for a gantry slave too.
    fn limit(&self, designed: &Designed) -> Option<Figure> {
        Some(figure(designed, designed.axis.ipc.limit()))
    }

    fn certificate(&self, designed: &Designed, program: &Program) -> Result<Certified, Defect> {
        // A gantry slave's block never acts: there is nothing to measure.
        if designed.axis.control.master.is_some() {
            return Ok(Certified::default());
        }
        if designed.axis.ipc.takes_sets() {
            let program = Ipc.specialise(self, designed, Some(VERIFIED))?;
            return Ok(with_sets::as_generated(certified(designed, &program)?));
        }
        certified(designed, program)
    }
}

fn purpose(designed: &Designed) -> String {
    let axis = &designed.axis;
    if axis.control.master.is_some() {
        return "Improved position control of a gantry slave: v_add is 0 in every call, because the stages of the master act. Any mode \
                but OFF is a fault."
            .to_owned();
    }
    if !axis.ipc.is_active() {
        return "Improved position control without an active stage: v_add is 0 in every call.".to_owned();
    }
    let start = match axis.ipc.takes_sets() {
        true => "The first call begins to check the offered parameter set; until it is in use, v_add is 0.",
        false => {
            "The first call that finds the mode ON or DRYRUN presets the filters to the present input, with v_add = 0."
        }
    };
    let later = match axis.counts_calls {
        true => "the first call after a pause starts the filters again",
        false => "the next call continues the filters from their old state",
    };
    format!(
        "Improved position control: v_add, added to the velocity command, acts against vibrations of the axis. {start} In ON v_add \
         then fades in. While the block is not called, v_add keeps its last value and must not be added; {later}."
    )
}

/// The proven properties of the block with constants.
fn certified(designed: &Designed, program: &Program) -> Result<Certified, Defect> {
    let certificate = certificate::certify(designed, program);
    certificate.refuse(designed)?;
    let figures = limit(designed).into_iter().chain(certificate::figure(&certificate));
    Ok(Certified { lines: certificate::lines(&certificate), figures: figures.collect() })
}

/// The largest |v_add| that an axis adds; `None` if it adds nothing.
pub(super) fn limit(designed: &Designed) -> Option<Figure> {
    let axis = &designed.axis;
    let own = axis.ipc.is_active().then(|| axis.ipc.limit());
    let limit = if axis.control.master.is_some() { axis.control.master_limit } else { own };
    limit.map(|limit| figure(designed, limit))
}

fn figure(designed: &Designed, limit: f64) -> Figure {
    let doc = "the largest |v_add| [um/s or 0.001 deg/s]".to_owned();
    Figure { name: "LIMIT", doc, value: literal(limit, designed.axis.real) }
}

fn in_short(stage: &Stage) -> String {
    let damping = stage.mode.osc_damping().map_or_else(String::new, |damping| format!(", damping {damping}"));
    let filters: Vec<String> = stage.filter.iter().filter_map(filter::in_short).collect();
    format!("{}{damping}: {}, weight {}{}", stage.mode.text(), filters.join(", "), stage.weight(), stage.cap())
}

//! Warnings: a watch that reacts too late, and tuning that starts at 0.

use crate::axis::{Axis, Ipc};
use crate::config::values::key;
use crate::parameters::Name;
use crate::{codes, rules::effective::Effective};

pub(super) fn advise(axis: &Axis, e: &mut Effective<'_>) {
    let ipc = &axis.ipc;
    if ipc.watch {
        watch(axis, e);
    }
    let Some(tuning) = ipc.tuning().filter(|_| axis.stages_act()) else { return };
    let mut of_stages = ipc.stage.iter().zip(tuning.weight).filter(|(stage, _)| stage.is_some());
    let zero = match () {
        () if tuning.limit <= 0.0 => key(Name::TuningLimit),
        () if of_stages.all(|(_, weight)| weight <= 0.0) => {
            let first = ipc.stage.iter().position(Option::is_some).and_then(|i| u32::try_from(i).ok());
            (Name::TuningWeight, [first.unwrap_or(0), 0])
        }
        () => return,
    };
    let input = zero.0.parameter().short();
    let found = format!("{} is 0: the block adds nothing until its input {input} is written", e.title(zero));
    e.warn(codes::TUNED_TO_0, zero, found, format!("a part from 0 to 1, or a caller that writes {input}"));
}

/// Warns of oscillations that the watch cannot detect.
fn watch(axis: &Axis, e: &mut Effective<'_>) {
    let (ipc, at) = (&axis.ipc, key(Name::Watch));
    let (found, instead) = match () {
        () if axis.control.master.is_some() => {
            ("the axis is a gantry slave".to_owned(), "`watch` for the master, whose stages act")
        }
        () if !ipc.is_active() => ("no stage is active".to_owned(), "an active stage, or no `watch`"),
        () if ipc.v_add_max_fact == 0 => ("the limit (P-AXIS-00757) is 0".to_owned(), "a limit above 0, or no `watch`"),
        () if ipc.v_add_max_fact >= Ipc::WHOLE => (
            format!(
                "it waits for {} {}, {} % of vb_max (P-AXIS-00757), which the axis hardly reaches",
                ipc.limit(),
                axis.control.velocity_unit(),
                f64::from(ipc.v_add_max_fact) / 10.0
            ),
            "a v_add_max_fact that is a little more than what the vibration needs",
        ),
        () => return,
    };
    e.warn(codes::BLIND_WATCH, at, format!("the watch over the loop sees nothing: {found}"), instead.to_owned());
}

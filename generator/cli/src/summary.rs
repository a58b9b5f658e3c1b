//! What an axis's block does, in a few lines for the user.

use generator::axis::{Axis, DirectSource, Enable, Filter, Mode, Prototype, Stage};
use generator::design;
use portable::RealKind;
use std::fmt::Write;

/// The lines for an axis.
pub fn of(axis: &Axis) -> String {
    let real = match axis.real {
        RealKind::F64 => "f64",
        RealKind::F32 => "f32",
    };
    let unit = |velocity: f64| format!("{velocity}");
    let enable = match axis.ipc.enable {
        Enable::Off => "OFF",
        Enable::On => "ON",
        Enable::DryRun => "DRYRUN",
    };
    let mut text = format!(
        "axis {}: ipc, {real}, cycle {} us, starts {enable}, |v_add| <= {}, fades in {} cycles\n",
        axis.name,
        f64::from(axis.cycle_time_ns) / 1000.0,
        unit(design::ipc::limit(&axis.ipc)),
        design::ipc::fade_cycles(axis),
    );
    for (index, stage) in axis.ipc.stage.iter().enumerate() {
        let what = stage.as_ref().map_or_else(|| "NOT_ACTIVE".to_owned(), stage_line);
        writeln!(text, "  stage[{index}] {what}").expect("summary: a string takes all text");
    }
    text
}

fn stage_line(stage: &Stage) -> String {
    let source = match stage.mode {
        Mode::Direct { source: DirectSource::Motor } => "DIRECT from v_motor".to_owned(),
        Mode::Direct { source: DirectSource::Direct } => "DIRECT from v_direct".to_owned(),
        Mode::Indirect { osc_damping } => format!("INDIRECT from v_motor, damping {osc_damping}"),
        Mode::SetPoint { osc_damping } => format!("SET_POINT from v_command, damping {osc_damping}"),
    };
    let filters = stage.filter.iter().filter_map(filter_text);
    format!("{source}: {}, weight {}", filters.collect::<Vec<_>>().join(", "), stage.weight())
}

fn filter_text(filter: &Filter) -> Option<String> {
    match filter {
        Filter::NoFilter => None,
        Filter::Bandpass { prototype, order, f0, q_factor } => {
            let prototype = match prototype {
                Prototype::CritDamping => "CRIT_DAMPING",
                Prototype::Butterworth => "BUTTERWORTH",
                Prototype::Bessel => "BESSEL",
            };
            Some(format!("BANDPASS {prototype} order {order} at {f0} Hz, Q {q_factor}"))
        }
        Filter::Allpass { f0, q_factor } => Some(format!("ALLPASS at {f0} Hz, Q {q_factor}")),
    }
}

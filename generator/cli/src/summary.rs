//! What an axis's blocks do, in a few lines for the user.

use generator::axis::{Axis, DirectSource, Enable, Feedforward, Filter, Mode, Place, Prototype, Stage};
use generator::block;
use generator::design::{self, control_notes, digits};
use portable::RealKind;
use std::fmt::Write;

/// The lines for an axis.
pub fn of(axis: &Axis) -> String {
    let real = match axis.real {
        RealKind::F64 => "f64",
        RealKind::F32 => "f32",
    };
    let blocks = block::names(axis);
    let cycle = f64::from(axis.cycle_time_ns) / 1000.0;
    let mut text = format!("axis {}: {}, {real}, cycle {cycle} us", axis.name, blocks.join(", "));
    if blocks.contains(&"ipc") {
        text += &of_ipc(axis);
    }
    text.push('\n');
    for (index, stage) in axis.ipc.stage.iter().enumerate().filter(|_| blocks.contains(&"ipc")) {
        let what = stage.as_ref().map_or_else(|| "NOT_ACTIVE".to_owned(), stage_line);
        writeln!(text, "  stage[{index}] {what}").expect("summary: a string takes all text");
    }
    let of_control = [axis.control.feedforward.as_ref().map(feedforward), position_control(axis), gantry(axis)];
    for line in of_control.into_iter().flatten() {
        writeln!(text, "  {line}").expect("summary: a string takes all text");
    }
    text
}

fn of_ipc(axis: &Axis) -> String {
    let enable = match axis.ipc.enable {
        Enable::Off => "OFF",
        Enable::On => "ON",
        Enable::DryRun => "DRYRUN",
    };
    format!(
        ", starts {enable}, |v_add| <= {}, fades in {} cycles",
        design::ipc::limit(&axis.ipc),
        design::ipc::fade_cycles(axis)
    )
}

/// Which quantities go which way.
fn feedforward(of: &Feedforward) -> String {
    let ways = [
        (of.conventional, "to the position controller", String::new()),
        (of.additive, "as additive velocity", delayed(&[of.velocity_delay])),
        (of.torque, "as additive torque", delayed(&[of.acceleration_delay, of.jerk_delay])),
    ];
    let said = ways.into_iter().filter(|(quantities, ..)| quantities.any());
    let said: Vec<String> =
        said.map(|(what, way, delay)| format!("{} {way}{delay}", control_notes::quantities(what))).collect();
    let said = if said.is_empty() { "nothing goes out".to_owned() } else { said.join("; ") };
    format!("feedforward: {said}; weight {}", digits(of.weight.value()))
}

fn delayed(us: &[u32]) -> String {
    us.iter().filter(|us| **us > 0).map(|us| format!(", {us} us later")).collect()
}

fn position_control(axis: &Axis) -> Option<String> {
    let of = axis.control.position_control.as_ref()?;
    let place = match of.place {
        Place::Cnc => "in the CNC",
        Place::Drive => "in the drive",
        Place::Profidrive => "in the drive (PROFIdrive)",
    };
    let kv = if of.kv > 0 { format!(", Kv {}/s", digits(design::position_control::kv(of))) } else { String::new() };
    Some(format!("position control {place}{kv}"))
}

fn gantry(axis: &Axis) -> Option<String> {
    let master = axis.control.master?;
    Some(match axis.control.master_limit {
        Some(limit) => format!("gantry slave of axis {master}: puts out its v_add, |v_add| <= {}", digits(limit)),
        None => format!("gantry slave of axis {master}"),
    })
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

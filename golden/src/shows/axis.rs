//! The constructs of an axis, in words.

use generator::axis::{Axis, Enable, Filter, Mode, Stage};
use generator::parameters::words::{StageMode, Words};
use portable::RealKind;
use std::collections::BTreeSet;

/// The low f0 * Ts for cases in double precision: the signal-to-noise ratio there is still 98 dB.
const LOWEST_DOUBLE: f64 = 1e-6;
/// A low f0 * Ts in single precision: 1 Hz at 62.5 us.
const LOWEST_SINGLE: f64 = 6.25e-5;
/// The highest f0 * Ts that the check permits.
const HIGHEST: f64 = 0.45;

/// The constructs of an axis.
pub fn shown(axis: &Axis) -> BTreeSet<String> {
    let mut shown = BTreeSet::new();
    let real = match axis.real {
        RealKind::F64 => "double precision",
        RealKind::F32 => "single precision",
    };
    let enable = match axis.ipc.enable {
        Enable::Off => "start in OFF",
        Enable::On => "start in ON",
        Enable::DryRun => "start in DRYRUN",
    };
    shown.extend([
        real.to_owned(),
        enable.to_owned(),
        format!("cycle time {} us", f64::from(axis.cycle_time_ns) / 1e3),
    ]);
    if axis.ipc.v_add_max_fact == 0 {
        shown.insert("limit 0".to_owned());
    }
    let stages: Vec<&Stage> = axis.ipc.stage.iter().flatten().collect();
    let is_full = |stage: &&&Stage| stage.filter.iter().all(|filter| *filter != Filter::NoFilter);
    if stages.iter().filter(is_full).count() == axis.ipc.stage.len() {
        shown.insert("three full stages".to_owned());
    }
    for stage in stages {
        shown.insert(mode(stage.mode));
        shown.insert(stage.filter.map(|filter| filter.kind().name()).join(" + "));
        if f64::from(stage.weight_fact_num) > Stage::MAX_WEIGHT * f64::from(stage.weight_fact_denom) {
            shown.insert("weight above the cap".to_owned());
        }
        for filter in stage.filter {
            shown.extend(of_filter(&filter, axis));
        }
    }
    shown
}

fn of_filter(filter: &Filter, axis: &Axis) -> Vec<String> {
    let Some(f0) = filter.f0() else { return Vec::new() };
    let mut shown = Vec::new();
    if let Filter::Bandpass { prototype, order, .. } = filter {
        shown.push(format!("{} order {order}", prototype.name()));
    }
    let cycles = f0 * f64::from(axis.cycle_time_ns) / 1e9;
    let lowest = if axis.real == RealKind::F64 { LOWEST_DOUBLE } else { LOWEST_SINGLE };
    for (limit, end) in [(lowest, "lowest"), (HIGHEST, "highest")] {
        if (cycles - limit).abs() < 1e-9 * limit {
            shown.push(format!("{end} f0"));
        }
    }
    shown
}

fn mode(mode: Mode) -> String {
    match mode {
        Mode::Direct { .. } => mode.text(),
        Mode::Indirect { .. } => StageMode::Indirect.name().to_owned(),
        Mode::SetPoint { .. } => StageMode::SetPoint.name().to_owned(),
    }
}

//! The certificate of a block against brute force, closed forms and blocks that are made wrong. No golden files.

mod chain;
mod lines;
mod range;
mod response;

use crate::inside::sets::axis;
use generator::axis::{Axis, DirectSource, Filter, Mode, Prototype, Stage};
use generator::blocks::ipc::certificate::{Certificate, certify};
use generator::blocks::{Block, Designed, blocks};
use portable::RealKind;

fn block(axis: &Axis) -> Block {
    blocks(&Designed::from(axis.clone())).expect("no defect").remove(0)
}

/// What is certain of it.
fn certified(axis: &Axis) -> Certificate {
    certify(&Designed::from(axis.clone()), &block(axis).program)
}

/// The rack-and-pinion example: 53 Hz DIRECT with weight 3, 11 Hz INDIRECT with weight 1.9, cycle 1 ms.
pub fn rack_and_pinion(real: RealKind) -> Axis {
    let filter = |f0, q_factor| {
        [Filter::Bandpass { prototype: Prototype::CritDamping, order: 1, f0, q_factor }, Filter::NoFilter]
    };
    let direct = Mode::Direct { source: DirectSource::Motor };
    let indirect = Mode::Indirect { osc_damping: 0.8 };
    let stage = [
        Some(Stage { mode: direct, weight_fact_num: 300, weight_fact_denom: 100, filter: filter(53.0, 10.0) }),
        Some(Stage { mode: indirect, weight_fact_num: 190, weight_fact_denom: 100, filter: filter(11.0, 2.0) }),
        None,
    ];
    axis(real, 1_000_000, stage)
}

/// A DIRECT stage of weight 1 with one band-pass.
fn one_band_pass(
    real: RealKind,
    cycle_time_ns: u32,
    prototype: Prototype,
    order: usize,
    f0: f64,
    q_factor: f64,
) -> Axis {
    let filter = [Filter::Bandpass { prototype, order, f0, q_factor }, Filter::NoFilter];
    let mode = Mode::Direct { source: DirectSource::Motor };
    let stage = Some(Stage { mode, weight_fact_num: 1, weight_fact_denom: 1, filter });
    axis(real, cycle_time_ns, [stage, None, None])
}

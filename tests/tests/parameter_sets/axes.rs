//! Axes of one structure with other numbers, and their parameter sets as inputs of a block.

use axgen_tests::model::subject;
use axgen_tests::random::rng::Rng;
use generator::blocks::{Block, Designed};
use golden::case::named_block;
use portable::{Literal, RealKind};

/// Everything that the stages of an axis may have, by the kind of structure.
pub const STRUCTURES: usize = 3;

/// An axis of a structure; `rng` chooses its numbers. The limit is at most that of [`designed`].
pub fn other(structure: usize, real: RealKind, rng: &mut Rng, fact: u32) -> Designed {
    let mut number = |from: f64, to: f64| from + (to - from) * (rng.below(1001) as f64 / 1000.0);
    let real = if real == RealKind::F64 { "f64" } else { "f32" };
    let (more, stages) = match structure {
        0 => (
            "",
            format!(
                "{{ mode = 'DIRECT', weight_fact_num = {}, weight_fact_denom = 1000, filter = [{{ order = 1, fg_f0 = {}, q_factor = {} }}] }}",
                number(1.0, 7000.0).round(),
                number(36.0, 90.0),
                number(1.0, 10.0)
            ),
        ),
        1 => (
            "ride_through = 2\nwatch = true",
            [("DIRECT", ""), ("INDIRECT", "osc_damping = 0.8,"), ("SET_POINT", "osc_damping = 0.4,")]
                .map(|(mode, damping)| {
                    format!(
                        "{{ mode = '{mode}', {damping} weight_fact_num = {}, weight_fact_denom = 1000, filter = [{{ order = 2, fg_f0 = {}, q_factor = {} }}] }}",
                        number(1.0, 7000.0).round(),
                        number(36.0, 90.0),
                        number(1.0, 10.0)
                    )
                })
                .join(", "),
        ),
        _ => (
            "",
            format!(
                "{{ mode = 'INDIRECT', osc_damping = {}, weight_fact_num = {}, weight_fact_denom = 1000, filter = [{{ order = 3, prototype = 'BESSEL', fg_f0 = {}, q_factor = {} }}, {{ type = 'ALLPASS', fg_f0 = {}, q_factor = 2.0 }}] }}",
                number(0.1, 0.9),
                number(1.0, 7000.0).round(),
                number(36.0, 90.0),
                number(1.0, 10.0),
                number(40.0, 200.0)
            ),
        ),
    };
    subject::read(&format!(
        "cycle_time = '1ms'
[axis.X]
real = '{real}'
fade = '30ms'
tunable = 'all'
getriebe = [{{ kv = 2000, dynamik.vb_max = 500000 }}]
{more}
[axis.X.lr_param.improved_position_control]
enable = 'ON'
v_add_max_fact = {fact}
stage = [{stages}]
"
    ))
}

/// The limit that the block is generated with [0.1 %].
pub const FACT: u32 = 20;

/// The block of an axis that is tested with a structure.
pub fn block(structure: usize, designed: &Designed) -> Block {
    named_block(designed, ["ipc", "ipc", "axis"][structure]).unwrap()
}

/// The parts of the set that the parameters of an axis make: their position among all inputs, and their values.
pub fn set(block: &Block) -> Vec<(usize, Literal)> {
    let own = &block.for_axis;
    let parts = own.program.inputs.iter().zip(&own.inputs).filter(|(input, _)| own.program.in_set(input).is_some());
    parts.map(|(input, position)| (*position, input.start)).collect()
}

/// Sets of one structure, each with other numbers; the limit is lower in some.
pub fn sets(structure: usize, real: RealKind, rng: &mut Rng, count: usize) -> Vec<Vec<(usize, Literal)>> {
    (0..count)
        .map(|_| {
            let fact = 1 + rng.below(FACT as usize) as u32;
            set(&block(structure, &other(structure, real, rng, fact)))
        })
        .collect()
}

//! Stages as an axis has them: proposed ones with few digits, weights rounded down; their responses are those of the block.

use generator::analysis;
use generator::axis::{Filter, Mode, Stage};
use generator::parameters::words::{DirectSource, Prototype};
use identification::Complex64;
use identification::shape::{self, Allpass, Shape, Stages};
use stability::{Band, Controller, STAGES};

/// Resolution of frequencies, quality factors and dampings in parts of 1, and the denominator of weights (P-AXIS-00755).
const DIGITS: f64 = 1e4;
const DENOMINATOR: u32 = 1000;
/// The prototype that is stated: of order 1 all of them are equal.
const PROTOTYPE: Prototype = Prototype::CritDamping;

/// A shape with a weight as the parameters of a set: one band-pass of order 1, and an all-pass where there is one.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a weight is from 0 to 7")]
pub(super) fn rounded(shape: &Shape, weight: f64) -> Stage {
    let round = |value: f64| libm::round(value * DIGITS) / DIGITS;
    let Shape { mode, f0, q, damping, allpass } = *shape;
    let allpass = allpass.map(|Allpass { f0, q }| Allpass { f0: round(f0), q: round(q) });
    let shape = Shape { mode, f0: round(f0), q: round(q), damping: round(damping), allpass };
    let weight_fact_num = libm::floor(weight * f64::from(DENOMINATOR)) as u32;
    Stage { weight_fact_num, weight_fact_denom: DENOMINATOR, ..with_weight_1(&shape) }
}

/// The response of a shape with weight 1 as a block has it.
pub(super) fn responses(cycle_time: f64) -> Box<Stages<'static>> {
    Box::new(move |shape| Box::new(analysis::of_stage(&with_weight_1(shape), cycle_time)))
}

fn with_weight_1(shape: &Shape) -> Stage {
    let mode = match shape.mode {
        shape::Mode::Direct => Mode::Direct { source: DirectSource::Motor },
        shape::Mode::Indirect => Mode::Indirect { osc_damping: shape.damping },
    };
    let bandpass = Filter::Bandpass { prototype: PROTOTYPE, order: 1, f0: shape.f0, q_factor: shape.q };
    let allpass = shape.allpass.map(|Allpass { f0, q }| Filter::Allpass { f0, q_factor: q });
    Stage { mode, weight_fact_num: 1, weight_fact_denom: 1, filter: [bandpass, allpass.unwrap_or(Filter::NoFilter)] }
}

/// The controller of stages, as blocks have it.
pub(super) fn controller(stages: &[Stage], cycle_time: f64, position_gain: Option<f64>) -> Controller<'static> {
    let responses: Vec<_> = stages.iter().map(|stage| analysis::of_stage(stage, cycle_time)).collect();
    let band = |filter: &Filter| match *filter {
        Filter::Bandpass { f0, q_factor, .. } | Filter::Allpass { f0, q_factor } => {
            Some(Band { centre: f0, width: f0 / q_factor })
        }
        Filter::NoFilter => None,
    };
    Controller {
        cycle_time,
        // The responses have their weights.
        weight: [1.0; STAGES],
        stage: Box::new(move |t| {
            std::array::from_fn(|i| responses.get(i).map_or(Complex64::new(0.0, 0.0), |response| response(t)))
        }),
        bands: stages.iter().flat_map(|stage| &stage.filter).filter_map(band).collect(),
        position_gain,
        gain_in_drive: None,
    }
}

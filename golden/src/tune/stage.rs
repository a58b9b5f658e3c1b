//! A proposed stage as the parameters of a set: numbers with few digits, weights rounded down. Its response is that of the
//! block.

use generator::analysis;
use generator::axis::{self, Filter};
use generator::parameters::words::{DirectSource, Prototype, StageMode, Words};
use identification::shape::{Allpass, Mode, Shape, Stages};

/// Resolution of frequencies, quality factors and dampings in parts of 1, and the denominator of weights (P-AXIS-00755).
const DIGITS: f64 = 1e4;
pub(super) const DENOMINATOR: u32 = 1000;

/// A stage with one band-pass of order 1, for which all prototypes are equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    pub shape: Shape,
    /// numerator of its weight over 1000 (P-AXIS-00754)
    pub weight_fact_num: u32,
}

impl Stage {
    /// A stage from a shape and a weight.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a weight is from 0 to 7")]
    pub(super) fn rounded(shape: &Shape, weight: f64) -> Self {
        let round = |value: f64| libm::round(value * DIGITS) / DIGITS;
        let Shape { mode, f0, q, damping, allpass } = *shape;
        let allpass = allpass.map(|Allpass { f0, q }| Allpass { f0: round(f0), q: round(q) });
        let shape = Shape { mode, f0: round(f0), q: round(q), damping: round(damping), allpass };
        Self { shape, weight_fact_num: libm::floor(weight * f64::from(DENOMINATOR)) as u32 }
    }

    #[must_use]
    pub fn weight(&self) -> f64 {
        f64::from(self.weight_fact_num) / f64::from(DENOMINATOR)
    }

    #[must_use]
    pub fn parameters(&self) -> Parameters {
        let (mode, direct_source, damping) = match self.shape.mode {
            Mode::Direct => (StageMode::Direct, Some(DirectSource::Motor.name()), None),
            Mode::Indirect => (StageMode::Indirect, None, Some(self.shape.damping)),
        };
        Parameters { mode: mode.name(), direct_source, damping, prototype: PROTOTYPE.name(), order: 1 }
    }
}

/// The parameters of a stage that are words, or depend on its mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// P-AXIS-00753
    pub mode: &'static str,
    /// `None` if it has no effect in the mode
    pub direct_source: Option<&'static str>,
    /// P-AXIS-00850; `None` if it has no effect in the mode
    pub damping: Option<f64>,
    /// P-AXIS-00848
    pub prototype: &'static str,
    /// P-AXIS-00750
    pub order: u32,
}

/// The stated prototype: for order 1 all of them are equal.
const PROTOTYPE: Prototype = Prototype::CritDamping;

/// The response of a shape with weight 1, as in a block.
pub(super) fn responses(cycle_time: f64) -> Box<Stages<'static>> {
    Box::new(move |shape| Box::new(analysis::of_stage(&with_weight_1(shape), cycle_time)))
}

fn with_weight_1(shape: &Shape) -> axis::Stage {
    let mode = match shape.mode {
        Mode::Direct => axis::Mode::Direct { source: DirectSource::Motor },
        Mode::Indirect => axis::Mode::Indirect { osc_damping: shape.damping },
    };
    let bandpass = Filter::Bandpass { prototype: PROTOTYPE, order: 1, f0: shape.f0, q_factor: shape.q };
    let allpass = shape.allpass.map(|Allpass { f0, q }| Filter::Allpass { f0, q_factor: q });
    axis::Stage {
        mode,
        weight_fact_num: 1,
        weight_fact_denom: 1,
        filter: [bandpass, allpass.unwrap_or(Filter::NoFilter)],
    }
}

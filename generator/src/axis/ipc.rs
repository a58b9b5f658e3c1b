//! Improved position control of one axis after the check: plain data. No spans, no coefficients.

use crate::number::digits;
use crate::parameters::words::{DirectSource, Enable, FilterType, Prototype, StageMode, Words};
use portable::Extreme;
use reference::design::limit;

/// Improved position control (`lr_param.improved_position_control`).
#[derive(Clone, Debug, PartialEq)]
pub struct Ipc {
    /// mode at start (P-AXIS-00758)
    pub enable: Enable,
    /// largest |v_add| as a fraction of `v_max` [0.1 %] (P-AXIS-00757)
    pub v_add_max_fact: u32,
    /// largest velocity of the axis [um/s or 0.001 deg/s] (P-AXIS-00212)
    pub v_max: f64,
    /// time of the fade [s], before it is raised to one period of the lowest f0
    pub fade: f64,
    /// number of consecutive bad samples that the last good one replaces
    pub ride_through: u32,
    /// source of its numbers
    pub numbers: Numbers,
    /// whether the loop is watched
    pub watch: bool,
    /// cycles between a command and the actual value that it caused (P-AXIS-00191), if given; no block depends on them
    pub delay_cycles: Option<u32>,
    /// the stages; an inactive one is `None`
    pub stage: [Option<Stage>; 3],
}

impl Ipc {
    /// A limit of the whole of vb_max [0.1 %].
    pub(crate) const WHOLE: u32 = 1000;

    /// The longest fade in cycles: all whole numbers up to 2^24 are exact in f32.
    pub(crate) const MAX_FADE_CYCLES: f64 = 16_777_216.0;

    /// The values that the caller may tune; `None` if there are none.
    pub fn tuning(&self) -> Option<Tuning> {
        if let Numbers::Weights(tuning) = self.numbers { Some(tuning) } else { None }
    }

    /// Whether all numbers come from parameter sets.
    pub fn takes_sets(&self) -> bool {
        matches!(self.numbers, Numbers::Sets { .. })
    }

    /// The lowest centre frequency of the sets that the controller designs [Hz]; `None` if it designs none.
    pub fn lowest_f0(&self) -> Option<f64> {
        if let Numbers::Sets { lowest_f0 } = self.numbers { lowest_f0 } else { None }
    }

    /// The centre frequencies of all active filters [Hz].
    pub fn filter_f0s(&self) -> impl Iterator<Item = f64> {
        self.stage.iter().flatten().flat_map(|stage| &stage.filter).filter_map(Filter::f0)
    }

    /// Whether a stage acts.
    pub fn is_active(&self) -> bool {
        self.stage.iter().any(Option::is_some)
    }

    /// Largest |v_add|, in the unit of v_max (P-AXIS-00757, P-AXIS-00212).
    pub fn limit(&self) -> f64 {
        self.limit_with(self.v_add_max_fact)
    }

    /// The same with another part of v_max [0.1 %].
    pub(crate) fn limit_with(&self, v_add_max_fact: u32) -> f64 {
        limit::limit(v_add_max_fact, self.v_max)
    }

    /// Time of the whole fade [s]: the key `fade`, at least one period of the key `lowest_f0`, or else of the lowest f0 of all
    /// active filters. It is not rounded up to whole cycles.
    pub fn fade_time(&self) -> f64 {
        let lowest = self.lowest_f0().or_else(|| self.filter_f0s().min_by(f64::total_cmp));
        lowest.map_or(self.fade, |f0| self.fade.larger(1.0 / f0))
    }
}

/// Where the numbers of the block come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Numbers {
    /// from the parameters
    Fixed,
    /// from the parameters; the caller tunes which part of the weights and of the limit acts
    Weights(Tuning),
    /// from parameter sets
    Sets {
        /// lowest centre frequency of the sets that the controller designs [Hz]; `None` if it designs none
        lowest_f0: Option<f64>,
    },
}

/// Inputs for tuning, each a fraction from 0 to 1 of the parameter: their start values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tuning {
    /// `tuning_limit`
    pub limit: f64,
    /// `tuning_weight` of each stage
    pub weight: [f64; 3],
}

/// An active stage.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// where its vibration comes from (P-AXIS-00753)
    pub mode: Mode,
    /// weight, as written: numerator (P-AXIS-00754)
    pub weight_fact_num: u32,
    /// weight, as written: denominator (P-AXIS-00755)
    pub weight_fact_denom: u32,
    /// the filters in the order of their execution; at least one is a band-pass
    pub filter: [Filter; 2],
}

impl Stage {
    /// The largest weight; a larger one is capped (P-AXIS-00754).
    pub const MAX_WEIGHT: f64 = 7.0;

    /// num / denom, the weight in the parameters.
    pub(crate) fn asked_weight(&self) -> f64 {
        f64::from(self.weight_fact_num) / f64::from(self.weight_fact_denom)
    }

    /// weight = min(num / denom, 7).
    pub fn weight(&self) -> f64 {
        self.asked_weight().smaller(Self::MAX_WEIGHT)
    }

    /// The text after its weight if that is capped: ` (700 capped)`.
    pub(crate) fn cap(&self) -> String {
        Self::cap_of(self.asked_weight())
    }

    /// The same of a weight in the parameters.
    pub(crate) fn cap_of(asked: f64) -> String {
        if asked > Self::MAX_WEIGHT { format!(" ({} capped)", digits(asked)) } else { String::new() }
    }

    /// Index of its first band-pass; 0 if there is none.
    pub fn first_bandpass(&self) -> u32 {
        let mut filters = (0..).zip(&self.filter);
        filters.find(|(_, filter)| filter.kind() == FilterType::Bandpass).map_or(0, |(k, _)| k)
    }

    /// Centre frequency of the stage's first band-pass [Hz], which is also that of the simulated oscillation.
    ///
    /// # Panics
    /// If there is no band-pass, which the check excludes.
    pub fn f0(&self) -> f64 {
        let bandpass = self.filter.iter().find(|filter| filter.kind() == FilterType::Bandpass);
        bandpass.and_then(Filter::f0).expect("check: an active stage has a band-pass")
    }
}

/// Mode of an active stage (P-AXIS-00753).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// a measured velocity
    Direct { source: DirectSource },
    /// the oscillation simulated from the motor's velocity, with the damping ratio D (P-AXIS-00850, formerly P-AXIS-00756)
    Indirect { osc_damping: f64 },
    /// the oscillation simulated from the command velocity, with the damping ratio D
    SetPoint { osc_damping: f64 },
}

impl Mode {
    /// Damping ratio of the simulated oscillation (P-AXIS-00850), if the mode has one.
    pub(crate) fn osc_damping(self) -> Option<f64> {
        match self {
            Self::Direct { .. } => None,
            Self::Indirect { osc_damping } | Self::SetPoint { osc_damping } => Some(osc_damping),
        }
    }

    /// Its word (P-AXIS-00753).
    pub fn word(self) -> &'static str {
        let word = match self {
            Self::Direct { .. } => StageMode::Direct,
            Self::Indirect { .. } => StageMode::Indirect,
            Self::SetPoint { .. } => StageMode::SetPoint,
        };
        word.name()
    }

    /// The input velocity of the mode.
    pub(crate) fn source(self) -> &'static str {
        match self {
            Self::Direct { source } => source.name(),
            Self::Indirect { .. } => DirectSource::Motor.name(),
            Self::SetPoint { .. } => "v_command",
        }
    }

    /// Mode and source: `DIRECT from v_motor`.
    pub fn text(self) -> String {
        format!("{} from {}", self.word(), self.source())
    }
}

/// A filter of a stage (P-AXIS-00849).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Filter {
    /// the input passes unchanged
    NoFilter,
    Bandpass {
        /// P-AXIS-00848
        prototype: Prototype,
        /// number of sections, 1 to 3 (P-AXIS-00750)
        order: usize,
        /// centre frequency [Hz] (P-AXIS-00751)
        f0: f64,
        /// quality factor: centre frequency / bandwidth (P-AXIS-00752)
        q_factor: f64,
    },
    Allpass {
        /// frequency of -180 degrees [Hz] (P-AXIS-00751)
        f0: f64,
        /// quality factor (P-AXIS-00752)
        q_factor: f64,
    },
}

impl Filter {
    /// Centre frequency [Hz] (P-AXIS-00751).
    pub fn f0(&self) -> Option<f64> {
        Some(self.f0_and_q()?[0])
    }

    /// Centre frequency [Hz] and quality factor (P-AXIS-00751, P-AXIS-00752).
    pub(crate) fn f0_and_q(&self) -> Option<[f64; 2]> {
        match *self {
            Self::NoFilter => None,
            Self::Bandpass { f0, q_factor, .. } | Self::Allpass { f0, q_factor } => Some([f0, q_factor]),
        }
    }

    /// Its type (P-AXIS-00849).
    pub fn kind(&self) -> FilterType {
        match self {
            Self::NoFilter => FilterType::NoFilter,
            Self::Bandpass { .. } => FilterType::Bandpass,
            Self::Allpass { .. } => FilterType::Allpass,
        }
    }
}

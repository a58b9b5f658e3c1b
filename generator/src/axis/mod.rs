//! One axis after reading and checking: physical, valid parameters. Plain data; no spans, no coefficients.

mod control;

pub use control::{
    Control, Feedforward, Motor, Place, PositionControl, Quantities, Ratio, Resolution, TimeBase, Torque, Velocity,
    Width,
};

use portable::RealKind;

/// An axis, ready to be designed.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// as the set names it
    pub name: String,
    /// the real type of its blocks
    pub real: RealKind,
    /// position-controller cycle [ns]
    pub cycle_time_ns: u32,
    /// improved position control
    pub ipc: Ipc,
    /// feedforward, position control, gantry
    pub control: Control,
    /// every effective parameter, one `path value` a line, in the order of the parameter table: what the digest covers
    pub canonical: String,
}

impl Axis {
    /// Position-controller cycle Ts [s].
    #[must_use]
    pub fn cycle_time(&self) -> f64 {
        f64::from(self.cycle_time_ns) * 1e-9
    }
}

/// Improved position control (`lr_param.improved_position_control`).
#[derive(Clone, Debug, PartialEq)]
pub struct Ipc {
    /// mode at start (P-AXIS-00758)
    pub enable: Enable,
    /// largest |v_add| as a fraction of `v_max` [0.1 %] (P-AXIS-00757)
    pub v_add_max_fact: u32,
    /// largest velocity of the axis [um/s or 0.001 deg/s] (P-AXIS-00212)
    pub v_max: f64,
    /// time that the gate takes from 0 to 1 [s], before it is raised to one period of the lowest f0
    pub fade: f64,
    /// the stages; an inactive one is `None`
    pub stage: [Option<Stage>; 3],
}

/// Mode at start (P-AXIS-00758). The numbers are those of the input `mode`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enable {
    /// the block is off
    Off = 0,
    /// the block acts
    On = 1,
    /// the block calculates and does not act
    DryRun = 2,
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
    /// The largest weight; a larger one is capped without a message (P-AXIS-00754).
    pub const MAX_WEIGHT: f64 = 7.0;

    /// weight = min(num / denom, 7).
    #[must_use]
    pub fn weight(&self) -> f64 {
        (f64::from(self.weight_fact_num) / f64::from(self.weight_fact_denom)).min(Self::MAX_WEIGHT)
    }

    /// Centre frequency of the stage's first band-pass [Hz]; the simulated oscillation has it too.
    ///
    /// # Panics
    /// If there is no band-pass, which the check excludes.
    #[must_use]
    pub fn f0(&self) -> f64 {
        self.filter
            .iter()
            .find_map(|filter| match filter {
                Filter::Bandpass { f0, .. } => Some(*f0),
                _ => None,
            })
            .expect("check: an active stage has a band-pass")
    }
}

/// Mode of an active stage (P-AXIS-00753).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// a measured velocity
    Direct {
        /// which one
        source: DirectSource,
    },
    /// the oscillation simulated from the motor's velocity
    Indirect {
        /// damping ratio D of the simulated oscillation (P-AXIS-00850, formerly P-AXIS-00756)
        osc_damping: f64,
    },
    /// the oscillation simulated from the command velocity
    SetPoint {
        /// damping ratio D of the simulated oscillation (P-AXIS-00850, formerly P-AXIS-00756)
        osc_damping: f64,
    },
}

/// Which measured velocity a DIRECT stage takes (key `direct_source`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DirectSource {
    /// the motor encoder (v_ist1)
    Motor,
    /// the direct measuring system (v_ist2)
    Direct,
}

/// A filter of a stage (P-AXIS-00849).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Filter {
    /// the input passes unchanged
    NoFilter,
    /// band-pass
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
    /// all-pass
    Allpass {
        /// frequency of -180 degrees [Hz] (P-AXIS-00751)
        f0: f64,
        /// quality factor (P-AXIS-00752)
        q_factor: f64,
    },
}

/// Low-pass prototype of a band-pass (P-AXIS-00848).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Prototype {
    /// all poles in one place
    CritDamping,
    /// flattest amplitude
    Butterworth,
    /// flattest delay
    Bessel,
}

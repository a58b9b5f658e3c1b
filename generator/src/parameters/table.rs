//! The table: one declaration per parameter, in the order in which every output lists them; no rule and no reading.
//!
//! The comment above a declaration is the parameter's meaning. Sources: ISG FCT-A12 and the ISG axis parameter list,
//! Beckhoff TF5200. Parameters without an id are keys of our own, for what no axis list holds.

use super::{Bound, Kind, Parameter, Scope, Word};

/// Stages of improved position control.
pub const STAGES: u32 = 3;
/// Filters of a stage.
pub const FILTERS: u32 = 2;
/// Gear steps of an axis.
const GEARS: u32 = 16;

/// Weights are unsigned numbers of 32 bits without 0 and the largest.
const WEIGHT: Kind = Kind::Integer { from: 1, to: u32::MAX - 1 };
/// Damping ratio of a vibration.
const DAMPING: Kind = Kind::Real { from: Bound::Open(0.0), to: Bound::Open(1.0) };
/// The first build with improved position control.
const IPC: &str = "V3.1.3077.08";
/// The first build with filter[k].
const IPC_FILTERS: &str = "V3.1.3132.0";

/// A parameter of the vendor.
const VENDOR: Parameter = Parameter {
    id: None,
    path: "",
    aliases: &[],
    misprints: &[],
    indices: &[],
    scope: Scope::List,
    kind: Kind::Text,
    unit: "",
    default: &[],
    since: "",
    meaning: "",
};
/// A key of our own below an axis.
const AXIS_KEY: Parameter = Parameter { scope: Scope::Axis, ..VENDOR };
/// A key of our own at the top of a set.
const SET_KEY: Parameter = Parameter { scope: Scope::Set, ..VENDOR };

/// A path within the structure of improved position control.
macro_rules! ipc {
    ($path:literal) => {
        concat!("lr_param.improved_position_control.", $path)
    };
}

/// A word without a number or another spelling.
const fn word(name: &'static str) -> Word {
    Word { name, number: None, also: &[] }
}

/// A word with its number.
const fn numbered(name: &'static str, number: u32) -> Word {
    Word { name, number: Some(number), also: &[] }
}

macro_rules! table {
    ($($(#[doc = $meaning:literal])+ $name:ident: $base:ident { $($field:ident: $value:expr),+ $(,)? })+) => {
        /// A parameter, by name; the order is the table's.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Name { $($(#[doc = $meaning])+ $name),+ }

        /// All parameters.
        pub static TABLE: [Parameter; [$(Name::$name),+].len()] = [$(
            Parameter { meaning: concat!($($meaning),+).trim_ascii(), $($field: $value,)+ ..$base }
        ),+];

        impl Name {
            /// All names, in the order of the table.
            pub const ALL: [Name; [$(Name::$name),+].len()] = [$(Name::$name),+];
        }
    };
}

table! {
    /// cycle time of the position controller: one call of the block
    CycleTime: SET_KEY {
        path: "cycle_time",
        kind: Kind::Duration { from: 1, to: u32::MAX as u64 },
        unit: "ns",
    }
    /// what `generate` writes when the command line names no target
    Targets: SET_KEY {
        path: "targets",
        kind: Kind::Words(&[word("c"), word("st"), word("twincat"), word("codesys"), word("scl")]),
    }
    /// file of the axis list, relative to the set; keys beside it override the list
    List: AXIS_KEY { path: "list" }
    /// axis list that the axis was imported from, line by line, for `axgen export`; `=` stands where the axis has the value
    ImportedLines: AXIS_KEY { path: "imported_list.lines" }
    /// what a character of these lines stands for: its bytes in UTF-8, or the one byte of its number
    ImportedEncoding: AXIS_KEY {
        path: "imported_list.encoding",
        kind: Kind::Word(&[word("utf-8"), word("latin-1")]),
        default: &["utf-8"],
    }
    /// how every one of these lines ends
    ImportedLineEnd: AXIS_KEY {
        path: "imported_list.line_end",
        kind: Kind::Word(&[word("LF"), word("CRLF")]),
        default: &["LF"],
    }
    /// real type of the generated blocks: double or single precision
    RealType: AXIS_KEY {
        path: "real",
        kind: Kind::Word(&[
            Word { name: "f64", number: None, also: &["LREAL"] },
            Word { name: "f32", number: None, also: &["REAL"] },
        ]),
        default: &["f64"],
    }
    /// gear step whose parameters (`getriebe[i]`) are used
    Gear: AXIS_KEY { path: "gear", kind: Kind::Integer { from: 0, to: GEARS - 1 }, default: &["0"] }
    /// time in which the additive velocity is faded in and out, at least one period of the lowest f0
    Fade: AXIS_KEY { path: "fade", kind: Kind::Duration { from: 0, to: 1_000_000_000_000 }, unit: "ns", default: &["0.1s"] }
    /// logical axis number
    AxisNumber: VENDOR {
        id: Some("P-AXIS-00016"),
        path: "kopf.achs_nr",
        kind: Kind::Integer { from: 0, to: 65_535 },
        default: &["0"],
    }
    /// axis type: translatory axis, rotary axis or spindle
    AxisType: VENDOR {
        id: Some("P-AXIS-00018"),
        path: "kenngr.achs_typ",
        kind: Kind::Word(&[
            numbered("ACHSTYP_TRANSLATOR", 1),
            numbered("ACHSTYP_ROTATOR", 2),
            numbered("ACHSTYP_SPINDEL", 4),
        ]),
        default: &["ACHSTYP_TRANSLATOR"],
    }
    /// on a gantry slave: logical axis number of its master
    GantryMaster: VENDOR {
        id: Some("P-AXIS-00070"),
        path: "kenngr.gantry_ax_nr",
        kind: Kind::Integer { from: 0, to: 65_535 },
        default: &["0"],
    }
    /// largest velocity of the axis
    VbMax: VENDOR {
        id: Some("P-AXIS-00212"),
        path: "getriebe[i].dynamik.vb_max",
        indices: &[GEARS],
        kind: Kind::Integer { from: 1, to: 2_000_000_000 },
        unit: "um/s or 0.001 deg/s",
        default: &["200000"],
    }
    /// mode of improved position control at start; DRYRUN calculates and puts out nothing
    Enable: VENDOR {
        id: Some("P-AXIS-00758"),
        path: ipc!("enable"),
        kind: Kind::Word(&[
            Word { name: "OFF", number: Some(0), also: &["FALSE"] },
            Word { name: "ON", number: Some(1), also: &["TRUE"] },
            word("DRYRUN"),
        ]),
        default: &["OFF"],
        since: IPC,
    }
    /// largest additive velocity as a part of the largest velocity of the axis (P-AXIS-00212)
    VAddMaxFact: VENDOR {
        id: Some("P-AXIS-00757"),
        path: ipc!("v_add_max_fact"),
        kind: Kind::Integer { from: 0, to: 2000 },
        unit: "0.1 %",
        default: &["0"],
        since: IPC,
    }
    /// where the stage takes the vibration from: a measured velocity, the motor's velocity behind a simulated
    /// oscillation, or the command velocity behind a simulated oscillation
    Mode: VENDOR {
        id: Some("P-AXIS-00753"),
        path: ipc!("stage[i].mode"),
        indices: &[STAGES],
        kind: Kind::Word(&[
            numbered("NOT_ACTIVE", 0),
            numbered("DIRECT", 1),
            numbered("INDIRECT", 2),
            numbered("SET_POINT", 3),
        ]),
        default: &["NOT_ACTIVE"],
        since: IPC,
    }
    /// measured velocity that a DIRECT stage takes: motor encoder or direct measuring system
    DirectSource: AXIS_KEY {
        path: ipc!("stage[i].direct_source"),
        indices: &[STAGES],
        kind: Kind::Word(&[word("v_motor"), word("v_direct")]),
        default: &["v_motor"],
    }
    /// weight of the stage: numerator; a weight above 7 is capped
    WeightFactNum: VENDOR {
        id: Some("P-AXIS-00754"),
        path: ipc!("stage[i].weight_fact_num"),
        indices: &[STAGES],
        kind: WEIGHT,
        default: &["1"],
        since: IPC,
    }
    /// weight of the stage: denominator
    WeightFactDenom: VENDOR {
        id: Some("P-AXIS-00755"),
        path: ipc!("stage[i].weight_fact_denom"),
        indices: &[STAGES],
        kind: WEIGHT,
        default: &["1"],
        since: IPC,
    }
    /// damping ratio of the simulated oscillation (INDIRECT, SET_POINT); the lower, the larger the additive velocity
    OscDamping: VENDOR {
        id: Some("P-AXIS-00850"),
        path: ipc!("stage[i].osc_damping"),
        misprints: &[ipc!("stage[i]osc_damping")],
        indices: &[STAGES],
        kind: DAMPING,
        default: &["-1"],
        since: IPC_FILTERS,
    }
    /// predecessor of P-AXIS-00850
    FilterDamping: VENDOR {
        id: Some("P-AXIS-00756"),
        path: ipc!("stage[i].filter.damping"),
        aliases: &[ipc!("stage[i].filter[k].damping")],
        indices: &[STAGES, 1],
        kind: DAMPING,
        default: &["-1"],
        since: IPC,
    }
    /// type of the filter; every active stage needs a band-pass
    FilterType: VENDOR {
        id: Some("P-AXIS-00849"),
        path: ipc!("stage[i].filter[k].type"),
        aliases: &[ipc!("stage[i].filter.type")],
        indices: &[STAGES, FILTERS],
        kind: Kind::Word(&[word("NO_FILTER"), word("BANDPASS"), word("ALLPASS")]),
        default: &["BANDPASS", "NO_FILTER"],
        since: IPC_FILTERS,
    }
    /// low-pass prototype of a band-pass; the second filter needs it in writing
    FilterPrototype: VENDOR {
        id: Some("P-AXIS-00848"),
        path: ipc!("stage[i].filter[k].prototype"),
        aliases: &[ipc!("stage[i].filter.prototype")],
        indices: &[STAGES, FILTERS],
        kind: Kind::Word(&[word("CRIT_DAMPING"), word("BUTTERWORTH"), word("BESSEL")]),
        default: &["CRIT_DAMPING"],
        since: IPC_FILTERS,
    }
    /// order of a band-pass: its sections of second order, 20 dB/decade each
    FilterOrder: VENDOR {
        id: Some("P-AXIS-00750"),
        path: ipc!("stage[i].filter[k].order"),
        aliases: &[ipc!("stage[i].filter.order")],
        indices: &[STAGES, FILTERS],
        kind: Kind::Integer { from: 1, to: 3 },
        default: &["0"],
        since: IPC,
    }
    /// centre frequency of a band-pass and of the simulated oscillation; frequency of -180 degrees of an all-pass
    FilterF0: VENDOR {
        id: Some("P-AXIS-00751"),
        path: ipc!("stage[i].filter[k].fg_f0"),
        aliases: &[ipc!("stage[i].filter.fg_f0")],
        indices: &[STAGES, FILTERS],
        kind: Kind::Real { from: Bound::Open(0.0), to: Bound::Closed(500.0) },
        unit: "Hz",
        default: &["-1"],
        since: IPC,
    }
    /// quality factor: centre frequency / bandwidth at -3 dB
    FilterQ: VENDOR {
        id: Some("P-AXIS-00752"),
        path: ipc!("stage[i].filter[k].q_factor"),
        aliases: &[ipc!("stage[i].filter.q_factor")],
        indices: &[STAGES, FILTERS],
        kind: Kind::Real { from: Bound::Closed(1.0), to: Bound::Closed(10.0) },
        default: &["-1"],
        since: IPC,
    }
}

//! The table: one declaration per parameter, in the order in which every output lists them; no rule and no reading.
//!
//! The comment above a declaration is the parameter's meaning. Sources: ISG FCT-A12 and the ISG axis parameter list,
//! Beckhoff TF5200. Parameters without an id are keys of our own, for what no axis list holds.

use super::words::{
    AddJerk, AxisType, Boolean, DirectSource, DriveType, Enable, FeedforwardWord, FilterType, LineEnd, ListEncoding,
    Motor, OperationMode, ProcessDatum, Prototype, RealType, StageMode, TargetName, Width, Words,
};
use super::{Bound, Kind, Parameter, Scope};

/// Stages of improved position control.
pub(crate) const STAGES: u32 = 3;
/// Filters of a stage.
pub(crate) const FILTERS: u32 = 2;
/// Gear steps of an axis.
const GEARS: u32 = 16;

/// Weights are unsigned numbers of 32 bits without 0 and the largest.
const WEIGHT: Kind = Kind::Integer { from: 1, to: u32::MAX - 1 };
/// A factor of the vendor's type UNS32.
const UNSIGNED: Kind = Kind::Integer { from: 1, to: u32::MAX };
/// A factor of the vendor's type SGN32; a denominator of 0 takes its term away.
const SIGNED: Kind = Kind::Integer { from: 0, to: i32::MAX as u32 };
/// A delay; six cycles end it, which the cycle time says.
const DELAY: Kind = Kind::Integer { from: 0, to: u16::MAX as u32 };
/// A finite real number that is not negative.
const POSITIVE: Kind = Kind::Real { from: Bound::Closed(0.0), to: Bound::Closed(f64::MAX) };
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
    data_type: "",
    unit: "",
    default: &[],
    since: "",
    printed: "",
    numbers: &[],
    drives: "",
    is_shared: false,
    meaning: "",
};
/// A parameter of the vendor that lists have for other functions too.
const SHARED: Parameter = Parameter { is_shared: true, ..VENDOR };
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

macro_rules! table {
    ($($(#[doc = $meaning:literal])+ $name:ident: $base:ident { $($field:ident: $value:expr),+ $(,)? })+) => {
        /// A parameter, by name; the order is the table's.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Name { $($(#[doc = $meaning])+ $name),+ }

        /// All parameters.
        pub(crate) static TABLE: [Parameter; [$(Name::$name),+].len()] = [$(
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
    CycleTime: SET_KEY { path: "cycle_time", kind: Kind::Duration { from: 1, to: u32::MAX as u64 }, unit: "ns" }
    /// what `generate` writes when the command line names no target
    Targets: SET_KEY { path: "targets", kind: Kind::Words(TargetName::WORDS) }
    /// file of the axis list, relative to the set; keys beside it override the list
    List: AXIS_KEY { path: "list" }
    /// axis list that the axis was imported from, line by line, for `axgen export`; `=` stands where the axis has the value
    ImportedLines: AXIS_KEY { path: "imported_list.lines" }
    /// what a character of these lines stands for: its bytes in UTF-8, or the one byte of its number
    ImportedEncoding: AXIS_KEY {
        path: "imported_list.encoding",
        kind: Kind::Word(ListEncoding::WORDS), default: &["utf-8"],
    }
    /// how every one of these lines ends
    ImportedLineEnd: AXIS_KEY { path: "imported_list.line_end", kind: Kind::Word(LineEnd::WORDS), default: &["LF"] }
    /// real type of the generated blocks: double or single precision
    RealType: AXIS_KEY { path: "real", kind: Kind::Word(RealType::WORDS), default: &["f64"] }
    /// gear step whose parameters (`getriebe[i]`) are used
    Gear: AXIS_KEY { path: "gear", kind: Kind::Integer { from: 0, to: GEARS - 1 }, default: &["0"] }
    /// time in which the additive velocity is faded in and out, at least one period of the lowest f0
    Fade: AXIS_KEY { path: "fade", kind: Kind::Duration { from: 0, to: 1_000_000_000_000 }, unit: "ns", default: &["0.1s"] }
    /// velocity command of the drive: its type in the process data; for position control in the CNC
    VelocityCommandData: AXIS_KEY {
        path: "process_data.velocity_command",
        kind: Kind::Word(Width::WORDS), default: &["INT32"],
    }
    /// additive velocity command of the drive: its type in the process data, SERCOS S-0-0037, CANopen 60B1h, PROFIdrive NSOLL_B
    AdditiveVelocityData: AXIS_KEY {
        path: "process_data.additive_velocity",
        kind: Kind::Word(ProcessDatum::WORDS), default: &["NONE"],
    }
    /// additive torque or current command of the drive: its type in the process data, SERCOS S-0-0081, CANopen 60B2h
    AdditiveTorqueData: AXIS_KEY { path: "process_data.additive_torque", kind: Kind::Word(ProcessDatum::WORDS), default: &["NONE"] }
    /// motor: a rotary one has a torque and an inertia, a linear one a force and a mass
    Motor: AXIS_KEY { path: "motor", kind: Kind::Word(Motor::WORDS), default: &["rotary"] }
    /// whether ADD_JERK of P-AXIS-00223 is generated: its formula is inferred from units, not documented
    AddJerk: AXIS_KEY { path: "add_jerk", kind: Kind::Word(AddJerk::WORDS), default: &["refused"] }
    /// logical axis number
    AxisNumber: VENDOR {
        id: Some("P-AXIS-00016"), path: "kopf.achs_nr",
        kind: Kind::Integer { from: 0, to: 65_535 }, default: &["0"],
    }
    /// axis type: translatory axis, rotary axis or spindle
    AxisType: VENDOR {
        id: Some("P-AXIS-00018"), path: "kenngr.achs_typ",
        kind: Kind::Word(AxisType::WORDS), default: &["ACHSTYP_TRANSLATOR"],
    }
    /// drive type; it decides where the position is controlled, unless P-AXIS-00320 does
    DriveType: SHARED {
        id: Some("P-AXIS-00020"), path: "kenngr.antr_typ",
        kind: Kind::Word(DriveType::WORDS), default: &["SIMULATION"],
    }
    /// on a gantry slave: logical axis number of its master
    GantryMaster: VENDOR {
        id: Some("P-AXIS-00070"), path: "kenngr.gantry_ax_nr",
        kind: Kind::Integer { from: 0, to: 65_535 }, default: &["0"],
    }
    /// largest velocity of the axis
    VbMax: VENDOR {
        id: Some("P-AXIS-00212"), path: "getriebe[i].dynamik.vb_max", indices: &[GEARS],
        kind: Kind::Integer { from: 1, to: 2_000_000_000 }, unit: "um/s or 0.001 deg/s", default: &["200000"],
    }
    /// gain of the position controller Kv; a drive that controls the position has the same (SERCOS S-0-0104, CANopen 30C0h:01)
    Kv: SHARED {
        id: Some("P-AXIS-00099"), path: "getriebe[i].kv", indices: &[GEARS],
        kind: UNSIGNED, unit: "0.01/s", default: &["1000"],
    }
    /// velocity command of the drive: denominator of its value at 1 m/min or 1000 deg/min
    MultiGainN: SHARED {
        id: Some("P-AXIS-00128"), path: "getriebe[i].multi_gain_n", indices: &[GEARS],
        data_type: "UNS32", kind: UNSIGNED, default: &["1"],
        drives: "Simulation, Conventional, Terminal, Lightbus, PROFIdrive",
    }
    /// velocity command of the drive: numerator of its value at 1 m/min or 1000 deg/min
    MultiGainZ: SHARED {
        id: Some("P-AXIS-00129"), path: "getriebe[i].multi_gain_z", indices: &[GEARS],
        data_type: "UNS32", kind: UNSIGNED, unit: "increments", default: &["2000"],
        drives: "Simulation, Conventional, Terminal, Lightbus, PROFIdrive",
    }
    /// position increments of the controller per revolution of the motor
    IncrPerRev: SHARED {
        id: Some("P-AXIS-00092"), path: "getriebe[i].incr_per_rev", indices: &[GEARS],
        data_type: "UNS32", kind: Kind::Integer { from: 0, to: u32::MAX }, unit: "increments/revolution",
        default: &["1024"], drives: "----",
    }
    /// path resolution: denominator, path; with a feed constant revolutions of the gear's output
    WegaufN: SHARED {
        id: Some("P-AXIS-00233"), path: "getriebe[i].wegaufn", indices: &[GEARS],
        kind: UNSIGNED, default: &["1"],
    }
    /// path resolution: numerator, increments; with a feed constant revolutions of the gear's input
    WegaufZ: SHARED {
        id: Some("P-AXIS-00234"), path: "getriebe[i].wegaufz", indices: &[GEARS],
        kind: UNSIGNED, default: &["1"],
    }
    /// total load at the motor: inertia of motor and load, or the moved mass of a linear motor
    Load: SHARED {
        id: Some("P-AXIS-00391"), path: "getriebe[i].load", indices: &[GEARS],
        data_type: "REAL64", kind: POSITIVE, unit: "kg m^2, linear motor: kg", default: &["1e-6"], drives: "SERCOS",
    }
    /// feed constant: numerator
    FeedConstNum: SHARED {
        id: Some("P-AXIS-00362"), path: "antr.feed_const_num",
        kind: UNSIGNED, unit: "0.1 um/revolution or 0.0001 deg/revolution", default: &["1"],
    }
    /// feed constant: denominator
    FeedConstDenom: SHARED { id: Some("P-AXIS-00363"), path: "antr.feed_const_denom", kind: UNSIGNED, default: &["1"] }
    /// where the position is controlled; DRIVE_DEFAULT: in the drive for SERCOS, PROFIdrive and CANopen, else in the CNC
    OperationMode: SHARED {
        id: Some("P-AXIS-00320"), path: "antr.operation_mode",
        kind: Kind::Word(OperationMode::WORDS), default: &["DRIVE_DEFAULT"],
    }
    /// cycles between sending a command and receiving the actual value that it caused
    NbrDelayCycles: SHARED {
        id: Some("P-AXIS-00191"), path: "antr.nbr_delay_cycles",
        kind: Kind::Integer { from: 0, to: 10 }, unit: "cycles", default: &["-1"],
    }
    /// scaling of the additive velocity: path in the time of P-AXIS-00207 at which the drive gets P-AXIS-00206
    VResoDenom: SHARED {
        id: Some("P-AXIS-00205"), path: "antr.v_reso_denom",
        data_type: "UNS32", kind: UNSIGNED, unit: "um or 0.001 deg", default: &["36"], drives: "all",
    }
    /// scaling of the additive velocity: value that the drive gets
    VResoNum: SHARED {
        id: Some("P-AXIS-00206"), path: "antr.v_reso_num",
        data_type: "UNS32", kind: Kind::Integer { from: 0, to: u32::MAX }, unit: "increments", default: &["1"],
        drives: "all",
    }
    /// scaling of the additive velocity: the time of P-AXIS-00205
    VTimeBase: SHARED {
        id: Some("P-AXIS-00207"), path: "antr.v_time_base",
        data_type: "UNS16", kind: Kind::Integer { from: 0, to: 2 }, default: &["0"],
        numbers: &["per minute", "per second", "per sampling interval"], drives: "SERCOS",
    }
    /// feedforward: the quantities, and whether they go to the drive as additive commands
    FeedforwardMode: SHARED {
        id: Some("P-AXIS-00223"), path: "vorsteuer.vorsteuerung",
        data_type: "STRING, before the words UNS16", kind: Kind::Flags(FeedforwardWord::WORDS), default: &["NONE"],
        since: "words: V2.11.2034.6, V2.11.2808.03, V3.1.3065.04, V3.1.3102.00", drives: "----",
    }
    /// feedforward of the acceleration: numerator of its time constant; with ADD_ACC of a plain weight
    VsAFaktor: SHARED {
        id: Some("P-AXIS-00225"), path: "vorsteuer.vs_a_faktor",
        data_type: "SGN32", kind: SIGNED, unit: "us, with ADD_ACC: 1", default: &["1"], drives: "----",
    }
    /// feedforward of the acceleration: denominator; 0 takes the term away
    VsANenner: SHARED {
        id: Some("P-AXIS-00226"), path: "vorsteuer.vs_a_nenner",
        data_type: "SGN32", kind: SIGNED, default: &["1"], drives: "----",
    }
    /// weight of the whole feedforward: numerator; 0.7 to 1 is usual, above 1 the axis leads
    VsVFaktor: SHARED {
        id: Some("P-AXIS-00228"), path: "vorsteuer.vs_v_faktor",
        data_type: "SGN32", kind: SIGNED, default: &["1"], drives: "----",
    }
    /// weight of the whole feedforward: denominator; 0 takes all of it away
    VsVNenner: SHARED {
        id: Some("P-AXIS-00229"), path: "vorsteuer.vs_v_nenner",
        data_type: "SGN32", kind: SIGNED, default: &["1"], drives: "----",
    }
    /// feedforward is active despite G137
    DefaultActive: SHARED {
        id: Some("P-AXIS-00255"), path: "vorsteuer.default_active",
        kind: Kind::Word(Boolean::WORDS), default: &["FALSE"],
    }
    /// feedforward is inactive despite G135, and despite P-AXIS-00255
    GlobalDisable: SHARED {
        id: Some("P-AXIS-00256"), path: "vorsteuer.global_disable",
        kind: Kind::Word(Boolean::WORDS), default: &["FALSE"],
    }
    /// feedforward of the jerk: numerator of its factor
    JerkFactNum: SHARED {
        id: Some("P-AXIS-00337"), path: "vorsteuer.jerk_fact_num",
        data_type: "UNS32", kind: Kind::Integer { from: 0, to: u32::MAX }, default: &["1"], drives: "----",
    }
    /// feedforward of the jerk: denominator of its factor; 0 is corrected to 100 (110473)
    JerkFactDenom: SHARED {
        id: Some("P-AXIS-00338"), path: "vorsteuer.jerk_fact_denom",
        data_type: "UNS32", kind: UNSIGNED, default: &["100"], drives: "----",
    }
    /// delay of the additive velocity against the position, below six cycles; outside it is corrected to 0 (70349)
    VelocityDelayTime: SHARED {
        id: Some("P-AXIS-00389"), path: "vorsteuer.velocity_delay_time",
        data_type: "UNS16", kind: DELAY, unit: "us", default: &["0"],
        printed: "0 <= velocity_delay_time < 6 interpolator cycles; in an example: at most one cycle",
        drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// delay of the additive torque of ADD_ACC against the position, below six cycles; outside it is corrected to 0 (70348)
    AccelerationDelayTime: SHARED {
        id: Some("P-AXIS-00390"), path: "vorsteuer.acceleration_delay_time",
        data_type: "UNS16", kind: DELAY, unit: "us", default: &["0"],
        printed: "0 < acceleration_delay_time < 6 interpolator cycles, which excludes the default; in an example: at most one cycle",
        drives: "SERCOS, Lightbus, PROFIdrive, CANopen",
    }
    /// delay of the additive torque of ADD_JERK against the position, below six cycles; outside it is corrected to 0 (70348)
    JerkDelayTime: SHARED {
        id: Some("P-AXIS-00547"), path: "vorsteuer.jerk_delay_time",
        kind: DELAY, unit: "us", default: &["0"],
    }
    /// feedforward without the delay of a cycle; with VEL alone, else it is the error 110624
    FeedforwardWithoutDelay: SHARED {
        id: Some("P-AXIS-00566"), path: "vorsteuer.feedforward_without_delay",
        kind: Kind::Word(Boolean::WORDS), default: &["FALSE"],
    }
    /// PROFIdrive: cycles by which the feedforward leads the position
    ShiftTime: SHARED {
        id: Some("P-AXIS-00165"), path: "vorsteuer.shift_time",
        data_type: "UNS16", kind: Kind::Integer { from: 0, to: 4 }, unit: "cycles", default: &["3"],
        drives: "PROFIdrive",
    }
    /// additive torque: numerator of the value at which the motor has its nominal torque
    TorqueScaleNum: SHARED {
        id: Some("P-AXIS-00325"), path: "antr.torque_scale_num",
        data_type: "UNS32", kind: WEIGHT, unit: "increments", default: &["1"], drives: "SERCOS, Lightbus, CANopen",
    }
    /// additive torque: denominator; 0 takes the additive torque away (110465)
    TorqueScaleDenom: SHARED {
        id: Some("P-AXIS-00326"), path: "antr.torque_scale_denom",
        data_type: "UNS32", kind: WEIGHT, default: &["1"],
        printed: "1 < torque_scale_denom < MAX(UNS32), which excludes the default", drives: "SERCOS, Lightbus, CANopen",
    }
    /// additive torque: nominal torque or force of the motor, from its data sheet; 0 takes the additive torque away
    AccReferenceValue: SHARED {
        id: Some("P-AXIS-00392"), path: "antr.acc_reference_value",
        data_type: "REAL64", kind: POSITIVE, unit: "Nm, linear motor: N", default: &["1"], drives: "SERCOS, CANopen",
    }
    /// weight of the feedforward that the drive itself has (SERCOS S-0-0296, CANopen 3062h)
    FeedForwardVWeighting: SHARED {
        id: Some("P-AXIS-00833"), path: "antr.feed_forward_v_weighting",
        kind: Kind::Integer { from: 0, to: 1200 }, unit: "0.1 %", default: &["0"], since: "V3.1.3125.0",
        drives: "SERCOS, CANopen",
    }
    /// predecessor of P-AXIS-00833, which adopts it
    ChangeFeedForwardVWeighting: SHARED {
        id: Some("P-AXIS-00766"), path: "antr.sai_op_mode_change.feed_forward_v_weighting",
        data_type: "UNS16", kind: Kind::Integer { from: 0, to: 1200 }, unit: "0.1 %", default: &["0"],
        drives: "SERCOS, CANopen",
    }
    /// spindle: velocity from which it is in velocity control; nothing is generated from it yet
    VVelocityControlOn: SHARED {
        id: Some("P-AXIS-00767"), path: "antr.sai_op_mode_change.v_velocity_control_on",
        data_type: "SGN32", kind: SIGNED, unit: "0.001 deg/s", default: &["200000000"], since: "V3.1.3079.13",
        drives: "SERCOS, CANopen",
    }
    /// spindle: velocity below which it is in position control again; nothing is generated from it yet
    VPositionControlOn: SHARED {
        id: Some("P-AXIS-00768"), path: "antr.sai_op_mode_change.v_position_control_on",
        data_type: "SGN32", kind: SIGNED, unit: "0.001 deg/s", default: &["0"], since: "V3.1.3079.13",
        drives: "SERCOS, CANopen",
    }
    /// mode of improved position control at start; DRYRUN calculates and puts out nothing
    Enable: VENDOR {
        id: Some("P-AXIS-00758"), path: ipc!("enable"),
        data_type: "STRING, before V3.1.3132.0 BOOLEAN", kind: Kind::Word(Enable::WORDS), default: &["OFF"],
        since: "V3.1.3077.08; words: V3.1.3132.0", drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// largest additive velocity as a part of the largest velocity of the axis (P-AXIS-00212)
    VAddMaxFact: VENDOR {
        id: Some("P-AXIS-00757"), path: ipc!("v_add_max_fact"),
        data_type: "UNS16", kind: Kind::Integer { from: 0, to: 2000 }, unit: "0.1 %", default: &["0"], since: IPC,
        drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// where the stage takes the vibration from: a measured velocity, the motor's velocity behind a simulated
    /// oscillation, or the command velocity behind a simulated oscillation
    Mode: VENDOR {
        id: Some("P-AXIS-00753"), path: ipc!("stage[i].mode"), indices: &[STAGES],
        data_type: "UNS32", kind: Kind::Word(StageMode::WORDS), default: &["NOT_ACTIVE"], since: IPC,
        drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// measured velocity that a DIRECT stage takes: motor encoder or direct measuring system
    DirectSource: AXIS_KEY {
        path: ipc!("stage[i].direct_source"), indices: &[STAGES],
        kind: Kind::Word(DirectSource::WORDS), default: &["v_motor"],
    }
    /// weight of the stage: numerator; a weight above 7 is capped
    WeightFactNum: VENDOR {
        id: Some("P-AXIS-00754"), path: ipc!("stage[i].weight_fact_num"), indices: &[STAGES],
        data_type: "UNS32", kind: WEIGHT, default: &["1"], since: IPC, drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// weight of the stage: denominator
    WeightFactDenom: VENDOR {
        id: Some("P-AXIS-00755"), path: ipc!("stage[i].weight_fact_denom"), indices: &[STAGES],
        data_type: "UNS32", kind: WEIGHT, default: &["1"], since: IPC, drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// damping ratio of the simulated oscillation (INDIRECT, SET_POINT); the lower, the larger the additive velocity
    OscDamping: VENDOR {
        id: Some("P-AXIS-00850"), path: ipc!("stage[i].osc_damping"), misprints: &[ipc!("stage[i]osc_damping")],
        indices: &[STAGES],
        data_type: "REAL64", kind: DAMPING, default: &["-1"], since: IPC_FILTERS, drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// predecessor of P-AXIS-00850
    FilterDamping: VENDOR {
        id: Some("P-AXIS-00756"), path: ipc!("stage[i].filter.damping"), aliases: &[ipc!("stage[i].filter[k].damping")],
        indices: &[STAGES, 1],
        data_type: "REAL64", kind: DAMPING, default: &["-1"], since: IPC, drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// type of the filter; every active stage needs a band-pass
    FilterType: VENDOR {
        id: Some("P-AXIS-00849"), path: ipc!("stage[i].filter[k].type"), aliases: &[ipc!("stage[i].filter.type")],
        indices: &[STAGES, FILTERS],
        data_type: "STRING", kind: Kind::Word(FilterType::WORDS), default: &["BANDPASS", "NO_FILTER"],
        since: IPC_FILTERS, drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// low-pass prototype of a band-pass; the second filter needs it in writing
    FilterPrototype: VENDOR {
        id: Some("P-AXIS-00848"), path: ipc!("stage[i].filter[k].prototype"),
        aliases: &[ipc!("stage[i].filter.prototype")], indices: &[STAGES, FILTERS],
        data_type: "STRING", kind: Kind::Word(Prototype::WORDS), default: &["CRIT_DAMPING"], since: IPC_FILTERS,
        drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// order of a band-pass: its sections of second order, 20 dB/decade each
    FilterOrder: VENDOR {
        id: Some("P-AXIS-00750"), path: ipc!("stage[i].filter[k].order"), aliases: &[ipc!("stage[i].filter.order")],
        indices: &[STAGES, FILTERS],
        data_type: "UNS32", kind: Kind::Integer { from: 1, to: 3 }, default: &["0"], since: IPC,
        drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// centre frequency of a band-pass and of the simulated oscillation; frequency of -180 degrees of an all-pass
    FilterF0: VENDOR {
        id: Some("P-AXIS-00751"), path: ipc!("stage[i].filter[k].fg_f0"), aliases: &[ipc!("stage[i].filter.fg_f0")],
        indices: &[STAGES, FILTERS],
        data_type: "REAL64", kind: Kind::Real { from: Bound::Open(0.0), to: Bound::Closed(500.0) }, unit: "Hz",
        default: &["-1"], since: IPC, drives: "SERCOS, PROFIdrive, CANopen",
    }
    /// quality factor: centre frequency / bandwidth at -3 dB
    FilterQ: VENDOR {
        id: Some("P-AXIS-00752"), path: ipc!("stage[i].filter[k].q_factor"),
        aliases: &[ipc!("stage[i].filter.q_factor")], indices: &[STAGES, FILTERS],
        data_type: "REAL64", kind: Kind::Real { from: Bound::Closed(1.0), to: Bound::Closed(10.0) }, default: &["-1"],
        since: IPC, drives: "SERCOS, PROFIdrive, CANopen",
    }
}

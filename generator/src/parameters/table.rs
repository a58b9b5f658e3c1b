//! The table: one declaration per parameter, in the order in which every output lists them; no rule and no reading.
//!
//! The comment above a declaration is the parameter's meaning. Sources: ISG FCT-A12 and the ISG axis parameter list,
//! Beckhoff TF5200. Parameters without an id are keys of our own, for what no axis list holds.

use super::words::{
    AddJerk, AxisType, Boolean, DirectSource, DriveObject, DriveSetting, DriveType, Enable, FeedforwardWord,
    FilterType, LineEnd, ListEncoding, Motor, OperationMode, ProcessDatum, Prototype, RealType, ResponseFrom,
    StageMode, TargetName, Tunable, Width, Words,
};
use super::{Kind, Parameter, Scope};

/// Stages of improved position control.
pub(crate) const STAGES: u32 = 3;
/// Filters of a stage.
pub(crate) const FILTERS: u32 = 2;
/// Gear steps of an axis.
const GEARS: u32 = 16;

const fn integer(from: u32, to: u32) -> Kind {
    Kind::Integer { from: from as i64, to: to as i64 }
}

/// A real number above 0.
const fn above_0(to: f64) -> Kind {
    Kind::Real { from: 0.0, to, open: [true, false] }
}

/// Weights are unsigned numbers of 32 bits without 0 and the largest.
const WEIGHT: Kind = integer(1, u32::MAX - 1);
const FRACTION: Kind = Kind::Real { from: 0.0, to: 1.0, open: [false; 2] };
/// A factor of the vendor's type UNS32.
const UNSIGNED: Kind = integer(1, u32::MAX);
/// A factor of the vendor's type SGN32; a denominator of 0 takes its term away.
const SIGNED: Kind = integer(0, i32::MAX as u32);
/// A number of the vendor's type SGN16.
const SIGNED_16: Kind = Kind::Integer { from: i16::MIN as i64, to: i16::MAX as i64 };
/// A delay; six cycles end it, which the cycle time says.
const DELAY: Kind = integer(0, u16::MAX as u32);
/// A finite real number that is not negative.
const POSITIVE: Kind = Kind::Real { from: 0.0, to: f64::MAX, open: [false; 2] };
/// Damping ratio of a vibration.
const DAMPING: Kind = Kind::Real { from: 0.0, to: 1.0, open: [true; 2] };
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
    axes: "",
    dimension: "",
    is_shared: false,
    meaning: "",
};
/// A parameter of the vendor that lists have for other functions too.
const SHARED: Parameter = Parameter { is_shared: true, ..VENDOR };
/// A switch of feedforward.
const SWITCH: Parameter = Parameter { kind: Kind::Word(Boolean::WORDS), default: &["FALSE"], ..SHARED };
/// One whose axis types and dimension a manual prints.
const PRINTED: Parameter = Parameter { axes: "T, R, S", dimension: "----", ..SHARED };
/// A factor of feedforward of the vendor's type SGN32.
const FACTOR: Parameter = Parameter { data_type: "SGN32", kind: SIGNED, default: &["1"], drives: "----", ..PRINTED };
/// A parameter of a gear step.
const GEAR: Parameter = Parameter { indices: &[GEARS], ..SHARED };
const PRINTED_GEAR: Parameter = Parameter { indices: &[GEARS], ..PRINTED };
/// A parameter of improved position control, of one of its stages, of a filter there; with the first build that has it.
const IPC: Parameter =
    Parameter { since: "V3.1.3077.08", drives: "SERCOS, PROFIdrive, CANopen", is_shared: false, ..PRINTED };
const STAGE: Parameter = Parameter { indices: &[STAGES], ..IPC };
const FILTER: Parameter = Parameter { indices: &[STAGES, FILTERS], ..IPC };
/// A key of our own below an axis.
const AXIS_KEY: Parameter = Parameter { scope: Scope::Axis, ..VENDOR };
/// A key of our own at the top of a set.
const SET_KEY: Parameter = Parameter { scope: Scope::Set, ..VENDOR };

macro_rules! table {
    ($($(#[doc = $meaning:literal])+ $name:ident: $base:ident(
        $path:literal $(, $id:literal)? $(, $field:ident: $value:expr)*
    ))+) => {
        /// A parameter, by name; the order is the table's.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Name { $($(#[doc = $meaning])+ $name),+ }

        pub(crate) static TABLE: [Parameter; [$(Name::$name),+].len()] = [$(
            Parameter {
                path: $path,
                $(id: Some($id),)?
                meaning: concat!($($meaning),+).trim_ascii(),
                $($field: $value,)*
                ..$base
            }
        ),+];

        impl Name {
            pub const ALL: [Name; [$(Name::$name),+].len()] = [$(Name::$name),+];
        }
    };
}

table! {
    /// cycle time of the position controller: one call of the block
    CycleTime: SET_KEY("cycle_time", kind: Kind::Duration { from: 1, to: u32::MAX as u64 }, unit: "ns")
    /// what `generate` writes when the command line names no target
    Targets: SET_KEY("targets", kind: Kind::Words(TargetName::WORDS))
    /// file of the axis list, relative to the set; keys next to it override the list
    List: AXIS_KEY("list")
    /// axis list that the axis was imported from, line by line, for `axgen export`; `=` stands where the axis has the value
    ImportedLines: AXIS_KEY("imported_list.lines")
    /// what stands before these lines in their file, a project of TwinCAT
    ImportedBefore: AXIS_KEY("imported_list.before")
    /// what stands after these lines in their file
    ImportedAfter: AXIS_KEY("imported_list.after", aliases: &["imported_list.behind"])
    /// what a character of these lines stands for in the file: its bytes in UTF-8 or UTF-16, or the one byte of its number
    ImportedEncoding: AXIS_KEY("imported_list.encoding", kind: Kind::Word(ListEncoding::WORDS), default: &["utf-8"])
    /// how every one of these lines ends
    ImportedLineEnd: AXIS_KEY("imported_list.line_end", kind: Kind::Word(LineEnd::WORDS), default: &["LF"])
    /// real type of the generated blocks: double or single precision
    RealType: AXIS_KEY("real", kind: Kind::Word(RealType::WORDS), default: &["f64"])
    /// names in C for tools that distinguish only the first 31 characters (C99 5.2.4.1, MISRA C:2012 5.1): all
    /// names that linkers see have at most as many; the axis then has a name of at most 12 characters
    ShortNames: AXIS_KEY("short_names", kind: Kind::Word(Boolean::WORDS), default: &["FALSE"])
    /// gear step whose parameters (`getriebe[i]`) are used
    Gear: AXIS_KEY("gear", kind: integer(0, GEARS - 1), default: &["0"])
    /// time in which the additive velocity is faded in and out, at least one period of the lowest f0
    Fade: AXIS_KEY("fade", kind: Kind::Duration { from: 0, to: 1_000_000_000_000 }, unit: "ns", default: &["0.1s"])
    /// bad samples in a row in whose place improved position control takes the last good one; 0: the first one is a fault
    RideThrough: AXIS_KEY("ride_through", kind: integer(0, 10), default: &["0"])
    /// what the caller may tune while improved position control acts: nothing; each stage's weight and the limit; all numbers, which
    /// come from parameter sets; or the parameters, from which the block `set_design` makes such sets
    Tunable: AXIS_KEY("tunable", kind: Kind::Word(Tunable::WORDS), default: &["nothing"])
    /// lowest centre frequency that the block `set_design` accepts: the fade lasts at least one period of it
    LowestF0: AXIS_KEY("lowest_f0", kind: Kind::Real { from: 0.0, to: 500.0, open: [true, false] }, unit: "Hz")
    /// start of the input tuning_limit: the part of the limit (P-AXIS-00757) that holds
    TuningLimit: AXIS_KEY("tuning_limit", kind: FRACTION, default: &["1"])
    /// whether improved position control watches its loop, fades out where it becomes unstable, and says so: output `tripped`
    Watch: AXIS_KEY("watch", kind: Kind::Word(Boolean::WORDS), default: &["FALSE"])
    /// cycles after which the motor does what was commanded, at least 1, fractions allowed: for the stability of
    /// the loop; it does not affect the blocks
    DriveDelay: AXIS_KEY("drive.delay", kind: Kind::Real { from: 1.0, to: 1000.0, open: [false; 2] }, unit: "cycles")
    /// time constant of the drive's velocity, after the delay: for the stability of the loop
    DriveTimeConstant: AXIS_KEY("drive.time_constant", kind: Kind::Duration { from: 1, to: 10_000_000_000 }, unit: "ns")
    /// file of a measured frequency response to the velocity of the motor, relative to the set: for the stability of the loop, instead of
    /// the time constant; drive.delay is then the delay that it lacks, without it 0
    DriveResponse: AXIS_KEY("drive.response")
    /// the signal that the response starts from: the commanded velocity; or the current, which needs the gain and the integral time of the
    /// speed controller too
    DriveResponseFrom: AXIS_KEY("drive.response_from", kind: Kind::Word(ResponseFrom::WORDS), default: &["v_cmd"])
    /// gain of the speed controller, in units of the current in the response for one of its velocity
    DriveSpeedGain: AXIS_KEY("drive.speed_gain", kind: above_0(f64::MAX))
    /// integral time of the speed controller
    DriveSpeedIntegralTime: AXIS_KEY("drive.speed_integral_time", kind: Kind::Duration { from: 1, to: 10_000_000_000 }, unit: "ns")
    /// accepts a block that starts ON although its loop oscillates even with an ideal drive: for test stands without a machine
    AcceptUnstable: AXIS_KEY("accept_unstable", kind: Kind::Word(Boolean::WORDS), default: &["FALSE"])
    /// amplitude of the block excitation, in the unit of velocities; a key `excitation` asks for the block
    ExcitationAmplitude: AXIS_KEY("excitation.amplitude", kind: above_0(1e9), unit: "um/s or 0.001 deg/s", default: &["2000"])
    /// bits of the shift register of the excitation; without it the fewest with a period of 4 s
    ExcitationBits: AXIS_KEY("excitation.bits", kind: integer(7, 15))
    /// cycles for which a clock of the excitation lasts; without it 2 ms, at least one cycle
    ExcitationClock: AXIS_KEY("excitation.clock", kind: integer(1, 100_000), unit: "cycles")
    /// periods of the excitation that are measured, after one that settles
    ExcitationPeriods: AXIS_KEY("excitation.periods", kind: integer(4, 1000), default: &["8"])
    /// whether the blocks look at the rate of their calls: input `cycle_counter`; skipped and doubled calls are a fault, and after a pause the
    /// block restarts
    CycleCounter: AXIS_KEY("cycle_counter", kind: Kind::Word(Boolean::WORDS), default: &["FALSE"])
    /// velocity command of the drive: its type in the process data; for position control in the CNC, and for a spindle whose drive changes
    /// to velocity control
    VelocityCommandData: AXIS_KEY("process_data.velocity_command", kind: Kind::Word(Width::WORDS), default: &["INT32"])
    /// additive velocity command of the drive: its type in the process data, SERCOS S-0-0037, CANopen 60B1h, PROFIdrive NSOLL_B
    AdditiveVelocityData: AXIS_KEY("process_data.additive_velocity",
        kind: Kind::Word(ProcessDatum::WORDS), default: &["NONE"])
    /// additive torque or current command of the drive: its type in the process data, SERCOS S-0-0081, CANopen 60B2h
    AdditiveTorqueData: AXIS_KEY("process_data.additive_torque",
        kind: Kind::Word(ProcessDatum::WORDS), default: &["NONE"])
    /// motor: a rotary one has a torque and an inertia, a linear one a force and a mass
    Motor: AXIS_KEY("motor", kind: Kind::Word(Motor::WORDS), default: &["rotary"])
    /// whether ADD_JERK of P-AXIS-00223 is generated: its formula is inferred from units, not documented
    AddJerk: AXIS_KEY("add_jerk", kind: Kind::Word(AddJerk::WORDS), default: &["refused"])
    /// spindle whose drive changes its operation mode: what the drive's cyclic telegrams have; where it is given, it is checked
    ProcessDataObjects: AXIS_KEY("process_data.objects", kind: Kind::Words(DriveObject::WORDS))
    /// spindle whose SERCOS drive changes its operation mode: settings that the drive has (010: bits 2 to 0, rotary); where it is given, it
    /// is checked
    DriveSettings: AXIS_KEY("drive_settings", kind: Kind::Words(DriveSetting::WORDS))
    /// spindle: deceleration of the velocity command on the way from velocity control to position control
    SpindleDeceleration: AXIS_KEY("spindle.deceleration",
        kind: above_0(1e12), unit: "0.001 deg/s^2", default: &["6000000"])
    /// spindle: how close the actual velocity must be to that of position control; at least 1 % of P-AXIS-00768, by default two steps of the encoder too
    SpindleWindow: AXIS_KEY("spindle.window", kind: above_0(2e9), unit: "0.001 deg/s", default: &["6000"])
    /// spindle: largest step of the position command when the interpolator takes over, at a constant velocity
    SpindleTakeoverWindow: AXIS_KEY("spindle.takeover_window",
        kind: above_0(180_000.0), unit: "0.001 deg", default: &["1000"])
    /// spindle: time in which the drive displays the new operation mode; by default at least 10 cycles more than P-AXIS-00191
    SpindleModeTimeout: AXIS_KEY("spindle.mode_timeout",
        kind: Kind::Duration { from: 1, to: 1_000_000_000_000 }, unit: "ns", default: &["0.1s"])
    /// spindle: time in which it has braked; 0: twice the ramp from P-AXIS-00212 to P-AXIS-00768, and 0.5 s
    SpindleBrakeTimeout: AXIS_KEY("spindle.brake_timeout",
        kind: Kind::Duration { from: 0, to: 1_000_000_000_000 }, unit: "ns", default: &["0s"])
    /// logical axis number
    AxisNumber: VENDOR("kopf.achs_nr", "P-AXIS-00016", kind: integer(0, 65_535), default: &["0"])
    /// axis type: translatory axis, rotary axis or spindle
    AxisType: VENDOR("kenngr.achs_typ", "P-AXIS-00018",
        kind: Kind::Word(AxisType::WORDS), default: &["ACHSTYP_TRANSLATOR"])
    /// drive type; it decides where the position is controlled, unless P-AXIS-00320 does
    DriveType: SHARED("kenngr.antr_typ", "P-AXIS-00020", kind: Kind::Word(DriveType::WORDS), default: &["SIMULATION"])
    /// on a gantry slave: logical axis number of its master
    GantryMaster: VENDOR("kenngr.gantry_ax_nr", "P-AXIS-00070", kind: integer(0, 65_535), default: &["0"])
    /// largest velocity of the axis
    VbMax: VENDOR("getriebe[i].dynamik.vb_max", "P-AXIS-00212",
        indices: &[GEARS], kind: integer(1, 2_000_000_000), unit: "um/s or 0.001 deg/s", default: &["200000"])
    /// gain of the position controller Kv; a drive that controls the position has the same (SERCOS S-0-0104, CANopen 30C0h:01)
    Kv: GEAR("getriebe[i].kv", "P-AXIS-00099", kind: UNSIGNED, unit: "0.01/s", default: &["1000"])
    /// velocity command of the drive: denominator of its value at 1 m/min or 1000 deg/min
    MultiGainN: PRINTED_GEAR("getriebe[i].multi_gain_n", "P-AXIS-00128",
        data_type: "UNS32", kind: UNSIGNED, default: &["1"],
        drives: "Simulation, Conventional, Terminal, Lightbus, PROFIdrive")
    /// velocity command of the drive: numerator of its value at 1 m/min or 1000 deg/min
    MultiGainZ: PRINTED_GEAR("getriebe[i].multi_gain_z", "P-AXIS-00129",
        data_type: "UNS32", kind: UNSIGNED, unit: "increments", default: &["2000"],
        drives: "Simulation, Conventional, Terminal, Lightbus, PROFIdrive", dimension: "T: bit; R, S: bit")
    /// position increments of the controller per revolution of the motor
    IncrPerRev: PRINTED_GEAR("getriebe[i].incr_per_rev", "P-AXIS-00092",
        data_type: "UNS32", kind: integer(0, u32::MAX), unit: "increments/revolution", default: &["1024"],
        drives: "----", dimension: "T: increments/rev.; R, S: increments/rev.")
    /// path resolution: denominator, path; with a feed constant revolutions of the gear's output
    WegaufN: GEAR("getriebe[i].wegaufn", "P-AXIS-00233", kind: UNSIGNED, default: &["1"])
    /// path resolution: numerator, increments; with a feed constant revolutions of the gear's input
    WegaufZ: GEAR("getriebe[i].wegaufz", "P-AXIS-00234", kind: UNSIGNED, default: &["1"])
    /// gear ratio: revolutions of the input; where the resolution is used, axgen takes the ratio from P-AXIS-00234 and 00233
    GearFactNum: GEAR("getriebe[i].gear_fact_num", "P-AXIS-00511", kind: UNSIGNED, default: &["1"])
    /// gear ratio: revolutions of the output
    GearFactDenom: GEAR("getriebe[i].gear_fact_denom", "P-AXIS-00512", kind: UNSIGNED, default: &["1"])
    /// total load at the motor: inertia of motor and load, or the moved mass of a linear motor
    Load: PRINTED_GEAR("getriebe[i].load", "P-AXIS-00391",
        data_type: "REAL64", kind: POSITIVE, unit: "kg m^2, linear motor: kg", default: &["1e-6"], drives: "SERCOS",
        dimension: "T: kg; R, S: kg m^2")
    /// stroke of the measuring probe: feedforward delays the position, and a measuring run needs more of it
    HubMesstaster: SHARED("kenngr.hub_messtaster", "P-AXIS-00086", kind: integer(0, u32::MAX), unit: "0.1 um", default: &["0"])
    /// feed constant: numerator
    FeedConstNum: SHARED("antr.feed_const_num", "P-AXIS-00362",
        kind: UNSIGNED, unit: "0.1 um/revolution or 0.0001 deg/revolution", default: &["1"])
    /// feed constant: denominator
    FeedConstDenom: SHARED("antr.feed_const_denom", "P-AXIS-00363", kind: UNSIGNED, default: &["1"])
    /// where the position is controlled; DRIVE_DEFAULT: in the drive for SERCOS, PROFIdrive and CANopen, else in the CNC
    OperationMode: SHARED("antr.operation_mode", "P-AXIS-00320",
        kind: Kind::Word(OperationMode::WORDS), default: &["DRIVE_DEFAULT"])
    /// cycles between sending a command and receiving the actual value that it caused
    NbrDelayCycles: SHARED("antr.nbr_delay_cycles", "P-AXIS-00191",
        kind: integer(0, 10), unit: "cycles", default: &["-1"])
    /// scaling of the additive velocity, and of the velocity command of a spindle: path in the time of P-AXIS-00207 at which the drive gets P-AXIS-00206
    VResoDenom: PRINTED("antr.v_reso_denom", "P-AXIS-00205",
        data_type: "UNS32", kind: UNSIGNED, unit: "um or 0.001 deg", default: &["36"], drives: "all",
        dimension: "T: 1 um; R, S: 0.001 deg")
    /// scaling of the additive velocity, and of the velocity command of a spindle: value that the drive gets
    VResoNum: PRINTED("antr.v_reso_num", "P-AXIS-00206",
        data_type: "UNS32", kind: integer(0, u32::MAX), unit: "increments", default: &["1"], drives: "all",
        dimension: "T: increments; R, S: increments")
    /// scaling of the additive velocity, and of the velocity command of a spindle: the time of P-AXIS-00205
    VTimeBase: PRINTED("antr.v_time_base", "P-AXIS-00207",
        data_type: "UNS16", kind: integer(0, 2), default: &["0"],
        numbers: &["per minute", "per second", "per sampling interval"], drives: "SERCOS")
    /// feedforward: the quantities, and whether they go to the drive as additive commands
    FeedforwardMode: PRINTED("vorsteuer.vorsteuerung", "P-AXIS-00223",
        data_type: "STRING, before the words UNS16", kind: Kind::Flags(FeedforwardWord::WORDS), default: &["NONE"],
        since: "words: V2.11.2034.6, V2.11.2808.03, V3.1.3065.04, V3.1.3102.00", drives: "----")
    /// feedforward of the acceleration: numerator of its time constant; with ADD_ACC of a plain weight
    VsAFaktor: FACTOR("vorsteuer.vs_a_faktor", "P-AXIS-00225", unit: "us, with ADD_ACC: 1", dimension: "T: us; R, S: us")
    /// feedforward of the acceleration: denominator; 0 takes the term away
    VsANenner: FACTOR("vorsteuer.vs_a_nenner", "P-AXIS-00226")
    /// weight of the whole feedforward: numerator; 0.7 to 1 is usual, above 1 the axis leads
    VsVFaktor: FACTOR("vorsteuer.vs_v_faktor", "P-AXIS-00228")
    /// weight of the whole feedforward: denominator; 0 takes all of it away
    VsVNenner: FACTOR("vorsteuer.vs_v_nenner", "P-AXIS-00229")
    /// feedforward is active despite G137
    DefaultActive: SWITCH("vorsteuer.default_active", "P-AXIS-00255")
    /// feedforward is inactive despite G135, and despite P-AXIS-00255
    GlobalDisable: SWITCH("vorsteuer.global_disable", "P-AXIS-00256")
    /// feedforward of the jerk: numerator of its factor
    JerkFactNum: PRINTED("vorsteuer.jerk_fact_num", "P-AXIS-00337",
        data_type: "UNS32", kind: integer(0, u32::MAX), default: &["1"], drives: "----")
    /// feedforward of the jerk: denominator of its factor; 0 is corrected to 100 (110473)
    JerkFactDenom: PRINTED("vorsteuer.jerk_fact_denom", "P-AXIS-00338",
        data_type: "UNS32", kind: UNSIGNED, default: &["100"], drives: "----")
    /// delay of the additive velocity against the position, below six cycles; outside it is corrected to 0 (70349)
    VelocityDelayTime: PRINTED("vorsteuer.velocity_delay_time", "P-AXIS-00389",
        data_type: "UNS16", kind: DELAY, unit: "us", default: &["0"],
        printed: "0 <= velocity_delay_time < 6 interpolator cycles; in an example: at most one cycle",
        drives: "SERCOS, PROFIdrive, CANopen", dimension: "T: us; R, S: us")
    /// delay of the additive torque of ADD_ACC against the position, below six cycles; outside it is corrected to 0 (70348)
    AccelerationDelayTime: PRINTED("vorsteuer.acceleration_delay_time", "P-AXIS-00390",
        data_type: "UNS16", kind: DELAY, unit: "us", default: &["0"],
        printed: "0 < acceleration_delay_time < 6 interpolator cycles, which excludes the default; in an example: at most one cycle",
        drives: "SERCOS, Lightbus, PROFIdrive, CANopen", dimension: "T: us; R, S: us")
    /// delay of the additive torque of ADD_JERK against the position, below six cycles; outside it is corrected to 0 (70348)
    JerkDelayTime: SHARED("vorsteuer.jerk_delay_time", "P-AXIS-00547", kind: DELAY, unit: "us", default: &["0"])
    /// feedforward without the delay of a cycle; with VEL alone, else it is the error 110624
    FeedforwardWithoutDelay: SWITCH("vorsteuer.feedforward_without_delay", "P-AXIS-00566")
    /// PROFIdrive: cycles by which the feedforward leads the position
    ShiftTime: PRINTED("vorsteuer.shift_time", "P-AXIS-00165",
        data_type: "UNS16", kind: integer(0, 4), unit: "cycles", default: &["3"], drives: "PROFIdrive",
        dimension: "T: number of interpolation cycles; R, S: number of interpolation cycles")
    /// additive torque: numerator of the value at which the motor has its nominal torque
    TorqueScaleNum: PRINTED("antr.torque_scale_num", "P-AXIS-00325",
        data_type: "UNS32", kind: WEIGHT, unit: "increments", default: &["1"], drives: "SERCOS, Lightbus, CANopen")
    /// additive torque: denominator; 0 takes the additive torque away (110465)
    TorqueScaleDenom: PRINTED("antr.torque_scale_denom", "P-AXIS-00326",
        data_type: "UNS32", kind: WEIGHT, default: &["1"],
        printed: "1 < torque_scale_denom < MAX(UNS32), which excludes the default", drives: "SERCOS, Lightbus, CANopen")
    /// additive torque: nominal torque or force of the motor, from its data sheet; 0 takes the additive torque away
    AccReferenceValue: PRINTED("antr.acc_reference_value", "P-AXIS-00392",
        data_type: "REAL64", kind: POSITIVE, unit: "Nm, linear motor: N", default: &["1"], drives: "SERCOS, CANopen",
        dimension: "T: N; R, S: Nm")
    /// weight of the velocity feedforward that the drive itself has (SERCOS S-0-0296, CANopen 3062h)
    FeedForwardVWeighting: SHARED("antr.feed_forward_v_weighting", "P-AXIS-00833",
        kind: integer(0, 1200), unit: "0.1 %", default: &["0"], since: "V3.1.3125.0", drives: "SERCOS, CANopen")
    /// predecessor of P-AXIS-00833, which adopts it
    ChangeFeedForwardVWeighting: PRINTED("antr.sai_op_mode_change.feed_forward_v_weighting", "P-AXIS-00766",
        data_type: "UNS16", kind: integer(0, 1200), unit: "0.1 %", default: &["0"], drives: "SERCOS, CANopen",
        axes: "S", dimension: "S: 0.1 %")
    /// spindle: velocity above which M3 and M4 lead to velocity control; at 0 at every velocity
    VVelocityControlOn: PRINTED("antr.sai_op_mode_change.v_velocity_control_on", "P-AXIS-00767",
        data_type: "SGN32", kind: SIGNED, unit: "0.001 deg/s", default: &["200000000"], since: "V3.1.3079.13",
        drives: "SERCOS, CANopen", axes: "S", dimension: "S: 0.001 deg/s")
    /// spindle: velocity to which it brakes before position control is taken up again
    VPositionControlOn: PRINTED("antr.sai_op_mode_change.v_position_control_on", "P-AXIS-00768",
        data_type: "SGN32", kind: SIGNED, unit: "0.001 deg/s", default: &["0"], since: "V3.1.3079.13",
        drives: "SERCOS, CANopen", axes: "S", dimension: "S: 0.001 deg/s")
    /// predecessor of P-AXIS-00767, which adopts it
    VelocityPositionControlOn: SHARED("antr.velocity_position_control_on", "P-AXIS-00265",
        kind: SIGNED, unit: "0.001 deg/s", default: &["200000000"])
    /// predecessor of P-AXIS-00768, which adopts it
    VelocityPositionControlOff: SHARED("antr.velocity_position_control_off", "P-AXIS-00266",
        kind: SIGNED, unit: "0.001 deg/s", default: &["0"])
    /// spindle with a SERCOS drive: operation mode of velocity control; the main mode is that of position control
    OpModeForVelocityControl: PRINTED("antr.sercos.op_mode_for_velocity_control", "P-AXIS-00264",
        data_type: "UNS16", kind: integer(0, 3), default: &["0"],
        numbers: &[
            "main mode, S-0-0032", "auxiliary mode 1, S-0-0033", "auxiliary mode 2, S-0-0034",
            "auxiliary mode 3, S-0-0035",
        ],
        drives: "SERCOS", axes: "S", dimension: "")
    /// CANopen: operation mode (6060h) of position control; 8 is the cyclic synchronous position mode
    CyclicPositionOpMode: PRINTED("antr.canopen.cyclic_position_op_mode", "P-AXIS-00463",
        data_type: "SGN16", kind: SIGNED_16, default: &["8"], drives: "CANopen", dimension: "")
    /// CANopen: operation mode (6060h) of velocity control; 9 is the cyclic synchronous velocity mode
    CyclicVelocityOpMode: PRINTED("antr.canopen.cyclic_velocity_op_mode", "P-AXIS-00464",
        data_type: "SGN16", kind: SIGNED_16, default: &["9"], drives: "CANopen", axes: "", dimension: "")
    /// mode of improved position control at start; DRYRUN calculates and puts out nothing
    Enable: IPC("lr_param.improved_position_control.enable", "P-AXIS-00758",
        data_type: "STRING, before V3.1.3132.0 BOOLEAN", kind: Kind::Word(Enable::WORDS), default: &["OFF"],
        since: "V3.1.3077.08; words: V3.1.3132.0")
    /// largest additive velocity as a part of the largest velocity of the axis (P-AXIS-00212)
    VAddMaxFact: IPC("lr_param.improved_position_control.v_add_max_fact", "P-AXIS-00757",
        data_type: "UNS16", kind: integer(0, 2000), unit: "0.1 %", default: &["0"], dimension: "T: 0.1 %; R, S: 0.1 %")
    /// where the stage takes the vibration from: a measured velocity, the motor's velocity after a simulated
    /// oscillation, or the command velocity after a simulated oscillation
    Mode: STAGE("lr_param.improved_position_control.stage[i].mode", "P-AXIS-00753",
        data_type: "UNS32", kind: Kind::Word(StageMode::WORDS), default: &["NOT_ACTIVE"])
    /// measured velocity that a DIRECT stage takes: motor encoder or direct measuring system
    DirectSource: AXIS_KEY("lr_param.improved_position_control.stage[i].direct_source",
        indices: &[STAGES], kind: Kind::Word(DirectSource::WORDS), default: &["v_motor"])
    /// start of the input tuning_weight of the stage: the part of its weight that acts
    TuningWeight: AXIS_KEY("lr_param.improved_position_control.stage[i].tuning_weight",
        indices: &[STAGES], kind: FRACTION, default: &["1"])
    /// weight of the stage: numerator; a weight above 7 is capped
    WeightFactNum: STAGE("lr_param.improved_position_control.stage[i].weight_fact_num", "P-AXIS-00754",
        data_type: "UNS32", kind: WEIGHT, default: &["1"])
    /// weight of the stage: denominator
    WeightFactDenom: STAGE("lr_param.improved_position_control.stage[i].weight_fact_denom", "P-AXIS-00755",
        data_type: "UNS32", kind: WEIGHT, default: &["1"])
    /// damping ratio of the simulated oscillation (INDIRECT, SET_POINT); the lower, the larger the additive velocity
    OscDamping: STAGE("lr_param.improved_position_control.stage[i].osc_damping", "P-AXIS-00850",
        misprints: &["lr_param.improved_position_control.stage[i]osc_damping"], data_type: "REAL64", kind: DAMPING,
        default: &["-1"], since: IPC_FILTERS)
    /// predecessor of P-AXIS-00850
    FilterDamping: STAGE("lr_param.improved_position_control.stage[i].filter.damping", "P-AXIS-00756",
        aliases: &["lr_param.improved_position_control.stage[i].filter[k].damping"], indices: &[STAGES, 1],
        data_type: "REAL64", kind: DAMPING, default: &["-1"])
    /// type of the filter; every active stage needs a band-pass
    FilterType: FILTER("lr_param.improved_position_control.stage[i].filter[k].type", "P-AXIS-00849",
        aliases: &["lr_param.improved_position_control.stage[i].filter.type"], data_type: "STRING",
        kind: Kind::Word(FilterType::WORDS), default: &["BANDPASS", "NO_FILTER"], since: IPC_FILTERS)
    /// low-pass prototype of a band-pass; it must be given explicitly for the second filter
    FilterPrototype: FILTER("lr_param.improved_position_control.stage[i].filter[k].prototype", "P-AXIS-00848",
        aliases: &["lr_param.improved_position_control.stage[i].filter.prototype"], data_type: "STRING",
        kind: Kind::Word(Prototype::WORDS), default: &["CRIT_DAMPING"], since: IPC_FILTERS)
    /// order of a band-pass: its sections of second order, 20 dB/decade each
    FilterOrder: FILTER("lr_param.improved_position_control.stage[i].filter[k].order", "P-AXIS-00750",
        aliases: &["lr_param.improved_position_control.stage[i].filter.order"], data_type: "UNS32", kind: integer(1, 3),
        default: &["0"])
    /// centre frequency of a band-pass and of the simulated oscillation; frequency of -180 degrees of an all-pass
    FilterF0: FILTER("lr_param.improved_position_control.stage[i].filter[k].fg_f0", "P-AXIS-00751",
        aliases: &["lr_param.improved_position_control.stage[i].filter.fg_f0"], data_type: "REAL64",
        kind: Kind::Real { from: 0.0, to: 500.0, open: [true, false] }, unit: "Hz", default: &["-1"],
        dimension: "T: Hz; R, S: Hz")
    /// quality factor: centre frequency / bandwidth at -3 dB
    FilterQ: FILTER("lr_param.improved_position_control.stage[i].filter[k].q_factor", "P-AXIS-00752",
        aliases: &["lr_param.improved_position_control.stage[i].filter.q_factor"], data_type: "REAL64",
        kind: Kind::Real { from: 1.0, to: 10.0, open: [false; 2] }, default: &["-1"])
}

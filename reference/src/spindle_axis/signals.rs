//! Inputs and outputs of the block `spindle_axis`. Nothing is computed here.

use crate::ipc::STAGES;
use crate::spindle::{Job, SpindleState};
use portable::portable;

/// Declares the inputs of the block; its form with parameter sets has more of them.
macro_rules! inputs {
    ($($more:tt)*) => {
        /// Inputs. Inputs that the spindle does not use are not read.
        #[portable]
        #[derive(Clone, Copy, Debug, Default)]
        pub struct Inputs<R> {
            /// command position of the interpolator [0.001 deg]
            pub x_command: R,
            /// actual position [0.001 deg]
            pub x_actual: R,
            /// command velocity of the interpolator [0.001 deg/s]
            pub v_interpolator: R,
            /// acceleration of the interpolator [0.001 deg/s^2]
            pub a_interpolator: R,
            /// jerk of the interpolator, 0 where the profile is not jerk-limited [0.001 deg/s^3]
            pub j_interpolator: R,
            /// actual velocity, for the changeover [0.001 deg/s]
            pub v_actual: R,
            /// velocity of the motor encoder, v_ist1 [0.001 deg/s]
            pub v_motor: R,
            /// velocity of the direct measuring system, v_ist2 [0.001 deg/s]
            pub v_direct: R,
            /// with the key tunable: factor of the stage's weight, 0 to 1; outside this range the last valid value stays
            /// active, with the id 4, which is not a fault
            pub tuning_weight: [R; STAGES],
            /// with the key tunable: factor of the limit (P-AXIS-00757), 0 to 1; outside this range the last valid value
            /// stays active, with the id 4, which is not a fault
            pub tuning_limit: R,
            /// speed of a request, S word; its sign does not matter [0.001 deg/s]
            pub s_word: R,
            /// target of M19, S.POS [0.001 deg]
            pub s_position: R,
            /// request: turn in positive direction; counts when it becomes TRUE
            pub m3: bool,
            /// request: turn in negative direction; counts when it becomes TRUE
            pub m4: bool,
            /// request: stop; counts when it becomes TRUE
            pub m5: bool,
            /// request: stop at s_position, in negative direction if m4 is TRUE; counts when it becomes TRUE
            pub m19: bool,
            /// request S[PUTAX]: release the axis; counts when it becomes TRUE
            pub putax: bool,
            /// request: homing; counts when it becomes TRUE
            pub g74: bool,
            /// the interpolator has completed the job: M19, S[PUTAX] or G74
            pub job_done: bool,
            /// TRUE: the drive is on and has no fault
            pub drive_on: bool,
            /// the operation mode that the drive displays: SERCOS S-0-0135, CANopen 6061h
            pub operation_mode_display: i32,
            /// improved position control: 0 OFF, 1 ON, 2 DRYRUN; any other value is a fault; starts with the value of
            /// P-AXIS-00758
            pub mode: i32,
            /// G135: TRUE, G137: FALSE; acts at once: switch it at standstill
            pub feedforward_active: bool,
            /// weight of G136 [%], limited to 0..100
            pub feedforward_percentage: i32,
            /// CNC reset, a level: the spindle goes back to position control and stops; while TRUE nothing is added
            pub reset: bool,
            /// cycle time of the calling task [ns]; 0: unchecked; a value other than the designed cycle time is a fault
            pub task_cycle_ns: u32,
            /// with the key cycle_counter: cycle counter of the controller; 0: unchecked, in TwinCAT the counter of the task
            /// is used; skipped and doubled calls and, while the drive is on, a pause are an error that stays until reset
            pub cycle_counter: u32,
            $($more)*
        }
    };
}

pub(crate) use inputs;

inputs! {}

/// Declares the outputs of the block; its form with parameter sets has more of them.
macro_rules! outputs {
    ($($more:tt)*) => {
        /// Outputs. An output that the spindle does not have is 0.
        #[portable]
        #[derive(Clone, Copy, Debug, Default)]
        pub struct Outputs<R> {
            /// command position of the spindle, 0 <= x_spindle < 360 000 [0.001 deg]
            pub x_spindle: R,
            /// command velocity of the spindle [0.001 deg/s]
            pub v_spindle: R,
            /// speed of the job, below 0 for M4 [0.001 deg/s]
            pub job_speed: R,
            /// target of the job M19 [0.001 deg]
            pub job_position: R,
            /// output of the position controller, with feedforward if the axis has one, before v_add is added, held while a
            /// sample is missing; v_spindle where the loop is open; for monitoring, the outputs to the drive contain v_add
            /// [0.001 deg/s]
            pub v_command: R,
            /// conventional feedforward [0.001 deg/s]
            pub v_feedforward: R,
            /// additive velocity of improved position control [0.001 deg/s]
            pub v_add: R,
            /// v_add before the fade, within the limit (P-AXIS-00757); 0 in OFF [0.001 deg/s]
            pub v_add_calculated: R,
            /// position control in the drive: the position command of the drive [0.001 deg]
            pub x_drive: R,
            /// 0 POSITION, 1 TO_VELOCITY, 2 VELOCITY, 3 BRAKE, 4 TO_POSITION
            pub spindle_state: SpindleState,
            /// what the interpolator has to do: 0 STOP (M5), 1 TURN (M3, M4), 2 ORIENT (M19), 3 RELEASE (S[PUTAX]), 4 HOME
            /// (G74)
            pub job: Job,
            /// counts the jobs: a changed number means a new job
            pub job_number: u32,
            /// number of waiting requests
            pub waiting: u32,
            /// the operation mode that the drive is to take: SERCOS S-0-0134, CANopen 6060h
            pub operation_mode: i32,
            /// v_spindle less the velocity in additive_velocity, as process data of the drive: SERCOS S-0-0036, CANopen
            /// 60FFh [increments]
            pub velocity_command: i32,
            /// position control in the CNC: the velocity command of the drive (P-AXIS-00129/00128) [increments]
            pub manipulated_variable: i32,
            /// additive torque command of the drive (P-AXIS-00325/00326) [increments]
            pub additive_torque: i32,
            /// additive velocity command of the drive (P-AXIS-00205 to 00207) [increments]
            pub additive_velocity: i32,
            /// reason of the fault; of several faults, improved position control comes before feedforward, position control,
            /// changeover; 31 to 36 last one cycle, other faults of the changeover may stay until reset: 0 none
            pub error_id: u32,
            /// state POSITION, and the interpolator moves the spindle: position lag and position may be monitored
            pub loop_closed: bool,
            /// an output is at its limit, or at the end of the range of its process-data type, in this cycle
            pub limited: bool,
            /// a velocity sample of improved position control is bad and is replaced by the last good one (key ride_through)
            pub held: bool,
            /// improved position control found the loop unstable: v_add fades out and stays 0 until mode is not ON or reset
            /// is TRUE (key watch)
            pub tripped: bool,
            /// a part of the block cannot act in this cycle, or the spindle is stopped; the error id gives the reason
            pub fault: bool,
            $($more)*
        }
    };
}

pub(crate) use outputs;

outputs! {}

//! Inputs and outputs of the block `axis`. Nothing is computed here.

use crate::ipc::STAGES;
use portable::portable;

/// Declares the inputs of the block; its form with parameter sets has more of them.
macro_rules! inputs {
    ($($more:tt)*) => {
        /// Inputs. Translatory axes in um, rotary axes and spindles in 0.001 deg. Inputs that the axis does not use are not
        /// read.
        #[portable]
        #[derive(Clone, Copy, Debug, Default)]
        pub struct Inputs<R> {
            /// command position of the interpolator, on the turn of the actual position [um or 0.001 deg]
            pub x_command: R,
            /// actual position, on the same turn as x_command [um or 0.001 deg]
            pub x_actual: R,
            /// x_command - x_actual, in single precision instead of both positions: the caller subtracts in increments or in
            /// double precision [um or 0.001 deg]
            pub following_error: R,
            /// velocity of the interpolator [um/s or 0.001 deg/s]
            pub v_interpolator: R,
            /// acceleration of the interpolator [um/s^2 or 0.001 deg/s^2]
            pub a_interpolator: R,
            /// jerk of the interpolator, 0 where the profile is not jerk-limited [um/s^3 or 0.001 deg/s^3]
            pub j_interpolator: R,
            /// velocity of the motor encoder, v_ist1 [um/s or 0.001 deg/s]
            pub v_motor: R,
            /// velocity of the direct measuring system, v_ist2 [um/s or 0.001 deg/s]
            pub v_direct: R,
            /// with the key tunable: factor of the stage's weight, 0 to 1; outside this range the last valid value stays
            /// active, 0 after a cycle in which the block did not act, with the id 4, which is not a fault
            pub tuning_weight: [R; STAGES],
            /// with the key tunable: factor of the limit (P-AXIS-00757), 0 to 1; outside this range the last valid value
            /// stays active, 0 after a cycle in which the block did not act, with the id 4, which is not a fault
            pub tuning_limit: R,
            /// gantry slave: v_add of the master axis [um/s or 0.001 deg/s]
            pub v_add_master: R,
            /// improved position control: 0 OFF, 1 ON, 2 DRYRUN; any other value is a fault; starts with the value of
            /// P-AXIS-00758
            pub mode: i32,
            /// G135: TRUE, G137: FALSE; acts at once: switch it at standstill
            pub feedforward_active: bool,
            /// weight of G136 [%], limited to 0..100
            pub feedforward_percentage: i32,
            /// FALSE: the axis is not in position control: all outputs are 0 at once, and x_drive, if the drive has the
            /// position controller, follows x_command. The first cycle with TRUE acts in full, without a ramp: x_command
            /// must be at the actual position
            pub position_controlled: bool,
            /// while TRUE all outputs are 0; x_drive, if the drive has the position controller, follows x_command; hold it
            /// while positions are set (homing)
            pub reset: bool,
            /// cycle time of the calling task [ns]; 0: unchecked; a value other than the designed cycle time is a fault
            pub task_cycle_ns: u32,
            /// with the key cycle_counter: cycle counter of the controller; 0: unchecked, in TwinCAT the counter of the task
            /// is used; skipped and doubled calls are a fault; the block restarts after a pause
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
        /// Outputs. An output that the axis does not have is 0.
        #[portable]
        #[derive(Clone, Copy, Debug, Default)]
        pub struct Outputs<R> {
            /// output of the position controller, with feedforward if the axis has one, before v_add is added; for
            /// monitoring, the outputs to the drive contain v_add [um/s or 0.001 deg/s]
            pub v_command: R,
            /// conventional feedforward [um/s or 0.001 deg/s]
            pub v_feedforward: R,
            /// additive velocity of improved position control; gantry master: to be wired to v_add_master of each slave;
            /// gantry slave: that of the master, within its limit [um/s or 0.001 deg/s]
            pub v_add: R,
            /// v_add before the fade, within the limit (P-AXIS-00757); 0 in OFF; gantry slave: v_add [um/s or 0.001 deg/s]
            pub v_add_calculated: R,
            /// position control in the drive: the position command of the drive [um or 0.001 deg]
            pub x_drive: R,
            /// position control in the CNC: the velocity command of the drive (P-AXIS-00129/00128) [increments]
            pub manipulated_variable: i32,
            /// PROFIdrive: control deviation XERR, signal 25 (P-AXIS-00092) [increments]
            pub xerr: i32,
            /// additive torque command of the drive (P-AXIS-00325/00326) [increments]
            pub additive_torque: i32,
            /// additive velocity command of the drive (P-AXIS-00205 to 00207) [increments]
            pub additive_velocity: i32,
            /// reason of the fault; of several faults, improved position control comes before feedforward, position control;
            /// cycle_time, x_command and x_actual set all outputs to 0, and x_drive, if the drive has the position
            /// controller, follows x_command or holds its last valid one; the others stop the part that reads the input: 0 none
            pub error_id: u32,
            /// an output is at its limit, or at the end of the range of its process-data type, in this cycle
            pub limited: bool,
            /// a velocity sample of improved position control is bad and is replaced by the last good one (key ride_through)
            pub held: bool,
            /// improved position control found the loop unstable: v_add fades out and stays 0 until mode is not ON or reset
            /// is TRUE (key watch)
            pub tripped: bool,
            /// a part of the block cannot act in this cycle; the error id gives the reason
            pub fault: bool,
            $($more)*
        }
    };
}

pub(crate) use outputs;

outputs! {}

//! What goes into the block `axis` and what comes out. Nothing is computed here.

use crate::ipc::STAGES;
use portable::portable;

/// Inputs. Translatory axes in um, rotary axes and spindles in 0.001 deg. What the axis does not use may stay as it is.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<R> {
    /// command position of the interpolator, on the same turn as x_actual [um or 0.001 deg]
    pub x_command: R,
    /// actual position, on the same turn as x_command [um or 0.001 deg]
    pub x_actual: R,
    /// x_command - x_actual in the place of both, in single precision: subtracted by the caller in increments or in double precision [um or 0.001 deg]
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
    /// with the key tunable: part of each stage's weight that acts, 0 to 1; anything else is held and told by error_id, and is no fault
    pub tuning_weight: [R; STAGES],
    /// with the key tunable: part of the limit (P-AXIS-00757) that holds, 0 to 1; anything else is held and told by error_id, and is no fault
    pub tuning_limit: R,
    /// on a gantry slave: v_add of its master [um/s or 0.001 deg/s]
    pub v_add_master: R,
    /// improved position control: 0 OFF, 1 ON, 2 DRYRUN; any other value is a fault (P-AXIS-00758)
    pub mode: i32,
    /// G135: TRUE, G137: FALSE; acts at once: switch it at standstill
    pub feedforward_active: bool,
    /// weight of G136 [%], limited to 0..100
    pub feedforward_percentage: i32,
    /// FALSE: the axis is not in position control, all outputs are 0 at once; x_drive, if the drive has the controller, follows x_command. It acts in full in the next cycle: x_command stands on x_actual then
    pub position_controlled: bool,
    /// while TRUE the same
    pub reset: bool,
    /// the caller's cycle [ns], 0: unchecked; another value than designed for is a fault
    pub task_cycle_ns: u32,
    /// with the key cycle_counter: the controller's cycles, counted; 0: unchecked, in TwinCAT those of the task; skipped and doubled calls are a fault, and after a pause everything starts anew
    pub cycle_counter: u32,
}

/// Outputs. What the axis does not have is 0.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Outputs<R> {
    /// output of the position controller with feedforward, before v_add is added [um/s or 0.001 deg/s]
    pub v_command: R,
    /// conventional feedforward [um/s or 0.001 deg/s]
    pub v_feedforward: R,
    /// additive velocity of improved position control; gantry slaves get it as v_add_master [um/s or 0.001 deg/s]
    pub v_add: R,
    /// the same after the limit (P-AXIS-00757) and before the fade; 0 in OFF [um/s or 0.001 deg/s]
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
    /// of several parts the last one's; cycle_time, x_command and x_actual stop the axis, the others the part that reads them: 0 none
    pub error_id: u32,
    /// the limit of v_add or a process-data type cuts an output off in this cycle
    pub limited: bool,
    /// a velocity that improved position control reads is bad, the last good one stands in its place (key ride_through)
    pub held: bool,
    /// improved position control found the loop unstable: v_add fades out and stays 0 until mode is not ON, or reset (key watch)
    pub tripped: bool,
    /// a part of the block cannot act in this cycle, the id says why
    pub fault: bool,
}

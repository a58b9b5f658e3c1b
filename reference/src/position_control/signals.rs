//! Inputs and outputs of the block `position_control`. Nothing is computed here.

use portable::portable;

/// Inputs. Translatory axes in um, rotary axes and spindles in 0.001 deg.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<R> {
    /// command position of the interpolator, on the same turn as x_actual [um or 0.001 deg]
    pub x_command: R,
    /// actual position, on the same turn as x_command [um or 0.001 deg]
    pub x_actual: R,
    /// x_command - x_actual, in single precision instead of both positions: the caller subtracts in increments or in double
    /// precision [um or 0.001 deg]
    pub following_error: R,
    /// conventional feedforward [um/s or 0.001 deg/s]
    pub v_feedforward: R,
    /// additive feedforward, before it is scaled [um/s or 0.001 deg/s]
    pub v_additive: R,
    /// additive torque of the feedforward [increments]
    pub torque_feedforward: i32,
    /// additive velocity of improved position control [um/s or 0.001 deg/s]
    pub v_add: R,
    /// FALSE: the axis is not in position control: all outputs are 0 at once, and x_drive, if the drive has the position
    /// controller, follows x_command. The first cycle with TRUE acts in full, without a ramp: x_command must be at x_actual
    pub position_controlled: bool,
    /// while TRUE all outputs are 0; x_drive, if the drive has the position controller, follows x_command; hold it while
    /// positions are set (homing)
    pub reset: bool,
    /// cycle time of the calling task [ns]; 0: unchecked; a value other than the designed cycle time is a fault
    pub task_cycle_ns: u32,
    /// with the key cycle_counter: cycle counter of the controller; 0: unchecked, in TwinCAT the counter of the task is used;
    /// skipped and doubled calls are a fault; the block restarts after a pause
    pub cycle_counter: u32,
}

/// Outputs. An output that the axis does not have is 0.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Outputs<R> {
    /// output of the position controller with feedforward, before v_add is added: v_command of improved position control [um/s
    /// or 0.001 deg/s]
    pub v_command: R,
    /// position control in the drive: the position command of the drive [um or 0.001 deg]
    pub x_drive: R,
    /// position control in the CNC: the velocity command of the drive (P-AXIS-00129/00128) [increments]
    pub manipulated_variable: i32,
    /// PROFIdrive: control deviation XERR, signal 25 (P-AXIS-00092) [increments]
    pub xerr: i32,
    /// additive velocity command of the drive (P-AXIS-00205 to 00207) [increments]
    pub additive_velocity: i32,
    /// additive torque command of the drive (P-AXIS-00325/00326) [increments]
    pub additive_torque: i32,
    /// an output is limited to the range of its process-data type in this cycle
    pub limited: bool,
    /// the block cannot act in this cycle; the error id gives the reason
    pub fault: bool,
    /// reason of the fault, which stops the block: 0 none
    pub error_id: u32,
}

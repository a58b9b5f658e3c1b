//! What goes into the block `position_control` and what comes out. Nothing is computed here.

use portable::portable;

/// Inputs. Translatory axes in um, rotary axes and spindles in 0.001 deg.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<R> {
    /// command position of the interpolator, on the same turn as x_actual [um or 0.001 deg]
    pub x_command: R,
    /// actual position, on the same turn as x_command [um or 0.001 deg]
    pub x_actual: R,
    /// x_command - x_actual in the place of both, in single precision: subtracted by the caller in increments or in double precision [um or 0.001 deg]
    pub following_error: R,
    /// conventional feedforward [um/s or 0.001 deg/s]
    pub v_feedforward: R,
    /// additive feedforward, before it is scaled [um/s or 0.001 deg/s]
    pub v_additive: R,
    /// additive torque of the feedforward [increments]
    pub torque_feedforward: i32,
    /// additive velocity of improved position control [um/s or 0.001 deg/s]
    pub v_add: R,
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
    /// output of the position controller with feedforward, before v_add is added: v_command of improved position control [um/s or 0.001 deg/s]
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
    /// a process-data type cuts an output off in this cycle
    pub limited: bool,
    /// the block cannot act in this cycle, the id says why
    pub fault: bool,
    /// each stops the block: 0 none
    pub error_id: u32,
}

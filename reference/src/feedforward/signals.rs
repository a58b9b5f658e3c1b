//! Inputs and outputs of the block `feedforward`. Nothing is computed here.

use portable::portable;

/// Inputs. Translatory axes in um, rotary axes and spindles in 0.001 deg.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<R> {
    /// velocity of the interpolator [um/s or 0.001 deg/s]
    pub v_interpolator: R,
    /// acceleration of the interpolator [um/s^2 or 0.001 deg/s^2]
    pub a_interpolator: R,
    /// jerk of the interpolator, 0 where the profile is not jerk-limited [um/s^3 or 0.001 deg/s^3]
    pub j_interpolator: R,
    /// G135: TRUE, G137: FALSE; acts at once: switch it at standstill
    pub feedforward_active: bool,
    /// weight of G136 [%], limited to 0..100
    pub feedforward_percentage: i32,
    /// FALSE: the axis is not in position control: all outputs are 0 at once
    pub position_controlled: bool,
    /// while TRUE all outputs are 0; the first cycle after it fills the delays with the present sample
    pub reset: bool,
    /// cycle time of the calling task [ns]; 0: unchecked; a value other than the designed cycle time is a fault
    pub task_cycle_ns: u32,
    /// with the key cycle_counter: cycle counter of the controller; 0: unchecked, in TwinCAT the counter of the task is used;
    /// skipped and doubled calls are a fault; the block restarts after a pause
    pub cycle_counter: u32,
}

/// Outputs.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Outputs<R> {
    /// conventional feedforward, to be added to the position controller's output [um/s or 0.001 deg/s]
    pub v_feedforward: R,
    /// additive feedforward, weighted and delayed, before it is scaled (P-AXIS-00389) [um/s or 0.001 deg/s]
    pub v_additive: R,
    /// v_additive as process data of the drive (P-AXIS-00205 to 00207) [increments]
    pub additive_velocity: i32,
    /// additive torque or force as process data of the drive (P-AXIS-00325/00326, 00390 to 00392) [increments]
    pub additive_torque: i32,
    /// additive_velocity is limited to the range of its process-data type in this cycle
    pub velocity_limited: bool,
    /// additive_torque is limited to the range of its process-data type in this cycle
    pub torque_limited: bool,
    /// the block cannot act in this cycle; the error id gives the reason
    pub fault: bool,
    /// 0 none
    pub error_id: u32,
}

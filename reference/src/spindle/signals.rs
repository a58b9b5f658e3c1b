//! Inputs and outputs of the block `spindle`. Nothing is computed here.

use super::request::Job;
use super::state::SpindleState;
use portable::portable;

/// Inputs.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Inputs<R> {
    /// command position of the interpolator [0.001 deg]
    pub x_command: R,
    /// command velocity of the interpolator [0.001 deg/s]
    pub v_interpolator: R,
    /// actual position [0.001 deg]
    pub x_actual: R,
    /// actual velocity [0.001 deg/s]
    pub v_actual: R,
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
    /// G135: TRUE, G137: FALSE
    pub feedforward_active: bool,
    /// weight of G136 [%], limited to 0..100
    pub feedforward_percentage: i32,
    /// CNC reset, a level: the spindle goes back to position control and stops
    pub reset: bool,
    /// cycle time of the calling task [ns]; 0: unchecked; a value other than the designed cycle time is a fault
    pub task_cycle_ns: u32,
    /// with the key cycle_counter: cycle counter of the controller; 0: unchecked, in TwinCAT the counter of the task
    /// is used; skipped and doubled calls and, while the drive is on, a pause are an error that stays until reset
    pub cycle_counter: u32,
}

/// Outputs.
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
    /// 0 POSITION, 1 TO_VELOCITY, 2 VELOCITY, 3 BRAKE, 4 TO_POSITION
    pub spindle_state: SpindleState,
    /// what the interpolator has to do: 0 STOP (M5), 1 TURN (M3, M4), 2 ORIENT (M19), 3 RELEASE (S[PUTAX]), 4 HOME (G74)
    pub job: Job,
    /// counts the jobs: a changed number means a new job
    pub job_number: u32,
    /// number of waiting requests
    pub waiting: u32,
    /// the operation mode that the drive is to take: SERCOS S-0-0134, CANopen 6060h
    pub operation_mode: i32,
    /// v_spindle as process data of the drive: SERCOS S-0-0036, CANopen 60FFh [increments]
    pub velocity_command: i32,
    /// an error of this cycle, or one that stays until reset: 0 none
    pub error_id: u32,
    /// state POSITION, and the interpolator moves the spindle: improved position control may act, position lag and
    /// position may be monitored
    pub loop_closed: bool,
    /// velocity_command is limited to the range of its process-data type in this cycle
    pub limited: bool,
    /// the block cannot act in this cycle, or the spindle is stopped; the error id gives the reason
    pub fault: bool,
}

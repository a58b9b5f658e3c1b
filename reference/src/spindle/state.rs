//! The data of the changeover: coefficients, state, the five states. No motion.

use super::request::{Before, Request};
use crate::{call_rate, process_data};
use portable::{Real, portable};

/// What controls the spindle.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpindleState {
    /// position control
    Position,
    /// velocity control is asked for
    ToVelocity,
    /// velocity control
    Velocity,
    /// velocity control, on the way to the velocity at which position control is taken up
    Brake,
    /// position control is asked for
    #[default]
    ToPosition,
}

/// Coefficients.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Coeffs<R> {
    /// cycle time that all coefficients were designed for [ns]
    pub cycle_time_ns: u32,
    /// cycle time T [s]
    pub cycle_time: R,
    /// whether the drive controls the position and the block commands its operation mode
    pub in_drive: bool,
    /// Von: M3 or M4 with a higher speed changes to velocity control [0.001 deg/s]
    pub v_velocity_control_on: R,
    /// Voff: at or below this speed the change to position control begins [0.001 deg/s]
    pub v_position_control_on: R,
    /// -Voff [0.001 deg/s]
    pub v_position_control_on_negative: R,
    /// by how much v_actual may lie outside 0 to v_spindle where position control is taken up [0.001 deg/s]
    pub window: R,
    /// Voff + window: a spindle that turns faster when the drive comes on is caught [0.001 deg/s]
    pub v_taken_up: R,
    /// whether the drive has no velocity control: a spindle that turns too fast is waited for
    pub only_position: bool,
    /// whether the drive has velocity control only: VELOCITY replaces POSITION
    pub only_velocity: bool,
    /// whether the position loop is this block's: without x_actual it misses a sample
    pub closes_loop: bool,
    /// deceleration * T: largest change of the velocity in a cycle [0.001 deg/s]
    pub v_step: R,
    /// largest velocity below 180 deg / T, up to which a drive distinguishes the direction [0.001 deg/s]
    pub v_largest: R,
    /// largest velocity of a usual cycle (fast path) of POSITION: below Von and v_largest, with the velocity command within its
    /// range [0.001 deg/s]
    pub v_usual_position: R,
    /// largest velocity of a usual cycle (fast path) of VELOCITY or BRAKE: the velocity command is within its range [0.001 deg/s]
    pub v_usual_velocity: R,
    /// lead of the position command over the actual position where position control begins [s]
    pub lead_time: R,
    /// whether the CNC's feedforward shortens that time; of a drive that controls the position, an additive velocity
    pub has_feedforward: bool,
    /// whether the feedforward is active despite G137 (P-AXIS-00255)
    pub default_active: bool,
    /// decrease of the lead per percent of the feedforward [s]
    pub lead_time_per_percent: R,
    /// largest step of the position command when the interpolator takes over, without an acceleration [0.001 deg]
    pub takeover_window: R,
    /// deceleration T^2 / 2: n cycles after the last valid sample, an accelerating interpolator is n (n + 1) times this
    /// distance further [0.001 deg]
    pub takeover_way: R,
    /// cycles within which the drive displays a new mode
    pub mode_cycles: u32,
    /// cycles within which position control begins after the drive is switched on
    pub start_cycles: u32,
    /// cycles within which the spindle has braked
    pub brake_cycles: u32,
    /// operation mode of position control
    pub position_mode: i32,
    /// operation mode of velocity control
    pub velocity_mode: i32,
    /// velocity command: increments for 0.001 deg/s
    pub velocity_scale: R,
    /// range of the velocity command
    pub velocity_range: process_data::Coeffs<R>,
    /// the rate of the calls
    pub call_rate: call_rate::Coeffs,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// state of the changeover
    pub control: SpindleState,
    /// second copy of the state of the changeover, to detect corruption
    pub control_copy: SpindleState,
    /// cycles in TO_VELOCITY, BRAKE or TO_POSITION, this one included
    pub cycles: u32,
    /// consecutive cycles in which v_actual has been settled
    pub settled: u32,
    /// consecutive cycles in which a sample has been missing
    pub missing: u32,
    /// error id that stays until reset, 0 none
    pub lasting_error: u32,
    /// what is known of a spindle that the block does not move yet
    pub seen: Seen<R>,
    /// whether a spindle that was caught waits for the drive to display velocity control
    pub catches: bool,
    /// whether velocity control is asked for
    pub asks_velocity: bool,
    /// TRUE: a reset leads back to position control
    pub returns: bool,
    /// whether the block moves the spindle: position control is taken up at x_start; else the commands follow the spindle
    pub is_moving: bool,
    /// TRUE: the interpolator must continue from the position command x
    pub takes_over: bool,
    /// the position command [0.001 deg]
    pub x: R,
    /// position at which position control is taken up [0.001 deg]
    pub x_start: R,
    /// the velocity command [0.001 deg/s]
    pub v: R,
    /// the job
    pub present: Request<R>,
    /// whether the job is a TURN faster than Von
    pub turns_fast: bool,
    /// number of jobs so far
    pub jobs: u32,
    /// number of waiting requests
    pub queued: u32,
    /// the requests that wait, the first one first
    pub request: [Request<R>; 4],
    /// the request inputs of the last cycle
    pub before: Before,
    /// code of the usual cycle (fast path) that may be next: POSITION, VELOCITY or BRAKE without any request
    pub usual: u32,
    /// the rate of the calls
    pub call_rate: call_rate::State,
}

constants! {
    /// no usual cycle (fast path) is next
    pub fn usual_none() -> u32 { 0u32 }
    /// the usual cycle (fast path) of POSITION may be next; the codes differ in several bits, so that a flipped bit is detected
    pub fn usual_position() -> u32 { 0x5555u32 }
    /// the usual cycle (fast path) of VELOCITY may be next
    pub fn usual_velocity() -> u32 { 0xAAAAu32 }
    /// the usual cycle (fast path) of BRAKE may be next
    pub fn usual_brake() -> u32 { 0x3333u32 }
}

/// The actual velocity of a spindle that the block does not move yet.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Seen<R> {
    /// consecutive cycles with a valid sample of v_actual, up to 3
    pub samples: u32,
    /// consecutive cycles in which v_actual was low enough for position control, up to 3
    pub slow: u32,
    /// v_actual of the previous cycle [0.001 deg/s]
    pub v_last: R,
    /// v_actual of the cycle before the previous one [0.001 deg/s]
    pub v_before: R,
    /// median of the last three samples of v_actual [0.001 deg/s]
    pub v: R,
}

/// The results of checks in one cycle.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct Cycle<R> {
    /// the state with which the cycle begins
    pub control: SpindleState,
    /// whether that state begins with this cycle
    pub begins: bool,
    /// whether nothing is known of the velocity of the spindle any more
    pub forgets: bool,
    /// of a sample that is needed and out of range
    pub sample_error: u32,
    /// of a sample without which the spindle coasts
    pub lacking: u32,
    /// whether the velocity command is limited by `v_turning`
    pub holds_back: bool,
    /// velocity with which the spindle turns, as far as it is known [0.001 deg/s]
    pub v_turning: R,
    /// whether the velocity command goes down to Voff
    pub brakes: bool,
    /// whether the position command is that of a drive that turns with v_spindle from where the spindle is
    pub shows: bool,
    /// whether the position command goes on with the velocity command
    pub advances: bool,
    /// whether position control is taken up in the next cycle
    pub resynchronises: bool,
    /// the state with which the next cycle begins
    pub next: SpindleState,
}

/// A state begins.
#[portable]
pub fn enter<R: Real>(state: &mut State<R>) {
    state.cycles = 0u32;
    state.settled = 0u32;
    state.missing = 0u32;
}

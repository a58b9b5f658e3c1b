//! Common to the signals of all blocks: the error ids and the largest sample in range. Nothing is computed here.
//!
//! Ids of the controller keep their numbers; ids below 100 are axgen's own.

constants! {
    /// error_id: no fault
    pub fn error_none() -> u32 { 0u32 }
    /// error_id: task_cycle_ns is not the cycle time that the coefficients were designed for
    pub fn error_cycle_time() -> u32 { 1u32 }
    /// error_id: mode is none of OFF, ON, DRYRUN
    pub fn error_mode() -> u32 { 2u32 }
    /// error_id: the block's memory was corrupted, or an input is far above P-AXIS-00212; the block restarts
    pub fn error_state() -> u32 { 3u32 }
    /// error_id: tuning_limit or a tuning_weight is outside 0 to 1; the last valid value stays active; not a fault
    pub fn error_tuning() -> u32 { 4u32 }
    /// error_id: the loop was found unstable, and v_add fades out (key watch); not a fault; stays until mode is not ON or
    /// reset is TRUE
    pub fn error_unstable() -> u32 { 5u32 }
    /// error_id: a parameter set for another block structure is refused; not a fault while a set is in use
    pub fn error_set_structure() -> u32 { 6u32 }
    /// error_id: a parameter set with an unusable number, an unstable section or too large a limit is refused
    pub fn error_set_unsound() -> u32 { 7u32 }
    /// error_id: a damaged parameter set is refused: its check word is wrong
    pub fn error_set_damaged() -> u32 { 8u32 }
    /// error_id: cycle_counter shows skipped or doubled calls (key cycle_counter)
    pub fn error_call_rate() -> u32 { 9u32 }
    /// error_id: v_command is not within the sample limit
    pub fn error_v_command() -> u32 { 11u32 }
    /// error_id: v_motor is not within the sample limit
    pub fn error_v_motor() -> u32 { 12u32 }
    /// error_id: v_direct is not within the sample limit
    pub fn error_v_direct() -> u32 { 13u32 }
    /// error_id: v_interpolator is not within the sample limit
    pub fn error_v_interpolator() -> u32 { 14u32 }
    /// error_id: a_interpolator is not within the sample limit
    pub fn error_a_interpolator() -> u32 { 15u32 }
    /// error_id: j_interpolator is not within the sample limit
    pub fn error_j_interpolator() -> u32 { 16u32 }
    /// error_id: x_command is not within the sample limit
    pub fn error_x_command() -> u32 { 17u32 }
    /// error_id: x_actual is not within the sample limit
    pub fn error_x_actual() -> u32 { 18u32 }
    /// error_id: v_feedforward is not within the sample limit
    pub fn error_v_feedforward() -> u32 { 19u32 }
    /// error_id: v_additive is not within the sample limit
    pub fn error_v_additive() -> u32 { 20u32 }
    /// error_id: v_add is not within the sample limit
    pub fn error_v_add() -> u32 { 21u32 }
    /// error_id: v_add_master is not within the sample limit
    pub fn error_v_add_master() -> u32 { 22u32 }
    /// error_id: v_actual is not within the sample limit
    pub fn error_v_actual() -> u32 { 23u32 }
    /// error_id: following_error is not within the sample limit
    pub fn error_following_error() -> u32 { 24u32 }
    /// error_id: spindle: two requests in one cycle, the one of lower priority is lost
    pub fn error_requests() -> u32 { 31u32 }
    /// error_id: spindle: M3 and M4 in one cycle, the request is lost
    pub fn error_direction() -> u32 { 32u32 }
    /// error_id: spindle: s_word is not within the sample limit, the request is lost
    pub fn error_s_word() -> u32 { 33u32 }
    /// error_id: spindle: s_position is not within the position limit, the request is lost
    pub fn error_s_position() -> u32 { 34u32 }
    /// error_id: spindle: four requests wait already, the request is lost
    pub fn error_waiting() -> u32 { 35u32 }
    /// error_id: spindle: the drive is off, the request is lost
    pub fn error_drive_off() -> u32 { 36u32 }
    /// error_id: spindle: the drive does not display velocity control within the time; stays until reset
    pub fn error_to_velocity() -> u32 { 41u32 }
    /// error_id: spindle: the spindle has not braked within the time; stays until reset
    pub fn error_brake() -> u32 { 42u32 }
    /// error_id: spindle: position control does not begin within the time; stays until reset
    pub fn error_to_position() -> u32 { 43u32 }
    /// error_id: spindle: 180 degrees a cycle or more, the drive cannot distinguish the direction; stays until reset
    pub fn error_half_turn() -> u32 { 44u32 }
    /// error_id: spindle: the drive displays another operation mode; stays from the fourth cycle on
    pub fn error_mode_display() -> u32 { 45u32 }
    /// error_id: spindle: x_command does not go on from x_spindle; stays until reset
    pub fn error_takeover() -> u32 { 46u32 }
    /// error_id: spindle: the spindle turns too fast for position control, and the drive has no velocity control to catch it:
    /// the block waits
    pub fn error_too_fast() -> u32 { 47u32 }
    /// error_id: spindle: the position lag is near half a turn, beyond which the loop would turn the other way; stays until
    /// reset
    pub fn error_lag() -> u32 { 48u32 }
    /// error_id: spindle: the drive has no position control, the request is lost
    pub fn error_only_velocity() -> u32 { 49u32 }
    /// error_id: excitation: the motor stands still or has changed its direction, v_excite fades out; not a fault; stays
    /// until the next start
    pub fn error_reversal() -> u32 { 51u32 }
    /// error_id: set design: a centre frequency is outside its range: above 0, up to 500 Hz, f0 Ts up to 0.45
    pub fn error_f0() -> u32 { 61u32 }
    /// error_id: set design: a centre frequency is below lowest_f0, which the block was generated with
    pub fn error_low_f0() -> u32 { 62u32 }
    /// error_id: set design: a quality factor is outside its range: 1 to 10
    pub fn error_q_factor() -> u32 { 63u32 }
    /// error_id: set design: a damping ratio is outside its range: above 0, below 1
    pub fn error_damping() -> u32 { 64u32 }
    /// error_id: set design: a weight is outside its range: above 0, up to 7
    pub fn error_weight() -> u32 { 65u32 }
    /// error_id: set design: the limit is outside its range: 0 to the limit of the block ipc
    pub fn error_limit() -> u32 { 66u32 }
    /// error_id: improved position control is enabled on a gantry slave, the error 70600 of the controller
    pub fn error_gantry_slave() -> u32 { 70_600u32 }
    /// largest magnitude of a sample in range, far above any real signal; NaN and infinity are out of range
    pub fn sample_limit<R: Real>() -> R { R::per_kind(1.0e15, 1.0e9) }
}

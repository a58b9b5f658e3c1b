//! The error ids of the blocks: the reaction of the block, and the remedy. One row per id; `axgen explain`, the guides for
//! PLCs and docs/error-ids.md come from this table. The cause is in the reference, at the function of the id.

use portable::{Expr, Fn, Literal};
use reference::signal;

#[derive(Clone, Copy, Debug)]
pub struct ErrorId {
    pub id: u32,
    /// the cause
    pub why: &'static str,
    /// the reaction of the block
    pub does: &'static str,
    /// the action for the reader
    pub remedy: &'static str,
}

/// A row: the function of the reference, the reaction of the block, the remedy.
type Row = (&'static Fn, &'static str, &'static str);

macro_rules! rows {
    ($($function:ident: $does:expr, $remedy:expr;)+) => {
        &[$((&signal::$function::Ir::<f64>::IR, $does, $remedy)),+]
    };
}

/// For a velocity that improved position control reads.
const NOTHING_ADDED: &str = "Improved position control adds nothing in a cycle with this fault: v_add is 0 at once. It fades in again when the sample is \
                             good. The other parts of an axis continue.";
const MEASURED: &str = "Check encoder, scaling and process data. If single telegrams are lost, the key ride_through lets the block hold samples.";
/// For a derivative that feedforward reads.
const NOTHING_FED: &str = "Feedforward outputs 0 in a cycle with this fault. Position control continues without it.";
const INTERPOLATOR: &str = "Check the link to the interpolator, and the scaling of the signal.";
/// For an input that the position controller adds.
const NO_POSITION_CONTROL: &str = "Velocities, manipulated variable and torque are 0 in a cycle with this fault, xerr is 0, and x_drive follows x_command.";
const PART: &str = "Check the connection: the signal is an output of another block.";
/// For an input of the design of a set.
const REFUSED: &str = "The design ends without a set: designed is FALSE and params is 0. Where the block has more \
                       than one stage or filter, wrong_stage and wrong_filter name the input. The set in use goes on.";
/// For a request to a spindle.
const LOST: &str =
    "The request is lost. The spindle continues as before. The error is not latched, and no reset is needed.";
/// For an error of a spindle that stays.
const STAYS: &str = "The spindle brakes with spindle.deceleration to standstill by its velocity command and stays there, with this id, until a reset. \
                     No job is served.";
/// For a sample of a spindle that may be missing for some cycles.
const COASTS: &str = "The spindle continues at its last velocity for up to three cycles. From the fourth consecutive bad cycle on, it brakes to \
                      standstill, and the id stays until a reset.";

static ROWS: &[Row] = rows! {
    error_cycle_time: "The block acts as if it were off while the cause lasts, and restarts after it. A spindle brakes to standstill, and the id \
                       stays until a reset.",
        "Call the block in a task with the cycle time that it was generated for, or generate it for this task. 0 at task_cycle_ns: unchecked.";
    error_mode: "Improved position control acts as in the mode OFF, at once: v_add is 0. The other parts of an axis go on.",
        "Write 0 (OFF), 1 (ON) or 2 (DRYRUN) to mode.";
    error_state: "v_add is 0. The block restarts in the same cycle and fades in again; a delay continues with the present sample. A block \
                  with parameter sets first checks the offered set again; until then active_set is 0. If the \
                  memory of a spindle's changeover is overwritten, the spindle brakes to standstill, and the id stays until a reset.",
        "Something else writes to the memory of the block, or an input is far above vb_max. Find the cause, because the fault can recur.";
    error_tuning: "Not a fault. The last valid value stays active. After a cycle in which the block axis \
                   or spindle_axis did not act, that value is 0.",
        "Write a number from 0 to 1 to each tuning input: the fraction follows it again.";
    error_unstable: "Not a fault. v_add fades out and stays 0 until the mode is not ON, or reset.",
        "Take a smaller weight; a smaller limit does not help. If the vibration comes from another source (chatter, a \
         program at f0), take a larger limit or remove the source. Then a reset, or the mode OFF or DRYRUN: the block is \
         ready again (docs/improved-position-control.md).";
    error_set_structure: "The offered set is refused. Not a fault while a set is in use: that set stays in use. Without a set in use, nothing is added.",
        "Make the set for the block that runs there: `axgen params-of NEW --axis X --on OLD`, with OLD as the file that the block was generated \
         from; or generate the block again (docs/parameter-sets.md).";
    error_set_unsound: "The offered set is refused. Not a fault while a set is in use: that set stays in use. Without a set in use, nothing is added.",
        "Make the set again, with a limit that is not above the one of the block, or generate the block again (docs/parameter-sets.md).";
    error_set_damaged: "The offered set is refused. Not a fault while a set is in use: that set stays in use. Without a set in use, nothing is added.",
        "The set was changed, damaged, or read while somebody wrote it: write it again, all of it between two calls of the block \
         (docs/parameter-sets.md).";
    error_call_rate: "The block acts as if it were off while the calls are irregular, and restarts after it, as after a reset. A spindle brakes to \
                      standstill, and the id stays until a reset.",
        "Call the block once in each cycle of its task, without a condition around the call. The same counter must count those cycles: 1 more in \
         each, and 0 where nothing is checked.";
    error_v_command: NOTHING_ADDED, "Check what gives v_command: the position controller with its feedforward.";
    error_v_motor: NOTHING_ADDED, MEASURED;
    error_v_direct: NOTHING_ADDED, MEASURED;
    error_v_interpolator: "Feedforward outputs 0 in a cycle with this fault. A spindle continues at its last velocity for up to three \
                           cycles. From the fourth consecutive bad cycle on, it brakes to standstill, and the id stays until a reset.", INTERPOLATOR;
    error_a_interpolator: NOTHING_FED, INTERPOLATOR;
    error_j_interpolator: NOTHING_FED, INTERPOLATOR;
    error_x_command: "Velocities, manipulated variable and torque are 0 in a cycle with this fault, and x_drive holds its last value. A spindle \
                      continues at its last velocity for up to three cycles. From the fourth consecutive bad cycle on, it brakes to \
                      standstill, and the id stays until a reset.", INTERPOLATOR;
    error_x_actual: "Velocities and manipulated variable are 0 in a cycle with this fault; x_drive follows x_command. A spindle without a \
                     position does not leave TO_POSITION at the start, nor BRAKE. One whose loop is closed in the CNC continues at its last velocity \
                     for up to three cycles. From the fourth consecutive bad cycle on, it brakes to standstill, and the id stays until \
                     a reset.",
        "Check encoder, scaling and process data.";
    error_v_feedforward: NO_POSITION_CONTROL, PART;
    error_v_additive: NO_POSITION_CONTROL, PART;
    error_v_add: NO_POSITION_CONTROL, PART;
    error_v_add_master: "0 is added in place of the master's v_add; the other parts of the axis go on.",
        "Check the connection to the master's block.";
    error_v_actual: "The spindle is not released at the start, and stays in BRAKE: without its velocity it does not count as settled. In BRAKE the \
                     time of error 42 runs.",
        "Check encoder, scaling and process data.";
    error_following_error: NO_POSITION_CONTROL, "Check what gives following_error.";
    error_requests: LOST, "Give one request a cycle. The one of higher priority was taken: G74, S[PUTAX], M19, M5, then M3 and M4.";
    error_direction: LOST, "Give M3 or M4, not both.";
    error_s_word: LOST, "Write a number to s_word before the request.";
    error_s_position: LOST, "Write a position to s_position before M19.";
    error_waiting: LOST, "Wait until `waiting` is below 4, or give a reset, which clears all waiting requests.";
    error_drive_off: LOST, "Give the request again when drive_on is TRUE.";
    error_to_velocity: STAYS, "The drive does not know the mode, or its display is not in the telegram: check the parameters of the modes and \
                               operation_mode_display. Then a reset.";
    error_brake: STAYS, "The drive does not follow velocity_command, v_actual is wrong or noisy, or spindle.window or spindle.brake_timeout is too small. \
                         Then a reset.";
    error_to_position: STAYS, "A drive that does not display the mode: as for 41. At the start: v_actual must be valid, and at most Voff and the \
                               window, in three consecutive cycles, and x_actual valid. Then a reset.";
    error_half_turn: "The spindle brakes with spindle.deceleration to standstill by its velocity command and stays there, with this id, until a reset. The \
                      block axis of a spindle without a changeover holds x_drive, for as long as the fault lasts.", "Command less than 180 degrees a cycle under position control: a lower speed, a shorter cycle, or velocity control above \
                             P-AXIS-00767. Then a reset.";
    error_mode_display: COASTS, "Something else changes the operation mode of the drive, or it has a fault: check drive_on and \
                                 operation_mode_display. Then a reset.";
    error_takeover: STAYS, "The interpolator must go on from x_spindle and v_spindle (docs/spindle.md); or spindle.takeover_window is too small. Then a reset.";
    error_too_fast: "The block waits and does not take the spindle over: its commands follow the spindle. Position control begins by itself when the \
                     spindle is slow enough.",
        "Wait until the spindle has coasted down. A drive with a mode of velocity control, and P-AXIS-00767 and 00768, would catch it.";
    error_lag: STAYS, "Take a larger Kv, a smaller P-AXIS-00767 or a lower speed of positioning: `axgen check` names them. Check the scaling of the \
                       manipulated variable and the direction of the encoder. Then a reset.";
    error_only_velocity: LOST, "M19, G74 and S[PUTAX] need a drive with position control.";
    error_reversal: "Not a fault. v_excite fades out; the id stays until the next start. Nothing starts while the motor stands still.",
        "Move in one direction, 2.5 times the amplitude or faster, from before the start until `done`. Then press the button again.";
    error_f0: REFUSED, "Type a centre frequency above 0 up to 500 Hz, with f0 times the cycle time at most 0.45.";
    error_low_f0: REFUSED, "Type a higher centre frequency, or generate the axis with a smaller lowest_f0.";
    error_q_factor: REFUSED, "Type a quality factor from 1 to 10.";
    error_damping: REFUSED, "Type a damping ratio above 0 and below 1.";
    error_weight: REFUSED, "Type a weight above 0 up to 7. Switching a stage off needs another block.";
    error_limit: REFUSED, "Type a limit from 0 to that of the block, P-AXIS-00757 times P-AXIS-00212 of the set it was generated from.";
    error_gantry_slave: "The block acts as in the mode OFF: v_add is 0.", "Leave mode OFF: the stages belong to the master (docs/gantry.md).";
};

/// All ids, in the order of the table.
pub fn all() -> impl Iterator<Item = ErrorId> {
    ROWS.iter().filter_map(|(function, does, remedy)| {
        let Some(Expr::Constant { value }) = function.body.block.value else { return None };
        let Literal::U32(id) = value() else { return None };
        Some(ErrorId { id, why: function.doc.strip_prefix("error_id: ")?, does, remedy })
    })
}

/// The page docs/error-ids.md.
pub fn page() -> String {
    let mut page = "# Error ids\n\n\
        The ids at the output `error_id`; in `twincat`, `codesys` and `scl` at `ErrorID`, or at `NoticeID` if they are not a fault. \
        `axgen explain 12` prints a row.\nThe header of each block lists the ids that it can have. Ids of the controller keep their numbers, which \
        begin at 70000; ours are below 100.\nOut of the sample limit: not within +-1e15 (single precision: +-1e9), a NaN, an infinity.\n\n\
        | id | cause | what the block does | what to do |\n| ---: | --- | --- | --- |\n"
        .to_owned();
    for ErrorId { id, why, does, remedy } in all() {
        page.push_str(&format!("| {id} | {why} | {does} | {remedy} |\n"));
    }
    page
}

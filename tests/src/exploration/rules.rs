//! What must be so in every cycle, from docs/spindle.md: modes, commands, times. Requests stand next to it; nothing is searched.

use super::drive::wrap;
use super::transitions::{By, Node, Transition};
use super::world::{Edge, is_free, is_number, is_place};
use super::{orders, transitions};
use reference::spindle::{Job, SpindleState};

/// A rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Rule {
    /// only transitions of the table
    Listed,
    /// the outputs `spindle_state` and `loop_closed` say what is
    Shown,
    /// 0 <= x_spindle < 360 000
    Range,
    /// the mode asked for belongs to the state; velocity_command is v_spindle
    Mode,
    /// VELOCITY and POSITION begin with their display, and another display is a fault
    Displayed,
    /// where the block owns v_spindle it goes towards 0 by the deceleration, and not below Voff before POSITION
    Ramp,
    /// where the block owns x_spindle it goes on by v_spindle * T
    Advance,
    /// the first position command after BRAKE is the formula's, in bits
    Formula,
    /// the first step of POSITION, and one after missing samples, is within the window around v_spindle * T
    TakeOver,
    /// without a sample three cycles are coasted in their state, and the fourth one stops
    Coasts,
    /// an error that stays begins where the page says, and nowhere else; a reset ends it
    Lasts,
    /// error_id: the error that stays, else that of a sample, else that of a request
    Errors,
    /// a state that waits ends within its time, or an error stays, and not before
    Time,
    /// BRAKE ends after three cycles with the command at Voff and v_actual within the window, and not before
    Settled,
    /// BRAKE is not left with a command above Voff
    SlowEnough,
    /// at the start position control is taken up after three cycles in which the spindle was slow enough, and a faster one is caught
    Begins,
    /// a drive changes to position control at Voff + window or below, and in the direction of the command
    Obeys,
    /// the velocity command of a spindle that the block does not move yet is not against its direction
    Forward,
    /// POSITION is left only for a TURN faster than Von at Von
    FastTurn,
    /// BRAKE begins only for a request that needs it, or a reset
    Cause,
    /// a reset and the drive that is off empty the queue and make STOP the job
    ResetClears,
    /// in the cycle of a reset POSITION is not left for TO_VELOCITY
    ResetStays,
    /// a reset in VELOCITY leads to BRAKE in the same cycle, one in TO_VELOCITY in the first cycle of VELOCITY, with all samples
    ResetBrakes,
    /// requests are counted, wait and are served as the page says
    Order,
    /// BRAKE ends a job only for a reset in this cycle or a request after the job
    JobKept,
    /// a reset, a drive and an interpolator that do their part lead to POSITION and STOP
    Returns,
    /// a drive and an interpolator that do their part lead to a state that serves, or to an error
    Settles,
}

/// The rules that a cycle breaks.
#[must_use]
pub fn broken(edge: &Edge<'_>) -> Vec<Rule> {
    let checks: [(Rule, bool); 25] = [
        (Rule::Listed, is_listed(edge)),
        (Rule::Shown, is_shown(edge)),
        (Rule::Range, (0.0..360_000.0).contains(&edge.outputs.x_spindle)),
        (Rule::Mode, is_mode_right(edge)),
        (Rule::Displayed, is_displayed(edge)),
        (Rule::Ramp, is_on_ramp(edge)),
        (Rule::Advance, advances(edge)),
        (Rule::Formula, is_by_formula(edge)),
        (Rule::TakeOver, is_taken_over(edge)),
        (Rule::Coasts, coasts(edge)),
        (Rule::Lasts, edge.after.block.lasting_error == lasting(edge)),
        (Rule::Errors, is_error_right(edge)),
        (Rule::Time, is_in_time(edge)),
        (Rule::Settled, is_settled(edge)),
        (Rule::SlowEnough, !passes(edge, Node::Brake, Node::ToPosition) || !is_above_off(edge)),
        (Rule::Begins, begins_slowly(edge)),
        (Rule::Obeys, obeys_slowly(edge)),
        (Rule::Forward, goes_forward(edge)),
        (Rule::FastTurn, is_fast_turn(edge)),
        (Rule::Cause, has_cause(edge)),
        (
            Rule::ResetClears,
            !(edge.inputs.reset || edge.is_off) || edge.outputs.waiting == 0 && edge.outputs.job == Job::Stop,
        ),
        (Rule::ResetStays, !edge.inputs.reset || !passes(edge, Node::Position, Node::ToVelocity)),
        (Rule::ResetBrakes, brakes_for_reset(edge)),
        (Rule::Order, orders::are_as_stated(edge)),
        (Rule::JobKept, orders::is_job_kept(edge)),
    ];
    checks.into_iter().filter(|(_, is_kept)| !is_kept).map(|(rule, _)| rule).collect()
}

fn passes(edge: &Edge<'_>, from: Node, to: Node) -> bool {
    edge.transitions.iter().flatten().any(|one| one.from == from && one.to == to)
}

fn is_above_off(edge: &Edge<'_>) -> bool {
    edge.outputs.v_spindle.abs() > edge.coeffs.v_position_control_on
}

fn is_listed(edge: &Edge<'_>) -> bool {
    let listed = transitions::possible(edge.coeffs.in_drive);
    edge.transitions.iter().flatten().all(|one| listed.contains(one))
}

fn is_shown(edge: &Edge<'_>) -> bool {
    let o = &edge.outputs;
    let state = match edge.inside {
        Node::Off | Node::OffStopped | Node::ToPosition => SpindleState::ToPosition,
        Node::Position => SpindleState::Position,
        Node::ToVelocity => SpindleState::ToVelocity,
        Node::Velocity => SpindleState::Velocity,
        Node::Brake => SpindleState::Brake,
        Node::Stopped if edge.before.is_idle => SpindleState::ToPosition,
        Node::Stopped if edge.inputs.reset && edge.before.block.lasting_error != 0 => SpindleState::Brake,
        Node::Stopped => edge.before.block.control,
    };
    let is_moved = edge.inside == Node::Position && edge.missing() == 0 && !is_stopping(edge);
    o.spindle_state == state && o.loop_closed == is_moved
}

fn is_mode_right(edge: &Edge<'_>) -> bool {
    let (o, coeffs) = (&edge.outputs, edge.coeffs);
    if !coeffs.in_drive {
        return o.operation_mode == 0 && o.velocity_command == 0 && !o.limited;
    }
    let taken_up = coeffs.v_position_control_on + coeffs.window;
    let is_velocity = match edge.inside {
        _ if edge.looks() && !is_place(edge.inputs.x_actual) => true,
        _ if edge.is_off => edge.turning() != Some(0.0),
        _ if edge.looks() => edge.turning().is_none_or(|v| v.abs() > taken_up),
        Node::Off | Node::OffStopped | Node::Position | Node::ToPosition => false,
        Node::ToVelocity | Node::Velocity => true,
        Node::Brake | Node::Stopped => edge.before.block.asks_velocity,
    };
    let mode = if is_velocity { coeffs.velocity_mode } else { coeffs.position_mode };
    let command = f64::from(o.velocity_command) / coeffs.velocity_scale;
    o.operation_mode == mode && command == o.v_spindle && !o.limited
}

fn is_displayed(edge: &Edge<'_>) -> bool {
    let (display, o) = (edge.inputs.operation_mode_display, &edge.outputs);
    if !edge.coeffs.in_drive {
        return true;
    }
    let is_velocity = display == edge.coeffs.velocity_mode;
    let is_position = display == edge.coeffs.position_mode;
    let may_enter = is_velocity && o.operation_mode == edge.coeffs.velocity_mode;
    (!passes(edge, Node::ToVelocity, Node::Velocity) || may_enter)
        && (!passes(edge, Node::ToPosition, Node::Position) || is_position)
        && (edge.inside != Node::Velocity || is_velocity || o.fault)
        && (edge.inside != Node::Position || is_position || o.fault)
}

/// Whether an error that stays began in this cycle, or stays.
fn is_stopping(edge: &Edge<'_>) -> bool {
    !edge.is_off && edge.after.block.lasting_error != 0
}

fn is_on_ramp(edge: &Edge<'_>) -> bool {
    let (old, new, coeffs) = (edge.before.block.v, edge.outputs.v_spindle, edge.coeffs);
    let down = |from: f64, end: f64| from.abs().min((from.abs() - coeffs.v_step).max(end)).copysign(from);
    let slower = |end: f64| down(old, end);
    let turning = edge.turning().unwrap_or(old);
    match edge.inside {
        _ if edge.is_off && edge.turning().is_none() => new == slower(0.0),
        _ if edge.is_off => new == slower(0.0).clamp(turning.min(0.0), turning.max(0.0)),
        _ if edge.is_seized() => new == turning,
        _ if edge.is_start() && is_stopping(edge) => new == down(turning, 0.0),
        _ if edge.is_start() => new == turning,
        _ if is_stopping(edge) => new == slower(0.0),
        Node::Brake => new == slower(coeffs.v_position_control_on),
        Node::ToPosition => new == old,
        Node::Position | Node::ToVelocity | Node::Velocity if edge.missing() != 0 => new == old,
        Node::Position | Node::ToVelocity | Node::Velocity => new == edge.inputs.v_interpolator,
        _ => false,
    }
}

fn advances(edge: &Edge<'_>) -> bool {
    let (old, o, i, coeffs) = (edge.before.block.x, &edge.outputs, &edge.inputs, edge.coeffs);
    let (is_found, on) = (is_place(i.x_actual), wrap(old + o.v_spindle * coeffs.cycle_time));
    let accompanied = wrap(i.x_actual + o.v_spindle * (coeffs.lead_time - coeffs.cycle_time));
    let shows_other = coeffs.in_drive && !coeffs.only_velocity && i.operation_mode_display != coeffs.position_mode;
    let is_late = is_stopping(edge) && shows_other;
    match edge.inside {
        _ if edge.is_off && !is_found => o.x_spindle == old,
        _ if is_found && (edge.is_off || edge.is_seized() || edge.is_start() || is_late) => o.x_spindle == accompanied,
        _ if edge.is_seized() || edge.is_start() || is_stopping(edge) => o.x_spindle == on,
        Node::ToPosition if edge.before.x_start.is_some() => true,
        Node::Position | Node::ToVelocity if edge.missing() == 0 => o.x_spindle == wrap(i.x_command),
        Node::Velocity if edge.missing() == 0 && is_found => o.x_spindle == wrap(i.x_actual),
        _ => o.x_spindle == on,
    }
}

fn is_by_formula(edge: &Edge<'_>) -> bool {
    let is_next = edge.inside == Node::ToPosition;
    edge.before.x_start.is_none_or(|x| !is_next || edge.outputs.x_spindle.to_bits() == wrap(x).to_bits())
}

/// How far x_spindle is from where it would be by v_spindle * T, the shortest way.
fn step(edge: &Edge<'_>, x: f64) -> f64 {
    let old = &edge.before.block;
    (wrap(x - (old.x + old.v * edge.coeffs.cycle_time) + 180_000.0) - 180_000.0).abs()
}

fn is_taken_over(edge: &Edge<'_>) -> bool {
    let follows = matches!(edge.inside, Node::Position | Node::ToVelocity);
    let is_first = edge.before.takes_over && follows && !is_stopping(edge);
    !is_first || step(edge, edge.outputs.x_spindle) <= edge.coeffs.takeover_window
}

/// The cycles without a sample, with this one, and what the spindle does in it.
fn coasts(edge: &Edge<'_>) -> bool {
    let is_fourth = edge.before.missing == 3;
    let then = if is_fourth { Node::Stopped } else { edge.inside };
    edge.missing() == 0 || edge.before.missing < 4 && edge.after.node == then
}

/// Position control at the start, and what is caught there.
fn begins_slowly(edge: &Edge<'_>) -> bool {
    let begins = edge.is_start() && edge.after.node == Node::Position;
    let is_caught = edge.is_start() && edge.after.node == Node::Brake;
    (!begins || edge.may_begin()) && is_caught == edge.is_too_fast()
}

fn obeys_slowly(edge: &Edge<'_>) -> bool {
    let is_asked = edge.before.node == Node::ToPosition || edge.before.is_idle;
    let changes = is_asked && edge.before.drive.velocity_control.mode && !edge.after.drive.velocity_control.mode;
    let (end, v) = (edge.coeffs.v_position_control_on + edge.coeffs.window, edge.before.drive.velocity.v);
    let is_along = v * edge.before.block.v >= 0.0 || v.abs() <= edge.coeffs.window;
    !changes || v.abs() <= end && is_along
}

fn goes_forward(edge: &Edge<'_>) -> bool {
    !edge.looks() || edge.turning().is_none_or(|v| v * edge.outputs.v_spindle >= 0.0)
}

/// Whether BRAKE may be left.
fn may_leave_brake(edge: &Edge<'_>) -> bool {
    edge.settled() >= 3 && is_place(edge.inputs.x_actual)
}

/// Whether TO_VELOCITY or TO_POSITION is answered.
fn is_answered(edge: &Edge<'_>) -> bool {
    let coeffs = edge.coeffs;
    let mode = if edge.inside == Node::ToVelocity { coeffs.velocity_mode } else { coeffs.position_mode };
    let can_start = !edge.is_start() || edge.may_begin();
    can_start && (!coeffs.in_drive || edge.inputs.operation_mode_display == mode)
}

/// Whether a spindle that was caught waits for the drive to display velocity control.
fn is_unanswered(edge: &Edge<'_>) -> bool {
    let coeffs = edge.coeffs;
    edge.before.is_caught && coeffs.in_drive && edge.inputs.operation_mode_display != coeffs.velocity_mode
}

/// The error that stays after this cycle, else 0.
fn lasting(edge: &Edge<'_>) -> u32 {
    let (coeffs, i) = (edge.coeffs, &edge.inputs);
    let is_half_turn = coeffs.in_drive && i.v_interpolator.abs() * coeffs.cycle_time >= 180_000.0;
    let is_jump = edge.before.takes_over && step(edge, i.x_command) > coeffs.takeover_window;
    let old = if i.reset { 0 } else { edge.before.block.lasting_error };
    match edge.inside {
        _ if old != 0 => old,
        _ if i.task_cycle_ns != coeffs.cycle_time_ns => 1,
        _ if edge.missing() != 0 && edge.before.missing < 3 => 0,
        _ if edge.missing() != 0 => edge.missing(),
        Node::Position | Node::ToVelocity if is_half_turn => 44,
        Node::Position | Node::ToVelocity if is_jump => 46,
        Node::ToVelocity if !is_answered(edge) && edge.cycles() > coeffs.mode_cycles => 41,
        Node::Brake if !may_leave_brake(edge) && is_unanswered(edge) && edge.cycles() > coeffs.mode_cycles => 41,
        Node::Brake if !may_leave_brake(edge) && edge.cycles() > coeffs.brake_cycles => 42,
        Node::ToPosition if edge.is_start() && (edge.moves() || edge.is_too_fast()) => 0,
        Node::ToPosition if edge.is_start() && !is_answered(edge) && edge.cycles() > coeffs.mode_cycles + 2 => 43,
        Node::ToPosition if edge.is_start() => 0,
        Node::ToPosition if !is_answered(edge) && edge.cycles() > coeffs.mode_cycles => 43,
        _ => 0,
    }
}

fn is_error_right(edge: &Edge<'_>) -> bool {
    let (i, o) = (&edge.inputs, &edge.outputs);
    let sample = match edge.inside {
        Node::Off | Node::OffStopped if !is_place(i.x_actual) => 18,
        Node::ToPosition if edge.is_start() && !is_number(i.v_actual) => 23,
        Node::ToPosition if edge.is_start() && !is_place(i.x_actual) => 18,
        Node::Brake if !is_number(i.v_actual) => 23,
        Node::Brake if edge.settled() >= 3 && !is_place(i.x_actual) => 18,
        _ => edge.missing(),
    };
    let errors = [lasting(edge), sample, orders::counted(edge).1];
    let first = errors.into_iter().find(|id| *id != 0).unwrap_or(0);
    o.error_id == first && o.fault == (first != 0)
}

fn is_in_time(edge: &Edge<'_>) -> bool {
    let time = match edge.inside {
        Node::ToPosition if edge.is_start() => edge.coeffs.mode_cycles + 2,
        Node::ToVelocity | Node::ToPosition => edge.coeffs.mode_cycles,
        Node::Brake if is_unanswered(edge) => edge.coeffs.mode_cycles,
        Node::Brake => edge.coeffs.brake_cycles,
        _ => return true,
    };
    let is_over = edge.cycles() > time;
    let may_stay = edge.missing() != 0 || edge.moves();
    let is_left = edge.after.node != edge.inside;
    let is_timeout = |one: &Transition| matches!(one.by, By::Error(41..=43));
    let is_early = !is_over && edge.transitions.iter().flatten().any(is_timeout);
    (!is_over || is_left || may_stay) && !is_early
}

fn is_settled(edge: &Edge<'_>) -> bool {
    let leaves = edge.after.node == Node::ToPosition;
    edge.inside != Node::Brake || leaves == may_leave_brake(edge)
}

fn is_fast_turn(edge: &Edge<'_>) -> bool {
    let (job, on) = (&edge.before.block.present, edge.coeffs.v_velocity_control_on);
    let is_fast = job.kind == Job::Turn && job.speed.abs() > on && edge.outputs.v_spindle.abs() >= on;
    let is_blind = edge.missing() != 0;
    let has_to = edge.inside == Node::Position && is_fast && !edge.inputs.reset && !is_blind && !is_stopping(edge);
    let leaves = passes(edge, Node::Position, Node::ToVelocity);
    (!leaves || is_fast) && (!has_to || leaves)
}

fn has_cause(edge: &Edge<'_>) -> bool {
    let entered = edge.transitions.iter().flatten().find(|one| (one.from, one.to) == (Node::Velocity, Node::Brake));
    let block = &edge.after.block;
    let needs_it = block.queued > 0 && !is_free(block.request[0].kind);
    entered.is_none_or(|one| one.by == By::Reset || needs_it)
}

fn brakes_for_reset(edge: &Edge<'_>) -> bool {
    let was_reset = edge.inputs.reset || edge.before.was_reset;
    let is_velocity = edge.inside == Node::Velocity && edge.before.node == Node::Velocity;
    let is_blind = edge.missing() != 0;
    !(was_reset && is_velocity) || edge.after.node == Node::Brake || is_stopping(edge) || is_blind
}

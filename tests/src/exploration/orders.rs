//! What must become of requests and jobs in every cycle, from docs/spindle.md, (2) to (4) and (7). No motion.

use super::transitions::Node;
use super::world::{Edge, is_free};
use reference::spindle::{Inputs, Job, Request};

/// Which request counts in this cycle, and the error of what is refused.
fn counted(edge: &Edge<'_>) -> (Option<Request<f64>>, u32) {
    let (i, held) = (&edge.inputs, &edge.before.block.before);
    let m19 = i.m19 && !held.m19;
    let turn = !m19 && (i.m3 && !held.m3 || i.m4 && !held.m4);
    // In the order of their priority.
    let asked = [
        (i.g74 && !held.g74, Job::Home),
        (i.putax && !held.putax, Job::Release),
        (m19, Job::Position),
        (i.m5 && !held.m5, Job::Stop),
        (turn, Job::Turn),
    ];
    let mut asked = asked.into_iter().filter(|(is_asked, _)| *is_asked && !i.reset).map(|(_, job)| job);
    let Some(kind) = asked.next() else { return (None, 0) };
    let (is_turn, is_position) = (kind == Job::Turn, kind == Job::Position);
    let error = match () {
        () if (is_turn || is_position) && i.m3 && i.m4 => 32,
        () if (is_turn || is_position) && !is_speed(i) => 33,
        () if is_position && (i.s_position.is_nan() || i.s_position.abs() > 7e14) => 34,
        () if waiting(edge) == 4 => 35,
        () => 0,
    };
    if error != 0 {
        return (None, error);
    }
    let speed = if i.m4 { -i.s_word.abs() } else { i.s_word.abs() };
    let speed = if is_turn || is_position { speed } else { 0.0 };
    let position = if is_position { i.s_position } else { 0.0 };
    (Some(Request { kind, speed, position }), if asked.next().is_some() { 31 } else { 0 })
}

fn is_speed(inputs: &Inputs<f64>) -> bool {
    inputs.s_word.abs() <= 1e15
}

/// How many wait when the request of this cycle is looked at.
fn waiting(edge: &Edge<'_>) -> u32 {
    edge.before.block.queued
}

fn is_same(a: &Request<f64>, b: &Request<f64>) -> bool {
    (a.kind, a.speed, a.position) == (b.kind, b.speed, b.position)
}

/// Whether the queue and the job of the next cycle, and what is put out of them, are as stated.
pub fn are_as_stated(edge: &Edge<'_>) -> bool {
    let (old, new, o) = (&edge.before.block, &edge.after.block, &edge.outputs);
    let (request, error) = counted(edge);
    let mut queue: Vec<_> = old.request[..old.queued as usize].iter().copied().chain(request).collect();
    let mut job = old.present;
    let mut begun = 0;
    if edge.inputs.reset {
        queue.clear();
    }
    let is_stopped = edge.is_off || edge.inputs.reset || new.lasting_error != 0 || edge.after.node == Node::Brake;
    let can_serve = match (edge.after.node, queue.first()) {
        (Node::Position, Some(_)) => true,
        // BRAKE follows at once. Whether a TURN that is begun here is lost there is looked at by another rule.
        (Node::Velocity, Some(_)) if edge.after.was_reset => (new.queued as usize) < queue.len(),
        (Node::Velocity, Some(first)) => is_free(first.kind),
        _ => false,
    };
    if is_stopped {
        begun = u32::from(job.kind != Job::Stop);
        if job.kind != Job::Stop {
            job = Request::default();
        }
    } else if can_serve && (is_free(job.kind) || edge.inputs.job_done) {
        job = queue.remove(0);
        begun = 1;
    }
    let waits = &new.request[..new.queued as usize];
    let is_shown = (o.job, o.job_speed, o.job_position) == (job.kind, job.speed, job.position)
        && o.waiting == new.queued
        && o.job_number == old.jobs + begun;
    // One id a cycle: an error that stays, of a sample or of the cycle time comes before that of a request.
    let is_refused = error == 0 || o.error_id == error || matches!(o.error_id, 1 | 14 | 17 | 18 | 23 | 41..=46);
    let is_invented = matches!(o.error_id, 31..=35) && o.error_id != error;
    let is_queue = waits.len() == queue.len() && waits.iter().zip(&queue).all(|(a, b)| is_same(a, b));
    is_queue && is_same(&new.present, &job) && is_shown && is_refused && !is_invented
}

/// Whether BRAKE ends a job only for a reset in this cycle, or a request behind it: what was asked for behind an older reset
/// is not lost.
pub fn is_job_kept(edge: &Edge<'_>) -> bool {
    let (old, new) = (&edge.before.block, &edge.after.block);
    let is_followed = new.queued > 0 && !is_free(new.request[0].kind);
    let begins = edge.inside == Node::Velocity && edge.after.node == Node::Brake;
    !begins || edge.inputs.reset || is_followed || old.present.kind == Job::Stop
}

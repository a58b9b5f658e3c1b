//! What must become of requests and jobs in every cycle, from docs/spindle.md, (1) to (4) and (7). No motion.

use super::transitions::Node;
use super::world::{Edge, is_free, is_number, is_place};
use reference::spindle::{Job, Request};

/// The request that counts in this cycle and is not refused, and the error of the others.
#[must_use]
pub fn counted(edge: &Edge<'_>) -> (Option<Request<f64>>, u32) {
    let (i, [m3, m4, m5, m19, putax, g74]) = (&edge.inputs, edge.before.held);
    let is_orient = i.m19 && !m19;
    let is_turn = !is_orient && (i.m3 && !m3 || i.m4 && !m4);
    // In the order of their priority.
    let asked = [
        (i.g74 && !g74, Job::Home),
        (i.putax && !putax, Job::Release),
        (is_orient, Job::Orient),
        (i.m5 && !m5, Job::Stop),
        (is_turn, Job::Turn),
    ];
    let mut asked = asked.into_iter().filter(|(is_asked, _)| *is_asked && !i.reset).map(|(_, job)| job);
    let Some(kind) = asked.next() else { return (None, 0) };
    let has_speed = matches!(kind, Job::Turn | Job::Orient);
    let error = match () {
        () if has_speed && i.m3 && i.m4 => 32,
        () if has_speed && !is_number(i.s_word) => 33,
        () if kind == Job::Orient && !is_place(i.s_position) => 34,
        () if !i.drive_on => 36,
        () if edge.before.block.queued == 4 => 35,
        () => 0,
    };
    if error != 0 {
        return (None, error);
    }
    let speed = if i.m4 { -i.s_word.abs() } else { i.s_word.abs() };
    let speed = if has_speed { speed } else { 0.0 };
    let position = if kind == Job::Orient { i.s_position } else { 0.0 };
    (Some(Request { kind, speed, position }), if asked.next().is_some() { 31 } else { 0 })
}

fn is_same(a: &Request<f64>, b: &Request<f64>) -> bool {
    (a.kind, a.speed, a.position) == (b.kind, b.speed, b.position)
}

/// Whether the queue and the job of the next cycle, and what is put out of them, are as stated.
pub fn are_as_stated(edge: &Edge<'_>) -> bool {
    let (old, new, o) = (&edge.before.block, &edge.after.block, &edge.outputs);
    let (request, _) = counted(edge);
    let mut queue: Vec<_> = old.request[..old.queued as usize].iter().copied().chain(request).collect();
    let mut job = old.present;
    let mut begun = 0;
    if edge.inputs.reset || edge.is_off {
        queue.clear();
    }
    let is_stopped = edge.is_off || edge.inputs.reset || new.lasting_error != 0 || edge.after.node == Node::Brake;
    let can_serve = match (edge.after.node, queue.first()) {
        (Node::Position, Some(_)) => true,
        (Node::Velocity, Some(first)) => is_free(first.kind) && !edge.after.was_reset,
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
    let is_queue = waits.len() == queue.len() && waits.iter().zip(&queue).all(|(a, b)| is_same(a, b));
    is_queue && is_same(&new.present, &job) && is_shown
}

/// Whether BRAKE ends a job only for a reset in this cycle, or a request after it: what was asked for after an older reset
/// is not lost.
pub fn is_job_kept(edge: &Edge<'_>) -> bool {
    let (old, new) = (&edge.before.block, &edge.after.block);
    let is_followed = new.queued > 0 && !is_free(new.request[0].kind);
    let begins = edge.inside == Node::Velocity && edge.after.node == Node::Brake;
    !begins || edge.inputs.reset || is_followed || old.present.kind == Job::Stop
}

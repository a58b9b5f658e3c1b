//! A cycle of the block: what is wrong, how the spindle moves, what is next. Angles and requests have files of their own.

use super::motion::{Motion, is_position, is_velocity, near, slower, velocity_command, wrap};
use super::requests::{Kind, Request, Requests};
use super::start::{Samples, ahead, lead_time};
use super::{BRAKE, Inputs, Outputs, POSITION, Parameters, TO_POSITION, TO_VELOCITY, VELOCITY};
use std::collections::VecDeque;

/// Cycles in a row that BRAKE asks for.
const SETTLED: u64 = 3;
/// The cycle without a sample, of those in a row, that is one too many.
const TOO_MANY: u64 = 4;

/// An entry of the log: a state begins.
#[derive(Clone, Copy, Debug)]
struct Entry {
    state: i32,
    /// its first cycle
    since: u64,
    /// the position of that cycle, if the block chose it; none of TO_POSITION: the block does not move the spindle yet
    origin: Option<f64>,
}

/// The block's memory: a log and numbers of cycles.
#[derive(Clone, Debug)]
pub struct Model {
    p: Parameters,
    /// number of the cycle
    now: u64,
    requests: Requests,
    job: Request,
    jobs: u32,
    /// the present state at the end
    log: VecDeque<Entry>,
    /// the error that stays
    stays: Option<u32>,
    x: f64,
    v: f64,
    mode: i32,
    /// the last cycle with a reset
    reset_at: u64,
    /// the last cycle of BRAKE that was not settled
    unsettled_at: u64,
    /// the last cycle in which the spindle followed the interpolator's position
    followed_at: u64,
    /// the last cycle that missed no sample
    complete_at: u64,
    /// of a spindle that the block does not move yet
    samples: Samples,
    /// a spindle was caught, and the drive has not displayed velocity control since
    is_caught: bool,
}

impl Model {
    /// Before the first cycle.
    #[must_use]
    pub fn new(p: &Parameters) -> Self {
        Self {
            p: p.clone(),
            now: 0,
            requests: Requests::default(),
            job: Request::STOP,
            jobs: 0,
            log: VecDeque::from([Entry { state: TO_POSITION, since: 1, origin: None }]),
            stays: None,
            x: 0.0,
            v: 0.0,
            mode: p.position_mode,
            reset_at: 0,
            unsettled_at: 0,
            followed_at: 0,
            complete_at: 0,
            samples: Samples::default(),
            is_caught: false,
        }
    }

    /// One cycle.
    pub fn cycle(&mut self, inputs: &Inputs) -> Outputs {
        self.now += 1;
        let refused = self.requests.take(inputs, self.p.only_velocity).err();
        self.prepare(inputs);
        let is_off = !inputs.drive_on;
        // With the drive off the state is the start, also with an error that stays.
        let has_state = is_off || self.stays.is_none();
        let Entry { state, since, .. } = self.current();
        // An error has outlasted the drive that was off.
        let seizes = !has_state && self.is_at_start() && since == self.now;
        let is_accompanied = !is_off && self.is_at_start() && (has_state || seizes);
        if is_accompanied {
            self.accompany(inputs);
        }
        let sample = if has_state { self.sample(inputs) } else { None };
        let is_missing = sample.is_some() && matches!(state, POSITION | TO_VELOCITY | VELOCITY);
        if !is_missing {
            self.complete_at = self.now;
        }
        let mut next = None;
        if has_state && !is_off {
            self.ask_for_mode(inputs);
            next = if sample.is_none() { self.next(inputs) } else { None };
            self.stays = if is_missing {
                sample.filter(|_| self.now - self.complete_at >= TOO_MANY)
            } else {
                self.test(inputs).or_else(|| self.overdue(next, sample, inputs.reset))
            };
        }
        let motion = match (self.stays, is_missing) {
            _ if seizes => Motion { v: self.v, x: self.with_spindle(self.v, inputs) },
            (Some(_), _) if !is_off => {
                let (v, follows) = (slower(self.v, 0.0, self.step()), self.displays(inputs, self.p.position_mode));
                Motion { v, x: self.with_spindle(v, inputs).filter(|_| is_accompanied || !follows) }
            }
            (_, true) => Motion { v: self.v, x: None },
            _ if is_off => self.followed(inputs),
            _ => self.moved(inputs),
        };
        self.x = motion.position(self.x, &self.p);
        self.v = motion.v;
        if is_off {
            // The next cycle is the first one, if the drive is on in it.
            self.enter(TO_POSITION, self.now + 1, None);
        } else if seizes {
            self.is_caught = self.mode == self.p.velocity_mode;
            self.enter(TO_POSITION, self.now, Some(self.x));
        } else if let Some(next) = next.filter(|_| self.stays.is_none()) {
            let is_caught = self.is_caught || next == BRAKE && self.is_at_start();
            self.is_caught = is_caught && next != TO_POSITION;
            let origin = (next == TO_POSITION).then(|| self.resynchronised(inputs));
            self.enter(next, self.now + 1, origin);
        } else if sample == Some(47) {
            // It is waited for as long as it takes.
            self.enter(TO_POSITION, self.now + 1, None);
        }
        self.employ(inputs);
        let is_closed = state == POSITION && !is_missing && self.stays.is_none();
        self.outputs(state, is_closed, self.stays.or(sample).or(refused).unwrap_or(0))
    }

    fn outputs(&self, spindle_state: i32, loop_closed: bool, error_id: u32) -> Outputs {
        let p = &self.p;
        let (velocity_command, limited) = if p.in_cnc { (0, false) } else { velocity_command(p, self.v) };
        Outputs {
            spindle_state,
            loop_closed,
            x_spindle: self.x,
            v_spindle: self.v,
            operation_mode: if p.in_cnc { 0 } else { self.mode },
            velocity_command,
            job: self.job.kind as i32,
            job_number: self.jobs,
            job_speed: self.job.speed,
            job_position: self.job.target,
            waiting: u32::try_from(self.requests.waiting.len()).expect("a few"),
            limited,
            fault: error_id != 0,
            error_id,
        }
    }

    /// What acts before the state: a reset, a wrong cycle, a drive that is off.
    fn prepare(&mut self, inputs: &Inputs) {
        if inputs.reset {
            self.requests.waiting.clear();
            self.reset_at = self.now;
            if self.stays.take().is_some() && inputs.drive_on {
                if self.is_at_start() {
                    self.samples.forget();
                    self.enter(TO_POSITION, self.now, None);
                } else {
                    self.enter(BRAKE, self.now, None);
                }
            }
        }
        if inputs.task_cycle_ns != 0 && inputs.task_cycle_ns != self.p.cycle_ns {
            self.stays.get_or_insert(1);
        }
        if !inputs.drive_on {
            self.requests.waiting.clear();
            if !self.is_at_start() {
                self.samples.forget();
            }
            self.is_caught = false;
            self.enter(TO_POSITION, self.now, None);
        }
    }

    /// The drive is on, and the block does not move the spindle yet: its commands go with the spindle.
    fn accompany(&mut self, inputs: &Inputs) {
        let is_known = self.samples.take(inputs.v_actual);
        if let Some(v) = self.samples.velocity(&self.p).filter(|_| is_known) {
            self.v = v;
        }
        self.holds_if(is_known && is_position(inputs.x_actual) && self.v.abs() <= self.p.v_off + self.p.window);
    }

    /// The drive is off: the velocity goes down, and is not beyond the spindle's.
    fn followed(&mut self, inputs: &Inputs) -> Motion {
        let mut v = slower(self.v, 0.0, self.step());
        let is_known = self.samples.take(inputs.v_actual);
        let turning = self.samples.velocity(&self.p).filter(|_| is_known);
        if let Some(turning) = turning {
            v = v.clamp(turning.min(0.0), turning.max(0.0));
        }
        self.holds_if(turning == Some(0.0) && is_position(inputs.x_actual));
        Motion { v, x: self.with_spindle(v, inputs).or(Some(self.x)) }
    }

    /// The position that a drive with position control turns to at a velocity, from where the spindle is.
    fn with_spindle(&self, v: f64, inputs: &Inputs) -> Option<f64> {
        is_position(inputs.x_actual).then(|| ahead(inputs.x_actual, v, lead_time(&self.p, inputs) - self.p.cycle))
    }

    /// The mode at the start: position control only of what is known to stand where it is, or to be slow enough.
    fn holds_if(&mut self, is_safe: bool) {
        self.mode = if is_safe || self.p.only_position { self.p.position_mode } else { self.p.velocity_mode };
    }

    /// Where position control is taken up in the next cycle.
    fn resynchronised(&self, inputs: &Inputs) -> f64 {
        let from = if is_position(inputs.x_actual) { inputs.x_actual } else { self.x };
        ahead(from, self.v, lead_time(&self.p, inputs))
    }

    fn step(&self) -> f64 {
        self.p.deceleration * self.p.cycle
    }

    /// Whether the block does not move the spindle yet.
    fn is_at_start(&self) -> bool {
        let Entry { state, origin, .. } = self.current();
        state == TO_POSITION && origin.is_none()
    }

    /// The error of a sample that the state needs and does not have: the state does not change then.
    fn sample(&mut self, inputs: &Inputs) -> Option<u32> {
        let Entry { state, .. } = self.current();
        let is_start = self.is_at_start();
        let p = &self.p;
        let follows = matches!(state, POSITION | TO_VELOCITY);
        let is_elsewhere = match state {
            POSITION => !self.displays(inputs, p.position_mode),
            VELOCITY => !self.displays(inputs, p.velocity_mode),
            _ => false,
        };
        // The velocity that is put out is the one of the cycle before; no number is not slow.
        let along = if self.v < 0.0 { -inputs.v_actual } else { inputs.v_actual };
        let is_slow = self.v.abs() <= p.v_off && (-p.window..=self.v.abs() + p.window).contains(&along);
        if state == BRAKE && !is_slow {
            self.unsettled_at = self.now;
        }
        let needs_velocity = state == BRAKE || is_start && inputs.drive_on;
        let needs_position = (is_start || self.is_settled()) && !p.only_velocity;
        let must_wait = is_start && p.only_position && inputs.drive_on && self.samples.is_fast(p);
        let missing = [
            ((follows || state == VELOCITY) && !is_velocity(inputs.v_interpolator), 14),
            (follows && !is_position(inputs.x_command), 17),
            (follows && p.closes_loop && !is_position(inputs.x_actual), 18),
            (is_elsewhere, 45),
            (needs_velocity && !is_velocity(inputs.v_actual), 23),
            (needs_position && !is_position(inputs.x_actual), 18),
            (must_wait, 47),
        ];
        missing.into_iter().find_map(|(is_missing, id)| is_missing.then_some(id))
    }

    /// Half a turn, and the take-over: where the spindle has not followed the interpolator in the cycle before.
    fn test(&self, inputs: &Inputs) -> Option<u32> {
        let Entry { state, since, .. } = self.current();
        let follows = matches!(state, POSITION | TO_VELOCITY);
        let steps_too_far = follows && !self.p.in_cnc && inputs.v_interpolator.abs() * self.p.cycle >= 180_000.0;
        let takes_over = follows && self.followed_at + 1 < self.now;
        let step = near(wrap(inputs.x_command) - (self.x + self.v * self.p.cycle));
        // The interpolator may have accelerated in each cycle that it has not been followed, and in this one: 1 + 2 + ... + n.
        let n = (self.now - since.max(self.followed_at + 1) + 1) as f64;
        let further = self.p.takeover_way * n * (n + 1.0);
        let jumps = takes_over && step.abs() > self.p.takeover_window + further;
        if steps_too_far { Some(44) } else { jumps.then_some(46) }
    }

    /// The time of the state is over. That of a spindle that is waited for does not run.
    fn overdue(&self, next: Option<i32>, sample: Option<u32>, reset: bool) -> Option<u32> {
        let Entry { state, since, .. } = self.current();
        let (mode, brake) = (self.p.mode_timeout_cycles, self.p.brake_timeout_cycles);
        // A spindle without position control, which is reset, waits at rest.
        let is_slow = !self.is_at_start() || self.samples.is_slow(&self.p);
        let rests = self.p.only_velocity && reset && sample.is_none() && is_slow;
        let is_over = |cycles: u32| next.is_none() && self.now >= since + u64::from(cycles);
        match state {
            TO_VELOCITY => is_over(mode).then_some(41),
            BRAKE if self.is_caught && is_over(mode) => Some(41),
            BRAKE => is_over(brake).then_some(42),
            TO_POSITION if rests => None,
            TO_POSITION if self.is_at_start() => (is_over(mode + 2) && sample != Some(47)).then_some(43),
            TO_POSITION => is_over(mode).then_some(43),
            _ => None,
        }
    }

    /// What the state changes to.
    fn next(&self, inputs: &Inputs) -> Option<i32> {
        match self.current().state {
            POSITION => {
                let is_fast = self.job.speed.abs() > self.p.v_on && inputs.v_interpolator.abs() >= self.p.v_on;
                (self.job.kind == Kind::Turn && is_fast && !inputs.reset).then_some(TO_VELOCITY)
            }
            TO_VELOCITY => self.displays(inputs, self.p.velocity_mode).then_some(VELOCITY),
            VELOCITY => {
                let is_asked_for = self.requests.waiting.front().is_some_and(|request| !request.kind.is_of_velocity());
                (is_asked_for || self.returns()).then_some(BRAKE)
            }
            BRAKE => self.is_settled().then_some(TO_POSITION),
            _ if self.is_at_start() && !self.samples.is_slow(&self.p) => self.samples.is_fast(&self.p).then_some(BRAKE),
            // It turns slowly, and goes on doing so.
            _ if self.is_at_start() && self.v != 0.0 => Some(TO_POSITION),
            // A spindle without position control stands still there while it is reset.
            _ if self.p.only_velocity && inputs.reset => None,
            _ => self.displays(inputs, self.p.position_mode).then_some(self.closed()),
        }
    }

    /// The outputs of the state.
    fn moved(&mut self, inputs: &Inputs) -> Motion {
        let Entry { state, since, origin } = self.current();
        let actual = is_position(inputs.x_actual).then_some(inputs.x_actual);
        match state {
            POSITION | TO_VELOCITY => {
                self.followed_at = self.now;
                Motion { v: inputs.v_interpolator, x: Some(inputs.x_command) }
            }
            VELOCITY => Motion { v: inputs.v_interpolator, x: actual },
            BRAKE => Motion { v: slower(self.v, self.p.v_off, self.step()), x: None },
            _ if origin.is_none() => Motion { v: self.v, x: self.with_spindle(self.v, inputs) },
            _ => Motion { v: self.v, x: origin.filter(|_| self.now == since) },
        }
    }

    fn ask_for_mode(&mut self, inputs: &Inputs) {
        match self.current().state {
            TO_VELOCITY => self.mode = self.p.velocity_mode,
            TO_POSITION if !self.is_at_start() => self.mode = self.p.position_mode,
            BRAKE => self.is_caught &= !self.displays(inputs, self.p.velocity_mode),
            _ => {}
        }
    }

    /// The state that a drive in the mode of TO_POSITION leads to.
    fn closed(&self) -> i32 {
        if self.p.only_velocity { VELOCITY } else { POSITION }
    }

    /// The job, once the next state is known.
    fn employ(&mut self, inputs: &Inputs) {
        let Entry { state: next, .. } = self.current();
        if !inputs.drive_on || inputs.reset || self.stays.is_some() || next == BRAKE {
            if self.job.kind != Kind::Stop {
                self.begin(Request::STOP);
            }
            return;
        }
        let may_serve = match (next, self.requests.waiting.front()) {
            (POSITION, _) => true,
            (VELOCITY, Some(request)) => request.kind.is_of_velocity() && !self.returns(),
            _ => false,
        };
        if may_serve
            && (self.job.kind.is_of_velocity() || inputs.job_done)
            && let Some(request) = self.requests.waiting.pop_front()
        {
            self.begin(request);
        }
    }

    /// Whether there was a reset since velocity control was asked for.
    fn returns(&self) -> bool {
        let begin = if self.p.only_velocity { VELOCITY } else { TO_VELOCITY };
        let away = self.log.iter().rfind(|entry| entry.state == begin);
        away.is_some_and(|entry| self.reset_at >= entry.since)
    }

    /// Settled in this cycle and in those before it, in BRAKE.
    fn is_settled(&self) -> bool {
        let Entry { state, since, .. } = self.current();
        state == BRAKE && self.now - self.unsettled_at.max(since - 1) >= SETTLED
    }

    fn displays(&self, inputs: &Inputs, mode: i32) -> bool {
        self.p.in_cnc || self.p.only_velocity || inputs.operation_mode_display == mode
    }

    fn current(&self) -> Entry {
        *self.log.back().expect("the log begins with a state")
    }

    fn enter(&mut self, state: i32, since: u64, origin: Option<f64>) {
        self.log.push_back(Entry { state, since, origin });
        if self.log.len() > 8 {
            self.log.pop_front();
        }
    }

    fn begin(&mut self, request: Request) {
        self.job = request;
        self.jobs = self.jobs.wrapping_add(1);
    }
}

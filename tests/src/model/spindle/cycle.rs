//! A cycle of the block: what is wrong, how the spindle moves, what is next. Angles and requests have files of their own.

use super::motion::{Motion, is_position, is_velocity, near, resynchronised, slower, velocity_command};
use super::requests::{Kind, Request, Requests};
use super::{BRAKE, Inputs, Outputs, POSITION, Parameters, TO_POSITION, TO_VELOCITY, VELOCITY};
use std::collections::VecDeque;

/// Cycles in a row that BRAKE asks for.
const SETTLED: u64 = 3;

/// The block's memory: a log and numbers of cycles.
#[derive(Clone, Debug)]
pub struct Model {
    p: Parameters,
    /// number of the cycle
    now: u64,
    requests: Requests,
    job: Request,
    jobs: u32,
    /// each state with its first cycle, the last one at the end
    log: VecDeque<(i32, u64)>,
    /// the error that stays
    stays: Option<u32>,
    x: f64,
    v: f64,
    mode: i32,
    /// where TO_POSITION begins; `None`: at the actual position
    resynchronised: Option<f64>,
    /// the last cycle with a reset
    reset_at: u64,
    /// the last cycle of BRAKE with an actual velocity that is too high
    fast_at: u64,
    /// the last cycle in which the spindle followed the interpolator's position
    followed_at: u64,
    /// the last cycle in which TO_POSITION had a position
    placed_at: u64,
}

/// What is wrong in a state.
enum Finding {
    Nothing,
    /// a bad sample: this cycle's
    Passing(u32),
    Stays(u32),
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
            log: VecDeque::from([(TO_POSITION, 1)]),
            stays: None,
            x: 0.0,
            v: 0.0,
            mode: p.position_mode,
            resynchronised: None,
            reset_at: 0,
            fast_at: 0,
            followed_at: 0,
            placed_at: 0,
        }
    }

    /// One cycle.
    pub fn cycle(&mut self, inputs: &Inputs) -> Outputs {
        self.now += 1;
        let is_wrong = inputs.task_cycle_ns != 0 && inputs.task_cycle_ns != self.p.cycle_ns;
        let mut told: Vec<u32> = is_wrong.then_some(1).into_iter().collect();
        told.extend(self.requests.take(inputs));
        let is_on = inputs.drive_on && !is_wrong;
        if inputs.reset {
            self.reset();
        }
        let motion = if is_on { self.run(inputs, &mut told) } else { self.be_off(inputs, &mut told) };
        self.x = motion.position(self.x, &self.p);
        self.v = motion.v;
        let (state, _) = self.current();
        if self.stays.is_none() && is_on {
            // What is told then and is no refused request is a bad sample.
            self.go_on(inputs, told.iter().any(|id| *id < 31));
        }
        self.outputs(state, self.stays.or(told.first().copied()).unwrap_or(0))
    }

    fn outputs(&self, state: i32, error_id: u32) -> Outputs {
        let p = &self.p;
        let (velocity_command, limited) = if p.in_cnc { (0, false) } else { velocity_command(p, self.v) };
        Outputs {
            state,
            loop_closed: state == POSITION && error_id == 0,
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

    fn reset(&mut self) {
        self.requests.waiting.clear();
        self.reset_at = self.now;
        self.end_job();
        // With the drive off the next lines of the cycle enter another one.
        if self.stays.take().is_some() {
            self.enter(BRAKE, self.now);
        }
    }

    fn be_off(&mut self, inputs: &Inputs, told: &mut Vec<u32>) -> Motion {
        self.enter(TO_POSITION, self.now);
        self.resynchronised = None;
        self.mode = self.p.position_mode;
        self.end_job();
        let x = if is_position(inputs.x_actual) { inputs.x_actual } else { self.x };
        told.extend((!is_position(inputs.x_actual)).then_some(18));
        // The next cycle is the first one, if the drive is on in it.
        self.enter(TO_POSITION, self.now + 1);
        Motion { v: 0.0, x: Some(x) }
    }

    /// A cycle with the drive on.
    fn run(&mut self, inputs: &Inputs, told: &mut Vec<u32>) -> Motion {
        if self.stays.is_none() {
            match self.find(inputs) {
                Finding::Nothing => {}
                Finding::Passing(id) => {
                    told.push(id);
                    self.show_mode();
                    let is_start = self.current().0 == TO_POSITION;
                    // BRAKE needs no sample to brake.
                    let v = if self.current().0 == BRAKE { self.braked() } else { self.v };
                    return Motion { v, x: is_start.then_some(self.x) };
                }
                Finding::Stays(id) => {
                    self.stays = Some(id);
                    self.end_job();
                }
            }
        }
        if self.stays.is_some() {
            return Motion { v: slower(self.v, 0.0, self.p.deceleration * self.p.cycle), x: None };
        }
        self.show_mode();
        match self.current().0 {
            POSITION | TO_VELOCITY => {
                self.followed_at = self.now;
                Motion { v: inputs.v_interpolator, x: Some(inputs.x_command) }
            }
            VELOCITY => {
                let x = is_position(inputs.x_actual).then_some(inputs.x_actual);
                Motion { v: inputs.v_interpolator, x }
            }
            BRAKE => Motion { v: self.braked(), x: None },
            _ if self.placed_at < self.current().1 => {
                self.placed_at = self.now;
                Motion { v: self.v, x: Some(self.resynchronised.take().unwrap_or(inputs.x_actual)) }
            }
            _ => Motion { v: self.v, x: None },
        }
    }

    fn braked(&self) -> f64 {
        slower(self.v, self.p.v_off, self.p.deceleration * self.p.cycle)
    }

    fn show_mode(&mut self) {
        match self.current().0 {
            TO_VELOCITY => self.mode = self.p.velocity_mode,
            TO_POSITION => self.mode = self.p.position_mode,
            _ => {}
        }
    }

    /// Samples, then the tests, then the time.
    fn find(&mut self, inputs: &Inputs) -> Finding {
        let (state, since) = self.current();
        let follows = matches!(state, POSITION | TO_VELOCITY);
        if state == BRAKE && !self.is_slow(inputs) {
            self.fast_at = self.now;
        }
        let is_settled = self.is_settled();
        let is_start = state == TO_POSITION && self.placed_at < since && self.resynchronised.is_none();
        let bad = [
            ((follows || state == VELOCITY) && !is_velocity(inputs.v_interpolator), 14),
            (follows && !is_position(inputs.x_command), 17),
            (state == BRAKE && !is_velocity(inputs.v_actual), 23),
            ((is_start || is_settled) && !is_position(inputs.x_actual), 18),
        ];
        let bad = bad.into_iter().find_map(|(is_bad, id)| is_bad.then_some(id));
        if bad.is_none()
            && let Some(id) = self.test(inputs)
        {
            return Finding::Stays(id);
        }
        let (limit, id, changes) = match state {
            TO_VELOCITY => (self.p.mode_timeout_cycles, 41, self.displays(inputs, self.p.velocity_mode)),
            BRAKE => (self.p.brake_timeout_cycles, 42, is_settled),
            TO_POSITION => (self.p.mode_timeout_cycles, 43, self.displays(inputs, self.p.position_mode)),
            _ => (0, 0, true),
        };
        let passed = self.now - since + 1;
        match bad {
            _ if passed > u64::from(limit) && (!changes || bad.is_some()) && id != 0 => Finding::Stays(id),
            Some(id) => Finding::Passing(id),
            None => Finding::Nothing,
        }
    }

    /// 44 to 46.
    fn test(&self, inputs: &Inputs) -> Option<u32> {
        let (state, since) = self.current();
        let follows = matches!(state, POSITION | TO_VELOCITY);
        let steps_too_far = follows && inputs.v_interpolator.abs() * self.p.cycle >= 180_000.0;
        let is_elsewhere = match state {
            POSITION => !self.displays(inputs, self.p.position_mode),
            VELOCITY => !self.displays(inputs, self.p.velocity_mode),
            _ => false,
        };
        let step = near(inputs.x_command - (self.x + self.v * self.p.cycle));
        let jumps = state == POSITION && self.followed_at < since && step.abs() > self.p.takeover_window;
        [(steps_too_far && !self.p.in_cnc, 44), (is_elsewhere, 45), (jumps, 46)]
            .into_iter()
            .find_map(|(is_wrong, id)| is_wrong.then_some(id))
    }

    /// The end of a cycle without an error that stays: what is next, and which job.
    fn go_on(&mut self, inputs: &Inputs, is_bad: bool) {
        if !is_bad {
            self.change(inputs);
        }
        let may_serve = match (self.current().0, self.requests.waiting.front()) {
            (POSITION, _) => true,
            (VELOCITY, Some(request)) => request.kind.is_of_velocity(),
            _ => false,
        };
        if may_serve
            && (self.job.kind.is_of_velocity() || inputs.job_done)
            && let Some(request) = self.requests.waiting.pop_front()
        {
            self.begin(request);
        }
    }

    fn change(&mut self, inputs: &Inputs) {
        let (state, since) = self.current();
        let next = match state {
            POSITION => {
                let is_fast = self.job.speed.abs() > self.p.v_on && self.v.abs() >= self.p.v_on;
                (self.job.kind == Kind::Turn && is_fast).then_some(TO_VELOCITY)
            }
            TO_VELOCITY => self.displays(inputs, self.p.velocity_mode).then_some(VELOCITY),
            VELOCITY => {
                let away = self.log.iter().rfind(|(state, _)| *state == TO_VELOCITY).map_or(since, |(_, since)| *since);
                let is_asked_for = self.requests.waiting.front().is_some_and(|request| !request.kind.is_of_velocity());
                (is_asked_for || self.reset_at >= away).then_some(BRAKE)
            }
            BRAKE => self.is_settled().then_some(TO_POSITION),
            _ => self.displays(inputs, self.p.position_mode).then_some(POSITION),
        };
        match next {
            Some(BRAKE) => self.begin(Request::STOP),
            Some(TO_POSITION) => self.resynchronised = Some(resynchronised(&self.p, inputs, self.v)),
            _ => {}
        }
        if let Some(next) = next {
            self.enter(next, self.now + 1);
        }
    }

    /// Slow in this cycle and in those before it, in BRAKE.
    fn is_settled(&self) -> bool {
        let (state, since) = self.current();
        state == BRAKE && self.now - self.fast_at.max(since - 1) >= SETTLED
    }

    fn is_slow(&self, inputs: &Inputs) -> bool {
        inputs.v_actual.abs() <= self.p.v_off + self.p.window
    }

    fn displays(&self, inputs: &Inputs, mode: i32) -> bool {
        self.p.in_cnc || inputs.operation_mode_display == mode
    }

    /// The state and its first cycle.
    fn current(&self) -> (i32, u64) {
        *self.log.back().expect("the log begins with a state")
    }

    fn enter(&mut self, state: i32, first: u64) {
        self.log.push_back((state, first));
        if self.log.len() > 8 {
            self.log.pop_front();
        }
    }

    fn begin(&mut self, request: Request) {
        self.job = request;
        self.jobs = self.jobs.wrapping_add(1);
    }

    fn end_job(&mut self) {
        if self.job.kind != Kind::Stop {
            self.begin(Request::STOP);
        }
    }
}

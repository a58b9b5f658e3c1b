//! The interpolator of a spindle: its job, as command position and velocity. It knows no NC program.

use crate::grid::{TURN, angle, rate};
use crate::profile::{Error, Limits, Mover};

/// Speed of homing [0.001 deg/s]: 50 rpm.
const HOMING: f64 = 300_000.0;

/// The outputs of the changeover in the previous cycle: state, job, commands.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    pub state: State,
    pub job: Job,
    pub job_number: f64,
    pub job_speed: f64,
    pub job_position: f64,
    pub x_spindle: f64,
    pub v_spindle: f64,
}

/// State of the changeover.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    Position,
    ToVelocity,
    Velocity,
    Brake,
    ToPosition,
}

/// The job of a spindle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Job {
    Stop,
    Turn,
    Orient,
    Release,
    Home,
}

/// The commanded state of the spindle.
#[derive(Clone, Copy, Debug)]
pub struct Commanded {
    pub x: f64,
    pub v: f64,
    /// whether the motion of the job is finished
    pub is_done: bool,
}

/// An interpolator.
pub struct Interpolator {
    limits: Limits,
    cycle: f64,
    mover: Mover,
    /// number of the job for which it moves
    job: f64,
    /// target and speed after a stop, if it has to reverse
    after_stop: Option<[f64; 2]>,
    last: Commanded,
}

impl Interpolator {
    /// At rest.
    pub fn at(limits: Limits, cycle: f64, x: f64) -> Result<Self, Error> {
        let mover = Mover::at(limits, cycle, x, 0.0)?;
        Ok(Self { limits, cycle, mover, job: 0.0, after_stop: None, last: Commanded { x, v: 0.0, is_done: false } })
    }

    /// One cycle. In BRAKE it does not move the spindle, and from TO_POSITION it continues from the outputs of the
    /// changeover. In VELOCITY only the velocity is used: the position is constant.
    pub fn next(&mut self, seen: &Seen) -> Result<Commanded, Error> {
        match seen.state {
            State::Brake => return Ok(self.last),
            State::ToPosition => {
                self.mover = Mover::at(self.limits, self.cycle, seen.x_spindle, seen.v_spindle)?;
                self.begin(seen)?;
            }
            _ if self.job.to_bits() != seen.job_number.to_bits() => self.begin(seen)?,
            _ => {}
        }
        let now = self.mover.next();
        if let Some([target, speed]) = self.after_stop.filter(|_| self.mover.is_done()) {
            self.after_stop = None;
            self.approach(target, speed)?;
        }
        let x = if seen.state == State::Velocity { self.last.x } else { angle(now.x) };
        let is_done = self.mover.is_done() && !matches!(seen.job, Job::Stop | Job::Turn);
        self.last = Commanded { x, v: rate(now.v), is_done };
        Ok(self.last)
    }

    fn begin(&mut self, seen: &Seen) -> Result<(), Error> {
        self.job = seen.job_number;
        self.after_stop = None;
        match seen.job {
            Job::Stop | Job::Release => self.mover.turn(0.0),
            Job::Turn => self.mover.turn(seen.job_speed),
            Job::Orient => self.approach(seen.job_position, seen.job_speed),
            Job::Home => self.approach(0.0, HOMING),
        }
    }

    /// Plans a motion to the next passage of an angle, in the direction of the speed, at which it can stop. To reverse the
    /// direction it stops first.
    fn approach(&mut self, target: f64, speed: f64) -> Result<(), Error> {
        let v = self.mover.now().v;
        if v * speed < 0.0 {
            self.after_stop = Some([target, speed]);
            return self.mover.turn(0.0);
        }
        let stop = self.stop(speed)?;
        let turns = if speed < 0.0 { ((stop - target) / TURN).floor() } else { ((stop - target) / TURN).ceil() };
        self.mover.go(target + turns * TURN, speed.abs())
    }

    /// The position of a stop if it brakes now; if it is faster than `speed`, it slows down to it first.
    fn stop(&self, speed: f64) -> Result<f64, Error> {
        let mut trial = self.mover.clone();
        let speeds = if trial.now().v.abs() > speed.abs() { [speed, 0.0] } else { [0.0, 0.0] };
        for speed in speeds {
            trial.turn(speed)?;
            while !trial.is_done() {
                trial.next();
            }
        }
        Ok(trial.now().x)
    }
}

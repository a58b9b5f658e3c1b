//! The machine around a spindle's block: the interpolator, and the drive with its commands. No program, no operator.

use generator::axis::{Axis, Changeover, DriveModel, Ratio, Spindle};
use machine::drive::TIME_CONSTANT;
use machine::grid::shortest;
use machine::profile::{Error, Limits};
use machine::spindle::drive::{Actual, Command, Drive, Setup};
use machine::spindle::interpolator::{Commanded, Interpolator, Job, Seen, State};

/// Time in which the acceleration is reached [s].
const JERK_TIME: f64 = 0.05;

/// The outputs of the block in the previous cycle, by name; `None` if it has no such output.
pub(crate) type Outputs<'o> = &'o dyn Fn(&str) -> Option<f64>;

/// Interpolator and drive.
pub(crate) struct Machine<'a> {
    spindle: &'a Spindle,
    limits: Limits,
    cycle: f64,
    interpolator: Interpolator,
    drive: Drive,
    /// values that arrived in this cycle, and that arrive in the next one
    pub(crate) actual: Actual,
    arriving: Actual,
}

impl<'a> Machine<'a> {
    /// The machine at rest.
    pub(crate) fn start(axis: &Axis, spindle: &'a Spindle, x: f64) -> Result<Self, Error> {
        let (cycle, acceleration) = (axis.cycle_time(), spindle.deceleration);
        let limits = Limits { velocity: axis.ipc.v_max, acceleration, jerk: acceleration / JERK_TIME };
        let (position_mode, weight) = match spindle.drive {
            Changeover::Cnc => (None, 0.0),
            Changeover::Drive { position_mode, feed_forward_v_weighting, .. } => {
                ((!spindle.only_velocity()).then_some(position_mode), f64::from(feed_forward_v_weighting) / 1000.0)
            }
        };
        let kv = f64::from(spindle.kv) / 100.0;
        let setup = Setup { cycle, delay_cycles: spindle.delay_cycles, kv, weight, position_mode };
        let (drive, actual) = Drive::at(setup, x);
        let interpolator = Interpolator::at(limits, cycle, x)?;
        Ok(Self { spindle, limits, cycle, interpolator, drive, actual, arriving: actual })
    }

    /// Its drive, for the loop of improved position control: actual values arrive cycles late, after the velocity loop.
    pub(crate) fn model(axis: &Axis, spindle: &Spindle) -> DriveModel {
        DriveModel {
            delay_cycles: Some(1.0 + f64::from(spindle.delay_cycles)),
            time_constant: Some(TIME_CONSTANT),
            response: None,
            position_gain: axis
                .drive
                .position_gain
                .or((!spindle.only_velocity()).then(|| f64::from(spindle.kv) / 100.0)),
        }
    }

    /// One cycle: actual values, then the interpolator.
    pub(crate) fn next(&mut self, seen: &Seen) -> Result<Commanded, Error> {
        self.actual = self.arriving;
        self.interpolator.next(seen)
    }

    /// The interpolator restarts at rest.
    pub(crate) fn restart(&mut self, x: f64) -> Result<(), Error> {
        self.interpolator = Interpolator::at(self.limits, self.cycle, x)?;
        Ok(())
    }

    /// One cycle of the drive. With position control in the CNC it gets a velocity, from the CNC's controller if the loop is
    /// closed: the block `spindle_axis` is that controller. `feedforward`: whether it is active, and its percentage.
    pub(crate) fn obey(&mut self, outputs: Outputs<'_>, feedforward: [f64; 2]) {
        let command = self.command(outputs, feedforward);
        self.arriving = self.drive.step(command);
    }

    /// One cycle of a drive that is off: the spindle coasts.
    pub(crate) fn coast(&mut self) {
        let Actual { x, v, mode } = self.actual;
        self.arriving = self.drive.step(Command { x, v, mode });
    }

    #[expect(clippy::cast_possible_truncation, reason = "an operation mode is an integer of 32 bits")]
    fn command(&self, outputs: Outputs<'_>, feedforward: [f64; 2]) -> Command {
        let get = |name| outputs(name).unwrap_or(0.0);
        let (x, v, mode) = (get("x_spindle"), get("v_spindle"), get("operation_mode") as i32);
        if let Changeover::Drive { .. } = self.spindle.drive {
            return Command { x, v, mode };
        }
        if let Some(v_command) = outputs("v_command") {
            return Command { x, v: v_command + get("v_add"), mode };
        }
        if get("loop_closed") == 0.0 {
            return Command { x, v, mode };
        }
        let is_active = self.spindle.default_active || feedforward[0] != 0.0;
        let weight = self.spindle.feedforward.filter(|_| is_active).map_or(0.0, Ratio::value);
        let weight = weight * feedforward[1].clamp(0.0, 100.0) / 100.0;
        let v = f64::from(self.spindle.kv) / 100.0 * shortest(x - self.actual.x) + weight * v;
        Command { x, v, mode }
    }
}

/// The outputs that the interpolator reads.
pub(crate) fn seen(outputs: Outputs<'_>) -> Seen {
    let get = |name| outputs(name).unwrap_or(0.0);
    let states = [State::Position, State::ToVelocity, State::Velocity, State::Brake];
    let jobs = [Job::Stop, Job::Turn, Job::Orient, Job::Release, Job::Home];
    let number = |name| (0_u8..).take_while(|number| f64::from(*number) < get(name)).count();
    Seen {
        state: states.get(number("spindle_state")).copied().unwrap_or(State::ToPosition),
        job: jobs.get(number("job")).copied().unwrap_or(Job::Stop),
        job_number: get("job_number"),
        job_speed: get("job_speed"),
        job_position: get("job_position"),
        x_spindle: get("x_spindle"),
        v_spindle: get("v_spindle"),
    }
}

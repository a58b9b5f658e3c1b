//! The motion of one spindle or axis: jerk-limited, from any moving start, to a speed or a position, sample by sample. Nothing of NC
//! programs, and no unit: lengths are what the caller has, times are seconds.
//!
//! The profiles are those of `rsruckig`, the fastest within the limits. It decides by absolute differences of about 1e-8, so it is
//! given velocities relative to the largest one, and positions relative to where the motion begins.

use rsruckig::prelude::{ControlInterface, InputParameter, Ruckig, RuckigResult, ThrowErrorHandler, Trajectory};
use std::fmt;

/// What no motion exceeds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// [1/s]
    pub velocity: f64,
    /// [1/s^2]
    pub acceleration: f64,
    /// [1/s^3]
    pub jerk: f64,
}

/// Where a mover is at the end of a cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sample {
    pub x: f64,
    pub v: f64,
    pub a: f64,
    /// of the time that begins here; 0 at the end
    pub j: f64,
}

/// Why there is no motion.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// a number that is not finite, a limit or a cycle time that is not above 0, a speed above the limit: its name and its value
    Number { name: &'static str, value: f64 },
    /// what the library says, if it finds no profile
    NoProfile(String),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number { name, value } => write!(f, "{name} is {value}, which is out of its range"),
            Self::NoProfile(reason) => write!(f, "no jerk-limited profile: {reason}"),
        }
    }
}

impl std::error::Error for Error {}

/// One spindle or axis that moves.
#[derive(Clone, Debug)]
pub struct Mover {
    limits: Limits,
    cycle: f64,
    now: Sample,
    plan: Option<Plan>,
}

/// A motion from one sample on.
#[derive(Clone, Debug)]
struct Plan {
    profile: Box<Trajectory<1>>,
    /// position that the profile counts from
    from: f64,
    /// where it ends: exactly, whatever the profile's last digit is
    end: Sample,
    /// cycles since its beginning
    cycles: u32,
}

impl Mover {
    /// Moves on with a speed, of which `velocity` is the limit, until there is a target. The cycle time is in s.
    pub fn at(limits: Limits, cycle: f64, x: f64, v: f64) -> Result<Self, Error> {
        for (name, value) in [
            ("the limit of the velocity", limits.velocity),
            ("the limit of the acceleration", limits.acceleration),
            ("the limit of the jerk", limits.jerk),
            ("the cycle time", cycle),
        ] {
            within(name, value, value.is_finite() && value > 0.0)?;
        }
        within("the position", x, x.is_finite())?;
        within("the velocity", v, v.abs() <= limits.velocity)?;
        Ok(Self { limits, cycle, now: Sample { x, v, a: 0.0, j: 0.0 }, plan: None })
    }

    /// The present sample.
    pub fn now(&self) -> Sample {
        self.now
    }

    /// From here to a speed, which is kept. An error leaves the motion as it is.
    pub fn turn(&mut self, v_target: f64) -> Result<(), Error> {
        within("the target velocity", v_target, v_target.abs() <= self.limits.velocity)?;
        let mut input = self.input();
        input.control_interface = ControlInterface::Velocity;
        input.target_velocity[0] = v_target / self.limits.velocity;
        self.plan(&input, |end| Sample { x: end, v: v_target, a: 0.0, j: 0.0 })
    }

    /// From here to a position, no faster than `v_max`, and to a stop there; back to it, if the way is too short to stop. From a
    /// speed above `v_max` it first slows down. An error leaves the motion as it is.
    pub fn go(&mut self, x_target: f64, v_max: f64) -> Result<(), Error> {
        within("the target position", x_target, x_target.is_finite())?;
        within("the velocity of the way", v_max, v_max > 0.0 && v_max <= self.limits.velocity)?;
        let mut input = self.input();
        input.target_position[0] = (x_target - self.now.x) / self.limits.velocity;
        input.max_velocity[0] = v_max / self.limits.velocity;
        self.plan(&input, |_| Sample { x: x_target, ..Sample::default() })
    }

    /// One cycle further.
    #[expect(clippy::should_implement_trait, reason = "a motion has no end that an iterator could have")]
    pub fn next(&mut self) -> Sample {
        let scale = self.limits.velocity;
        let Some(plan) = &mut self.plan else {
            self.now.x += self.now.v * self.cycle;
            return self.now;
        };
        plan.cycles = plan.cycles.saturating_add(1);
        let time = f64::from(plan.cycles) * self.cycle;
        let late = time - plan.profile.get_duration();
        if late >= 0.0 {
            self.now = Sample { x: plan.end.x + plan.end.v * late, ..plan.end };
            self.plan = None;
        } else {
            let relative = at(&plan.profile, time);
            self.now = Sample {
                x: plan.from + relative.x * scale,
                v: relative.v * scale,
                a: relative.a * scale,
                j: relative.j * scale,
            };
        }
        self.now
    }

    /// Whether the target is reached; without one, it is.
    pub fn is_done(&self) -> bool {
        self.plan.is_none()
    }

    /// The present sample and the limits, as the library takes them.
    fn input(&self) -> InputParameter<1> {
        let Limits { velocity, acceleration, jerk } = self.limits;
        let mut input = InputParameter::new(None);
        input.current_velocity[0] = self.now.v / velocity;
        // A sample may be above its limit by a rounding, which would be a motion of its own to the library.
        input.current_acceleration[0] = self.now.a.clamp(-acceleration, acceleration) / velocity;
        input.max_velocity[0] = 1.0;
        input.max_acceleration[0] = acceleration / velocity;
        input.max_jerk[0] = jerk / velocity;
        input
    }

    /// Finds the profile; its end is made from where the library ends, in the caller's units.
    fn plan(&mut self, input: &InputParameter<1>, end: impl Fn(f64) -> Sample) -> Result<(), Error> {
        let mut profile = Box::new(Trajectory::new(None));
        let result = Ruckig::<1, ThrowErrorHandler>::new(None, self.cycle)
            .calculate(input, &mut profile)
            .map_err(|error| Error::NoProfile(error.to_string()))?;
        let last = at(&profile, profile.get_duration());
        let finite = profile.get_duration().is_finite() && last.x.is_finite();
        if result != RuckigResult::Working || !finite {
            return Err(Error::NoProfile(format!("{result:?}")));
        }
        let from = self.now.x;
        self.plan = Some(Plan { profile, from, end: end(from + last.x * self.limits.velocity), cycles: 0 });
        Ok(())
    }
}

/// The state of a profile, in its own units.
fn at(profile: &Trajectory<1>, time: f64) -> Sample {
    let zero = || rsruckig::prelude::DataArrayOrVec::new(None, 0.0);
    let (mut x, mut v, mut a, mut j) = (zero(), zero(), zero(), zero());
    profile.at_time(time, &mut Some(&mut x), &mut Some(&mut v), &mut Some(&mut a), &mut Some(&mut j), &mut None);
    Sample { x: x[0], v: v[0], a: a[0], j: j[0] }
}

fn within(name: &'static str, value: f64, is_good: bool) -> Result<(), Error> {
    if is_good { Ok(()) } else { Err(Error::Number { name, value }) }
}

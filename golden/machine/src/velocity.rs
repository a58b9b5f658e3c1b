//! The response of an actual velocity to its command, sample by sample: the effect of inertia and velocity loop. No
//! position, no delay.

/// Kinds of responses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Follows {
    /// at once
    AtOnce,
    /// a cycle late
    Late,
    /// overshoots each change by its size for a cycle
    Beyond,
    /// limited change per cycle: a drive at its current limit
    Weak(f64),
    /// from above, except for 0: too fast by this value after each change; the excess is halved in each cycle, this number
    /// of times
    FromAbove(f64, u8),
    /// first order: in each cycle this fraction of the difference is covered
    Lagging(f64),
    /// second order: `a += k (v_command - v) - d a`, `v += a`; k, d
    Overshooting(f64, f64),
}

impl Follows {
    /// `Tc dv/dt = v_command - v` with a command that is held for a cycle; both times are in s. `AtOnce` without a time
    /// constant.
    #[must_use]
    pub fn time_constant(cycle: f64, time_constant: f64) -> Self {
        if time_constant > 0.0 { Self::Lagging(1.0 - libm::exp(-cycle / time_constant)) } else { Self::AtOnce }
    }
}

/// A velocity, and the values of the previous cycle that its response needs; all others are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity {
    /// the velocity
    pub v: f64,
    /// the command of the previous cycle
    pub before: f64,
    /// number of times that the excess has been halved
    pub halved: u8,
    /// change of the velocity in a cycle
    a: f64,
}

impl Velocity {
    /// The steady state of a constant velocity.
    #[must_use]
    pub fn of(v: f64) -> Self {
        Self { v, ..Self::default() }
    }

    /// One cycle; returns the velocity at its end.
    pub fn next(&mut self, follows: Follows, v_command: f64) -> f64 {
        let Self { v, before, halved, a } = *self;
        let after = |v: f64| Self { before: v_command, ..Self::of(v) };
        *self = match follows {
            Follows::AtOnce => Self::of(v_command),
            Follows::Late => after(before),
            Follows::Beyond => after(2.0 * v_command - before),
            Follows::Weak(most) => Self::of(v + (v_command - v).clamp(-most, most)),
            Follows::FromAbove(excess, often) => {
                let halved = if v_command - before == 0.0 { (halved + 1).min(often) } else { 0 };
                let excess = if v_command == 0.0 { 0.0 } else { excess.copysign(v_command) };
                Self { halved, ..after(v_command + excess / f64::from(1 << halved)) }
            }
            Follows::Lagging(part) => Self::of(v + part * (v_command - v)),
            Follows::Overshooting(k, d) => {
                let a = a + (k * (v_command - v) - d * a);
                Self { a, ..Self::of(v + a) }
            }
        };
        self.v
    }
}

//! Units of channels: as stated in the name of a column, or as plausible for a machine. No file.

/// The quantity of a channel.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Quantity {
    Velocity,
    Position,
    Acceleration,
}

/// A unit. Blocks take um/s, of rotary axes 0.001 deg/s: a degree of a rotary axis stands for a millimetre of another one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    pub name: &'static str,
    /// in m, m/s, m/s^2; of a rotary axis in 1000 deg, 1000 deg/s, 1000 deg/s^2
    pub size: f64,
}

/// Largest deviation of the ratio of two channels from the ratio of their units, as a factor.
const NEAR: f64 = 1.3;
/// Range of the peak velocity of a move [m/s]. The ranges for m/s, mm/s and um/s are adjacent.
const PEAK_VELOCITY: [f64; 2] = [5e-3, 5.0];
/// Ranges of the peak following error [m], and of the peak acceleration [m/s^2].
const PEAK_ERROR: [f64; 2] = [2e-5, 2e-2];
const PEAK_ACCELERATION: [f64; 2] = [0.05, 50.0];

impl Quantity {
    fn units(self) -> &'static [Unit] {
        const VELOCITY: [Unit; 10] = [
            unit("um/s", 1e-6),
            unit("mm/s", 1e-3),
            unit("m/s", 1.0),
            unit("m/min", 1.0 / 60.0),
            unit("mm/min", 1e-3 / 60.0),
            unit("0.001 deg/s", 1e-6),
            unit("deg/s", 1e-3),
            unit("deg/min", 1e-3 / 60.0),
            unit("1/min", 6e-3),
            unit("rpm", 6e-3),
        ];
        const POSITION: [Unit; 7] = [
            unit("um", 1e-6),
            unit("mm", 1e-3),
            unit("m", 1.0),
            unit("0.001 deg", 1e-6),
            unit("deg", 1e-3),
            unit("0.1 um", 1e-7),
            unit("0.0001 deg", 1e-7),
        ];
        const ACCELERATION: [Unit; 4] =
            [unit("mm/s^2", 1e-3), unit("m/s^2", 1.0), unit("g", 9.80665), unit("deg/s^2", 1e-3)];
        match self {
            Self::Velocity => &VELOCITY,
            Self::Position => &POSITION,
            Self::Acceleration => &ACCELERATION,
        }
    }

    /// The names of all units.
    pub(super) fn names(self) -> String {
        self.units().iter().map(|unit| unit.name).collect::<Vec<_>>().join(", ")
    }

    /// The units that can be inferred from the numbers alone: neighbours differ by a factor of 1000.
    fn by_numbers(self) -> impl Iterator<Item = Unit> {
        self.units()
            .iter()
            .copied()
            .filter(|unit| !unit.name.ends_with("/min") && !["g", "0.1 um"].contains(&unit.name) && !unit.is_rotary())
    }
}

const fn unit(name: &'static str, size: f64) -> Unit {
    Unit { name, size }
}

impl Unit {
    /// The unit in a name.
    pub(super) fn named(quantity: Quantity, name: &str) -> Option<Self> {
        const SPELLINGS: [(&str, &str); 15] = [
            (" ", ""),
            (",", "."),
            ("\u{b5}", "u"),
            ("\u{3bc}", "u"),
            ("\u{b2}", "^2"),
            ("s2", "s^2"),
            ("\u{b0}", "deg"),
            ("degrees", "deg"),
            ("degree", "deg"),
            ("10^-", "10-"),
            ("1e-", "10-"),
            ("1E-", "10-"),
            ("10-4", "0.0001"),
            ("10-3", "0.001"),
            ("10-1", "0.1"),
        ];
        let plain = SPELLINGS.iter().fold(name.to_owned(), |name, (is, stands_for)| name.replace(is, stands_for));
        quantity.units().iter().find(|unit| unit.name.replace(' ', "") == plain).copied()
    }

    pub(crate) fn is_rotary(self) -> bool {
        self.name.contains("deg") || matches!(self.name, "1/min" | "rpm")
    }

    /// The unit of a rotary axis that corresponds to a translatory one; `None` if there is no such unit.
    pub(super) fn rotary(self) -> Option<Self> {
        let name = match self.name {
            "um/s" => "0.001 deg/s",
            "mm/s" => "deg/s",
            "um" => "0.001 deg",
            "0.1 um" => "0.0001 deg",
            "mm" => "deg",
            "mm/s^2" => "deg/s^2",
            _ => return None,
        };
        Some(Self { name, ..self })
    }

    pub(super) fn of_velocity(peak: f64) -> Option<Self> {
        plausible(Quantity::Velocity, peak, PEAK_VELOCITY)
    }

    /// The unit of a following error, from its peak.
    pub(super) fn of_error(peak: f64) -> Option<Self> {
        plausible(Quantity::Position, peak, PEAK_ERROR)
    }

    /// The unit of an acceleration, from its peak.
    pub(super) fn of_acceleration(peak: f64) -> Option<Self> {
        plausible(Quantity::Acceleration, peak, PEAK_ACCELERATION)
    }

    /// The unit of a position, from its change per second divided by a velocity with a known unit.
    pub(super) fn of_position(slope: f64, velocity: Self) -> Option<Self> {
        let size = velocity.size / slope;
        Quantity::Position.by_numbers().find(|unit| is_near(size / unit.size))
    }
}

/// Whether a ratio is almost 1.
pub(super) fn is_near(ratio: f64) -> bool {
    (1.0 / NEAR..=NEAR).contains(&ratio)
}

fn plausible(quantity: Quantity, peak: f64, [from, below]: [f64; 2]) -> Option<Unit> {
    quantity.by_numbers().find(|unit| (from..below).contains(&(peak * unit.size)))
}

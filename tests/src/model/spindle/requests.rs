//! Requests: which input of a cycle counts, which is refused, and those that wait. What a request does is not known here.

use super::Inputs;
use super::motion::{is_position, is_velocity};
use std::collections::VecDeque;

/// What the interpolator has to do, with the numbers of the output `job`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Stop = 0,
    Turn = 1,
    Position = 2,
    Release = 3,
    Home = 4,
}

impl Kind {
    /// Over at any time, and served in VELOCITY.
    #[must_use]
    pub fn is_of_velocity(self) -> bool {
        matches!(self, Self::Stop | Self::Turn)
    }
}

/// What waits, or is the job.
#[derive(Clone, Copy, Debug)]
pub struct Request {
    pub kind: Kind,
    /// below 0: M4
    pub speed: f64,
    pub target: f64,
}

impl Request {
    /// Of a reset, of BRAKE, of an error that stays, of a drive that is off.
    pub const STOP: Self = Self { kind: Kind::Stop, speed: 0.0, target: 0.0 };
}

/// Those that wait at most.
const PLACES: usize = 4;

/// The inputs of the cycle before, and the requests that wait.
#[derive(Clone, Debug, Default)]
pub struct Requests {
    /// none before the first cycle
    levels: Option<[bool; 6]>,
    pub waiting: VecDeque<Request>,
}

impl Requests {
    /// Takes a cycle's inputs.
    ///
    /// # Errors
    /// What was refused, or else that a request was lost.
    pub fn take(&mut self, inputs: &Inputs, only_velocity: bool) -> Result<(), u32> {
        let levels = [inputs.g74, inputs.putax, inputs.m19, inputs.m5, inputs.m3, inputs.m4];
        let before = self.levels.replace(levels).unwrap_or(levels);
        if inputs.reset {
            return Ok(());
        }
        let [g74, putax, m19, m5, m3, m4] = std::array::from_fn(|index| levels[index] && !before[index]);
        let turn = !m19 && (m3 || m4);
        let ranking =
            [(g74, Kind::Home), (putax, Kind::Release), (m19, Kind::Position), (m5, Kind::Stop), (turn, Kind::Turn)];
        let mut counting = ranking.into_iter().filter_map(|(became_true, kind)| became_true.then_some(kind));
        let Some(first) = counting.next() else { return Ok(()) };
        self.admit(first, inputs, only_velocity)?;
        if counting.next().is_some() { Err(31) } else { Ok(()) }
    }

    /// Puts a request after those that wait, or refuses it.
    fn admit(&mut self, kind: Kind, inputs: &Inputs, only_velocity: bool) -> Result<(), u32> {
        let has_speed = matches!(kind, Kind::Turn | Kind::Position);
        let has_target = kind == Kind::Position;
        let refusals = [
            (has_speed && inputs.m3 && inputs.m4, 32),
            (has_speed && !is_velocity(inputs.s_word), 33),
            (has_target && !is_position(inputs.s_position), 34),
            (only_velocity && !kind.is_of_velocity(), 49),
            (!inputs.drive_on, 36),
            (self.waiting.len() >= PLACES, 35),
        ];
        if let Some((_, id)) = refusals.into_iter().find(|(is_refused, _)| *is_refused) {
            return Err(id);
        }
        let direction = if inputs.m4 { -1.0 } else { 1.0 };
        self.waiting.push_back(Request {
            kind,
            speed: if has_speed { direction * inputs.s_word.abs() } else { 0.0 },
            target: if has_target { inputs.s_position } else { 0.0 },
        });
        Ok(())
    }
}

//! The choices that a program is made of, each with its place: drawn from a source of chance and recorded, or given back. What
//! they mean is for `generate`.
//!
//! 0 is the plainest choice, and a choice that is not given is 0: a program of no choices is the plainest of all. The place of a
//! choice is the way to it through the program that is being made, so that one that is taken away moves no other.

use super::rng::Rng;
use std::collections::HashMap;

/// Where a choice is made, and what was chosen.
pub type Choice = (u64, u32);

/// Where choices come from, and those that were made.
#[derive(Clone, Debug)]
pub struct Choices {
    source: Source,
    made: Vec<Choice>,
    /// the open places, each with the number of choices and places inside it so far
    open: Vec<(u64, u64)>,
}

#[derive(Clone, Debug)]
enum Source {
    Chance(Rng),
    Given(HashMap<u64, u32>),
}

impl Choices {
    /// Choices by chance.
    #[must_use]
    pub fn by_chance(rng: Rng) -> Self {
        Self { source: Source::Chance(rng), made: Vec::new(), open: vec![(0, 0)] }
    }

    /// Choices that are given.
    #[must_use]
    pub fn given(choices: &[Choice]) -> Self {
        Self { source: Source::Given(choices.iter().copied().collect()), made: Vec::new(), open: vec![(0, 0)] }
    }

    /// Those that were made.
    #[must_use]
    pub fn made(self) -> Vec<Choice> {
        self.made
    }

    /// Opens a place inside the present one.
    pub fn enter(&mut self) {
        let place = self.next();
        self.open.push((place, 0));
    }

    /// Opens the place of a name, of which there is one inside the present one.
    pub fn enter_named(&mut self, name: &str) {
        let outside = self.open.last().map_or(0, |(place, _)| *place);
        let place = name.bytes().fold(mixed(outside, u64::MAX), |place, byte| mixed(place, u64::from(byte)));
        self.open.push((place, 0));
    }

    /// Closes the present place.
    pub fn leave(&mut self) {
        self.open.pop();
    }

    /// A number below the bound that follows from the place alone: for names, which are not worth a choice.
    pub fn of_place(&mut self, bound: usize) -> usize {
        usize::try_from(self.next() % bound as u64).unwrap_or_default()
    }

    /// Whether something is there that could be left out: always, until it is taken away.
    pub fn is_there(&mut self) -> bool {
        self.choose() != 0
    }

    /// A number below the bound, which is not 0.
    pub fn below(&mut self, bound: usize) -> usize {
        let scaled = (u64::from(self.choose()) * bound as u64) >> 32;
        usize::try_from(scaled).unwrap_or_default()
    }

    /// A number from the first to the last, both included.
    pub fn between(&mut self, first: usize, last: usize) -> usize {
        first + self.below(last - first + 1)
    }

    /// True in so many of 100 cases; false is the plainer one.
    pub fn chance(&mut self, percent: usize) -> bool {
        self.below(100) >= 100 - percent
    }

    /// One of the items; the first is the plainest.
    pub fn pick<'i, T>(&mut self, items: &'i [T]) -> &'i T {
        &items[self.below(items.len())]
    }

    /// One of the items that the weights stand for; an item without weight is never taken.
    pub fn weighted(&mut self, weights: &[usize]) -> usize {
        let mut rest = self.below(weights.iter().sum());
        for (item, weight) in weights.iter().enumerate() {
            if rest < *weight {
                return item;
            }
            rest -= weight;
        }
        unreachable!("choices: the weights have a sum")
    }

    /// One of several names with weights: the same one, whatever other names come or go.
    pub fn named<'n>(&mut self, names: impl Iterator<Item = (&'n str, usize)>) -> usize {
        let chosen = u64::from(self.choose());
        let rank = |name: &str, ticket: usize| {
            name.bytes().fold(mixed(chosen, ticket as u64), |rank, byte| mixed(rank, u64::from(byte)))
        };
        let best = |(name, weight): (&str, usize)| (0..weight).map(|ticket| rank(name, ticket)).max();
        let ranks = names.map(best).enumerate();
        ranks.max_by_key(|(_, rank)| *rank).map_or(0, |(item, _)| item)
    }

    fn choose(&mut self) -> u32 {
        let place = self.next();
        let value = match &mut self.source {
            Source::Chance(rng) => u32::try_from(rng.word() >> 32).unwrap_or_default(),
            Source::Given(values) => values.get(&place).copied().unwrap_or_default(),
        };
        self.made.push((place, value));
        value
    }

    /// The next place inside the present one.
    fn next(&mut self) -> u64 {
        let Some((place, count)) = self.open.last_mut() else {
            unreachable!("choices: the outermost place stays open")
        };
        *count += 1;
        mixed(*place, *count)
    }
}

/// A number that depends on all bits of two.
fn mixed(a: u64, b: u64) -> u64 {
    Rng::numbered(a, usize::try_from(b & 0xffff_ffff).unwrap_or_default()).word()
}

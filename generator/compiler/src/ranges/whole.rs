//! Intervals of integers, with the remaining named numbers. No reals.

use portable::{Binary, Literal};

/// All named numbers, and any other number.
const ALL: u128 = u128::MAX;

/// The integers from `low` to `high`; if `named` is not all ones, only the named numbers at these positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Whole {
    pub low: i64,
    pub high: i64,
    pub(super) named: u128,
}

/// The named numbers of a program, in their order.
#[derive(Clone, Debug, Default)]
pub(super) struct Names(Vec<i64>);

impl Names {
    /// The first of these numbers, as many as a bit set can hold.
    pub(super) fn of(numbers: impl Iterator<Item = i64>) -> Self {
        let mut names = Vec::new();
        for number in numbers {
            if names.len() < 127 && !names.contains(&number) {
                names.push(number);
            }
        }
        names.sort_unstable();
        Self(names)
    }

    pub(super) fn one(&self, number: i64) -> Whole {
        let named = self.0.binary_search(&number).map_or(ALL, |position| 1 << position);
        Whole { low: number, high: number, named }
    }

    /// The numbers, if they are named.
    pub(super) fn numbers(&self, of: Whole) -> Option<Vec<i64>> {
        let of = self.listed(of);
        let is_in = |(position, _): &(usize, &i64)| of.named >> position & 1 == 1;
        (of.named != ALL).then(|| self.0.iter().enumerate().filter(is_in).map(|(_, number)| *number).collect())
    }

    pub(super) fn join(&self, a: Whole, b: Whole) -> Whole {
        match (a.is_none(), b.is_none()) {
            (true, _) => b,
            (_, true) => a,
            _ => {
                let (a, b) = (self.listed(a), self.listed(b));
                let named = if a.named == ALL || b.named == ALL { ALL } else { a.named | b.named };
                Whole { low: a.low.min(b.low), high: a.high.max(b.high), named }
            }
        }
    }

    /// The integers as named numbers, if each number of a short range has a name.
    fn listed(&self, of: Whole) -> Whole {
        if of.named != ALL || of.high - of.low > 126 {
            return of;
        }
        let Ok(first) = self.0.binary_search(&of.low) else { return of };
        let count = usize::try_from(of.high - of.low).unwrap_or_default();
        // The names are in order: if all exist, the last one is at this distance.
        if self.0.get(first + count) != Some(&of.high) {
            return of;
        }
        Whole { named: ((2 << count) - 1) << first, ..of }
    }

    /// The intersection of both.
    pub(super) fn meet(&self, a: Whole, b: Whole) -> Whole {
        self.tight(Whole { low: a.low.max(b.low), high: a.high.min(b.high), named: a.named & b.named })
    }

    /// The integers without one number.
    pub(super) fn without(&self, of: Whole, number: i64) -> Whole {
        let mut left = of;
        if left.named != ALL {
            left.named &= !self.0.binary_search(&number).map_or(0, |position| 1 << position);
        }
        left.low += i64::from(left.low == number);
        left.high -= i64::from(left.high == number);
        self.tight(left)
    }

    fn tight(&self, mut of: Whole) -> Whole {
        if of.named != ALL {
            // The names are in order: those in the interval are next to each other.
            let first = self.0.partition_point(|number| *number < of.low);
            let after = self.0.partition_point(|number| *number <= of.high);
            of.named &= (1_u128 << after).saturating_sub(1 << first);
            if of.named == 0 {
                return Whole::NONE;
            }
            let [first, last] = [of.named.trailing_zeros(), of.named.ilog2()];
            (of.low, of.high) = (self.0[first as usize], self.0[last as usize]);
        }
        if of.low > of.high { Whole::NONE } else { of }
    }
}

impl Whole {
    pub(super) const NONE: Self = Self { low: 0, high: -1, named: 0 };

    pub(super) fn numbers(low: i64, high: i64) -> Self {
        Self { low, high, named: ALL }
    }

    pub(super) fn is_none(self) -> bool {
        self.low > self.high
    }
}

pub(super) fn number(literal: Literal) -> Option<i64> {
    match literal {
        Literal::I32(value) => Some(value.into()),
        Literal::U32(value) => Some(value.into()),
        _ => None,
    }
}

/// The result of an operator on two integers before it wraps around; `None` if a divisor may be 0.
pub(super) fn binary(operator: Binary, a: Whole, b: Whole) -> Option<Whole> {
    let pairs = [(a.low, b.low), (a.low, b.high), (a.high, b.low), (a.high, b.high)];
    let of = |compute: fn(i64, i64) -> i64| {
        let results = pairs.map(|(a, b)| compute(a, b));
        let first = results[0];
        let (low, high) = results.iter().fold((first, first), |(low, high), value| (low.min(*value), high.max(*value)));
        Whole::numbers(low, high)
    };
    match operator {
        Binary::Add => Some(Whole::numbers(a.low + b.low, a.high + b.high)),
        Binary::Subtract => Some(Whole::numbers(a.low - b.high, a.high - b.low)),
        Binary::Multiply => Some(of(i64::saturating_mul)),
        Binary::Divide | Binary::Remainder if b.low <= 0 && b.high >= 0 => None,
        Binary::Divide => Some(of(|a, b| a / b)),
        Binary::Remainder => {
            let largest = b.low.abs().max(b.high.abs()) - 1;
            let is_kept = b.low == b.high && a.low >= -largest && a.high <= largest;
            let (low, high) = (if a.low < 0 { -largest } else { 0 }, if a.high > 0 { largest } else { 0 });
            Some(if is_kept { a } else { Whole::numbers(low.max(a.low.min(0)), high.min(a.high.max(0))) })
        }
        _ => panic!("ranges: {operator:?} of two integers gives no integer"),
    }
}

//! A parameter set as docs/parameter-sets.md describes it: its numbers by their names, what refuses it. Nothing that changes
//! from cycle to cycle.

use super::check_word::word;
use crate::model::history::narrowed;
use crate::model::parameters::{Mode, Parameters};

/// A coefficient is within +-32768, a limit within 2^20 of that.
const LARGEST: f64 = 32_768.0;
const LARGEST_LIMIT: f64 = LARGEST * 1_048_576.0;
/// Of a weight.
const LARGEST_WEIGHT: f64 = 7.0;

/// A parameter set.
#[derive(Clone, Debug)]
pub struct Set {
    /// `structure`
    pub structure: u32,
    /// `set_id`
    pub set_id: u32,
    /// the numbers, in the order of [`Structure::names`]
    pub numbers: Vec<f64>,
    /// which parameters the numbers belong to: a set that is taken over has all of them
    pub of: usize,
}

/// A section of a structure.
#[derive(Clone, Copy, Debug)]
enum Section {
    Bandpass,
    Allpass,
    Oscillation,
}

/// What a block knows of the sets that fit it.
#[derive(Clone, Debug)]
pub struct Structure {
    /// its number
    pub number: u32,
    /// the real type
    pub single: bool,
    /// the limit that the block was generated with
    pub limit: f64,
    /// the numbers of a set, in their order
    pub names: Vec<String>,
    /// which sections there are, and where their numbers begin
    sections: Vec<(Section, usize)>,
    /// where the gains are
    gains: Vec<usize>,
    /// how many of the numbers, the first ones, are limits
    limits: usize,
}

impl Section {
    fn names(self, single: bool) -> &'static [&'static str] {
        match (self, single) {
            (Self::Oscillation, true) => &["h", "r", "g", "g2"],
            (_, true) => &["a", "b", "c"],
            (Self::Bandpass, _) => &["b2", "a1", "a2"],
            (Self::Allpass, _) => &["a1", "a2", "preset"],
            (Self::Oscillation, _) => &["b0", "b1", "b2", "a1", "a2", "preset_s1", "preset_s2"],
        }
    }

    /// Whether the poles lie inside the unit circle. z^2 + a1 z + a2 has them there where |a2| < 1 and the polynomial is
    /// above 0 at 1 and at -1. A section by the trapezoidal rule, u = A p - B s, s' = s + u, p' = p - C (s + s'), has a1 = B
    /// + AC - 2 and a2 = 1 - B + AC: the polynomial is 2 AC at 1 and 4 - 2 B at -1, and 1 - a2 is B - AC.
    fn is_stable(self, numbers: &[f64], single: bool) -> bool {
        let biquad = |a1: f64, a2: f64| a2.abs() < 1.0 && 1.0 + a1 + a2 > 0.0 && 1.0 - a1 + a2 > 0.0;
        // Products are rounded: this form is that of single precision.
        let trapezoidal = |a: f64, b: f64, c: f64| {
            let product = narrowed(a * c);
            product > 0.0 && b < 2.0 && b > product
        };
        match (self, single) {
            (Self::Bandpass, false) => biquad(numbers[1], numbers[2]),
            (Self::Allpass, false) => biquad(numbers[0], numbers[1]),
            (Self::Oscillation, false) => biquad(numbers[3], numbers[4]),
            (Self::Oscillation, true) => {
                let [h, r, g, g2] = [0, 1, 2, 3].map(|at| numbers[at]);
                trapezoidal(narrowed(g * h), narrowed(g * r), g2)
            }
            (_, true) => trapezoidal(numbers[0], numbers[1], numbers[2]),
        }
    }
}

impl Structure {
    /// Of the block that these parameters make, with the number and the limit that it was generated with.
    #[must_use]
    pub fn new(p: &Parameters, number: u32, limit: f64) -> Self {
        let mut names: Vec<String> = ["limit", "lower_limit", "sum_limit"].map(str::to_owned).into();
        if p.watch {
            names.push("watch.quiet".to_owned());
        }
        let limits = names.len();
        let (mut sections, mut gains) = (Vec::new(), Vec::new());
        for (i, stage) in p.stages.iter().enumerate() {
            let mut section = |kind: Section, path: String| {
                sections.push((kind, names.len()));
                names.extend(kind.names(p.single).iter().map(|name| format!("{path}.{name}")));
            };
            if matches!(stage.mode, Mode::Indirect | Mode::SetPoint) {
                section(Section::Oscillation, format!("stage[{i}].oscillation"));
            }
            let at = usize::from(stage.all_pass.is_some() && stage.is_all_pass_first);
            if at == 1 {
                section(Section::Allpass, format!("stage[{i}].filter[0].allpass"));
            }
            for k in 0..stage.band_pass.0 {
                section(Section::Bandpass, format!("stage[{i}].filter[{at}].bandpass[{k}]"));
            }
            if at == 0 && stage.all_pass.is_some() {
                section(Section::Allpass, format!("stage[{i}].filter[1].allpass"));
            }
            gains.push(names.len());
            names.push(format!("stage[{i}].gain"));
        }
        Self { number, single: p.single, limit, names, sections, gains, limits }
    }

    /// The cycles of a whole check: it reads one piece a cycle.
    pub fn check_cycles(&self) -> usize {
        self.names.len() * self.pieces()
    }

    /// Pieces of a number.
    fn pieces(&self) -> usize {
        if self.single { 3 } else { 4 }
    }

    /// A number as the check word cuts it.
    fn cut(&self, at: usize, number: f64) -> f64 {
        if at < self.limits { number / 1_048_576.0 } else { number }
    }

    /// Whether a number is in range, fits the numbers before it, and the section whose poles it decides is stable.
    fn is_sound(&self, at: usize, before: &[f64], number: f64) -> bool {
        let decided = self.poles_end().find(|(_, end)| *end == at);
        match at {
            0 => (0.0..=self.limit).contains(&number),
            1 => number + before[0] == 0.0,
            2 => (before[0]..=LARGEST_LIMIT).contains(&number),
            3 if self.limits > 3 => number.abs() <= self.limit,
            _ if self.gains.contains(&at) => number.abs() <= LARGEST_WEIGHT,
            _ => {
                let is_stable = |((kind, first), _): ((Section, usize), usize)| {
                    let mut numbers = before[first..].to_vec();
                    numbers.push(number);
                    numbers.resize(7, 0.0);
                    kind.is_stable(&numbers, self.single)
                };
                number.abs() <= LARGEST && decided.is_none_or(is_stable)
            }
        }
    }

    /// Each section with the place of the number that completes its poles.
    fn poles_end(&self) -> impl Iterator<Item = ((Section, usize), usize)> {
        let end = |(kind, first): (Section, usize)| match (kind, self.single) {
            (Section::Oscillation, true) => first + 3,
            (Section::Oscillation, false) => first + 4,
            (Section::Allpass, false) => first + 1,
            (Section::Bandpass | Section::Allpass, _) => first + 2,
        };
        self.sections.iter().map(move |of| (*of, end(*of)))
    }

    /// Where the numbers of the limits end.
    #[must_use]
    pub fn limits(&self) -> usize {
        self.limits
    }

    /// Where the gains stand.
    #[must_use]
    pub fn gains(&self) -> &[usize] {
        &self.gains
    }

    /// Where a number of each section stands that decides where its poles are, and values with which they do not lie inside
    /// the unit circle.
    #[must_use]
    pub fn poles(&self) -> Vec<(usize, &'static [f64])> {
        let of = |(kind, at): &(Section, usize)| match (kind, self.single) {
            // a2
            (Section::Bandpass, false) => (at + 2, [1.0, 1.5, -1.0, -2.5].as_slice()),
            (Section::Allpass, false) => (at + 1, [1.0, 1.5, -1.0, -2.5].as_slice()),
            (Section::Oscillation, false) => (at + 4, [1.0, 1.5, -1.0, -2.5].as_slice()),
            // R, of which B is a part
            (Section::Oscillation, true) => (at + 1, [1e4, 0.0, -0.5].as_slice()),
            // B
            (_, true) => (at + 1, [2.0, 2.5, 0.0, -0.5].as_slice()),
        };
        self.sections.iter().map(of).collect()
    }
}

impl Set {
    /// Limit, largest sum and quiet span.
    #[must_use]
    pub fn limits(&self, of: &Structure) -> [f64; 3] {
        [self.numbers[0], self.numbers[2], if of.limits > 3 { self.numbers[3] } else { 0.0 }]
    }

    /// The same set with the number that belongs to its numbers, as far as the word covers their digits.
    #[must_use]
    pub fn sealed(self, of: &Structure) -> Self {
        let cut: Vec<f64> = self.numbers.iter().enumerate().map(|(at, number)| of.cut(at, *number)).collect();
        // What is beyond the range is refused whatever the number is.
        let is_cut = cut.iter().all(|number| number.abs() <= LARGEST);
        let set_id = if is_cut { word(self.structure, cut, of.single).0 } else { self.set_id };
        Self { set_id, ..self }
    }

    /// The id for which it is refused while it does not change; 0: it is not.
    #[must_use]
    pub fn refusal(&self, of: &Structure) -> u32 {
        let mut checked = Checking::new(self.set_id);
        match checked.begin(self, of) {
            0 => loop {
                if let Some(why) = checked.piece(&self.numbers, of, false) {
                    return why;
                }
            },
            why => why,
        }
    }
}

/// A set that is checked, a piece of a number in a cycle: docs/parameter-sets.md, "What the block does".
#[derive(Clone, Debug)]
pub struct Checking {
    /// its number
    pub set: u32,
    /// cycles so far
    pieces: usize,
    /// each number as it was when its first piece was taken
    cut: Vec<f64>,
    /// each number as it was when its last piece was taken
    seen: Vec<f64>,
}

impl Checking {
    /// Before the first piece.
    #[must_use]
    pub fn new(set: u32) -> Self {
        Self { set, pieces: 0, cut: Vec::new(), seen: Vec::new() }
    }

    /// The first cycle: 6 for a set of another structure or without a number.
    #[must_use]
    pub fn begin(&self, offered: &Set, of: &Structure) -> u32 {
        if offered.structure != of.number || offered.set_id == 0 { 6 } else { 0 }
    }

    /// Whether the last piece was taken.
    #[must_use]
    pub fn is_done(&self, of: &Structure) -> bool {
        self.pieces == of.check_cycles()
    }

    /// The next piece of these numbers. The id for which the set is refused, or 0 after the last piece. `was_checked`: only
    /// the word is formed.
    pub fn piece(&mut self, numbers: &[f64], of: &Structure, was_checked: bool) -> Option<u32> {
        let (at, piece) = (self.pieces / of.pieces(), self.pieces % of.pieces());
        if !was_checked && !of.is_sound(at, &self.seen, numbers[at]) {
            return Some(7);
        }
        if piece == 0 {
            self.cut.push(of.cut(at, numbers[at]));
        }
        if piece + 1 == of.pieces() {
            self.seen.push(numbers[at]);
        }
        self.pieces += 1;
        // What is beyond the range has no word.
        let is_cut = || self.cut.iter().all(|number| number.abs() <= LARGEST);
        let is_its_number = || is_cut() && word(of.number, self.cut.iter().copied(), of.single) == (self.set, true);
        self.is_done(of).then(|| if is_its_number() { 0 } else { 8 })
    }
}

//! From a program that differs to a small one that still does: proptest simplifies the choices that it was made of, first by taking
//! them away, then by making them smaller. Here is what of it is worth a build, and what is built together.

use super::choices::{Choice, Choices};
use super::syntax::Program;
use super::{generate, print};
use proptest::num::u32::BinarySearch;
use proptest::prelude::*;
use proptest::strategy::{NewTree, ValueTree};
use proptest::test_runner::TestRunner;
use std::collections::HashMap;

/// Candidates that are built together.
const WIDTH: usize = 60;
/// Builds that a shrinking may take.
const BUILDS: usize = 60;
/// Steps ahead that are looked at for candidates of one build.
const AHEAD: usize = 3_000;

/// Shrinks the program that the choices make. `differs` says of each candidate whether it still differs.
///
/// # Errors
/// Those of `differs`.
///
/// # Panics
/// Never: the choices are a strategy that always has a value.
pub fn shrink(
    choices: &[Choice],
    differs: impl FnMut(&[Program]) -> Result<Vec<bool>, String>,
) -> Result<Program, String> {
    let best = Candidate::new(choices);
    let mut search = Search { best, differs, builds: 0, verdicts: HashMap::new(), alone: HashMap::new() };
    loop {
        let before = search.best.text.len();
        let choices = search.best.choices.clone();
        let all = choices.iter().map(|_| prop::bool::weighted(1.0)).collect::<Vec<_>>();
        let kept = all.prop_map(move |kept| {
            choices.iter().zip(kept).filter(|(_, kept)| *kept).map(|(choice, _)| *choice).collect()
        });
        search.pass(kept)?;
        let choices = search.best.choices.clone();
        let values = choices.iter().map(|(_, value)| Recorded(*value)).collect::<Vec<_>>();
        let smaller = values
            .prop_map(move |values| choices.iter().zip(values).map(|((place, _), value)| (*place, value)).collect());
        search.pass(smaller)?;
        if search.best.text.len() == before || search.builds >= BUILDS {
            return Ok(search.best.program);
        }
    }
}

/// The place of a choice that differs, and what it is now; `None`: it is left out.
type Change = (u64, Option<u32>);

/// A number that was drawn already.
#[derive(Debug)]
struct Recorded(u32);

impl Strategy for Recorded {
    type Tree = BinarySearch;
    type Value = u32;

    fn new_tree(&self, _: &mut TestRunner) -> NewTree<Self> {
        Ok(BinarySearch::new(self.0))
    }
}

/// Choices and what they make.
#[derive(Clone)]
struct Candidate {
    choices: Vec<Choice>,
    program: Program,
    text: String,
}

impl Candidate {
    fn new(choices: &[Choice]) -> Self {
        let mut made = Choices::given(choices);
        let program = generate::program(&mut made);
        let text = print::module(&program, "");
        // What is left out is 0, and what was not asked for is nothing.
        let choices = made.made().into_iter().filter(|(_, value)| *value != 0).collect();
        Self { choices, program, text }
    }

    /// The first choice in which two differ, as it is in the second.
    fn change(&self, other: &Self) -> Option<Change> {
        let mut theirs = other.choices.iter().peekable();
        self.choices.iter().find_map(|own| match theirs.next_if(|their| their.0 == own.0) {
            Some(their) if their.1 == own.1 => None,
            Some(their) => Some((their.0, Some(their.1))),
            None => Some((own.0, None)),
        })
    }
}

struct Search<D> {
    best: Candidate,
    differs: D,
    builds: usize,
    /// what was said of a text
    verdicts: HashMap<String, bool>,
    /// what was said of a change the last time
    alone: HashMap<Change, bool>,
}

impl<D: FnMut(&[Program]) -> Result<Vec<bool>, String>> Search<D> {
    /// Follows the simplifications of a strategy as far as the builds reach.
    fn pass<S>(&mut self, strategy: S) -> Result<(), String>
    where
        S: Strategy<Value = Vec<Choice>>,
        S::Tree: Clone,
    {
        let mut tree =
            strategy.new_tree(&mut TestRunner::deterministic()).expect("shrink: recorded choices are a value");
        let mut more = tree.simplify();
        while more {
            let candidate = Candidate::new(&tree.current());
            let verdict = match self.known(&self.best, &candidate) {
                Some(verdict) => verdict,
                None if self.builds >= BUILDS => return Ok(()),
                None => {
                    self.build(tree.clone())?;
                    continue;
                }
            };
            if verdict {
                self.best = candidate;
            }
            more = if verdict { tree.simplify() } else { tree.complicate() };
        }
        Ok(())
    }

    /// What needs no build: the same text differs as it did, and a longer one is not what is looked for.
    fn known(&self, best: &Candidate, candidate: &Candidate) -> Option<bool> {
        if candidate.text == best.text {
            return Some(true);
        }
        if candidate.text.len() >= best.text.len() {
            return Some(false);
        }
        self.verdicts.get(&candidate.text).copied()
    }

    /// Builds the tree's candidate, and those that come after it if each change does again what it did alone.
    fn build(&mut self, mut tree: impl ValueTree<Value = Vec<Choice>>) -> Result<(), String> {
        let mut best = self.best.clone();
        let mut asked: Vec<(Candidate, Option<Change>)> = Vec::new();
        for _ in 0..AHEAD {
            let candidate = Candidate::new(&tree.current());
            let verdict = self.known(&best, &candidate).unwrap_or_else(|| {
                let change = best.change(&candidate);
                if asked.iter().all(|(other, _)| other.text != candidate.text) {
                    asked.push((candidate.clone(), change));
                }
                change.and_then(|change| self.alone.get(&change)).copied().unwrap_or_default()
            });
            if verdict {
                best = candidate;
            }
            let more = if verdict { tree.simplify() } else { tree.complicate() };
            if !more || asked.len() >= WIDTH {
                break;
            }
        }
        let programs: Vec<Program> = asked.iter().map(|(candidate, _)| candidate.program.clone()).collect();
        let answers = (self.differs)(&programs)?;
        self.builds += 1;
        for ((candidate, change), answer) in asked.into_iter().zip(answers) {
            self.verdicts.insert(candidate.text, answer);
            self.alone.extend(change.map(|change| (change, answer)));
        }
        Ok(())
    }
}

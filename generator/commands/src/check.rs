//! The command `check`: the axes of a set with their verdicts; in full also the proven properties of their blocks.

use crate::words::{counted, made};
use generator::blocks::{self, Designed};
use generator::pipeline::Set;
use generator::summary::{self, AxisRow};
use serde::Serialize;

/// A set that was read and checked.
#[derive(Clone, Debug, Serialize)]
pub struct Check {
    pub axes: Vec<CheckedAxis>,
    pub warnings: usize,
    /// parameters of other functions in its lists
    pub foreign: usize,
}

/// An axis.
#[derive(Clone, Debug, Serialize)]
pub struct CheckedAxis {
    #[serde(flatten)]
    pub row: AxisRow,
    /// the proven properties of each block; empty unless asked for
    pub proven: Vec<Proven>,
}

/// The proven properties of a block.
#[derive(Clone, Debug, Serialize)]
pub struct Proven {
    pub block: &'static str,
    /// the ranges of its outputs, whatever its state and its inputs hold
    pub ranges: Vec<String>,
    /// its range at rest and its measured response
    pub certificate: Vec<String>,
}

/// Checks a set that was read with this number of warnings.
#[must_use]
pub fn check(set: &Set, warnings: usize, verbose: bool) -> Check {
    let axis = |designed: &Designed| CheckedAxis {
        row: summary::details(designed),
        proven: if verbose { proven(designed) } else { Vec::new() },
    };
    Check { axes: set.axes.iter().map(axis).collect(), warnings, foreign: set.foreign }
}

fn proven(designed: &Designed) -> Vec<Proven> {
    let blocks = made(blocks::blocks(designed)).into_iter();
    let proven = blocks.map(|block| Proven {
        block: block.program.block,
        ranges: block.shown.lines(&block.program),
        certificate: block.certificate.lines,
    });
    proven.collect()
}

impl Check {
    /// What the command prints.
    #[must_use]
    pub fn text(&self) -> String {
        let (warnings, foreign) = (counted(self.warnings, "warning"), counted(self.foreign, "parameter"));
        let axes: String = self.axes.iter().map(CheckedAxis::text).collect();
        format!("{axes}{warnings}, {foreign} of other functions passed over\n")
    }
}

impl CheckedAxis {
    fn text(&self) -> String {
        let mut text = self.row.text();
        for Proven { block, ranges, certificate } in &self.proven {
            text += &format!("  {block}, whatever its state and its inputs hold:\n");
            ranges.iter().for_each(|line| text.extend(["    ", line, "\n"]));
            certificate.iter().for_each(|line| text.extend(["  ", line, "\n"]));
        }
        text
    }
}

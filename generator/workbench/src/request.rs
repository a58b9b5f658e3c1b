//! The requests of the page, as they stand in JSON: data.

use commands::stages::Number;
use serde::Deserialize;

/// A set, or a list with what it does not contain.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
pub struct Subject {
    /// the name of its file
    pub set: String,
    /// of a list
    pub cycle_time: Option<String>,
    /// the name of the axis of a list
    pub name: Option<String>,
    /// measured responses of drives
    #[serde(default)]
    pub responses: Vec<Response>,
}

/// A file with the measured response of the drive of an axis.
#[derive(Clone, Debug, PartialEq, Deserialize)]
pub struct Response {
    pub file: String,
    pub axis: String,
}

/// A request. An axis without a name is the only one of its set.
#[derive(Clone, Debug, Deserialize)]
#[serde(tag = "command", rename_all = "snake_case")]
pub enum Request {
    /// the probable use of files
    Kinds {
        names: Vec<String>,
    },
    /// reads and checks
    Check {
        of: Subject,
    },
    /// the loop of an axis as numbers and as a picture
    Loop {
        axis: String,
    },
    /// writes a value into the text of the user, reads and checks; with the loop of the axis
    Edit {
        of: Subject,
        axis: String,
        stage: usize,
        value: Number,
        to: f64,
    },
    /// the commissioning page of an axis, with the names of a target
    Page {
        axis: String,
        target: String,
    },
    /// the files of an axis for a target; the parameters with their coefficients, and the lines of these in the files
    Code {
        of: Subject,
        axis: String,
        target: String,
    },
    /// an archive of all files for targets, those of the set if none is named, and of the user's files: the file `name`
    Zip {
        of: Subject,
        targets: Vec<String>,
        name: String,
    },
    /// runs every block in every engine that needs no compiler
    Verify {
        samples: usize,
    },
    /// two versions of a set
    Diff {
        of: Subject,
        old: String,
    },
    /// the loop of an axis with and without its stages, over time
    Simulate {
        axis: String,
    },
    /// the parameter set for a block that was generated from another version
    ParamsOf {
        of: Subject,
        axis: String,
        on: String,
        form: String,
    },
    Measure {
        of: Subject,
        axis: Option<String>,
        recording: String,
        excited: Option<String>,
    },
    Tune {
        of: Subject,
        axis: String,
        recording: String,
        excited: Option<String>,
    },
    /// writes a proposal of the last `tune` into the text of the user
    Apply {
        of: Subject,
        axis: String,
        proposal: String,
    },
}

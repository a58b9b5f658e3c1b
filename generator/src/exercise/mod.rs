//! The exercise of a block: its inputs in a run of its own, and the answers of the reference. Self-tests, on a controller or
//! in a build, and runners on a user's own board use it. Printing is done by the targets.

mod answers;
mod inputs;
mod noise;
mod run;
pub mod runner;
mod self_test;
mod trial;

pub(crate) use answers::{Answer, RecordedAnswers, Start, recording};
pub use inputs::Drill;
pub(crate) use inputs::{Exercise, Turn, Wanted};
pub(crate) use noise::Noise;
pub use run::Run;
pub(crate) use run::Running;
pub(crate) use self_test::SelfTest;
pub(crate) use trial::Trial;

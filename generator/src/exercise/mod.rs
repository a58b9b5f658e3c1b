//! The exercise of a block: its inputs in a run of its own, and the answers of the reference. Self-tests, on a controller or
//! in a build, and runners on a user's own board use it. Printing is done by the targets.
//!
//! ```text
//! inputs     the inputs of a block
//! run        the reference in operation, and the digest of its outputs and state
//! noise      integers that every target can generate
//! self_test  a few samples, each with a digest of outputs and state: detects a build that fuses, reorders or shortens
//! operations
//! trial      a run with the answers themselves: a user can repeat it on the controller
//! answers    the reference's answers in a trial
//! runner     a long run, of which only digests are kept
//! ```

mod answers;
mod inputs;
mod noise;
mod run;
pub mod runner;
mod self_test;
mod trial;

pub(crate) use answers::{Answer, RecordedAnswers, recording};
pub use inputs::Drill;
pub(crate) use inputs::{Exercise, Turn, Wanted};
pub(crate) use noise::Noise;
pub use run::Run;
pub(crate) use run::Running;
pub(crate) use self_test::SelfTest;
pub(crate) use trial::Trial;

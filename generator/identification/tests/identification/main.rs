//! Judges of the crate: sums and closed formulas, the demonstration plant with seeded noise, synthesised records. Nothing of the command.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod excitation;
mod offset;
mod plant;
mod response;

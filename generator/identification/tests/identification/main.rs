//! Judges of the crate: sums and closed formulas, the demonstration plant with seeded noise, synthesised records.
//! Nothing of the command.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "numbers of samples")]

mod excitation;
mod offset;
mod plant;
mod proposals;
mod random_axes;
mod response;
mod stage;
mod vibrations;
mod what_if;

//! `axgen measure` and `axgen tune` on recordings of the simulated demonstration plant.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod measure;
mod plant;
mod stages;
mod tune;

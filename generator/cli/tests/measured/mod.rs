//! `axgen measure` and `axgen tune` on recordings of the simulated demonstration plant.

mod measure;
mod plant;
mod stages;
mod tune;
mod units;

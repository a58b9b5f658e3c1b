//! Improved position control in the loop of an axis: the reference of the block `ipc`, sample by sample, with moves forward
//! and back; off, each stage alone, and all stages. No file.

mod of_plant;
pub mod picture;
pub mod recording;
mod ripple;
mod row;
mod setting;
pub mod text;

use crate::analysis::stages;
use generator::blocks::Designed;
pub use row::{Moved, Row, Simulation};
use setting::{OFF, ON, Setting, only};

/// Simulates an axis; `dwell` [s] replaces the default.
///
/// # Errors
/// The axis has no block `ipc`.
pub fn run(designed: &Designed, moved: Moved, dwell: Option<f64>) -> Result<Simulation, String> {
    let stages: Vec<(usize, f64)> = stages(designed).collect();
    let set = Setting::new(designed, moved, dwell, &stages);
    let mut rows = vec![set.row("off", designed, OFF)?];
    if stages.len() > 1 {
        for (stage, _) in &stages {
            rows.push(set.row(&format!("stage {stage} alone"), &only(designed, Some(*stage)), ON)?);
        }
    }
    rows.push(set.row("all", designed, ON)?);
    Ok(Simulation { moved, kv: set.position.kv, rows, deviation: set.deviation(), stages })
}

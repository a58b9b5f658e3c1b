//! Improved position control in the loop of an axis: the reference of the block `ipc`, sample by sample, with moves forward and back; off,
//! each stage alone, and all. No file.
//!
//! ```text
//! row              what comes out of a run
//! setting          the loop of a run
//! response_filter  a measured response as a machine
//! ripple           a vibration on a machine that has none
//! loop_margins     Ms of the same loop
//! text             the table, and CSV; picture: off against on
//! ```

mod loop_margins;
pub mod picture;
mod response_filter;
mod ripple;
mod row;
mod setting;
pub mod text;

use generator::blocks::Designed;
pub use row::{Moved, Row, Simulation};
use setting::{OFF, ON, Setting, only, stages};

/// Runs an axis; a dwell [s] takes the place of the usual one.
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
    let deviation = set.filter.as_ref().zip(set.model.response.as_ref());
    let deviation = deviation.map(|(filter, measured)| filter.deviation(&measured.response));
    Ok(Simulation { moved, kv: set.position.kv, rows, deviation, stages })
}

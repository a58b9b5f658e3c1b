//! A simulation as a table, and as CSV with off and on.

use super::{Moved, Row, Simulation};
use generator::blocks::Designed;
use machine::closed_loop::UM;
use std::fmt::Write;

/// First line of the CSV file.
pub const HEAD: &str = "time [s],x_command [mm],x off [mm],x on [mm],v_motor off [mm/s],v_motor on [mm/s],v_add [mm/s],\
    a_load off [m/s^2],a_load on [m/s^2]";

/// The table, and problems of the loop.
#[must_use]
pub fn table(simulation: &Simulation, designed: &Designed) -> String {
    let axis = &designed.axis;
    let all = simulation.rows.last();
    let samples = all.map_or(0, |row| row.record.command.len());
    let moved = match simulation.moved {
        Moved::Demonstration => "the demonstration plant",
        Moved::Drive if simulation.deviation.is_some() => "the measured drive, ripple of 1 mm/s at each f0",
        Moved::Drive => "a drive without mechanics, ripple of 1 mm/s at each f0",
    };
    let mut text =
        format!("axis {}: {moved}, Kv {}/s, {:.3} s\n", axis.name, simulation.kv, samples as f64 * axis.cycle_time());
    if let Some([deviation, hz]) = simulation.deviation {
        text += &format!("its filter differs from the response by {:.2} % at most, at {hz:.1} Hz\n", deviation * 100.0);
    }
    let (mut columns, decimals) = match simulation.moved {
        Moved::Demonstration => (["53 Hz", "11 Hz", "ring-down"].map(|name| format!("{name} [m/s^2]")).to_vec(), 3),
        Moved::Drive => (simulation.stages.iter().map(|(_, f0)| format!("{f0} Hz [mm/s]")).collect(), 3),
    };
    columns.extend(["following error [mm]", "peak v_add [um/s]", "Ms"].map(str::to_owned));
    text += &line("", &columns, &columns);
    for row in &simulation.rows {
        let mut cells: Vec<String> = row.amplitudes.iter().map(|value| format!("{value:.decimals$}")).collect();
        cells.push(format!("{:.2}", row.following_error));
        cells.push(format!("{:.0}", row.peak_v_add));
        cells.push(row.ms_in_words());
        text += &line(&row.name, &cells, &columns);
    }
    text + &remarks(simulation)
}

fn line(name: &str, cells: &[String], columns: &[String]) -> String {
    let cells =
        cells.iter().zip(columns).map(|(cell, column)| format!("  {cell:>width$}", width = column.len().max(8)));
    format!("  {name:<13}{}\n", cells.collect::<String>())
}

/// Whether any run oscillates, or may oscillate.
#[must_use]
pub fn is_unstable(simulation: &Simulation) -> bool {
    simulation.rows.iter().any(|row| row.ms.is_none())
}

/// The remarks on each run, in addition to its numbers.
fn remarks(simulation: &Simulation) -> String {
    simulation.rows.iter().filter_map(remark).collect()
}

fn remark(row: &Row) -> Option<String> {
    let of_block = |id| format!("error {id} of the block; `axgen explain {id}` says what it means");
    let said = row.oscillation().message().or_else(|| row.error_id.map(of_block))?;
    Some(format!("{}: {said}\n", row.name))
}

/// Off and on, one line per cycle.
#[must_use]
pub fn csv(simulation: &Simulation) -> String {
    let mut text = format!("{HEAD}\n");
    let [Some(off), Some(on)] = [simulation.rows.first(), simulation.rows.last()].map(|row| row.map(|row| &row.record))
    else {
        return text;
    };
    for (n, x) in off.command.iter().enumerate() {
        let mm = |x: f64| x * 1e3;
        let v = |v: f64| v / UM * 1e3;
        let time = n as f64 * off.cycle;
        let [x, x_off, x_on] = [*x, off.x[n], on.x[n]].map(mm);
        let [v_off, v_on, v_add] = [off.signals[n].v_motor, on.signals[n].v_motor, on.v_add[n]].map(v);
        let [a_off, a_on] = [off.sensor[n], on.sensor[n]];
        writeln!(text, "{time:.6},{x:.6},{x_off:.6},{x_on:.6},{v_off:.6},{v_on:.6},{v_add:.6},{a_off:.6},{a_on:.6}")
            .expect("csv: a string takes all text");
    }
    text
}

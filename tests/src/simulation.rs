//! A closed position loop: the block `axis` with the coefficients that the generator designs, and a drive that moves a mass.
//!
//! ```text
//! interpolator --x, v, a, j--> block axis --velocity command--> hold --> velocity loop --> integral --x_actual--+
//!                                 ^                                                                             |
//!                                 +-----------------------------------------------------------------------------+
//! ```
//!
//! The block samples x_actual and puts out its command at the same instant, which is held for a cycle Ts. A hold is late by
//! Ts/2 on average. What feedforward calls Ta is everything between command and velocity, so that here
//! `Ta = time constant of the drive + Ts/2`. Only + - * / of doubles: the same bits on every host.

use generator::blocks;
use generator::config::ListOptions;
use generator::pipeline::read_to_look_at;
use machine::Machine;
use machine::seven_phases::Move;
use machine::velocity_loop::{Loop, VelocityLoop};
use portable::{Block, Portable};
use reference::axis::{Axis, Coeffs};
use std::path::Path;

/// Gain of the position controller Kv [1/s].
pub const KV: f64 = 30.0;

/// Velocity that one increment of the drive's velocity command stands for [um/s]: a millionth of 1 m/min.
pub const INCREMENT: f64 = 1.0 / 60.0;

/// What is simulated.
#[derive(Clone, Copy, Debug)]
pub struct Bench<'a> {
    /// cycle time Ts [ns]
    pub cycle_ns: u32,
    /// the parameters below `vorsteuer`, as lines of TOML; empty: no feedforward
    pub feedforward: &'a str,
    /// weight of G136 [%]
    pub percentage: i32,
    /// the velocity loop
    pub drive: Loop,
    /// its equivalent time constant, without the hold [ns]
    pub drive_ns: u32,
}

/// One cycle.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// when [ns]
    pub ns: u64,
    /// planned velocity [um/s]
    pub v: f64,
    /// position lag, x_command - x_actual [um]
    pub lag: f64,
}

/// Runs a move from its begin to a time [ns], cycle by cycle; the last sample is the last cycle before that time.
///
/// # Panics
/// If the parameters are wrong, or the block reports a fault or a limit.
#[must_use]
pub fn run(bench: &Bench<'_>, of: &Move, until_ns: u64) -> Vec<Sample> {
    let coeffs = coefficients(bench);
    let mut drive = VelocityLoop::new(bench.drive, bench.drive_ns, bench.cycle_ns);
    let (mut state, mut outputs) = (<Axis as Block<f64>>::state(), <Axis as Block<f64>>::outputs());
    let mut inputs = <Axis as Block<f64>>::inputs(&coeffs);
    inputs.feedforward_active = true;
    inputs.feedforward_percentage = bench.percentage;
    inputs.task_cycle_ns = bench.cycle_ns;
    let mut samples = Vec::new();
    for cycle in 0.. {
        let ns = cycle * u64::from(bench.cycle_ns);
        if ns >= until_ns {
            break;
        }
        let planned = of.at(ns);
        let x_actual = drive.now().x;
        (inputs.x_command, inputs.x_actual) = (planned.x, x_actual);
        (inputs.v_interpolator, inputs.a_interpolator, inputs.j_interpolator) = (planned.v, planned.a, planned.j);
        <Axis as Block<f64>>::step(&mut state, &coeffs, &inputs, &mut outputs);
        assert!(!outputs.fault && !outputs.limited, "simulation: {ns} ns: {outputs:?}");
        samples.push(Sample { ns, v: planned.v, lag: planned.x - x_actual });
        drive.step(f64::from(outputs.manipulated_variable) * INCREMENT);
    }
    samples
}

/// The coefficients that the generator designs for the axis.
fn coefficients(bench: &Bench<'_>) -> Coeffs<f64> {
    // kv in 0.01/s; multi_gain_z is the velocity command at 1 m/min.
    let set = format!(
        "cycle_time = \"{}ns\"\n\
         [axis.X]\n\
         getriebe = [{{ kv = {}, multi_gain_z = 1000000, multi_gain_n = 1 }}]\n\
         [axis.X.vorsteuer]\n\
         {}\n",
        bench.cycle_ns,
        KV * 100.0,
        bench.feedforward
    );
    let load = |_: &Path| Ok(set.clone().into_bytes());
    let (read, report) = read_to_look_at(Path::new("simulation.toml"), &ListOptions::default(), &load);
    let read = read.unwrap_or_else(|| panic!("simulation: {set}{report:#?}"));
    let axis = blocks::named("axis").expect("the registry has it");
    let mut leaves = axis.coefficients(&read.axes[0]).into_iter();
    Coeffs::build(&mut || leaves.next().expect("all coefficients"))
}

//! The block itself in a loop with the ideal drive: of stages without a message none oscillates, by the emitted C; those that are refused
//! do, by the reference.

use crate::emitted::growths;
use crate::random::{axis, read, stage};
use axgen_tests::environment::by_depth;
use axgen_tests::subject::Subject;
use generator::blocks::Designed;
use inside::rng::Rng;
use machine::closed_loop::Signals;

/// Cycles of noise, of a window that is looked at, and windows.
const NOISE: usize = 2000;
const WINDOW: usize = 1000;
const WINDOWS: usize = 6;

/// How much larger the last window is than the first one after the noise, rms; infinite where it is as large as the
/// limit makes it. The motor does what was commanded one cycle before.
fn growth(designed: &Designed, rng: &mut Rng) -> f64 {
    let mut block = Subject::new(designed);
    block.set("mode", 1.0);
    let (mut v_motor, mut windows) = (0.0, [0.0; WINDOWS]);
    for cycle in 0..NOISE + WINDOW * WINDOWS {
        let v_command = if cycle < NOISE { rng.below(2001) as f64 - 1000.0 } else { 0.0 };
        let v_add = block.step(&Signals { v_command, v_motor, v_direct: 0.0 });
        v_motor = v_command + v_add;
        if cycle >= NOISE {
            windows[(cycle - NOISE) / WINDOW] += v_motor * v_motor;
        }
    }
    let last = (windows[WINDOWS - 1] / WINDOW as f64).sqrt();
    if last > 300_000.0 { f64::INFINITY } else { (windows[WINDOWS - 1] / windows[0]).sqrt() }
}

/// A loop that neither grows nor falls in six seconds is called neither.
const STILL: f64 = 1.01;
/// Axes of a program in C.
const BATCH: usize = 50;

#[test]
fn a_stage_without_a_message_is_stable_on_the_ideal_drive() {
    let count = by_depth(200, 400, 2_000);
    let mut rng = Rng::new(0x1dea);
    let (mut silent, mut refused, mut grown) = (Vec::new(), 0_usize, 0_usize);
    for number in 0..count {
        let stage = stage(&mut rng, 150.0);
        let axis = axis(&format!("X{number}"), "", "ON", std::slice::from_ref(&stage));
        let set = |key: &str| format!("cycle_time = \"1ms\"\n{}", axis.replacen('\n', &format!("\n{key}"), 1));
        match read(&set("")) {
            (Some(axes), report) => {
                assert!(!report.to_string().contains("AX461"), "a block that starts ON is refused: {report}");
                silent.extend(axes.into_iter().map(|axis| (axis, stage.clone())));
            }
            (None, report) => {
                assert!(report.to_string().contains("AX345"), "{report}");
                refused += 1;
                let (axes, _) = read(&set("accept_unstable = true\n"));
                grown += usize::from(growth(&axes.expect("it is accepted")[0], &mut rng) > 1.0);
            }
        }
    }
    for batch in silent.chunks(BATCH) {
        let axes: Vec<Designed> = batch.iter().map(|(axis, _)| axis.clone()).collect();
        for (growth, (_, stage)) in growths(&axes).into_iter().zip(batch) {
            assert!(growth < STILL, "{growth}: {stage}");
        }
    }
    let silent = silent.len();
    println!("{count} stages: {silent} without a message, all stable; {refused} refused, of which {grown} grow");
    assert!(silent > count / 5 && refused > count / 5);
    // What is unstable by a hair grows less in six seconds than the noise decays.
    assert!(grown * 100 > refused * 95, "{grown} of {refused}");
}

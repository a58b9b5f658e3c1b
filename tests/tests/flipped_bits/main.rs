//! One bit of a block's state flips: of every block without a spindle it is reported, or harmless. The bounds are those of the documents:
//! v_add stays within its limit, a section forgets within its time constants, nothing else deviates without a report. A spindle cannot tell a
//! request that a bit has changed from a real one: its outputs stay within their ranges, and docs/spindle.md has the table.
#![expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "counts and samples of a test")]

mod campaign;
mod spindles;

use axgen_tests::cases;
use axgen_tests::environment::by_depth;
use axgen_tests::model::subject;
use campaign::{Bench, Table};
use generator::blocks::{Block, Designed};
use golden::case::named_block;
use rayon::prelude::*;

/// Improved position control with everything that has a state, its numbers fixed, tuned or from parameter sets.
fn ipc(real: &str, tunable: &str) -> Designed {
    subject::read(&format!(
        "cycle_time = '1ms'\n[axis.X]\nreal = '{real}'\ntunable = '{tunable}'\nride_through = 2\nwatch = true
getriebe = [{{ kv = 2000, dynamik.vb_max = 500000 }}]
[axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = 200
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'DIRECT'
filter = [{{ order = 1, fg_f0 = 20.0, q_factor = 5.0 }}]
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'INDIRECT'\nosc_damping = 0.5
filter = [{{ order = 1, fg_f0 = 50.0, q_factor = 2.0 }}]
[[axis.X.lr_param.improved_position_control.stage]]\nmode = 'DIRECT'
filter = [{{ type = 'ALLPASS', fg_f0 = 30.0, q_factor = 2.0 }}, {{ type = 'BANDPASS', prototype = 'CRIT_DAMPING', order = 1, fg_f0 = 40.0, q_factor = 2.0 }}]
"
    ))
}

/// The blocks: `ipc` in its three forms, and those of the golden cases that have other parts; in both real types.
fn subjects() -> Vec<(String, Designed, Block)> {
    let mut subjects = Vec::new();
    for real in ["f64", "f32"] {
        for tunable in ["nothing", "weights", "all"] {
            let designed = ipc(real, tunable);
            for name in ["ipc", "axis"] {
                let block = named_block(&designed, name).expect("the axis has it");
                subjects.push((format!("{name}, {real}, tunable {tunable}"), designed.clone(), block));
            }
        }
    }
    for case in cases::in_both_real_types() {
        let name = case.block.program.block;
        if ["feedforward", "position_control", "axis"].contains(&name) {
            let folder = case.folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
            subjects.push((format!("{name}, {:?}, {folder}", case.axis.axis.real), case.axis, case.block));
        }
    }
    subjects
}

/// A drive is not sent to a position that was overwritten: that is fault 3. The present one is held with 17.
#[test]
fn an_overwritten_position_is_not_held() {
    let mut flipped = 0;
    for (name, designed, block) in subjects() {
        let bench = Bench::of(&designed, &block);
        let flips = bench.flips_of_the_held_position();
        if flips.is_empty() {
            continue;
        }
        let (held, error_id) = bench.hold(None);
        assert!(held != 0.0 && (error_id - 17.0).abs() < 0.5, "{name}: {held}, {error_id}");
        for flip in flips {
            // The sign of a 0 is no other position.
            let (x_drive, error_id) = bench.hold(Some(flip));
            assert!(x_drive == 0.0 && (error_id - 3.0).abs() < 0.5, "{name}, {flip:?}: {x_drive}, {error_id}");
            flipped += 1;
        }
    }
    assert!(flipped > 300, "{flipped}");
}

/// Each how many bits flip.
fn every() -> usize {
    by_depth(37, 37, 1)
}

/// An offered set is taken over in the end, whatever bit flips in its first check, in the check of the copy, or in the fade.
#[test]
fn a_flipped_bit_keeps_no_set_away() {
    let mut away = Vec::new();
    for (name, designed, block) in subjects().into_iter().filter(|(.., block)| block.for_axis.program.has_set()) {
        let bench = Bench::of(&designed, &block);
        for before in [5, 60, 150] {
            let lost = |flip: &(usize, usize)| !bench.takes_a_set(*flip, before, 700);
            let flips: Vec<_> = bench.flips(every()).into_par_iter().filter(lost).collect();
            away.extend(flips.iter().map(|(at, bit)| {
                let path = &block.program.state[*at].path;
                format!("{name}: bit {bit} of {path} before cycle {before}")
            }));
        }
    }
    assert!(away.is_empty(), "{} sets:\n{}", away.len(), away.join("\n"));
}

#[test]
fn a_flipped_bit_of_the_state_is_reported_or_harmless() {
    let mut silent = Vec::new();
    for (name, designed, block) in subjects() {
        let bench = Bench::of(&designed, &block);
        let flips = bench.flips(every());
        let table = flips.par_iter().map(|flip| bench.run(*flip)).reduce(Table::default, Table::and);
        eprintln!(
            "{name}: {} bits, {} reported (numbers in use within {} cycles, stated {}), {} harmless, {} silent",
            flips.len(),
            table.reported,
            table.latest,
            bench.stated(),
            table.harmless,
            table.silent
        );
        assert!(table.latest <= bench.stated(), "{name}");
        silent.extend(table.places.into_keys().map(|place| format!("{name}: {place}")));
    }
    assert!(silent.is_empty(), "{} silent:\n{}", silent.len(), silent[..silent.len().min(40)].join("\n"));
}

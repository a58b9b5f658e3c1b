//! What docs/improved-position-control.md and docs/parameter-sets.md state of the block `ipc`, one sentence a test,
//! against its reference. All kinds of the block: with constants, with weights that the caller tunes, with parameter
//! sets.

#![expect(clippy::float_cmp, reason = "what is nothing, or the same, is that number")]

use axgen_tests::model::subject::read;
use axgen_tests::subject::Subject;
use golden::case::named_block;
use golden::subject;
use machine::closed_loop::Signals;
use std::f64::consts::TAU;

/// Ways to tune.
const TUNABLE: [&str; 3] = ["nothing", "weights", "all"];
/// Cycles of a block of the watch: 30 ms at 5 ms, at least 8.
const LENGTH: usize = 8;
/// 0.1 * 500000 um/s.
const LIMIT: f64 = 50_000.0;

/// A stage of 40 Hz in an axis whose cycle is 5 ms; 20 cycles of fading.
fn axis(tunable: &str, more: &str) -> Subject {
    let mut block = Subject::new(&read(&format!(
        "cycle_time = '5ms'\n[axis.X]\nfade = '100ms'\ntunable = '{tunable}'\n{more}
getriebe = [{{ dynamik.vb_max = 500000 }}]
[axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = 100
stage = [{{ mode = 'DIRECT', weight_fact_num = 1, filter = [{{ order = 1, fg_f0 = 40.0, q_factor = 2.0 }}] }}]\n"
    )));
    // The first cycle presets. A set is checked before.
    block.step(&at(0.0));
    if tunable == "all" {
        wait_for_set(&mut block);
    }
    block
}

/// Cycles at rest until a set is in use.
fn wait_for_set(block: &mut Subject) {
    let waited = (0..200).find(|_| {
        block.step(&at(0.0));
        block.get("active_set") != 0.0
    });
    assert!(waited.is_some(), "no set in use");
}

fn at(v_motor: f64) -> Signals {
    Signals { v_motor, ..Signals::default() }
}

/// A swing at f0, of this amplitude.
fn swing(cycle: usize, amplitude: f64) -> f64 {
    amplitude * (TAU * 0.2 * cycle as f64 + 0.3).sin()
}

/// "span > 2 limit: what is smaller than the limit does not need to be taken out." What grows further trips.
#[test]
fn a_swing_that_grows_below_the_limit_does_not_trip() {
    for tunable in TUNABLE {
        let trips_at = |largest: f64| {
            let mut block = axis(tunable, "watch = true");
            (1..800).find_map(|cycle| {
                let amplitude = (LIMIT / 20.0 * 1.01_f64.powi(i32::try_from(cycle).expect("small"))).min(largest);
                // Growth by more than a tenth from block to block, again and again.
                let grows = 1.2_f64.powi(i32::try_from(cycle / LENGTH % 12).expect("small")) / 8.0;
                block.step(&at(swing(cycle, amplitude * grows)));
                (block.get("tripped") == 1.0).then_some(amplitude * grows)
            })
        };
        assert_eq!(trips_at(0.9 * LIMIT), None, "{tunable}");
        let beyond = trips_at(8.0 * LIMIT);
        assert!(beyond.is_some_and(|amplitude| amplitude > LIMIT), "{tunable}: {beyond:?}");
    }
}

/// A sum that is a fault (error 3) is not a vibration: it trips nothing, in whichever cycle it comes.
#[test]
fn a_fault_of_the_state_trips_nothing() {
    let run = |tunable: &str, blow: usize| {
        let mut block = axis(tunable, "watch = true");
        for cycle in 1..200 {
            // A sample in range that is far above vb_max.
            block.step(&at(if cycle == blow { 1e12 } else { swing(cycle, 4.0 * LIMIT) }));
            if block.get("tripped") == 1.0 {
                return Some(cycle);
            }
            if cycle > blow {
                assert_eq!([block.get("fault"), block.get("error_id")], [1.0, 3.0], "{tunable}");
                return None;
            }
        }
        None
    };
    for tunable in TUNABLE {
        let trips = run(tunable, 1000).expect("it trips");
        for blow in trips - LENGTH..=trips {
            assert_eq!(run(tunable, blow), None, "{tunable}, cycle {blow} of {trips}");
        }
    }
}

/// "Up to n bad samples in a row": a good one between them begins a new row.
#[test]
fn a_good_sample_begins_a_new_row_of_bad_ones() {
    for tunable in TUNABLE {
        let mut block = axis(tunable, "ride_through = 1");
        (1..60).for_each(|cycle| _ = block.step(&at(swing(cycle, 1000.0))));
        for cycle in 60..160 {
            let is_bad = cycle % 2 == 1;
            block.step(&at(if is_bad { f64::NAN } else { swing(cycle, 1000.0) }));
            let found = ["held", "fault"].map(|output| block.get(output));
            assert_eq!(found, [f64::from(u8::from(is_bad)), 0.0], "{tunable}, cycle {cycle}");
        }
        block.step(&at(swing(160, 1000.0)));
        let ids: Vec<f64> = (0..2)
            .map(|_| {
                block.step(&at(f64::NAN));
                block.get("error_id")
            })
            .collect();
        assert_eq!(ids, [0.0, 12.0], "{tunable}: the second bad one in a row");
    }
}

/// The parts of a set by their names, from a block that was generated with them.
fn offer(block: &mut Subject, of: &Subject) {
    let names = ["set_id", "limit", "lower_limit", "sum_limit", "stage[0].gain"];
    let sections = ["b2", "a1", "a2"].map(|name| format!("stage[0].filter[0].bandpass[0].{name}"));
    for name in names.map(str::to_owned).into_iter().chain(sections) {
        let name = format!("params.{name}");
        block.set(&name, of.input(&name));
    }
}

/// Another set of the same structure.
fn other() -> Subject {
    Subject::new(&read(
        "cycle_time = '5ms'\n[axis.X]\nfade = '100ms'\ntunable = 'all'
getriebe = [{ dynamik.vb_max = 500000 }]
[axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = 50
stage = [{ mode = 'DIRECT', weight_fact_num = 2, filter = [{ order = 1, fg_f0 = 30.0, q_factor = 3.0 }] }]\n",
    ))
}

/// "The sections start from the steady state of the present input": also in DRYRUN, where they ran on.
#[test]
fn a_set_is_taken_over_with_fresh_sections() {
    let mut block = axis("all", "");
    let other = other();
    block.set("mode", 2.0);
    (1..60).for_each(|cycle| _ = block.step(&at(swing(cycle, 1000.0))));
    assert!(block.get("v_add_calculated").abs() > 10.0);
    offer(&mut block, &other);
    let copied = (60..200).find(|cycle| {
        block.step(&at(swing(*cycle, 1000.0)));
        block.get("active_set") == 0.0
    });
    assert!(copied.is_some());
    wait_for_set(&mut block);
    assert!(block.get("active_set") == other.input("params.set_id"));
    assert_eq!(block.get("v_add_calculated"), 0.0);
    for _ in 0..20 {
        block.step(&at(0.0));
        assert!(block.get("v_add_calculated").abs() < 1e-6, "a steady velocity is no vibration");
    }
}

/// "If its numbers change after their check, the copy is refused": no set is in use, v_add is 0, and the id is 8 until it is
/// repaired.
#[test]
fn a_set_that_is_damaged_while_the_block_fades_out_is_never_in_use() {
    let mut block = axis("all", "");
    let (own, other) = (block.get("active_set"), other());
    (1..60).for_each(|cycle| _ = block.step(&at(swing(cycle, 1000.0))));
    offer(&mut block, &other);
    let mut told = Vec::new();
    for cycle in 60..500 {
        match cycle {
            // 7 numbers of 4 pieces; the fade of 20 cycles runs.
            95 => block.set("params.stage[0].gain", -1.5),
            300 => offer(&mut block, &other),
            _ => {}
        }
        block.step(&at(swing(cycle, 1000.0)));
        let now = ["active_set", "error_id", "fault"].map(|name| block.get(name));
        assert!(now[0] != 0.0 || block.get("v_add") == 0.0, "cycle {cycle}");
        if told.last() != Some(&now) {
            told.push(now);
        }
    }
    assert_eq!(told.first(), Some(&[own, 0.0, 0.0]));
    assert!(told.contains(&[0.0, 8.0, 1.0]), "{told:?}");
    assert_eq!(told.last(), Some(&[other.input("params.set_id"), 0.0, 0.0]));
}

/// With the limit 0 the watch has no effect: noise trips nothing, and the block acts as soon as the limit is raised.
#[test]
fn with_the_limit_0_the_watch_has_no_effect() {
    let mut block = axis("weights", "watch = true");
    block.set("tuning_limit", 0.0);
    for cycle in 1..800 {
        block.step(&at(swing(cycle, 5.0)));
        assert_eq!(["tripped", "error_id"].map(|output| block.get(output)), [0.0; 2], "cycle {cycle}");
    }
    block.set("tuning_limit", 1.0);
    (800..900).for_each(|cycle| _ = block.step(&at(swing(cycle, 1000.0))));
    assert!((900..905).any(|cycle| block.step(&at(swing(cycle, 1000.0))).abs() > 500.0));
}

/// A refused set "stays refused as long as it is offered": also while the block fades out because the watch has tripped.
#[test]
fn the_id_of_a_refused_set_stays_during_a_trip() {
    let mut block = axis("all", "watch = true");
    block.set("params.set_id", 77.0);
    let ids: Vec<f64> = (1..600)
        .map(|cycle| {
            block.step(&at(swing(cycle, 4.0 * LIMIT)));
            block.get("error_id")
        })
        .collect();
    assert_eq!(block.get("tripped"), 1.0);
    let refused = ids.iter().position(|id| *id == 8.0).expect("it is refused");
    assert!(ids[refused..].iter().all(|id| *id == 8.0), "{:?}", &ids[refused..]);
}

/// "A fraction is 0 after a cycle in which the block axis does not act: it does not read its input then." A limit is
/// lowered during a reset, and the input is NaN afterwards: the old limit does not return.
#[test]
fn a_fraction_that_was_not_read_is_not_used() {
    let designed = read(
        "cycle_time = '5ms'\n[axis.X]\nfade = '100ms'\ntunable = 'weights'\nkenngr.antr_typ = 'CONVENTIONAL'
getriebe = [{ kv = 1000, multi_gain_z = 1000, dynamik.vb_max = 500000 }]
[axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = 100
stage = [{ mode = 'DIRECT', weight_fact_num = 1, filter = [{ order = 1, fg_f0 = 40.0, q_factor = 2.0 }] }]\n",
    );
    let mut axis = subject::Subject::start(&designed, &named_block(&designed, "axis").expect("position control"));
    let of = [(1.0, 0.0, LIMIT, 0.0), (0.02, 1.0, 0.0, 0.0), (f64::NAN, 0.0, 0.0, 4.0), (0.02, 0.0, 0.02 * LIMIT, 0.0)];
    for (limit, reset, largest, error_id) in of {
        assert!(axis.set("tuning_limit", limit) && axis.set("reset", reset));
        let v_add = (0..100).map(|cycle| {
            axis.set("v_motor", swing(cycle, 200_000.0));
            axis.step();
            axis.get("v_add").abs()
        });
        assert_eq!(v_add.fold(0.0, f64::max), largest);
        assert_eq!([axis.get("error_id"), axis.get("fault")], [error_id, 0.0]);
    }
}

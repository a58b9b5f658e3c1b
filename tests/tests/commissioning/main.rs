//! The commissioning page of the shipped example, followed word by word on the demonstration plant: every command is
//! run, every number is used, in the order of the page. In the end both vibrations are below half. A step that is
//! missing, or a number that nobody needs, fails.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::float_cmp, reason = "numbers that were written, and 0, are exact")]
#![expect(clippy::print_stdout, reason = "the documents show these figures")]

mod after;
mod before;
mod machine;
mod page;
mod weights;

use crate::machine::{Machine, Move};
use after::{hand_over, stop, undo};
use axgen_tests::environment;
use before::{connect, dry_run, record};
use page::{Page, Step};
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use weights::weights;

/// What somebody at the machine has found out so far.
struct Session {
    machine: Machine,
    is_tunable: bool,
    /// rest before and after a move [s]
    quiet: f64,
    /// of each stage
    bands: Vec<[f64; 2]>,
    /// of each stage: its amplitude with OFF, and in the row before
    off: Vec<f64>,
    before: Vec<f64>,
    /// the row of the limit: what is written
    limit: f64,
    v_add_max_fact: f64,
    /// checks of a step of a weight [%]: growth of an amplitude, rest of v_add
    growth: f64,
    rest: f64,
    /// time of a fade [s]
    fade: f64,
}

const SENSOR: &str = "the lines of `a_load`";
const LIMIT: &str = "lr_param.improved_position_control.v_add_max_fact";

#[test]
fn the_page_of_a_set_whose_weights_are_inputs() {
    follow(Machine::new(environment::axgen(), "rack-and-pinion.toml", None), true);
}

#[test]
fn the_page_of_a_list() {
    follow(Machine::new(environment::axgen(), "rack-and-pinion.lis", Some("1ms".to_owned())), false);
}

/// A page that somebody has spoilt: each of these was followed to the end once.
#[test]
fn a_spoilt_page_is_found() {
    let changes: [(&str, &str, &str); 5] = [
        ("**1.2** On the controller.", "On the controller.", "a step that is missing"),
        ("as long as `mode` is OFF.", "as long as `mode` is OFF. Wait for 3 s.", "a number that nobody needs"),
        ("between 50.41 and 55.71 Hz", "between 53.41 and 55.71 Hz", "a number that is wrong"),
        ("- `limited` is FALSE. If", "- If", "a condition that is missing"),
        ("| 4.4.2 | 0.2 | 0.6 | 60 | 100 | 63 % | 1 |\n", "", "a row that is missing"),
    ];
    for (from, to, what) in changes.into_iter().take(environment::by_depth(2, 5, 5)) {
        let machine = Machine::new(environment::axgen(), "rack-and-pinion.toml", None);
        let page = generated(&machine).replacen(from, to, 1);
        assert_ne!(page, generated(&machine), "{from}");
        // What it says of that is of no interest here.
        let followed = catch_unwind(AssertUnwindSafe(|| follow_text(machine, &page, true)));
        assert!(followed.is_err(), "{what}");
    }
}

fn follow(machine: Machine, is_tunable: bool) {
    let page = generated(&machine);
    follow_text(machine, &page, is_tunable);
}

/// The page as the command writes it.
fn generated(machine: &Machine) -> String {
    machine.done("axgen generate SET", 0);
    fs::read_to_string(machine.path("generated/axis_rack_and_pinion_commissioning.md")).unwrap()
}

fn follow_text(machine: Machine, page: &str, is_tunable: bool) {
    let mut page = Page::read(page);
    let said = page.head.contains("add `--cycle-time 1000us` to each command");
    assert!(said, "the cycle time that each command gets with a list: {}", page.head);
    let mut session = Session {
        machine,
        is_tunable,
        quiet: 0.0,
        bands: Vec::new(),
        off: Vec::new(),
        before: Vec::new(),
        limit: 0.0,
        v_add_max_fact: 0.0,
        growth: 0.0,
        rest: 0.0,
        fade: 0.0,
    };
    connect(&mut session, &mut page);
    record(&mut session, &mut page);
    dry_run(&mut session, &mut page);
    weights(&mut session, &mut page);
    stop(&mut session, &mut page);
    undo(&mut session, &mut page);
    hand_over(&mut session, &mut page);
    page.done();
}

impl Session {
    fn write(&mut self, step: &mut Step) {
        step.writes().iter().for_each(|(input, value)| self.machine.set(input, *value));
    }

    /// A move, as step 2.1 says.
    fn make_move(&mut self) -> Move {
        self.machine.make_move(self.quiet)
    }

    /// The amplitude of each stage, read as section 2 says: DIRECT at the motor, INDIRECT at the load.
    fn amplitudes(&self, of: &Move) -> Vec<f64> {
        vec![of.of_motor(self.bands[0]), of.of_load_at_ramps(self.bands[1])]
    }

    /// v_add or v_add_calculated has gone where the axis rests.
    fn has_gone(&self, of: &Move, signal: &[f64], percent: f64) {
        let [rest, peak] = of.rest_and_peak(signal);
        assert!(rest < percent / 100.0 * peak, "{rest} at rest, {peak} at the most");
    }
}

//! The commissioning page of the shipped example, followed word by word on the demonstration plant: every command is run, every number is used, in the
//! order of the page. In the end both vibrations are below half. A step that is missing, or a number that nobody needs, fails.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod machine;
mod page;

use axgen_tests::environment;
use axgen_tests::plant::measure::{figures, spectrum};
use machine::{Machine, Move, mean};
use page::{Page, Step, Table};

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

const SENSOR: &str = "the sensor at the load (it need not show in the velocity of the motor)";
/// What this machine needs [m].
const FOLLOWING_ERROR: f64 = 3e-3;
const LIMIT: &str = "lr_param.improved_position_control.v_add_max_fact";

#[test]
fn the_page_of_a_set_whose_weights_are_inputs() {
    follow(Machine::new(environment::axgen(), "rack-and-pinion.toml", None), true);
}

#[test]
fn the_page_of_a_list() {
    follow(Machine::new(environment::axgen(), "rack-and-pinion.lis", Some("1ms".to_owned())), false);
}

fn follow(machine: Machine, is_tunable: bool) {
    machine.done("axgen generate SET", 0);
    let name = machine.path("generated/axis_rack_and_pinion_commissioning.md");
    let mut page = Page::read(&std::fs::read_to_string(name).unwrap());
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

fn connect(session: &mut Session, page: &mut Page) {
    page.section("1");
    let mut step = page.step("1.1");
    assert_eq!(step.commands, ["axgen check SET", "axgen verify SET"]);
    session.machine.done(&step.commands[0], 0);
    let verified = session.machine.done(&step.commands[1], 0);
    let bits = format!("{}", step.number("must show ", " differing bits for each engine"));
    let rows: Vec<&str> = verified.lines().filter(|line| line.starts_with("rack_and_pinion  ")).collect();
    assert!(rows.len() > 5 && rows[1..].iter().all(|row| row.split_whitespace().last() == Some(&bits)), "{verified}");
    step.done();

    // The test golden.rs runs the self-tests; here it is there.
    let step = page.step("1.2");
    step.says("Run the self-test of the block");
    assert!(session.machine.path(&format!("generated/{}.st", step.name("of the block, ", ". It must"))).exists());
    step.done();

    let mut step = page.step("1.3");
    session.write(&mut step);
    step.says("`fault` must be FALSE");
    let cycle = step.number("It must be ", " ns");
    for (written, error) in [(cycle + 1.0, 1.0), (cycle, 0.0)] {
        session.machine.set("task_cycle_ns", written);
        session.machine.rest(0.01);
        assert_eq!((session.machine.get("fault"), session.machine.get("error_id")), (error, error));
    }
    let explained = session.machine.command("axgen explain 1").1;
    step.says("`axgen explain` with the number of `error_id`");
    assert!(explained.contains("task_cycle_ns"), "{explained}");
    step.done();

    let mut step = page.step("1.4");
    step.says("Move the axis forward at a constant velocity");
    step.says("It must be positive");
    let window = step.number("over ", " s");
    let agreement = step.number("within ", " %");
    let table = step.tables[0].clone();
    assert_eq!(table.rows.iter().map(|row| row[0].as_str()).collect::<Vec<_>>(), ["`v_motor`"]);
    let run = session.machine.make_move(1.0);
    let dwell = run.dwell();
    assert!(window <= dwell.len() as f64 * run.record.cycle);
    let v_motor = mean(run.record.signals[dwell.clone()].iter().map(|signals| signals.v_ist1));
    let command = run.record.v_command[dwell.start] * 1e6;
    assert!(v_motor > 0.0 && (v_motor / command - 1.0).abs() <= agreement / 100.0, "{v_motor} {command}");
    step.done();

    let mut step = page.step("1.5");
    step.says("Add `v_add` to the velocity command behind the position controller, with the sign +");
    let exactly = step.number("must be exactly ", " as long as `mode` is OFF");
    assert!(run.record.v_add.iter().all(|v_add| *v_add == exactly));
    step.done();
}

fn record(session: &mut Session, page: &mut Page) {
    page.section("2");
    let mut step = page.step("2.1");
    session.write(&mut step);
    session.quiet = step.number("rest for ", " s before it");
    step.done();
    let run = session.make_move();
    for (n, row) in page.stages.rows.clone().into_iter().enumerate() {
        let mut step = page.step(&format!("2.{}", n + 2));
        let window = step.number("at least ", " s in which");
        let f0 = step.number("highest peak around ", " Hz.");
        let low = step.number("must lie between ", " and ");
        let band = [low, step.number("must lie between # and ", " Hz. Note its amplitude")];
        assert!(band[1] > band[0], "{band:?}");
        let is_direct = row[page.stages.column("mode")] == "DIRECT";
        step.says(if is_direct { "the spectrum of `v_motor`" } else { SENSOR });
        for path in [step.name("write this frequency to ", ", generate"), step.name("write NOT_ACTIVE to ", ".")] {
            assert!(path.starts_with(&format!("lr_param.improved_position_control.stage[{n}].")), "{path}");
        }
        let v: Vec<f64> = run.record.signals.iter().map(|signals| signals.v_ist1).collect();
        let (signal, part) = if is_direct {
            (v.as_slice(), run.dwell())
        } else {
            let [start, _] = run.record.ramps[0];
            (run.record.sensor.as_slice(), start..start + 1000)
        };
        assert!(window <= part.len() as f64 * run.record.cycle);
        let largest = highest_peak(&signal[part], run.record.cycle, [f0 / 2.0, f0 * 2.0]);
        assert!(band[0] < largest[0] && largest[0] < band[1], "stage {n}: {largest:?}, {band:?}");
        session.bands.push(band);
        step.done();
    }
    session.off = session.amplitudes(&run);
}

/// Frequency [Hz] and amplitude of the highest peak within a band [Hz] of a spectrum. The mean is no vibration.
fn highest_peak(signal: &[f64], cycle: f64, around: [f64; 2]) -> [f64; 2] {
    let level = mean(signal.iter().copied());
    let vibration: Vec<f64> = signal.iter().map(|sample| sample - level).collect();
    let lines = spectrum(&vibration, cycle, around);
    let peaks = lines.windows(3).filter(|three| three[0][1] < three[1][1] && three[1][1] > three[2][1]);
    peaks.map(|three| three[1]).max_by(|a, b| a[1].total_cmp(&b[1])).unwrap()
}

fn dry_run(session: &mut Session, page: &mut Page) {
    page.section("3");
    let mut step = page.step("3.1");
    session.write(&mut step);
    step.done();
    let run = session.make_move();

    let mut step = page.step("3.2");
    let exactly = step.number("`v_add` is exactly ", ".");
    assert!(run.record.v_add.iter().all(|v_add| *v_add == exactly));
    step.says("`limited` is FALSE");
    assert!(!run.was_limited);
    step.says("`v_add_calculated` has both signs");
    let calculated = &run.v_add_calculated;
    assert!(calculated.iter().any(|v| *v > 0.0) && calculated.iter().any(|v| *v < 0.0));
    let [_, peak] = run.rest_and_peak(calculated);
    let part = step.number("its mean is less than ", " % of its peak");
    let at_speed = mean(calculated[run.dwell()].iter().copied());
    assert!(at_speed.abs() < part / 100.0 * peak, "{at_speed} {peak}");
    assert_eq!(step.number("", " s after the axis has come to rest"), session.quiet);
    let part = step.number("`v_add_calculated` is less than ", " % of its peak");
    session.has_gone(&run, calculated, part);
    step.done();

    let mut step = page.step("3.3");
    let reserve = step.number("Take the peak of `v_add_calculated` ", " times");
    step.says("The first limit in this table that is larger is your limit");
    let table = step.tables[0].clone();
    assert_eq!(table.rows.len(), 6);
    for row in &table.rows {
        let [limit, fact] = [table.number(row, "limit [um/s]", ""), table.number(row, "`v_add_max_fact`", "")];
        assert_eq!(limit, fact * 530.0);
        assert!(!session.is_tunable || table.number(row, "`tuning_limit`", "") * 530_000.0 == limit);
    }
    let row = table.rows.iter().find(|row| table.number(row, "limit [um/s]", "") > reserve * peak).unwrap();
    session.v_add_max_fact = table.number(row, "`v_add_max_fact`", "");
    session.limit = if session.is_tunable { table.number(row, "`tuning_limit`", "") } else { session.v_add_max_fact };
    step.done();
}

fn weights(session: &mut Session, page: &mut Page) {
    page.section("4");
    let mut step = page.step("4.1");
    if session.is_tunable {
        session.write(&mut step);
        step.says("your limit of step 3.3 to `tuning_limit`");
        session.machine.set("tuning_limit", session.limit);
        let exactly = step.number("`v_add` must be exactly ", ".");
        assert!(session.make_move().record.v_add.iter().all(|v_add| *v_add == exactly));
    } else {
        step.says("Copy `SET`, and the files that it names, into a new folder `trial`");
        session.machine.copy("trial");
        assert_eq!(step.name("your limit of step 3.3 to ", ", NOT_ACTIVE to "), LIMIT);
        session.machine.write("trial/SET", LIMIT, &session.v_add_max_fact.to_string());
        let path = step.name("NOT_ACTIVE to ", ".");
        assert!(path.ends_with(".mode"), "{path}");
        session.machine.write("trial/SET", &path, "NOT_ACTIVE");
    }
    step.done();

    let mut step = page.step("4.2");
    step.says("Make the move of step 2.1 and record it");
    let fade = if session.is_tunable { "The weight follows within " } else { "and wait for " };
    session.fade = step.number(fade, " ms") / 1000.0;
    let how = Step4::of(session, &mut step);
    step.done();

    let mut step = page.step("4.3");
    step.says("The amplitude at the f0 of each stage, read as in section 2,");
    session.growth = step.number("has not grown by more than ", " % since the row before");
    step.says("`limited` is FALSE");
    assert_eq!(step.number("", " s after the axis has come to rest"), session.quiet);
    step.says("The following error is as small as your machine needs it");
    session.rest = step.number("`v_add` is less than ", " % of its peak");
    step.done();

    session.before.clone_from(&session.off);
    for (n, stage) in page.stages.rows.clone().into_iter().enumerate() {
        let mut step = page.step(&format!("4.{}", n + 4));
        let f0 = step.number(&format!("Stage {n}, "), " Hz.");
        assert!(session.bands[n][0] < f0 && f0 < session.bands[n][1], "{f0}");
        if !session.is_tunable && n > 0 {
            let path = step.name("First write INDIRECT to ", ".");
            session.machine.write("trial/SET", &path, "INDIRECT");
        }
        let table = step.tables[0].clone();
        let designed: f64 = stage[page.stages.column("weight")].parse().unwrap();
        assert_eq!(table.number(table.rows.last().unwrap(), "weight", ""), designed, "the last row is the design");
        let mut last = 0.0;
        for (r, row) in table.rows.iter().enumerate() {
            assert_eq!(row[0], format!("4.{}.{}", n + 4, r + 1));
            let weight = table.number(row, "weight", "");
            assert!(weight > last && weight <= last + 0.2001 * designed, "{last} -> {weight}: a large step");
            last = weight;
            one_row(session, &how, n, &table, row);
        }
        step.done();
    }
}

/// How step 4.2 goes.
#[derive(Default)]
struct Step4 {
    writes: [Vec<(String, f64)>; 2],
    command: Option<String>,
}

impl Step4 {
    fn of(session: &Session, step: &mut Step) -> Self {
        if session.is_tunable {
            step.says("write the number of the row to the input");
            return Self::default();
        }
        let writes = step.writes();
        assert_eq!(writes.len(), 2, "OFF before, ON behind the change: {writes:?}");
        step.says("Load the new block at standstill");
        Self { writes: [vec![writes[0].clone()], vec![writes[1].clone()]], command: step.commands.first().cloned() }
    }
}

fn one_row(session: &mut Session, how: &Step4, stage: usize, table: &Table, row: &[String]) {
    let [num, denom] = ["`weight_fact_num`", "`weight_fact_denom`"].map(|head| table.number(row, head, ""));
    let weight = table.number(row, "weight", "");
    assert!((num / denom / weight - 1.0).abs() < 1e-3, "{row:?}");
    write_row(session, how, stage, table, row);
    let run = session.make_move();
    assert!(!run.was_limited);
    session.has_gone(&run, &run.record.v_add, session.rest);
    assert!(figures(&run.record).following_error < FOLLOWING_ERROR, "{row:?}");
    let now = session.amplitudes(&run);
    for (now, before) in now.iter().zip(&session.before) {
        assert!(*now <= before * (1.0 + session.growth / 100.0), "{row:?}: {before} -> {now}");
    }
    let left = table.number(row, "left at best", "%") / 100.0;
    assert!(now[stage] < session.before[stage], "{row:?}: nothing has become better");
    assert!(now[stage] / session.off[stage] >= left - 0.01, "{row:?}: {}", now[stage] / session.off[stage]);
    let part: Vec<f64> = now.iter().zip(&session.off).map(|(now, off)| now / off).collect();
    println!("row {}: left of each stage's amplitude: {part:.2?}", row[0]);
    session.before = now;
}

fn write_row(session: &mut Session, how: &Step4, stage: usize, table: &Table, row: &[String]) {
    if session.is_tunable {
        let input = format!("tuning_weight{stage}");
        session.machine.set(&input, table.number(row, &format!("`{input}`"), ""));
        return;
    }
    how.writes[0].iter().for_each(|(input, value)| session.machine.set(input, *value));
    let faded = session.machine.rest(session.fade + 0.001);
    assert_eq!(faded.last(), Some(&0.0));
    for name in ["weight_fact_num", "weight_fact_denom"] {
        let path = format!("lr_param.improved_position_control.stage[{stage}].{name}");
        session.machine.write("trial/SET", &path, &table.number(row, &format!("`{name}`"), "").to_string());
    }
    session.machine.done(how.command.as_deref().unwrap(), 0);
    session.machine.load("trial/SET");
    how.writes[1].iter().for_each(|(input, value)| session.machine.set(input, *value));
}

fn stop(session: &mut Session, page: &mut Page) {
    let step = page.step("5");
    let table = step.tables[0].clone();
    for seen in ["`limited` is TRUE", "goes on vibrating", "amplitude grows", "rough at rest", "`fault` is TRUE"] {
        assert!(table.rows.iter().any(|row| row[0].contains(seen)), "when to stop: {seen}");
    }
    let of_tuning = table.rows.iter().find(|row| row[0].starts_with("`error_id` is "));
    assert_eq!(of_tuning.is_some(), session.is_tunable);
    if let Some(row) = of_tuning {
        let id: f64 = row[0].rsplit(' ').next().unwrap().parse().unwrap();
        assert!(row[1].contains("no number from 0 to 1"), "{row:?}");
        for (value, error) in [(1.5, id), (-0.5, id), (f64::NAN, id), (1.0, 0.0)] {
            session.machine.set("tuning_weight0", value);
            session.machine.rest(0.01);
            assert_eq!((session.machine.get("error_id"), session.machine.get("fault")), (error, 0.0), "{value}");
        }
    }
    let all: Vec<&String> =
        table.rows.iter().flatten().filter(|cell| cell.contains(|c: char| c.is_ascii_digit())).collect();
    let expected = if session.is_tunable { 3 } else { 0 };
    let with_numbers = all.iter().filter(|cell| !cell.contains("f0") && !cell.contains("filter[1]")).count();
    assert_eq!(with_numbers, expected, "{all:?}");
    step.says("Write OFF to `mode`, as section 6 says");
    step.done();
}

fn undo(session: &mut Session, page: &mut Page) {
    page.section("6");
    let mut step = page.step("6.1");
    if session.is_tunable {
        step.says("write the number of the row above");
        assert_eq!(step.number("within ", " ms") / 1000.0, session.fade);
    } else {
        step.says("do step 4.2 with the row above");
    }
    step.done();

    let mut step = page.step("6.2");
    session.write(&mut step);
    let [exactly, after] = [step.number("`v_add` is exactly ", " after "), step.number("is exactly # after ", " ms")];
    session.machine.rest(after / 1000.0 + 0.001);
    assert_eq!(session.machine.get("v_add"), exactly);
    step.done();

    let mut step = page.step("6.3");
    session.machine.set("mode", 1.0);
    session.make_move();
    let writes = step.writes();
    assert_eq!(writes.len(), 3, "{writes:?}");
    let exactly = step.number("`v_add` is exactly ", " in the same cycle");
    let mut reset = 0;
    // It is written in the midst of a move.
    session.machine.set("mode", 1.0);
    for (input, value) in &writes {
        session.machine.set(input, *value);
        let v_add = session.machine.rest(0.001);
        reset += usize::from(v_add == [exactly]);
    }
    assert_eq!(reset, 3);
    step.done();
}

fn hand_over(session: &mut Session, page: &mut Page) {
    page.section("7");
    let mut step = page.step("7.1");
    let writes = step.writes();
    assert_eq!(writes.len(), 2, "{writes:?}");
    let wait = step.number("# for ", " ms") / 1000.0;
    assert_eq!(wait, session.fade);
    let name = step.name("Save the record as ", ",");
    let bits = step.number("There must be ", " differing bits");
    session.machine.set(&writes[0].0, writes[0].1);
    session.machine.rest(wait + 0.001);
    session.machine.start_recording();
    session.machine.set(&writes[1].0, writes[1].1);
    session.make_move();
    session.machine.save(&name);
    assert_eq!(step.commands.len(), 1);
    let compared = session.machine.done(&step.commands[0], 0);
    assert!(compared.contains(&format!(": {bits} differing bits")), "{compared}");
    step.done();

    let mut step = page.step("7.2");
    if session.is_tunable {
        // All rows were done: the weights are those of the set.
        step.says("If you stayed at a row before the last one, write its `weight_fact_num` and `weight_fact_denom` to the stage in `SET`");
        assert_eq!(step.name("Write the `v_add_max_fact` of your limit to ", "."), LIMIT);
        session.machine.write("SET", LIMIT, &session.v_add_max_fact.to_string());
        session.machine.done("axgen generate SET", 0);
        session.machine.load("SET");
        session.write(&mut step);
    } else {
        assert_eq!(step.commands, ["axgen diff SET trial/SET"]);
        let changed = session.machine.done(&step.commands[0], 1);
        assert!(changed.lines().all(|line| line.contains(": limit ")), "the weights are designed again: {changed}");
        step.says("copy `trial/SET` over `SET`, and generate");
        std::fs::copy(session.machine.path("trial/rack-and-pinion.lis"), session.machine.path("rack-and-pinion.lis"))
            .unwrap();
        session.machine.done("axgen generate SET", 0);
        session.machine.load("SET");
    }
    step.done();

    let step = page.step("7.3");
    let path = step.name("Write to ", " how the block starts: ON, DRYRUN or OFF");
    session.machine.write("SET", &path, "ON");
    session.machine.done("axgen generate SET", 0);
    session.machine.load("SET");
    step.done();
    // The block as it stays with the machine: both vibrations, where the plant's table has them.
    let with = session.make_move();
    session.machine.set("mode", 0.0);
    let off = session.make_move();
    let [at_speed, at_ramps] = [[50.0, 56.0], [9.5, 12.5]];
    let left = [
        with.of_load_at_speed(at_speed) / off.of_load_at_speed(at_speed),
        with.of_load_at_ramps(at_ramps) / off.of_load_at_ramps(at_ramps),
    ];
    println!("left of 53 Hz and 11 Hz: {left:.3?}");
    assert!(left.iter().all(|left| *left < 0.5), "{left:?}");
}

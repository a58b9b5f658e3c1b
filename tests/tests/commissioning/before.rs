//! Sections 1 to 3 of the page: what is done before anything is added.

use crate::machine::mean;
use crate::page::Page;
use crate::{SENSOR, Session};
use machine::sequence::Sequence;
use serde_json::Value;

pub fn connect(session: &mut Session, page: &mut Page) {
    page.section("1");
    let mut step = page.step("1.1");
    assert_eq!(step.commands, ["axgen check SET", "axgen verify SET"]);
    session.machine.done(&step.commands[0], 0);
    let verified = session.machine.done(&step.commands[1], 0);
    let bits = format!("{}", step.number("must show ", " differing bits for each engine"));
    let is_row = |line: &&str| line.starts_with("rack_and_pinion  ") && !line.contains("reached:");
    let rows: Vec<&str> = verified.lines().filter(is_row).collect();
    assert!(rows.len() > 5 && rows[1..].iter().all(|row| row.split_whitespace().last() == Some(&bits)), "{verified}");
    step.done();

    // The test golden.rs runs the self-tests; here it is there.
    let mut step = page.step("1.2");
    step.says("Run the self-test of the block");
    assert!(session.machine.path(&format!("generated/{}.st", step.name("of the block, ", ". It must"))).exists());
    let differing = [step.number("a function returns ", ";"), step.number("and `differing` is ", ".")];
    assert_eq!(differing, [0.0; 2]);
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
    let v_motor = mean(run.record.signals[dwell.clone()].iter().map(|signals| signals.v_motor));
    let command = run.record.v_planned[dwell.start] * 1e6;
    assert!(v_motor > 0.0 && (v_motor / command - 1.0).abs() <= agreement / 100.0, "{v_motor} {command}");
    step.done();

    let mut step = page.step("1.5");
    step.says("Add `v_add` to the velocity command after the position controller, with the sign +");
    let exactly = step.number("must be exactly ", " as long as `mode` is OFF");
    assert!(run.record.v_add.iter().all(|v_add| *v_add == exactly));
    step.done();
}

pub fn record(session: &mut Session, page: &mut Page) {
    page.section("2");
    let mut step = page.step("2.1");
    session.write(&mut step);
    session.quiet = step.number("rest for ", " s before each move");
    let speed_for = step.number("constant velocity for at least ", " s");
    step.says("Save the record as `moves.csv`");
    let names: Vec<String> = step.tables[0].rows.iter().map(|row| row[0].trim_matches('`').to_owned()).collect();
    step.done();
    let run = session.make_move();
    assert!(speed_for <= Sequence::DEMONSTRATION.dwell);
    session.machine.write_moves("moves.csv", &names, &run.record);

    let step = page.step("2.2");
    let command = step.commands[0].clone();
    step.done();
    session.machine.done(&command, 0);
    let report: Value = serde_json::from_str(&session.machine.done(&format!("{command} --json"), 0)).unwrap();

    for (n, row) in page.stages.rows.clone().into_iter().enumerate() {
        let mut step = page.step(&format!("2.{}", n + 3));
        let f0 = step.number("strongest vibration near ", " Hz");
        let low = step.number("must lie between ", " and ");
        let band = [low, step.number("must lie between # and ", " Hz. Note its amplitude")];
        assert!(band[0] < f0 && f0 < band[1], "{band:?}");
        let is_direct = row[page.stages.column("mode")] == "DIRECT";
        step.says(if is_direct { "the lines of `v_motor`" } else { SENSOR });
        for path in [step.name("write this frequency to ", ". Then generate"), step.name("write NOT_ACTIVE to ", ".")] {
            assert!(path.starts_with(&format!("lr_param.improved_position_control.stage[{n}].")), "{path}");
        }
        let channel = if is_direct { "v_motor" } else { "a_load" };
        let strongest = strongest(&report, channel, [f0 / 2.0, f0 * 2.0]);
        assert!(band[0] < strongest && strongest < band[1], "stage {n}: {strongest} Hz, {band:?}");
        session.bands.push(band);
        step.done();
    }
    session.off = session.amplitudes(&run);
}

/// Frequency [Hz] of the strongest vibration of a channel within a band [Hz], in a report of `axgen measure`.
fn strongest(report: &Value, channel: &str, around: [f64; 2]) -> f64 {
    let of = |vibration: &Value, key: &str| vibration[key].as_f64().unwrap();
    let all = report["vibrations"].as_array().unwrap().iter();
    let near = all.filter(|vibration| vibration["channel"] == channel);
    let near = near.filter(|vibration| (around[0]..around[1]).contains(&of(vibration, "hz")));
    let strongest = near.max_by(|a, b| of(a, "amplitude").total_cmp(&of(b, "amplitude")));
    of(strongest.unwrap_or_else(|| panic!("{channel} {around:?}: {report:#}")), "hz")
}

pub fn dry_run(session: &mut Session, page: &mut Page) {
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

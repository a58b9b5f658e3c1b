//! Sections 5 to 7 of the page: when to stop, how to undo, how to hand over.

use crate::page::Page;
use crate::{LIMIT, Session};

pub fn stop(session: &mut Session, page: &mut Page) {
    let step = page.step("5");
    let table = step.tables[0].clone();
    for seen in ["`limited` is TRUE", "goes on vibrating", "amplitude grows", "rough at rest", "`fault` is TRUE"] {
        assert!(table.rows.iter().any(|row| row[0].contains(seen)), "when to stop: {seen}");
    }
    let of_tuning = table.rows.iter().find(|row| row[0].starts_with("`error_id` is "));
    assert_eq!(of_tuning.is_some(), session.is_tunable);
    if let Some(row) = of_tuning {
        let id: f64 = row[0].rsplit(' ').next().unwrap().parse().unwrap();
        assert!(row[1].contains("not a number from 0 to 1") && row[2] == "write a number from 0 to 1", "{row:?}");
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

pub fn undo(session: &mut Session, page: &mut Page) {
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
    assert_eq!(after / 1000.0, session.fade);
    session.machine.rest(after / 1000.0 + 0.001);
    assert_eq!(session.machine.get("v_add"), exactly);
    step.done();

    let mut step = page.step("6.3");
    session.machine.set("mode", 1.0);
    session.make_move();
    let writes = step.writes();
    assert_eq!(writes, [("reset", 1.0), ("mode", 0.0), ("reset", 0.0)].map(|(input, value)| (input.to_owned(), value)));
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

pub fn hand_over(session: &mut Session, page: &mut Page) {
    page.section("7");
    let mut step = page.step("7.1");
    let writes = step.writes();
    assert_eq!(writes, [0.0, 1.0].map(|mode| ("mode".to_owned(), mode)));
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
        let path = step.name("Write to ", " how the block starts: ON, DRYRUN or OFF");
        session.machine.write("SET", &path, "ON");
        session.machine.done("axgen generate SET", 0);
        session.machine.load("SET");
        session.write(&mut step);
        session.machine.rest(0.01);
        assert_eq!(session.machine.get("error_id"), 0.0);
    } else {
        let path = step.name("Write to ", " in `trial/SET` how the block starts: ON, DRYRUN or OFF");
        session.machine.write("trial/SET", &path, "ON");
        assert_eq!(step.commands, ["axgen diff SET trial/SET"]);
        let changed = session.machine.done(&step.commands[0], 1);
        let is_wanted = |line: &str| line.contains(": limit ") || line.contains(": starts ");
        assert!(changed.lines().all(is_wanted), "the weights are designed again: {changed}");
        step.says("copy `trial/SET`, and the files that it names, over `SET` and those that it names. Then generate");
        std::fs::copy(session.machine.path("trial/rack-and-pinion.lis"), session.machine.path("rack-and-pinion.lis"))
            .unwrap();
        session.machine.done("axgen generate SET", 0);
        session.machine.load("SET");
    }
    step.done();

    page.step("7.3").done();
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

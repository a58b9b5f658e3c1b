//! Section 4 of the page: the weights in steps.

use crate::page::{Page, Step, Table};
use crate::{LIMIT, Session};
use machine::measure::figures;

/// What this machine needs [m].
const FOLLOWING_ERROR: f64 = 3e-3;

/// Above it a loop has little reserve.
const MAX_MS: f64 = 2.0;

pub fn weights(session: &mut Session, page: &mut Page) {
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
        assert_eq!(step.number("the largest amplification of the loop with this drive: above ", " it has"), MAX_MS);
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
        assert_eq!(writes.len(), 2, "OFF before, ON after the change: {writes:?}");
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
    assert!(table.number(row, "Ms", "") < MAX_MS, "{row:?}");
    let left = table.number(row, "left at best", "%") / 100.0;
    assert!(now[stage] < session.before[stage], "{row:?}: nothing has become better");
    assert!(now[stage] / session.off[stage] >= left - 0.03, "{row:?}: {}", now[stage] / session.off[stage]);
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

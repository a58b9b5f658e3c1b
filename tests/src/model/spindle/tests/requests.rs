//! Which requests count: sections 1 and 7 of a cycle. No formula is here.

use super::bench::Bench;
use crate::model::spindle::Inputs;

/// Error, job and waiting after one cycle of inputs in POSITION.
fn after(change: impl FnOnce(&mut Inputs)) -> (u32, i32, u32) {
    let mut bench = Bench::drive().positioned();
    let out = bench.once(change);
    (out.error_id, out.job, out.job_number)
}

#[test]
fn of_several_the_first_in_the_ranking_counts() {
    assert_eq!(after(|i| i.g74 = true), (0, 4, 1));
    assert_eq!(after(|i| (i.g74, i.putax) = (true, true)), (31, 4, 1));
    assert_eq!(after(|i| (i.putax, i.m19) = (true, true)), (31, 3, 1));
    assert_eq!(after(|i| (i.m19, i.m5) = (true, true)), (31, 2, 1));
    assert_eq!(after(|i| (i.m5, i.m3) = (true, true)), (31, 0, 1));
    assert_eq!(after(|i| (i.m5, i.m4) = (true, true)), (31, 0, 1));
    assert_eq!(after(|i| (i.g74, i.m3, i.m4) = (true, true, true)), (31, 4, 1));
    assert_eq!(after(|i| (i.m19, i.m3) = (true, true)), (0, 2, 1));
    assert_eq!(after(|i| (i.m19, i.m4) = (true, true)), (0, 2, 1));
    // With M19 no request of its own, even where another one counts.
    assert_eq!(after(|i| (i.g74, i.m19, i.m3) = (true, true, true)), (31, 4, 1));
}

#[test]
fn of_a_refused_request_and_others_only_the_refusal_is_told_and_all_are_lost() {
    assert_eq!(after(|i| (i.m19, i.m5, i.s_word) = (true, true, f64::NAN)), (33, 0, 0));
    assert_eq!(after(|i| (i.m19, i.m5, i.s_position) = (true, true, f64::NAN)), (34, 0, 0));
    assert_eq!(after(|i| (i.m19, i.m5, i.m3, i.m4) = (true, true, true, true)), (32, 0, 0));
    assert_eq!(after(|i| (i.g74, i.m5, i.drive_on) = (true, true, false)), (36, 0, 0));
    // One that does not count is not read.
    assert_eq!(after(|i| (i.m5, i.m3, i.s_word) = (true, true, f64::NAN)), (31, 0, 1));
}

#[test]
fn the_reasons_have_an_order() {
    let all = |i: &mut Inputs| {
        (i.m19, i.m3, i.m4, i.drive_on) = (true, true, true, false);
        (i.s_word, i.s_position) = (f64::NAN, f64::NAN);
    };
    let changes: [fn(&mut Inputs); 4] = [|_| {}, |i| i.m3 = false, |i| i.s_word = 1.0, |i| i.s_position = 1.0];
    let mut told = Vec::new();
    for number in 1..=4 {
        told.push(after(|i| {
            all(i);
            changes[..number].iter().for_each(|change| change(i));
        }));
    }
    assert_eq!(told, [(32, 0, 0), (33, 0, 0), (34, 0, 0), (36, 0, 0)]);
    // The drive goes off while four wait; they are lost too.
    let mut bench = Bench::drive().positioned();
    bench.once(|i| i.g74 = true);
    for _ in 0..4 {
        bench.cycle();
        bench.once(|i| i.m5 = true);
    }
    bench.cycle();
    assert_eq!(bench.out.waiting, 4);
    let out = bench.once(|i| (i.m5, i.drive_on) = (true, false));
    assert_eq!((out.error_id, out.waiting, out.job), (36, 0, 0));
}

#[test]
fn what_is_true_in_the_first_cycle_does_not_count() {
    let mut bench = Bench::drive();
    (bench.inputs.m5, bench.inputs.m3, bench.inputs.m4) = (true, true, true);
    let out = bench.cycles(9);
    assert_eq!((out.spindle_state, out.waiting, out.job_number, out.error_id), (0, 0, 0, 0));
    bench.once(|i| i.m5 = false);
    assert_eq!(bench.cycle().job_number, 1);
    // The cycle in which the drive is on again is not the first one.
    bench.inputs.m5 = false;
    bench.once(|i| i.drive_on = false);
    bench.once(|i| i.m5 = true);
    assert_eq!((bench.cycle().job_number, bench.out.error_id), (2, 0));
}

#[test]
fn m3_and_m4_together_are_refused() {
    assert_eq!(after(|i| (i.m3, i.m4) = (true, true)), (32, 0, 0));
    assert_eq!(after(|i| (i.m19, i.m3, i.m4) = (true, true, true)), (32, 0, 0));
    // M5 counts, and M3 and M4 are one too many.
    assert_eq!(after(|i| (i.m5, i.m3, i.m4) = (true, true, true)), (31, 0, 1));
    // One that stays TRUE.
    let mut bench = Bench::drive().positioned();
    bench.inputs.m3 = true;
    assert_eq!((bench.cycle().error_id, bench.out.job_number), (0, 1));
    assert_eq!((bench.once(|i| i.m4 = true).error_id, bench.out.job_number), (32, 1));
}

#[test]
fn an_s_word_or_a_position_that_is_none_is_refused_where_it_is_read() {
    for bad in [f64::NAN, f64::INFINITY, 1.000_000_1e15, -1.000_000_1e15] {
        assert_eq!(after(|i| (i.m3, i.s_word) = (true, bad)), (33, 0, 0));
        assert_eq!(after(|i| (i.m4, i.s_word) = (true, bad)), (33, 0, 0));
        assert_eq!(after(|i| (i.m19, i.s_word) = (true, bad)), (33, 0, 0));
        assert_eq!(after(|i| (i.m19, i.s_position) = (true, bad)), (34, 0, 0));
        assert_eq!(after(|i| (i.m5, i.s_word, i.s_position) = (true, bad, bad)), (0, 0, 1));
        assert_eq!(after(|i| (i.g74, i.s_word, i.s_position) = (true, bad, bad)), (0, 4, 1));
        assert_eq!(after(|i| (i.m3, i.s_position) = (true, bad)), (0, 1, 1));
    }
    assert_eq!(after(|i| (i.m3, i.s_word) = (true, -1e15)), (0, 1, 1));
    assert_eq!(after(|i| (i.m19, i.s_position) = (true, 7e14)), (0, 2, 1));
    assert_eq!(after(|i| (i.m19, i.s_position) = (true, 7.000_001e14)), (34, 0, 0));
}

#[test]
fn speeds_and_targets_are_those_of_the_request() {
    let job = |change: fn(&mut Inputs)| {
        let out = Bench::drive().positioned().once(|i| {
            (i.s_word, i.s_position) = (-7.0, -500_000.0);
            change(i);
        });
        [out.job_speed, out.job_position]
    };
    let expect = |found: [f64; 2], speed: f64, target: f64| {
        assert!((found[0] - speed).abs() + (found[1] - target).abs() < 1e-9, "{found:?}, not {speed}, {target}");
    };
    expect(job(|i| i.m3 = true), 7.0, 0.0);
    expect(job(|i| i.m4 = true), -7.0, 0.0);
    expect(job(|i| i.m5 = true), 0.0, 0.0);
    expect(job(|i| i.m19 = true), 7.0, -500_000.0);
    expect(job(|i| (i.m19, i.m4) = (true, true)), -7.0, -500_000.0);
    expect(job(|i| i.putax = true), 0.0, 0.0);
}

#[test]
fn a_request_counts_once_when_it_becomes_true_and_not_with_a_reset() {
    let mut bench = Bench::drive().positioned();
    bench.inputs.m5 = true;
    assert_eq!(bench.cycles(5).job_number, 1);
    bench.inputs.reset = true;
    bench.inputs.m3 = true;
    assert_eq!((bench.cycle().job_number, bench.out.error_id), (1, 0));
    bench.inputs.reset = false;
    assert_eq!(bench.cycles(5).job_number, 1);
    bench.once(|i| i.m3 = false);
    assert_eq!((bench.cycle().job_number, bench.out.job), (2, 1));
}

#[test]
fn four_wait_in_their_order_and_the_fifth_is_refused() {
    let mut bench = Bench::drive().positioned();
    bench.once(|i| i.g74 = true);
    for waiting in 1..=4 {
        assert_eq!((bench.cycle().error_id, bench.once(|i| i.m5 = true).waiting), (0, waiting));
    }
    bench.cycle();
    assert_eq!((bench.once(|i| i.m3 = true).error_id, bench.out.waiting), (35, 4));
    // A refused request is lost, and its error is this cycle's.
    assert_eq!((bench.cycle().error_id, bench.out.waiting, bench.out.job), (0, 4, 4));
    bench.once(|i| i.job_done = true);
    let numbers: Vec<(i32, u32)> = (0..4).map(|_| (bench.cycle().job, bench.out.job_number)).collect();
    assert_eq!(numbers, [(0, 3), (0, 4), (0, 5), (0, 5)]);
}

#[test]
fn requests_wait_in_to_velocity_brake_and_to_position() {
    let mut bench = Bench::drive().changing();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    assert_eq!((bench.once(|i| i.m5 = true).waiting, bench.out.job), (1, 1));
    let mut bench = Bench::drive().brake();
    assert_eq!((bench.once(|i| i.m3 = true).waiting, bench.out.job), (2, 0));
    let mut bench = Bench::drive().back();
    assert_eq!((bench.once(|i| i.m3 = true).waiting, bench.out.job), (2, 0));
}

#[test]
fn velocity_serves_what_waited_for_it_one_a_cycle_until_it_has_to_leave() {
    let waits = |last_turn: fn(&mut Inputs)| {
        let mut bench = Bench::drive().changing();
        (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
        for change in [|i: &mut Inputs| i.m4 = true, last_turn, |i: &mut Inputs| i.g74 = true] {
            bench.once(change);
            bench.cycle();
        }
        bench.inputs.operation_mode_display = 9;
        bench
    };
    let told = |out: crate::model::spindle::Outputs| (out.spindle_state, out.job, out.job_number, out.waiting);
    let mut bench = waits(|i| i.m5 = true);
    assert_eq!(told(bench.cycle()), (1, 1, 2, 2));
    assert_eq!(told(bench.cycle()), (2, 0, 3, 1));
    // The job is STOP already.
    assert_eq!(told(bench.cycle()), (2, 0, 3, 1));
    assert_eq!(told(bench.cycle()), (3, 0, 3, 1));
    let mut bench = waits(|i| i.m3 = true);
    assert_eq!(told(bench.cycle()), (1, 1, 2, 2));
    assert_eq!(told(bench.cycle()), (2, 1, 3, 1));
    // STOP of BRAKE.
    assert_eq!(told(bench.cycle()), (2, 0, 4, 1));
    assert_eq!(told(bench.cycle()), (3, 0, 4, 1));
}

#[test]
fn to_velocity_does_not_serve_what_velocity_would_not() {
    let mut bench = Bench::drive().changing();
    (bench.echoes, bench.inputs.operation_mode_display) = (false, 8);
    bench.once(|i| i.g74 = true);
    bench.inputs.operation_mode_display = 9;
    let told: Vec<[i32; 2]> = (0..3).map(|_| [bench.cycle().spindle_state, bench.out.job]).collect();
    assert_eq!(told, [[1, 1], [2, 0], [3, 0]]);
}

#[test]
fn a_request_waits_while_an_error_stays_and_is_gone_with_the_reset() {
    let mut bench = Bench::drive().positioned();
    bench.once(|i| i.task_cycle_ns = 1);
    assert_eq!((bench.once(|i| i.m5 = true).waiting, bench.out.error_id, bench.out.job_number), (1, 1, 0));
    assert_eq!((bench.once(|i| (i.m3, i.m4) = (true, true)).error_id, bench.out.waiting), (1, 1));
    assert_eq!(bench.once(|i| i.reset = true).waiting, 0);
}

#[test]
fn m5_is_a_job_of_its_own_and_a_stop_behind_a_stop_is_none() {
    let mut bench = Bench::drive().positioned();
    bench.once(|i| i.m5 = true);
    bench.cycle();
    assert_eq!(bench.once(|i| i.m5 = true).job_number, 2);
    assert_eq!(bench.once(|i| i.reset = true).job_number, 2);
    assert_eq!(bench.once(|i| i.drive_on = false).job_number, 2);
    assert_eq!(bench.once(|i| i.task_cycle_ns = 1).job_number, 2);
}

#[test]
fn nothing_is_refused_with_a_reset() {
    assert_eq!(after(|i| (i.reset, i.m3, i.m4, i.g74) = (true, true, true, true)), (0, 0, 0));
}

#[test]
fn m3_is_a_request_again_while_m19_stays() {
    let mut bench = Bench::drive().positioned();
    bench.inputs.m19 = true;
    assert_eq!((bench.cycle().job, bench.out.waiting), (2, 0));
    assert_eq!((bench.once(|i| i.m3 = true).error_id, bench.out.waiting), (0, 1));
}

//! Requests: which one counts, what is refused, how they wait, and when they are served.

use super::bench::{Bench, RPM};
use reference::spindle::{Inputs, Job, Outputs, SpindleState};

/// The outputs of the cycle in POSITION in which a bench gets these inputs.
fn asked(change: impl FnOnce(&mut Inputs<f64>)) -> Outputs<f64> {
    Bench::in_drive().at_rest().with_inputs(change)
}

#[test]
fn each_request_is_its_job() {
    let of = |o: Outputs<f64>| (o.job, o.job_speed, o.job_position, o.job_number, o.error_id);
    assert_eq!(of(asked(|i| i.m3 = true)), (Job::Turn, 1000.0 * RPM, 0.0, 1, 0));
    assert_eq!(of(asked(|i| i.m4 = true)), (Job::Turn, -1000.0 * RPM, 0.0, 1, 0));
    assert_eq!(of(asked(|i| i.m5 = true)), (Job::Stop, 0.0, 0.0, 1, 0));
    assert_eq!(of(asked(|i| i.m19 = true)), (Job::Orient, 1000.0 * RPM, 180_000.0, 1, 0));
    assert_eq!(of(asked(|i| i.putax = true)), (Job::Release, 0.0, 0.0, 1, 0));
    assert_eq!(of(asked(|i| i.g74 = true)), (Job::Home, 0.0, 0.0, 1, 0));
}

#[test]
fn the_sign_of_the_s_word_does_not_matter() {
    assert_eq!(asked(|i| (i.m3, i.s_word) = (true, -5.0)).job_speed, 5.0);
    assert_eq!(asked(|i| (i.m4, i.s_word) = (true, -5.0)).job_speed, -5.0);
    assert_eq!(asked(|i| (i.m4, i.s_word) = (true, 5.0)).job_speed, -5.0);
}

#[test]
fn m3_and_m4_are_the_direction_of_m19() {
    let of = |o: Outputs<f64>| (o.job, o.job_speed, o.waiting, o.error_id);
    assert_eq!(of(asked(|i| (i.m19, i.m4) = (true, true))), (Job::Orient, -1000.0 * RPM, 0, 0));
    assert_eq!(of(asked(|i| (i.m19, i.m3) = (true, true))), (Job::Orient, 1000.0 * RPM, 0, 0));
}

#[test]
fn a_request_counts_once_when_it_becomes_true() {
    let mut bench = Bench::in_drive().at_rest();
    bench.inputs.m5 = true;
    assert_eq!(bench.cycles(10).job_number, 1);
    bench.inputs.m5 = false;
    assert_eq!(bench.cycle().job_number, 1);
    bench.inputs.m5 = true;
    assert_eq!(bench.cycle().job_number, 2);
}

/// G74 before S[PUTAX] before M19 before M5 before M3 and M4.
#[test]
fn of_two_requests_the_one_of_higher_priority_counts_and_the_other_is_error_31() {
    let set: [fn(&mut Inputs<f64>); 5] =
        [|i| i.g74 = true, |i| i.putax = true, |i| i.m19 = true, |i| i.m5 = true, |i| i.m3 = true];
    let jobs = [Job::Home, Job::Release, Job::Orient, Job::Stop, Job::Turn];
    for high in 0..set.len() {
        for low in high + 1..set.len() {
            let o = asked(|i| {
                set[low](i);
                set[high](i);
            });
            let is_direction = (high, low) == (2, 4);
            assert_eq!((o.job, o.error_id, o.waiting), (jobs[high], if is_direction { 0 } else { 31 }, 0));
        }
    }
}

#[test]
fn both_directions_are_error_32() {
    let of = |o: Outputs<f64>| (o.job_number, o.error_id, o.waiting);
    assert_eq!(of(asked(|i| (i.m3, i.m4) = (true, true))), (0, 32, 0));
    assert_eq!(of(asked(|i| (i.m3, i.m4, i.m19) = (true, true, true))), (0, 32, 0));
    // With M5 they are the request that is lost.
    assert_eq!(of(asked(|i| (i.m3, i.m4, i.m5) = (true, true, true))), (1, 31, 0));
    let mut bench = Bench::in_drive().at_rest();
    bench.inputs.m3 = true;
    bench.cycle();
    assert_eq!(of(bench.with_inputs(|i| i.m4 = true)), (1, 32, 0), "m3 is still TRUE");
}

#[test]
fn an_s_word_out_of_range_is_error_33() {
    for s in [f64::NAN, f64::INFINITY, -1.1e15] {
        assert_eq!(asked(|i| (i.m3, i.s_word) = (true, s)).error_id, 33);
        assert_eq!(asked(|i| (i.m19, i.s_word) = (true, s)).error_id, 33);
        let o = asked(|i| (i.m5, i.s_word) = (true, s));
        assert_eq!((o.error_id, o.job_number, o.job_speed), (0, 1, 0.0), "M5 has no speed");
    }
}

#[test]
fn a_target_out_of_range_is_error_34() {
    for x in [f64::NAN, f64::NEG_INFINITY, 7.1e14] {
        let o = asked(|i| (i.m19, i.s_position) = (true, x));
        assert_eq!((o.error_id, o.job_number, o.waiting), (34, 0, 0));
        assert_eq!(asked(|i| (i.m3, i.s_position) = (true, x)).error_id, 0, "M3 has no target");
    }
}

#[test]
fn the_fifth_request_that_waits_is_error_35() {
    let mut bench = Bench::in_drive().before_brake(1000.0 * RPM);
    for waiting in 2..=4 {
        assert_eq!(bench.with_inputs(|i| i.m5 = true).waiting, waiting);
        bench.cycle();
    }
    let o = bench.with_inputs(|i| i.m3 = true);
    assert_eq!((o.error_id, o.waiting, o.job_number), (35, 4, bench.cycle().job_number));
    assert_eq!(bench.outputs.error_id, 0, "this cycle's error");
}

#[test]
fn a_request_with_the_drive_off_is_error_36() {
    let requests: [fn(&mut Inputs<f64>); 6] =
        [|i| i.m3 = true, |i| i.m4 = true, |i| i.m5 = true, |i| i.m19 = true, |i| i.putax = true, |i| i.g74 = true];
    for ask in requests {
        let mut bench = Bench::in_drive().at_rest();
        bench.inputs.drive_on = false;
        let o = bench.with_inputs(ask);
        assert_eq!((o.error_id, o.waiting, o.job_number), (36, 0, 0));
        assert_eq!(bench.cycle().error_id, 0, "this cycle's error");
    }
}

/// In the order of the page: 32, 33, 34, 36, 35; and 31 only for those next to a request that is not refused.
#[test]
fn a_request_is_refused_for_the_first_reason() {
    let full = || {
        let mut bench = Bench::in_drive().before_brake(1000.0 * RPM);
        for _ in 0..3 {
            bench.with_inputs(|i| i.m5 = true);
            bench.cycle();
        }
        assert_eq!(bench.outputs.waiting, 4);
        bench
    };
    let bad: [fn(&mut Inputs<f64>); 5] = [
        |i| (i.m3, i.m4) = (true, true),
        |i| i.s_word = f64::NAN,
        |i| i.s_position = f64::NAN,
        |i| i.drive_on = false,
        |_| (),
    ];
    for (first, id) in [32, 33, 34, 36, 35].into_iter().enumerate() {
        let o = full().with_inputs(|i| {
            (i.m19, i.m5) = (true, true);
            bad[first..].iter().for_each(|spoil| spoil(i));
        });
        assert_eq!(o.error_id, id);
    }
}

#[test]
fn a_refused_request_is_lost_and_so_are_the_others_of_its_cycle() {
    for change in [
        (|i: &mut Inputs<f64>| i.s_position = f64::NAN) as fn(&mut Inputs<f64>),
        |i| i.s_word = f64::NAN,
        |i| (i.m3, i.m4) = (true, true),
    ] {
        let mut bench = Bench::in_drive().at_rest();
        let o = bench.with_inputs(|i| {
            (i.m19, i.m5) = (true, true);
            change(i);
        });
        assert!(matches!(o.error_id, 32..=34));
        let o = bench.cycles(3);
        assert_eq!((o.job_number, o.waiting, o.error_id), (0, 0, 0));
    }
}

#[test]
fn a_request_beside_one_of_higher_priority_is_lost() {
    let mut bench = Bench::in_drive().at_rest();
    bench.with_inputs(|i| (i.m3, i.m5) = (true, true));
    let o = bench.cycles(3);
    assert_eq!((o.job, o.job_number, o.waiting, o.error_id), (Job::Stop, 1, 0, 0));
}

/// M19 while M3 turns, then M3 again: a tool is changed at that position.
#[test]
fn requests_are_served_in_their_order_and_a_turn_during_brake_waits_for_m19() {
    let mut bench = Bench::in_drive().before_brake(1000.0 * RPM);
    bench.cycle();
    assert_eq!(bench.with_inputs(|i| i.m3 = true).waiting, 2);
    bench.with_inputs(|i| i.m5 = true);
    bench.until_next(SpindleState::Position);
    bench.v = bench.outputs.v_spindle;
    let o = bench.cycles(50);
    assert_eq!((o.job, o.waiting), (Job::Orient, 2), "until it has been done");
    let o = bench.with_inputs(|i| i.job_done = true);
    assert_eq!((o.job, o.waiting), (Job::Turn, 1));
    assert_eq!((bench.cycle().job, bench.outputs.waiting), (Job::Stop, 0), "one a cycle");
}

#[test]
fn m19_g74_and_putax_are_over_when_the_interpolator_has_done_them() {
    let requests: [fn(&mut Inputs<f64>); 3] = [|i| i.m19 = true, |i| i.g74 = true, |i| i.putax = true];
    for ask in requests {
        let mut bench = Bench::in_drive().at_rest();
        let job = bench.with_inputs(ask).job;
        bench.with_inputs(|i| i.m5 = true);
        assert_eq!((bench.cycles(10).job, bench.outputs.waiting), (job, 1));
        let o = bench.with_inputs(|i| i.job_done = true);
        assert_eq!((o.job, o.waiting, o.job_number), (Job::Stop, 0, 2));
    }
}

#[test]
fn stop_and_turn_are_over_at_any_time() {
    let mut bench = Bench::in_drive().turning();
    assert_eq!(bench.with_inputs(|i| i.m4 = true).job_speed, -1000.0 * RPM);
    assert_eq!(bench.with_inputs(|i| i.m5 = true).job, Job::Stop);
    assert_eq!(bench.with_inputs(|i| i.g74 = true).job, Job::Home);
}

#[test]
fn nothing_is_served_in_to_velocity_brake_and_to_position() {
    let waits = |mut bench: Bench| {
        bench.display = Some(0);
        let before = bench.outputs.waiting;
        assert_eq!(bench.with_inputs(|i| i.m5 = true).waiting, before + 1);
        assert_eq!(bench.cycle().waiting, before + 1);
    };
    waits(Bench::in_drive().before_to_velocity());
    waits(Bench::in_drive().before_brake(1000.0 * RPM));
    waits(Bench::in_drive().before_to_position());
}

#[test]
fn a_new_number_is_a_new_job_and_stop_is_one_unless_it_is_the_job() {
    let mut bench = Bench::in_drive().fast(1000.0 * RPM);
    let number = bench.outputs.job_number;
    assert_eq!(bench.with_inputs(|i| i.reset = true).job_number, number + 1);
    assert_eq!(bench.with_inputs(|i| i.reset = true).job_number, number + 1);
}

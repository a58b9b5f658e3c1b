//! A record as it would have been with the stages of the manual, against the simulation with them.

use crate::plant::{CYCLE, Impulse, Move, moved};
use crate::stage::{manual, response, running};
use identification::figures::{Judge, Record, Vibration, When};
use identification::response::Lines;
use identification::shape::{Mode, Shape, allpass};
use identification::what_if::Axis;
use identification::{Complex64, segments};
use machine::measure::amplitude;
use machine::plant::{DEMONSTRATION, Plant};
use std::{f64::consts::PI, ops::Range};

/// The vibrations of the demonstration plant, as its load shows them.
pub const VIBRATIONS: [Vibration; 2] = [
    Vibration { hz: 53.0, when: When::Driving, channel: Some(0) },
    Vibration { hz: 10.97, when: When::Ramps, channel: Some(0) },
];

/// The ramps of a move.
pub fn ramps(of: &Move) -> Vec<Range<usize>> {
    segments::ramps(&segments::of(&of.v_command)).collect()
}

/// Exact lines of a plant.
pub fn exact(plant: &Plant) -> Lines {
    let impulse = Impulse::of(plant);
    let hz: Vec<f64> = (1..2047).map(|k| f64::from(k) / 4.094).take_while(|hz| *hz <= 250.0).collect();
    Lines {
        response: hz.iter().map(|hz| impulse.p(*hz)).collect(),
        error: vec![0.0; hz.len()],
        coherence: vec![1.0; hz.len()],
        hz,
    }
}

#[test]
fn the_pair_of_the_manual() {
    let (without, off) = moved(&DEMONSTRATION, |_| 0.0);
    let (with, on) = moved(&DEMONSTRATION, running(&manual(), CYCLE));
    let ramps = ramps(&without);
    let simulated = [
        on.at_speed / off.at_speed,
        on.at_ramps / off.at_ramps,
        on.ring_down / off.ring_down,
        on.following_error / off.following_error,
        after_stops(&with, &ramps) / after_stops(&without, &ramps),
    ];
    // The definition's following errors are of the other convention of the command, x[n] = x[n-1] + Ts v[n].
    let tolerances = [0.01, 0.01, 0.01, 0.06];
    for ((found, golden), tolerance) in simulated.iter().zip([0.452, 0.324, 0.385, 3.46]).zip(tolerances) {
        assert!((found / golden - 1.0).abs() < tolerance, "simulated: {simulated:?}");
    }
    let measured = exact(&DEMONSTRATION).response(CYCLE).unwrap();
    let axis = Axis { cycle_time: CYCLE, position_gain: Some(20.0), response: &measured };
    let offset: Vec<f64> = without.a_load.iter().map(|a| a + 3.0).collect();
    let (channels, v_motor): (&[&[f64]], _) = (&[&without.a_load], &without.v_motor);
    let record = Record { channels, v_motor, load: Some(&offset), error: Some(&without.error), ramps: &ramps };
    let judge = Judge::new(axis, record, &VIBRATIONS).unwrap();
    let stages = |shape: &Shape| response(shape, CYCLE);
    let left = judge.left(&stages, &manual());
    let [ring, settled] = [left.ring, left.settled].map(Option::unwrap);
    let error = judge.effect(&stages, &manual()).following_error.unwrap();
    let found = [left.residuals[0], left.residuals[1], ring, error, settled];
    // Golden figures, and the simulation: 5 % is what a load's vibration and a mesh that follows the position make.
    // Of the ring-down the definition leaves open which cycle its window begins with.
    for (found, (golden, tolerance)) in found.iter().zip([(0.454, 0.01), (0.311, 0.01), (0.376, 0.03)]) {
        assert!((found / golden - 1.0_f64).abs() < tolerance, "{found}, {golden} expected");
    }
    let tolerances = [0.015, 0.065, 0.065, 0.01, 0.065];
    for ((found, simulated), tolerance) in found.iter().zip(simulated).zip(tolerances) {
        assert!((found / simulated - 1.0).abs() < tolerance, "what-if {found}, simulated {simulated}");
    }
    assert!((found[3] / 3.45 - 1.0).abs() < 0.06, "{found:?}");
    // Nothing added leaves everything.
    let nothing = judge.left(&stages, &[(manual()[0].0, 0.0)]);
    assert!(nothing.residuals.iter().chain(&nothing.ring).all(|left| (left - 1.0).abs() < 1e-9), "{nothing:?}");
    let peak = judge.effect(&stages, &manual()).peak_v_add;
    let mut block = running(&manual(), CYCLE);
    let mut largest = 0.0_f64;
    moved(&DEMONSTRATION, |v| {
        let v_add = block(v);
        largest = largest.max(v_add.abs());
        v_add
    });
    assert!((peak / largest - 1.0).abs() < 0.02, "{peak} {largest}");
}

/// The rms of the load from 0.14 s after the second and the fourth ramp, at whose ends the axis stands still, to the next one.
fn after_stops(of: &Move, ramps: &[Range<usize>]) -> f64 {
    let stops = [ramps[1].end + 140..ramps[2].start, ramps[3].end + 140..ramps[3].end + 940];
    let mean =
        |window: Range<usize>| of.a_load[window.clone()].iter().map(|a| a * a / window.len() as f64).sum::<f64>();
    stops.map(mean).iter().sum::<f64>().sqrt()
}

/// The mean amplitude of the following error around ramps at 9.5 to 12.5 Hz.
fn around_ramps(of: &Move, ramps: &[Range<usize>]) -> f64 {
    let window = |ramp: &Range<usize>| amplitude(&of.error[ramp.start - 100..ramp.start + 900], CYCLE, [9.5, 12.5]);
    ramps.iter().map(window).sum::<f64>() / ramps.len() as f64
}

/// Stages leave R of what moves the motor, but the following error also has what they add to its way.
#[test]
fn what_is_left_of_the_following_error() {
    let (without, _) = moved(&DEMONSTRATION, |_| 0.0);
    let (with, _) = moved(&DEMONSTRATION, running(&manual(), CYCLE));
    let ramps = ramps(&without);
    let simulated = around_ramps(&with, &ramps) / around_ramps(&without, &ramps);
    let measured = exact(&DEMONSTRATION).response(CYCLE).unwrap();
    let axis = Axis { cycle_time: CYCLE, position_gain: Some(20.0), response: &measured };
    let record =
        Record { channels: &[], v_motor: &without.v_motor, load: None, error: Some(&without.error), ramps: &ramps };
    let vibrations = [Vibration { hz: 11.0, when: When::Ramps, channel: None }];
    let judge = Judge::new(axis, record, &vibrations).unwrap();
    let left = judge.left(&|shape: &Shape| response(shape, CYCLE), &manual());
    assert!((left.residuals[0] / simulated - 1.0).abs() < 0.02, "what-if {}, simulated {simulated}", left.residuals[0]);
    let nothing = judge.left(&|shape: &Shape| response(shape, CYCLE), &[(manual()[0].0, 0.0)]);
    assert!((nothing.residuals[0] - 1.0).abs() < 1e-9, "{nothing:?}");
    // A vibration of the following error needs the following error.
    assert!(Judge::new(axis, Record { error: None, ..record }, &vibrations).is_none());
}

#[test]
fn an_allpass_turns_by_its_lead() {
    for (f0, lead) in [(53.0, 60.0), (53.0, 90.0), (11.0, 120.0), (11.0, 180.0), (30.0, 270.0)] {
        let shape = Shape { mode: Mode::Direct, f0, q: 5.0, damping: 0.8, allpass: None };
        let turned = Shape { allpass: allpass(f0, lead, CYCLE), ..shape };
        assert!(turned.allpass.is_some());
        let t = libm::tan(PI * f0 * CYCLE);
        let apart = response(&turned, CYCLE)(t) / response(&shape, CYCLE)(t);
        let expected = Complex64::from_polar(1.0, lead.to_radians());
        assert!((apart - expected).norm() < 1e-9, "{f0} {lead}: {apart}");
    }
    // Ratios for low frequencies and Q 2, as the definition has them.
    for (lead, ratio) in [(30.0, 0.435), (60.0, 0.657), (90.0, 0.781), (120.0, 0.866), (180.0, 1.0)] {
        let found = allpass(1.0, lead, CYCLE).unwrap().f0;
        assert!((found - ratio).abs() < 1e-3, "{lead}: {found}");
    }
    assert_eq!(allpass(400.0, 359.0, CYCLE), None, "no f0 reaches it");
}

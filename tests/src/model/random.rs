//! Random parameters of an axis that `axgen` takes: every way that the documents tell apart, defaults and corrected values
//! included. Nothing is computed from them here.

use super::parameters::{
    ACCELERATION, ADDITIVE_TORQUE, ADDITIVE_VELOCITY, JERK, JERK_TORQUE, Location, Master, Mode, Pair, Parameters,
    Stage, VELOCITY,
};
use crate::random::rng::Rng;

/// P-AXIS-00320; the default decides by the drive.
const MODES: [&str; 4] = ["DRIVE_DEFAULT", "DRIVE_DEFAULT", "DRIVE_POSITION_CONTROL", "CNC_POSITION_CONTROL"];
/// P-AXIS-00848.
const PROTOTYPES: [&str; 3] = ["CRIT_DAMPING", "BUTTERWORTH", "BESSEL"];

/// An axis.
#[must_use]
pub fn parameters(rng: &mut Rng) -> Parameters {
    let single = rng.chance(20);
    let cycle_ns = *rng.pick(&[1_000_000, 1_000_000, 2_000_000, 250_000, 62_500, 333_333, 1_234_567]);
    let kind = *rng.pick(&[1, 1, 2, 4]);
    let word = word(rng);
    let width = |rng: &mut Rng| *rng.pick(&[16, 32, 32]);
    let optional = |rng: &mut Rng| *rng.pick(&[None, Some(16), Some(32), Some(32)]);
    let mut p = Parameters {
        single,
        cycle_ns,
        kind,
        drive: *rng.pick(&[1, 2, 3, 3, 4, 8]),
        operation_mode: MODES[rng.below(MODES.len())],
        kv: (!rng.chance(5)).then(|| number(rng, 6000)),
        multi_gain: [number(rng, 20_000), number(rng, 40)],
        incr_per_rev: *rng.pick(&[1024, 1_048_576, 3600, 65536, 7]),
        wegauf: [number(rng, 40), number(rng, 40)],
        feed_const: if rng.chance(40) {
            *rng.pick(&[[1, 1], [1, 7], [7, 1]])
        } else {
            [number(rng, 100_000), number(rng, 9)]
        },
        load: zero(rng, 4, 1_000_000),
        reference: zero(rng, 4, 30_000),
        torque_scale: [number(rng, 1000), zero(rng, 4, 9)],
        linear: kind == 1 && rng.chance(25),
        v_reso: [zero(rng, 2, 10_000), number(rng, 10_000)],
        v_time_base: *rng.pick(&[0, 1, 2]),
        command_bits: width(rng),
        velocity_bits: optional(rng),
        torque_bits: optional(rng),
        word,
        vs_a: [zero(rng, 4, 6000), *rng.pick(&[1, 1, 10, 3, 0])],
        vs_v: [zero(rng, 3, 12), *rng.pick(&[1, 10, 10, 7, 3])],
        jerk_fact: [zero(rng, 4, 100), *rng.pick(&[100, 100, 7, 0])],
        delay_us: [delay(rng, cycle_ns), delay(rng, cycle_ns), delay(rng, cycle_ns)],
        default_active: rng.chance(20),
        global_disable: rng.chance(8),
        shift_time: (!rng.chance(30)).then(|| *rng.pick(&[0, 1, 2, 3, 4])),
        enable: "OFF",
        v_add_max_fact: *rng.pick(&[0, 1, 50, 500, 2000]),
        vb_max: number(rng, 1_000_000),
        fade_ns: number(rng, 40) * (cycle_ns / 2),
        ride_through: *rng.pick(&[0, 0, 1, 2, 5]),
        tunable: if rng.chance(40) { "weights" } else { "nothing" },
        watch: rng.clone().chance(50), // a clone: the other axes and histories stay what they were
        counts_calls: rng.clone().below(7) < 2,
        stages: Vec::new(),
        master: None,
    };
    if rng.chance(3) {
        p.vs_v[1] = 0;
    }
    if rng.chance(50) {
        p.stages = (0..rng.between(1, 3)).map(|_| stage(rng, &p)).collect();
    }
    if rng.chance(20) {
        p.master = Some(Master {
            v_add_max_fact: *rng.pick(&[0, 100, 2000]),
            vb_max: number(rng, 1_000_000),
            has_stage: !rng.chance(20),
        });
    }
    // What would be an error instead of a warning: AX310.
    if p.master.is_some_and(|master| master.has_stage) && p.location() != Location::Cnc && p.velocity_bits.is_none() {
        p.velocity_bits = Some(32);
    }
    p
}

/// A sum of words, or none.
fn word(rng: &mut Rng) -> u32 {
    const WORDS: [u32; 6] = [
        VELOCITY,
        ACCELERATION,
        JERK,
        ADDITIVE_VELOCITY | VELOCITY,
        ADDITIVE_TORQUE | ACCELERATION,
        JERK_TORQUE | JERK,
    ];
    if rng.chance(10) {
        return 0;
    }
    (0..rng.between(1, 4)).map(|_| *rng.pick(&WORDS)).fold(0, |sum, word| sum | word)
}

/// 1 to a number, small ones as often as large ones.
fn number(rng: &mut Rng, largest: u32) -> u32 {
    let scale = f64::from(largest).powf(rng.below(1001) as f64 / 1000.0);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to the largest")]
    let number = scale.round() as u32;
    number.clamp(1, largest)
}

/// The same, and 0 in so many of 100 cases.
fn zero(rng: &mut Rng, percent: usize, largest: u32) -> u32 {
    if rng.chance(percent) { 0 } else { number(rng, largest) }
}

/// 0, a whole number of cycles, any time below six cycles, one just below, or one that is corrected [us].
fn delay(rng: &mut Rng, cycle_ns: u32) -> u32 {
    let six = (6 * cycle_ns).div_ceil(1000);
    let any = u32::try_from(rng.below(six as usize)).expect("microseconds");
    let whole = u32::try_from(rng.below(6)).expect("small") * cycle_ns / 1000;
    *rng.pick(&[0, whole, any, any, any, six - 1, 1, six])
}

fn stage(rng: &mut Rng, p: &Parameters) -> Stage {
    let ts = f64::from(p.cycle_ns) * 1e-9;
    let part = |rng: &mut Rng| 10f64.powf(-0.4 - 1.4 * rng.below(1001) as f64 / 1000.0);
    // At most 500 Hz, and 0.4 of the sampling frequency; a fade is at least a period.
    let frequency = |rng: &mut Rng| ((part(rng) / ts).min(500.0) * 1000.0).round() / 1000.0;
    let q = |rng: &mut Rng| f64::from(u32::try_from(rng.between(100, 1000)).expect("small")) / 100.0;
    let order = rng.between(1, 3);
    let prototype = PROTOTYPES[rng.below(PROTOTYPES.len())];
    Stage {
        mode: *rng.pick(&[Mode::DirectMotor, Mode::DirectLoad, Mode::Indirect, Mode::SetPoint]),
        weight: weight(rng),
        damping: f64::from(u32::try_from(rng.between(10, 99)).expect("small")) / 100.0,
        band_pass: (order, prototype, frequency(rng), q(rng)),
        all_pass: rng.chance(25).then(|| (frequency(rng), q(rng))),
        is_all_pass_first: rng.clone().chance(40), // a clone, as above
    }
}

/// Up to beyond the cap of 7.
fn weight(rng: &mut Rng) -> Pair {
    [number(rng, 80), *rng.pick(&[10, 10, 7])]
}

//! The block `excitation` against judges that share no code with it: the sequence of the crate `identification`, whose own tests
//! have its digits and its spectrum, the response of the demonstration plant, random inputs and overwritten states.

#![expect(clippy::cast_possible_truncation, reason = "random bits")]

use crate::inside::sets::Random;
use crate::response_file::DEMONSTRATION_PLANT;
use crate::set_of;
use generator::blocks::{Design, Designed};
use identification::excitation::{self, Sequence};
use identification::response::Lines;
use machine::closed_loop::{Position, UM};
use machine::plant::DEMONSTRATION;
use machine::{Machine, Measured};
use portable::{Block, Real};
use reference::excitation::{Coeffs, Excitation, Inputs, Outputs, State};

/// Coefficients, as the generator designs them, with these keys of the table `excitation`.
fn designed(cycle: &str, keys: &str) -> Coeffs<f64> {
    let set = format!(
        "cycle_time = '{cycle}'\n[axis.X]\nexcitation = {{ {keys} }}\ngetriebe = [{{ dynamik.vb_max = 500000 }}]\n"
    );
    Excitation::design(&Designed::from(set_of(&set).axes[0].axis.clone()))
}

struct Running {
    coeffs: Coeffs<f64>,
    state: State,
    inputs: Inputs<f64>,
}

impl Running {
    fn new(coeffs: Coeffs<f64>) -> Self {
        let state = <Excitation as Block<f64>>::state();
        Self { coeffs, state, inputs: <Excitation as Block<f64>>::inputs(&coeffs) }
    }

    fn step(&mut self, hold_to_run: bool, v_motor: f64) -> Outputs<f64> {
        let mut outputs = <Excitation as Block<f64>>::outputs();
        (self.inputs.hold_to_run, self.inputs.v_motor) = (hold_to_run, v_motor);
        <Excitation as Block<f64>>::step(&mut self.state, &self.coeffs, &self.inputs, &mut outputs);
        outputs
    }

    /// A whole run, from the cycle of the start to the last one that is active.
    fn whole(coeffs: Coeffs<f64>) -> Vec<Outputs<f64>> {
        let mut block = Self::new(coeffs);
        assert!(!block.step(false, 1.0).active);
        let run: Vec<_> = std::iter::from_fn(|| Some(block.step(true, 1e5)).filter(|now| now.active)).collect();
        // It says that it is done, and the button that stays pressed starts nothing.
        for _ in 0..1000 {
            let after = block.step(true, 1e5);
            assert!(
                after.done && !after.active && !after.fault && after.v_excite.to_bits() == 0 && after.error_id == 0
            );
        }
        assert!(block.step(false, 1e5).done, "it stays so when the button is released");
        assert!(!block.step(true, 1e5).done, "until the next start");
        run
    }
}

#[test]
fn every_register_gives_the_sequence_of_the_analysis() {
    for (bits, clock) in [(7, 1), (8, 2), (9, 1), (10, 3), (11, 2), (11, 16), (12, 1), (13, 1), (14, 1), (15, 1)] {
        let coeffs = designed("1ms", &format!("bits = {bits}, clock = {clock}, periods = 4, amplitude = 3000"));
        let sequence = Sequence::new(bits, clock).unwrap();
        let expected = excitation::Excitation { sequence, cycle_time: 1e-3, amplitude: 3000.0, periods: 4 };
        let run = Running::whole(coeffs);
        let samples: Vec<f64> = expected.samples().collect();
        assert_eq!(run.len(), samples.len(), "{bits} bits");
        for (n, (found, expected)) in run.iter().zip(&samples).enumerate() {
            // Two roundings of the fade in another order.
            assert!((found.v_excite - expected).abs() <= 1e-12 * 3000.0, "{bits} bits, cycle {n}");
        }
        let measured = expected.measured();
        for (n, found) in run.iter().enumerate() {
            let period = if measured.contains(&n) { n / sequence.period() } else { 0 };
            assert_eq!((found.period as usize, found.done, found.fault), (period, false, false), "cycle {n}");
        }
    }
}

#[test]
fn the_button_and_the_motor_end_it() {
    let coeffs = designed("1ms", "bits = 7, clock = 1, periods = 4");
    let mut block = Running::new(coeffs);
    assert!((0..50).all(|_| !block.step(true, 1e4).active), "a button that is pressed at power-on starts nothing");
    let start = |block: &mut Running, v_motor: f64| {
        block.step(false, v_motor);
        block.step(true, v_motor)
    };
    let standing = start(&mut block, 0.0);
    assert!(!standing.active && !standing.fault && standing.error_id == 51, "no start at standstill");
    assert!(start(&mut block, 1e4).active);
    assert!((0..300).all(|_| block.step(true, 1e4).active));
    // The motor stands: the fade falls by a hundredth a cycle, and no sample of it counts.
    let falling: Vec<_> = (0..101).map(|_| block.step(true, 0.0)).collect();
    for (n, now) in falling[..100].iter().enumerate() {
        let level = 2000.0 * (100 - n) as f64 / 100.0;
        assert!((now.v_excite.abs() - level).abs() < 1e-9 && now.period == 0 && now.error_id == 51 && !now.fault);
    }
    assert!(!falling[100].active && !falling[100].done && falling[100].error_id == 51);
    assert!((0..500).all(|_| !block.step(true, 1e4).active), "the button that stays pressed starts nothing");
    // Backwards, and the button is let go within the rise.
    assert_eq!(start(&mut block, -1e4).error_id, 0);
    assert!((0..30).all(|_| block.step(true, -1e4).active));
    assert!((0..31).all(|_| block.step(false, -1e4).active));
    assert!(!block.step(false, -1e4).active);
    // So does the loss of position control, at once, and the button that stays pressed starts nothing afterwards.
    assert!(start(&mut block, 1e4).active && (0..150).all(|_| block.step(true, 1e4).active));
    block.inputs.position_controlled = false;
    let lost = block.step(true, 1e4);
    assert!(lost.v_excite.to_bits() == 0 && !lost.active && !lost.done && !lost.fault && lost.error_id == 0);
    assert!(!start(&mut block, 1e4).active, "no start without position control");
    block.inputs.position_controlled = true;
    assert!((0..50).all(|_| !block.step(true, 1e4).active), "the button was pressed before");
    // Bad samples end it at once.
    for bad in [f64::NAN, f64::INFINITY, -2e15] {
        assert!(start(&mut block, 1e4).active && block.step(true, 1e4).active);
        let now = block.step(true, bad);
        assert!(now.fault && now.error_id == 12 && !now.active && now.v_excite.to_bits() == 0);
        assert!((0..9).all(|_| !block.step(true, 1e4).active));
    }
}

/// Anything, or nearly what is expected.
fn word(random: &mut Random, near: u32) -> u32 {
    match random.below(3) {
        0 => random.next() as u32,
        1 => near.wrapping_add(random.below(3) as u32).wrapping_sub(1),
        _ => random.below(near as usize + 1) as u32,
    }
}

fn never_above<R: Real>(coeffs: &Coeffs<R>, random: &mut Random) {
    let mut state = <Excitation as Block<R>>::state();
    let (mut faults, mut actives) = (0, 0);
    for n in 0..300_000_u32 {
        if random.below(20) == 0 {
            let mut bit = || random.below(2) == 0;
            (state.held, state.active, state.ends, state.complete) = (bit(), bit(), bit(), bit());
            (state.reversed, state.forward) = (bit(), bit());
            (state.fade, state.register) = (word(random, coeffs.fade_cycles), word(random, coeffs.ones));
            (state.cycle, state.clock) = (word(random, coeffs.clock), word(random, coeffs.ones));
            state.period = word(random, coeffs.periods);
        }
        let v_motor = match random.below(30) {
            0 => f64::from_bits(random.next()),
            1 => -1e4,
            _ => 1e4,
        };
        let inputs = Inputs {
            v_motor: R::lit(v_motor),
            hold_to_run: random.below(10) > 0,
            position_controlled: random.below(10) > 0,
            task_cycle_ns: if random.below(50) == 0 { n } else { 0 },
            cycle_counter: 0,
        };
        let mut outputs = <Excitation as Block<R>>::outputs();
        <Excitation as Block<R>>::step(&mut state, coeffs, &inputs, &mut outputs);
        let v = outputs.v_excite.to_f64();
        assert!(v.abs() <= coeffs.amplitude.to_f64(), "cycle {n}: {v}");
        assert!(
            outputs.active && inputs.position_controlled || v.to_bits() == 0,
            "cycle {n}: {v} without an excitation"
        );
        (faults, actives) = (faults + u32::from(outputs.fault), actives + u32::from(outputs.active));
    }
    assert!(faults > 1000 && actives > 10_000, "{faults} faults, {actives} cycles of excitation");
}

#[test]
fn never_above_its_amplitude() {
    let mut random = Random(88_172_645_463_325_252);
    for (cycle, keys) in [("1ms", "bits = 7, clock = 1, periods = 4"), ("300us", "amplitude = 777.7, periods = 5")] {
        let of = designed(cycle, keys);
        never_above(&of, &mut random);
        let single = Coeffs {
            cycle_time_ns: of.cycle_time_ns,
            bits: of.bits,
            ones: of.ones,
            front: of.front,
            clock: of.clock,
            periods: of.periods,
            amplitude: f32::lit(of.amplitude),
            fade_cycles: of.fade_cycles,
            fade_step: f32::lit(of.fade_step),
            call_rate: of.call_rate,
        };
        never_above(&single, &mut random);
    }
}

/// The demonstration plant in its position loop, moving at 10 mm/s, excited by the block: the response is that of the plant.
#[test]
fn the_response_of_the_demonstration_plant() {
    let mut block = Running::new(designed("1ms", "amplitude = 2000"));
    let sequence = Sequence::for_cycle(1e-3);
    let (mut machine, mut actual, mut x) = (DEMONSTRATION.without_mesh().at_rest(), Measured::default(), 0.0);
    let (mut v_cmd, mut v_motor) = (Vec::new(), Vec::new());
    for n in 0.. {
        x += 0.01 * 1e-3;
        let signals = Position::DEMONSTRATION.signals(x, 0.01, &actual);
        let now = block.step(n > 500, signals.v_motor);
        assert!(!now.fault && now.error_id == 0, "cycle {n}: {}", now.error_id);
        let commanded = (signals.v_command + now.v_excite) / UM;
        if now.period > 0 {
            v_cmd.push(commanded);
            v_motor.push(actual.v_motor);
        }
        if now.done {
            break;
        }
        actual = machine.step(commanded);
    }
    assert_eq!(v_cmd.len(), 8 * sequence.period());
    let lines = Lines::measured(&sequence, 1e-3, &v_cmd, &v_motor).unwrap();
    let response = lines.response(1e-3).unwrap();
    // Magnitude and phase [deg] by an independent simulation.
    for (hz, magnitude, phase) in DEMONSTRATION_PLANT {
        let p = response.value(hz);
        let apart = [p.norm() / magnitude - 1.0, p.arg().to_degrees() - phase];
        assert!(apart[0].abs() < 0.01 && apart[1].abs() < 0.5, "{hz} Hz: {apart:?}");
    }
}

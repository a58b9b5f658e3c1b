//! A block on a bench: its coefficients, its state, its inputs, and a cycle at a time. No assertion.

use portable::{Block, Real};
use reference::ipc::{Coeffs, Inputs, Ipc, Outputs, State, mode_on, step};
use reference::stage::{self, Mode};
use reference::{bandpass, filter, oscillation};

/// Cycles that the fade takes: 107 * (1 / 107) is not 1, in neither real type, and a full fade is 1 all the same.
pub const FADE_CYCLES: u32 = 107;

/// A block in operation.
#[derive(Clone)]
pub struct Bench<R> {
    pub coeffs: Coeffs<R>,
    pub state: State<R>,
    pub inputs: Inputs<R>,
}

impl<R: Real> Bench<R> {
    /// A block with these stages, in ON, before its first cycle.
    pub fn new(stages: &[stage::Coeffs<R>]) -> Self {
        let mut coeffs = Coeffs {
            cycle_time_ns: 1_000_000,
            enable: mode_on(),
            limit: R::lit(530_000.0),
            lower_limit: R::lit(-530_000.0),
            sum_limit: R::lit(4e6),
            rest: R::per_kind(530_000.0 / (1u64 << 60) as f64, 530_000.0 / (1u64 << 40) as f32),
            fade_cycles: FADE_CYCLES,
            fade_step: R::lit(1.0 / f64::from(FADE_CYCLES)),
            ..Coeffs::default()
        };
        coeffs.stage[..stages.len()].copy_from_slice(stages);
        Self { coeffs, state: <Ipc as Block<R>>::state(), inputs: <Ipc as Block<R>>::inputs(&coeffs) }
    }

    /// One cycle.
    pub fn step(&mut self) -> Outputs<R> {
        let mut outputs = <Ipc as Block<R>>::outputs();
        step(&mut self.state, &self.coeffs, &self.inputs, &mut outputs);
        outputs
    }

    /// One cycle with this velocity on all three inputs.
    pub fn at(&mut self, v: R) -> Outputs<R> {
        (self.inputs.v_command, self.inputs.v_motor, self.inputs.v_direct) = (v, v, v);
        self.step()
    }

    /// The block after as many cycles of noise as it takes to fade in, and more.
    pub fn running(mut self) -> Self {
        let mut noise = Noise::default();
        for _ in 0..3 * FADE_CYCLES {
            self.at(noise.next());
        }
        self
    }
}

/// A band-pass of order 1: 53 Hz, quality factor 10, 1 ms; weight 3; from the motor.
pub fn direct<R: Real>() -> stage::Coeffs<R> {
    let section = bandpass::Coeffs {
        b2: R::lit(-0.016_379_233_277_825_974),
        a1: R::lit(-1.859_167_333_218_350_5),
        a2: R::lit(0.967_241_533_444_348),
        a: R::lit(0.016_379_233_277_825_974),
        b: R::lit(0.086_795_566_668_650_76),
        c: R::lit(3.299_122_687_638_476),
    };
    stage::Coeffs { mode: Mode::Direct, gain: R::lit(-3.0), filter: band_pass(section), ..stage::Coeffs::default() }
}

/// A band-pass of order 1: 11 Hz, quality factor 2, 1 ms; damping ratio 0.8; weight 1.9.
pub fn simulated<R: Real>(mode: Mode) -> stage::Coeffs<R> {
    let section = bandpass::Coeffs {
        b2: R::lit(-0.016_986_936_943_368_59),
        a1: R::lit(-1.961_332_251_243_502_3),
        a2: R::lit(0.966_026_126_113_262_8),
        a: R::lit(0.016_986_936_943_368_59),
        b: R::lit(0.036_320_811_321_617_41),
        c: R::lit(0.138_161_308_463_350_34),
    };
    let oscillation = oscillation::Coeffs {
        b0: R::lit(0.053_486_731_356_617_98),
        b1: R::lit(0.002_262_495_254_415_846),
        b2: R::lit(-0.051_224_236_102_202_135),
        a1: R::lit(-1.890_764_042_032_348_2),
        a2: R::lit(0.895_289_032_541_179_9),
        preset_s1: R::lit(0.946_513_268_643_382),
        preset_s2: R::lit(-0.946_513_268_643_382),
        h: R::lit(0.946_513_268_643_382),
        r: R::lit(3.094_286_814_320_585),
        g: R::lit(0.034_571_282_215_389_665),
        g2: R::lit(0.069_142_564_430_779_33),
    };
    stage::Coeffs { mode, oscillation, gain: R::lit(-1.9), filter: band_pass(section), ..stage::Coeffs::default() }
}

/// Both stages of the application example.
pub fn example<R: Real>() -> Bench<R> {
    Bench::new(&[direct(), simulated(Mode::Indirect)])
}

fn band_pass<R: Real>(section: bandpass::Coeffs<R>) -> [filter::Coeffs<R>; 2] {
    let mut first = filter::Coeffs { kind: filter::Type::Bandpass, order: 1, ..filter::Coeffs::default() };
    first.bandpass[0] = section;
    [first, filter::Coeffs::default()]
}

/// White noise up to 8,000, from integers.
pub struct Noise(u32);

impl Default for Noise {
    fn default() -> Self {
        Self(1)
    }
}

impl Noise {
    /// The next value.
    pub fn next<R: Real>(&mut self) -> R {
        R::lit((f64::from(self.bits() >> 8) - 8_388_608.0) / 1024.0)
    }

    /// The next number.
    pub fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        self.0
    }
}

/// The bits of a real, for a comparison without tolerance.
pub fn bits<R: Real>(x: R) -> u64 {
    x.to_f64().to_bits()
}

/// The bits of all outputs.
pub fn all_bits<R: Real>(outputs: &Outputs<R>) -> (u64, u64, bool, bool, u32) {
    (bits(outputs.v_add), bits(outputs.v_add_calculated), outputs.limited, outputs.fault, outputs.error_id)
}

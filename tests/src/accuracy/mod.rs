//! Single precision against 80 digits: a stage of the reference and an independent model of it on the same samples of a moving axis.
//!
//! The signal is a move to 500,000 um/s with a vibration of 1,000 um/s at or next to f0, seen by an encoder of 10 nm. What is compared is what the
//! stage adds in the second half of the move.

pub mod filters;
pub mod fixed;
pub mod poles;

use crate::model::subject::read;
use filters::Polynomials;
use fixed::Fixed;
use generator::blocks;
use portable::{Block, Portable};
use reference::design::poles::Prototype;
use reference::ipc::{self, Ipc};
use reference::{bandpass, filter, section};
use std::f64::consts::TAU;
use std::fmt::Write;

/// Velocity of the move [um/s].
const VELOCITY: f64 = 500_000.0;
/// Amplitude of the vibration [um/s].
const VIBRATION: f64 = 1_000.0;
/// One increment of the encoder [um].
const INCREMENT: f64 = 0.01;
/// The highest f0 of a filter [Hz].
const HIGHEST: f64 = 500.0;
/// The shortest cycle time [ns].
const SHORTEST: f64 = 62_500.0;

/// What a stage has next to its band-pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Before {
    /// nothing
    Nothing,
    /// an all-pass at this part of f0, of this quality factor
    Allpass(f64, f64),
    /// the simulated oscillation with this damping ratio
    Oscillation(f64),
}

/// A stage.
#[derive(Clone, Copy, Debug)]
pub struct Cell {
    /// f0 Ts
    pub f0_ts: f64,
    /// of the band-pass
    pub prototype: Prototype,
    /// of the band-pass
    pub order: usize,
    /// of the band-pass
    pub q: f64,
    /// what stands before it
    pub before: Before,
    /// frequency of the vibration, as a part of f0
    pub vibration: f64,
}

/// What was found.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// signal-to-noise ratio [dB] while the axis moves
    pub ratio: f64,
    /// the same as the certificate states it
    pub stated: f64,
    /// what a cascade of biquads would have in its place; meaningless where something stands before the band-pass
    pub biquads: f64,
    /// cycles from the end of the move until the output is 0 and stays so; none: not within the record
    pub at_rest: Option<usize>,
}

impl Cell {
    fn cycle_time_ns(&self) -> f64 {
        (self.f0_ts / HIGHEST * 1e9).max(SHORTEST).ceil()
    }

    fn f0(&self) -> f64 {
        self.f0_ts / self.cycle_time_ns() * 1e9
    }

    /// Samples of the move: a multiple of what the slowest section takes to settle.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most some millions")]
    fn length(&self) -> usize {
        let before = match self.before {
            Before::Nothing => 0.0,
            Before::Allpass(part, q) => q / part,
            Before::Oscillation(damping) => 0.5 / damping,
        };
        let cycles = 10.0 * self.q.max(before) * self.order as f64;
        ((cycles / self.f0_ts) as usize).max(4_000)
    }

    /// Its set.
    fn set(&self) -> String {
        let prototype = match self.prototype {
            Prototype::CritDamping => "CRIT_DAMPING",
            Prototype::Butterworth => "BUTTERWORTH",
            Prototype::Bessel => "BESSEL",
        };
        let (order, f0, q) = (self.order, self.f0(), self.q);
        let bandpass = format!(
            "{{ type = 'BANDPASS', prototype = '{prototype}', order = {order}, fg_f0 = {f0:?}, q_factor = {q:?} }}"
        );
        let mut set = format!("cycle_time = \"{}us\"\n[axis.X]\nreal = \"f32\"\n", self.cycle_time_ns() / 1e3);
        set +=
            "getriebe = [{ dynamik.vb_max = 500000 }]\n[axis.X.lr_param.improved_position_control]\nenable = \"ON\"\n";
        set += "v_add_max_fact = 2000\n[[axis.X.lr_param.improved_position_control.stage]]\n";
        let (mode, filters) = match self.before {
            Before::Nothing => ("mode = 'DIRECT'".to_owned(), bandpass),
            Before::Oscillation(damping) => (format!("mode = 'INDIRECT'\nosc_damping = {damping:?}"), bandpass),
            Before::Allpass(part, q) => {
                let f0 = part * f0;
                let allpass = format!("{{ type = 'ALLPASS', fg_f0 = {f0:?}, q_factor = {q:?} }}");
                ("mode = 'DIRECT'".to_owned(), format!("{allpass}, {bandpass}"))
            }
        };
        let _ = writeln!(set, "{mode}\nfilter = [{filters}]");
        set
    }

    /// The same stage with 80 digits.
    fn model(&self) -> Vec<Polynomials> {
        let ts = Fixed::from(self.cycle_time_ns()) / Fixed::from(1e9);
        let f0_ts = |f0: f64| Fixed::from(f0) * &ts;
        let mut model = match self.before {
            Before::Nothing => vec![],
            Before::Oscillation(damping) => vec![filters::oscillation(f0_ts(self.f0()), damping)],
            Before::Allpass(part, q) => vec![filters::allpass(f0_ts(part * self.f0()), q)],
        };
        model.extend(filters::bandpass(self.prototype, self.order, f0_ts(self.f0()), self.q));
        model
    }

    /// Runs both.
    ///
    /// # Panics
    /// If the generator refuses the stage.
    #[must_use]
    pub fn run(&self) -> Found {
        let designed = read(&self.set());
        let kind = blocks::named("ipc").expect("the registry has the block");
        let mut leaves = kind.coefficients(&designed).into_iter();
        let coeffs: ipc::Coeffs<f32> = Portable::build(&mut || leaves.next().expect("all coefficients"));
        let (mut state, mut outputs) = (<Ipc as Block<f32>>::state(), <Ipc as Block<f32>>::outputs());
        let mut inputs = <Ipc as Block<f32>>::inputs(&coeffs);
        let (mut model, length) = (self.model(), self.length());
        let mut axis = Moving::new(self.vibration * self.f0(), self.cycle_time_ns() / 1e9, length);
        let [mut signal, mut noise, mut noise_of_biquads] = [0.0; 3];
        let mut biquads = [section::State::<f32>::default(); filter::MAX_ORDER];
        let mut moving = None;
        // As long again at rest, and what the slowest section takes to fall from 10^6 to nothing.
        for n in 0..3 * length {
            inputs.v_motor = if n < length { axis.next() } else { 0.0 };
            ipc::step(&mut state, &coeffs, &inputs, &mut outputs);
            if n < length {
                let x = Fixed::from(f64::from(inputs.v_motor));
                let y = model.iter_mut().fold(x, |x, filter| filter.step(x)).to_f64();
                let sections = biquads.iter_mut().zip(&coeffs.stage[0].filter[0].bandpass).take(self.order);
                let other = sections.fold(inputs.v_motor, |x, (state, coeffs)| bandpass::biquad(state, coeffs, x));
                if n >= length / 2 {
                    let error = f64::from(outputs.v_add_calculated) + y; // the weight is -1
                    signal += y * y;
                    noise += error * error;
                    noise_of_biquads += (f64::from(other) - y).powi(2);
                }
            } else if outputs.v_add_calculated.to_bits() != 0 {
                moving = Some(n + 1 - length);
            }
        }
        let at_rest = moving.unwrap_or(0);
        Found {
            ratio: 10.0 * (signal / noise).log10(),
            stated: stated(&designed),
            biquads: 10.0 * (signal / noise_of_biquads).log10(),
            at_rest: (at_rest < 2 * length).then_some(at_rest),
        }
    }
}

/// The ratio in the certificate's line.
fn stated(designed: &blocks::Designed) -> f64 {
    let blocks = blocks::blocks(designed).expect("no defect");
    let lines = blocks.iter().flat_map(|block| &block.certificate.lines);
    let ratio = lines.filter_map(|line| line.split_once("stage[0] ")?.1.strip_suffix(" dB")?.parse().ok()).next();
    ratio.expect("the certificate states the ratio")
}

/// The velocity of an axis as its encoder shows it.
struct Moving {
    /// vibration: cycles per sample
    f0_ts: f64,
    ts: f64,
    length: f64,
    n: f64,
    counts: f64,
}

impl Moving {
    fn new(f0: f64, ts: f64, length: usize) -> Self {
        Self { f0_ts: f0 * ts, ts, length: length as f64, n: 0.0, counts: 0.0 }
    }

    /// The velocity of the next cycle [um/s]: increments times 10 nm / Ts.
    #[expect(clippy::cast_possible_truncation, reason = "a sample of single precision")]
    fn next(&mut self) -> f32 {
        self.n += 1.0;
        let counts = (self.position() / INCREMENT).round();
        let velocity = (counts - self.counts) * INCREMENT / self.ts;
        self.counts = counts;
        if self.n < 8.0 { 0.0 } else { velocity as f32 }
    }

    /// Position [um]: it accelerates during a tenth of the record; the vibration is there from the beginning.
    fn position(&self) -> f64 {
        let ramp = self.length / 10.0;
        let cycles = if self.n < ramp { self.n * self.n / (2.0 * ramp) } else { self.n - ramp / 2.0 };
        let angle = TAU * (self.f0_ts * self.n).fract();
        VELOCITY * cycles * self.ts - VIBRATION * self.ts / (TAU * self.f0_ts) * angle.cos()
    }
}

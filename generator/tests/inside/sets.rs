//! Random filters, the same in every run. No assertion.

use generator::axis::{Axis, DirectSource, Enable, Filter, Ipc, Mode, Numbers, Prototype, Stage};
use portable::RealKind;

/// Cycle times [ns].
const CYCLES: [u32; 7] = [62_500, 125_000, 250_000, 500_000, 1_000_000, 2_000_000, 4_000_000];

/// A band-pass or an all-pass to be.
#[derive(Clone, Copy, Debug)]
pub struct Set {
    /// of a band-pass
    pub prototype: Prototype,
    /// of a band-pass
    pub order: usize,
    pub f0: f64,
    /// quality factor, 1 to 10
    pub q_factor: f64,
    /// cycle time [ns]
    pub cycle_time_ns: u32,
    /// f0 Ts, 6e-6 to 0.45
    pub product: f64,
}

impl Set {
    /// Cycle time [s].
    pub fn cycle_time(&self) -> f64 {
        f64::from(self.cycle_time_ns) / 1e9
    }
}

/// `count` sets: each prototype and order in turn, f0 Ts evenly in the logarithm, Q evenly.
pub fn sets(count: usize) -> impl Iterator<Item = Set> {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    (0..count).map(move |i| {
        let prototype = [Prototype::CritDamping, Prototype::Butterworth, Prototype::Bessel][i % 3];
        let product = 6e-6 * libm::pow(0.45 / 6e-6, random.unit());
        let cycle_time_ns = CYCLES[random.below(CYCLES.len())];
        Set {
            prototype,
            order: i / 3 % 3 + 1,
            f0: product / (f64::from(cycle_time_ns) / 1e9),
            q_factor: 1.0 + 9.0 * random.unit(),
            cycle_time_ns,
            product,
        }
    })
}

/// `count` axes of up to three stages: all modes, all kinds of filter, one cycle time for an axis. f0 Ts from 0.01 on, in single
/// precision from 6e-5 on.
pub fn axes(count: usize, real: RealKind) -> impl Iterator<Item = Axis> {
    let mut random = Random(0xD1B5_4A32_D192_ED03);
    let lowest = if real == RealKind::F32 { 6e-5 } else { 0.01 };
    (0..count).map(move |i| {
        let cycle_time_ns = CYCLES[random.below(CYCLES.len())];
        let stage = core::array::from_fn(|k| {
            (k == i % 3 || random.below(2) == 1).then(|| stage(&mut random, cycle_time_ns, lowest))
        });
        let enable = [Enable::Off, Enable::On, Enable::DryRun][random.below(3)];
        let v_add_max_fact = u32::try_from(random.below(2001)).expect("below 2001");
        let v_max = libm::round(1.0 + 2e6 * random.unit());
        let of = axis(real, cycle_time_ns, stage);
        Axis { ipc: Ipc { enable, v_add_max_fact, v_max, fade: random.unit(), ..of.ipc }, ..of }
    })
}

/// An axis with a limit of 530000.
pub fn axis(real: RealKind, cycle_time_ns: u32, stage: [Option<Stage>; 3]) -> Axis {
    Axis {
        excitation: None,
        short_names: false,
        counts_calls: false,
        name: "X".to_owned(),
        real,
        cycle_time_ns,
        ipc: Ipc {
            enable: Enable::On,
            v_add_max_fact: 1000,
            v_max: 530_000.0,
            fade: 0.1,
            ride_through: 0,
            numbers: Numbers::Fixed,
            watch: false,
            delay_cycles: None,
            stage,
        },
        control: generator::axis::Control::default(),
        canonical: String::new(),
        drive: Default::default(),
        canonical_of: Default::default(),
    }
}

fn stage(random: &mut Random, cycle_time_ns: u32, lowest: f64) -> Stage {
    let osc_damping = 0.01 + 0.98 * random.unit();
    let mode = match random.below(4) {
        0 => Mode::Direct { source: DirectSource::Motor },
        1 => Mode::Direct { source: DirectSource::Direct },
        2 => Mode::Indirect { osc_damping },
        _ => Mode::SetPoint { osc_damping },
    };
    let mut filter = [bandpass(random, cycle_time_ns, lowest), Filter::NoFilter];
    match random.below(3) {
        0 => {}
        1 => filter[1] = bandpass(random, cycle_time_ns, lowest),
        _ => filter[1] = Filter::Allpass { f0: f0(random, cycle_time_ns, lowest), q_factor: 1.0 + 9.0 * random.unit() },
    }
    if random.below(2) == 1 {
        filter.swap(0, 1);
    }
    let weight_fact_num = u32::try_from(1 + random.below(1000)).expect("below 1001");
    Stage { mode, weight_fact_num, weight_fact_denom: 100, filter }
}

fn bandpass(random: &mut Random, cycle_time_ns: u32, lowest: f64) -> Filter {
    Filter::Bandpass {
        prototype: [Prototype::CritDamping, Prototype::Butterworth, Prototype::Bessel][random.below(3)],
        order: 1 + random.below(3),
        f0: f0(random, cycle_time_ns, lowest),
        q_factor: 1.0 + 9.0 * random.unit(),
    }
}

/// f0 Ts from the lowest one to 0.45.
fn f0(random: &mut Random, cycle_time_ns: u32, lowest: f64) -> f64 {
    lowest * libm::pow(0.45 / lowest, random.unit()) / (f64::from(cycle_time_ns) / 1e9)
}

/// xorshift64
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// In 0..1.
    pub fn unit(&mut self) -> f64 {
        let [high, low] = [self.next() >> 38, self.next() >> 38].map(|bits| u32::try_from(bits).expect("26 bits"));
        (f64::from(high) + f64::from(low) / 67_108_864.0) / 67_108_864.0
    }

    /// In 0..`count`.
    pub fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.next() >> 33).expect("31 bits") % count
    }
}

/// Coefficients of a filter at the cycle time [s].
pub fn filter(filter: &Filter, cycle_time: f64) -> reference::filter::Coeffs<f64> {
    let mode = Mode::Direct { source: DirectSource::Motor };
    let stage = Stage { mode, weight_fact_num: 1, weight_fact_denom: 1, filter: [*filter, Filter::NoFilter] };
    generator::blocks::ipc::stage::stage(0, &stage, cycle_time).coeffs.filter[0]
}

//! What the parameters of an axis mean for its blocks: which quantity goes where, and every factor as an exact number. Nothing
//! that changes from cycle to cycle.

use super::exact::Exact;
use super::parameters::{
    ACCELERATION, ADDITIVE_TORQUE, ADDITIVE_VELOCITY, Bits, JERK, JERK_TORQUE, Location, Mode, Pair, Parameters,
    VELOCITY,
};

/// 2 pi, 37 digits after the point.
const TWO_PI: u128 = 62_831_853_071_795_864_769_252_867_665_590_057_684;

/// Factors of v, a and j in a sum; `None`: the sum has no such term.
pub type Terms = [Option<Exact>; 3];

/// A delay in cycles: whole ones, and the rest as a fraction.
#[derive(Clone, Debug)]
pub struct Delay {
    /// N
    pub whole: usize,
    /// 1 - f and f; `None`: f is 0
    pub parts: Option<[Exact; 2]>,
}

/// The coefficients of an axis.
#[derive(Clone, Debug)]
pub struct Coefficients {
    /// unit roundoff of the real type
    pub u: f64,
    /// largest magnitude of a number in range
    pub largest: f64,
    /// cycle time [ns]
    pub cycle_ns: u32,
    /// W
    pub weight: Exact,
    /// active despite G137; inactive despite G135
    pub always: bool,
    /// inactive despite G135
    pub never: bool,
    /// of `v_feedforward`: 1, Ta, Tj
    pub conventional: Terms,
    /// of `v_additive`: 1, and on a PROFIdrive Ta, Tj
    pub additive: Terms,
    /// of `additive_torque`: `torque_acceleration` and `torque_jerk`
    pub torque: Terms,
    /// P-AXIS-00389, 00390, 00547
    pub delays: [Delay; 3],
    /// `velocity_scale` and the process datum
    pub velocity: Option<(Exact, Bits)>,
    /// process datum of the additive torque
    pub torque_bits: Option<Bits>,
    /// where the position is controlled
    pub location: Location,
    /// whether the controller of the CNC takes `following_error` instead of both positions: in single precision
    pub takes_following_error: bool,
    /// Kv [1/s]
    pub kv: Exact,
    /// `manipulated_scale` and the process datum
    pub manipulated: (Exact, Bits),
    /// 10 R, increments per um
    pub increments: Exact,
    /// cycles by which the position comes after the feedforward
    pub shift: usize,
    /// whether `v_add` exists: an active stage, or a slave whose master has one
    pub has_v_add: bool,
    /// on a gantry slave: the master's limit of `v_add`, where the master has a stage
    pub slave: Option<Exact>,
    /// limit of `v_add`
    pub limit: Exact,
    /// whether the stages run here: not on a slave
    pub runs_stages: bool,
}

impl Coefficients {
    /// Of an axis. The formulas and their sources stand in [`super`].
    #[must_use]
    pub fn new(p: &Parameters) -> Self {
        let ways = Ways::new(p);
        let location = p.location();
        let of_load = |scale: Exact| scale.times(&quotient([p.load, 1_000_000]));
        let torque = of_load(ways.torque_of_a_load(p));
        let weight_of_acceleration = quotient(p.vs_a);
        let jerk = quotient(jerk_fact(p));
        // A torque alone leads nothing that the position could come after.
        let leads = [&ways.conventional, &ways.additive].iter().any(|way| way.contains(&true));
        Self {
            u: if p.single { f64::from(f32::EPSILON) / 2.0 } else { f64::EPSILON / 2.0 },
            largest: if p.single { 1e9 } else { 1e15 },
            cycle_ns: p.cycle_ns,
            weight: quotient(p.vs_v),
            always: p.default_active,
            never: p.global_disable,
            conventional: terms(p, ways.conventional),
            additive: terms(p, ways.additive),
            torque: [
                None,
                ways.torque[1].then(|| torque.times(&weight_of_acceleration)),
                ways.torque[2].then(|| torque.times(&jerk)),
            ],
            delays: p.delay_us.map(|us| Delay::new(us, p.cycle_ns)),
            velocity: p.velocity_bits.map(|bits| (velocity_scale(p), bits)),
            torque_bits: p.torque_bits.filter(|_| ways.torque.contains(&true)),
            location,
            takes_following_error: p.single && location == Location::Cnc,
            kv: Exact::ratio(p.kv.unwrap_or(1000), 100),
            manipulated: (Exact::ratio(60, 1_000_000).times(&quotient(p.multi_gain)), p.command_bits),
            increments: Exact::given(10.0).times(&resolution(p)),
            shift: match p.shift_time {
                _ if location != Location::Profidrive || !(leads || ways.torque.contains(&true)) => 0,
                given => given.unwrap_or(3) as usize,
            },
            has_v_add: match p.master {
                Some(master) => master.has_stage,
                None => !p.stages.is_empty(),
            },
            slave: p.master.filter(|master| master.has_stage).map(|master| limit(master.v_add_max_fact, master.vb_max)),
            limit: limit(p.v_add_max_fact, p.vb_max),
            runs_stages: p.master.is_none() && !p.stages.is_empty(),
        }
    }

    /// Whether some stage reads what a mode reads.
    #[must_use]
    pub fn reads(p: &Parameters, mode: &[Mode]) -> bool {
        p.master.is_none() && p.stages.iter().any(|stage| mode.contains(&stage.mode))
    }
}

impl Delay {
    /// d = (N + f) Ts; outside of 0 to below six cycles it is corrected to 0 (70348, 70349).
    fn new(us: u32, cycle_ns: u32) -> Self {
        let ns = u64::from(us) * 1000;
        let cycle = u64::from(cycle_ns);
        let (whole, rest) = if ns < 6 * cycle { (ns / cycle, ns % cycle) } else { (0, 0) };
        let rest = u32::try_from(rest).expect("below a cycle");
        let parts = (rest != 0).then(|| [Exact::ratio(cycle_ns - rest, cycle_ns), Exact::ratio(rest, cycle_ns)]);
        Self { whole: usize::try_from(whole).expect("below 6"), parts }
    }
}

/// Which of v, a, j goes which way.
struct Ways {
    conventional: [bool; 3],
    additive: [bool; 3],
    torque: [bool; 3],
}

impl Ways {
    fn new(p: &Parameters) -> Self {
        let has = |bit: u32| p.word & bit != 0;
        let is = |pair: Pair| pair[0] != 0 && pair[1] != 0;
        let weighted = is(p.vs_v);
        let has_torque =
            weighted && p.torque_bits.is_some() && p.torque_scale[1] != 0 && p.reference != 0 && p.load != 0;
        // What a weight, a time constant, a jerk factor or a load of 0 weights is left out, and so is a jerk that has the time
        // constant. A v_reso_num of 0 leaves the quantity in: it is read, and what comes of it is 0.
        let has_jerk = jerk_fact(p)[0] != 0;
        let asked = [has(VELOCITY), has(ACCELERATION), has(JERK)];
        let to_torque = [false, has(ADDITIVE_TORQUE), has(JERK_TORQUE)];
        let allowed = [weighted, weighted && is(p.vs_a), weighted && is(p.vs_a) && has_jerk];
        let all_additive = p.location() == Location::Profidrive;
        let additive_is_on = p.velocity_bits.is_some();
        let goes_additive = |i: usize| has(ADDITIVE_VELOCITY) && (i == 0 || all_additive);
        let along = |i: usize| asked[i] && allowed[i] && !to_torque[i];
        Self {
            conventional: [0, 1, 2].map(|i| along(i) && !goes_additive(i)),
            additive: [0, 1, 2].map(|i| along(i) && goes_additive(i) && additive_is_on),
            torque: [false, to_torque[1] && has_torque && is(p.vs_a), to_torque[2] && has_torque && has_jerk],
        }
    }

    /// Increments of the torque for 1 um/s^2 and a load of 1, without the weight of the acceleration.
    fn torque_of_a_load(&self, p: &Parameters) -> Exact {
        if !self.torque.contains(&true) {
            return Exact::zero();
        }
        let moved = if p.linear {
            Exact::ratio(1, 1_000_000)
        } else {
            let turns = resolution(p).over(&Exact::given(f64::from(p.incr_per_rev)));
            Exact::given(10.0).times(&turns).times(&Exact::decimal(TWO_PI, 37))
        };
        moved.over(&Exact::ratio(p.reference, 1000)).times(&quotient(p.torque_scale))
    }
}

/// 1, Ta, Tj of a sum that has them: Ta = vs_a 1e-6, Tj = jf Ta^2.
fn terms(p: &Parameters, has: [bool; 3]) -> Terms {
    let ta = quotient(p.vs_a).times(&Exact::ratio(1, 1_000_000));
    let tj = quotient(jerk_fact(p)).times(&ta).times(&ta);
    let mut factors = [Exact::given(1.0), ta, tj].into_iter();
    has.map(|has| factors.next().filter(|_| has))
}

/// `jerk_fact_num` / `jerk_fact_denom`; a denominator of 0 is corrected to 100 (110473).
fn jerk_fact(p: &Parameters) -> Pair {
    let [num, denom] = p.jerk_fact;
    [num, if denom == 0 { 100 } else { denom }]
}

/// `v_reso_num` / `v_reso_denom` * tb.
fn velocity_scale(p: &Parameters) -> Exact {
    let tb = match p.v_time_base {
        0 => Exact::given(60.0),
        1 => Exact::given(1.0),
        _ => Exact::ratio(p.cycle_ns, 1_000_000_000),
    };
    quotient(p.v_reso).times(&tb)
}

/// R [increments per 0.1 um].
fn resolution(p: &Parameters) -> Exact {
    let wegauf = quotient(p.wegauf);
    let [num, denom] = p.feed_const;
    if [num, denom] == [1, 1] {
        return wegauf;
    }
    Exact::given(f64::from(p.incr_per_rev)).times(&wegauf).times(&quotient([denom, num]))
}

/// `v_add_max_fact`/1000 * `vb_max`.
fn limit(v_add_max_fact: u32, vb_max: u32) -> Exact {
    Exact::ratio(v_add_max_fact, 1000).times(&Exact::given(f64::from(vb_max)))
}

/// A quotient of parameters; one with the denominator 0 is used nowhere.
fn quotient([num, denom]: Pair) -> Exact {
    Exact::ratio(num, denom.max(1))
}

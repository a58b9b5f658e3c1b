//! Numbers typed at the demonstration plant while it moves: f0 from 50 to 53 Hz, the weight from 0.001 to 3.

use axgen_tests::model::subject;
use generator::blocks::Designed;
use golden::case::named_block;
use golden::subject::Subject;
use machine::closed_loop::{self, Position, Record, Signals};
use machine::measure::{amplitude, dwells};
use machine::plant::DEMONSTRATION;
use machine::sequence::Sequence;

/// The axis of the demonstration plant with one stage, and its controller designs sets.
fn axis(f0: f64, weight: f64) -> Designed {
    subject::read(&format!(
        "cycle_time = '1ms'\n[axis.X]\ntunable = 'parameters'\nlowest_f0 = 10\ngetriebe = [{{ dynamik.vb_max = 530000 }}]\n\
         [axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = 400\nstage = [{{ mode = 'DIRECT', \
         weight_fact_num = {}, weight_fact_denom = 1000, filter = [{{ order = 1, fg_f0 = {f0}, q_factor = 10 }}] }}]\n",
        weight * 1000.0
    ))
}

/// Both blocks, and what the glue of an operator does: a piece of a design in each cycle, a complete set is passed on.
struct Bench {
    ipc: Subject,
    design: Subject,
    cycle: usize,
    /// the numbers of the sets in use, in their order
    used: Vec<f64>,
}

impl Bench {
    fn new(designed: &Designed) -> Self {
        let [ipc, design] =
            ["ipc", "set_design"].map(|name| Subject::start(designed, &named_block(designed, name).unwrap()));
        Self { ipc, design, cycle: 0, used: Vec::new() }
    }

    /// A cycle. `typed`: the cycle in which an input is typed, its name and its value.
    fn step(&mut self, signals: &Signals, typed: &[(usize, &str, f64)]) -> f64 {
        for (_, input, value) in typed.iter().filter(|(cycle, ..)| *cycle == self.cycle) {
            assert!(self.design.set(input, *value), "{input}");
        }
        let is_pressed = typed.iter().any(|(cycle, ..)| (*cycle..cycle + 5).contains(&self.cycle));
        self.design.set("execute", f64::from(u8::from(is_pressed)));
        self.design.step();
        if self.design.get("designed") > 0.0 {
            for at in 0..self.ipc.inputs.shape.signals.len() {
                let name = self.ipc.inputs.shape.signals[at].name.clone();
                if name.starts_with("params.") {
                    self.ipc.set(&name, self.design.get(&name));
                }
            }
        }
        self.cycle += 1;
        let v_add = self.ipc.cycle(signals);
        assert_eq!((self.ipc.get("fault"), self.ipc.get("error_id")), (0.0, 0.0), "cycle {}", self.cycle);
        let active = self.ipc.get("active_set");
        if active != 0.0 && self.used.last() != Some(&active) {
            self.used.push(active);
        }
        v_add
    }
}

fn run(bench: &mut Bench, typed: &[(usize, &str, f64)]) -> Record {
    (0..300).for_each(|_| _ = bench.step(&Signals::default(), &[]));
    bench.cycle = 0;
    let moves = Sequence { dwell: 4.0, ..Sequence::DEMONSTRATION };
    closed_loop::run(DEMONSTRATION.at_rest(), &Position::DEMONSTRATION, &moves, |signals| bench.step(signals, typed))
}

fn largest_step(record: &Record) -> f64 {
    record.v_add.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max)
}

/// The set number of an axis's own parameters.
fn set_number(of: &Designed) -> f64 {
    let mut bench = Bench::new(of);
    run(&mut bench, &[]);
    bench.used[0]
}

/// A step of v_add is at most one of the fade, which is limit / fade_cycles, and twice the largest step of a run in which
/// nothing is typed.
#[test]
fn numbers_typed_while_the_axis_moves_do_not_step_v_add() {
    let (start, end) = (axis(50.0, 0.001), axis(53.0, 3.0));
    let mut usual = Bench::new(&end);
    let undisturbed = run(&mut usual, &[]);
    let mut bench = Bench::new(&start);
    // In the dwells: at full speed.
    let typed = [(1_500, "stage[0].filter[0].f0", 53.0), (3_000, "stage[0].weight", 3.0)];
    let record = run(&mut bench, &typed);
    let expected = [set_number(&start), set_number(&axis(53.0, 0.001)), set_number(&end)];
    assert_eq!(bench.used, expected);
    let bound = 212_000.0 / 100.0 + 2.0 * largest_step(&undisturbed);
    let step = largest_step(&record);
    eprintln!("largest step of v_add {step:.0} um/s, undisturbed {:.0}, bound {bound:.0}", largest_step(&undisturbed));
    assert!(step <= bound, "{step} {bound}");
    // On the way back all of it acts.
    let at_53 = |record: &Record| {
        let window = dwells(record).nth(1).unwrap();
        amplitude(&record.sensor[window], record.cycle, [50.0, 56.0])
    };
    let mut off = Bench::new(&start);
    let [without, with, usual] = [&run(&mut off, &[]), &record, &undisturbed].map(at_53);
    eprintln!("53 Hz: {without:.3} m/s^2 without, {with:.3} with the typed numbers, {usual:.3} as generated");
    assert!(with < 0.5 * without && (with / usual - 1.0).abs() < 0.02, "{without} {with} {usual}");
}

//! The block `FB_damping_tuning` of the example with the emitted blocks of `tuning.toml`: what is typed, and what is shown.

#![expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "small positive numbers of a test")]

use super::project::{all, stem};
use super::swap;
use generator::axis::{Filter, Mode};
use generator::blocks::{Block as Emitted, Designed, calls_of_design, named};
use generator::config::ListOptions;
use golden::case::named_block;
use golden::engine::emitted;
use portable::{Literal, Portable, RealKind};
use reference::sets::{Coeffs, params};
use st::{Block, Dialect, Instance, Program};
use std::path::Path;

const TUNING: &str = "POUs/FB_damping_tuning.TcPOU";
/// The program around it, as the head of the block shows it.
const PROGRAM: &str = include_str!("tuning.TcPOU");

/// The emitted blocks of the axis, and the text of the block that is tested.
struct Tuning {
    designed: Designed,
    text: String,
}

impl Tuning {
    fn of_example() -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/twincat");
        let (set, report) = generator::pipeline::read(&folder.join("tuning.toml"), &ListOptions::default());
        let designed = set.unwrap_or_else(|| panic!("{report:#?}")).axes.into_iter().next().unwrap();
        Self { designed, text: std::fs::read_to_string(folder.join(TUNING)).unwrap() }
    }

    /// The program with another text of the block, without one of its assignments.
    fn program(&self, text: &str, without: Option<usize>) -> Result<Block, String> {
        let mut program = Program::new(RealKind::F64);
        let block = |name: &str| named_block(&self.designed, name).unwrap();
        let (ipc, design) = (block("ipc"), block("set_design"));
        let types = emitted::types(&self.designed, &ipc).unwrap().unwrap();
        program.structure(&types.text).unwrap();
        for block in [&ipc, &design] {
            program.add(self.emitted(block));
        }
        let tuning = program.read(text, stem(TUNING)).map_err(|said| all(&said))?;
        program.add(match without {
            Some(which) => tuning.without(which).ok_or("no such assignment")?,
            None => tuning,
        });
        program.read(PROGRAM, "MAIN").map_err(|said| all(&said))
    }

    fn emitted(&self, block: &Emitted) -> Block {
        let [file, _] = emitted::files(Dialect::TwinCat, &self.designed, block).unwrap();
        emitted::read(Dialect::TwinCat, &file, &self.designed, block).unwrap()
    }

    /// The number of the generator's set of other numbers.
    fn set_id(&self, typed: &[(&str, f64)]) -> u32 {
        let mut axis = self.designed.axis.clone();
        let stage = axis.ipc.stage[0].as_mut().unwrap();
        for &(name, value) in typed {
            match (name, &mut stage.filter[0], &mut stage.mode) {
                ("f0", Filter::Bandpass { f0, .. }, _) => *f0 = value,
                ("q_factor", Filter::Bandpass { q_factor, .. }, _) => *q_factor = value,
                ("damping", _, Mode::Indirect { osc_damping }) => *osc_damping = value,
                ("weight", ..) => stage.weight_fact_num = (value * 100.0) as u32,
                ("largest_velocity", ..) => axis.ipc.v_add_max_fact = (value * 2.0) as u32,
                _ => panic!("{name}"),
            }
        }
        let mut numbers = named("ipc").unwrap().coefficients(&Designed::from(axis)).into_iter();
        params(&Coeffs::<f64>::build(&mut || numbers.next().unwrap())).set_id
    }
}

/// An operator in front of a running program.
struct Operator<'a> {
    run: Instance<'a>,
}

impl Operator<'_> {
    fn types(&mut self, typed: &[(&str, f64)]) {
        for &(name, value) in typed {
            assert!(self.run.set(name, Literal::F64(value)), "{name}");
        }
    }

    fn button(&mut self, pressed: bool, cycles: usize) {
        assert!(self.run.set("button", Literal::Bool(pressed)));
        (0..cycles).for_each(|_| self.run.cycle(&[], &mut Vec::new()));
    }

    /// Whether it is busy, the lamp, the id, and the set in use.
    fn shown(&self) -> (bool, bool, u32, u32) {
        let value = |name: &str| super::world::get(&self.run, name);
        let Literal::Bool(busy) = value("busy") else { panic!("busy is a BOOL") };
        let Literal::Bool(lamp) = value("lamp") else { panic!("lamp is a BOOL") };
        let [id, set] = ["error_id", "active_set"].map(|name| match value(name) {
            Literal::U32(id) => id,
            _ => panic!("{name} is a UDINT"),
        });
        (busy, lamp, id, set)
    }
}

/// What each input is when it is wrong, and the id of that.
const WRONG: [(&str, f64, u32); 6] = [
    ("f0", 451.0, 61),
    ("f0", 19.0, 62),
    ("q_factor", 11.0, 63),
    ("damping", 1.0, 64),
    ("weight", 8.0, 65),
    ("largest_velocity", 26.0, 66),
];

/// What differs from the sequence that an operator expects.
fn differs(tuning: &Tuning, program: &Block) -> Result<(), String> {
    let mut operator = Operator { run: program.start(&[], &[], &[]).map_err(|said| all(&said))? };
    let design = calls_of_design(&tuning.designed);
    let change = design + 2 * 100 + 2 * 5 * 12; // a fade out and in, two checks of at most 12 numbers
    let good = [("f0", 53.0), ("q_factor", 3.0), ("damping", 0.8), ("weight", 0.25), ("largest_velocity", 20.0)];
    let [first, second] = [tuning.set_id(&[]), tuning.set_id(&good)];
    let expect = |operator: &Operator<'_>, what: &str, expected| {
        let shown = operator.shown();
        if shown == expected { Ok(()) } else { Err(format!("{what}: {shown:?}, expected {expected:?}")) }
    };

    operator.button(false, change);
    expect(&operator, "before the first press", (false, false, 0, first))?;
    operator.types(&good);
    operator.button(true, 1);
    // What is typed during a design waits for the next press, and a press during it is ignored.
    operator.types(&[("f0", 60.0), ("q_factor", 4.0), ("damping", 0.2), ("weight", 0.5), ("largest_velocity", 10.0)]);
    operator.button(true, 10);
    expect(&operator, "during the design", (true, false, 0, first))?;
    operator.button(false, 1);
    operator.button(true, design);
    expect(&operator, "a set that is not in use yet", (false, false, 0, first))?;
    operator.button(true, change);
    expect(&operator, "a set in use, the button held", (false, true, 0, second))?;
    for (name, value, id) in WRONG {
        operator.types(&good);
        operator.types(&[(name, value)]);
        operator.button(false, 1);
        operator.button(true, change);
        expect(&operator, name, (false, false, id, second))?;
    }
    operator.types(&good);
    operator.button(false, 1);
    operator.button(true, change);
    expect(&operator, "the numbers of the set in use", (false, true, 0, second))?;
    let refused = super::world::get(&operator.run, "block_error_id");
    if refused == Literal::U32(0) { Ok(()) } else { Err(format!("the block ipc reports {refused:?}")) }
}

#[test]
fn what_is_typed_is_designed_and_what_is_refused_changes_nothing() {
    let tuning = Tuning::of_example();
    differs(&tuning, &tuning.program(&tuning.text, None).unwrap()).unwrap();
}

#[test]
fn mistakes_in_the_tuning_are_found() {
    let tuning = Tuning::of_example();
    for (old, new) in [
        ("button AND NOT button_before AND NOT design.active", "button AND NOT design.active"),
        ("button AND NOT button_before AND NOT design.active", "button AND NOT button_before"),
        ("um_per_mm * largest_velocity", "largest_velocity"),
        ("stage0_filter0_f0 := f0_taken", "stage0_filter0_f0 := f0"),
        ("stage0_weight := weight_taken", "stage0_weight := damping_taken"),
        ("IF design.designed THEN", "IF design.active THEN"),
        ("design.designed AND (active_set = params.set_id)", "active_set = params.set_id"),
        ("design.designed AND (active_set = params.set_id)", "design.designed"),
    ] {
        let program = tuning.program(&swap(&tuning.text, old, new), None);
        assert!(program.is_ok_and(|program| differs(&tuning, &program).is_err()), "{new}");
    }
    let mut count = 0;
    while let Ok(program) = tuning.program(&tuning.text, Some(count)) {
        assert!(differs(&tuning, &program).is_err(), "assignment {count} can be lost");
        count += 1;
    }
    assert_eq!(count, 11);
}

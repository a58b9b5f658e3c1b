//! The self-tests that Structured Text gets: each finds no difference in its block, in every dialect, and finds a planted fault.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::print_stdout, reason = "`--nocapture` shows how many faults were planted and found")]

use axgen_tests::cases::{in_both_real_types, title};
use axgen_tests::environment::by_depth;
use axgen_tests::model::subject::read;
use generator::blocks::blocks;
use generator::target::File;
use golden::case::{self, Case, VECTOR_SAMPLES};
use golden::engine::{self, Engine, emitted};
use golden::samples::Samples;
use rayon::prelude::*;
use st::{Block, Dialect};

/// What is emitted of a case in a dialect: the block, which was read once, and the file of its self-test.
struct Emitted<'a> {
    case: &'a Case,
    dialect: Dialect,
    block: Block,
    test: File,
}

impl<'a> Emitted<'a> {
    fn of(case: &'a Case, dialect: Dialect) -> Self {
        let failed = |failure| panic!("{}: {dialect:?}: {failure}", title(case));
        let [file, test] = emitted::files(dialect, &case.axis, &case.block).unwrap_or_else(failed);
        let block =
            emitted::read(dialect, &file, &case.axis, &case.block).unwrap_or_else(|failure| panic!("{failure}"));
        Self { case, dialect, block, test }
    }

    /// What the self-test says of the block, or of one that was changed.
    fn differing(&self, block: &Block) -> i32 {
        let Self { case, dialect, .. } = *self;
        let said = emitted::run_self_test(dialect, (&self.test, block), &case.axis, &case.block);
        let (done, differing) = said.unwrap_or_else(|failure| panic!("{}: {dialect:?}: {failure}", title(case)));
        assert!(done, "{}: {dialect:?}: it does not come to its end", title(case));
        differing
    }
}

#[test]
fn a_self_test_finds_nothing_in_its_block() {
    in_both_real_types().par_iter().enumerate().for_each(|(number, case)| {
        // The dialects differ in names and declarations: a plain run has the plain one and one of the others in turn.
        let more = &Dialect::ALL[1..];
        let dialects = [&Dialect::ALL[..1], by_depth(&more[number % more.len()..][..1], more, more)].concat();
        for dialect in dialects {
            let emitted = Emitted::of(case, dialect);
            assert_eq!(emitted.differing(&emitted.block), 0, "{}: {dialect:?}", title(case));
            assert_eq!(emitted.differing(&emitted.block.clone().wide()), 0, "{}: {dialect:?}", title(case));
        }
    });
}

#[test]
fn a_self_test_of_an_excitation_reaches_its_amplitude() {
    for keys in ["", "cycle_counter = true"] {
        let set = format!(
            "cycle_time = '1ms'\n[axis.X]\n{keys}\nexcitation.amplitude = 5000\ngetriebe = [{{ dynamik.vb_max = 500000 }}]"
        );
        let designed = read(&set);
        let block = blocks(&designed).unwrap().into_iter().find(|block| block.program.block == "excitation").unwrap();
        let [_, test] = emitted::files(Dialect::Plain, &designed, &block).unwrap();
        assert!(
            ["expected_v_excite := 5000.0;", "expected_v_excite := -5000.0;"].iter().all(|row| test.text.contains(row)),
            "{keys}"
        );
    }
}

/// Of a spindle no self-test claims to find it: few cycles of its noise compute a position, and fewer show the last bit.
const FUSED: &str = "a fused operation";

/// A fault, by its number; none: there are no more.
type Plant = fn(&Block, usize) -> Option<Block>;

#[derive(Clone, Copy, Debug, Default)]
struct Count {
    planted: usize,
    found: usize,
    /// seen in the outputs of the case's own stimulus, and not found
    missed: usize,
}

/// Whether a changed block gives other outputs in the case's own stimulus.
fn shows(case: &Case, inputs: &Samples, expected: &Samples, block: &Block) -> bool {
    emitted::run_read(Dialect::Plain, block, &case.block, inputs).unwrap() != *expected
}

/// So many that are missed, of a case in which none is found, are no accident of which of them were planted.
fn too_many() -> usize {
    by_depth(6, 4, 1)
}

/// One in 25 of those that are found. Which of `part` are planted is chance: two standard deviations more.
fn most_missed(found: usize, part: usize) -> usize {
    found.div_ceil(25) + if part == 1 { 0 } else { 2 * found.div_ceil(25).isqrt() }
}

/// Of `part` faults of a case one is planted, in turn.
fn count(case: &Case, turn: usize, name: &str, (plant, part): (Plant, usize)) -> Count {
    let inputs = case::inputs(case, VECTOR_SAMPLES).unwrap();
    let expected = engine::run(Engine::Reference, &case.axis, &case.block, &inputs).unwrap();
    let emitted = Emitted::of(case, Dialect::Plain);
    let mut count = Count::default();
    let planted = (turn % part..).step_by(part);
    for changed in planted.map_while(|which| plant(&emitted.block, which)) {
        let is_found = emitted.differing(&changed) > 0;
        count.planted += 1;
        count.found += usize::from(is_found);
        count.missed += usize::from(!is_found && shows(case, &inputs, &expected, &changed));
    }
    let is_claimed = !(case.block.program.block == "spindle" && name == FUSED);
    assert!(
        !is_claimed || count.found > 0 || count.missed < too_many(),
        "{}: no {name} is found, {} can be seen",
        title(case),
        count.missed
    );
    count
}

/// Each single fault that is planted, one in so many or with `AXGEN_EVERY_LEVEL` all, in each case's block: in each case
/// some of each kind are found, and of those that the case's own stimulus shows at most one in 25 is missed. Many that are
/// planted can be seen by nobody: a number next to a comparison, a value that is there already. The numbers of a spindle
/// decide when it changes: a scenario in a closed loop shows what a self-test, which comes near few of them, does not. There
/// at most as many are missed as are found, and of fused operations nothing is claimed.
#[test]
fn a_self_test_finds_planted_faults() {
    // A block has few numbers and places to fuse, and many statements.
    let (few, many) = (by_depth(12, 6, 1), by_depth(80, 40, 1));
    let plants: [(&str, Plant, usize); 3] = [
        ("another constant", Block::with_other_constant, few),
        ("a lost statement", Block::without, many),
        (FUSED, |block, which| block.contracted(Some(which)), few),
    ];
    for (name, plant, part) in plants {
        // The self-test of an excitation never starts it: it holds the button from its first sample on.
        let mut cases = in_both_real_types();
        cases.retain(|case| case.block.program.block != "excitation");
        let counts: Vec<(bool, Count)> = cases
            .par_iter()
            .enumerate()
            .map(|(turn, case)| (case.block.program.block == "spindle", count(case, turn, name, (plant, part))))
            .collect();
        let all = |is_spindle: bool| {
            counts.iter().filter(|(of, _)| *of == is_spindle).fold(Count::default(), |all, (_, of)| Count {
                planted: all.planted + of.planted,
                found: all.found + of.found,
                missed: all.missed + of.missed,
            })
        };
        let [spindles, others] = [all(true), all(false)];
        println!("{name}: spindles {spindles:?}, others {others:?}");
        assert!(
            others.found * part > 200 && others.missed <= most_missed(others.found, part),
            "{name}: {} of {}",
            others.missed,
            others.found
        );
        assert!(
            name == FUSED || spindles.missed <= spindles.found,
            "{name}, spindles: {} of {}",
            spindles.missed,
            spindles.found
        );
    }
}

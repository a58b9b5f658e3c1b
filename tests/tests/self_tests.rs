//! The self-tests that Structured Text gets: each finds no difference in its block, in every dialect, and finds a planted fault.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]
#![expect(clippy::print_stdout, reason = "`--nocapture` shows how many faults were planted and found")]

use axgen_tests::cases::{in_both_real_types, title};
use golden::case::{self, Case, VECTOR_SAMPLES};
use golden::engine::{self, Engine, emitted};
use golden::samples::Samples;
use rayon::prelude::*;
use st::{Block, Dialect};

const DIALECTS: [Dialect; 4] = [Dialect::Plain, Dialect::TwinCat, Dialect::Codesys, Dialect::Scl];

/// What the self-test of a case says of a block that was changed.
fn differing(case: &Case, dialect: Dialect, changed: impl FnOnce(Block) -> Option<Block>) -> Option<i32> {
    let failed = |failure| panic!("{}: {dialect:?}: {failure}", title(case));
    let [file, test] = emitted::files(dialect, &case.axis, &case.block).unwrap_or_else(failed);
    let block = emitted::read(dialect, &file, &case.axis, &case.block).unwrap_or_else(|failure| panic!("{failure}"));
    let block = changed(block)?;
    let said = emitted::run_self_test(dialect, (&test, &block), &case.axis, &case.block);
    let (done, differing) = said.unwrap_or_else(|failure| panic!("{}: {dialect:?}: {failure}", title(case)));
    assert!(done, "{}: {dialect:?}: it does not come to its end", title(case));
    Some(differing)
}

#[test]
fn a_self_test_finds_nothing_in_its_block() {
    in_both_real_types().par_iter().for_each(|case| {
        for dialect in DIALECTS {
            assert_eq!(differing(case, dialect, Some), Some(0), "{}: {dialect:?}", title(case));
            assert_eq!(differing(case, dialect, |block| Some(block.wide())), Some(0), "{}: {dialect:?}", title(case));
        }
    });
}

/// Of a spindle no self-test claims to find it: few cycles of its noise compute a position, and fewer show the last bit.
const FUSED: &str = "a fused operation";

/// A fault, by its number; none: there are no more.
type Plant = fn(&Block, usize) -> Option<Block>;

#[derive(Clone, Copy, Default)]
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

fn count(case: &Case, name: &str, plant: Plant) -> Count {
    let inputs = case::inputs(case, VECTOR_SAMPLES).unwrap();
    let expected = engine::run(Engine::Reference, &case.axis, &case.block, &inputs).unwrap();
    let mut count = Count::default();
    for which in 0.. {
        let mut is_shown = false;
        let planted = differing(case, Dialect::Plain, |block| {
            let changed = plant(&block, which)?;
            is_shown = shows(case, &inputs, &expected, &changed);
            Some(changed)
        });
        let Some(differing) = planted else { break };
        count.planted += 1;
        count.found += usize::from(differing > 0);
        count.missed += usize::from(is_shown && differing == 0);
    }
    let is_claimed = !(case.block.program.block == "spindle" && name == FUSED);
    assert!(
        !is_claimed || count.found > 0 || count.missed == 0,
        "{}: no {name} is found, {} can be seen",
        title(case),
        count.missed
    );
    count
}

/// Each single fault that is planted in each case's block: in each case some of each kind are found, and of those that the case's own
/// stimulus shows at most one in 25 is missed. Many that are planted can be seen by nobody: a number beside a comparison, a value
/// that is there already. The numbers of a spindle decide when it changes: a scenario in a closed loop shows what a self-test, which
/// comes near few of them, does not. There at most as many are missed as are found, and of fused operations nothing is claimed.
#[test]
fn a_self_test_finds_planted_faults() {
    let plants: [(&str, Plant); 3] = [
        ("another constant", Block::with_other_constant),
        ("a lost statement", Block::without),
        (FUSED, |block, which| block.contracted(Some(which))),
    ];
    for (name, plant) in plants {
        let counts: Vec<(bool, Count)> = in_both_real_types()
            .par_iter()
            .map(|case| (case.block.program.block == "spindle", count(case, name, plant)))
            .collect();
        let all = |is_spindle: bool| {
            counts.iter().filter(|(of, _)| *of == is_spindle).fold(Count::default(), |all, (_, of)| Count {
                planted: all.planted + of.planted,
                found: all.found + of.found,
                missed: all.missed + of.missed,
            })
        };
        let [spindles, others] = [all(true), all(false)];
        for Count { planted, found, missed } in [spindles, others] {
            println!("{name}: {planted} planted, {found} found, {missed} missed");
        }
        assert!(
            others.found > 100 && 25 * others.missed < others.found,
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

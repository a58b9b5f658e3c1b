//! Random axes and spindles: the emitted Rust, many modules in one crate, gives the bits of the reference. `AXGEN_RANDOM_AXES` is
//! another number of them, as of the C.

use crate::random_axes::{numbered, numbers};
use axgen_tests::environment::by_depth;
use axgen_tests::model::random;
use axgen_tests::random::rng::Rng;
use generator::blocks::{self, Block, Designed};
use generator::generate::identity;
use generator::target::{self, File};
use golden::engine::{self, Engine, rust};
use golden::exercise;
use golden::samples::Samples;
use rayon::prelude::*;

const SEED: u64 = 20_261_124;
/// Of each.
const SAMPLES: usize = 1000;
/// Modules of a crate: more of them take more memory to compile.
const BATCH: usize = 40;
/// One axis in so many is a spindle with a changeover.
const SPINDLES: usize = 4;

/// A random axis with its block that contains the others, its module and its samples.
struct Emitted {
    designed: Designed,
    block: Block,
    file: File,
    inputs: Samples,
}

/// None: the axis has no block.
fn emitted(index: usize) -> Option<Emitted> {
    let rng = &mut Rng::numbered(SEED, index);
    let set = if index.is_multiple_of(SPINDLES) { spindle(rng) } else { random::parameters(rng).set() };
    let designed = numbered(index, &set);
    let block = blocks::blocks(&designed).unwrap_or_else(|defect| panic!("axis {index}: {defect}")).pop()?;
    let target = target::named("rust").expect("there is a target for Rust");
    let file = target.files(&identity(&designed.axis, &block), &block).expect("Rust prints every block").remove(0);
    let inputs = exercise::inputs(&designed, &block, SAMPLES);
    Some(Emitted { designed, block, file, inputs })
}

/// A spindle in the CNC or in a drive, with one of its blocks or all of them.
fn spindle(rng: &mut Rng) -> String {
    let in_drive = rng.chance(50);
    let off = 1000 * (1 + rng.below(300));
    let on = off + 1000 * rng.below(900);
    let mut set = format!("cycle_time = \"{}\"\n[axis.X]\n", rng.pick(&["250us", "1ms", "2ms"]));
    if rng.chance(20) {
        set += "real = \"f32\"\n";
    }
    if in_drive {
        set += "kenngr.antr_typ = \"CANOPEN\"\n\
                process_data.objects = [\"6060h\", \"6061h\", \"607Ah\", \"6064h\", \"60FFh\", \"606Ch\"]\n\
                antr.canopen = { cyclic_position_op_mode = 8, cyclic_velocity_op_mode = 9 }\n";
    } else if rng.chance(50) {
        set += "vorsteuer.vorsteuerung = \"VEL\"\n";
    }
    set += &format!(
        "kenngr.achs_typ = \"ACHSTYP_SPINDEL\"\ngetriebe = [{{ kv = {}, dynamik.vb_max = 9000000 }}]\n\
         spindle.deceleration = {}\nantr.nbr_delay_cycles = {}\nantr.v_reso_num = {}\nantr.v_reso_denom = 36\n\
         antr.sai_op_mode_change = {{ v_velocity_control_on = {on}, v_position_control_on = {off}{} }}\n",
        500 + rng.below(4000),
        1_000_000 * (1 + rng.below(50)),
        rng.below(6),
        rng.pick(&[1, 7, 1000]),
        if in_drive { ", feed_forward_v_weighting = 500" } else { "" },
    );
    set
}

/// Which of the modules of a crate have other bits than the reference.
fn wrong(batch: &[Emitted]) -> Vec<&str> {
    let many: Vec<(&File, &Block, &Samples)> = batch.iter().map(|of| (&of.file, &of.block, &of.inputs)).collect();
    let answers = rust::run_files(&many).unwrap_or_else(|failure| panic!("seed {SEED}: {failure}"));
    let is_wrong = |(of, found): &(&Emitted, Samples)| {
        let expected = engine::run(Engine::Reference, &of.designed, &of.block, &of.inputs);
        *found != expected.unwrap_or_else(|failure| panic!("{}: {failure}", of.file.name))
    };
    batch.iter().zip(answers).filter(is_wrong).map(|(of, _)| of.file.name.as_str()).collect()
}

#[test]
#[expect(clippy::print_stdout, reason = "a figure of the acceptance")]
fn random_modules_have_the_bits_of_the_reference() {
    let axes = numbers(by_depth(4, 15, 200));
    let batch = |batch: &[usize]| {
        let emitted: Vec<Emitted> = batch.iter().filter_map(|index| emitted(*index)).collect();
        let spindles = emitted.iter().filter(|of| of.block.program.block.starts_with("spindle")).count();
        let wrong = wrong(&emitted);
        assert!(wrong.is_empty(), "seed {SEED}: {wrong:?}");
        (emitted.len(), spindles)
    };
    let (run, spindles) =
        axes.par_chunks(BATCH).map(batch).reduce(|| (0, 0), |one, other| (one.0 + other.0, one.1 + other.1));
    assert!(2 * run > axes.len() && 5 * spindles > axes.len(), "few axes have a block: {run}, {spindles} spindles");
    println!("0 differing bits: {run} random modules of Rust with {SAMPLES} samples each, {spindles} of them spindles");
}

/// A module that adds where it should multiply is found, and only that one.
#[test]
fn another_operation_in_a_module_is_found() {
    let mut emitted: Vec<Emitted> = (0..4).filter_map(emitted).collect();
    let step = |of: &Emitted| Some(of.file.text.find("pub fn step(")?..of.file.text.find("pub fn self_test()")?);
    let has_product = |of: &Emitted| step(of).is_some_and(|step| of.file.text[step].contains(" * "));
    let changed = emitted.iter().rposition(has_product).expect("a module has a product");
    let step = step(&emitted[changed]).expect("a module has a step");
    let file = &mut emitted[changed].file;
    let name = file.name.clone();
    // The self-test would refuse it before: here it says that nothing differs.
    let (before, step) = (&file.text[..step.start], file.text[step].replace(" * ", " + "));
    file.text = format!("{before}{step}pub fn self_test() -> u32 {{\n    0\n}}\n");
    assert_eq!(wrong(&emitted), [name]);
}

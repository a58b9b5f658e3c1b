//! clang for ARM: what it makes of the emitted C calls nothing but what a processor without the arithmetic needs, and
//! links and runs as docs/runner.md says. Without an attribute it stores several zeros by a call of memset.

use crate::bare::is_arithmetic;
use crate::boards::{BOARDS, Emitted, emulator, finished, said, written};
use crate::in_turn;
use axgen_tests::cases::{all, in_both_real_types, title};
use axgen_tests::environment::{by_depth, has, is_every_level, is_exhaustive};
use portable::RealKind;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

const LEVELS: [&str; 5] = ["-Os", "-O1", "-O2", "-O3", "-Oz"];
/// A processor, and whether it computes in single and in double precision by itself.
const PROCESSORS: [(&[&str], [bool; 2]); 5] = [
    (&["--target=armv7em-none-eabihf", "-mcpu=cortex-m4"], [true, false]),
    (&["--target=armv6m-none-eabi", "-mcpu=cortex-m0plus"], [false, false]),
    (&["--target=armv7m-none-eabi", "-mcpu=cortex-m3"], [false, false]),
    (&["--target=armv7em-none-eabi", "-mcpu=cortex-m4", "-mfloat-abi=soft"], [false, false]),
    (&["--target=armv7em-none-eabihf", "-mcpu=cortex-m7"], [true, true]),
];
const SAMPLES: usize = 1000;
const PAGE: &str = include_str!("../../../docs/runner.md");

fn is_there() -> bool {
    has("clang", "clang version", "clang") && has("arm-none-eabi-nm", "nm", "binutils-arm-none-eabi")
}

/// The options that a processor without a library needs.
fn clang(folder: &Path, options: &[&str]) -> Command {
    let mut clang = Command::new("clang");
    clang.current_dir(folder).args(["-std=c99", "-Wall", "-Wextra", "-nostdlibinc", "-c"]).args(options);
    clang
}

#[test]
fn what_clang_makes_for_arm_calls_no_library() {
    if !is_there() {
        return;
    }
    // In a plain run one level and one of two processors each, in an exhaustive run one level and one processor, both in
    // turn; of three cases their self-tests and runners too. All of them with AXGEN_EVERY_LEVEL.
    let mut seen = BTreeSet::new();
    let emitted: Vec<_> = in_both_real_types()
        .iter()
        .map(|case| (title(case), case.block.program.real, Emitted::of(&case.axis, &case.block, SAMPLES)))
        .filter(|(.., of)| seen.insert(of.files[1].text.clone()))
        .collect();
    let objects: usize = emitted
        .par_iter()
        .enumerate()
        .map(|(number, (title, real, emitted))| {
            let is_whole = is_every_level() || number < 3;
            let (levels, processors) = match is_exhaustive() {
                true => (in_turn(&LEVELS, number, 1), in_turn(&PROCESSORS, number / LEVELS.len(), 1)),
                false if number % 4 > 0 => return 0,
                false => (LEVELS[..1].to_vec(), PROCESSORS[number / 4 % 2..][..1].to_vec()),
            };
            let folder = written(&[emitted]);
            let sources: Vec<&str> = emitted
                .files
                .iter()
                .map(|file| &*file.name)
                .filter(|name| name.ends_with(".c") && (is_whole || *name == emitted.files[1].name))
                .collect();
            let single = usize::from(*real == RealKind::F64);
            let mut count = 0;
            for (processor, computes) in &processors {
                for level in &levels {
                    finished(clang(folder.path(), processor).arg(level).args(&sources), title);
                    let objects: Vec<String> = sources.iter().map(|name| name.replace(".c", ".o")).collect();
                    let undefined = undefined(folder.path(), &objects);
                    let is_allowed = |name: &String| {
                        // Digests and counts are of 64 bits in the self-test and in the runner.
                        let is_own = name.starts_with("axis_") || name == "runner_put";
                        is_own || is_arithmetic(name) && (!computes[single] || !is_real(name))
                    };
                    let of = format!("{title} {processor:?} {level}");
                    assert!(undefined.iter().all(is_allowed), "{of}: {undefined:?}");
                    count += objects.len();
                }
            }
            count
        })
        .sum();
    assert!(objects > by_depth(10, 40, 40), "{objects} objects");
}

/// The names that some objects lack.
fn undefined(folder: &Path, objects: &[String]) -> BTreeSet<String> {
    let output =
        Command::new("arm-none-eabi-nm").current_dir(folder).arg("-u").args(objects).output().expect("nm starts");
    assert!(output.status.success(), "nm fails");
    let text = String::from_utf8_lossy(&output.stdout);
    text.lines().filter_map(|line| line.trim().strip_prefix("U ")).map(str::to_owned).collect()
}

/// Whether a name of the ABI is of arithmetic with reals.
fn is_real(name: &str) -> bool {
    name.trim_start_matches("__aeabi_").starts_with(['f', 'd']) && !name.contains("div")
}

/// The two lines of the page, with a case's block, and the start-up code of these tests instead of the reader's.
#[test]
fn the_lines_for_clang_link_a_runner_that_passes() {
    if !is_there() || !BOARDS[2].is_there() {
        return;
    }
    for wanted in ["single-precision, f32", "whole-spindle-in-the-cnc, f64", "tuned-while-moving, f64"] {
        let case = all().into_iter().find(|case| title(case) == wanted).unwrap_or_else(|| panic!("no case {wanted}"));
        let emitted = Emitted::of(&case.axis, &case.block, SAMPLES);
        let folder = written(&[&emitted]);
        let cross = Path::new(env!("CARGO_MANIFEST_DIR")).join("cross");
        for (from, to) in [("cortex_m.c", "board.c"), ("cortex_m.ld", "board.ld")] {
            std::fs::copy(cross.join(from), folder.path().join(to)).expect("room in the folder");
        }
        let lines: Vec<&str> = PAGE
            .lines()
            .filter(|line| ["clang ", "arm-none-eabi-gcc "].iter().any(|tool| line.starts_with(tool)))
            .collect();
        let [compiles, links] = lines[..] else { panic!("docs/runner.md: {lines:?}") };
        let (prefix, board) = (&emitted.prefix, format!("'-DRUNS=RUN({})' board.c", emitted.prefix));
        for line in [compiles, links] {
            let line = line.replace(" -c axis_x_ipc", &format!(" -nostdlibinc -c {prefix}")).replace("board.c", &board);
            // The linker warns of sections of its own library.
            let output = Command::new("sh").current_dir(folder.path()).args(["-c", &line]).output().expect("sh starts");
            assert!(output.status.success(), "{line}: {}", String::from_utf8_lossy(&output.stderr));
        }
        let said = said(emulator("mps2-an386", folder.path()).args(["-kernel", "program.elf"]));
        assert!(said.contains("self-test: passed") && said.ends_with("\npassed\n"), "{wanted}: {said}");
    }
}

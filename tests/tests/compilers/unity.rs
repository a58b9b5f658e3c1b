//! All files of all blocks of several axes in one translation unit, as some firmware is built: the same bits, no name twice.

use crate::files::compile;
use crate::tools;
use axgen_tests::environment::{by_depth, has};
use generator::config::ListOptions;
use generator::generate::axis_files;
use generator::target::{File, TARGETS};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// Axes with every block, spindles, both real types, short and long names.
const SETS: [&str; 4] = [
    "examples/feedforward.toml",
    "tests/bench/spindles.toml",
    "tests/bench/single.toml",
    "tests/tests/compilers/unity.toml",
];
const STRICT: [&str; 9] =
    ["-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Wdouble-promotion", "-Werror", "-O2"];
const CPP: [&str; 2] = ["-std=c++98", "-std=c++17"];
const STRICT_CPP: [&str; 7] = ["-pedantic", "-Wall", "-Wextra", "-Wshadow", "-Wconversion", "-Werror", "-fsyntax-only"];

/// The files of all axes in a folder, and their names.
fn written() -> (TempDir, Vec<String>) {
    let (folder, mut names) = (tempfile::tempdir().expect("a temporary folder"), Vec::new());
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for path in SETS {
        let (set, report) = generator::pipeline::read(&root.join(path), &ListOptions::default());
        for axis in set.unwrap_or_else(|| panic!("{report}")).axes {
            for File { name, text } in axis_files(&axis, &TARGETS[..1]).expect("the target prints the blocks") {
                assert!(!names.contains(&name), "{name} twice");
                std::fs::write(folder.path().join(&name), text).expect("room in it");
                names.push(name);
            }
        }
    }
    (folder, names)
}

fn include<'n>(names: impl Iterator<Item = &'n String>) -> String {
    names.fold(String::new(), |mut text, name| {
        writeln!(text, "#include \"{name}\"").expect("a string takes all text");
        text
    })
}

/// The names of the blocks: what their headers are called.
fn blocks(names: &[String]) -> Vec<&str> {
    names.iter().filter_map(|name| name.strip_suffix(".h")).collect()
}

#[test]
fn all_axes_in_one_translation_unit_pass_their_self_tests() {
    let (folder, names) = written();
    let mut text = include(names.iter().filter(|name| name.ends_with(".c")));
    text += "int main(void)\n{\n";
    let blocks = blocks(&names);
    assert!(blocks.len() > 30, "{blocks:?}");
    for (index, block) in blocks.iter().enumerate() {
        writeln!(text, "    if ({block}_self_test() != 0u) {{ return {}; }}", index + 1)
            .expect("a string takes all text");
    }
    text += "    return 0;\n}\n";
    std::fs::write(folder.path().join("unity.c"), text).expect("room in it");
    for tool in tools().into_iter().take(by_depth(1, 1, 2)) {
        compile(tool.command, folder.path(), &[&STRICT[..], &["unity.c", "-o", "unity"]].concat());
        let run = Command::new(folder.path().join("unity")).status().expect("the program starts");
        let code = run.code().and_then(|code| usize::try_from(code).ok()).expect("it ends by itself");
        assert_eq!(code, 0, "{}: {}", tool.command, blocks.get(code.wrapping_sub(1)).unwrap_or(&"all"));
    }
}

/// What a header says in macros and enumerators is so, in every standard that firmware is built with, and in C++.
#[test]
fn headers_hold_beside_each_other() {
    let (folder, names) = written();
    let headers: Vec<&String> = names.iter().filter(|name| name.ends_with(".h")).collect();
    let mut text = include(headers.iter().chain(&headers).copied());
    for block in blocks(&names) {
        let upper = block.to_ascii_uppercase();
        let _ = writeln!(
            text,
            "#if {upper}_CYCLE_TIME_NS == 0 || {upper}_STRUCTURE_0 == 0 && {upper}_STRUCTURE_3 == 0\n#error \"{block}\"\n#endif"
        );
        // This host aligns each member to its own size; no header states that of a pointer to a set.
        for part in ["inputs", "outputs", "state"] {
            let size = format!("{upper}_{}_SIZE", part.to_ascii_uppercase());
            let known = if part == "inputs" { format!("!defined({upper}_PARAMS_SIZE)") } else { "1".to_owned() };
            let of = format!("{block}_{part}");
            let _ = writeln!(text, "#if {known}\nextern char {of}_size[sizeof({of}) == {size} ? 1 : -1];\n#endif");
        }
        let _ = writeln!(text, "extern char {block}_error[{upper}_ERROR_NONE == 0 ? 1 : -1];");
    }
    for name in ["headers.c", "headers.cpp"] {
        std::fs::write(folder.path().join(name), &text).expect("room in it");
    }
    for tool in tools() {
        for standard in ["-std=c99", "-std=c11", "-std=gnu17"] {
            let arguments = [&STRICT[1..], &[standard, "-fsyntax-only", "headers.c"]].concat();
            compile(tool.command, folder.path(), &arguments);
        }
        for standard in CPP.iter().filter(|_| has(tool.cpp, tool.version_contains, tool.package)) {
            compile(tool.cpp, folder.path(), &[&STRICT_CPP[..], &[standard, "headers.cpp"]].concat());
        }
    }
}

/// The refusal of a real type with other bits works in each standard.
#[test]
fn a_real_type_with_other_bits_is_refused() {
    let (folder, _) = written();
    let text = "#include <stdbool.h>\n#include <stdint.h>\n#define double float\n#include \"axis_x_axis.h\"\n";
    for (name, standards) in [("other.c", ["-std=c99", "-std=c11"]), ("other.cpp", CPP)] {
        std::fs::write(folder.path().join(name), text).expect("room in it");
        for tool in tools() {
            for standard in standards {
                let command = if name == "other.c" { tool.command } else { tool.cpp };
                if !has(command, tool.version_contains, tool.package) {
                    continue;
                }
                let arguments = [standard, "-fsyntax-only", name];
                let output = Command::new(command).args(arguments).current_dir(folder.path()).output();
                let said = output.expect("the compiler starts").stderr;
                let said = String::from_utf8_lossy(&said);
                assert!(said.contains("64") && said.contains("bits"), "{command} {standard}: {said}");
            }
        }
    }
}

/// Names that linkers see have at most 31 characters where an axis asks for short ones, and no identifier has more than 63.
#[test]
fn short_names_are_short() {
    let (folder, names) = written();
    let short: Vec<&str> = blocks(&names).into_iter().filter(|block| block.starts_with("ax_")).collect();
    assert!(short.len() >= 4, "{short:?}");
    let mut longest = 0;
    for block in short {
        for end in [".h", ".c", "_self_test.c"] {
            let path: PathBuf = folder.path().join(format!("{block}{end}"));
            let text = std::fs::read_to_string(path).expect("it was written");
            let words = text.split(|character: char| !(character.is_ascii_alphanumeric() || character == '_'));
            for word in words {
                let is_external =
                    ["init", "inputs_init", "step", "self_test"].iter().any(|of| word == format!("{block}_{of}"));
                let length = word.len();
                assert!(length <= 63 && (!is_external || length <= 31), "{word}: {length}");
                longest = longest.max(if is_external { length } else { 0 });
            }
        }
    }
    assert_eq!(longest, 31, "the longest axis name with short names");
}

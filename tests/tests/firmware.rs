//! The emitted C as the tools of a firmware see it: code and constants in the sections that the firmware names, and descriptions
//! for calibration tools, read by another party's parser and compared with what a compiler makes of the structs.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use a2lfile::{A2lObjectName, Characteristic, Measurement, Module};
use axgen_tests::cases::{all, title};
use axgen_tests::environment::{by_depth, has};
use generator::generate::identity;
use generator::target::{self, File, Target};
use golden::case::Case;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// The files of a case in a folder.
fn written(case: &Case, target: Target) -> (TempDir, Vec<File>) {
    let folder = tempfile::tempdir().unwrap();
    let files = target.files(&identity(&case.axis.axis, &case.block), &case.block).unwrap();
    let used = golden::engine::of_set(target, &case.axis, &case.block).unwrap();
    for File { name, text } in files.iter().chain(&used) {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    (folder, files)
}

fn said(program: &str, folder: &Path, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).current_dir(folder).output().unwrap();
    assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// The sections of an object and their sizes.
fn sections(folder: &Path, options: &[&str]) -> BTreeMap<String, u64> {
    let arguments = ["-std=c99", "-Wall", "-Werror", "-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard"];
    said("arm-none-eabi-gcc", folder, &[&arguments, options, &["-c", "block.c", "-o", "block.o"]].concat());
    let text = said("arm-none-eabi-size", folder, &["-A", "block.o"]);
    let section = |line: &str| {
        let mut words = line.split_whitespace();
        Some((words.next()?.to_owned(), words.next()?.parse().ok()?))
    };
    text.lines().filter_map(section).filter(|(_, size)| *size > 0).collect()
}

#[test]
fn code_and_constants_are_in_the_sections_that_the_firmware_names() {
    if !has("arm-none-eabi-gcc", "arm-none-eabi", "gcc-arm-none-eabi") {
        return;
    }
    let cases: Vec<Case> = all().into_iter().step_by(by_depth(4, 3, 1)).collect();
    cases.par_iter().for_each(|case| {
        let (folder, files) = written(case, target::named("c").unwrap());
        std::fs::write(folder.path().join("block.c"), &files[1].text).unwrap();
        let named = [
            "-DAXGEN_CODE_SECTION=__attribute__((section(\".itcm\")))",
            "-DAXGEN_CONST_SECTION=__attribute__((section(\".calibration\")))",
        ];
        let has_set = case.block.program.has_set();
        // gcc makes a table of a switch of the design, which runs in a slow task.
        let may_have_table = case.block.program.made.is_some();
        for level in ["-O2", "-Os"] {
            let [usual, placed] = [[level].to_vec(), [&[level], &named[..]].concat()];
            let [usual, placed] = [usual, placed].map(|options| sections(folder.path(), &options));
            let of = |sections: &BTreeMap<String, u64>, name: &str| sections.get(name).copied().unwrap_or(0);
            let title = format!("{} {level}: {usual:?} {placed:?}", title(case));
            // gcc keeps functions that are marked as cold apart. Each section ends with its own padding.
            let cold = of(&usual, ".text.unlikely");
            let code = of(&usual, ".text") + cold;
            let padding = if cold > 0 { 4 } else { 0 };
            assert!(code > 0, "{title}");
            assert!(of(&placed, ".itcm").abs_diff(code) <= padding, "the same code, all of it: {title}");
            let table = of(&placed, ".rodata");
            assert!(table == 0 || may_have_table, "{title}");
            assert_eq!(of(&placed, ".calibration") + table, of(&usual, ".rodata"), "{title}");
            assert_eq!(of(&placed, ".calibration") > 0, has_set, "{title}");
            assert_eq!([".text", ".text.unlikely", ".data", ".bss"].map(|name| of(&placed, name)), [0; 4], "{title}");
        }
    });
}

/// A description as the module of a project.
fn module(description: &File) -> Module {
    let text = format!(
        "ASAP2_VERSION 1 60\n/begin PROJECT firmware \"\"\n/begin MODULE firmware \"\"\n{}\n/end MODULE\n/end PROJECT\n",
        description.text
    );
    let (file, findings) =
        a2lfile::load_from_string(&text, None, true).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let findings: Vec<String> = findings.into_iter().chain(file.check()).map(|finding| finding.to_string()).collect();
    assert!(findings.is_empty(), "{}: {findings:#?}", description.name);
    file.project.module[0].clone()
}

/// The place of an object: its variable, and its offset.
fn places(module: &Module) -> BTreeMap<String, (String, i32)> {
    let link = |link: &Option<a2lfile::SymbolLink>| {
        let link = link.as_ref().unwrap();
        (link.symbol_name.clone(), link.offset)
    };
    let measured = module.measurement.iter().map(|of: &Measurement| (of.get_name().to_owned(), link(&of.symbol_link)));
    let tuned =
        module.characteristic.iter().map(|of: &Characteristic| (of.get_name().to_owned(), link(&of.symbol_link)));
    measured.chain(tuned).collect()
}

#[test]
fn descriptions_say_where_a_compiler_puts_each_signal() {
    if !has("gcc", "", "gcc") {
        return;
    }
    let target = target::named("c").unwrap().with_descriptions().unwrap();
    all().par_iter().for_each(|case| {
        let (folder, files) = written(case, target);
        let block = target.block(&case.block).unwrap();
        let description = target.description(&identity(&case.axis.axis, &case.block), &block).unwrap();
        let places = places(&module(&description));
        let prefix = files[0].name.trim_end_matches(".h");
        let mut program =
            format!("#include \"{prefix}.h\"\n#include <stddef.h>\n#include <stdio.h>\nint main(void)\n{{\n");
        for name in places.keys() {
            let (variable, member) = name.split_once('.').unwrap();
            let end = variable.strip_prefix(&format!("{prefix}_")).unwrap();
            let ty = [("in", "inputs"), ("out", "outputs"), ("mem", "state"), ("designed", "params")]
                .into_iter()
                .find_map(|(of, ty)| (of == end).then_some(ty))
                .unwrap();
            program += &format!("    printf(\"{name} %d\\n\", (int)offsetof({prefix}_{ty}, {member}));\n");
        }
        program += "    return 0;\n}\n";
        std::fs::write(folder.path().join("offsets.c"), program).unwrap();
        said("gcc", folder.path(), &["-std=c99", "offsets.c", "-o", "offsets"]);
        let compiled = said(&folder.path().join("offsets").to_string_lossy(), folder.path(), &[]);
        let described: Vec<String> = places.iter().map(|(name, (_, offset))| format!("{name} {offset}")).collect();
        assert!(!described.is_empty());
        assert_eq!(compiled.lines().collect::<Vec<_>>(), described, "{}", title(case));
        let all_named = places.iter().all(|(name, (variable, _))| name.starts_with(&format!("{variable}.")));
        assert!(all_named, "{places:?}");
    });
}

/// Units, limits and names of one block, which are not in the struct.
#[test]
fn a_description_has_units_limits_and_names() {
    let case = all().into_iter().find(|case| title(case).starts_with("set-design")).unwrap();
    let target = target::named("c").unwrap().with_descriptions().unwrap();
    let block = target.block(&case.block).unwrap();
    let module = module(&target.description(&identity(&case.axis.axis, &case.block), &block).unwrap());
    let tuned = |end: &str| module.characteristic.iter().find(|of| of.get_name().ends_with(end)).unwrap();
    let frequency = tuned("_in.stage0_filter0_f0");
    let method = module.compu_method.iter().find(|of| of.get_name() == frequency.conversion).unwrap();
    let lowest = case.axis.set_design.lowest_f0;
    assert_eq!((method.unit.as_str(), frequency.lower_limit.to_bits()), ("Hz", lowest.to_bits()));
    let highest = (0.45e9 / f64::from(case.axis.axis.cycle_time_ns)).min(500.0);
    assert_eq!(frequency.upper_limit.to_bits(), highest.to_bits());
    assert_eq!(tuned("_in.stage0_weight").upper_limit.to_bits(), 7.0_f64.to_bits());
    let names = module.compu_vtab.iter().find(|of| of.get_name().ends_with(".error_id.names")).unwrap();
    assert!(
        names
            .value_pairs
            .iter()
            .any(|pair| pair.in_val.to_bits() == 65.0_f64.to_bits() && pair.out_val == "ERROR_WEIGHT"),
        "{names:?}"
    );
}

//! `axgen params-of` as a user sees it: each form read back, against the bytes that a C compiler makes of the generated header; what is
//! refused, and what `axgen diff` says of the same changes.

use crate::words;
use std::{fs, path::Path, process::Command};
use tempfile::TempDir;

const OLD: &str = include_str!("params_of.toml");
/// Another weight and another frequency.
const NEW: [(&str, &str); 2] = [("weight_fact_num = 150", "weight_fact_num = 90"), ("fg_f0 = 53.0", "fg_f0 = 54.3")];
const SINGLE: (&str, &str) = ("tunable", "real = \"f32\"\ntunable");

/// Runs the block with the set that it was generated with, offers the new one, then a damaged one with another number; writes the bytes of
/// the new one if the block did with them what it says.
const MAIN: &str = r#"
#include <stdio.h>
#include "BLOCK.h"
extern const BLOCK_params SET;

static BLOCK_state state;
static BLOCK_inputs inputs;
static BLOCK_outputs outputs;

static int runs(const volatile BLOCK_params *params, uint32_t active, uint32_t error_id)
{
    int cycle;
    inputs.params = params;
    for (cycle = 0; cycle < 400; cycle++) {
        inputs.v_motor = (cycle % 20) * 100;
        BLOCK_step(&state, &inputs, &outputs);
    }
    return outputs.active_set == active && outputs.error_id == error_id && !outputs.fault;
}

int main(void)
{
    BLOCK_params damaged = SET;
    damaged.set_id += 1u;
    BLOCK_init(&state);
    BLOCK_inputs_init(&inputs);
    inputs.mode = 1;
    if (!runs(inputs.params, BLOCK_designed.set_id, 0u)) return 2;
    if (!runs(&SET, SET.set_id, 0u) || SET.set_id == BLOCK_designed.set_id) return 3;
    if (!runs(&damaged, SET.set_id, 8u)) return 4;
    damaged.structure += 1u;
    if (!runs(&damaged, SET.set_id, 6u)) return 5;
    return fwrite(&SET, sizeof SET, 1, stdout) == 1 ? 0 : 1;
}
"#;

fn changed(changes: &[(&str, &str)]) -> String {
    changes.iter().fold(OLD.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    })
}

/// A folder with `old.toml` and `new.toml`.
fn folder(old: &[(&str, &str)], new: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("old.toml"), changed(old)).unwrap();
    fs::write(folder.path().join("new.toml"), changed(new)).unwrap();
    folder
}

/// Runs the command; gives its exit code, its output and its messages.
fn axgen(folder: &Path, arguments: &[&str]) -> (i32, Vec<u8>, String) {
    let output = Command::new(crate::AXGEN).current_dir(folder).args(arguments).output().unwrap();
    (output.status.code().unwrap(), output.stdout, String::from_utf8(output.stderr).unwrap())
}

fn in_form(folder: &Path, form: &str) -> Vec<u8> {
    let (code, out, err) = axgen(folder, &["params-of", "new.toml", "--axis", "X", "--on", "old.toml", "--as", form]);
    assert_eq!((code, err.as_str()), (0, ""));
    out
}

fn text_in(folder: &Path, form: &str) -> String {
    String::from_utf8(in_form(folder, form)).unwrap()
}

fn succeeds(command: &mut Command) -> Vec<u8> {
    let output = command.output().unwrap();
    assert!(output.status.success(), "{command:?}\n{}", String::from_utf8_lossy(&output.stderr));
    output.stdout
}

/// The bits of a set in a form of lines: what stands before and after `between`.
fn bits(lines: &str, between: &str, end: &str, single: bool) -> Vec<(String, Vec<u8>)> {
    let line = |line: &str| {
        let (name, value) = line.strip_suffix(end)?.split_once(between)?;
        let bits = match (["structure", "set_id"].iter().any(|word| name.ends_with(word)), single) {
            (true, _) => value.parse::<u32>().unwrap().to_le_bytes().to_vec(),
            (false, true) => value.parse::<f32>().unwrap().to_le_bytes().to_vec(),
            (false, false) => value.parse::<f64>().unwrap().to_le_bytes().to_vec(),
        };
        Some((name.to_owned(), bits))
    };
    lines.lines().filter_map(line).collect()
}

/// Every form has the bytes that a compiler makes of the one in C.
fn assert_one_set(old: &[(&str, &str)], new: &[(&str, &str)], stem: &str) {
    let folder = folder(old, new);
    let path = folder.path();
    let single = old.contains(&SINGLE);
    for target in ["c", "rust"] {
        let (code, _, err) = axgen(path, &["generate", "old.toml", "--target", target, "--out", "."]);
        assert_eq!(code, 0, "{err}");
    }
    let file = in_form(path, "bin");
    let (head, bytes) = file.split_at(12);
    let length = u32::try_from(bytes.len()).unwrap();
    assert_eq!(head, [b"AXPS".as_slice(), &1_u32.to_le_bytes(), &length.to_le_bytes()].concat());
    let bytes = bytes.to_vec();

    // The lines of CSV have the names of the struct.
    let csv = text_in(path, "csv");
    let members = bits(&csv, ",", "", single);
    assert_eq!(members.len(), csv.lines().count());
    assert_eq!(members.iter().flat_map(|(_, bits)| bits.clone()).collect::<Vec<u8>>(), bytes);
    let of = |name: &str| members.iter().find(|(known, _)| known == name).map(|(_, bits)| bits.clone());
    assert_eq!(
        of("stage0_gain"),
        Some(if single { (-0.9_f32).to_le_bytes().to_vec() } else { (-0.9_f64).to_le_bytes().to_vec() })
    );

    // C: the struct in memory.
    let number = u32::from_le_bytes(bytes[4..8].try_into().unwrap());
    let set = text_in(path, "c");
    let between = if stem.starts_with("ax_") { "set" } else { "set_" };
    let name = format!("{stem}_{between}{number:08x}");
    assert!(set.starts_with(&format!("/* {name}.c - generated by axgen ")), "{set}");
    assert_eq!(generator::digest::has_right_checksum(&set), Some(true));
    fs::write(path.join("set.c"), &set).unwrap();
    let main = MAIN.replace("BLOCK", stem).replace("SET", &name);
    fs::write(path.join("main.c"), main).unwrap();
    let cc = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
    let flags = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-Wmissing-variable-declarations"];
    let flags = &flags[..if cc.contains("clang") { 6 } else { 5 }];
    let files = ["set.c", "main.c", &format!("{stem}.c"), "-o", "main"];
    succeeds(Command::new(&cc).current_dir(path).args(flags).args(files));
    assert_eq!(succeeds(&mut Command::new(path.join("main"))), bytes);

    // Rust: each member of the struct of the module, by its name.
    let module = fs::read_dir(path).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let module =
        module.filter(|name| name.starts_with("axis_")).find_map(|name| Some(name.strip_suffix(".rs")?.to_owned()));
    let module = module.unwrap();
    fs::write(path.join("set.rs"), text_in(path, "rust")).unwrap();
    let put: String =
        members.iter().map(|(name, _)| format!("    out.write_all(&SET.{name}.to_le_bytes()).unwrap();\n")).collect();
    let main = format!(
        "mod {module};\nmod set;\nuse std::io::Write;\nconst SET: {module}::Params = set::SET_{number:08X};\nfn main() {{\n    \
         let mut out = std::io::stdout();\n{put}}}\n"
    );
    fs::write(path.join("main.rs"), main).unwrap();
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    succeeds(Command::new(rustc).current_dir(path).args(["--edition", "2021", "main.rs", "-o", "main_of_rust"]));
    assert_eq!(succeeds(&mut Command::new(path.join("main_of_rust"))), bytes);

    // Structured Text: an assignment each.
    for (form, variable) in [("st", "params"), ("scl", "\"params\"")] {
        let text = text_in(path, form);
        assert_eq!(generator::digest::has_right_checksum(&text), Some(true));
        let assigned = bits(&text, " := ", ";", single);
        assert_eq!(assigned.iter().flat_map(|(_, bits)| bits.clone()).collect::<Vec<u8>>(), bytes, "{text}");
        for ((name, _), (member, _)) in assigned.iter().zip(&members) {
            // A word of the language gets an end.
            let member = if member == "limit" { "limit_value" } else { member };
            assert_eq!(*name, format!("{variable}.{member}"));
        }
    }
}

#[test]
fn every_form_is_one_set() {
    assert_one_set(&[], &NEW, "axis_x_ipc");
}

#[test]
fn so_it_is_in_single_precision_with_short_names() {
    let short = ("[axis.X]", "[axis.X]\nshort_names = true");
    assert_one_set(&[SINGLE, short], &[&[SINGLE, short][..], &NEW].concat(), "ax_x_ipc");
}

/// What linkers see has at most 31 characters, with the longest name that an axis may have there.
#[test]
fn short_names_stay_short() {
    let folder = folder(&[], &[]);
    for file in ["old.toml", "new.toml"] {
        let text = changed(&[("[axis.X]", "[axis.X]\nshort_names = true")]).replace("axis.X", "axis.ABCDEFGHIJKL");
        fs::write(folder.path().join(file), text).unwrap();
    }
    let (_, out, err) = axgen(folder.path(), &["params-of", "new.toml", "--on", "old.toml"]);
    let text = String::from_utf8(out).unwrap();
    let name = text
        .lines()
        .find_map(|line| line.strip_prefix("AXGEN_CONST_SECTION const ax_abcdefghijkl_ipc_params ")?.split(' ').next());
    assert!(name.is_some_and(|name| name.len() == 31), "{text}{err}");
}

/// A text for people, word by word.
#[test]
fn the_constant_in_c() {
    let folder = folder(&[], &NEW);
    let text = text_in(folder.path(), "c");
    let lines: Vec<&str> = text.lines().collect();
    // In hexadecimal digits, and as a PLC shows it.
    let is_number = |text: &str| {
        let (digits, decimal) = text.split_once(" = ").unwrap();
        digits.len() == 8 && u32::from_str_radix(digits, 16) == decimal.parse()
    };
    let (set, structure) = lines[5].split_once(", for the set structure ").unwrap();
    assert!(is_number(set.strip_prefix(" * set         ").unwrap()) && is_number(structure), "{}", lines[5]);
    assert_eq!(lines[2], " * a parameter set for the block axis_x_ipc");
    assert_eq!(lines[4], " * axis        X");
    assert_eq!(lines[6], " * cycle time  1000000 ns");
    let set = &lines[5][15..23];
    assert!(
        lines.contains(&format!("AXGEN_CONST_SECTION const axis_x_ipc_params axis_x_ipc_set_{set} = {{").as_str()),
        "{text}"
    );
    assert!(lines.contains(&"    -0.9, /* stage0_gain */") && lines.contains(&"    200000.0, /* limit */"), "{text}");
}

/// What is said of changes of the two sets, in `params_of.txt`: of a set that is refused, and the last line of the semantic diff.
#[test]
fn what_is_said_of_changes() {
    transcript::compare(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/params_of.txt"), |form, text| {
        let lines = |key: &str| text.lines().filter_map(|line| line.strip_prefix(key)).collect::<Vec<_>>().join("\n");
        let changes = |file: &str| -> Vec<(String, String)> {
            let change =
                |line: &str| line.split_once(" => ").map(|(from, to)| (from.to_owned(), to.replace(" // ", "\n")));
            lines(file).lines().filter_map(change).collect()
        };
        let [old, new] = ["old: ", "new: "].map(changes);
        let pairs =
            |of: &[(String, String)]| changed(&of.iter().map(|(a, b)| (a.as_str(), b.as_str())).collect::<Vec<_>>());
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("old.toml"), pairs(&old)).unwrap();
        fs::write(folder.path().join("new.toml"), pairs(&new)).unwrap();
        if form == "diff" {
            let (code, out, err) = words(&folder, "diff old.toml new.toml");
            assert_eq!(code, 1, "{err}");
            return out.lines().last().unwrap().to_owned();
        }
        let options = lines("options: ");
        let (code, out, err) = words(&folder, &format!("params-of new.toml --on old.toml --output set.c {options}"));
        assert_eq!((code, out.as_str()), (2, ""));
        assert!(!folder.path().join("set.c").exists());
        err
    });
}

#[test]
fn no_file_is_lost() {
    let folder = folder(&[], &NEW);
    let write = |arguments: &[&str]| {
        let all = [&["params-of", "new.toml", "--on", "old.toml"], arguments].concat();
        let (code, _, err) = axgen(folder.path(), &all);
        (code, err)
    };
    assert_eq!(write(&["-o", "set.c"]), (0, String::new()));
    let text = fs::read(folder.path().join("set.c")).unwrap();
    assert_eq!(text, in_form(folder.path(), "c"));
    let there = "set.c: error[AX014]: is there already; give another name, or --force to replace it\n";
    assert_eq!(write(&["-o", "set.c"]), (2, there.to_owned()));
    assert_eq!(write(&["--out", "set.c", "--force"]), (0, String::new()));
    let input = "old.toml: error[AX014]: is an input of this run; give another name\n";
    assert_eq!(write(&["-o", "old.toml", "--force"]), (2, input.to_owned()));
}

/// The set is written; what it leaves is said.
#[test]
fn what_no_set_carries_is_said() {
    let folder = folder(&[], &[NEW[0], ("enable = \"OFF\"", "enable = \"DRYRUN\"")]);
    let (code, out, err) = axgen(folder.path(), &["params-of", "new.toml", "--on", "old.toml", "--as", "csv"]);
    let expected = "new.toml: warning[AX447]: axis X: starts OFF -> DRYRUN: no parameter set says that\n    \
                    write instead: `axgen generate new.toml --axis X`, where the block is to have it\n";
    assert_eq!((code, err.as_str()), (0, expected));
    assert!(out.starts_with(b"structure,"));
}

//! Which files a set gets, and what a reader finds in them.

use super::{MACHINE, files, of_ipc};
use crate::without_comments;

#[test]
fn every_target_has_its_files() {
    let names: Vec<String> = files(MACHINE).into_keys().collect();
    let shared = [
        "IMPORT_CODESYS.md",
        "IMPORT_SCL.md",
        "axgen_mode.scl",
        "axgen_shared.xml",
        "rust/Cargo.toml",
        "rust/lib.rs",
        "twincat/DUTs/E_axgen_mode.TcDUT",
        "twincat/IMPORT.md",
        "twincat/POUs/F_axgen_in_range_LREAL.TcPOU",
        "twincat/POUs/F_axgen_in_range_REAL.TcPOU",
        "twincat/Tests/PRG_axgen_tests.TcPOU",
        "twincat/axgen.plcproj-fragment",
    ];
    let mut expected: Vec<String> = ["x", "y", "c"].into_iter().flat_map(of_ipc).collect();
    expected.extend(shared.map(str::to_owned));
    expected.sort();
    assert_eq!(names, expected);
}

#[test]
fn a_target_for_one_real_type_has_no_parts_for_the_other() {
    let single = "cycle_time = \"1ms\"\n[axis.X]\nlist = \"rack-and-pinion.lis\"\n";
    let names: Vec<String> = files(single).into_keys().collect();
    assert!(names.iter().any(|name| name.ends_with("in_range_LREAL.TcPOU")));
    assert!(!names.iter().any(|name| name.contains("_REAL")), "{names:?}");
}

/// A crate with one feature has the module that declares the type of the sets, also by what is read back from a folder.
#[test]
fn a_feature_enables_the_type_of_its_sets() {
    let set = MACHINE.replacen("[axis.X]\n", "[axis.X]\ntunable = \"all\"\ngetriebe = [{ kv = 2000 }]\n", 1);
    let all = files(&set);
    assert!(all["rust/Cargo.toml"].contains("axis_x_axis = [\"axis_x_ipc\"]"));
    let of_x = |name: &str| name.starts_with("axis_x_") && name.ends_with(".rs");
    let modules: Vec<_> =
        all.iter().filter(|(name, _)| of_x(name)).map(|(name, text)| (&**name, text.clone())).collect();
    assert!(generator::target::head::unit("x", &modules).unwrap().takes_sets);
}

/// In TwinCAT every signal, every state and every number has a comment, after it or, where that is too long, above it; a
/// velocity has its unit, the one of its axis.
#[test]
fn every_declaration_says_what_it_is() {
    for (name, text) in files(MACHINE).iter().filter(|(name, _)| name.contains("POUs/FB_")) {
        let declaration = text.split_once("]]>").unwrap().0;
        let signals = declaration.split("VAR (* used within one cycle only *)").next().unwrap();
        let signals = signals.split_once("\nVAR_INPUT").unwrap().1;
        let constants = declaration.split("VAR CONSTANT").nth(1).unwrap();
        let lines: Vec<&str> = signals.lines().chain(constants.lines()).collect();
        let mut count = 0;
        for (at, line) in lines.iter().enumerate().filter(|(_, line)| line.contains(" : ") && line.contains(';')) {
            let above = lines[..at].last().filter(|above| line.ends_with(';') && above.ends_with(" *)"));
            assert!(line.contains("; (* ") && line.ends_with(" *)") || above.is_some(), "{name}: {line}");
            let unit = if name.contains("axis_c_") { "[0.001 deg/s]" } else { "[um/s]" };
            let is_velocity = line.trim_start().starts_with("v_");
            let comment = if above.is_some() { lines[..at].join(" ") } else { (*line).to_owned() };
            assert!(!is_velocity || comment.contains(unit), "{name}: {line}");
            count += 1;
        }
        assert!(count > 25, "{name}: {count}");
    }
}

/// Outside the declarations a TwinCAT block has no number but the 0 and 1 of counting and of a cleared output.
#[test]
fn no_number_stands_among_the_statements_of_twincat() {
    for (name, text) in files(MACHINE).iter().filter(|(name, _)| name.contains("POUs/FB_")) {
        let statements = text.split_once("<ST><![CDATA[").unwrap().1.split_once("]]>").unwrap().0;
        let code = without_comments(statements);
        let words = code.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_' || c == '.'));
        let numbers: Vec<&str> = words.filter(|word| word.starts_with(|c: char| c.is_ascii_digit())).collect();
        let strange: Vec<&&str> = numbers.iter().filter(|number| !["0", "1", "0.0", "1.0"].contains(number)).collect();
        assert!(!numbers.is_empty() && strange.is_empty(), "{name}: {strange:?}");
    }
}

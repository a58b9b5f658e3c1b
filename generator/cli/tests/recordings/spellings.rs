//! Exports through the command: a stimulus with a map, one file for both, characters of Latin-1, standard input's size.

use super::{Recording, axgen, compare, folder, good};
use std::fs;

/// An export of a good recording: every column a channel with its own times, foreign names, a foreign channel of another rate.
fn export(recording: &Recording) -> String {
    let names = ["Befehl \u{e4}", "Motor", "Korrektur", "berechnet"];
    let head = |key: &str, cells: [&str; 4], last: &str| {
        let own: String = cells.iter().map(|cell| format!("{key};{cell};")).collect();
        format!("{own}{key};{last}\n")
    };
    let mut text =
        "Name;Scope Project;\nFile;C:\\x.svdx;\nStarttime of export;133000000000000000;1. M\u{e4}rz;15:56:24.376\n\n"
            .to_owned();
    text += &head("Name", names, "Temperatur");
    text += &head("SampleTime[ms]", ["1"; 4], "5");
    text += &head("SymbolName", ["MAIN.a", "MAIN.b", "MAIN.c", "MAIN.d"], "MAIN.t");
    text += "\n";
    for (sample, row) in recording.rows.iter().enumerate() {
        let own: String = row.iter().map(|value| format!("{sample};{value};")).collect();
        let foreign = if sample < 600 { format!("{};21.5", 5 * sample) } else { " ; ".to_owned() };
        text += &format!("{own}{foreign}\n").replace('.', ",");
    }
    text + "EOF\n"
}

const INPUTS: [&str; 4] = ["--map", "Befehl \u{e4}=v_command", "--map", "MAIN.b=v_motor"];
const OUTPUTS: [&str; 4] = ["--map", "Korrektur=v_add", "--map", "berechnet=v_add_calculated"];

fn latin_1(text: &str) -> Vec<u8> {
    text.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap()).collect()
}

#[test]
fn an_export_in_latin_1_is_compared() {
    let folder = folder();
    let text = export(&good());
    for bytes in [latin_1(&text), text.replace("Name;Scope Project;", "TwinCAT Scope Export").into_bytes()] {
        let run = compare(folder.path(), bytes, &[INPUTS, OUTPUTS].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
        assert!(
            run.out.contains(", 3000 samples: 0 differing bits\nleft out, no signal of ipc: Temperatur\n"),
            "{}",
            run.out
        );
    }
}

/// `--map` names the columns of a stimulus too; outputs in the same file are left out.
#[test]
fn an_export_is_a_stimulus() {
    let folder = folder();
    let recording = good();
    fs::write(folder.path().join("scope.csv"), export(&recording)).unwrap();
    let run = |map: &[&str]| {
        let command = ["run", "axes.toml", "--axis", "X", "--stimulus", "scope.csv"];
        axgen(folder.path(), &[&command[..], map].concat())
    };
    for map in [INPUTS.to_vec(), [INPUTS, OUTPUTS].concat()] {
        let run = run(&map);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let first = |line: &str| line.split(',').next().unwrap().parse::<f64>().unwrap().to_bits();
        let v_add = recording.at("v_add");
        let expected: Vec<u64> = recording.rows.iter().map(|row| row[v_add].to_bits()).collect();
        assert_eq!(run.out.lines().skip(1).map(first).collect::<Vec<_>>(), expected);
    }
    let wrong = run(&["--map", "Motor=v_motr", "--map", "Moter=v_motor"]);
    assert_eq!((wrong.code, wrong.err.matches("error[").count()), (2, 2), "{}", wrong.err);
    assert!(wrong.err.contains("the column `Motor` for `v_motr`"), "{}", wrong.err);
    assert!(wrong.err.contains("no column `Moter`, which --map names"), "{}", wrong.err);
}

/// The inputs in one file, the outputs in another: the map names columns of both.
#[test]
fn a_map_names_columns_of_both_files() {
    let folder = folder();
    let recording = good();
    let csv = |names: &[&str], called: &str| {
        let csv = recording.only(names).csv();
        called.to_owned() + &csv[csv.find('\n').unwrap()..]
    };
    fs::write(folder.path().join("in.csv"), csv(&["v_command", "v_motor"], "command,motor")).unwrap();
    let map = ["--map", "command=v_command", "--map", "motor=v_motor", "--map", "correction=v_add"];
    let run = compare(folder.path(), csv(&["v_add"], "correction"), &[&["--stimulus", "in.csv"], &map[..]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    assert!(run.out.contains("v_add against engine reference, 3000 samples: 0 differing bits\n"), "{}", run.out);
}

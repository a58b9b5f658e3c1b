//! The command as a user and a script see it: output, exit codes, files.

use crate::{AXGEN, EXAMPLES, Run, axgen};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// A folder with the examples in it, whose limits are below 100 %: nothing is said of them.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for entry in fs::read_dir(EXAMPLES).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            continue; // the repository of `pipeline.rs`
        }
        let text = fs::read_to_string(&path)
            .unwrap()
            .replace("v_add_max_fact             1000", "v_add_max_fact             999");
        fs::write(folder.path().join(path.file_name().unwrap()), text).unwrap();
    }
    folder
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap()
}

#[test]
fn a_second_run_touches_nothing() {
    let folder = folder();
    let arguments = ["generate", "machine.toml", "--out", "out"];
    axgen(folder.path(), &arguments);
    let before: Vec<_> =
        files(&folder.path().join("out")).iter().map(|file| fs::metadata(file).unwrap().modified().unwrap()).collect();
    let run = axgen(folder.path(), &arguments);
    assert!(run.out.ends_with("3 axes: 0 files written, 12 unchanged, 0 warnings\n"), "{}", run.out);
    let after: Vec<_> =
        files(&folder.path().join("out")).iter().map(|file| fs::metadata(file).unwrap().modified().unwrap()).collect();
    assert_eq!(before, after);
}

#[test]
fn one_axis_alone() {
    let folder = folder();
    let run = axgen(folder.path(), &["generate", "machine.toml", "--axis", "Y", "--target", "c"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert_eq!(
        files(&folder.path().join("generated")).len(),
        5,
        "with the manifest; nothing else is left in the folder"
    );
}

/// A runner next to each block in C, of as many samples as are requested, and a description; the other files stay as they are.
#[test]
fn runners_and_descriptions_are_written_next_to_the_blocks() {
    let folder = folder();
    let names = |run: &Run| run.out.lines().filter(|line| line.starts_with("generated/")).count();
    let run = axgen(folder.path(), &["generate", "machine.toml", "--runner"]);
    assert_eq!((run.code, names(&run)), (0, 15), "{}", run.out);
    let runner = read(folder.path(), "generated/axis_c_ipc_runner.c");
    assert!(runner.contains("uint32_t axis_c_ipc_runner(void)\n{") && runner.contains("sample < 100000u"));
    assert_eq!(runner.matches("UINT32_C(0x").count(), 100 + 2, "digests; the factor of the digest, a NaN");
    let run = axgen(folder.path(), &["generate", "machine.toml", "--runner=1500"]);
    assert!(run.out.ends_with("3 axes: 3 files written, 12 unchanged, 0 warnings\n"), "{}", run.out);
    assert!(read(folder.path(), "generated/axis_c_ipc_runner.c").contains("sample < 1500u"));
    let run = axgen(folder.path(), &["generate", "machine.toml", "--runner=1500", "--check"]);
    assert_eq!(run.code, 0, "{}", run.out);
    let run = axgen(folder.path(), &["generate", "machine.toml", "--runner=1500", "--a2l"]);
    assert!(run.out.ends_with("3 axes: 3 files written, 15 unchanged, 0 warnings\n"), "{}", run.out);
    assert!(read(folder.path(), "generated/axis_c_ipc.a2l").contains("SYMBOL_LINK \"axis_c_ipc_out\" 0\n"));
}

#[test]
fn verify_counts_no_differing_bit() {
    let folder = folder();
    let run = axgen(folder.path(), &["verify", "machine.toml", "--samples", "5000"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let rows: Vec<Vec<&str>> = run.out.lines().skip(1).map(|line| line.split_whitespace().collect()).collect();
    let rows = rows.into_iter().filter(|row| row[0] != "not");
    let (reached, rows): (Vec<_>, Vec<_>) = rows.partition(|row| row[2] == "reached:");
    assert_eq!((reached.len(), rows.len()), (3, 3 * 8), "three axes, eight engines");
    for row in reached {
        assert_eq!((row[4], row[6]), ("of", "inputs"), "{row:?}");
    }
    for row in rows {
        assert_eq!(row[3], "5000");
        assert_eq!(row[4], if row[2] == "reference" { "(reference)" } else { "0" });
    }
}

const RACK: [&str; 4] = ["run", "rack-and-pinion.lis", "--cycle-time", "1ms"];

/// Inputs, and with them what the block answers, as a controller would have recorded it.
fn recording(folder: &Path) -> Vec<String> {
    let inputs: Vec<String> = (0..400).map(|i| format!("{}.5,1", (i * 37) % 1000)).collect();
    fs::write(folder.join("in.csv"), format!("v_motor,mode\n{}\n", inputs.join("\n"))).unwrap();
    let run = axgen(folder, &[&RACK[..], &["--stimulus", "in.csv", "--hex", "--out", "out.csv"]].concat());
    assert_eq!((run.code, run.out.as_str(), run.err.as_str()), (0, "", ""));
    let header = "v_motor,mode".to_owned();
    [header]
        .iter()
        .chain(&inputs)
        .zip(read(folder, "out.csv").lines())
        .map(|(inputs, outputs)| format!("{inputs},{outputs}"))
        .collect()
}

/// What is said of the agreement, after what the recording can prove.
fn verdict(out: &str) -> String {
    let lines = out.lines().skip_while(|line| !line.contains(" against engine "));
    lines.map(|line| line.to_owned() + "\n").collect()
}

#[test]
fn a_recording_is_compared_through_any_engine() {
    let folder = folder();
    let rows = recording(folder.path());
    fs::write(folder.path().join("recorded.csv"), rows.join("\n")).unwrap();
    for engine in ["reference", "program", "c", "rust", "st", "twincat", "codesys", "scl"] {
        let run = axgen(folder.path(), &[&RACK[..], &["--engine", engine, "--compare", "recorded.csv"]].concat());
        let expected = format!(
            "v_add, v_add_calculated, limited, held, tripped, fault, error_id against engine {engine}, 400 samples: 0 differing bits\n"
        );
        assert_eq!((run.code, run.err.as_str(), verdict(&run.out)), (0, "", expected));
    }
}

#[test]
fn a_recording_that_differs_is_said_and_ends_with_1() {
    let folder = folder();
    let mut rows = recording(folder.path());
    // v_add of sample 200, off by its last bit.
    let mut cells: Vec<String> = rows[201].split(',').map(str::to_owned).collect();
    let bits = u64::from_str_radix(&cells[2][2..], 16).unwrap();
    cells[2] = format!("0x{:016x}", bits ^ 1);
    let (recorded, computed) = (f64::from_bits(bits ^ 1), f64::from_bits(bits));
    rows[201] = cells.join(",");
    fs::write(folder.path().join("recorded.csv"), rows.join("\n")).unwrap();
    let run = axgen(folder.path(), &[&RACK[..], &["--engine", "st", "--compare", "recorded.csv"]].concat());
    let verdict = verdict(&run.out);
    let lines: Vec<&str> = verdict.lines().collect();
    assert_eq!((run.code, lines.len()), (1, 4), "{}", run.out);
    assert!(lines[0].ends_with("against engine st, 400 samples: 1 differing bit"), "{}", run.out);
    assert_eq!(
        lines[1],
        format!(
            "first: sample 200 (line 202), v_add: {recorded:?} = 0x{:016x} recorded, {computed:?} = 0x{bits:016x} computed",
            bits ^ 1
        )
    );
    assert_eq!(lines[2], "v_add: largest error 1.42e-14 um/s at sample 200 (line 202)");
    assert!(lines[3].starts_with("not explained by any of "), "{}", run.out);
    let cause = "only the last digits differ: other options of the compiler (fused multiply-add, fast math), or another version of the block";
    assert!(lines[3].ends_with(cause), "{}", run.out);
}

/// What a scope exports: keys above the channels, times, decimal commas, few digits, a foreign channel, other names.
#[test]
fn an_export_of_a_scope_is_compared() {
    let folder = folder();
    let rows = recording(folder.path());
    let bits = |cell: &str| f64::from_bits(u64::from_str_radix(&cell[2..], 16).unwrap());
    let comma = |value: f64| format!("{value:.3}").replace('.', ",");
    let export = |names: [&str; 2], error: f64| {
        let mut text = format!(
            "\u{feff}Name\tScope Project\r\nFile\tC:\\scope.svdx\r\nStarttime of export\t133000000000000000\r\n\r\n\
             SymbolName\t{}\tSymbolName\t{}\tSymbolName\tMAIN.temperature\r\n\
             SampleTime[ms]\t1\tSampleTime[ms]\t1\tSampleTime[ms]\t10\r\n\r\n",
            names[0], names[1]
        );
        for (sample, row) in rows[1..].iter().enumerate() {
            let cells: Vec<&str> = row.split(',').collect();
            let moved = if sample == 7 { error } else { 0.0 };
            let (v_motor, v_add) = (comma(cells[0].parse().unwrap()), comma(bits(cells[2]) + moved));
            text += &format!("{sample}\t{v_motor}\t{sample}\t{v_add}\t{sample}\t21,5\t\r\n");
        }
        fs::write(folder.path().join("scope.csv"), text + "EOF\r\n").unwrap();
    };
    let compare = |more: &[&str]| axgen(folder.path(), &[&RACK[..], &["--compare", "scope.csv"], more].concat());
    // The inputs were in mode 1, which is the start of `mode`.
    export(["MAIN.x.v_motor", "MAIN.x.v_add"], 0.0);
    let run = compare(&[]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    let said = verdict(&run.out);
    let lines: Vec<&str> = said.lines().collect();
    assert!(lines[0].starts_with("v_add against engine reference, 400 samples: "), "{}", run.out);
    assert_eq!(lines[1], "left out, no signal of ipc: MAIN.temperature");
    assert!(lines[2].starts_with("v_add: largest error "), "{}", run.out);
    assert!(lines[2].contains(" um/s at sample "), "{}", run.out);
    assert!(lines[2].ends_with("; agrees within the 6 digits recorded"), "{}", run.out);
    assert_eq!(lines.len(), 3);

    export(["MAIN.x.v_motor", "MAIN.x.v_add"], 0.25);
    let run = compare(&[]);
    assert_eq!(run.code, 1, "{}", run.out);
    assert!(run.out.contains("at sample 7 (line 15); more than the 6 digits recorded explain"), "{}", run.out);
    assert!(run.out.contains("\nfirst: sample "), "{}", run.out);

    export(["speed", "correction"], 0.0);
    let run = compare(&[]);
    assert_eq!(run.code, 2);
    assert!(run.err.starts_with("scope.csv:1:1: error[AX015]: no column of an output"), "{}", run.err);
    let run = compare(&["--map", "speed=v_motor", "--map", "correction=v_add", "--map", "MAIN.temperature=-"]);
    assert_eq!(run.code, 0, "{}{}", run.out, run.err);
}

/// Outputs alone, next to a stimulus; one output alone; none; and no inputs at all.
#[test]
fn what_a_recording_may_lack() {
    let folder = folder();
    let rows = recording(folder.path());
    let only = |columns: &[usize]| -> String {
        let row = |row: &String| {
            let cells: Vec<&str> = row.split(',').collect();
            columns.iter().map(|column| cells[*column]).collect::<Vec<_>>().join(",") + "\n"
        };
        rows.iter().map(row).collect()
    };
    fs::write(folder.path().join("outputs.csv"), only(&[2, 7])).unwrap();
    let run = axgen(folder.path(), &[&RACK[..], &["--stimulus", "in.csv", "--compare", "outputs.csv"]].concat());
    assert_eq!(verdict(&run.out), "v_add, fault against engine reference, 400 samples: 0 differing bits\n");
    let run = axgen(folder.path(), &[&RACK[..], &["--compare", "in.csv"]].concat());
    assert_eq!(run.code, 2);
    assert!(run.err.starts_with("in.csv:1:1: error[AX015]: no column of an output"), "{}", run.err);
    let run = axgen(folder.path(), &RACK);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("--stimulus <FILE>"), "{}", run.err);
    // A recording that goes on where the stimulus has ended.
    fs::write(folder.path().join("short.csv"), "v_motor,mode\n1.0,1\n").unwrap();
    let run = axgen(folder.path(), &[&RACK[..], &["--stimulus", "short.csv", "--compare", "outputs.csv"]].concat());
    assert_eq!(run.code, 1, "{}", run.out);
}

/// The engines that are there have run, and the missing one is named.
#[test]
fn a_missing_compiler_is_the_environment() {
    let folder = folder();
    let verify = |variable: &str, more: &[&str]| {
        let output = Command::new(AXGEN)
            .current_dir(folder.path())
            .env(variable, "no-such-compiler")
            .args(["verify", "machine.toml", "--samples", "10"])
            .args(more)
            .output()
            .unwrap();
        let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
        (output.status.code(), out, err)
    };
    for (variable, language, engine) in [("CC", "C", "c"), ("RUSTC", "Rust", "rust")] {
        let (code, out, err) = verify(variable, &[]);
        assert_eq!(code, Some(3), "{err}");
        let missing = format!(
            "engine {engine}: error[AX018]: the {language} compiler `no-such-compiler` does not start (No such file or \
             directory (os error 2)); install it, or set {variable} to another\n"
        );
        assert!(err.ends_with(&missing), "{err}");
        assert_eq!(err.matches("no-such-compiler").count(), 1, "{err}");
        for row in out.lines().skip(1) {
            let words: Vec<&str> = row.split_whitespace().collect();
            if words[0] == "not" {
                continue;
            }
            let expected = match words[2] {
                "reference" => "(reference)",
                "reached:" => continue,
                missing if missing == engine => "- not run",
                _ => "0",
            };
            assert_eq!(words[4..].join(" "), expected, "{row}");
        }
    }
    let (code, out, err) = verify("CC", &["--engine", "st", "--engine", "program"]);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    assert_eq!(out.lines().filter(|line| !line.starts_with(' ')).count(), 1 + 3 * 4, "{out}");
}

//! What a new user meets: a set to start from, what a parameter or a code means, the schema, completions, pages; and what a
//! release pipeline meets: checks of files, results for machines.

mod files;
mod killed;
mod messages;
mod outputs;
mod paths;
mod special;
mod streams;

use crate::{AXGEN, ROOT, Run};
use serde_json::Value;
use std::process::{Command, Stdio};
use std::{fs, path::Path};
use tempfile::TempDir;

fn axgen(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let Run { code, out, err } = crate::axgen(folder, arguments);
    (code, out, err)
}

/// A folder with the set that `init` writes.
fn started() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let (code, out, err) = axgen(folder.path(), &["init"]);
    assert_eq!((code, out.as_str(), err.as_str()), (0, "axes.toml: edit it, then: axgen check axes.toml\n", ""));
    let first = fs::read_to_string(folder.path().join("axes.toml")).unwrap();
    assert!(first.starts_with("#:schema ./axgen.schema.json\n"), "{first}");
    folder
}

/// A golden case of few samples: those of a short move.
fn write_case(folder: &Path) {
    fs::create_dir(folder.join("case")).unwrap();
    let case = "purpose = \"\"\nset = \"../axes.toml\"\naxis = \"X\"\nblock = \"ipc\"\nscenario = \"move.nc\"\n";
    fs::write(folder.join("case/case.toml"), case).unwrap();
    fs::write(folder.join("case/move.nc"), "G0 X1\nM30\n").unwrap();
}

fn edit(folder: &Path, from: &str, to: &str) {
    let text = fs::read_to_string(folder.join("axes.toml")).unwrap();
    assert_eq!(text.matches(from).count(), 1, "{from}");
    fs::write(folder.join("axes.toml"), text.replace(from, to)).unwrap();
}

#[test]
fn what_init_writes_is_checked_generated_and_verified_without_a_warning() {
    let folder = started();
    let (code, out, err) = axgen(folder.path(), &["check", "axes.toml"]);
    assert_eq!((code, err.as_str()), (0, ""));
    assert!(out.ends_with("0 warnings, 0 parameters of other functions passed over\n"), "{out}");
    assert_eq!(axgen(folder.path(), &["generate", "axes.toml"]).0, 0);
    assert_eq!(axgen(folder.path(), &["verify", "axes.toml", "--samples", "1000"]).0, 0);
}

#[test]
fn a_check_is_silent_right_after_generate_and_names_every_change() {
    let folder = started();
    let all = ["c", "rust", "st", "twincat", "codesys", "scl"].map(|target| ["--target", target]).concat();
    let generate = |more: &[&str]| axgen(folder.path(), &[&["generate", "axes.toml"], all.as_slice(), more].concat());
    assert_eq!(generate(&[]).0, 0);
    assert_eq!(generate(&["--check"]), (0, String::new(), String::new()));
    assert_eq!(generate(&["--diff"]), (0, String::new(), String::new()));
    // A file was edited, another is gone.
    let (st, scl) = (folder.path().join("generated/axis_x_ipc.st"), folder.path().join("generated/axis_x_ipc.scl"));
    fs::write(&st, fs::read_to_string(&st).unwrap().replacen("LREAL", "REAL", 1)).unwrap();
    fs::remove_file(&scl).unwrap();
    let (code, out, _) = generate(&["--check"]);
    assert_eq!((code, out.as_str()), (1, "generated/axis_x_ipc.st: differs\ngenerated/axis_x_ipc.scl: is not there\n"));
    assert!(!scl.exists(), "nothing was written");
    generate(&["--force"]);
    // A parameter was changed.
    edit(folder.path(), "fg_f0 = 53.0", "fg_f0 = 54.0");
    let (code, out, _) = generate(&["--check"]);
    assert_eq!((code, out.lines().count()), (1, 14), "{out}");
    let (code, out, _) = generate(&["--diff"]);
    assert_eq!(code, 1);
    assert!(out.contains("--- generated/axis_x_ipc.c\n+++ generated/axis_x_ipc.c (as it would be written)\n"), "{out}");
    assert!(out.contains("\n-") && out.contains("centre frequency 53 Hz") && out.contains("centre frequency 54 Hz"));
    generate(&[]);
    assert_eq!(generate(&["--check"]).0, 0);
    edit(folder.path(), "Paths and units are those of an axis list.", "Another comment.");
    assert_eq!(generate(&["--check"]), (0, String::new(), String::new()), "a comment changes no file");
}

#[test]
fn every_stage_can_be_printed() {
    let folder = started();
    let (_, help, _) = axgen(folder.path(), &["generate", "--help"]);
    let passes = compiler::pass::PASSES.map(|(name, _)| name);
    let stages =
        ["parameters", "program"].into_iter().chain(passes).chain(["c", "rust", "st", "twincat", "codesys", "scl"]);
    for stage in stages {
        assert!(help.contains(stage), "{stage} is in the help: {help}");
        let (code, out, err) = axgen(folder.path(), &["generate", "axes.toml", "--emit", stage]);
        assert_eq!((code, err.as_str()), (0, ""));
        let shown = if stage == "parameters" { "weight_fact_num 50" } else { "outputs.v_add = " };
        assert!(out.starts_with("# axis X") && out.contains(shown), "{stage}: {out}");
    }
    assert!(!folder.path().join("generated").exists(), "no file is written");
}

#[test]
fn messages_for_machines_are_an_object_a_line() {
    let folder = started();
    edit(folder.path(), "v_add_max_fact = 100 ", "v_add_max_fact = 9999 ");
    edit(folder.path(), "order = 1,", "ordr = 1,");
    let (code, _, err) = axgen(folder.path(), &["check", "axes.toml", "--message-format", "json"]);
    assert_eq!(code, 2);
    let objects: Vec<Value> = err.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let codes: Vec<&str> = objects.iter().map(|object| object["code"].as_str().unwrap()).collect();
    assert_eq!(codes, ["AX104", "AX203", "AX206"]);
    assert_eq!(objects[1]["line"], 24);
    assert_eq!(objects[1]["column"], 18);
    assert_eq!(objects[1]["severity"], "error");
    assert_eq!(objects[1]["file"], "axes.toml");
    assert_eq!(objects[1]["allowed"], "0 <= v_add_max_fact <= 2000 [0.1 %]");
    assert!(objects[1]["text"].as_str().unwrap().starts_with("v_add_max_fact = 9999"));
    assert_eq!(objects[0]["instead"].as_str(), Some("order"));
}

#[test]
fn a_parameter_is_found_by_id_path_and_end_of_path() {
    let folder = tempfile::tempdir().unwrap();
    let told = |wanted: &str| {
        let (code, out, _) = axgen(folder.path(), &["params", wanted]);
        assert_eq!(code, 0, "{wanted}");
        out
    };
    let by_id = told("P-AXIS-00752");
    for wanted in [
        "p-axis-00752",
        "00752",
        "q_factor",
        "filter.q_factor",
        "lr_param.improved_position_control.stage[2].filter[1].q_factor",
        "lr_param.improved_position_control.stage[i].filter.q_factor",
    ] {
        assert_eq!(told(wanted), by_id, "{wanted}");
    }
    assert_eq!(
        by_id,
        "lr_param.improved_position_control.stage[i].filter[k].q_factor (P-AXIS-00752)\n  \
         meaning   quality factor: centre frequency / bandwidth at -3 dB\n  \
         type      REAL64\n  \
         allowed   1 <= q_factor <= 10\n  \
         default   -1\n  \
         since     V3.1.3077.08\n  \
         drives    SERCOS, PROFIdrive, CANopen\n  \
         axes      T, R, S\n  \
         dimension ----\n  \
         also      lr_param.improved_position_control.stage[i].filter.q_factor\n  \
         stands in an axis list, and below an axis of a set\n"
    );
    let misprinted = told("lr_param.improved_position_control.stage[i]osc_damping");
    assert_eq!(misprinted, told("00850"));
    assert!(
        misprinted.contains("\n  misprint  lr_param.improved_position_control.stage[i]osc_damping\n"),
        "{misprinted}"
    );
    let meant = "\n  allowed   0 (per minute), 1 (per second), 2 (per sampling interval)\n";
    assert!(told("v_time_base").contains(meant));
    assert!(
        told("vs_v_faktor").contains("\n  type      SGN32\n") && told("vs_v_faktor").contains("\n  drives    ----\n")
    );
    assert!(told("00758").contains("\n  since     V3.1.3077.08; words: V3.1.3132.0\n"));
    // The manuals print two units of a load, and of a nominal torque.
    assert!(told("00391").contains("\n  axes      T, R, S\n  dimension T: kg; R, S: kg m^2\n"));
    assert!(told("00392").contains("\n  axes      T, R, S\n  dimension T: N; R, S: Nm\n"));
    assert!(told("00767").contains("\n  axes      S\n  dimension S: 0.001 deg/s\n"));
    assert!(!told("00833").contains("axes") && !told("00833").contains("dimension"));
    let (code, _, err) = axgen(folder.path(), &["params", "bandwidth"]);
    assert!(code == 2 && err.contains("error[AX012]: no parameter `bandwidth`"), "{err}");
    assert!(axgen(folder.path(), &["params"]).1.lines().count() >= 20);
}

/// What the manuals name and axgen does not read: by both commands, in the list of all, and on the page; never a parameter
/// that is read.
#[test]
fn what_the_manuals_name_besides_is_known() {
    let folder = started();
    let ask = |command: &str, name: &str| {
        let (code, out, err) = axgen(folder.path(), &[command, name]);
        assert_eq!((code, err.as_str()), (0, ""), "{command} {name}");
        out
    };
    let names = [
        "V_SATZ_ANZ",
        "P-AXIS-00405",
        "P-AXIS-00065",
        "P-CHAN-00071",
        "#SLOPE",
        "CNC objects",
        "S-0-0104",
        "S-0-0296",
        "S-0-0348",
        "P-AXIS-00267",
        "P-AXIS-00268",
    ];
    let (_, all, _) = axgen(folder.path(), &["params"]);
    let (_, page, _) = axgen(folder.path(), &["params", "--markdown"]);
    for name in names {
        let told = ask("params", name);
        assert!(told.starts_with(&format!("{name}\n  meaning   ")) && told.contains("\n  not read  "), "{told}");
        assert_eq!(ask("explain", name).trim_end(), told.trim_end());
        assert_eq!(ask("params", &name.to_ascii_lowercase()), told);
        assert_eq!(all.lines().filter(|line| line.starts_with(&format!("{name} "))).count(), 1, "{name}");
        assert_eq!(page.lines().filter(|line| line.starts_with(&format!("| {name} |"))).count(), 1, "{name}");
    }
    // The digit in m3 is not an index: m4 is a different signal.
    assert!(
        ask("explain", "m4").contains("request: turn in negative direction") && ask("explain", "M5").contains("stop")
    );
    for (short, name) in [("00405", "P-AXIS-00405"), ("00071", "P-CHAN-00071"), ("slope", "#SLOPE")] {
        assert_eq!(ask("params", short), ask("params", name));
    }
    assert!(ask("params", "CNC objects").contains("their names and numbers are open"));
    let read = generator::parameters::Name::ALL.map(|name| name.parameter().id);
    for other in &generator::parameters::others::OTHERS {
        assert!(!read.contains(&Some(other.name)), "{}", other.name);
        assert!([other.name, other.meaning, other.unread].iter().all(|text| text.is_ascii() && !text.contains('|')));
    }
}

#[test]
fn the_reference_page_is_what_the_table_says() {
    let folder = tempfile::tempdir().unwrap();
    let (_, page, _) = axgen(folder.path(), &["params", "--markdown"]);
    let kept = fs::read_to_string(Path::new(ROOT).join("docs/parameters.md")).unwrap();
    assert!(kept == page, "docs/parameters.md: axgen params --markdown >docs/parameters.md");
}

/// The errors of the controller, however they are written, and the error ids of the blocks: those that the reference has.
#[test]
fn every_number_is_explained() {
    let folder = started();
    for number in [70348, 70349, 70350, 70351, 70600, 110_465, 110_473, 110_624] {
        for written in [number.to_string(), format!("P-ERR-{number}")] {
            let (exit, out, err) = axgen(folder.path(), &["explain", &written]);
            assert_eq!((exit, err.as_str()), (0, ""), "{written}");
            assert!(out.contains(&format!("Error {number} of the controller.\n\nAX")), "{out}");
        }
    }
    let reference = include_str!("../../../../reference/src/signal.rs");
    let ids = reference.split("/// error_id: ").skip(1).map(|rest| {
        let (why, rest) = rest.split_once("\n    pub fn").unwrap();
        let why = why.replace("\n    /// ", " ");
        let id = rest.split_once('{').unwrap().1.split_once("u32").unwrap().0.trim();
        (id.replace('_', ""), why)
    });
    let mut count = 0;
    for (id, why) in ids.filter(|(id, _)| id != "0") {
        let (exit, out, _) = axgen(folder.path(), &["explain", &id]);
        assert_eq!(exit, 0, "{id}");
        assert!(out.starts_with(&format!("error_id {id} of a block: {why}\n\nWhat the block does: ")), "{out}");
        assert!(out.contains("\n\nWhat to do: "), "{out}");
        let number: u32 = id.parse().unwrap();
        // What is true of a kind of ids is said of each of them, and of no other.
        assert_eq!(out.contains("The request is lost."), (31..=36).contains(&number) || number == 49, "{out}");
        assert_eq!(out.contains("Not a fault"), (4..=8).contains(&number) || number == 51, "{out}");
        let stays = [1, 3, 9, 14, 17, 18, 41, 42, 43, 44, 45, 46, 48].contains(&number);
        assert_eq!(out.contains("until a reset."), stays, "{out}");
        assert_eq!(out.contains("fourth consecutive bad cycle"), [14, 17, 18, 45].contains(&number), "{out}");
        count += 1;
    }
    assert_eq!(count, generator::error_ids::all().count());
    assert_eq!(axgen(folder.path(), &["explain", "error_id 12"]), axgen(folder.path(), &["explain", "12"]));
    assert_eq!(axgen(folder.path(), &["explain", "99"]).0, 2);
}

#[test]
fn every_code_is_explained() {
    let folder = tempfile::tempdir().unwrap();
    let (_, list, _) = axgen(folder.path(), &["explain"]);
    assert!(list.lines().count() > 40);
    for line in list.lines() {
        let (code, title) = line.split_once(' ').unwrap();
        let (exit, out, _) = axgen(folder.path(), &["explain", &code.to_lowercase()]);
        assert_eq!(exit, 0);
        assert!(out.starts_with(&format!("{code}: {title}\n\n")) && out.ends_with(".\n"), "{out}");
    }
    let (code, _, err) = axgen(folder.path(), &["explain", "AX999"]);
    assert!(code == 2 && err.contains("error[AX012]: no code `AX999`"), "{err}");
}

/// Signals, parameters, their words; a number that neither a block nor a controller has is not explained.
#[test]
fn words_are_explained() {
    let folder = started();
    for (word, said) in [
        ("limited", "output `limited` of the block ipc: the sum of the stages is above the limit"),
        ("tripped", "output `tripped` of the block ipc: the loop was found unstable"),
        ("DRYRUN", "lr_param.improved_position_control.enable (P-AXIS-00758)"),
        ("P-AXIS-00757", "lr_param.improved_position_control.v_add_max_fact (P-AXIS-00757)"),
    ] {
        let (code, out, err) = axgen(folder.path(), &["explain", word]);
        assert_eq!((code, err.as_str()), (0, ""), "{word}");
        assert!(out.starts_with(said), "{word}: {out}");
    }
    let (code, _, err) = axgen(folder.path(), &["explain", "902"]);
    assert!(code == 2 && err.contains("error[AX012]: no code `902`"), "{err}");
    let (code, _, err) = axgen(folder.path(), &["explain", "limitted"]);
    let said = "no code, signal, parameter or word `limitted`; `axgen explain` lists all codes, and `axgen params` all parameters";
    assert!(code == 2 && err.contains(said), "{err}");
}

/// What the schema takes is tested in the crate tests.
#[test]
fn the_schema_is_printed() {
    let (code, out, _) = axgen(tempfile::tempdir().unwrap().path(), &["schema"]);
    assert_eq!((code, out.trim_end()), (0, generator::schema::text().trim_end()));
}

#[test]
fn the_shells_and_the_manual_know_every_command() {
    let folder = tempfile::tempdir().unwrap();
    let commands = ["generate", "check", "run", "verify", "golden", "params", "explain", "init", "schema"];
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let (code, out, _) = axgen(folder.path(), &["completions", shell]);
        assert_eq!(code, 0);
        assert!(commands.iter().all(|command| out.contains(command)), "{shell}");
    }
    assert_eq!(axgen(folder.path(), &["man", "pages"]).0, 0);
    for command in commands {
        let page = fs::read_to_string(folder.path().join(format!("pages/axgen-{command}.1"))).unwrap();
        assert!(page.contains(".SH SYNOPSIS"), "{command}");
    }
}

#[test]
fn results_for_a_pipeline() {
    let folder = started();
    let run = ["verify", "axes.toml", "--samples", "100", "--junit", "junit.xml", "--json", "results.json"];
    assert_eq!(axgen(folder.path(), &run).0, 0);
    let results = fs::read_to_string(folder.path().join("results.json")).unwrap();
    let results: Value = serde_json::from_str(&results).unwrap();
    assert_eq!((&results["suite"], &results["failures"]), (&"axgen verify".into(), &0.into()));
    assert_eq!(results["results"].as_array().unwrap().len(), 8);
    assert_eq!(results["results"][3]["name"], "ipc rust");
    assert_eq!(
        elements(&folder.path().join("junit.xml")),
        ["testsuites", "testsuite"].iter().chain(&["testcase"; 8]).copied().collect::<Vec<_>>()
    );
}

/// A case of a user's own: recorded, verified, and found to differ after a change.
#[test]
fn a_users_own_golden_case() {
    let folder = started();
    let case = "purpose = \"<mine> & \\\"yours\\\"\"\nset = \"axes.toml\"\naxis = \"X\"\nblock = \"ipc\"\n\
                [stimulus.signal]\nv_motor = [{ form = { noise = { seed = 1 } }, amplitude = 1000 }]\n";
    fs::write(folder.path().join("case.toml"), case).unwrap();
    let verify = ["golden", "verify", ".", "--junit", "junit.xml", "--json", "results.json"];
    assert_eq!(axgen(folder.path(), &["golden", "record", "."]), (0, ".: recorded\n".to_owned(), String::new()));
    assert_eq!(axgen(folder.path(), &verify), (0, ".: as recorded\n".to_owned(), String::new()));
    edit(folder.path(), "weight_fact_num = 50", "weight_fact_num = 51");
    let (code, out, _) = axgen(folder.path(), &verify);
    assert_eq!(code, 1);
    assert!(out.starts_with(".: differs in outputs.csv, digest, emitted/axis_x_ipc.h"), "{out}");
    assert_eq!(elements(&folder.path().join("junit.xml")), ["testsuites", "testsuite", "testcase", "failure"]);
    let results = fs::read_to_string(folder.path().join("results.json")).unwrap();
    assert!(results.contains("\"passed\": false") && results.contains("differs in outputs.csv"), "{results}");
}

/// The names of an XML file's elements, in their order.
fn elements(path: &Path) -> Vec<String> {
    let text = fs::read_to_string(path).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let elements = document.descendants().filter(roxmltree::Node::is_element);
    elements.map(|element| element.tag_name().name().to_owned()).collect()
}

#[test]
fn a_reader_that_goes_away_is_no_defect() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(AXGEN)
        .current_dir(folder.path())
        .args(["params", "--markdown"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(command.stdout.take());
    let output = command.wait_with_output().unwrap();
    assert_eq!(String::from_utf8_lossy(&output.stderr), "");
}

#[test]
fn a_difference_is_said_in_what_it_means() {
    let folder = started();
    fs::copy(folder.path().join("axes.toml"), folder.path().join("old.toml")).unwrap();
    let diff = ["diff", "old.toml", "axes.toml"];
    edit(folder.path(), "# An axis set.", "# The axis set.");
    let (code, out, err) = axgen(folder.path(), &diff);
    assert_eq!((code, out.as_str(), err.as_str()), (0, "no difference in what the blocks do\n", ""));
    edit(folder.path(), "weight_fact_num = 50", "weight_fact_num = 100");
    let (code, out, _) = axgen(folder.path(), &diff);
    assert_eq!(code, 1);
    assert!(out.starts_with("axis X: stage[0]: weight 0.5 -> 1 (-6.02 -> 0 dB)"), "{out}");
    edit(folder.path(), "order = 1", "order = 4");
    let (code, out, err) = axgen(folder.path(), &diff);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("AX203"), "{err}");
}

#[test]
fn check_certifies_range_and_response() {
    let folder = started();
    let (_, out, _) = axgen(folder.path(), &["check", "axes.toml"]);
    assert!(!out.contains("range") && out.contains("\n  stage 0: weight 0.5; a drive that only delays "), "{out}");
    let (_, out, _) = axgen(folder.path(), &["check", "axes.toml", "--verbose"]);
    assert!(out.contains("\n  range: |v| <= 500000 um/s gives |v_add| <= "), "{out}");
    assert!(out.contains("\n  stage[0] at 53 Hz: designed 0.5 at 180 deg, measured 0.5 at 180 deg; at "), "{out}");
}

/// `check`, `generate` and `diff` warn of the same; of the two sets of a `diff`, of the one that is to run.
#[test]
fn a_diff_warns_of_the_new_set() {
    let folder = started();
    let old = fs::read_to_string(folder.path().join("axes.toml")).unwrap();
    let new = old.replace("\"DRYRUN\"", "\"ON\"").replace("v_add_max_fact = 100", "v_add_max_fact = 1000");
    assert_ne!(new, old);
    fs::write(folder.path().join("new.toml"), new).unwrap();
    let warnings = |arguments: &[&str]| {
        let (_, _, err) = axgen(folder.path(), arguments);
        err.lines().filter(|line| line.contains(": warning[")).map(str::to_owned).collect::<Vec<_>>()
    };
    let of_check = warnings(&["check", "new.toml"]);
    assert!(of_check.iter().any(|line| line.contains("AX439")), "{of_check:?}");
    assert_eq!(warnings(&["generate", "new.toml"]), of_check);
    assert_eq!(warnings(&["diff", "axes.toml", "new.toml"]), of_check);
    assert_eq!(warnings(&["diff", "new.toml", "axes.toml"]), warnings(&["check", "axes.toml"]));
}

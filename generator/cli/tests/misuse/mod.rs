//! Misuses of the command, as somebody makes them who puts a machine into operation: each is refused or warned of, and nearly each with
//! what to do instead. The rows are in `table.toml`.

use serde_json::Value;
use std::{collections::BTreeMap, fs, path::Path, process::Command};

/// Of the misuses that were looked for, so many may be said without what to do instead.
const WITHOUT_REMEDY: usize = 10;

struct Row {
    kind: String,
    what: String,
    run: String,
    exit: i32,
    says: String,
    change: Vec<[String; 3]>,
    files: BTreeMap<String, String>,
}

/// What a row's command has said.
struct Said {
    exit: i32,
    text: String,
    is_silent: bool,
    has_remedy: bool,
}

fn text(value: &toml::Value) -> String {
    value.as_str().unwrap().to_owned()
}

fn texts(value: Option<&toml::Value>) -> BTreeMap<String, String> {
    let table = value.and_then(toml::Value::as_table);
    table.into_iter().flatten().map(|(name, value)| (name.clone(), text(value))).collect()
}

fn table() -> (BTreeMap<String, String>, Vec<Row>) {
    let table: toml::Table = include_str!("table.toml").parse().unwrap();
    let change = |row: &toml::Value| {
        let changes = row.get("change").and_then(toml::Value::as_array).into_iter().flatten();
        changes.map(|change| [0, 1, 2].map(|i| text(&change[i]))).collect()
    };
    let row = |row: &toml::Value| Row {
        kind: text(&row["kind"]),
        what: text(&row["what"]),
        run: text(&row["run"]),
        exit: i32::try_from(row["exit"].as_integer().unwrap()).unwrap(),
        says: text(&row["says"]),
        change: change(row),
        files: texts(row.get("files")),
    };
    (texts(table.get("files")), table["row"].as_array().unwrap().iter().map(row).collect())
}

/// The words of a command line; quotes hold a blank.
fn words(line: &str) -> Vec<String> {
    let parts = line.split('"').enumerate();
    let of_part = |(i, part): (usize, &str)| match i % 2 {
        0 => part.split_whitespace().map(str::to_owned).collect(),
        _ => vec![part.to_owned()],
    };
    parts.flat_map(of_part).collect()
}

fn write(folder: &Path, files: &BTreeMap<String, String>) {
    for (name, text) in files {
        fs::write(folder.join(name), text).unwrap();
    }
}

/// Runs a command in a folder with files; they stay as they are.
fn run(line: &str, files: &BTreeMap<String, String>) -> Said {
    let folder = tempfile::tempdir().unwrap();
    write(folder.path(), files);
    let mut command = Command::new(crate::AXGEN);
    let output = command.current_dir(folder.path()).arg("--message-format=json").args(words(line)).output().unwrap();
    for (name, text) in files {
        assert_eq!(&fs::read_to_string(folder.path().join(name)).unwrap(), text, "{line}: {name} is as it was");
    }
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    let exit = output.status.code().unwrap_or_else(|| panic!("{line}: {}", output.status));
    Said { exit, is_silent: exit == 0 && err.is_empty(), has_remedy: false, text: out + &err }
}

fn of_row(row: &Row, given: &BTreeMap<String, String>) -> Said {
    let mut files = given.clone();
    files.extend(row.files.clone());
    for [file, old, new] in &row.change {
        let text = files.get_mut(file).unwrap();
        assert_eq!(text.matches(old.as_str()).count(), 1, "{}: {old} in {file}", row.what);
        *text = text.replace(old.as_str(), new);
    }
    let mut said = run(&row.run, &files);
    let messages = said.text.lines().filter(|line| line.contains(&row.says));
    let objects = messages.filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let is_given = |object: &Value, key: &str| object.get(key).is_some_and(|value| !value.is_null());
    said.has_remedy = objects.into_iter().any(|object| {
        let found = object.to_string();
        ["allowed", "instead"].iter().any(|key| is_given(&object, key))
            || ["give another name", "is allowed", "lists all", "give two names"]
                .iter()
                .any(|remedy| found.contains(remedy))
    });
    said
}

#[test]
fn nothing_is_said_of_what_the_rows_change() {
    let (files, _) = table();
    for line in ["damped.toml", "spindle.toml", "gantry.toml", "listed.toml", "x.lis --cycle-time 1ms"] {
        let said = run(&format!("check {line}"), &files);
        assert!(said.is_silent, "{line}: {}", said.text);
    }
}

#[test]
#[expect(clippy::print_stdout, reason = "the figures")]
fn every_misuse_is_said_and_nearly_each_with_a_remedy() {
    let (files, rows) = table();
    let further = rows.iter().filter(|row| row.kind == "further").count();
    assert!(further >= 60 && rows.len() - further >= 29, "{further} of {}", rows.len());
    let (mut wrong, mut without) = (Vec::new(), Vec::new());
    for row in &rows {
        let said = of_row(row, &files);
        if said.exit != row.exit || row.says.is_empty() || !said.text.contains(&row.says) {
            wrong.push(format!("{}: exit {}, {}", row.what, said.exit, said.text));
        }
        if row.kind == "further" && !said.has_remedy {
            without.push(&row.what);
        }
    }
    println!("{} misuses, {} of {further} without a remedy: {without:?}", rows.len(), without.len());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(without.len() <= WITHOUT_REMEDY, "{without:?}");
}

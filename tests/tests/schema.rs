//! The schema of a set next to `check`: it takes what `check` takes, and refuses what the place of a value alone tells. A third
//! party's validator judges.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use generator::config::{self, ListOptions, Unreadable};
use generator::diagnostics::Report;
use generator::import_export::import;
use generator::pipeline::read_with;
use generator::schema;
use jsonschema::Validator;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
const IPC: &str = "lr_param.improved_position_control";

fn validator() -> Validator {
    let schema: Value = serde_json::from_str(&schema::text()).unwrap();
    jsonschema::meta::validate(&schema).unwrap();
    jsonschema::validator_for(&schema).unwrap()
}

fn json(set: &str) -> Value {
    serde_json::to_value(toml::from_str::<toml::Table>(set).unwrap_or_else(|error| panic!("{error}\n{set}"))).unwrap()
}

fn mistakes(validator: &Validator, set: &str) -> Vec<String> {
    validator.iter_errors(&json(set)).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

/// What `check` says about a set without files next to it.
fn checked(set: &str) -> Report {
    let load = |path: &Path| match path == Path::new("set.toml") {
        true => Ok(set.as_bytes().to_vec()),
        false => Err(Unreadable::System("there is no such file".to_owned())),
    };
    read_with(Path::new("set.toml"), &ListOptions::default(), &load).1
}

fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(Path::new(ROOT).join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let below = entries.flat_map(|path| match path.is_dir() {
        true => fs::read_dir(path).unwrap().map(|entry| entry.unwrap().path()).collect(),
        false => vec![path],
    });
    let mut files: Vec<PathBuf> = below.filter(|path| path.to_string_lossy().ends_with(ending)).collect();
    files.sort();
    files
}

#[test]
fn it_takes_the_sets_of_the_repository_and_what_import_makes_of_its_lists() {
    let validator = validator();
    let starter = files("generator/cli/src", "starter.toml");
    let sets = [starter, files("examples", ".toml"), files("golden/cases", "set.toml")].concat();
    assert!(sets.len() > 20);
    for path in sets.into_iter().filter(|path| !path.ends_with("Cargo.toml")) {
        assert_eq!(mistakes(&validator, &fs::read_to_string(&path).unwrap()), [""; 0], "{}", path.display());
    }
    let lists = [files("examples", ".lis"), files("golden/cases", ".lis")].concat();
    assert!(lists.len() > 1);
    for path in lists {
        let options =
            ListOptions { cycle_time: Some("1ms".to_owned()), name: Some("X".to_owned()), ..ListOptions::default() };
        let set = import(&path, &options, &config::load).0.unwrap();
        assert_eq!(mistakes(&validator, &set), [""; 0], "{}\n{set}", path.display());
    }
}

/// A set with a valid stage, a part of which is replaced.
fn changed(from: &str, to: &str) -> String {
    let set = format!(
        "cycle_time = '1ms'\ntargets = ['c']\n[axis.X]\n{IPC}.v_add_max_fact = 1\n{IPC}.stage = [{{ mode = 'DIRECT', \
         weight_fact_num = 1, filter = [{{ order = 1, fg_f0 = 53, q_factor = 10 }}] }}]\n"
    );
    assert_eq!(set.matches(from).count(), 1, "{from}");
    set.replace(from, to)
}

/// The sets of one of the lists in `schema.toml`, which says what replaces what in the set above.
fn listed(list: &str) -> Vec<String> {
    let lists: toml::Table = include_str!("schema.toml").parse().unwrap();
    let text = |change: &toml::Value, at: usize| change[at].as_str().unwrap().to_owned();
    lists[list].as_array().unwrap().iter().map(|change| changed(&text(change, 0), &text(change, 1))).collect()
}

#[test]
fn it_takes_what_check_takes() {
    let validator = validator();
    for set in listed("taken") {
        assert!(!checked(&set).has_errors(), "{set}\n{}", checked(&set));
        assert_eq!(mistakes(&validator, &set), [""; 0], "{set}");
    }
}

#[test]
fn it_refuses_what_check_refuses() {
    let validator = validator();
    for set in listed("refused") {
        assert!(checked(&set).has_errors(), "{set}");
        assert_ne!(mistakes(&validator, &set), [""; 0], "{set}");
    }
}

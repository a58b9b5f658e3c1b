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
    let sets = [files("examples", ".toml"), files("golden/cases", "set.toml")].concat();
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

/// What replaces what in the set above.
const TAKEN: &[(&str, &str)] = &[
    ("'1ms'", "'1 ms'"),
    ("'1ms'", "'1000\u{b5}s'"),
    ("'1ms'", "'.5ms'"),
    ("'1ms'", "'0001.50000000000000ms'"),
    ("'1ms'", "'2000000.0ns'"),
    ("['c']", "['C', 'TwinCAT']"),
    ("['c']", "[]"),
    ("[axis.X]", "[axis.X]\nfade = '1000s'"),
    ("[axis.X]", "[axis.X]\nfade = '0s'"),
    ("[axis.X]", "[axis.X]\nreal = 'LREAL'\ngear = 15"),
    ("[axis.X]", "[axis.X]\nkenngr.achs_typ = 0x4"),
    ("[axis.X]", "[axis.X]\nkenngr.antr_typ = '0X02'\nantr.operation_mode = 'cnc_position_control'"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vorsteuerung = 'vel |ACC'"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vorsteuerung = '1 0x2'"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vorsteuerung = ''"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vorsteuerung = 0x303\nprocess_data.additive_torque = 'INT'"),
    ("[axis.X]", "[axis.X]\nvorsteuer.default_active = true\nvorsteuer.global_disable = 'false'"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vs_a_nenner = -5\nantr.v_reso_num = -1"),
    ("[axis.X]", "[axis.X]\ngetriebe = [{ dynamik.vb_max = 5 }, { dynamik.vb_max = 0 }]"),
    ("[axis.X]", "[axis.X]\nspindle = { deceleration = 0.5, mode_timeout = '1ns', brake_timeout = '0s' }"),
    ("[axis.X]", "[axis.X]\nprocess_data.objects = ['0x60FF', '607ah']\ndrive_settings = ['s-0-0076=010']"),
    ("[axis.X]", "[axis.X]\nantr.canopen.cyclic_velocity_op_mode = -3\nantr.sercos.op_mode_for_velocity_control = 4"),
    (".v_add_max_fact = 1\n", ".v_add_max_fact = 1\nlr_param.improved_position_control.enable = 'on'\n"),
    (".v_add_max_fact = 1\n", ".v_add_max_fact = 1\nlr_param.improved_position_control.enable = true\n"),
    (".v_add_max_fact = 1\n", ".v_add_max_fact = 1\nlr_param.improved_position_control.enable = '+01'\n"),
    ("mode = 'DIRECT'", "mode = 'direct', osc_damping = 1"),
    ("mode = 'DIRECT'", "mode = 1, osc_damping = -7"),
    ("order = 1", "order = 1, damping = 1"),
    ("}] }]", "}] }, { mode = 0, weight_fact_num = 0, filter.order = 9, filter.damping = 1 }]"),
    ("}] }]", "}] }, { filter.fg_f0 = 9999 }]"),
    ("}] }]", "}, { fg_f0 = -7, order = 9 }] }]"),
    ("}] }]", "}, { type = 'no_filter', fg_f0 = -7, order = 9 }] }]"),
    ("}] }]", "}, { type = 'ALLPASS', order = 9, fg_f0 = 40, q_factor = 2 }] }]"),
    ("mode = 'DIRECT'", "mode = 'INDIRECT', osc_damping = 0.5"),
    ("mode = 'DIRECT'", "mode = 'SET_POINT', osc_damping = 0.5"),
    ("[{ order = 1, fg_f0 = 53, q_factor = 10 }]", "{ order = 1, fg_f0 = 53, q_factor = 10 }"),
];

#[test]
fn it_takes_what_check_takes() {
    let validator = validator();
    for (from, to) in TAKEN {
        let set = changed(from, to);
        assert!(!checked(&set).has_errors(), "{to}\n{}", checked(&set));
        assert_eq!(mistakes(&validator, &set), [""; 0], "{to}");
    }
}

/// The same.
const REFUSED: &[(&str, &str)] = &[
    ("'1ms'", "'0ms'"),
    ("'1ms'", "'0.000s'"),
    ("'1ms'", "'10s'"),
    ("'1ms'", "'5s'"),
    ("'1ms'", "'1'"),
    ("'1ms'", "'ms'"),
    ("'1ms'", "'.ms'"),
    ("'1ms'", "'0.0005us'"),
    ("'1ms'", "1"),
    ("['c']", "['c', 'ada']"),
    ("['c']", "'c'"),
    ("[axis.X]", "[axis.X]\nfade = '2000s'"),
    ("[axis.X]", "[axis.X]\nfade = -1"),
    ("[axis.X]", "[axis.X]\ngear = 16"),
    ("[axis.X]", "[axis.X]\nkopf.achs_nr = 65536"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vorsteuerung = 'VELL'"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vorsteuerung = 0x400"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vorsteuerung = '0x404'"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vorsteuerung = -1"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vs_a_nenner = 'none'"),
    ("[axis.X]", "[axis.X]\nvorsteuer.vs_a_nenner = 1.5"),
    ("[axis.X]", "[axis.X]\ngetriebe = [{ dynamik.vb_max = 0 }]"),
    ("[axis.X]", "[axis.X]\nkenngr.antr_typ = 9"),
    ("[axis.X]", "[axis.X-1]"),
    ("[axis.X]", "[axis.X]\nspindle.deceleration = 0"),
    ("[axis.X]", "[axis.X]\nspindle.window = -1.0"),
    ("[axis.X]", "[axis.X]\nspindle.takeover_window = 180001"),
    ("[axis.X]", "[axis.X]\nspindle.mode_timeout = '0s'"),
    ("[axis.X]", "[axis.X]\nprocess_data.objects = ['6040h']"),
    ("[axis.X]", "[axis.X]\ndrive_settings = ['S-0-0032=4']"),
    (".v_add_max_fact = 1\n", ".v_add_max_fact = 2001\n"),
    ("mode = 'DIRECT'", "mode = 'DIRECTLY'"),
    ("mode = 'DIRECT'", "mode = 4"),
    ("mode = 'DIRECT'", "mode = 'INDIRECT', osc_damping = 1"),
    (
        "'DIRECT', weight_fact_num = 1, filter = [{ order = 1",
        "'INDIRECT', osc_damping = 0.5, filter = [{ order = 1, damping = 1",
    ),
    ("weight_fact_num = 1", "weight_fact_num = 0"),
    ("order = 1", "order = 4"),
    ("order = 1", "ordr = 1"),
    ("fg_f0 = 53", "fg_f0 = 501.0"),
    ("fg_f0 = 53", "fg_f0 = '53'"),
    ("}] }]", "}, { type = 'ALLPASS', fg_f0 = 0, q_factor = 2 }] }]"),
    ("}] }]", "}] }, {}, {}, { mode = 0 }]"),
];

#[test]
fn it_refuses_what_check_refuses() {
    let validator = validator();
    for (from, to) in REFUSED {
        let set = changed(from, to);
        assert!(checked(&set).has_errors(), "{to}");
        assert_ne!(mistakes(&validator, &set), [""; 0], "{to}");
    }
}

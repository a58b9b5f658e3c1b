//! The library as a page calls it: files in memory, data and files out.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use commands::files::Files;
use commands::stages::{self, Number, Written};
use commands::{check, trace, verify};
use generator::blocks;
use generator::config::{ListOptions, Load};
use generator::pipeline::{self, RefusedAxis, Set, Shown};
use generator::target::TARGETS;
use golden::engine::ENGINES;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

const LIST: &str = include_str!("../../../examples/rack-and-pinion.lis");
const SET: &str = "cycle_time = \"1ms\" # of the drive\n[axis.X]\nkopf.achs_nr = 1\ngetriebe = [{ dynamik.vb_max = 400000 }]\n\
    [axis.X.lr_param.improved_position_control]\nenable = \"DRYRUN\"\nv_add_max_fact = 100\n\
    [[axis.X.lr_param.improved_position_control.stage]]\nmode = \"DIRECT\" # measured\nweight_fact_num = 80\nweight_fact_denom = 100\n\
    filter = [{ order = 1, fg_f0 = 36.0, q_factor = 4.0 }]\n";

/// A file in memory, and what was read from it.
struct Read {
    path: PathBuf,
    files: Files,
    options: ListOptions,
    set: Set,
    warnings: usize,
}

impl Read {
    fn of(name: &str, text: &str, cycle_time: Option<&str>) -> Self {
        let (path, files) = (PathBuf::from(name), Files(BTreeMap::from([(name.into(), text.as_bytes().to_vec())])));
        let options = ListOptions { cycle_time: cycle_time.map(str::to_owned), ..ListOptions::default() };
        let load = |path: &Path| files.load(path);
        let (set, report) = pipeline::read_with(&path, &options, &load);
        let set = set.unwrap_or_else(|| panic!("{report}"));
        Self { path, files, options, set, warnings: report.warnings() }
    }

    /// The text of the file with another number of a stage.
    fn written(&self, stage: usize, number: Number, value: f64) -> Result<String, String> {
        let load = |path: &Path| self.files.load(path);
        let source = (self.path.as_path(), &self.options, &load as Load<'_>);
        let written = stages::written(source, &self.set.axes[0], (stage, number, value));
        let text = |written: Written| String::from_utf8(written.files.0[&self.path].clone()).unwrap();
        written.map(text).map_err(|report| report.to_string())
    }
}

/// The lines of two texts that differ.
fn changes<'t>(before: &'t str, after: &'t str) -> Vec<[&'t str; 2]> {
    assert_eq!(before.lines().count(), after.lines().count());
    before.lines().zip(after.lines()).filter(|(before, after)| before != after).map(|(b, a)| [b, a]).collect()
}

#[test]
fn verdicts_are_data() {
    let read = Read::of("x.toml", SET, None);
    let checked = serde_json::to_value(check::check(&read.set, read.warnings, false)).unwrap();
    let axis = &checked["axes"][0];
    let of = |keys: &[&str]| keys.iter().map(|key| axis[key].clone()).collect::<Value>();
    let head = of(&["axis", "blocks", "real", "cycle_time_us", "reserve", "assumed", "proven"]);
    assert_eq!(head, json!(["X", ["ipc"], "f64", 1000.0, "calm", [], []]));
    let stage = &axis["stages"][0];
    let active = &stage["active"];
    assert_eq!([&stage["stage"], &stage["mode"]], [&json!(0), &json!("DIRECT")]);
    assert_eq!(axis["stages"][1], json!({ "stage": 1, "mode": "NOT_ACTIVE", "active": null }));
    for (key, value) in [
        ("source", json!("v_motor")),
        ("f0", json!(36.0)),
        ("q_factor", json!(4.0)),
        ("damping", Value::Null),
        ("weight", json!(0.8)),
        ("asked_weight", json!(0.8)),
        ("reserve", json!("calm")),
    ] {
        assert_eq!(active[key], value, "{key}");
    }
    assert!(active["reserves"][0]["calm_up_to"].as_f64().unwrap() > 0.8, "{active}");
    assert!(axis["lines"].to_string().contains(active["verdict"].as_str().unwrap()), "{axis}");
}

#[test]
fn a_number_of_a_stage_is_written_into_the_users_own_text() {
    let read = Read::of("x.toml", SET, None);
    let filter = |f0: &str| format!("filter = [{{ order = 1, fg_f0 = {f0}, q_factor = 4.0 }}]");
    let new = read.written(0, Number::F0, 37.0).unwrap();
    assert_eq!(changes(SET, &new), [[filter("36.0").as_str(), filter("37.0").as_str()]]);
    let new = read.written(0, Number::Weight, 0.81).unwrap();
    assert_eq!(changes(SET, &new), [["weight_fact_num = 80", "weight_fact_num = 81"]]);
    let new = read.written(0, Number::Weight, 0.815).unwrap();
    let lines =
        [["weight_fact_num = 80", "weight_fact_num = 815"], ["weight_fact_denom = 100", "weight_fact_denom = 1000"]];
    assert_eq!(changes(SET, &new), lines);

    let read = Read::of("x.lis", LIST, Some("1ms"));
    let old = "lr_param.improved_position_control.stage[1].filter.damping    0.8";
    let changed = read.written(1, Number::Damping, 0.7).unwrap();
    assert_eq!(changes(LIST, &changed), [[old, &old.replace("0.8", "0.7")]], "by its predecessor");

    for (stage, number, value, found) in [
        (0, Number::F0, 5e3, "P-AXIS-00751"),
        (0, Number::F0, 0.0, "P-AXIS-00751"),
        (0, Number::Damping, 0.5, "stage 0"),
        (2, Number::F0, 5.0, "stage 2"),
    ] {
        let refused = read.written(stage, number, value).unwrap_err();
        assert!(refused.contains(found), "{refused}");
    }
}

/// In a set that names a list, the number stands in the list.
#[test]
fn a_number_of_a_list_is_written_into_the_list() {
    let set = "cycle_time = \"1ms\"\n[axis.X]\nlist = \"x.lis\"\n";
    let [set_file, list_file] = ["x.toml", "x.lis"].map(PathBuf::from);
    let files = [(set_file.clone(), set.as_bytes().to_vec()), (list_file.clone(), LIST.as_bytes().to_vec())];
    let files = Files(BTreeMap::from(files));
    let load = |path: &Path| files.load(path);
    let options = ListOptions::default();
    let read = pipeline::read_with(&set_file, &options, &load).0.unwrap();
    let written = stages::written((&set_file, &options, &load), &read.axes[0], (0, Number::QFactor, 9.0)).unwrap();
    let Written { files, shown, report } = written;
    assert!(shown.is_allowed && !report.has_errors());
    assert_eq!(files.0.keys().collect::<Vec<_>>(), [&list_file]);
    let list = String::from_utf8(files.0[&list_file].clone()).unwrap();
    let changed = changes(LIST, &list);
    assert!(changed.len() == 1 && changed[0][1].ends_with("q_factor   9"), "{changed:?}");
}

/// Both axes of a set with a mistake in one: the good one, and what is wrong with the other. An unstable loop alone is shown.
#[test]
fn a_set_with_errors_is_shown_as_far_as_it_can_be_read() {
    let show = |text: &str| {
        let files = Files(BTreeMap::from([("x.toml".into(), text.as_bytes().to_vec())]));
        let load = |path: &Path| files.load(path);
        let (shown, report) = pipeline::read_to_show(Path::new("x.toml"), &ListOptions::default(), &load);
        (shown.unwrap(), report)
    };
    let names = |shown: &Shown| shown.set.axes.iter().map(|of| of.axis.name.clone()).collect::<Vec<_>>();
    let bad = SET.split_once("[axis.X]").unwrap().1.replace("axis.X", "axis.Y").replace("achs_nr = 1", "achs_nr = 2");
    let (shown, _) = show(&format!("{SET}[axis.Y]{}", bad.replace("36.0", "-36.0")));
    assert_eq!((names(&shown), shown.is_allowed, shown.is_whole), (vec!["X".to_owned()], false, false));
    let [RefusedAxis { axis, found }] = &shown.refused[..] else { panic!("{:?}", shown.refused) };
    assert!(axis == "Y" && found.contains("-36"), "{axis}: {found}");

    let unstable = SET.replace("DRYRUN", "ON").replace("36.0", "300.0").replace("num = 80", "num = 700");
    let (shown, report) = show(&unstable);
    assert!(report.has_errors(), "{report}");
    assert_eq!((names(&shown), shown.is_allowed, shown.is_whole), (vec!["X".to_owned()], false, true));
}

#[test]
fn every_line_of_a_coefficient_leads_to_a_parameter_and_back() {
    let read = Read::of("x.lis", LIST, Some("1ms"));
    let axis = &read.set.axes[0];
    let blocks = blocks::blocks(axis).unwrap();
    let load = |path: &Path| read.files.load(path);
    let trace = trace::trace((&read.path, &read.options, &load), axis, &blocks, &TARGETS).unwrap();
    for (position, parameter) in trace.parameters.iter().enumerate() {
        for coefficient in &parameter.coefficients {
            assert!(trace.coefficients[*coefficient].parameters.contains(&position), "{}", parameter.path);
        }
    }
    let of = |end: &str| trace.parameters.iter().find(|of| of.path.ends_with(end)).unwrap();
    let names = |end: &str| -> Vec<&str> {
        of(end).coefficients.iter().map(|at| trace.coefficients[*at].path.as_str()).collect()
    };
    assert_eq!(names("stage[0].weight_fact_num"), ["stage[0].gain", "sum_limit"]);
    assert_eq!(names("v_add_max_fact"), ["limit", "lower_limit"]);
    let lines = &trace.coefficients[of("stage[0].weight_fact_num").coefficients[0]].lines;
    assert_eq!(lines.len(), TARGETS.len(), "{lines:?}");
    // Its declaration and its use, but not the comments that contain the word.
    let rest = trace.coefficients.iter().find(|of| of.path == "rest").unwrap();
    for target in ["c", "rust", "twincat"] {
        let of_target: Vec<_> = rest.lines.iter().filter(|of| of.target == target).collect();
        assert!(of_target.len() == 1 && of_target[0].lines.len() == 2, "{of_target:?}");
    }
}

/// In every target, also where two functions of C share a coefficient, and where it is an enumerator.
#[test]
fn every_coefficient_has_lines() {
    let set = include_str!("../../../golden/cases/spindle-in-a-canopen-drive/set.toml");
    let read = Read::of("set.toml", set, None);
    let axis = &read.set.axes[0];
    let blocks = blocks::blocks(axis).unwrap();
    let load = |path: &Path| read.files.load(path);
    for target in TARGETS {
        let trace = trace::trace((&read.path, &read.options, &load), axis, &blocks, &[target]).unwrap();
        let without: Vec<_> = trace.coefficients.iter().filter(|of| of.lines.is_empty()).map(|of| &of.path).collect();
        assert!(without.is_empty() && trace.coefficients.len() > 30, "{}: {without:?}", target.name);
    }
}

#[test]
fn engines_without_a_compiler_agree() {
    let read = Read::of("x.toml", SET, None);
    let axis = &read.set.axes[0];
    let engines: Vec<_> = ENGINES.into_iter().filter(|engine| !engine.is_compiled()).collect();
    let mut verification = verify::Verification::new(&engines, &|_, _| None);
    let mut rows = Vec::new();
    for block in blocks::blocks(axis).unwrap() {
        let inputs = golden::exercise::inputs(axis, &block, 500);
        verification
            .block(axis, &block, &inputs, |row| {
                rows.push(row);
                Ok::<_, ()>(())
            })
            .unwrap();
    }
    assert_eq!(rows.len(), 6);
    assert!(rows.iter().all(|row| row.failure().is_none() && row.digest == rows[0].digest), "{rows:?}");
}

#[test]
fn signals_are_explained_by_their_emitted_names() {
    for name in ["tuning_weight0", "stage0_filter1_f0", "params_set_id", "active_set", "wrong_filter"] {
        let text = commands::explain::text(Some(name)).unwrap();
        assert!(text.contains(&format!("put `{name}` of the block ")), "{text}");
    }
}

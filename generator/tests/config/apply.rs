//! Stages that are written into a set or a list, to the letter: what stands around them stays, byte for byte.

use generator::apply::{self, Applied};
use generator::axis::{DirectSource, Enable, Filter, Mode, Prototype, Stage};
use generator::config::{ListOptions, Unreadable};
use generator::diagnostics::Report;
use generator::pipeline::read_with;
use std::path::Path;

fn bandpass(f0: f64, q_factor: f64) -> Filter {
    Filter::Bandpass { prototype: Prototype::CritDamping, order: 1, f0, q_factor }
}

/// DIRECT at 53 Hz, with an all-pass; INDIRECT at 11 Hz.
fn pair() -> [Stage; 2] {
    let direct = Mode::Direct { source: DirectSource::Motor };
    let [weight_fact_num, weight_fact_denom] = [514, 1000];
    let allpass = Filter::Allpass { f0: 30.25, q_factor: 2.0 };
    let first = Stage { mode: direct, weight_fact_num, weight_fact_denom, filter: [bandpass(53.0, 8.5), allpass] };
    let mode = Mode::Indirect { osc_damping: 0.75 };
    [first, Stage { mode, weight_fact_num: 1900, weight_fact_denom, filter: [bandpass(11.0, 2.0), Filter::NoFilter] }]
}

fn applied(name: &str, text: &[u8], stages: &[Stage]) -> (Option<Applied>, Report) {
    let options = match name.ends_with(".toml") {
        true => ListOptions::default(),
        false => ListOptions { cycle_time: Some("1ms".to_owned()), ..ListOptions::default() },
    };
    let load = |path: &Path| match path.to_str() {
        Some(of) if of == name => Ok(text.to_vec()),
        Some("other.lis") => Ok(LIST.as_bytes().to_vec()),
        _ => Err(Unreadable::System("there is no such file".to_owned())),
    };
    let (applied, report) = apply::stages(Path::new(name), &options, "x", stages, &load);
    if let Some(applied) = &applied {
        let after = |_: &Path| -> Result<Vec<u8>, Unreadable> { Ok(applied.after.clone()) };
        let (set, report) = read_with(Path::new(name), &options, &after);
        assert!(!report.has_errors(), "{report:?}");
        let axis = set.unwrap().axes.into_iter().find(|of| of.axis.name == "x").unwrap().axis;
        assert_eq!(axis.ipc.enable, Enable::DryRun);
        assert_eq!(axis.ipc.stage.into_iter().flatten().collect::<Vec<_>>(), stages);
        assert_eq!(applied.before, text);
    }
    (applied, report)
}

fn changed(name: &str, text: &str, stages: &[Stage]) -> String {
    let (applied, report) = applied(name, text.as_bytes(), stages);
    let applied = applied.unwrap_or_else(|| panic!("{text}\n{report:?}"));
    String::from_utf8(applied.after).unwrap()
}

const TOP: &str = "# the set\ncycle_time = \"1ms\" # of the task\n\n[axis.x]\nkopf.achs_nr=1\nkenngr.achs_typ  = \"ACHSTYP_TRANSLATOR\"\n\
    getriebe = [{ dynamik.vb_max = 530000 }]  # um/s\n";
const BEHIND: &str = "\n# another axis\n[axis.y]\nkopf.achs_nr = 2\ngetriebe = [{ dynamik.vb_max = 4000 }]\n\n\
    [axis.y.lr_param.improved_position_control]\nenable = \"OFF\"\n";

const TABLES: &str = include_str!("applied/tables.toml");

/// The same as an array.
const ARRAY: &str = "[
    { mode = \"DIRECT\", weight_fact_num = 514, weight_fact_denom = 1000, \
    filter = [{ order = 1, fg_f0 = 53.0, q_factor = 8.5 }, { type = \"ALLPASS\", fg_f0 = 30.25, q_factor = 2.0 }] },
    { mode = \"INDIRECT\", osc_damping = 0.75, weight_fact_num = 1900, weight_fact_denom = 1000, \
    filter = [{ order = 1, fg_f0 = 11.0, q_factor = 2.0 }] },
]";

#[test]
fn a_set_in_every_form() {
    let head = "\n# what damps\n[axis.x.lr_param.improved_position_control]\n";
    let old = "[[axis.x.lr_param.improved_position_control.stage]] # first\nmode = \"DIRECT\" # direct\nfilter = [\n    { order = 2, \
        fg_f0 = 50.0, q_factor = 5.0 }, # the teeth\n]\n";
    let other = "# the bed\n[[axis.x.lr_param.improved_position_control.stage]]\nmode = \"NOT_ACTIVE\"\n\
        [[axis.x.lr_param.improved_position_control.stage.filter]]\norder = 1 # last\n";
    let forms: [(&str, String, String); 9] = [
        (
            "tables",
            format!("{head}enable = \"ON\" # at start\nv_add_max_fact = 1000\n\n{old}\n{other}"),
            format!("{head}enable = \"DRYRUN\" # at start\nv_add_max_fact = 1000\n\n{TABLES}\n# the bed\n"),
        ),
        (
            "no stage",
            format!("{head}enable = 'ON' # at start\nv_add_max_fact = 1000 # 0.1 %\n"),
            format!("{head}enable = \"DRYRUN\" # at start\nv_add_max_fact = 1000 # 0.1 %\n\n{TABLES}"),
        ),
        (
            "no mode",
            format!("{head}v_add_max_fact = 1000\n"),
            format!("{head}v_add_max_fact = 1000\nenable = \"DRYRUN\"\n\n{TABLES}"),
        ),
        (
            "no table of its own",
            format!("\n{old}"),
            format!("\n[axis.x.lr_param.improved_position_control]\nenable = \"DRYRUN\"\n\n{TABLES}"),
        ),
        (
            "an array",
            format!(
                "{head}stage = [{{ mode = \"DIRECT\", filter = [{{ order = 1, fg_f0 = 9, q_factor = 1 }}] }}] # one\nenable = \"DRYRUN\"\n"
            ),
            format!("{head}stage = {ARRAY} # one\nenable = \"DRYRUN\"\n"),
        ),
        (
            "keys with points",
            "lr_param.improved_position_control.enable = \"OFF\"\nfade = \"200ms\"\n".to_owned(),
            format!(
                "lr_param.improved_position_control.enable = \"DRYRUN\"\nlr_param.improved_position_control.stage = {ARRAY}\nfade = \"200ms\"\n"
            ),
        ),
        (
            "one value",
            "lr_param.improved_position_control = { v_add_max_fact = 10 } # all\n".to_owned(),
            format!(
                "lr_param.improved_position_control = {{ v_add_max_fact = 10, enable = \"DRYRUN\", stage = {ARRAY} }} # all\n"
            ),
        ),
        ("nothing", String::new(), format!("{head}enable = \"DRYRUN\"\n\n{TABLES}").replace("# what damps\n", "")),
        (
            "the same again",
            format!("{head}enable = \"DRYRUN\"\n\n{TABLES}"),
            format!("{head}enable = \"DRYRUN\"\n\n{TABLES}"),
        ),
    ];
    for (what, before, after) in forms {
        let [before, after] = [before, after].map(|text| format!("{TOP}{text}{BEHIND}"));
        assert_eq!(changed("x.toml", &before, &pair()), after, "{what}");
        let [before, after] = [before, after].map(|text| text.replace('\n', "\r\n"));
        assert_eq!(changed("x.toml", &before, &pair()), after, "{what}, CR LF");
    }
    // A file that ends without a line end.
    let open = format!("{TOP}{head}enable = \"ON\"");
    assert_eq!(
        changed("x.toml", &open, &pair()),
        format!("{TOP}{head}enable = \"DRYRUN\"\n\n{TABLES}"),
        "without a line end"
    );
    let (applied, _) = applied("x.toml", format!("{TOP}{BEHIND}").as_bytes(), &pair());
    let changes = applied.unwrap().changes;
    assert!(changes.iter().any(|line| line.contains("axis x: ") && line.contains("53")), "{changes:?}");
}

const LIST: &str = include_str!("applied/before.lis");

#[test]
fn a_list() {
    let expected = include_str!("applied/after.lis");
    assert_eq!(changed("x.lis", LIST, &pair()), expected);
    assert_eq!(changed("x.lis", expected, &pair()), expected, "the same again");
    let crlf = |text: &str| text.replace('\n', "\r\n");
    assert_eq!(changed("x.lis", &crlf(LIST), &pair()), crlf(expected));
    // What is no UTF-8 stays as it is, in a comment.
    let latin = |text: &str| [b"# Achse f\xfcr X\n", text.as_bytes()].concat();
    assert_eq!(applied("x.lis", &latin(LIST), &pair()).0.unwrap().after, latin(expected));
    // A list of a controller that knows nothing of it so far.
    let bare = "kopf.achs_nr 1\nkenngr.achs_typ ACHSTYP_TRANSLATOR\ngetriebe[0].dynamik.vb_max 530000\n# Ende:\nEnde\n";
    let found = changed("x.lis", bare, &pair()[1..]);
    assert_eq!(
        found,
        bare.replace(
            "\nEnde\n",
            "\nlr_param.improved_position_control.enable DRYRUN\n\
             lr_param.improved_position_control.stage[0].mode INDIRECT\n\
             lr_param.improved_position_control.stage[0].osc_damping 0.75\n\
             lr_param.improved_position_control.stage[0].weight_fact_num 1900\n\
             lr_param.improved_position_control.stage[0].weight_fact_denom 1000\n\
             lr_param.improved_position_control.stage[0].filter[0].order 1\n\
             lr_param.improved_position_control.stage[0].filter[0].fg_f0 11\n\
             lr_param.improved_position_control.stage[0].filter[0].q_factor 2\nEnde\n"
        )
    );
}

#[test]
fn a_list_in_a_project() {
    let around = |list: &str| {
        format!("<?xml version=\"1.0\"?>\n<a><ItemName>x</ItemName><AchsMds><![CDATA[{list}]]></AchsMds>\n</a>\n")
    };
    let found = changed("x.xti", &around(LIST), &pair()[..1]);
    let expected = changed("x.lis", LIST, &pair()[..1]);
    assert_eq!(found, around(&expected));
}

#[test]
fn what_is_not_written() {
    let refused = |text: &str| {
        let (applied, report) = applied("x.toml", text.as_bytes(), &pair());
        assert!(applied.is_none(), "{text}");
        report.diagnostics[0].clone()
    };
    let said = refused(&format!("{TOP}list = \"other.lis\"\n{BEHIND}"));
    assert_eq!((said.code, said.place.line), ("AX525", 8));
    assert!(said.instead.as_ref().unwrap().contains("axgen tune other.lis --cycle-time TIME --apply"), "{said:?}");
    let stage = "[axis.x.lr_param.improved_position_control]\nstage = 3\n";
    assert_ne!(refused(&format!("{TOP}{stage}{BEHIND}")).code, "AX525", "a mistake of the file is said as such");
    let inline = "cycle_time = \"1ms\"\naxis.x = { kopf.achs_nr = 1, kenngr.achs_typ = \"ACHSTYP_TRANSLATOR\", \
        getriebe = [{ dynamik.vb_max = 530000 }] }\n";
    let said = refused(inline);
    assert!(said.code == "AX525" && said.found == "axis.x is not a table", "{said:?}");
}

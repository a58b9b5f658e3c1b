//! Random lists: both generations, comments in latin-1, mixed line ends, foreign parameters, odd blanks and numbers.

use super::{IPC, exported, imported, meaning, round_trip};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::cell::Cell;
use std::collections::BTreeSet;

/// Known parameters, their values as lists spell them; a second index where there is one.
fn known() -> impl Strategy<Value = (String, String)> {
    let blank_index = prop::sample::select(&["[0]", "[]", "[00]"][..]);
    let stage = prop_oneof![blank_index.prop_map(str::to_owned), (1..3u32).prop_map(|i| format!("[{i}]"))];
    let filter = prop::sample::select(&[".filter", ".filter[]", ".filter[0]", ".filter[1]"][..]);
    let word = |words: &'static [&'static str]| prop::sample::select(words).prop_map(str::to_owned).boxed();
    let integer = prop_oneof![
        (0..5u32).prop_map(|n| n.to_string()),
        (1..u32::MAX).prop_map(|n| format!("0x{n:X}")),
        (1..9u32).prop_map(|n| format!("0X{n:04x}")),
        (0..2000u32).prop_map(|n| format!("+{n:06}")),
    ];
    let real = prop_oneof![
        (1..500u32).prop_map(|n| n.to_string()),
        (0.0..600.0f64).prop_map(|x| x.to_string()),
        (0.0..600.0f64).prop_map(|x| format!("{x:E}")),
        any::<f64>().prop_filter("finite", |x| x.is_finite()).prop_map(|x| format!("{x:e}")),
        word(&[".5", "5.", "-1", "0x1F", "00.70", "1e+1", "99999999999999999999"]),
    ];
    let modes = &["DIRECT", "indirect", "SET_POINT", "NOT_ACTIVE", "0", "1", "2", "0x3", "02"];
    let types = &["NO_FILTER", "BANDPASS", "ALLPASS", "bandpass"];
    prop_oneof![
        word(&["FALSE", "TRUE", "0", "1", "ON", "off", "DRYRUN"]).prop_map(|value| ("ipc.enable".to_owned(), value)),
        integer.clone().prop_map(|value| ("ipc.v_add_max_fact".to_owned(), value)),
        (0..16u32, integer.clone()).prop_map(|(i, value)| (format!("getriebe[{i}].dynamik.vb_max"), value)),
        integer.clone().prop_map(|value| ("kopf.achs_nr".to_owned(), value)),
        word(&["1", "2", "0x4", "ACHSTYP_ROTATOR"]).prop_map(|value| ("kenngr.achs_typ".to_owned(), value)),
        (stage.clone(), word(modes)).prop_map(|(i, value)| (format!("ipc.stage{i}.mode"), value)),
        (stage.clone(), word(&["weight_fact_num", "weight_fact_denom"]), integer.clone())
            .prop_map(|(i, end, value)| (format!("ipc.stage{i}.{end}"), value)),
        (stage.clone(), word(&[".osc_damping", "osc_damping", ".filter.damping", ".filter[0].damping"]), real.clone())
            .prop_map(|(i, end, value)| (format!("ipc.stage{i}{end}"), value)),
        (stage.clone(), filter.clone(), word(types)).prop_map(|(i, k, value)| (format!("ipc.stage{i}{k}.type"), value)),
        (stage.clone(), filter.clone(), word(&["BESSEL", "BUTTERWORTH", "crit_damping"]))
            .prop_map(|(i, k, value)| (format!("ipc.stage{i}{k}.prototype"), value)),
        (stage.clone(), filter.clone(), integer).prop_map(|(i, k, value)| (format!("ipc.stage{i}{k}.order"), value)),
        (stage, filter, word(&["fg_f0", "q_factor"]), real)
            .prop_map(|(i, k, end, value)| (format!("ipc.stage{i}{k}.{end}"), value)),
    ]
}

/// Any bytes that a comment may have; most are letters.
fn comment() -> impl Strategy<Value = Vec<u8>> {
    let byte = prop_oneof![
        8 => prop::sample::select(&b"abc XYZ-.:[]"[..]),
        2 => prop::sample::select(&b"\"'\\#()=\t"[..]),
        1 => any::<u8>().prop_filter("a line end", |byte| *byte != b'\n' && *byte != b'\r'),
    ];
    (prop::sample::select(&["#", "(", "# Axgen: "][..]), prop::collection::vec(byte, 0..40))
        .prop_map(|(sign, bytes)| [sign.as_bytes(), &bytes].concat())
}

fn blanks() -> impl Strategy<Value = &'static str> {
    prop::sample::select(&["", "", " ", "\t", "   ", " \t "][..])
}

/// A line: what it says, as the path without what does not tell parameters apart; and its bytes.
fn line() -> impl Strategy<Value = (Option<String>, Vec<u8>)> {
    let foreign = prop::sample::select(
        &[
            "kenngr.swe_pos 1500",
            "antr.x[1][2] MVS_SVS M 3",
            "list.without_value",
            "a.b = 3",
            "a.\"b 1",
            "lr_param.x -1e9",
        ][..],
    )
    .prop_filter("a path", |text| !text.contains('"'))
    .prop_map(|text| (None, text.to_owned()));
    let value = known().prop_map(|(path, value)| {
        let same = path.replace("[00]", "[0]").replace("[]", "[0]").replace(".filter.", ".filter[0].");
        let same = same.replace("]osc", "].osc");
        (Some(same), format!("{path}\u{0}{value}"))
    });
    let statement = (prop_oneof![3 => value, 1 => foreign], blanks(), blanks(), blanks(), prop::option::of(comment()))
        .prop_map(|((path, text), indent, gap, space, comment)| {
            let gap = if gap.is_empty() { " " } else { gap };
            let text = text.replace('\u{0}', gap).replace("ipc.", IPC);
            let space = if comment.is_some() && space.is_empty() { " " } else { space };
            (path, [indent.as_bytes(), text.as_bytes(), space.as_bytes(), &comment.unwrap_or_default()].concat())
        });
    let remark = (blanks(), prop::option::of(comment()))
        .prop_map(|(indent, comment)| (None, [indent.as_bytes(), &comment.unwrap_or_default()].concat()));
    prop_oneof![3 => statement, 1 => remark]
}

fn list() -> impl Strategy<Value = Vec<u8>> {
    let end = prop::sample::select(&["\n", "\r\n"][..]);
    let uniform = prop::sample::select(&[None, Some("\n"), Some("\r\n")][..]);
    let lines = prop::collection::vec((line(), end), 0..40);
    (lines, uniform, any::<bool>(), any::<bool>()).prop_map(|(lines, uniform, mark, ends)| {
        let mut list = if mark { b"\xEF\xBB\xBF".to_vec() } else { Vec::new() };
        let mut given = BTreeSet::new();
        // Of a list without any parameter of an axis only `import` makes something.
        list.extend(b"kenngr.swe_neg 0\n");
        for ((path, bytes), end) in lines {
            // A parameter that is given twice is an error.
            if path.is_some_and(|path| !given.insert(path)) {
                continue;
            }
            list.extend(bytes);
            list.extend(uniform.unwrap_or(end).as_bytes());
        }
        if !ends && list.ends_with(b"\n") {
            list.pop();
        }
        list
    })
}

#[test]
#[expect(clippy::print_stdout, reason = "how much of it the meaning was compared for")]
fn a_thousand_random_lists_come_back_to_the_byte_and_mean_the_same() {
    let mut runner = TestRunner::new(Config { cases: 1000, failure_persistence: None, ..Config::default() });
    let valid = Cell::new(0);
    let result = runner.run(&list(), |list| {
        let set = round_trip(&list);
        let (of_set, of_list) = (meaning("set.toml", set.as_bytes()), meaning("x.lis", &list));
        valid.set(valid.get() + usize::from(of_list.is_ok()));
        prop_assert_eq!(codes(&of_set), codes(&of_list), "{}", set);
        Ok(())
    });
    assert!(result.is_ok(), "{result:?}");
    println!("{} of 1000 lists are valid axes", valid.get());
    assert!(valid.get() >= 100);
}

/// What is said, without the paths: in a set some are spelled otherwise.
fn codes(meaning: &Result<String, Vec<(&'static str, String)>>) -> Result<String, Vec<&'static str>> {
    let codes = |said: &Vec<(&'static str, String)>| {
        let mut codes: Vec<_> = said.iter().map(|(code, _)| *code).filter(|code| *code != "AX108").collect();
        codes.sort_unstable();
        codes
    };
    meaning.clone().map_err(|said| codes(&said))
}

#[test]
fn an_export_is_imported_and_exported_to_the_same() {
    let mut runner = TestRunner::new(Config { cases: 100, failure_persistence: None, ..Config::default() });
    let result = runner.run(&list(), |list| {
        let set = imported(&list).replace("[axis.X]\n", "[axis.X]\nkenngr.gantry_ax_nr = 3\ngear = 2\n");
        let once = exported(&set);
        prop_assert_eq!(exported(&imported(&once)), once);
        Ok(())
    });
    assert!(result.is_ok(), "{result:?}");
}

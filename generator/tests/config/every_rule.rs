//! Every end of a range, spelling, word and contradiction that the tests of single rules leave out, and what is said.

use super::{IPC, direct, indirect, read_list, said};

fn canonical(list: &str) -> String {
    let (set, report) = read_list(list.replace("ipc.", IPC));
    let set = set.unwrap_or_else(|| panic!("{list}\n{report}"));
    set.axes[0].axis.canonical.replace(IPC, "ipc.")
}

/// Path, id, range; the ends inside; just outside.
const RANGES: &str = include_str!("ranges.txt");

#[test]
fn both_ends_of_every_range_of_a_list() {
    for line in RANGES.trim_ascii().lines() {
        let [path, id, allowed, inside, outside] = line.split(" | ").collect::<Vec<_>>()[..] else { panic!("{line}") };
        let damping = if path.ends_with("damping") { "" } else { "\nipc.stage[0].osc_damping 0.5" };
        let said = |value: &str| said(&indirect(&format!("{path} {value}{damping}")));
        for value in inside.split(' ') {
            // Legal, and warned of: the resonance of the simulated oscillation, the cap of a weight, an axis of 1 um/s or 2 km/s.
            let expected = match (path, value) {
                (_, "1e-15") => "warning[AX436]",
                ("ipc.stage[0].weight_fact_num", "0xFFFFFFFE") => "warning[AX437]",
                ("getriebe[0].dynamik.vb_max", _) => "warning[AX438]",
                _ => "",
            };
            assert!(said(value).contains(expected) && said(value).is_empty() == expected.is_empty(), "{path} {value}");
        }
        let column = path.replace("ipc.", IPC).len() + 2;
        for value in outside.split(' ') {
            let found = format!("x.lis:1:{column}: error[AX203]: `{path}` (P-AXIS-{id}) is {value}");
            assert_eq!(said(value), format!("{found}\n    allowed: {allowed}"));
        }
    }
}

/// Without index, with empty brackets, with 0: the same value, and given twice next to each other.
#[test]
fn every_spelling_of_a_path_is_one_parameter() {
    let new = indirect(
        "ipc.stage[0].osc_damping 0.5\nipc.stage[0].weight_fact_num 2\nipc.stage[0].weight_fact_denom 3\n\
         ipc.stage[0].filter.type BANDPASS\nipc.stage[0].filter.prototype BESSEL\ngetriebe[0].dynamik.vb_max 5000",
    );
    let old = indirect("ipc.stage[0].filter.damping 0.5");
    let lines = new.lines().enumerate().map(|line| (&new, line)).chain([(&old, (0, old.lines().next().unwrap()))]);
    let mut spellings = 0;
    for (list, (n, line)) in lines {
        let forms = [("[0]", "[]"), (".filter.", ".filter[0]."), (".filter.", ".filter[].")];
        for (plain, form) in forms.into_iter().filter(|(plain, _)| line.contains(plain)) {
            let other = line.replacen(plain, form, 1);
            let path = other.split(' ').next().unwrap();
            let alone = list.replace(line, &other);
            assert_eq!((said(&alone), canonical(&alone)), (String::new(), canonical(list)), "{path}");
            let [first, second] = [n + 1, list.lines().count() + 1];
            let twice = format!("x.lis:{second}:1: error[AX107]: `{path}` is given twice, first in line {first}");
            assert_eq!(said(&format!("{list}\n{other}")), twice + "\n    write instead: one of the two lines");
            spellings += 1;
        }
    }
    // Each of ten parameters with an index, and five of a filter and its damping in two forms more.
    assert_eq!(spellings, 11 + 2 * 6);
}

/// Path, word; its spellings.
const WORDS: &str = include_str!("words.txt");

/// Defaults are not in the canonical form.
const DEFAULTS: [&str; 4] = [
    "ipc.enable OFF",
    "ipc.stage[0].mode NOT_ACTIVE",
    "ipc.stage[0].filter[1].type NO_FILTER",
    "ipc.stage[0].filter[0].prototype CRIT_DAMPING",
];

#[test]
fn every_word_and_number_of_a_word() {
    let rest = "ipc.stage[0].osc_damping 0.5\nipc.stage[0].filter[1].prototype BESSEL\nipc.stage[0].filter[1].order 1\n\
                ipc.stage[0].filter[1].fg_f0 15\nipc.stage[0].filter[1].q_factor 2";
    for line in WORDS.trim_ascii().lines() {
        let (meant, spellings) = line.split_once(" | ").unwrap();
        let path = meant.split(' ').next().unwrap();
        for spelling in spellings.split(' ') {
            let canonical = canonical(&direct(&format!("{path} {spelling}\n{rest}")));
            let of_path = canonical.lines().find(|line| line.split(' ').next() == Some(path));
            assert_eq!(of_path, Some(meant).filter(|meant| !DEFAULTS.contains(meant)), "{spelling}\n{canonical}");
        }
    }
    for kind in ["ACHSTYP_TRANSLATOR", "1", "achstyp_rotator", "2", "ACHSTYP_SPINDEL", "0x4"] {
        assert_eq!(said(&direct(&format!("kenngr.achs_typ {kind}"))), "");
    }
}

/// Neither the place nor the advice is asserted: both are about fg_f0, and the damping is to blame.
#[test]
fn a_damping_that_rounding_takes_away() {
    let (_, report) = read_list(indirect("ipc.stage[0].osc_damping 1e-17").replace("ipc.", IPC));
    let [refusal] = &report.diagnostics[..] else { panic!("{report}") };
    let found = "stage[0].oscillation: unstable with its coefficients in double precision: a1 = -1.9952250127224505e0, a2 = 1e0";
    let allowed = "|a2| < 1 and |a1| < 1 + a2";
    assert_eq!((refusal.code, refusal.found.as_str(), refusal.allowed.as_deref()), ("AX308", found, Some(allowed)));
}

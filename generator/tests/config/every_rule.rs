//! Every end of a range, spelling, word and contradiction that the tests of single rules leave out, and what is said.

use super::{IPC, assert_transcript, direct, indirect, read_list, said, said_of_axis, said_of_set, set_point};

fn canonical(list: &str) -> String {
    let (set, report) = read_list(list.replace("ipc.", IPC));
    let set = set.unwrap_or_else(|| panic!("{list}\n{report}"));
    set.axes[0].axis.canonical.replace(IPC, "ipc.")
}

/// What is said about a set with a valid stage.
fn said_beside_a_stage(given: &str) -> String {
    said_of_axis(&format!(
        "{given}\nipc.v_add_max_fact = 1\n\
         ipc.stage = [{{ mode = 'DIRECT', filter = [{{ order = 1, fg_f0 = 53, q_factor = 10 }}] }}]"
    ))
}

/// Path, id, range; the ends inside; just outside.
const RANGES: &str = "
kopf.achs_nr | 00016 | 0 <= achs_nr <= 65535 | 0 65535 | -1 65536
kenngr.gantry_ax_nr | 00070 | 0 <= gantry_ax_nr <= 65535 | 0 | -1 65536
getriebe[0].dynamik.vb_max | 00212 | 1 <= vb_max <= 2000000000 [um/s or 0.001 deg/s] | 1 2000000000 | -1 0 2000000001
ipc.v_add_max_fact | 00757 | 0 <= v_add_max_fact <= 2000 [0.1 %] | 1 2000 | -1 2001
ipc.stage[0].weight_fact_num | 00754 | 1 <= weight_fact_num <= 4294967294 | 1 0xFFFFFFFE | -1 0 4294967295
ipc.stage[0].weight_fact_denom | 00755 | 1 <= weight_fact_denom <= 4294967294 | 1 0xFFFFFFFE | -1 0 4294967295
ipc.stage[0].osc_damping | 00850 | 0 < osc_damping < 1 | 1e-15 0.9999999999999999 | -1 -5e-324 -0 0 1 1.0000000000000002
ipc.stage[0].filter.damping | 00756 | 0 < damping < 1 | 1e-15 0.9999999999999999 | 1 1.0000000000000002
ipc.stage[0].filter.order | 00750 | 1 <= order <= 3 | 1 3 | -1 0 4
ipc.stage[0].filter.fg_f0 | 00751 | 0 < fg_f0 <= 500 [Hz] | 0.001 111 | -1 -5e-324 -0 0 500.0000000000001
ipc.stage[0].filter.q_factor | 00752 | 1 <= q_factor <= 10 | 1 10 | -1 0.9999999999999999 10.000000000000002
";

#[test]
fn both_ends_of_every_range_of_a_list() {
    for line in RANGES.trim_ascii().lines() {
        let [path, id, allowed, inside, outside] = line.split(" | ").collect::<Vec<_>>()[..] else { panic!("{line}") };
        let damping = if path.ends_with("damping") { "" } else { "\nipc.stage[0].osc_damping 0.5" };
        let said = |value: &str| said(&indirect(&format!("{path} {value}{damping}")));
        for value in inside.split(' ') {
            // Legal, and warned of: the resonance of the simulated oscillation, the cap of a weight, an axis of 1 um/s.
            let expected = match (path, value) {
                (_, "1e-15") => "warning[AX436]",
                ("ipc.stage[0].weight_fact_num", "0xFFFFFFFE") => "warning[AX437]",
                ("getriebe[0].dynamik.vb_max", "1") => "warning[AX438]",
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

#[test]
fn both_ends_of_the_keys_of_a_set() {
    assert_transcript(
        said_beside_a_stage,
        r#"
> gear = 0
> fade = "0s"

> gear = 15
> fade = "1000s"

> gear = -1
> fade = "1000.000000001s"
set.toml:3:8: error[AX203]: `gear` is -1
    allowed: 0 <= gear <= 15
set.toml:4:8: error[AX203]: `fade` is 1000.000000001s
    allowed: 0s <= fade <= 1000s

> gear = 16
> fade = "-1ns"
set.toml:4:8: error[AX205]: `fade` is `-1ns`, not a duration
    allowed: a number with a unit (s, ms, us or ns), 0s <= fade <= 1000s
set.toml:3:8: error[AX203]: `gear` is 16
    allowed: 0 <= gear <= 15

> getriebe = [{ dynamik.vb_max = 5000 }, {}, { dynamik.vb_max = 6 }, { dynamik.vb_max = 0 }]
set.toml:3:63: warning[AX403]: the gear steps 0, 2, 3 are given; step 0 is used
    write instead: the key `gear` in a set, to choose one

> gear = 1
> getriebe = [{ dynamik.vb_max = 0 }, { dynamik.vb_max = 5000 }]

> gear = 1
> getriebe = [{ dynamik.vb_max = 1 }, { dynamik.vb_max = 0 }]
set.toml:4:56: error[AX203]: `getriebe[1].dynamik.vb_max` (P-AXIS-00212) is 0
    allowed: 1 <= vb_max <= 2000000000 [um/s or 0.001 deg/s]
"#,
    );
}

#[test]
fn both_ends_of_fg_f0_which_the_cycle_time_narrows() {
    let say = |given: &str| {
        let (cycle_time, rest) = given.split_once(' ').unwrap();
        said_of_set(&format!(
            "cycle_time = \"{cycle_time}\"\n[axis.X]\n{IPC}v_add_max_fact = 1\n{IPC}stage = [{{ mode = 'SET_POINT', \
             osc_damping = 0.9, filter = [{{ fg_f0 = 53, order = 1, q_factor = 10 }}, {{ {rest}, q_factor = 10 }}] }}]"
        ))
    };
    assert_transcript(
        say,
        r#"
> 62.5us fg_f0 = 500, type = 'ALLPASS'

> 62.5us fg_f0 = 500.0000000000001, type = 'ALLPASS'
set.toml:4:148: error[AX203]: `ipc.stage[0].filter[1].fg_f0` (P-AXIS-00751) is 500.0000000000001
    allowed: 0 < fg_f0 <= 500 [Hz]

> 900us fg_f0 = 500, type = 'BANDPASS', prototype = 'BESSEL', order = 1
set.toml:4:148: warning[AX407]: stage[0].filter[1] lies at 0.45 of the sampling frequency: its upper skirt is squeezed against one half
    write instead: a shorter cycle time, or fg_f0 below 0.35 of the sampling frequency

> 1.25ms fg_f0 = 361, type = 'ALLPASS'
set.toml:4:148: error[AX304]: `ipc.stage[0].filter[1].fg_f0` (P-AXIS-00751) is 361 Hz, 0.45125 of the sampling frequency
    allowed: fg_f0 <= 360 Hz at a cycle time of 1.25ms (0.45 of the sampling frequency)
"#,
    );
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
const WORDS: &str = "
ipc.enable OFF | OFF off FALSE False 0 0x0
ipc.enable ON | ON on TRUE true 1 0x1
ipc.enable DRYRUN | DRYRUN DryRun
ipc.stage[0].mode NOT_ACTIVE | NOT_ACTIVE not_active 0
ipc.stage[0].mode DIRECT | DIRECT direct 1
ipc.stage[0].mode INDIRECT | INDIRECT Indirect 2
ipc.stage[0].mode SET_POINT | SET_POINT set_point 3 0X3
ipc.stage[0].filter[1].type NO_FILTER | NO_FILTER no_filter
ipc.stage[0].filter[1].type BANDPASS | BANDPASS BandPass
ipc.stage[0].filter[1].type ALLPASS | ALLPASS allpass
ipc.stage[0].filter[0].prototype CRIT_DAMPING | CRIT_DAMPING crit_damping
ipc.stage[0].filter[0].prototype BUTTERWORTH | BUTTERWORTH Butterworth
ipc.stage[0].filter[0].prototype BESSEL | BESSEL bessel
";

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

#[test]
fn what_is_no_word() {
    assert_transcript(
        |given| said(&direct(given)),
        r"
> ipc.enable -1
> kenngr.achs_typ 0
> ipc.stage[0].filter[1].type 1
> ipc.stage[0].filter[1].prototype 0
x.lis:1:43: error[AX202]: `ipc.enable` (P-AXIS-00758) is `-1`
    allowed: OFF (FALSE, 0), ON (TRUE, 1), DRYRUN
x.lis:2:17: error[AX202]: `kenngr.achs_typ` (P-AXIS-00018) is `0`
    allowed: ACHSTYP_TRANSLATOR (1), ACHSTYP_ROTATOR (2), ACHSTYP_SPINDEL (4)
x.lis:3:60: error[AX202]: `ipc.stage[0].filter[1].type` (P-AXIS-00849) is `1`
    allowed: NO_FILTER, BANDPASS, ALLPASS
x.lis:4:65: error[AX202]: `ipc.stage[0].filter[1].prototype` (P-AXIS-00848) is `0`
    allowed: CRIT_DAMPING, BUTTERWORTH, BESSEL

> ipc.enable FALSE ON
> ipc.stage[0].mode SETPOINT
x.lis:1:43: error[AX101]: `ipc.enable` (P-AXIS-00758) is `FALSE ON`: more than one value
    allowed: OFF (FALSE, 0), ON (TRUE, 1), DRYRUN
x.lis:2:50: error[AX202]: `ipc.stage[0].mode` (P-AXIS-00753) is `SETPOINT`
    allowed: NOT_ACTIVE (0), DIRECT (1), INDIRECT (2), SET_POINT (3)
    write instead: SET_POINT
",
    );
}

#[test]
fn b_a_damping_is_judged_where_the_mode_uses_it() {
    for damping in ["ipc.stage[0].osc_damping 7", "ipc.stage[0].filter.damping 7", "ipc.stage[0].filter[0].damping -7"]
    {
        assert_eq!(said(&direct(damping)), "");
    }
    for stage in [indirect, set_point] {
        assert_transcript(
            |given| said(&stage(given)),
            r"
> ipc.stage[0].osc_damping 7
x.lis:1:57: error[AX203]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is 7
    allowed: 0 < osc_damping < 1

> ipc.stage[0].filter[0].damping 7
x.lis:1:63: error[AX203]: `ipc.stage[0].filter[0].damping` (P-AXIS-00756) is 7
    allowed: 0 < damping < 1

> # none
x.lis:3:1: error[AX206]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is missing; its default -1 is outside of its range
    allowed: 0 < osc_damping < 1
    write instead: ipc.stage[0].osc_damping with a value
",
        );
    }
}

#[test]
fn c_every_pair_of_dampings_and_the_misprint() {
    assert_transcript(
        |given| said(&indirect(given)),
        r"
> ipc.stage[0].filter[0].damping 0.8
> ipc.stage[0].osc_damping 0.5
x.lis:2:57: error[AX303]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is 0.5, and its predecessor `ipc.stage[0].filter[0].damping` (P-AXIS-00756) is 0.8
    allowed: one of the two, or equal values
    write instead: only P-AXIS-00850

> ipc.stage[0].filter.damping 1
> ipc.stage[0].osc_damping 1
x.lis:2:57: error[AX203]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is 1
    allowed: 0 < osc_damping < 1

> ipc.stage[0].filter.damping 0.5
> ipc.stage[0].filter[1].type NO_FILTER
x.lis:1:60: warning[AX404]: stage[0].filter.damping (P-AXIS-00756) stands beside `ipc.stage[0].filter[1].type` of the newer parameters
    write instead: ipc.stage[0].osc_damping (P-AXIS-00850) alone

> ipc.stage[0].filter.damping 0.5
> ipc.stage[1].osc_damping 0.7
> ipc.stage[1].filter[0].order 1

> ipc.stage[]osc_damping 0.5
x.lis:1:1: warning[AX108]: `ipc.stage[]osc_damping` is a misprint of the manual
    write instead: ipc.stage[0].osc_damping

> ipc.stage[0].osc_damping 0.5
> ipc.stage[2]osc_damping 7
x.lis:2:1: warning[AX108]: `ipc.stage[2]osc_damping` is a misprint of the manual
    write instead: ipc.stage[2].osc_damping

> ipc.stage[0].osc_damping 0.5
> ipc.stage[3]osc_damping 0.5
x.lis:2:1: error[AX106]: `ipc.stage[3]osc_damping` has an index that does not exist
    allowed: ipc.stage[i].osc_damping with 0 <= i <= 2

> ipc.stage[0].filter.damping 0.5
> ipc.stage[0]osc_damping 0.7
x.lis:2:1: warning[AX108]: `ipc.stage[0]osc_damping` is a misprint of the manual
    write instead: ipc.stage[0].osc_damping
x.lis:2:56: error[AX303]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is 0.7, and its predecessor `ipc.stage[0].filter.damping` (P-AXIS-00756) is 0.5
    allowed: one of the two, or equal values
    write instead: only P-AXIS-00850
",
    );
    assert_transcript(
        |given| said_of_axis(&format!("ipc.v_add_max_fact = 1\nipc.stage = [{{ mode = 'SET_POINT', {given} }}]")),
        r"
> osc_damping = 0.50, filter = { order = 1, fg_f0 = 11, q_factor = 2, damping = 0.5 }
set.toml:4:145: warning[AX404]: stage[0].filter.damping (P-AXIS-00756) stands beside `ipc.stage[0].osc_damping` of the newer parameters
    write instead: ipc.stage[0].osc_damping (P-AXIS-00850) alone

> filter = { order = 1, fg_f0 = 11, q_factor = 2, damping = 0.5 }
",
    );
}

#[test]
fn d_e_every_error_of_every_stage_whatever_enable_says() {
    assert_transcript(
        |given| said(&direct(given)),
        r"
> ipc.enable OFF
> ipc.stage[0].filter.order 4
> ipc.stage[2].mode SET_POINT
> ipc.stage[2].filter.type ALLPASS
> ipc.stage[2].filter.fg_f0 480
> ipc.stage[2].filter.q_factor 2
x.lis:2:58: error[AX203]: `ipc.stage[0].filter.order` (P-AXIS-00750) is 4
    allowed: 1 <= order <= 3
x.lis:3:1: error[AX206]: `ipc.stage[2].osc_damping` (P-AXIS-00850) is missing; its default -1 is outside of its range
    allowed: 0 < osc_damping < 1
    write instead: ipc.stage[2].osc_damping with a value
x.lis:5:58: error[AX304]: `ipc.stage[2].filter.fg_f0` (P-AXIS-00751) is 480 Hz, 0.48 of the sampling frequency
    allowed: fg_f0 <= 450 Hz at a cycle time of 1ms (0.45 of the sampling frequency)

> ipc.stage[0].filter[0].type ALLPASS
> ipc.stage[0].filter[1].type ALLPASS
> ipc.stage[0].filter[1].fg_f0 40
> ipc.stage[0].filter[1].q_factor 2
x.lis:1:60: error[AX301]: stage[0] is DIRECT and has no band-pass
    allowed: at least one BANDPASS in every active stage (P-AXIS-00849)
    write instead: ipc.stage[0].filter[0].type BANDPASS
",
    );
}

#[test]
fn g_gantry_masters_and_slaves() {
    assert_transcript(
        said_beside_a_stage,
        r#"
> ipc.enable = 1
> kopf.achs_nr = 2
> kenngr.gantry_ax_nr = 65535
set.toml:3:45: error[AX305]: improved position control is enabled on a gantry slave, whose master is axis 65535 (P-AXIS-00070): error 70600 of the controller
    write instead: ipc.enable = "OFF" here, and the stages in the list of axis 65535

> ipc.enable = false
> kopf.achs_nr = 65534
> kenngr.gantry_ax_nr = 65535
set.toml:5:23: warning[AX412]: the axis is a gantry slave with active stages: its input `mode` must stay OFF (error 70600)
    write instead: the stages in the list of the master
set.toml:2:7: warning[AX431]: getriebe[0].kv (P-AXIS-00099) is not given: its default 1000 is used, 10/s
    write instead: the gain of the machine, in 0.01/s
set.toml:5:23: error[AX315]: X follows the axis 65535, and no axis of the set has this number
    write instead: the master's list in the set

> ipc.enable = 'ON'
> kenngr.gantry_ax_nr = 0
> getriebe = [{ dynamik.vb_max = 200000 }]

> ipc.enable = 'DRYRUN'
> kenngr.gantry_ax_nr = 3
> kopf.achs_nr = 3
> getriebe = [{ dynamik.vb_max = 200000 }]
"#,
    );
}

#[test]
fn weights_of_set_point_by_default_and_capped() {
    assert_transcript(
        |given| said(&set_point(given)),
        r"
> ipc.stage[0].osc_damping 0.3
x.lis:3:1: warning[AX405]: stage[0] is SET_POINT with the weight 1: above 0.529412 it amplifies what it is to damp
    write instead: about 0.264706, the best weight at this damping

> ipc.stage[0].osc_damping 0.8
> ipc.stage[0].weight_fact_num 900
x.lis:2:61: warning[AX437]: stage[0] asks for the weight 900/1 = 900: it is capped at 7
    write instead: weight_fact_num / weight_fact_denom <= 7; without a line weight_fact_denom (P-AXIS-00755) is 1
x.lis:2:61: warning[AX405]: stage[0] is SET_POINT with the weight 7: above 1.4382 it amplifies what it is to damp
    write instead: about 0.719101, the best weight at this damping

> ipc.stage[0].osc_damping 0.8
> ipc.stage[0].filter.fg_f0 200
",
    );
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

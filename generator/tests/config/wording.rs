//! Where a message about what is missing points, and that its advice is in the language of its file.

use super::{assert_transcript, said, said_of_axis};
use generator::codes::{CODES, explain};

/// A list as a whole has no line: the message stands where its user would look.
#[test]
fn what_is_missing_from_a_list_has_a_line() {
    assert_transcript(
        said,
        r"
> kopf.achs_nr 1
> vorsteuer.vorsteuerung VEL
x.lis:2:1: warning[AX431]: getriebe[0].kv (P-AXIS-00099) is not given: its default 1000 is used, 10/s
    write instead: the gain of the machine, in 0.01/s

> kopf.achs_nr 1
> getriebe[0].dynamik.vb_max 500000
> ipc.v_add_max_fact 1000
> ipc.stage[0].mode NOT_ACTIVE
x.lis:3:1: warning[AX401]: no stage is active: the block puts out 0
    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT

> kopf.achs_nr 1
x.lis: warning[AX401]: no stage is active: the block puts out 0
    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT
",
    );
}

/// What a set is told to write is TOML.
#[test]
fn what_to_write_in_a_set_is_toml() {
    assert_transcript(
        |given| said_of_axis(&format!("ipc.v_add_max_fact = 1\nipc.stage = [{{}}, {{ mode = 'DIRECT', {given} }}]")),
        r#"
> filter = [{ type = 'NO_FILTER' }]
set.toml:4:87: error[AX301]: stage[1] is DIRECT and has no band-pass
    allowed: at least one BANDPASS in every active stage (P-AXIS-00849)
    write instead: type = "BANDPASS" in ipc.stage[1].filter[0]

> filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }, { type = 'BANDPASS', order = 1, fg_f0 = 53, q_factor = 10 }]
set.toml:4:129: error[AX302]: `ipc.stage[1].filter[1].prototype` (P-AXIS-00848) is missing: the band-pass in filter[1] needs it in writing
    allowed: CRIT_DAMPING, BUTTERWORTH, BESSEL
    write instead: prototype = "CRIT_DAMPING" in ipc.stage[1].filter[1]

> filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }, { order = 1 }]
set.toml:4:130: warning[AX411]: stage[1].filter[1] has parameters and no type: it is NO_FILTER (P-AXIS-00849)
    write instead: type = "BANDPASS" or "ALLPASS" in ipc.stage[1].filter[1]
"#,
    );
}

#[test]
fn every_code_is_explained() {
    assert!(CODES.windows(2).all(|pair| pair[0].code < pair[1].code));
    assert_eq!(explain("ax206").unwrap().title, "a parameter is missing");
    assert!(explain("AX999").is_none());
    assert!(CODES.iter().all(|code| code.explanation.ends_with('.') && !code.title.ends_with('.')));
}

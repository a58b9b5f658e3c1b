//! Reading TOML sets.

use super::{assert_said, read_set, said_of_axis, said_of_set};

#[test]
fn a_valid_axis_says_nothing() {
    assert_said(
        &said_of_axis(
            "ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]",
        ),
        &[],
    );
}

#[test]
fn arrays_of_tables() {
    assert_said(
        &said_of_axis(
            "[axis.X.lr_param.improved_position_control]\n\
             enable = true\n\
             v_add_max_fact = 100\n\
             [[axis.X.getriebe]]\n\
             dynamik.vb_max = 200000\n\
             [[axis.X.lr_param.improved_position_control.stage]]\n\
             [[axis.X.lr_param.improved_position_control.stage]]\n\
             mode = 1\n\
             filter.order = 1\n\
             filter.fg_f0 = 53\n\
             filter.q_factor = 10",
        ),
        &[],
    );
}

#[test]
fn nothing() {
    assert_said(
        &said_of_set(""),
        &[
            "set.toml: error[AX005]: the set has no axis",
            "    write instead: [axis.X]",
            "set.toml: error[AX009]: the set has no cycle time",
            "    write instead: cycle_time = \"1ms\", if that is its cycle",
        ],
    );
}

#[test]
fn no_axis() {
    assert_said(
        &said_of_set("cycle_time = \"1ms\""),
        &["set.toml: error[AX005]: the set has no axis", "    write instead: [axis.X]"],
    );
}

#[test]
fn no_cycle_time() {
    assert_said(
        &said_of_set("[axis.X]"),
        &[
            "set.toml: error[AX009]: the set has no cycle time",
            "    write instead: cycle_time = \"1ms\", if that is its cycle",
        ],
    );
}

#[test]
fn cycle_times() {
    assert_said(
        &said_of_set(
            "cycle_time = 1\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX204]: `cycle_time` is of type integer",
            "    allowed: a string: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
            "    write instead: \"1ms\", if milliseconds are meant",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = 1.5\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX204]: `cycle_time` is of type float",
            "    allowed: a string: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
            "    write instead: \"1.5ms\", if milliseconds are meant",
        ],
    );
    assert_said(
        &said_of_set("cycle_time = 0.001\n[axis.X]"),
        &[
            "set.toml:1:14: error[AX204]: `cycle_time` is of type float",
            "    allowed: a string: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
            "    write instead: \"0.001s\", if seconds are meant, or \"0.001ms\", if milliseconds are",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `1`, which has no unit",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
            "    write instead: \"1ms\", if milliseconds are meant",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms \"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `1ms `, not a duration",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"-1ms\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `-1ms`, not a duration",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1 fortnight\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `1 fortnight`, not a duration",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"0.5ns\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `0.5ns`, no whole number of nanoseconds",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"0s\"\n\
             [axis.X]",
        ),
        &["set.toml:1:14: error[AX203]: `cycle_time` is 0s", "    allowed: 1ns <= cycle_time <= 4.294967295s"],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"4294967295ns\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"4.294967296s\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX203]: `cycle_time` is 4.294967296s",
            "    allowed: 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1e3us\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `1e3us`, not a duration",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \".\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `.`, which has no unit",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \".s\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `.s`, not a duration",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1.2.3ms\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `1.2.3ms`, not a duration",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"99999999999999999999s\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:14: error[AX205]: `cycle_time` is `99999999999999999999s`, far too long",
            "    allowed: a number with a unit (s, ms, us or ns), 1ns <= cycle_time <= 4.294967295s",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"62.5 us\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"62.5\u{b5}s\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
}

#[test]
fn targets() {
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             targets = [\"c\", \"ST\"]\n\
             [axis.X]",
        ),
        &[
            "set.toml:3:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             targets = \"c\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:11: error[AX204]: `targets` is of type string",
            "    allowed: an array of strings, any of c, rust, st, twincat, codesys, scl",
            "set.toml:3:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             targets = [\"pascal\"]\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:12: error[AX202]: `targets` is `pascal`",
            "    allowed: any of c, rust, st, twincat, codesys, scl",
            "set.toml:3:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             targets = [\"twincta\"]\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:12: error[AX202]: `targets` is `twincta`",
            "    allowed: any of c, rust, st, twincat, codesys, scl",
            "    write instead: twincat",
            "set.toml:3:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             targets = [\"c\", \"c\"]\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:17: error[AX107]: `targets` names `c` twice",
            "    allowed: any of c, rust, st, twincat, codesys, scl",
            "set.toml:3:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             targets = [\"stt\", \"c\", \"q\",\n  \"scll\", \"c\"]\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:12: error[AX202]: `targets` is `stt`",
            "    allowed: any of c, rust, st, twincat, codesys, scl",
            "    write instead: st",
            "set.toml:2:24: error[AX202]: `targets` is `q`",
            "    allowed: any of c, rust, st, twincat, codesys, scl",
            "    write instead: c",
            "set.toml:3:3: error[AX202]: `targets` is `scll`",
            "    allowed: any of c, rust, st, twincat, codesys, scl",
            "    write instead: scl",
            "set.toml:3:11: error[AX107]: `targets` names `c` twice",
            "    allowed: any of c, rust, st, twincat, codesys, scl",
            "set.toml:4:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             targets = [1]\n\
             [axis.X]",
        ),
        &[
            "set.toml:2:12: error[AX204]: `targets` is of type integer",
            "    allowed: an array of strings, any of c, rust, st, twincat, codesys, scl",
            "set.toml:3:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             targets = []\n\
             [axis.X]",
        ),
        &[
            "set.toml:3:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
}

#[test]
fn no_toml() {
    assert_said(
        &said_of_set(
            "cycle_time = \n\
             [axis.X",
        ),
        &[
            "set.toml:1:14: error[AX004]: the key has no value",
            "    write instead: a value behind `=`",
            "set.toml:2:1: error[AX004]: the name of a table without its end",
            "    write instead: [axis.X]",
        ],
    );
    assert_said(
        &said_of_set("= \"1ms\"\n\n[[["),
        &[
            "set.toml:1:1: error[AX004]: no TOML: unquoted keys cannot be empty, expected letters, numbers, `-`, `_`",
            "set.toml:3:1: error[AX004]: the name of a table without its end",
            "    write instead: [[[]]",
        ],
    );
    assert_said(
        &said_of_set(
            "a = 1\n\
             a = 2",
        ),
        &["set.toml:2:1: error[AX004]: the key is given twice", "    write instead: one of the two lines"],
    );
}

#[test]
fn keys_at_the_top() {
    assert_said(
        &said_of_set(
            "cycle_tme = \"1ms\"\n\
             enable = \"ON\"\n\
             axes = 1\n\
             cycle_time = \"1ms\"\n\
             [axis.X]",
        ),
        &[
            "set.toml:1:1: error[AX104]: `cycle_tme` is no key of a set",
            "    allowed: cycle_time, targets, axis.NAME",
            "    write instead: cycle_time",
            "set.toml:2:1: error[AX104]: `enable` is no key of a set",
            "    allowed: cycle_time, targets, axis.NAME",
            "set.toml:3:1: error[AX104]: `axes` is no key of a set",
            "    allowed: cycle_time, targets, axis.NAME",
            "    write instead: axis",
            "set.toml:5:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
}

#[test]
fn axis_is_no_table() {
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             axis = 1",
        ),
        &["set.toml:2:1: error[AX204]: `axis` is of type integer", "    allowed: a table"],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             axis.X = 1",
        ),
        &["set.toml:2:6: error[AX204]: `axis.X` is of type integer", "    allowed: a table"],
    );
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n\
             [[axis]]",
        ),
        &["set.toml:2:3: error[AX204]: `axis` is of type array", "    allowed: a table"],
    );
}

#[test]
fn names_of_axes() {
    assert_said(
        &said_of_set(
            "cycle_time = \"1ms\"\n[axis.X]\n[axis.x]\n[axis._Y]\n[axis.Y_]\n[axis.\"Y Z\"]\n[axis.\"*/\"]\n[axis.Y__Z]\n[axis.1Y]\n[axis.\"\"]\n[axis.\"\u{e4}\"]\n[axis.A12345678901234567890123456789012]\n[axis.\"../X\"]\n[axis.\"a\\nb\"]\n",
        ),
        &[
            "set.toml:3:7: error[AX007]: `x` differs only in case from the axis in line 2; Structured Text sees one name",
            "    write instead: another name",
            "set.toml:4:7: error[AX006]: `_Y` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:5:7: error[AX006]: `Y_` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:6:7: error[AX006]: `Y Z` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:7:7: error[AX006]: `*/` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:8:7: error[AX006]: `Y__Z` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:9:7: error[AX006]: `1Y` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:10:7: error[AX006]: `` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:11:7: error[AX006]: `\u{e4}` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:12:7: error[AX006]: `A12345678901234567890123456789012` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:13:7: error[AX006]: `../X` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:14:7: error[AX006]: `a\\nb` is no name for an axis",
            "    allowed: 1 to 32 letters, digits and single underscores, a letter first and no underscore last (what C and ST both accept)",
            "set.toml:2:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:3:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:4:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:5:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:6:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:7:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:8:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:9:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:10:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:11:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:12:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:13:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
            "set.toml:14:7: warning[AX401]: no stage is active: the block puts out 0",
            "    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT",
        ],
    );
}

#[test]
fn unknown_keys() {
    assert_said(
        &said_of_axis(
            "rael = \"f32\"\n\
             colour = 1\n\
             cycle_time = \"1ms\"\n\
             kenngr.swe_pos = 1\n\
             [axis.X.lr_param.improved_postion_control]\n\
             enable = 1\n\
             [axis.X.lr_param.improved_position_control]\n\
             enabel = 1\n\
             stage = [{ mod = 1, filtre = [{}] }]",
        ),
        &[
            "set.toml:3:1: error[AX104]: `rael` is not known",
            "    write instead: real",
            "set.toml:4:1: error[AX104]: `colour` is not known",
            "set.toml:5:1: error[AX104]: `cycle_time` is a key of the set, not of an axis",
            "    write instead: `cycle_time` before the first table",
            "set.toml:6:8: error[AX104]: `kenngr.swe_pos` is not known",
            "set.toml:7:18: error[AX104]: `lr_param.improved_postion_control` is not known",
            "    write instead: lr_param.improved_position_control",
            "set.toml:10:1: error[AX104]: `ipc.enabel` is not known",
            "    write instead: ipc.enable",
            "set.toml:11:12: error[AX104]: `ipc.stage[0].mod` is not known",
            "    write instead: ipc.stage[0].mode",
            "set.toml:11:21: error[AX104]: `ipc.stage[0].filtre` is not known",
            "    write instead: ipc.stage[0].filter",
        ],
    );
}

#[test]
fn tables_and_values_in_each_others_place() {
    assert_said(
        &said_of_axis(
            "list = 1\n\
             kopf = 1\n\
             getriebe = { dynamik.vb_max = 1 }\n\
             ipc.enable = { a = 1 }\n\
             ipc.stage = [1, { mode = [], filter = [[]] }]\n\
             [axis.X.kenngr]\n\
             achs_typ.x = 1\n\
             [[axis.X.real]]",
        ),
        &[
            "set.toml:3:8: error[AX204]: `list` is of type integer",
            "    allowed: a string",
            "set.toml:4:1: error[AX204]: `kopf` is of type integer",
            "    allowed: a table",
            "set.toml:5:1: error[AX204]: `getriebe` is of type table",
            "    allowed: an array of tables",
            "    write instead: getriebe = [{ ... }], or [[...getriebe]] for each",
            "set.toml:6:45: error[AX204]: `ipc.enable` (P-AXIS-00758) is of type table",
            "    allowed: a string, OFF (FALSE, 0), ON (TRUE, 1), DRYRUN",
            "set.toml:7:45: error[AX204]: `ipc.stage[0]` is of type integer",
            "    allowed: a table",
            "set.toml:7:57: error[AX204]: `ipc.stage[1].mode` (P-AXIS-00753) is of type array",
            "    allowed: a string, NOT_ACTIVE (0), DIRECT (1), INDIRECT (2), SET_POINT (3)",
            "set.toml:7:71: error[AX204]: `ipc.stage[1].filter[0]` is of type array",
            "    allowed: a table",
            "set.toml:9:1: error[AX204]: `kenngr.achs_typ` (P-AXIS-00018) is of type table",
            "    allowed: a string, ACHSTYP_TRANSLATOR (1), ACHSTYP_ROTATOR (2), ACHSTYP_SPINDEL (4)",
            "set.toml:10:1: error[AX204]: `real` is of type array",
            "    allowed: a string, f64 (LREAL), f32 (REAL)",
        ],
    );
}

#[test]
fn types() {
    assert_said(
        &said_of_axis(
            "gear = \"1\"\n\
             fade = 100\n\
             ipc.enable = 1.5\n\
             ipc.v_add_max_fact = \"1000\"\n\
             ipc.stage = [{ mode = true, weight_fact_num = 1.0, filter = [{ fg_f0 = '53', q_factor = nan, order = 0x2 }] }]\n\
             kopf.achs_nr = 1979-05-27",
        ),
        &[
            "set.toml:3:8: error[AX204]: `gear` is of type string",
            "    allowed: a whole number, 0 <= gear <= 15",
            "    write instead: 1, without quotes",
            "set.toml:4:8: error[AX204]: `fade` is of type integer",
            "    allowed: a string: a number with a unit (s, ms, us or ns), 0s <= fade <= 1000s",
            "    write instead: \"100ms\", if milliseconds are meant",
            "set.toml:5:45: error[AX204]: `ipc.enable` (P-AXIS-00758) is of type float",
            "    allowed: a string, OFF (FALSE, 0), ON (TRUE, 1), DRYRUN",
            "set.toml:6:53: error[AX204]: `ipc.v_add_max_fact` (P-AXIS-00757) is of type string",
            "    allowed: a whole number, 0 <= v_add_max_fact <= 2000 [0.1 %]",
            "    write instead: 1000, without quotes",
            "set.toml:7:54: error[AX202]: `ipc.stage[0].mode` (P-AXIS-00753) is `TRUE`",
            "    allowed: NOT_ACTIVE (0), DIRECT (1), INDIRECT (2), SET_POINT (3)",
            "set.toml:7:78: error[AX201]: `ipc.stage[0].weight_fact_num` (P-AXIS-00754) is `1.0`, no whole number",
            "    allowed: a whole number, 1 <= weight_fact_num <= 4294967294",
            "set.toml:7:103: error[AX204]: `ipc.stage[0].filter[0].fg_f0` (P-AXIS-00751) is of type string",
            "    allowed: a number, 0 < fg_f0 <= 500 [Hz]",
            "    write instead: 53, without quotes",
            "set.toml:7:120: error[AX201]: `ipc.stage[0].filter[0].q_factor` (P-AXIS-00752) is `nan`, no finite number",
            "    allowed: a number, 1 <= q_factor <= 10",
            "set.toml:8:16: error[AX204]: `kopf.achs_nr` (P-AXIS-00016) is of type datetime",
            "    allowed: a whole number, 0 <= achs_nr <= 65535",
        ],
    );
}

#[test]
fn real_types() {
    assert_said(
        &said_of_axis(
            "real = \"LREAL\"\n\
             ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]",
        ),
        &[],
    );
    assert_said(
        &said_of_axis(
            "real = \"f64\"\n\
             ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]",
        ),
        &[],
    );
    assert_said(
        &said_of_axis(
            "real = \"double\"\n\
             ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]",
        ),
        &["set.toml:3:8: error[AX202]: `real` is `double`", "    allowed: f64 (LREAL), f32 (REAL)"],
    );
}

#[test]
fn indices() {
    assert_said(
        &said_of_axis("ipc.stage = [{}, {}, {}, { mode = 1 }]\nipc.enable = 0\n"),
        &[
            "set.toml:3:59: error[AX106]: `ipc.stage[3].mode` has an index that does not exist",
            "    allowed: ipc.stage[i].mode with 0 <= i <= 2",
        ],
    );
}

#[test]
fn the_gear_step_is_chosen() {
    assert_said(
        &said_of_axis(
            "gear = 1\n\
             getriebe = [{}, { dynamik.vb_max = 5000 }, { dynamik.vb_max = 6 }]\n\
             ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]",
        ),
        &[],
    );
}

#[test]
fn a_gear_step_that_is_not_given() {
    assert_said(
        &said_of_axis(
            "gear = 3\n\
             getriebe = [{}, { dynamik.vb_max = 5 }]\n\
             ipc.v_add_max_fact = 1000\n\
             ipc.stage = [{ mode = 'DIRECT', filter = [{ order = 1, fg_f0 = 53, q_factor = 10 }] }]",
        ),
        &[
            "set.toml:3:8: error[AX317]: `gear` is 3, and the axis has the gear step 1 only",
            "    allowed: a gear step that the list or the set has",
            "    write instead: gear = 1, or the parameters getriebe[3]",
        ],
    );
}

#[test]
fn the_same_checks_as_for_lists() {
    assert_said(
        &said_of_axis(
            "ipc.v_add_max_fact = 2001\n\
             ipc.stage = [{ mode = 'INDIRECT', filter = [{ order = 4, fg_f0 = 480 }] }]",
        ),
        &[
            "set.toml:3:53: error[AX203]: `ipc.v_add_max_fact` (P-AXIS-00757) is 2001",
            "    allowed: 0 <= v_add_max_fact <= 2000 [0.1 %]",
            "set.toml:4:47: error[AX206]: `ipc.stage[0].osc_damping` (P-AXIS-00850) is missing; its default -1 is outside of its range",
            "    allowed: 0 < osc_damping < 1",
            "    write instead: ipc.stage[0].osc_damping with a value",
            "set.toml:4:86: error[AX203]: `ipc.stage[0].filter[0].order` (P-AXIS-00750) is 4",
            "    allowed: 1 <= order <= 3",
            "set.toml:4:97: error[AX304]: `ipc.stage[0].filter[0].fg_f0` (P-AXIS-00751) is 480 Hz, 0.48 of the sampling frequency",
            "    allowed: fg_f0 <= 450 Hz at a cycle time of 1ms (0.45 of the sampling frequency)",
            "set.toml:4:47: error[AX206]: `ipc.stage[0].filter[0].q_factor` (P-AXIS-00752) is missing; its default -1 is outside of its range",
            "    allowed: 1 <= q_factor <= 10",
            "    write instead: ipc.stage[0].filter[0].q_factor with a value",
        ],
    );
}

#[test]
fn no_utf8() {
    let (_, report) = read_set(b"# \xC3\xA4\n# \xE4\n");
    assert_said(&report.to_string(), &["set.toml:2:3: error[AX003]: not UTF-8", "    allowed: a TOML file is UTF-8"]);
}

#[test]
fn axes_keep_the_order_of_the_file() {
    let (set, _) = read_set("targets = [\"ST\", \"C\"]\ncycle_time = \"62.5us\"\n[axis.Z]\n[axis.A]\n[axis.m]\n");
    let set = set.unwrap();
    assert_eq!(set.targets, ["st", "c"]);
    let names: Vec<_> = set.axes.iter().map(|of| (of.axis.name.as_str(), of.axis.cycle_time_ns)).collect();
    assert_eq!(names, [("Z", 62_500), ("A", 62_500), ("m", 62_500)]);
}

//! Gear steps: which one is used, what is said where that may be a surprise.

use super::{assert_transcript, read, said, said_of_axis, short};
use generator::config::ListOptions;

#[test]
fn several_steps_of_a_list_are_named() {
    assert_transcript(
        said,
        r"
> getriebe[0].kv 1000
> getriebe[2].kv 3000
x.lis:2:16: warning[AX403]: the gear steps 0, 2 are given; step 0 is used
    write instead: the key `gear` in a set, to choose one

> getriebe[0].kv 1000
> getriebe[1].multi_gain_z 3000
x.lis:2:26: warning[AX403]: gear step 0 is used, and lacks what other steps have: multi_gain_z (P-AXIS-00129), whose default 2000 holds
    write instead: the parameters getriebe[0], or the key `gear` of another step
",
    );
}

/// What is said about an axis that has the list, and the keys that are given.
fn said_beside_a_list(keys: &str) -> String {
    let list = b"getriebe[0].kv 1000\ngetriebe[2].kv 3000\ngetriebe[0].dynamik.vb_max 500000\ngetriebe[1].dynamik.vb_max 400000";
    let set = format!("cycle_time = '1ms'\naxis.X = {{ list = 'x.lis', {keys} }}");
    let files: [(&str, &[u8]); 2] = [("set.toml", set.as_bytes()), ("x.lis", list)];
    short(&read("set.toml", &files, &ListOptions::default()).1)
}

#[test]
fn the_step_that_is_chosen_is_there_and_complete() {
    assert_transcript(
        said_beside_a_list,
        r"
> gear = 0

> gear = 1
x.lis:3:28: warning[AX403]: gear step 1 is used, and lacks what other steps have: kv (P-AXIS-00099), without which there is no position control
    write instead: the parameters getriebe[1], or the key `gear` of another step
set.toml:2:6: warning[AX401]: no stage is active: the block puts out 0
    write instead: ipc.stage[0].mode with DIRECT, INDIRECT or SET_POINT

> gear = 2
x.lis:3:28: warning[AX403]: gear step 2 is used, and lacks what other steps have: dynamik.vb_max (P-AXIS-00212), whose default 200000 holds
    write instead: the parameters getriebe[2], or the key `gear` of another step

> gear = 5
set.toml:2:35: error[AX317]: `gear` is 5, and the axis has the gear steps 0, 1, 2 only
    allowed: a gear step that the list or the set has
    write instead: gear = 0, or the parameters getriebe[5]
",
    );
    assert_transcript(
        said_of_axis,
        r"
> gear = 1
> getriebe = [{ kv = 1000 }]
set.toml:3:8: error[AX317]: `gear` is 1, and the axis has the gear step 0 only
    allowed: a gear step that the list or the set has
    write instead: gear = 0, or the parameters getriebe[1]
",
    );
}

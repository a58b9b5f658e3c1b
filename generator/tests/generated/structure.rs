//! The digest of a block's structure: another value of a coefficient keeps it, anything else in the block changes it.

use crate::set_of;
use generator::blocks::blocks;
use generator::generate::identity;

const SET: &str = "cycle_time = '1ms'\n[axis.X]\nreal = 'f64'\naccept_unstable = true\nfade = '0.1s'\nshort_names = false\n\
    getriebe = [{ kv = 2000, multi_gain_z = 20000, multi_gain_n = 1, dynamik.vb_max = 500000 }]\n\
    kenngr.antr_typ = 'CONVENTIONAL'\nvorsteuer.vorsteuerung = 'VEL|ACC'\nvorsteuer.vs_a_faktor = 4000\n\
    [axis.X.lr_param.improved_position_control]\nenable = 'ON'\nv_add_max_fact = 100\n\
    [[axis.X.lr_param.improved_position_control.stage]]\nmode = 'DIRECT'\nweight_fact_num = 3\nweight_fact_denom = 1\n\
    filter = [{ order = 1, fg_f0 = 53, q_factor = 5 }]\n";

/// Each block with the digest of its structure.
fn digests(set: &str) -> Vec<(&'static str, String)> {
    let set = set_of(set);
    let blocks = blocks(&set.axes[0]).unwrap();
    blocks.iter().map(|block| (block.program.block, identity(&set.axes[0].axis, block).structure_digest)).collect()
}

/// The blocks whose structure another line of the set changes.
fn changed(line: &str, other: &str) -> Vec<&'static str> {
    assert!(SET.contains(line), "{line}");
    let (before, after) = (digests(SET), digests(&SET.replace(line, other)));
    assert_eq!(before.len(), 4);
    before.iter().filter(|block| !after.contains(block)).map(|(block, _)| *block).collect()
}

#[test]
fn values_keep_the_structure() {
    for (line, other) in [
        ("weight_fact_num = 3", "weight_fact_num = 2"),
        // A factor of 1 is left out of the statements, but it is one of the coefficients.
        ("weight_fact_num = 3", "weight_fact_num = 1"),
        ("fg_f0 = 53", "fg_f0 = 60"),
        ("q_factor = 5", "q_factor = 2.5"),
        ("v_add_max_fact = 100", "v_add_max_fact = 200"),
        ("enable = 'ON'", "enable = 'OFF'"),
        ("fade = '0.1s'", "fade = '0.3s'"),
        ("vb_max = 500000", "vb_max = 400000"),
        ("kv = 2000", "kv = 3000"),
        ("vs_a_faktor = 4000", "vs_a_faktor = 5000"),
        ("multi_gain_z = 20000", "multi_gain_z = 10000"),
        ("short_names = false", "short_names = true"),
    ] {
        assert_eq!(changed(line, other), [""; 0], "{other}");
    }
}

#[test]
fn anything_else_changes_it() {
    let all = ["ipc", "feedforward", "position_control", "axis"];
    for (line, other, blocks) in [
        ("order = 1", "order = 2", &["ipc", "axis"][..]),
        ("mode = 'DIRECT'", "mode = 'INDIRECT'\nosc_damping = 0.5", &["ipc", "axis"]),
        ("mode = 'DIRECT'", "mode = 'DIRECT'\ndirect_source = 'v_direct'", &["ipc", "axis"]),
        ("q_factor = 5 }", "q_factor = 5 }, { type = 'ALLPASS', fg_f0 = 53, q_factor = 2 }", &["ipc", "axis"]),
        ("'VEL|ACC'", "'VEL'", &["feedforward", "axis"]),
        ("real = 'f64'", "real = 'f32'", &all),
        ("'1ms'", "'2ms'", &all),
    ] {
        assert_eq!(changed(line, other), blocks, "{other}");
    }
}

//! The keys of the excitation: defaults, ranges, what is refused and what is warned of.

use super::{read_set, said_of_axis};

/// Amplitude, bits, clock and periods at a cycle time.
fn excitation(cycle: &str, keys: &str) -> (f64, u32, u32, u32) {
    let (set, report) = read_set(format!(
        "cycle_time = '{cycle}'\n[axis.X]\nexcitation = {{ {keys} }}\ngetriebe = [{{ dynamik.vb_max = 500000 }}]\n"
    ));
    let set = set.unwrap_or_else(|| panic!("{report}"));
    let of = set.axes[0].axis.excitation.unwrap_or_else(|| panic!("{keys} asks for the block"));
    (of.amplitude, of.sequence.bits(), of.sequence.clock(), of.periods)
}

#[test]
fn what_is_left_out_follows_from_the_cycle_time() {
    assert_eq!(excitation("1ms", "periods = 8"), (2000.0, 11, 2, 8));
    assert_eq!(excitation("62.5us", "amplitude = 5000"), (5000.0, 11, 32, 8));
    assert_eq!(excitation("4ms", "amplitude = 2000"), (2000.0, 10, 1, 8));
    assert_eq!(excitation("1ms", "clock = 1"), (2000.0, 12, 1, 8), "bits follow the clock");
    assert_eq!(excitation("1ms", "bits = 13, periods = 4"), (2000.0, 13, 2, 4));
    let (set, _) = read_set("cycle_time = '1ms'\n[axis.X]\ngetriebe = [{ dynamik.vb_max = 500000 }]\n");
    assert!(set.is_some_and(|set| set.axes[0].axis.excitation.is_none()), "nobody asks for it");
}

/// What is said of these keys; the first line of each message, without its place.
fn said(keys: &str) -> Vec<String> {
    let text = format!(
        "excitation = {{ {keys} }}\ngetriebe = [{{ dynamik.vb_max = 500000 }}]\nipc.v_add_max_fact = 10\n\
         ipc.stage = [{{ mode = 'DIRECT', filter = [{{ order = 1, fg_f0 = 53, q_factor = 10 }}] }}]"
    );
    let said = said_of_axis(&text);
    said.lines().filter(|line| line.starts_with("set.toml") || line.starts_with("    ")).map(str::to_owned).collect()
}

fn has(keys: &str, expected: &[&str]) {
    let said = said(keys);
    for line in expected {
        assert!(said.iter().any(|said| said.contains(line)), "{keys}: {line}\n{said:#?}");
    }
}

#[test]
fn numbers_out_of_their_range() {
    for keys in ["amplitude = 0.0", "amplitude = -1.0", "amplitude = nan", "amplitude = inf", "amplitude = 2e9"] {
        has(keys, &["`excitation.amplitude`", "allowed: "]);
    }
    has("bits = 6", &["error[AX203]: `excitation.bits` is 6", "allowed: 7 <= bits <= 15"]);
    has("bits = 16", &["error[AX203]: `excitation.bits` is 16"]);
    has("clock = 0", &["error[AX203]: `excitation.clock` is 0", "allowed: 1 <= clock <= 100000 [cycles]"]);
    has("periods = 3", &["error[AX203]: `excitation.periods` is 3", "allowed: 4 <= periods <= 1000"]);
}

#[test]
fn what_does_not_fit_together() {
    assert!(said("amplitude = 5000").is_empty(), "{:?}", said("amplitude = 5000"));
    has(
        "amplitude = 5000.5",
        &[
            "error[AX346]: `excitation.amplitude` is 5000.5: the limit of v_add is 5000",
            "allowed: at most 5000 um/s, P-AXIS-00757 times P-AXIS-00212",
            "write instead: a smaller excitation.amplitude",
        ],
    );
    has(
        "amplitude = 4000, bits = 7, clock = 1, periods = 4",
        &[
            "warning[AX493]: a period of the excitation, (2^7 - 1) * 1 cycles, lasts 0.127 s: its lines are 7.87402 Hz apart",
        ],
    );
    let slow = said_of_axis("excitation = { amplitude = 20000 }\ngetriebe = [{ dynamik.vb_max = 60000 }]");
    let found = "warning[AX494]: the move while exciting needs 50000 um/s, with the excitation 70000; vb_max is 60000 (P-AXIS-00212)";
    assert!(slow.contains(found), "{slow}");
    let brief = super::said_of_set(
        "cycle_time = '500us'\n[axis.X]\nexcitation = { bits = 7, clock = 1 }\ngetriebe = [{ dynamik.vb_max = 500000 }]",
    );
    let found =
        "error[AX347]: a period of the excitation, (2^7 - 1) * 1 cycles, lasts 0.0635 s; the excitation rises in 0.1 s";
    assert!(brief.contains(found) && brief.contains("allowed: at least 0.1 s"), "{brief}");
}

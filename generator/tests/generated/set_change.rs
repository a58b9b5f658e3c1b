//! Which changes of an axis a parameter set brings to the block on the machine, and which need new code.

use crate::set_of;
use compiler::leaves;
use generator::blocks::{Design, Designed};
use generator::params_of;
use generator::set_change::{Refusal, judge};
use portable::{Literal, Portable, Real, RealKind};
use reference::sets::{Coeffs, params, refusal};
use reference::tunable_ipc::{Inputs, Outputs, State, TunableIpc, init, step};
use std::collections::BTreeSet;

const SET: &str = include_str!("../data/tunable.toml");

/// The axis of the set, each `from` replaced by `to`; every one must be there.
fn axis(changes: &[(&str, &str)]) -> Designed {
    let text = changes.iter().fold(SET.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    set_of(&text).axes.remove(0)
}

const SINGLE: (&str, &str) = ("tunable", "real = \"f32\"\ntunable");

/// Numbers alone: the block with the old structure and the new numbers is the new block, cycle by cycle.
#[test]
fn a_set_brings_weights_frequencies_damping_and_a_smaller_limit() {
    for real in [&[][..], &[SINGLE]] {
        let old = axis(real);
        for changed in [
            &[][..],
            &[("weight_fact_num = 150", "weight_fact_num = 90")],
            &[("fg_f0 = 53.0", "fg_f0 = 61.25"), ("q_factor = 10.0", "q_factor = 3.0")],
            &[("osc_damping = 0.7", "osc_damping = 0.9")],
            &[("v_add_max_fact = 500", "v_add_max_fact = 300")],
            &[("v_add_max_fact = 500", "v_add_max_fact = 1")],
            &[("CRIT_DAMPING", "BESSEL")],
        ] {
            let new = axis(&[real, changed].concat());
            let judgement = judge(&old, &new);
            assert!(judgement.reasons().is_empty(), "{changed:?}: {judgement:?}");
            assert_eq!(judgement.reasons(), Vec::<String>::new());
            if old.axis.real == RealKind::F64 {
                assert_same_outputs(&old, &new);
            }
        }
    }
}

/// A controller that designs its sets needs new code only for what its design does not read from an input.
#[test]
fn a_design_is_the_same_whatever_its_inputs_start_with() {
    let designs = ("tunable = \"all\"", "tunable = \"parameters\"\nlowest_f0 = 8");
    let old = axis(&[designs]);
    for (changed, reasons) in [
        (("q_factor = 10.0", "q_factor = 3.0"), &[][..]),
        (("weight_fact_num = 150", "weight_fact_num = 90"), &[]),
        (("v_add_max_fact = 500", "v_add_max_fact = 300"), &[]),
        (("CRIT_DAMPING", "BESSEL"), &["the block set_design differs"]),
    ] {
        assert_eq!(judge(&old, &axis(&[designs, changed])).reasons(), reasons, "{changed:?}");
    }
}

/// Both blocks start with the set of the new version, which both take over in the same cycle.
fn assert_same_outputs(old: &Designed, new: &Designed) {
    let coeffs = TunableIpc::design;
    let set = params(&coeffs(new));
    let [mut of_old, mut of_new] = [State::<f64>::default(); 2];
    let (mut out_of_old, mut out_of_new) = (Outputs::<f64>::default(), Outputs::<f64>::default());
    init(&mut of_old);
    init(&mut of_new);
    let (mut random, mut in_use) = (1_u32, 0);
    for _ in 0..3000 {
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let v_motor = f64::from(random >> 8) / 64.0;
        let inputs = Inputs {
            v_command: -v_motor,
            v_motor,
            mode: 1,
            position_controlled: true,
            params: set,
            ..Inputs::default()
        };
        step(&mut of_old, &coeffs(old), &inputs, &mut out_of_old);
        step(&mut of_new, &coeffs(new), &inputs, &mut out_of_new);
        in_use += u32::from(out_of_old.active_set == new.sets[1]);
        assert_eq!(leaves(&out_of_old), leaves(&out_of_new));
    }
    assert!(in_use > 2000, "{in_use}");
}

#[track_caller]
fn assert_structure(changed: &[(&str, &str)], expected: &[&str]) {
    let (old, new) = (axis(&[]), axis(changed));
    let lines = expected.iter().map(|&line| line.to_owned()).collect();
    assert_eq!(judge(&old, &new).refused, Some(Refusal::Structure(lines)));
    assert_ne!(old.sets[0], new.sets[0], "the block tells it by its word");
}

#[test]
fn another_structure_needs_new_code() {
    assert_structure(
        &[("order = 1", "order = 2")],
        &[
            "stage[0] DIRECT from v_motor, BANDPASS order 1, NO_FILTER -> DIRECT from v_motor, BANDPASS order 2, NO_FILTER",
        ],
    );
    assert_structure(
        &[("\"SET_POINT\"", "\"INDIRECT\"")],
        &[
            "stage[1] SET_POINT from v_command, BANDPASS order 1, ALLPASS -> INDIRECT from v_motor, BANDPASS order 1, ALLPASS",
        ],
    );
    assert_structure(
        &[("cycle_time = \"1ms\"", "cycle_time = \"2ms\"")],
        &[
            "cycle time 1000 -> 2000 us",
            "fade 100 -> 50 cycles",
            "watch in blocks of 50 cycles, alarm 6 -> in blocks of 25 cycles, alarm 6",
        ],
    );
    assert_structure(&[SINGLE], &["real type f64 -> f32"]);
    assert_structure(&[("tunable", "ride_through = 2\ntunable")], &["rides through 0 -> 2 bad samples in a row"]);
    // The watch counts cycles by the lowest f0, and the fade takes at least one period of it.
    assert_structure(
        &[("fg_f0 = 12.0", "fg_f0 = 8.0")],
        &["fade 100 -> 125 cycles", "watch in blocks of 50 cycles, alarm 6 -> in blocks of 75 cycles, alarm 6"],
    );
    assert_structure(&[("watch = true", "watch = false")], &["watch in blocks of 50 cycles, alarm 6 -> none"]);
}

#[test]
fn what_is_no_number_of_a_set_is_left() {
    let left = |changed: &[(&str, &str)]| {
        let judgement = judge(&axis(&[]), &axis(changed));
        assert_eq!(judgement.refused, None);
        assert!(!judgement.reasons().is_empty());
        judgement.reasons()
    };
    assert_eq!(left(&[("enable = \"OFF\"", "enable = \"DRYRUN\"")]), ["starts OFF -> DRYRUN"]);
    let slower = [("vb_max = 400000", "vb_max = 200000"), ("v_add_max_fact = 500", "v_add_max_fact = 1000")];
    assert_eq!(left(&slower), ["v_max 400000 -> 200000"]);
    let feedforward = [("[[axis.X.lr", "[axis.X.vorsteuer]\nvorsteuerung = \"VEL\"\n\n[[axis.X.lr")];
    let differing = ["the block feedforward differs", "the block position_control differs", "the block axis differs"];
    assert_eq!(left(&feedforward), differing);
    // A block `axis` takes its numbers from the set, too.
    let loops = ("getriebe = [{ dynamik", "getriebe = [{ kv = 2000, dynamik");
    let judged = judge(&axis(&[loops]), &axis(&[loops, ("fact_num = 80", "fact_num = 70")]));
    assert_eq!(judged.reasons(), Vec::<String>::new());
}

#[test]
fn a_larger_limit_needs_new_code_in_the_real_type_of_the_block() {
    for real in [&[][..], &[SINGLE]] {
        let old = axis(real);
        let new = axis(&[real, &[("v_add_max_fact = 500", "v_add_max_fact = 501")]].concat());
        assert_eq!(judge(&old, &new).refused, Some(Refusal::Limit([200_000.0, 200_400.0])));
        assert_eq!(judge(&new, &old).refused, None);
    }
}

#[test]
fn both_versions_take_sets() {
    let (with, without) = (axis(&[]), axis(&[("tunable = \"all\"", "tunable = \"nothing\"")]));
    assert_eq!(judge(&without, &with).refused, Some(Refusal::NoSetsBefore));
    assert_eq!(judge(&with, &without).refused, Some(Refusal::NoSetsAfter));
    assert_eq!(params_of::numbers(&without).map(|values| values.len()).ok(), Some(0));
}

/// The numbers are those that the reference makes of the axis, each with its name.
#[test]
fn the_values_are_those_of_the_reference() {
    let of = axis(&[]);
    let values = params_of::numbers(&of).unwrap_or_else(|defect| panic!("{defect}"));
    let value = |name: &str| values.iter().find(|(known, _)| known == name).map(|(_, value)| *value);
    let set = params(&TunableIpc::design(&of));
    assert_eq!(values[0], ("structure".to_owned(), Literal::U32(set.structure)));
    assert_eq!(values[1], ("set_id".to_owned(), Literal::U32(set.set_id)));
    assert_eq!(value("stage1_gain"), Some(Literal::F64(set.stage[1].gain)));
    assert_eq!(value("stage1_filter1_allpass_a2"), Some(Literal::F64(set.stage[1].filter[1].allpass.a2)));
    assert_eq!(value("watch_quiet"), Some(Literal::F64(set.watch.quiet)));
    assert_eq!(value("stage2_gain"), None, "the stage is not there");
}

/// Whatever bit of a number of the set is another one, the block refuses it, but for the sign of a 0: what
/// docs/parameter-sets.md says.
#[test]
fn no_changed_bit_escapes() {
    let (of, of_single) = (axis(&[]), axis(&[SINGLE]));
    assert_eq!(escapes::<f64>(&of), [""; 0]);
    assert_eq!(escapes::<f32>(&of_single), [""; 0]);
}

/// What a single changed bit makes of a number of the set, where the block does not see it.
fn escapes<R: Real>(of: &Designed) -> Vec<String> {
    let wide = TunableIpc::design(of);
    let coeffs: Coeffs<R> = build(leaves(&wide).into_iter().map(|leaf| match leaf {
        Literal::F64(value) => real::<R>(R::lit(value).to_f64()),
        other => other,
    }));
    let set = leaves(&params(&coeffs));
    let error = |at: usize, leaf: Literal| {
        let mut changed = set.clone();
        changed[at] = leaf;
        refusal(&coeffs, &build(changed.into_iter()))
    };
    assert_eq!(error(0, set[0]), 0, "as it is, the set is taken over");
    let mut found = BTreeSet::new();
    for (at, leaf) in set.iter().enumerate() {
        // What the structure does not use is not looked at.
        let is_used = matches!(leaf, Literal::U32(_) | Literal::I32(_)) || error(at, real::<R>(f64::NAN)) != 0;
        for bit in 0..if R::KIND == RealKind::F64 { 64 } else { 32 } {
            let changed = match *leaf {
                Literal::F64(value) => Literal::F64(f64::from_bits(value.to_bits() ^ 1 << bit)),
                Literal::F32(value) => Literal::F32(f32::from_bits(value.to_bits() ^ 1 << bit)),
                Literal::U32(value) if bit < 32 => Literal::U32(value ^ 1 << bit),
                Literal::I32(value) if bit < 32 => Literal::I32(value ^ 1 << bit),
                _ => continue,
            };
            if is_used && error(at, changed) == 0 {
                let text = |literal| match literal {
                    Literal::F64(value) => value.to_string(),
                    Literal::F32(value) => value.to_string(),
                    other => format!("{other:?}"),
                };
                found.insert(format!("{} of {}", text(changed), text(*leaf)));
            }
        }
    }
    found.into_iter().collect()
}

fn real<R: Real>(value: f64) -> Literal {
    #[expect(clippy::cast_possible_truncation, reason = "a number of that type")]
    if R::KIND == RealKind::F64 { Literal::F64(value) } else { Literal::F32(value as f32) }
}

fn build<T: Portable>(mut leaves: impl Iterator<Item = Literal>) -> T {
    T::build(&mut || leaves.next().unwrap_or_else(|| panic!("all scalars of the type")))
}

/// An axis has the same blocks with sets as with constants. What never acts takes none.
#[test]
fn sets_leave_the_blocks_of_an_axis_as_they_are() {
    let of = |changes: &[(&str, &str)]| generator::blocks::names(&axis(changes).axis);
    let loops = ("getriebe = [{ dynamik", "getriebe = [{ kv = 2000, dynamik");
    let feedforward = ("watch = true", "vorsteuer.vorsteuerung = \"VEL\"");
    let constants = ("tunable = \"all\"", "tunable = \"nothing\"");
    assert_eq!(of(&[]), ["ipc"]);
    let whole = ["ipc", "feedforward", "position_control", "axis"];
    assert_eq!([of(&[loops, feedforward, constants]), of(&[loops, feedforward])], [whole, whole]);
    let inactive = ("mode = \"DIRECT\"", "mode = \"NOT_ACTIVE\"");
    let other = ("mode = \"SET_POINT\"", "mode = \"NOT_ACTIVE\"");
    assert_eq!(of(&[loops, feedforward, inactive, other]), ["feedforward", "position_control", "axis"]);
}

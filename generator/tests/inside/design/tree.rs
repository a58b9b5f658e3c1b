//! The whole tree of coefficients: what is copied, what stays 0, the limit, the fade, single precision, the notes.

use crate::inside::sets::axes;
use generator::axis::{Axis, Filter, Mode, Prototype};
use generator::blocks::ipc::design::{design, fade_cycles};
use generator::blocks::{Designed, named};
use generator::design::rounding::rounded;
use portable::{Extreme, Literal, Portable, RealKind, Ty};
use reference::ipc::Coeffs;

fn axis() -> Axis {
    axes(1, RealKind::F64).next().expect("one axis")
}

fn notes(axis: Axis) -> Vec<(String, String)> {
    named("ipc").expect("the registry has it").notes(&Designed::from(axis))
}

fn ipc(axis: &Axis) -> Coeffs<f64> {
    design(axis).1
}

/// Each scalar with its path.
fn leaves<T: Portable>(value: &T) -> Vec<(String, Literal)> {
    let mut paths = Vec::new();
    walk(&T::TY, "", &mut paths);
    let mut literals = Vec::new();
    value.visit(&mut |literal| literals.push(literal));
    assert_eq!(paths.len(), literals.len());
    paths.into_iter().zip(literals).collect()
}

fn walk(ty: &Ty, path: &str, paths: &mut Vec<String>) {
    match ty {
        Ty::Struct { def } => {
            for field in def.fields {
                let dot = if path.is_empty() { "" } else { "." };
                walk(&field.ty, &format!("{path}{dot}{}", field.name), paths);
            }
        }
        Ty::Array { element, len } => (0..*len).for_each(|i| walk(element, &format!("{path}[{i}]"), paths)),
        _ => paths.push(path.to_owned()),
    }
}

#[test]
#[expect(clippy::cast_possible_truncation, reason = "this is the rounding that is tested")]
fn single_precision_is_double_precision_rounded_once() {
    for axis in axes(500, RealKind::F32) {
        let double = leaves(&ipc(&Axis { real: RealKind::F64, ..axis.clone() }));
        let single = leaves(&rounded::<_, Coeffs<f32>>(&ipc(&axis), RealKind::F32));
        assert_eq!(double.len(), single.len());
        for ((path, double), (_, single)) in double.into_iter().zip(single) {
            let expected = match double {
                // another constant, 2^-40 in place of 2^-60
                Literal::F64(value) if path == "rest" => Literal::F32((value * 1_048_576.0) as f32),
                Literal::F64(value) => Literal::F32(value as f32),
                other => other,
            };
            assert_eq!(single, expected, "{path}");
        }
    }
}

#[test]
fn what_is_not_used_is_0() {
    for axis in axes(500, RealKind::F64) {
        let coeffs = ipc(&axis);
        for (stage, coeffs) in axis.ipc.stage.iter().zip(&coeffs.stage) {
            let Some(stage) = stage else {
                assert!(leaves(coeffs).iter().all(|(_, literal)| is_zero(*literal)));
                continue;
            };
            let simulated = !matches!(stage.mode, Mode::Direct { .. });
            assert_eq!(simulated, !leaves(&coeffs.oscillation).iter().all(|(_, literal)| is_zero(*literal)));
            for (filter, coeffs) in stage.filter.iter().zip(&coeffs.filter) {
                let allpass = !leaves(&coeffs.allpass).iter().all(|(_, literal)| is_zero(*literal));
                let sections = coeffs.bandpass.iter().filter(|s| s.b2 < 0.0).count();
                match filter {
                    Filter::NoFilter => assert!(!allpass && sections == 0 && coeffs.order == 0),
                    Filter::Allpass { .. } => assert!(allpass && sections == 0 && coeffs.order == 0),
                    Filter::Bandpass { order, .. } => assert!(!allpass && sections == *order && coeffs.order == *order),
                }
            }
        }
    }
}

fn is_zero(literal: Literal) -> bool {
    [Literal::F64(0.0), Literal::Usize(0), Literal::I32(0)].contains(&literal.at_run_time())
}

#[test]
fn what_is_given_is_copied() {
    for axis in axes(200, RealKind::F64) {
        let coeffs = ipc(&axis);
        assert_eq!(coeffs.cycle_time_ns, axis.cycle_time_ns);
        assert_eq!(coeffs.enable, axis.ipc.enable as i32);
        for (stage, coeffs) in axis.ipc.stage.iter().zip(&coeffs.stage) {
            let weight = stage.as_ref().map_or(0.0, |stage| f64::from(stage.weight_fact_num) / 100.0);
            assert_eq!(coeffs.gain.to_bits(), if weight > 0.0 { -weight.smaller(7.0) } else { 0.0 }.to_bits());
        }
    }
}

#[test]
fn limit_and_rest() {
    let mut axis = axis();
    axis.ipc.v_max = 200_000.0;
    axis.ipc.v_add_max_fact = 333;
    let coeffs = ipc(&axis);
    assert_eq!([coeffs.limit, coeffs.lower_limit].map(f64::to_bits), [66_600.0, -66_600.0_f64].map(f64::to_bits));
    assert_eq!(coeffs.rest.to_bits(), (200_000.0 / 1_152_921_504_606_846_976.0_f64).to_bits());
    let single = Axis { real: RealKind::F32, ..axis.clone() };
    assert_eq!(ipc(&single).rest.to_bits(), (200_000.0 / 1_099_511_627_776.0_f64).to_bits());
    axis.ipc.v_add_max_fact = 0;
    let coeffs = ipc(&axis);
    assert_eq!([coeffs.limit, coeffs.lower_limit].map(f64::to_bits), [0, 0]); // both are +0
}

#[test]
fn fade_is_rounded_up_to_whole_cycles() {
    let mut axis = axis();
    axis.ipc.stage = [None, None, None];
    let rows = [
        (0.1, 1_000_000, 100),
        (0.1, 62_500, 1_600),
        (0.3, 100_000, 3_000),
        (0.7, 100_000, 7_000),
        (0.1, 300_000, 334), // 333.33
        (0.1000001, 1_000_000, 101),
        (0.0, 1_000_000, 1),
        (1048.576, 62_500, 16_777_216), // 2^24
    ];
    for (fade, ns, cycles) in rows {
        axis.ipc.fade = fade;
        axis.cycle_time_ns = ns;
        assert_eq!(fade_cycles(&axis), cycles, "{fade} s, {ns} ns");
        let coeffs = ipc(&axis);
        assert_eq!(coeffs.fade_cycles, cycles);
        assert_eq!(coeffs.fade_step.to_bits(), (1.0 / f64::from(cycles)).to_bits());
    }
    // every whole number of milliseconds and of 62.5 us, written as a decimal number
    for n in 1..=20_000_u32 {
        for ns in [1_000_000, 62_500] {
            axis.cycle_time_ns = ns;
            axis.ipc.fade = f64::from(n) * f64::from(ns) / 1e9;
            assert_eq!(fade_cycles(&axis), n);
            axis.ipc.fade = format!("{:.7}", axis.ipc.fade).parse().expect("a number");
            assert_eq!(fade_cycles(&axis), n);
        }
    }
}

#[test]
fn fade_lasts_at_least_one_period_of_the_lowest_filter() {
    let mut axis = axis();
    axis.cycle_time_ns = 1_000_000;
    axis.ipc.fade = 0.1;
    let mut stage = axis.ipc.stage[0].take().expect("the first axis has a first stage");
    let bandpass = Filter::Bandpass { prototype: Prototype::Bessel, order: 2, f0: 20.0, q_factor: 2.0 };
    stage.filter = [bandpass, Filter::NoFilter];
    axis.ipc.stage = [None, Some(stage.clone()), None];
    assert_eq!(fade_cycles(&axis), 100);
    stage.filter[1] = Filter::Allpass { f0: 4.0, q_factor: 2.0 };
    axis.ipc.stage[2] = Some(stage);
    assert_eq!(fade_cycles(&axis), 250);
}

/// A reviewer finds each note next to a number: its path is one of the tree, in the tree's order.
#[test]
fn notes_name_paths_of_the_tree_in_its_order() {
    for axis in axes(300, RealKind::F64) {
        let paths: Vec<_> = leaves(&ipc(&axis)).into_iter().map(|(path, _)| path).collect();
        let mut last = 0;
        for (prefix, text) in notes(axis.clone()) {
            let place = paths.iter().position(|path| {
                path.strip_prefix(prefix.as_str()).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
            });
            let place = place.unwrap_or_else(|| panic!("{prefix} is not a path of the coefficients"));
            assert!(place >= last, "{prefix}");
            last = place;
            assert!(text.is_ascii() && !text.contains('\n') && !text.is_empty(), "{text}");
        }
    }
}

#[test]
fn a_note_says_what_a_filter_is() {
    let mut axis = axis();
    axis.cycle_time_ns = 1_000_000;
    let mut stage = axis.ipc.stage[0].take().expect("the first axis has a first stage");
    stage.mode = Mode::Indirect { osc_damping: 0.8 };
    stage.filter = [
        Filter::Bandpass { prototype: Prototype::Butterworth, order: 3, f0: 53.0, q_factor: 10.0 },
        Filter::Allpass { f0: 7.5, q_factor: 2.0 },
    ];
    (stage.weight_fact_num, stage.weight_fact_denom) = (900, 100);
    axis.ipc.stage = [Some(stage), None, None];
    let notes = notes(axis);
    let of = |path: &str| notes.iter().find(|(found, _)| found == path).expect("the path has a note").1.as_str();
    assert_eq!(
        of("stage[0]"),
        "INDIRECT (P-AXIS-00753) from v_motor, weight 900/100 = 9 (P-AXIS-00754/00755), capped at 7"
    );
    assert_eq!(
        of("stage[0].oscillation"),
        "simulated oscillation of the load, f0 of the first BANDPASS 53 Hz (P-AXIS-00751), damping ratio 0.8 \
         (P-AXIS-00850): gain 1 at DC, 1.179248 and -32.00538 deg at f0"
    );
    assert_eq!(
        of("stage[0].filter[0]"),
        "BANDPASS BUTTERWORTH order 3 (P-AXIS-00849, 00848, 00750): centre frequency 53 Hz (P-AXIS-00751), quality \
         factor 10 (P-AXIS-00752), -3 dB at 50.41374 and 55.71374 Hz"
    );
    assert_eq!(
        of("stage[0].filter[0].bandpass[1]"),
        "section 2 of 3: centre frequency 50.75209 Hz, quality factor 19.64969, gain 2.001947 at its centre and 1 at 53 Hz"
    );
    assert_eq!(
        of("stage[0].filter[1]"),
        "ALLPASS (P-AXIS-00849): -180 deg at 7.5 Hz (P-AXIS-00751), quality factor 2 (P-AXIS-00752), -90 deg at \
         5.855655 and -270 deg at 9.605655 Hz"
    );
    assert!(notes.iter().all(|(path, _)| !path.starts_with("stage[1]")), "what is not there has no note");
}

//! What a text does: the same as equivalent Rust, to the last bit.

use crate::support::{LREAL, answers, block};
use portable::{Literal, Real, RealKind};
use st::{Dialect, Signal};

const BIQUAD: &str = include_str!("forms/biquad.st");

/// A REAL block assigns its literals first, and does one operation a statement.
const BIQUAD_SINGLE: &str = include_str!("forms/biquad_single.st");

/// Random bits: a third of them as they are, NaN and infinities among them.
fn random_reals<R: Real>(count: usize, of: impl Fn(u64) -> R) -> Vec<R> {
    let mut seed = 1u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        seed ^ (seed >> 29)
    };
    let mut reals: Vec<R> = Vec::new();
    while reals.len() < count {
        let bits = next();
        reals.push(match bits % 3 {
            0 => of(next()),
            1 => R::from_u32(u32::try_from(next() >> 33).expect("31 bits")),
            _ => -R::from_u32(u32::try_from(next() >> 40).expect("24 bits")) / R::lit(7.0),
        });
    }
    reals
}

fn is_nan(literal: Literal) -> bool {
    matches!(literal, Literal::F64(value) if value.is_nan()) || matches!(literal, Literal::F32(value) if value.is_nan())
}

fn biquad<R: Real>(text: &str, [b0, b1, a1, a2]: [R; 4], inputs: &[R]) {
    let block = block(Dialect::Plain, text, "biquad", R::KIND);
    let (mut samples, mut zero) = (Vec::new(), LREAL);
    inputs.iter().for_each(|&x| x.visit(&mut |literal| samples.push(vec![literal])));
    R::ZERO.visit(&mut |literal| zero = literal);
    let answers = answers(&block, &[("x", zero)], &samples, &[("y", zero)], &[]);
    let (mut s1, mut s2) = (R::ZERO, R::ZERO);
    for (&x, answer) in inputs.iter().zip(&answers) {
        let y = b0 * x + s1;
        s1 = b1 * x - a1 * y + s2;
        s2 = b0 * x - a2 * y;
        // Which NaN comes out of two is left open by IEEE 754 and by Rust.
        y.visit(&mut |literal| {
            assert!(*answer == [literal] || is_nan(answer[0]) && is_nan(literal), "{answer:?} {literal:?}")
        });
    }
}

#[test]
fn a_biquad_in_both_precisions() {
    let coefficients =
        [0.067_455_273_889_071_9, 0.134_910_547_778_143_8, -1.142_980_502_539_901_1, 0.412_801_598_096_188_66];
    // A finite signal in full, then one whose infinities and NaNs come at some sample.
    let finite = |real: &f64| real.abs() < 1e300;
    let doubles = random_reals(15_000, f64::from_bits);
    let kept: Vec<f64> = doubles.iter().copied().filter(finite).take(10_000).collect();
    assert_eq!(kept.len(), 10_000);
    biquad(BIQUAD, coefficients, &kept);
    biquad(BIQUAD, coefficients, &doubles);
    let singles = random_reals(15_000, |bits| f32::from_bits(u32::try_from(bits >> 32).expect("32 bits")));
    let kept: Vec<f32> = singles.iter().copied().filter(|real| real.abs() < 1e30).take(10_000).collect();
    assert_eq!(kept.len(), 10_000);
    let coefficients = [0.067_455_27, 0.134_910_55, -1.142_980_5, 0.412_801_6];
    biquad(BIQUAD_SINGLE, coefficients, &kept);
    biquad(BIQUAD_SINGLE, coefficients, &singles);
}

/// What each expression gives for the inputs, as outputs of the type of a value.
fn values(of: Literal, expressions: &[&str], inputs: &[Literal]) -> Vec<Literal> {
    let name = |value| match value {
        Literal::Bool(_) => "BOOL",
        Literal::I32(_) => "DINT",
        Literal::U32(_) => "UDINT",
        _ => "LREAL",
    };
    let names = ["a", "b", "c"];
    let signals: Vec<Signal<'_>> = names.into_iter().zip(inputs.iter().copied()).collect();
    let results: Vec<String> = (0..expressions.len()).map(|at| format!("y{at}")).collect();
    let outputs: Vec<Signal<'_>> = results.iter().map(|result| (result.as_str(), of)).collect();
    let declared = |list: &[Signal<'_>]| -> String {
        list.iter().map(|&(signal, value)| format!("    {signal} : {};\n", name(value))).collect()
    };
    let body: String = results.iter().zip(expressions).map(|(y, x)| format!("{y} := {x};\n")).collect();
    let text = format!(
        "FUNCTION_BLOCK probe\nVAR_INPUT\n{}END_VAR\nVAR_OUTPUT\n{}END_VAR\n{body}END_FUNCTION_BLOCK\n",
        declared(&signals),
        declared(&outputs),
    );
    let block = block(Dialect::Plain, &text, "probe", RealKind::F64);
    answers(&block, &signals, &[inputs.to_vec()], &outputs, &[]).remove(0)
}

#[test]
fn operators_of_reals_group_as_in_the_standard() {
    let (a, b, c) = (0.1, 1e16, -7.3);
    let list = [
        ("a - b + c", a - b + c),
        ("a - (b + c)", a - (b + c)),
        ("a -b", a - b),
        ("a -1.5", a - 1.5),
        ("a--1.5", a + 1.5),
        ("a / b * c", a / b * c),
        ("a / (b * c)", a / (b * c)),
        ("a * b / c", a * b / c),
        ("a + b * c", a + b * c),
        ("(a + b) * c", (a + b) * c),
        ("-a * b", -a * b),
        ("-(a - c)", -(a - c)),
        ("- a + c", -a + c),
        ("a - -c", a - -c),
        ("-1.0 * 0.0", -0.0),
        ("(-1.0 * 0.0) - 0.0", -0.0),
        ("-1.0 * 0.0 * a", -0.0),
        ("1.0 / (-1.0 * 0.0)", f64::NEG_INFINITY),
        ("1.5 * 2.0E-30 * 1.0E-30", 1.5 * 2.0e-30 * 1.0e-30),
        ("-1.5 * a", -1.5 * a),
        ("(-1.5) * a", -1.5 * a),
        ("0.1 + 0.2", 0.1 + 0.2),
    ];
    let expected: Vec<Literal> = list.iter().map(|&(_, value)| Literal::F64(value)).collect();
    let found = values(LREAL, &list.map(|(text, _)| text), &[a, b, c].map(Literal::F64));
    assert_eq!(found, expected);
}

#[test]
fn operators_of_bools_group_as_in_the_standard() {
    for bits in 0..8u8 {
        let [a, b, c] = [1, 2, 4].map(|bit| bits & bit != 0);
        let list = [
            ("NOT a AND b", !a && b),
            ("a AND NOT b", a && !b),
            ("a OR b AND c", a || b && c),
            ("(a OR b) AND c", (a || b) && c),
            ("a AND b OR c", a && b || c),
            ("a AND b = c", a && (b == c)),
            ("a = b OR c <> a", (a == b) || (c != a)),
            ("TRUE AND a OR FALSE", a),
        ];
        let expected: Vec<Literal> = list.iter().map(|&(_, value)| Literal::Bool(value)).collect();
        assert_eq!(values(Literal::Bool(false), &list.map(|(text, _)| text), &[a, b, c].map(Literal::Bool)), expected);
    }
}

#[test]
fn comparisons_with_a_nan_are_false() {
    let list = ["a < b", "a <= b", "a > b", "a >= b", "a = b", "a <> b", "b - b <= a"];
    let compare = |a: f64, b: f64| {
        let (at_most, same) = (a <= b, a.partial_cmp(&b) == Some(std::cmp::Ordering::Equal));
        [a < b, at_most, a > b, a >= b, same, !same, b - b <= a]
    };
    for (a, b) in
        [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::NAN, f64::NAN), (0.0, -0.0), (1.0, 2.0), (f64::INFINITY, 2.0)]
    {
        let expected = compare(a, b).map(Literal::Bool);
        assert_eq!(values(Literal::Bool(false), &list, &[a, b].map(Literal::F64)), expected, "{a} {b}");
    }
}

#[test]
fn integers_wrap_around() {
    for (a, b) in [(i32::MAX, 1), (i32::MIN, -1), (46_341, 46_341), (-7, 3)] {
        let list = ["a + b", "a - b", "a * b", "-a", "a + 1", "a - -1", "16#7FFFFFFF + a", "-2147483647 - a"];
        let expected = [
            a.wrapping_add(b),
            a.wrapping_sub(b),
            a.wrapping_mul(b),
            a.wrapping_neg(),
            a.wrapping_add(1),
            a.wrapping_add(1),
            i32::MAX.wrapping_add(a),
            (i32::MIN + 1).wrapping_sub(a),
        ];
        assert_eq!(values(Literal::I32(0), &list, &[a, b].map(Literal::I32)), expected.map(Literal::I32));
        let list = ["a < b", "a <= b", "a > b", "a >= b", "a = b", "a <> b", "a < 0"];
        let expected = [a < b, a <= b, a > b, a >= b, a == b, a != b, a < 0];
        assert_eq!(values(Literal::Bool(false), &list, &[a, b].map(Literal::I32)), expected.map(Literal::Bool));
        let list = ["DINT_TO_LREAL(a)", "DINT_TO_LREAL(a * b) * 0.1"];
        let expected = [f64::from(a), f64::from(a.wrapping_mul(b)) * 0.1];
        assert_eq!(values(LREAL, &list, &[a, b].map(Literal::I32)), expected.map(Literal::F64));
    }
    for a in [7, -7, 6, -6, 0, i32::MAX, i32::MIN] {
        let list = ["a / 3", "a MOD 3", "a / 1", "a MOD 1", "a * 5 MOD 16#10 / 2", "-a / 2147483647", "a - a / 7 * 7"];
        let expected = [a / 3, a % 3, a, 0, a.wrapping_mul(5) % 16 / 2, a.wrapping_neg() / i32::MAX, a % 7];
        assert_eq!(values(Literal::I32(0), &list, &[Literal::I32(a)]), expected.map(Literal::I32));
    }
    for (a, b) in [(u32::MAX, 1), (0, 1), (65_536, 65_536), (7, 3)] {
        let list = ["a + b", "a - b", "a * b", "a + 4294967295", "16#FFFFFFFF - b"];
        let expected = [
            a.wrapping_add(b),
            a.wrapping_sub(b),
            a.wrapping_mul(b),
            a.wrapping_add(u32::MAX),
            u32::MAX.wrapping_sub(b),
        ];
        assert_eq!(values(Literal::U32(0), &list, &[a, b].map(Literal::U32)), expected.map(Literal::U32));
        let list = ["a < b", "a <= b", "a > b", "a >= b", "a = b", "a <> b", "a > 2147483648"];
        let expected = [a < b, a <= b, a > b, a >= b, a == b, a != b, a > 1 << 31];
        assert_eq!(values(Literal::Bool(false), &list, &[a, b].map(Literal::U32)), expected.map(Literal::Bool));
        let list = ["a / 3", "a MOD 3", "a / 2147483648", "(a MOD 16#10) / 2", "a - (a / 7) * 7"];
        let expected = [a / 3, a % 3, a >> 31, a % 16 / 2, a % 7];
        assert_eq!(values(Literal::U32(0), &list, &[a, b].map(Literal::U32)), expected.map(Literal::U32));
        let found = values(LREAL, &["UDINT_TO_LREAL(a - b)"], &[a, b].map(Literal::U32));
        assert_eq!(found, [Literal::F64(f64::from(a.wrapping_sub(b)))]);
    }
}

#[test]
fn a_choice_takes_the_first_arm_that_holds_and_state_stays() {
    let text = include_str!("forms/counter.st");
    let block = block(Dialect::Plain, text, "COUNTER", RealKind::F64);
    let inputs = [3, 4, -2, 0, 5];
    let samples = inputs.map(|n| vec![Literal::I32(n)]);
    let whole = Literal::I32(0);
    let found = |set| answers(&block, &[("N", whole)], &samples, &[("y", whole)], set).concat();
    assert_eq!(found(&[("up", true)]), [3, 7, -1, 7, 12].map(Literal::I32));
    // No initial value of a plain file counts: `up` is FALSE.
    assert_eq!(found(&[]), [5, 5, -1, 0, 5].map(Literal::I32));
}

#[test]
fn a_conversion_to_single_precision_rounds_once() {
    let text = "FUNCTION_BLOCK probe\nVAR_INPUT\n    n : DINT;\n    u : UDINT;\nEND_VAR\nVAR_OUTPUT\n    y : REAL;\n    z : REAL;\n\
                END_VAR\ny := DINT_TO_REAL(n);\nz := UDINT_TO_REAL(u);\nEND_FUNCTION_BLOCK\n";
    let block = block(Dialect::Plain, text, "probe", RealKind::F32);
    let inputs = [("n", Literal::I32(-16_777_217)), ("u", Literal::U32(4_294_967_167))];
    let single = Literal::F32(0.0);
    let found =
        answers(&block, &inputs, &[inputs.map(|(_, value)| value).to_vec()], &[("y", single), ("z", single)], &[]);
    assert_eq!(found, [[Literal::F32(-16_777_216.0), Literal::F32(4_294_967_040.0)]]);
}

/// Of each type, and of a copy of the array; outside of it the value is one that nothing else has.
#[test]
fn an_element_of_an_array() {
    let text = "FUNCTION_BLOCK \"probe\"\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\n\
        VAR_INPUT\n    x : LREAL;\n    i : DINT;\n    u : UDINT;\nEND_VAR\n\
        VAR_OUTPUT\n    y : LREAL;\n    j : DINT;\n    q : BOOL;\nEND_VAR\n\
        VAR\n    k : ARRAY[0..2] OF LREAL;\n    m : ARRAY[0..2] OF LREAL;\n\
        \x20   n : ARRAY[0..2] OF DINT;\n    p : ARRAY[0..2] OF BOOL;\nEND_VAR\nBEGIN\n\
        #k[0] := #x;\n#k[1] := #x + #x;\n#k[2] := #k[0] + #k[1];\n#n[1] := #i;\n#p[2] := TRUE;\n\
        #m := #k;\n#k[2] := 0.0;\n#y := #m[UDINT_TO_DINT(#u)];\n#j := #n[#i];\n#q := #p[#i];\nEND_FUNCTION_BLOCK\n";
    let block = block(Dialect::Scl, text, "probe", RealKind::F64);
    let inputs = [("x", LREAL), ("i", Literal::I32(0)), ("u", Literal::U32(0))];
    let outputs = [("y", LREAL), ("j", Literal::I32(0)), ("q", Literal::Bool(false))];
    let sample = |index: u32| vec![Literal::F64(5.0), Literal::I32(index.cast_signed()), Literal::U32(index)];
    let inside = answers(&block, &inputs, &[0, 1, 2].map(sample), &outputs, &[]);
    let expected = [(5.0, 0, false), (10.0, 1, false), (15.0, 0, true)];
    for (answer, (y, j, q)) in inside.iter().zip(expected) {
        assert_eq!(*answer, [Literal::F64(y), Literal::I32(j), Literal::Bool(q)]);
    }
    let outside = answers(&block, &inputs, &[3, u32::MAX].map(sample), &outputs, &[]);
    assert!(outside.iter().all(|answer| is_nan(answer[0]) && answer[1] == Literal::I32(0x5555_5555)), "{outside:?}");
}

//! REAL evaluated as compilers may do it, held against the same in Rust. The texts are read as LREAL and called REAL then.

use crate::{Block, Dialect};
use portable::{Literal, RealKind};

/// The block of a text with these statements, and with variables of each type.
fn read(dialect: Dialect, body: &str, others: &[Block]) -> Block {
    let declared = "FUNCTION_BLOCK probe\nVAR_INPUT\n    a : LREAL;\n    b : LREAL;\n    c : LREAL;\n    n : DINT;\n    u : UDINT;\nEND_VAR\n\
         VAR_OUTPUT\n    y : LREAL;\n    q : BOOL;\n    k : DINT;\nEND_VAR\nVAR\n    t : LREAL;\n    p : BOOL;\nEND_VAR\n";
    let inner = if others.is_empty() { "" } else { "VAR\n    inner : probe;\n    other : probe;\nEND_VAR\n" };
    let text = match dialect {
        Dialect::TwinCat => format!(
            "<TcPlcObject><POU Name=\"probe\"><Declaration><![CDATA[{declared}{inner}]]></Declaration><Implementation><ST>\
             <![CDATA[{body}]]></ST></Implementation></POU></TcPlcObject>"
        ),
        _ => format!("{declared}{inner}{body}\nEND_FUNCTION_BLOCK\n"),
    };
    Block::read_with(dialect, &text, "probe", RealKind::F64, others).unwrap()
}

/// The same block, with other reals.
fn of(real: RealKind, mut block: Block) -> Block {
    block.variables.real = real;
    block
}

/// A block of REAL.
fn single(body: &str) -> Block {
    of(RealKind::F32, read(Dialect::Plain, body, &[]))
}

/// What a sample consists of.
#[derive(Clone, Copy, Debug)]
struct Sample {
    a: f32,
    b: f32,
    c: f32,
    n: i32,
    u: u32,
}

/// Numbers with all their digits, integers beyond 2^24, and products near the third number.
fn samples() -> Vec<Sample> {
    let mut seed = 1u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        u32::try_from(seed >> 32).unwrap()
    };
    let mut real = |exponent: u32| f32::from_bits((next() & 0x807f_ffff) | (exponent << 23));
    let mut sample = |at: u32| {
        let (a, b) = (real(127 + at % 3), real(126));
        let c = if at.is_multiple_of(2) { real(126 + at % 5) } else { a * b };
        Sample { a, b, c, n: c.to_bits().cast_signed(), u: c.to_bits() | 1 }
    };
    let mut samples: Vec<Sample> = (0..2000).map(&mut sample).collect();
    // a * b + c is below the middle of two REALs by less than half of the last bit of a double.
    let (step, scale) = (f32::EPSILON, 1.0 / 4096.0);
    samples.push(Sample { a: (1.0 + step) * scale, b: (1.0 - step) * scale, c: 1.0 + step, n: 0, u: 0 });
    samples
}

/// Holds an output against what it should be; how many of the samples `other` says something else of.
fn agree<T: PartialEq + std::fmt::Debug>(
    block: &Block,
    (output, start): (&str, Literal),
    of: impl Fn(Literal) -> T,
    (expected, other): (impl Fn(Sample) -> T, impl Fn(Sample) -> T),
) -> usize {
    let (real, whole) = (Literal::F32(0.0), Literal::I32(0));
    let inputs = [("a", real), ("b", real), ("c", real), ("n", whole), ("u", Literal::U32(0))];
    let mut instance = block.start(&inputs, &[(output, start)], &[]).unwrap();
    let (mut differing, mut found) = (0, Vec::new());
    for sample in samples() {
        let Sample { a, b, c, n, u } = sample;
        let values = [Literal::F32(a), Literal::F32(b), Literal::F32(c), Literal::I32(n), Literal::U32(u)];
        instance.cycle(&values, &mut found);
        assert_eq!(of(found[0]), expected(sample), "{sample:?}");
        differing += usize::from(expected(sample) != other(sample));
    }
    differing
}

/// The bits of a REAL.
fn bits(value: Literal) -> u32 {
    let Literal::F32(value) = value else { panic!("{value:?} is no REAL") };
    value.to_bits()
}

fn is_true(value: Literal) -> bool {
    value == Literal::Bool(true)
}

/// What `y` of a block should be, and what it is where it is evaluated as written, or otherwise; both must differ somewhere.
fn reals(block: &Block, expected: impl Fn(Sample) -> f32, other: impl Fn(Sample) -> f32) {
    let differing = agree(
        block,
        ("y", Literal::F32(0.0)),
        bits,
        (|sample: Sample| expected(sample).to_bits(), |sample: Sample| other(sample).to_bits()),
    );
    assert!(differing > 10, "{differing} samples tell the evaluations apart");
}

/// A double, rounded once.
#[expect(clippy::cast_possible_truncation, reason = "that is what it does")]
fn rounded(value: f64) -> f32 {
    value as f32
}

/// The sum of a product as doubles.
fn sum(s: Sample) -> f64 {
    f64::from(s.a) * f64::from(s.b) + f64::from(s.c)
}

#[test]
fn a_wide_statement_rounds_once_where_its_variable_is_assigned() {
    let text = "y := a * b + c;";
    reals(&single(text), |s| s.a * s.b + s.c, |s| rounded(sum(s)));
    reals(&single(text).wide(), |s| rounded(sum(s)), |s| s.a * s.b + s.c);
    reals(&single("t := a * b;\ny := t + c;").wide(), |s| s.a * s.b + s.c, |s| rounded(sum(s)));
    let negated = |s: Sample| rounded(-(f64::from(s.a) * f64::from(s.b)) / f64::from(s.c) - f64::from(s.a));
    reals(&single("y := -(a * b) / c - a;").wide(), negated, |s| -(s.a * s.b) / s.c - s.a);
}

#[test]
fn a_wide_conversion_rounds_where_its_variable_is_assigned() {
    let exact = |s: Sample| rounded(f64::from(s.n) * f64::from(s.a));
    #[expect(clippy::cast_precision_loss, reason = "that is what is tested")]
    let early = |s: Sample| s.n as f32 * s.a;
    reals(&single("y := DINT_TO_LREAL(n) * a;").wide(), exact, early);
    reals(&single("y := DINT_TO_LREAL(n) * a;"), early, exact);
    reals(&single("t := DINT_TO_LREAL(n);\ny := t * a;").wide(), early, exact);
    let exact = |s: Sample| rounded(f64::from(s.u) - f64::from(s.c));
    #[expect(clippy::cast_precision_loss, reason = "that is what is tested")]
    let early = |s: Sample| s.u as f32 - s.c;
    reals(&single("y := UDINT_TO_LREAL(u) - c;").wide(), exact, early);
}

#[test]
fn wide_comparisons_and_truncations_see_what_is_not_rounded() {
    let wide = |s: Sample| f64::from(s.a) * f64::from(s.b) > f64::from(s.c);
    let own = |s: Sample| s.a * s.b > s.c;
    let output = ("q", Literal::Bool(false));
    let text = "q := a * b > c;";
    assert!(agree(&single(text).wide(), output, is_true, (wide, own)) > 10);
    assert!(agree(&single(text), output, is_true, (own, wide)) > 10);
    let whole = |literal| if let Literal::I32(value) = literal { value } else { panic!("{literal:?} is no DINT") };
    #[expect(clippy::cast_possible_truncation, reason = "that is what is tested")]
    let wide = |s: Sample| (f64::from(s.a) * 16_777_217.0 + f64::from(s.c)) as i32;
    #[expect(clippy::cast_possible_truncation, reason = "that is what is tested")]
    let own = |s: Sample| (s.a * 16_777_216.0 + s.a + s.c) as i32;
    let text = "k := TRUNC(a * 16777216.0 + a + c);";
    assert!(agree(&single(text).wide(), ("k", Literal::I32(0)), whole, (wide, own)) > 10);
}

#[test]
fn an_argument_rounds() {
    let (wide, own) = (|s: Sample| s.a * s.b + s.c, |s: Sample| rounded(sum(s)));
    let inner = read(Dialect::Plain, "y := a + b;", &[]);
    let outer = read(Dialect::Plain, "inner(a := a * b, b := c);\ny := inner.y;", &[inner]);
    reals(&of(RealKind::F32, outer).wide(), wide, own);
    let text = "q := F_axgen_in_range_LREAL(value := a * b, largest := c);";
    let block = of(RealKind::F32, read(Dialect::TwinCat, text, &[])).wide();
    let rounded = |s: Sample| -s.c <= s.a * s.b && s.a * s.b <= s.c;
    let exact = |s: Sample| (f64::from(s.a) * f64::from(s.b)).abs() <= f64::from(s.c);
    assert!(agree(&block, ("q", Literal::Bool(false)), is_true, (rounded, exact)) > 10);
}

#[test]
fn fused_operations_round_once_in_either_precision() {
    let text = "y := a * b + c;";
    let block = single(text).contracted(None).unwrap();
    reals(&block, |s| s.a.mul_add(s.b, s.c), |s| s.a * s.b + s.c);
    let twice = |s: Sample| rounded(f64::from(s.a).mul_add(f64::from(s.b), f64::from(s.c)));
    assert!(samples().into_iter().any(|s| s.a.mul_add(s.b, s.c).to_bits() != twice(s).to_bits()));
    // In double precision a product of two REALs is exact.
    reals(&block.wide(), |s| rounded(sum(s)), |s| s.a * s.b + s.c);
    let three = single("y := a * b * c - a;").wide();
    let exact = |s: Sample| f64::from(s.a) * f64::from(s.b);
    let (a, c) = (|s: Sample| f64::from(s.a), |s: Sample| f64::from(s.c));
    let fused = |s: Sample| rounded(exact(s).mul_add(c(s), -a(s)));
    assert!(three.clone().contracted(Some(1)).is_none());
    agree(&three.contracted(None).unwrap(), ("y", Literal::F32(0.0)), bits, (|s| fused(s).to_bits(), |_| 0));
}

#[test]
fn a_block_keeps_its_evaluation_as_an_instance() {
    let inner = single("y := a * b + c;");
    let (wide, fused) = (inner.clone().wide(), inner.contracted(None).unwrap());
    // The second instance shows that the first one has slots of its own.
    let call = "inner(a := b, b := a, c := c);\nother(a := c, b := a, c := a);\n";
    let outer = |inner: &Block, statement: &str| {
        let inner = of(RealKind::F64, inner.clone());
        of(RealKind::F32, read(Dialect::Plain, &format!("{call}{statement}"), &[inner]))
    };
    reals(&outer(&wide, "y := inner.y;"), |s| rounded(sum(s)), |s| s.a * s.b + s.c);
    reals(&outer(&fused, "y := inner.y;"), |s| s.a.mul_add(s.b, s.c), |s| s.a * s.b + s.c);
    reals(&outer(&fused, "y := other.y;"), |s| s.c.mul_add(s.a, s.a), |s| s.c * s.a + s.a);
    // Around it nothing is wide, and fused operations round once: not to double precision before.
    let around = outer(&wide, "y := a * b + c;");
    reals(&around, |s| s.a * s.b + s.c, |s| rounded(sum(s)));
    reals(&around.contracted(Some(2)).unwrap(), |s| s.a.mul_add(s.b, s.c), |s| s.a * s.b + s.c);
}

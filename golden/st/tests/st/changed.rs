//! Changed blocks: fused operations, and planted faults. What REAL adds is tested inside the crate.

use crate::support::{LREAL, answers, block, block_with, said};
use portable::{Literal, Real, RealKind};
use st::{Block, Dialect};

/// Numbers of which each fused operation gives other bits.
const A: f64 = 2.8;
const B: f64 = -7.8;
const C: f64 = 5.9;
const D: f64 = 3.4;

/// An LREAL block with inputs `a` to `d` and these statements.
fn reading(body: &str) -> Block {
    let text = format!(
        "FUNCTION_BLOCK probe\nVAR_INPUT\n    a : LREAL;\n    b : LREAL;\n    c : LREAL;\n    d : LREAL;\n    n : DINT;\nEND_VAR\n\
         VAR_OUTPUT\n    y : LREAL;\n    z : LREAL;\n    q : BOOL;\n    k : DINT;\nEND_VAR\n{body}\nEND_FUNCTION_BLOCK\n"
    );
    block(Dialect::Plain, &text, "probe", RealKind::F64)
}

/// What `y` and `z` are after one cycle.
fn cycle(block: &Block) -> [f64; 2] {
    let inputs = ["a", "b", "c", "d"].map(|name| (name, LREAL));
    let found = answers(block, &inputs, &[[A, B, C, D].map(Literal::F64).to_vec()], &[("y", LREAL), ("z", LREAL)], &[]);
    [found[0][0], found[0][1]].map(|value| if let Literal::F64(value) = value { value } else { f64::NAN })
}

fn bits(values: [f64; 2]) -> [u64; 2] {
    values.map(f64::to_bits)
}

#[test]
fn a_product_in_a_sum_is_fused() {
    for (text, written, fused) in [
        ("y := a * b + c;", A * B + C, A.mul_add(B, C)),
        ("y := c + a * b;", C + A * B, A.mul_add(B, C)),
        ("y := a * b - c;", A * B - C, A.mul_add(B, -C)),
        ("y := c - a * b;", C - A * B, (-A).mul_add(B, C)),
        ("y := c - (a * b);", C - A * B, (-A).mul_add(B, C)),
        // of two products the left one
        ("y := a * b + c * d;", A * B + C * D, A.mul_add(B, C * D)),
        ("y := a * b - c * d;", A * B - C * D, A.mul_add(B, -(C * D))),
        ("y := (a + b) * (c + d) + (b + d);", (A + B) * (C + D) + (B + D), (A + B).mul_add(C + D, B + D)),
        ("y := a * b * c + d;", A * B * C + D, (A * B).mul_add(C, D)),
        ("y := 1.1 * c + b;", 1.1 * C + B, 1.1f64.mul_add(C, B)),
    ] {
        let block = reading(text);
        assert_ne!(written.to_bits(), fused.to_bits(), "{text} tells nothing");
        assert_eq!(cycle(&block)[0].to_bits(), written.to_bits(), "{text}");
        for which in [None, Some(0)] {
            let changed = block.contracted(which).unwrap_or_else(|| panic!("{text}"));
            assert_eq!(cycle(&changed)[0].to_bits(), fused.to_bits(), "{text}");
            assert!(changed.contracted(None).is_none(), "{text}");
        }
        assert!(block.contracted(Some(1)).is_none(), "{text}");
    }
}

#[test]
fn nothing_else_is_fused() {
    for text in [
        "y := a * b;",
        "y := a * b;\nz := y + c;",
        "y := a * b / c;",
        "y := -(a * b) + c;",
        "y := a + b - c;",
        "q := a * b < c + d;",
        "k := n * n + n;",
        "y := -1.0 * 0.0 + a;",
        "y := DINT_TO_LREAL(n * n) + a;",
    ] {
        assert!(reading(text).contracted(None).is_none(), "{text}");
    }
}

#[test]
fn one_place_or_all() {
    let text = "IF a > b THEN\n    y := (a * b + c) * d - c * b;\nELSE\n    y := a * a + b;\nEND_IF;\nz := c * d + y;";
    let block = reading(text);
    let z = |y: f64| C * D + y;
    let (first, second) = (A.mul_add(B, C), |sum: f64| sum.mul_add(D, -(C * B)));
    let written = (A * B + C) * D - C * B;
    assert_eq!(bits(cycle(&block)), bits([written, z(written)]));
    let places = [
        [first * D - C * B, z(first * D - C * B)],
        [second(A * B + C), z(second(A * B + C))],
        // the arm that is not taken
        [written, z(written)],
        [written, C.mul_add(D, written)],
    ];
    for (which, place) in places.into_iter().enumerate() {
        let changed = block.contracted(Some(which)).unwrap_or_else(|| panic!("{which}"));
        assert_eq!(bits(cycle(&changed)), bits(place), "{which}");
    }
    assert!(block.contracted(Some(4)).is_none());
    let all = block.contracted(None).expect("it has places");
    let y = second(first);
    assert_eq!(bits(cycle(&all)), bits([y, C.mul_add(D, y)]));
    // All at once, or one after another.
    let mut block = block;
    while let Some(next) = block.contracted(Some(0)) {
        block = next;
    }
    assert_eq!(bits(cycle(&block)), bits(cycle(&all)));
}

#[test]
fn lreal_has_nothing_wider() {
    for text in ["y := a * b + c;\nz := a * b * c / d;", "y := DINT_TO_LREAL(n) + a / b;"] {
        assert_eq!(bits(cycle(&reading(text).wide())), bits(cycle(&reading(text))), "{text}");
    }
}

#[test]
fn an_assignment_is_left_out() {
    let text = "y := a;\nIF a > b THEN\n    y := y + b * c;\nELSE\n    y := d;\nEND_IF;\nCASE n OF\n    0: z := y * d;\nEND_CASE;\nk := TRUNC(d);";
    let block = reading(text);
    let y = A + B * C;
    assert_eq!(bits(cycle(&block)), bits([y, y * D]));
    let expected = [[B * C, B * C * D], [A, A * D], [y, y * D], [y, 0.0], [y, y * D]];
    for (which, expected) in expected.into_iter().enumerate() {
        let changed = block.without(which).unwrap_or_else(|| panic!("{which}"));
        assert_eq!(bits(cycle(&changed)), bits(expected), "{which}");
        // What is left out is not fused either.
        let places = usize::from(which != 1);
        assert_eq!(changed.contracted(None).is_some(), places == 1, "{which}");
    }
    assert!(block.without(expected.len()).is_none());
    let whole =
        |block: &Block| answers(block, &[("d", LREAL)], &[vec![Literal::F64(D)]], &[("k", Literal::I32(0))], &[]);
    assert_eq!(whole(&block), [[Literal::I32(3)]]);
    assert_eq!(block.without(4).map(|changed| whole(&changed)), Some(vec![vec![Literal::I32(0)]]));
}

/// What a constant is when it is another one.
fn larger(value: f64) -> f64 {
    value + value * 2f64.powi(-10)
}

#[test]
fn a_constant_is_larger_by_a_thousandth() {
    let block = reading(
        "y := 0.1 * a + 0.0 - (-1.0 * 0.0);\nIF a < -2.5 THEN\n    y := 7.0;\nEND_IF;\nz := -1.5 + 5.0 - (4.0);",
    );
    let (y, z) = (0.1 * A, -1.5 + 5.0 - 4.0);
    assert_eq!(bits(cycle(&block)), bits([y, z]));
    let expected = [
        [larger(0.1) * A, z],
        [y, z],
        [y, z],
        [y, -larger(1.5) + 5.0 - 4.0],
        [y, -1.5 + larger(5.0) - 4.0],
        [y, -1.5 + 5.0 - larger(4.0)],
    ];
    for (which, expected) in expected.into_iter().enumerate() {
        let changed = block.with_other_constant(which).unwrap_or_else(|| panic!("{which}"));
        assert_eq!(bits(cycle(&changed)), bits(expected), "{which}");
    }
    assert!(block.with_other_constant(expected.len()).is_none());
    // The limit of the comparison moved too.
    let below =
        |block: &Block| answers(block, &[("a", LREAL)], &[vec![Literal::F64(-larger(2.5))]], &[("y", LREAL)], &[]);
    assert_eq!(below(&block), [[Literal::F64(7.0)]]);
    let changed = block.with_other_constant(1).expect("it has one");
    assert_eq!(below(&changed), [[Literal::F64(0.1 * -larger(2.5))]]);
    let changed = block.with_other_constant(2).expect("it has one");
    assert_eq!(below(&changed), [[Literal::F64(larger(7.0))]]);
}

#[test]
fn declared_and_assigned_constants_count_and_start_values_do_not() {
    let text = crate::forms::TWINCAT.replace("x : LREAL := 1.0", "x : LREAL := 3.0");
    let twincat = block(Dialect::TwinCat, &text, "probe", RealKind::F64);
    let scl =
        block(Dialect::Scl, &crate::forms::SCL.replace("ELSE\n", "ELSE\n    #sum := 2.0;\n"), "probe", RealKind::F64);
    let y = |block: &Block, x: f64| answers(block, &[("x", LREAL)], &[vec![Literal::F64(x)]], &[("y", LREAL)], &[]);
    // At its limit `x` is not below it. The text of TwinCAT has the number twice, that of SCL another one in the other arm.
    for (block, at_the_limit) in [(twincat, [0.0, 0.0, 5.0]), (scl, [0.0, 5.0, 0.0])] {
        let changed = |which| block.with_other_constant(which).expect("it has one");
        assert_eq!(y(&block, 3.0), [[Literal::F64(1.5)]]);
        assert_eq!(y(&changed(0), 3.0), [[Literal::F64(3.0 * larger(0.5))]]);
        assert_eq!(y(&block, 10.0), [[Literal::F64(0.0)]]);
        for (which, expected) in at_the_limit.into_iter().enumerate() {
            assert_eq!(y(&changed(which), 10.0), [[Literal::F64(expected)]], "{which}");
        }
        assert!(block.with_other_constant(3).is_none());
    }
}

#[test]
fn a_constant_of_real_is_larger_and_a_real() {
    let text = "FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : REAL;\n    z : REAL;\nEND_VAR\ny := -0.1;\nz := 2.0 * 0.5;\nEND_FUNCTION_BLOCK\n";
    let block = block(Dialect::Plain, text, "probe", RealKind::F32);
    let single = Literal::F32(0.0);
    let found = |block: &Block| answers(block, &[], &[vec![]], &[("y", single), ("z", single)], &[]).concat();
    assert_eq!(found(&block), [-0.1, 1.0].map(Literal::F32));
    let changed = |which| block.with_other_constant(which).map(|block| found(&block));
    assert_eq!(changed(0), Some([f32::lit(larger(-0.1)), 1.0].map(Literal::F32).to_vec()));
    assert_eq!(changed(1), Some([-0.1, f32::lit(larger(1.0))].map(Literal::F32).to_vec()));
    assert_eq!(changed(2), None);
    assert_eq!(found(&block.wide()), [-0.1, 1.0].map(Literal::F32));
}

#[test]
fn one_operation_a_statement_leaves_nothing_wider() {
    let text = "FUNCTION_BLOCK probe\nVAR_INPUT\n    a : REAL;\n    b : REAL;\n    u : UDINT;\nEND_VAR\nVAR_OUTPUT\n    y : REAL;\n    z : REAL;\n\
                END_VAR\ny := UDINT_TO_REAL(u);\nz := a * b;\ny := y * z;\nz := -y / b;\ny := y - z;\nEND_FUNCTION_BLOCK\n";
    let block = block(Dialect::Plain, text, "probe", RealKind::F32);
    let (single, word) = (Literal::F32(0.0), Literal::U32(0));
    let samples: Vec<Vec<Literal>> = (1u8..100)
        .map(|at| vec![Literal::F32(0.1 * f32::from(at)), Literal::F32(-0.7), Literal::U32(u32::MAX / u32::from(at))])
        .collect();
    let found = |block: &Block| {
        answers(block, &[("a", single), ("b", single), ("u", word)], &samples, &[("y", single), ("z", single)], &[])
    };
    assert_eq!(found(&block.clone().wide()), found(&block));
    assert!(block.contracted(None).is_none());
}

#[test]
fn a_changed_block_has_instances() {
    let inner = reading("y := a * b + 0.7;\nz := y;");
    let outer = |inner: &Block| {
        let text = "FUNCTION_BLOCK test\nVAR_INPUT\n    a : LREAL;\n    b : LREAL;\n    c : LREAL;\n    d : LREAL;\nEND_VAR\n\
                    VAR_OUTPUT\n    y : LREAL;\n    z : LREAL;\nEND_VAR\nVAR\n    tested : probe;\nEND_VAR\n\
                    tested(a := a, b := b);\ny := tested.y;\nz := tested.z + 1.0;\nEND_FUNCTION_BLOCK\n";
        assert_eq!(said(Dialect::Plain, text, "test", RealKind::F64).len(), 1);
        block_with(Dialect::Plain, text, "test", RealKind::F64, std::slice::from_ref(inner))
    };
    let found = |inner: Option<Block>| bits(cycle(&outer(&inner.expect("it can be changed"))));
    let (y, fused) = (A * B + 0.7, A.mul_add(B, 0.7));
    assert_eq!(found(Some(inner.clone())), bits([y, y + 1.0]));
    assert_eq!(found(inner.contracted(None)), bits([fused, fused + 1.0]));
    assert_eq!(found(inner.without(1)), bits([y, 1.0]));
    let other = A * B + larger(0.7);
    assert_eq!(found(inner.with_other_constant(0)), bits([other, other + 1.0]));
    // Assignments and numbers of the outer block are its own text's.
    let outer = outer(&inner);
    assert_eq!(outer.without(0).map(|changed| bits(cycle(&changed))), Some(bits([0.0, y + 1.0])));
    assert!(outer.without(2).is_none());
    let next = Some(bits([y, y + larger(1.0)]));
    assert_eq!(outer.with_other_constant(0).map(|changed| bits(cycle(&changed))), next);
    assert!(outer.with_other_constant(1).is_none());
}

//! Calls: where they stand, what is passed, and whose function is meant.

use crate::text;
use portable::{Real, from_u32, in_range, portable, with_numbers, within};

#[portable]
struct Section<R> {
    s1: R,
    count: u32,
}

#[portable]
struct State<R> {
    section: [Section<R>; 2],
}

#[expect(unused_qualifications, reason = "these paths are the test")]
mod inner {
    use portable::{Real, portable};

    pub const LEN: usize = 2;

    /// Not the one outside.
    #[portable]
    pub fn weight<R: Real>() -> R {
        R::lit(0.25)
    }

    #[portable]
    pub fn both<R: Real>(x: R) -> R {
        let mut w = [x; self::LEN];
        w[super::FIRST] = super::weight();
        w[0] + self::weight::<R>() + w[1]
    }
}

const FIRST: usize = 0;

#[portable]
fn weight<R: Real>() -> R {
    R::lit(0.75)
}

#[portable]
fn next<R: Real>(section: &mut Section<R>, x: R) -> R {
    let y = section.s1;
    section.s1 = x;
    y
}

#[portable]
fn sum<R: Real>(x: &[R; 2]) -> R {
    x[0] + x[1]
}

#[portable]
fn look<R: Real>(state: &State<R>) -> R {
    state.section[0].s1
}

#[portable]
fn step<R: Real>(state: &mut State<R>, x: R) -> R {
    let mut y = next(&mut state.section[0], x + weight());
    y = next::<R>(&mut state.section[1], y * R::lit(0.5));
    state.section[0].s1 = next(&mut state.section[1], -y);
    let t = [x, y];
    let s1 = look(state);
    let z = sum(&t) + inner::both(s1) * sum(&t);
    next(&mut state.section[0], z)
}

#[portable]
#[derive(Clone, Copy)]
struct Number<R> {
    s1: R,
}

#[portable]
struct Numbers<R> {
    section: [Number<R>; 2],
}

#[portable]
fn overlaid<R: Real>(state: &State<R>, numbers: &Numbers<R>) -> R {
    look(&with_numbers(state, numbers))
}

#[portable]
#[derive(Clone, Copy)]
struct Half<R> {
    section: Number<R>,
    limit: R,
}

#[portable]
#[derive(Clone, Copy)]
struct Whole<R> {
    half: Half<R>,
}

#[portable]
fn look_inside<R: Real>(half: &Half<R>) -> R {
    half.section.s1 + half.limit
}

#[portable]
fn overlaid_inside<R: Real>(whole: &Whole<R>, number: &Number<R>) -> R {
    look_inside(&Half { section: with_numbers(&whole.half.section, number), ..whole.half })
}

#[portable]
fn intrinsics<R: Real>(state: &State<R>, x: R) -> bool {
    let share = from_u32::<R>(state.section[0].count) * x;
    in_range(x, portable_limit()) && within(share, R::ONE)
}

#[portable]
fn portable_limit<R: Real>() -> R {
    R::per_kind(1e15, 1e9)
}

#[test]
fn a_call_that_changes_something_stands_alone() {
    let expected = "step(state: &mut State, x: f64) -> f64 { \
                    let y = next(&state.section[0], (x + weight())); \
                    y = next(&state.section[1], (y * 0.5f64)); \
                    state.section[0].s1 = next(&state.section[1], -y); \
                    let t = [x, y]; \
                    let s1 = look(&state); \
                    let z = (sum(&t) + (both(s1) * sum(&t))); \
                    next(&state.section[0], z) }";
    assert_eq!(text::function(&step::Ir::<f64>::IR), expected);
}

#[test]
fn intrinsics_are_calls() {
    let expected = "intrinsics(state: &State, x: f32) -> bool { \
                    let share = (from_u32(state.section[0].count) * x); \
                    (in_range(x, portable_limit()) && within(share, 1.0f32)) }";
    assert_eq!(text::function(&intrinsics::Ir::<f32>::IR), expected);
    assert_eq!(text::function(&portable_limit::Ir::<f32>::IR), "portable_limit() -> f32 { 1000000000.0f32 }");
}

#[test]
fn numbers_lie_over_a_structure() {
    let expected = "overlaid(state: &State, numbers: &Numbers) -> f64 { look(&with_numbers(&state, &numbers)) }";
    assert_eq!(text::function(&overlaid::Ir::<f64>::IR), expected);
    let section = |s1, count| Section { s1, count };
    let state = State { section: [section(1.0, 7), section(2.0, 8)] };
    let numbers = Numbers { section: [Number { s1: 3.0 }, Number { s1: 4.0 }] };
    let both: State<f64> = with_numbers(&state, &numbers);
    let all = both.section.map(|section| (section.s1.to_bits(), section.count));
    assert_eq!(all, [(3.0_f64.to_bits(), 7), (4.0_f64.to_bits(), 8)]);
    assert_eq!(overlaid(&state, &numbers).to_bits(), 3.0_f64.to_bits());
}

#[test]
fn numbers_lie_over_a_part() {
    let expected = "overlaid_inside(whole: &Whole, number: &Number) -> f64 { \
                    look_inside(&whole.half with with_numbers(&whole.half.section, &number)) }";
    assert_eq!(text::function(&overlaid_inside::Ir::<f64>::IR), expected);
    let whole = Whole { half: Half { section: Number { s1: 1.0 }, limit: 2.0 } };
    assert_eq!(overlaid_inside(&whole, &Number { s1: 3.0_f64 }).to_bits(), 5.0_f64.to_bits());
}

#[test]
fn paths_mean_what_they_mean_in_the_rust() {
    let ir = inner::both::Ir::<f64>::IR;
    let expected = "both(x: f64) -> f64 { let w = [x; 2]; w[0] = weight(); ((w[0] + weight()) + w[1]) }";
    assert_eq!(text::function(&ir), expected);
    let portable::Statement::Assign { value: portable::Expr::Call { function, .. }, .. } = &ir.body.block.statements[1]
    else {
        panic!("an assignment of a call expected");
    };
    assert_eq!(function.module, "accepted::calls::weight");
    assert!((inner::both(1.0) - 2.0_f64).abs() < 1e-15);
}

//! Constants, operators, places, and `if` and `match` as values.

use crate::text;
use portable::{Real, portable};

const ORDER: usize = 3;
const LIMIT: u32 = 7;
const HALF: f64 = 0.5;

#[portable]
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Off,
    On,
    DryRun,
}

#[portable]
struct State<R> {
    x: [R; ORDER],
    grid: [[R; 2]; ORDER],
    count: u32,
    mode: Mode,
}

#[portable]
fn constants<R: Real>(x: R) -> R {
    let a = R::ZERO + R::ONE + R::lit(-0.5) + R::lit(HALF) + R::lit(1e-3);
    let b = R::per_kind(1.0, 2.0) - R::lit(core::f64::consts::PI);
    let c = [LIMIT, u32::MAX, 0x10u32];
    let d = [-1i32, 2i32];
    let off = false;
    let order = ORDER - 1usize;
    let e = -2147483648i32;
    let f = Mode::On;
    x
}

#[portable]
fn operators<R: Real>(x: R, y: R, n: u32, mode: Mode, on: bool) -> bool {
    let sum = -x + y - x * y / (x + y);
    let order = x < y && on || x <= y && !on;
    let reverse = x >= y && on || x > y && !on;
    let mut count = n + 1u32;
    count += n;
    count -= 1u32;
    count *= n;
    count /= 3u32;
    count %= 5u32;
    let seventh = count / 7u32 + count % 2u32;
    count == n && count != 2u32 && mode == Mode::On && mode != Mode::Off && order != reverse && sum > x
}

#[portable]
fn places<R: Real>(state: &mut State<R>, i: usize) -> R {
    let mut t = [R::ZERO, R::ONE];
    let u = [R::ONE; ORDER];
    t[1] = state.x[0] + state.x[i] + state.x[ORDER - 1] + state.grid[i * 2 - 1][1usize];
    state.x[i + 1] = t[0] + u[2];
    (state.x)[2]
}

#[portable]
fn branches<R: Real>(state: &State<R>, x: R, n: i32, on: bool) -> R {
    let a = if on {
        let doubled = x + x;
        if doubled > x { doubled } else { x }
    } else if n == 1i32 {
        R::ONE
    } else {
        R::ZERO
    };
    let b = match state.mode {
        Mode::Off => 0i32,
        Mode::On | Mode::DryRun => match n {
            -1i32 => 1i32,
            2i32 | 3i32 => {
                let tripled = n * 3i32;
                tripled + n
            }
            _ => n,
        },
    };
    match on {
        true => a,
        false => x,
    }
}

fn body(of: &portable::Fn) -> String {
    let text = text::function(of);
    let start = text.find('{').expect("a body");
    text[start..].to_owned()
}

#[test]
fn constants_are_evaluated_at_the_real_type() {
    let expected = "{ let a = ((((0.0f64 + 1.0f64) + -0.5f64) + 0.5f64) + 0.001f64); \
                    let b = (1.0f64 - 3.141592653589793f64); \
                    let c = [7u32, 4294967295u32, 16u32]; \
                    let d = [-1i32, 2i32]; \
                    let off = false; \
                    let order = (3 - 1); \
                    let e = -2147483648i32; \
                    let f = variant 1; \
                    x }";
    assert_eq!(body(&constants::Ir::<f64>::IR), expected);
    assert!(body(&constants::Ir::<f32>::IR).contains("let b = (2.0f32 - 3.1415927f32);"));
}

#[test]
fn operators_keep_their_order() {
    let expected = "{ let sum = ((-x + y) - ((x * y) / (x + y))); \
                    let order = (((x < y) && on) || ((x <= y) && !on)); \
                    let reverse = (((x >= y) && on) || ((x > y) && !on)); \
                    let count = (n + 1u32); \
                    count = (count + n); \
                    count = (count - 1u32); \
                    count = (count * n); \
                    count = (count / 3u32); \
                    count = (count % 5u32); \
                    let seventh = ((count / 7u32) + (count % 2u32)); \
                    ((((((count == n) && (count != 2u32)) && (mode == variant 1)) && (mode != variant 0)) \
                    && (order != reverse)) && (sum > x)) }";
    assert_eq!(body(&operators::Ir::<f64>::IR), expected);
}

#[test]
fn places_are_fields_and_elements() {
    let expected = "{ let t = [0.0f64, 1.0f64]; \
                    let u = [1.0f64; 3]; \
                    t[1] = (((state.x[0] + state.x[i]) + state.x[(3 - 1)]) + state.grid[((i * 2) - 1)][1]); \
                    state.x[(i + 1)] = (t[0] + u[2]); \
                    state.x[2] }";
    assert_eq!(body(&places::Ir::<f64>::IR), expected);
}

#[test]
fn branches_are_values() {
    let expected = "{ let a = if on { let doubled = (x + x); if (doubled > x) { doubled } else { x } } \
                    else { if (n == 1i32) { 1.0f64 } else { 0.0f64 } }; \
                    let b = match state.mode { variant 0 => { 0i32 }, \
                    variant 1 | variant 2 => { match n { -1i32 => { 1i32 }, \
                    2i32 | 3i32 => { let tripled = (n * 3i32); (tripled + n) }, _ => { n } } } }; \
                    match on { true => { a }, false => { x } } }";
    assert_eq!(body(&branches::Ir::<f64>::IR), expected);
}

//! Locals, assignments, loops, and `if` and `match` without a value.

use crate::text;
use portable::{Real, copy, note, portable};

const ON: i32 = 1;

#[portable]
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Off,
    On,
}

#[portable]
struct State<R> {
    x: [R; 4],
    count: u32,
    mode: Mode,
}

#[portable]
fn next<R: Real>(state: &mut State<R>) -> R {
    state.count += 1u32;
    state.x[0]
}

#[portable]
fn noted(n: i32) -> i32 {
    if n > 0i32 {
        n
    } else {
        note("the caller gives no such number");
        0i32
    }
}

#[test]
fn a_note_stays_where_it_is() {
    assert_eq!((noted(3), noted(-1)), (3, 0));
    let of = text::function(&noted::Ir::<f64>::IR);
    assert!(of.contains("note(the caller gives no such number);"), "{of}");
}

#[portable]
fn loops<R: Real>(state: &mut State<R>, last: usize) {
    for i in 0..4 {
        state.x[i] = R::ZERO;
    }
    for i in 1..last {
        for k in i + 1..4usize {
            state.x[k] = state.x[i];
        }
    }
}

#[portable]
fn branches<R: Real>(state: &mut State<R>, n: i32) {
    if state.count > 3u32 {
        let y: R = next(state);
        state.x[1] = y;
    } else if n > 0i32 {
        next(state);
    }
    match state.mode {
        Mode::Off => {}
        Mode::On => state.count -= 1u32,
    }
    match n {
        ON => next_again(state),
        2i32 => {
            // A name may come again where the first one is out of sight.
            let y = next(state);
            state.x[2] = y;
        }
        _ => state.x[3] = R::ONE,
    }
    if n == 0i32 { state.count = 0u32 } else { next_again(state) }
}

#[portable]
fn next_again<R: Real>(state: &mut State<R>) {
    next(state);
}

#[portable]
#[derive(Clone, Copy, Default)]
struct Inner<R> {
    x: R,
    on: bool,
    n: [u32; 2],
}

#[expect(clippy::field_reassign_with_default, reason = "portable Rust makes a struct by its default alone")]
#[portable]
fn of_its_own<R: Real>(inner: &mut Inner<R>, x: R) -> R {
    let mut other = Inner::<R>::default();
    other.x = x;
    other.on = true;
    copy(inner, &other);
    other.x
}

#[portable]
fn copy<R: Real>(to: &mut Inner<R>, from: &Inner<R>) {
    to.x = from.x;
    to.n[1] = from.n[0];
}

#[portable]
fn taken_over<R: Real>(inner: &mut [Inner<R>; 2], from: &Inner<R>) {
    copy!(inner[0] = from: x, n);
    if from.on {
        portable::copy!(inner[1] = from:
            on,);
    }
    inner[1] = inner[0];
}

#[test]
fn fields_are_taken_over_by_their_names() {
    let of = text::function(&taken_over::Ir::<f64>::IR);
    assert!(of.ends_with("{ inner[0].x = from.x; inner[0].n = from.n; if from.on { inner[1].on = from.on; } else {}; inner[1] = inner[0]; }"), "{of}");
    let mut inner = [Inner::<f64>::default(); 2];
    taken_over(&mut inner, &Inner { x: 2.0, on: true, n: [3, 4] });
    assert_eq!((inner[1].x, inner[1].on, inner[1].n), (2.0, false, [3, 4]));
}

#[test]
fn structs_of_a_function() {
    assert_eq!(
        text::function(&of_its_own::Ir::<f64>::IR),
        "of_its_own(inner: &mut Inner, x: f64) -> f64 { \
         let other = default(F64(0.0), Bool(false), U32(0), U32(0)); \
         other.x = x; other.on = true; copy(&inner, &other); other.x }"
    );
}

#[test]
fn loops_count_over_indices() {
    let expected = "loops(state: &mut State, last: usize) { \
                    for i in 0..4 { state.x[i] = 0.0f64; } \
                    for i in 1..last { for k in (i + 1)..4 { state.x[k] = state.x[i]; } } }";
    assert_eq!(text::function(&loops::Ir::<f64>::IR), expected);
}

#[test]
fn branches_need_no_value() {
    let expected = "branches(state: &mut State, n: i32) { \
                    if (state.count > 3u32) { let y = next(&state); state.x[1] = y; } \
                    else { if (n > 0i32) { next(&state); } else {}; }; \
                    match state.mode { variant 0 => {}, variant 1 => { state.count = (state.count - 1u32); } }; \
                    match n { 1i32 => { next_again(&state); }, \
                    2i32 => { let y = next(&state); state.x[2] = y; }, \
                    _ => { state.x[3] = 1.0f64; } }; \
                    if (n == 0i32) { state.count = 0u32; } else { next_again(&state); }; }";
    assert_eq!(text::function(&branches::Ir::<f64>::IR), expected);
}

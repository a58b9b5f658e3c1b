//! Structs, enums, parameters and results.

use crate::text;
use portable::{Literal, Portable, Real, Ty, Variant, portable};

const LEN: usize = 2;

/// What a block does.
///
/// A second paragraph is for the reader of the Rust.
#[portable]
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    /// nothing
    Off,
    On,
}

#[portable]
#[derive(Clone, Debug, PartialEq)]
struct Section<R> {
    /// what the next
    /// output takes over
    s1: R,
    mode: Mode,
}

#[portable]
#[derive(Clone, Debug, PartialEq)]
struct State<R: Real> {
    section: [Section<R>; LEN],
    grid: [[u32; 2]; LEN],
    order: usize,
    offset: i32,
    filled: bool,
}

#[portable]
#[derive(Clone, Debug, PartialEq)]
struct Nothing {}

/// Takes every kind of parameter.
#[portable]
#[must_use]
#[allow(clippy::too_many_arguments, reason = "one of each")]
fn take<R: Real>(
    state: &mut State<R>,
    section: &Section<R>,
    grid: &[u32; 3],
    x: R,
    mode: Mode,
    count: u32,
    offset: i32,
    i: usize,
    on: bool,
) -> Mode {
    mode
}

#[portable]
fn without_real(nothing: &Nothing) {}

fn state() -> State<f64> {
    let section = |s1, mode| Section { s1, mode };
    State {
        section: [section(0.5, Mode::Off), section(0.25, Mode::On)],
        grid: [[1, 2], [3, 4]],
        order: 5,
        offset: -6,
        filled: true,
    }
}

#[test]
fn a_struct_lists_its_fields_with_their_first_paragraph() {
    let Ty::Struct { def } = Section::<f32>::TY else { panic!("a struct expected") };
    let fields: Vec<_> = def.fields.iter().map(|field| (field.name, text::ty(field.ty), field.doc)).collect();
    let expected = [("s1", "f32".to_owned(), "what the next output takes over"), ("mode", "Mode".to_owned(), "")];
    assert_eq!((def.name, fields), ("Section", expected.to_vec()));
}

#[test]
fn an_enum_lists_its_variants() {
    let Ty::Enum { def } = Mode::TY else { panic!("an enum expected") };
    let variants: Vec<_> = def.variants.iter().map(|variant| variant.name).collect();
    assert_eq!((def.name, variants), ("Mode", vec!["Off", "On"]));
}

fn mode(index: u32) -> Literal {
    let Ty::Enum { def: of } = Mode::TY else { panic!("an enum") };
    Literal::Variant(Variant { of, index })
}

#[test]
fn a_value_is_taken_apart_and_put_together() {
    let mut leaves = Vec::new();
    state().visit(&mut |literal| leaves.push(literal));
    let expected = [
        Literal::F64(0.5),
        mode(0),
        Literal::F64(0.25),
        mode(1),
        Literal::U32(1),
        Literal::U32(2),
        Literal::U32(3),
        Literal::U32(4),
        Literal::Usize(5),
        Literal::I32(-6),
        Literal::Bool(true),
    ];
    assert_eq!(leaves, expected);
    let each: Vec<_> = (0..expected.len()).map(|place| state().leaf(place)).collect();
    assert_eq!(each, expected);
    let mut next = leaves.into_iter();
    assert_eq!(State::build(&mut || next.next().expect("as many leaves")), state());
}

#[test]
fn parameters_and_results() {
    let expected = "take(state: &mut State, section: &Section, grid: &[u32; 3], x: f32, mode: Mode, count: u32, \
                    offset: i32, i: usize, on: bool) -> Mode { mode }";
    assert_eq!(text::function(&take::Ir::<f32>::IR), expected);
    assert_eq!(text::function(&without_real::Ir::<f64>::IR), "without_real(nothing: &Nothing) {}");
}

#[test]
fn a_function_knows_its_module_and_its_doc() {
    let ir = take::Ir::<f64>::IR;
    assert_eq!((ir.doc, ir.module), ("Takes every kind of parameter.", "accepted::types::take"));
}

#[test]
fn the_item_itself_is_unchanged() {
    let section = Section { s1: 0.5, mode: Mode::Off };
    assert_eq!(take(&mut state(), &section, &[1, 2, 3], 0.5, Mode::On, 1, 2, 3, true), Mode::On);
    without_real(&Nothing {});
}

//! What a Rust name stands for while specialising: a tree whose leaves are cells. No evaluation here.

use crate::program::Var;
use portable::{Field, Literal, Ty};
use std::fmt::Write;
use std::rc::Rc;

/// A local, a parameter, or a part of one.
pub(super) enum Node {
    /// a scalar, by its position among the cells
    Leaf(usize),
    /// `path`: where it stands in the coefficients, the state, ...
    Struct {
        path: Rc<str>,
        fields: Vec<(&'static str, Rc<Node>)>,
    },
    Array {
        path: Rc<str>,
        elements: Vec<Rc<Node>>,
    },
}

/// What is known of a scalar.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Cell {
    /// a coefficient, by its position among their leaves
    Coefficient(usize),
    /// a value that is known
    Known(Literal),
    /// an input, a local or a named constant: nothing can change it any more
    Fixed(Var),
    /// the variable that holds it: part of the state, or an output
    Memory(Var),
}

impl Node {
    /// Where the aggregate stands; empty for a leaf.
    pub(super) fn path(&self) -> Rc<str> {
        match self {
            Self::Leaf(_) => "".into(),
            Self::Struct { path, .. } | Self::Array { path, .. } => Rc::clone(path),
        }
    }
}

/// Builds the tree of a type; `leaf` enters each scalar and gives its cell. `path` is the same afterwards; without one,
/// the parts of the tree have no names.
pub(super) fn build(
    ty: Ty,
    mut path: Option<&mut String>,
    doc: &'static str,
    leaf: &mut dyn FnMut(Ty, &str, &'static str) -> usize,
) -> Rc<Node> {
    if !matches!(ty, Ty::Struct { .. } | Ty::Array { .. }) {
        return Rc::new(Node::Leaf(leaf(ty, path.map_or("", |path| path), doc)));
    }
    let here: Rc<str> = path.as_deref().map_or("", String::as_str).into();
    let mut inner = |part: std::fmt::Arguments<'_>, ty, doc| {
        if let Some(path) = &mut path {
            path.write_fmt(part).expect("specialise: a string takes all text");
        }
        let node = build(ty, path.as_deref_mut(), doc, leaf);
        if let Some(path) = &mut path {
            path.truncate(here.len());
        }
        node
    };
    Rc::new(match ty {
        Ty::Struct { def } => {
            let dot = if here.is_empty() { "" } else { "." };
            let field = |field: &Field| (field.name, inner(format_args!("{dot}{}", field.name), field.ty, field.doc));
            let fields = def.fields.iter().map(field).collect();
            Node::Struct { path: here, fields }
        }
        Ty::Array { element, len } => {
            let elements = (0..len).map(|index| inner(format_args!("[{index}]"), *element, doc)).collect();
            Node::Array { path: here, elements }
        }
        scalar => unreachable!("{scalar:?} is no aggregate"),
    })
}

/// The path and the doc comment of a leaf, by its position among the leaves of a type.
pub(super) fn leaf_at(ty: Ty, position: usize) -> (String, &'static str) {
    let (mut ty, mut position, mut path, mut doc) = (ty, position, String::new(), "");
    loop {
        match ty {
            Ty::Struct { def } => {
                let mut fields = def.fields.iter().map(|field| (field, leaves(field.ty)));
                let (field, _) = fields
                    .find(|(_, leaves)| match position.checked_sub(*leaves) {
                        Some(rest) => {
                            position = rest;
                            false
                        }
                        None => true,
                    })
                    .expect("specialise: the position is one of the type's leaves");
                path.push_str(if path.is_empty() { "" } else { "." });
                path.push_str(field.name);
                (ty, doc) = (field.ty, field.doc);
            }
            Ty::Array { element, .. } => {
                let each = leaves(*element);
                path.push_str(&format!("[{}]", position / each));
                (ty, position) = (*element, position % each);
            }
            _ => return (path, doc),
        }
    }
}

/// How many scalars a type has.
fn leaves(ty: Ty) -> usize {
    match ty {
        Ty::Struct { def } => def.fields.iter().map(|field| leaves(field.ty)).sum(),
        Ty::Array { element, len } => len * leaves(*element),
        _ => 1,
    }
}

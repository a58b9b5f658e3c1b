//! What a Rust name stands for while specialising: a tree whose leaves are cells. No evaluation here.

use crate::program::Var;
use portable::{Field, Literal, Ty};
use std::fmt::Write;
use std::rc::Rc;

/// A local, a parameter, or a part of one.
pub(super) enum Node {
    /// a scalar, by its position among the cells
    Leaf(usize),
    /// a struct
    Struct {
        /// where it stands in the coefficients, the state, ...
        path: Rc<str>,
        /// its fields
        fields: Vec<(&'static str, Rc<Node>)>,
    },
    /// an array
    Array {
        /// where it stands
        path: Rc<str>,
        /// its elements
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

/// Builds the tree of a type; `leaf` enters each scalar and gives its cell. `path` is the same afterwards.
pub(super) fn build(
    ty: Ty,
    path: &mut String,
    doc: &'static str,
    leaf: &mut dyn FnMut(Ty, &str, &'static str) -> usize,
) -> Rc<Node> {
    let outer = path.len();
    let mut inner = |path: &mut String, part: std::fmt::Arguments<'_>, ty, doc| {
        path.write_fmt(part).expect("specialise: a string takes all text");
        let node = build(ty, path, doc, leaf);
        path.truncate(outer);
        node
    };
    Rc::new(match ty {
        Ty::Struct { def } => {
            let dot = if outer == 0 { "" } else { "." };
            let field =
                |field: &Field| (field.name, inner(path, format_args!("{dot}{}", field.name), field.ty, field.doc));
            let fields = def.fields.iter().map(field).collect();
            Node::Struct { path: path.as_str().into(), fields }
        }
        Ty::Array { element, len } => {
            let elements = (0..len).map(|index| inner(path, format_args!("[{index}]"), *element, doc)).collect();
            Node::Array { path: path.as_str().into(), elements }
        }
        scalar => Node::Leaf(leaf(scalar, path, doc)),
    })
}

/// The path and the doc comment of a leaf, by its position among the leaves of a type.
pub(super) fn leaf_at(ty: Ty, position: usize) -> (String, &'static str) {
    let (mut ty, mut position, mut path, mut doc) = (ty, position, String::new(), "");
    loop {
        match ty {
            Ty::Struct { def } => {
                let mut fields = def.fields.iter();
                let field = fields.find(|field| {
                    let leaves = leaves(field.ty);
                    let inside = position < leaves;
                    if !inside {
                        position -= leaves;
                    }
                    inside
                });
                let field = field.expect("specialise: the position is one of the type's leaves");
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

/// Builds the tree of a type whose parts need no names.
pub(super) fn build_unnamed(ty: Ty, leaf: &mut dyn FnMut() -> usize) -> Rc<Node> {
    let nowhere: Rc<str> = "".into();
    build_at(ty, &nowhere, leaf)
}

fn build_at(ty: Ty, nowhere: &Rc<str>, leaf: &mut dyn FnMut() -> usize) -> Rc<Node> {
    let path = Rc::clone(nowhere);
    Rc::new(match ty {
        Ty::Struct { def } => Node::Struct {
            path,
            fields: def.fields.iter().map(|field| (field.name, build_at(field.ty, nowhere, leaf))).collect(),
        },
        Ty::Array { element, len } => {
            Node::Array { path, elements: (0..len).map(|_| build_at(*element, nowhere, leaf)).collect() }
        }
        _ => Node::Leaf(leaf()),
    })
}

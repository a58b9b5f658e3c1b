//! What a Rust name stands for while specialising: a tree whose leaves are cells. No evaluation here.

use crate::program::Var;
use portable::{Literal, Ty};
use std::rc::Rc;

/// A local, a parameter, or a part of one.
pub enum Node {
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
pub enum Cell {
    /// a coefficient, by its position among their leaves
    Coefficient(usize),
    /// a value that is known
    Known(Literal),
    /// an input, a local or a named constant: nothing can change it any more
    Fixed(Var),
    /// the variable that holds it: part of the state, or an output
    Memory(Var),
}

/// A leaf of the coefficients.
pub struct Coefficient {
    /// where it stands
    pub path: Rc<str>,
    /// the doc comment of its field
    pub doc: &'static str,
    /// its value
    pub value: Literal,
}

impl Node {
    /// Where the aggregate stands; empty for a leaf.
    pub fn path(&self) -> Rc<str> {
        match self {
            Self::Leaf(_) => "".into(),
            Self::Struct { path, .. } | Self::Array { path, .. } => Rc::clone(path),
        }
    }
}

/// Builds the tree of a type; `leaf` enters each scalar and gives its cell.
pub fn build(
    ty: Ty,
    path: &str,
    doc: &'static str,
    leaf: &mut dyn FnMut(Ty, Rc<str>, &'static str) -> usize,
) -> Rc<Node> {
    Rc::new(match ty {
        Ty::Struct { def } => Node::Struct {
            path: path.into(),
            fields: def
                .fields
                .iter()
                .map(|field| {
                    let inner = if path.is_empty() { field.name.to_owned() } else { format!("{path}.{}", field.name) };
                    (field.name, build(field.ty, &inner, field.doc, leaf))
                })
                .collect(),
        },
        Ty::Array { element, len } => Node::Array {
            path: path.into(),
            elements: (0..len).map(|index| build(*element, &format!("{path}[{index}]"), doc, leaf)).collect(),
        },
        scalar => Node::Leaf(leaf(scalar, path.into(), doc)),
    })
}

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

/// The path and the doc comment of a leaf, by its position among the leaves of a type.
pub fn leaf_at(ty: Ty, position: usize) -> (String, &'static str) {
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
pub fn build_unnamed(ty: Ty, leaf: &mut dyn FnMut() -> usize) -> Rc<Node> {
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

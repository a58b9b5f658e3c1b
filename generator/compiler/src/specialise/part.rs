//! The cells of a Rust name while specialising: consecutive cells, in the order of the type's scalars. No evaluation here.

use crate::program::{Var, push_field, push_index};
use portable::{Literal, Ty};
use std::rc::Rc;

/// A local or a parameter.
pub(super) struct Named {
    pub(super) name: &'static str,
    pub(super) part: Part,
    /// its path in the state, the inputs or the outputs; `None` for a scalar, or if it is elsewhere
    pub(super) path: Option<Rc<str>>,
}

/// A value or a part of one.
#[derive(Clone, Copy)]
pub(super) struct Part {
    pub(super) ty: Ty,
    /// the cell of its first scalar
    pub(super) first: usize,
}

/// The knowledge about a scalar.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Cell {
    /// a coefficient, by its position among their leaves
    Coefficient(usize),
    /// a value that is known
    Known(Literal),
    /// an input, a local or a named constant, which cannot change any more
    Fixed(Var),
    /// the variable that holds it: part of the state, or an output
    Memory(Var),
}

/// The type of a local's scalar, which is only known from its value.
const SCALAR: Ty = Ty::Bool;

impl Part {
    pub(super) fn scalar(cell: usize) -> Self {
        Self { ty: SCALAR, first: cell }
    }

    pub(super) fn scalars(first: usize, len: usize) -> Self {
        Self { ty: Ty::Array { element: &SCALAR, len }, first }
    }

    pub(super) fn field(self, name: &str) -> Option<Self> {
        let Ty::Struct { def } = self.ty else { return None };
        let field = def.fields.iter().find(|field| field.name == name)?;
        Some(Self { ty: field.ty, first: self.first + field.first })
    }

    pub(super) fn element(self, index: usize) -> Option<Self> {
        match self.ty {
            Ty::Array { element, len } if index < len => {
                Some(Self { ty: *element, first: self.first + index * element.leaves() })
            }
            _ => None,
        }
    }

    /// The cell, if there is only one.
    pub(super) fn cell(self) -> Option<usize> {
        (!matches!(self.ty, Ty::Struct { .. } | Ty::Array { .. })).then_some(self.first)
    }
}

impl Named {
    /// The name of one of its cells: its own name, or for a struct that of the field.
    pub(super) fn name_of(&self, cell: usize) -> Option<&'static str> {
        let position = cell.checked_sub(self.part.first).filter(|position| *position < self.part.ty.leaves())?;
        Some(Leaf::at(self.part.ty, position).field.map_or(self.name, |(name, _)| name))
    }
}

/// A scalar of a type.
pub(super) struct Leaf {
    pub(super) ty: Ty,
    pub(super) path: String,
    /// name and doc comment of the innermost field that is, or contains as an array, this scalar
    pub(super) field: Option<(&'static str, &'static str)>,
}

impl Leaf {
    /// The leaf with this position in a type.
    pub(super) fn at(ty: Ty, mut position: usize) -> Self {
        let mut leaf = Self { ty, path: String::with_capacity(64), field: None };
        loop {
            match leaf.ty {
                Ty::Struct { def } => {
                    let after = def.fields.partition_point(|field| field.first <= position);
                    let field = &def.fields[after - 1];
                    push_field(&mut leaf.path, field.name);
                    position -= field.first;
                    (leaf.ty, leaf.field) = (field.ty, Some((field.name, field.doc)));
                }
                Ty::Array { element, .. } => {
                    let each = element.leaves();
                    push_index(&mut leaf.path, position / each);
                    (leaf.ty, position) = (*element, position % each);
                }
                _ => return leaf,
            }
        }
    }

    /// Calls `visit` for every leaf of a type.
    pub(super) fn each(ty: Ty, visit: &mut impl FnMut(&Self)) {
        Self { ty, path: String::with_capacity(64), field: None }.inside(visit);
    }

    fn inside(&mut self, visit: &mut impl FnMut(&Self)) {
        let (ty, length, field) = (self.ty, self.path.len(), self.field);
        match ty {
            Ty::Struct { def } => {
                for field in def.fields {
                    push_field(&mut self.path, field.name);
                    (self.ty, self.field) = (field.ty, Some((field.name, field.doc)));
                    self.inside(visit);
                    self.path.truncate(length);
                }
            }
            Ty::Array { element, len } => {
                for index in 0..len {
                    push_index(&mut self.path, index);
                    self.ty = *element;
                    self.inside(visit);
                    self.path.truncate(length);
                }
            }
            _ => visit(self),
        }
        (self.ty, self.field) = (ty, field);
    }

    pub(super) fn doc(&self) -> &'static str {
        self.field.map_or("", |(_, doc)| doc)
    }
}

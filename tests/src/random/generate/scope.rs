//! What is visible at a point of a function that is being written: locals, parameters, loop variables.

use crate::random::choices::Choices;
use crate::random::syntax::{COEFFS, Mode, Place, Program, Scalar, Type};

/// A local, a parameter or a loop variable.
#[derive(Clone, Debug)]
pub struct Binding {
    /// its name
    pub name: String,
    /// its type
    pub ty: Type,
    /// what may be done with it
    pub access: Access,
    /// whether it has a value that may be looked at
    pub readable: bool,
    /// whether its value is known when the program is specialised
    pub known: bool,
    /// whether something has been read from it: what nothing reads is left out of the C, and says nothing
    pub used: bool,
}

/// What may be done with a local or a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Access {
    /// it is read: `let`, a value, or `&`
    Read,
    /// it is read and written: `let mut`
    Local,
    /// it is read and written: `&mut`
    Mutable,
    /// a loop variable below a number
    Index(usize),
}

/// The function that is being written, as far as it has come.
pub struct Writer<'g> {
    /// what decides
    pub choices: &'g mut Choices,
    /// the types, and the functions that may be called
    pub program: &'g Program,
    /// what each of those functions costs: statements once it is specialised
    pub costs: &'g [usize],
    /// what is visible
    pub scope: Vec<Binding>,
    /// what the call that is being written has borrowed already
    pub lent: Vec<(Place, Mode)>,
    /// whether only what is known when the program is specialised may be read
    pub known: bool,
    /// how often the present statement runs
    pub repeats: usize,
    /// what the function costs so far
    pub cost: usize,
    /// what it may cost
    pub limit: usize,
}

impl Writer<'_> {
    /// Takes a statement's cost from what is left, if there is so much.
    pub fn spend(&mut self, cost: usize) -> bool {
        let fits = self.cost + cost * self.repeats <= self.limit;
        if fits {
            self.cost += cost * self.repeats;
        }
        fits
    }

    /// Makes a name visible.
    pub fn enter(&mut self, name: &str, ty: Type, access: Access) {
        let known = ty == Type::Scalar(Scalar::Usize) || ty == Type::Struct(COEFFS);
        self.scope.push(Binding { name: name.to_owned(), ty, access, readable: true, known, used: false });
    }

    /// A name that nothing visible has. Outside its scope it may come again.
    pub fn fresh(&mut self) -> String {
        const NAMES: [&str; 14] =
            ["t", "p", "q", "r", "v", "next", "y_2", "old", "int", "short", "value", "choice", "acc", "signed"];
        let taken = |name: &str, scope: &[Binding]| scope.iter().any(|binding| binding.name == name);
        let plain = NAMES[self.choices.of_place(NAMES.len())];
        if !taken(plain, &self.scope) {
            return plain.to_owned();
        }
        let mut number = 2;
        while taken(&format!("{plain}{number}"), &self.scope) {
            number += 1;
        }
        format!("{plain}{number}")
    }
}

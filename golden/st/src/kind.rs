//! The types of the portable subset, and their values.

use portable::RealKind;

/// The type of a variable or an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// REAL or LREAL, as the block says
    Real,
    Bool,
    Dint,
    Udint,
    /// INT, in process data only
    Int,
    /// UINT, in process data only
    Uint,
}

impl Kind {
    /// Its name in the text.
    pub(crate) fn name(self, real: RealKind) -> &'static str {
        match (self, real) {
            (Self::Real, RealKind::F64) => "LREAL",
            (Self::Real, RealKind::F32) => "REAL",
            (Self::Bool, _) => "BOOL",
            (Self::Dint, _) => "DINT",
            (Self::Udint, _) => "UDINT",
            (Self::Int, _) => "INT",
            (Self::Uint, _) => "UINT",
        }
    }

    pub(crate) fn of(name: &str, real: RealKind) -> Option<Self> {
        [Self::Real, Self::Bool, Self::Dint, Self::Udint]
            .into_iter()
            .find(|kind| kind.name(real).eq_ignore_ascii_case(name))
    }

    /// All types, including those of process data only: these are only assigned and converted, because implementations
    /// compute with them in different widths.
    pub(crate) fn of_program(name: &str, real: RealKind) -> Option<Self> {
        let narrow = [Self::Int, Self::Uint].into_iter().find(|kind| kind.name(real).eq_ignore_ascii_case(name));
        Self::of(name, real).or(narrow)
    }
}

/// A start value.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Value {
    /// REAL or LREAL
    Real(f64),
    Bool(bool),
    /// DINT or UDINT, INT or UINT
    Word(u32),
}

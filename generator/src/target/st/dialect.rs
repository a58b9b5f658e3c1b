//! What dialects of Structured Text do differently inside a block. Plain data; their files differ more, and have modules.

use compiler::program::Type;
use portable::{Literal, RealKind};

/// A dialect.
#[derive(Clone, Copy, Debug)]
pub struct Dialect {
    /// whether a block can have constants with names of their own. Where it cannot rely on that, its numbers stand in the
    /// statements, with their names behind them.
    pub declares_constants: bool,
    /// whether a function looks at the exponent bits of a sample before it compares it ([`usable`]); elsewhere a comparison
    /// with a NaN is FALSE, and does no harm
    pub looks_at_bits: bool,
    /// what a statement writes before the name of a variable of the block
    pub sigil: &'static str,
}

/// Any compiler of the standard's second edition. Some drop every initial value inside an instance, silently: nothing
/// may depend on one.
pub const PLAIN: Dialect = Dialect { declares_constants: false, looks_at_bits: false, sigil: "" };

/// TwinCAT 3. A comparison with a NaN can stop its runtime.
pub const TWINCAT: Dialect = Dialect { declares_constants: true, looks_at_bits: true, sigil: "" };

/// CODESYS 3.5; the same runtime family, the same care.
pub const CODESYS: Dialect = Dialect { declares_constants: true, looks_at_bits: true, sigil: "" };

/// Siemens SCL for S7-1200 and S7-1500.
pub const SCL: Dialect = Dialect { declares_constants: true, looks_at_bits: false, sigil: "#" };

/// The function that looks at a sample's exponent bits, where [`Dialect::looks_at_bits`].
#[must_use]
pub fn usable(real: RealKind) -> &'static str {
    match real {
        RealKind::F64 => "F_axgen_usable_LREAL",
        RealKind::F32 => "F_axgen_usable_REAL",
    }
}

/// How a number with a name appears in a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// its digits in the statements, its name behind them
    Inline,
    /// by its name, declared as a constant
    Declared,
    /// by its name, a variable that each cycle assigns anew: digits in an expression would make all of it LREAL
    Assigned,
}

impl Dialect {
    /// How a number with a name appears.
    #[must_use]
    pub fn form(&self, value: Literal) -> Form {
        match value {
            _ if self.declares_constants => Form::Declared,
            Literal::F32(_) => Form::Assigned,
            _ => Form::Inline,
        }
    }

    /// Whether digits may stand beside a real variable in an expression: they are LREAL in every implementation, so that
    /// they must not stand beside a REAL.
    #[must_use]
    pub fn has_digits_in_expressions(&self, real: RealKind) -> bool {
        !self.declares_constants && real == RealKind::F64
    }
}

/// The name of a type.
#[must_use]
pub fn type_name(ty: Type, real: RealKind) -> &'static str {
    match (ty, real) {
        (Type::Bool, _) => "BOOL",
        (Type::I32, _) => "DINT",
        (Type::U32, _) => "UDINT",
        (Type::Real, RealKind::F64) => "LREAL",
        (Type::Real, RealKind::F32) => "REAL",
    }
}

/// The bit string of a real's size.
#[must_use]
pub fn word_name(real: RealKind) -> &'static str {
    match real {
        RealKind::F64 => "LWORD",
        RealKind::F32 => "DWORD",
    }
}

//! The operations of a lowered block. Their execution is elsewhere.

use super::kind::Kind;

/// The kinds of operations, each with the places of its result and of its operands.
macro_rules! codes {
    ($($(#[$doc:meta])* $code:ident: $result:ident <- $operands:ident,)+) => {
        /// The kind of an operation.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Code {
            $($(#[$doc])* $code,)+
        }

        impl Code {
            /// The places of its result and of its operands.
            fn places(self) -> (Place, Place) {
                match self {
                    $(Self::$code => (Place::$result, Place::$operands),)+
                }
            }
        }
    };
}

codes! {
    MoveReal: Real <- Real,
    NegateReal: Real <- Real,
    AddReal: Real <- Real,
    SubtractReal: Real <- Real,
    MultiplyReal: Real <- Real,
    DivideReal: Real <- Real,
    /// real := real * real + real, rounded once
    FusedAdd: Real <- Real,
    /// real := real * real - real, rounded once
    FusedSubtract: Real <- Real,
    /// real := third real - real * real, rounded once
    FusedSubtractFrom: Real <- Real,
    LessReal: Bool <- Real,
    AtMostReal: Bool <- Real,
    EqualReal: Bool <- Real,
    UnequalReal: Bool <- Real,
    MoveBool: Bool <- Bool,
    Not: Bool <- Bool,
    And: Bool <- Bool,
    Or: Bool <- Bool,
    EqualBool: Bool <- Bool,
    UnequalBool: Bool <- Bool,
    MoveWord: Word <- Word,
    NegateWord: Word <- Word,
    /// word := word + word; a DINT and a UDINT have the same bits
    AddWord: Word <- Word,
    SubtractWord: Word <- Word,
    MultiplyWord: Word <- Word,
    /// DINT := DINT / DINT, towards 0
    DivideDint: Word <- Word,
    /// DINT := DINT MOD DINT, with the sign of the first one
    RemainderDint: Word <- Word,
    DivideUdint: Word <- Word,
    RemainderUdint: Word <- Word,
    EqualWord: Bool <- Word,
    UnequalWord: Bool <- Word,
    LessDint: Bool <- Word,
    AtMostDint: Bool <- Word,
    LessUdint: Bool <- Word,
    AtMostUdint: Bool <- Word,
    RealOfDint: Real <- Word,
    RealOfUdint: Real <- Word,
    /// DINT := whole part of real
    Truncate: Word <- Real,
    /// real := real, rounded to single precision
    Single: Real <- Real,
    /// INT := DINT
    Narrow: Word <- Word,
    /// bool := real is finite, and between -real and real
    InRange: Bool <- Real,
    /// real := element of the `c` reals from `a` on, at the DINT `b`
    ElementReal: Real <- Real,
    /// bool := element of the `c` bools from `a` on, at the DINT `b`
    ElementBool: Bool <- Bool,
    /// word := element of the `c` words from `a` on, at the DINT `b`
    ElementWord: Word <- Word,
    /// continue at operation `to`
    Jump: Op <- Bool,
    /// continue at operation `to`, unless bool `a`
    JumpUnless: Op <- Bool,
}

impl Code {
    /// The operation that moves a value of a type.
    pub(crate) fn moving(kind: Kind) -> Self {
        match kind {
            Kind::Real => Self::MoveReal,
            Kind::Bool => Self::MoveBool,
            Kind::Dint | Kind::Udint | Kind::Int | Kind::Uint => Self::MoveWord,
        }
    }

    /// The operation that reads an element of an array of this type.
    pub(crate) fn element(kind: Kind) -> Self {
        match kind {
            Kind::Real => Self::ElementReal,
            Kind::Bool => Self::ElementBool,
            Kind::Dint | Kind::Udint | Kind::Int | Kind::Uint => Self::ElementWord,
        }
    }

    /// Whether the second operand is an index, and the third one a length.
    fn is_element(self) -> bool {
        matches!(self, Self::ElementReal | Self::ElementBool | Self::ElementWord)
    }
}

/// The first slots of a block that was copied into another one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Base {
    /// REAL or LREAL
    pub(crate) reals: u32,
    pub(crate) bools: u32,
    /// DINT and UDINT
    pub(crate) words: u32,
}

/// An operation. `to`, `a`, `b` and `c` are slots of the types of its code; unused ones are 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Op {
    /// its kind
    pub(crate) code: Code,
    /// slot of the result
    pub(crate) to: u32,
    /// the first operand
    pub(crate) a: u32,
    /// the second operand
    pub(crate) b: u32,
    /// the third operand
    pub(crate) c: u32,
    /// whether the result is part of an expression: not a variable, and used once
    pub(crate) part: bool,
    /// whether a real result is computed in double precision in a block of REAL; the final result is then rounded
    pub(crate) wide: bool,
}

impl Op {
    /// An operation in the precision of its block, whose result is not part of an expression.
    pub(crate) fn new(code: Code, to: u32, [a, b]: [u32; 2]) -> Self {
        Self { code, to, a, b, c: 0, part: false, wide: false }
    }
}

/// The meaning of the number of an operand or a result.
#[derive(Clone, Copy)]
enum Place {
    Real,
    Bool,
    Word,
    Op,
}

/// An operation of a block that was copied into another one, where its first operation has the number `first`.
pub(crate) fn moved(op: Op, base: Base, first: u32) -> Op {
    let start = |place| match place {
        Place::Real => base.reals,
        Place::Bool => base.bools,
        Place::Word => base.words,
        Place::Op => first,
    };
    let (to, operands) = op.code.places();
    let operand = |slot: u32| slot + start(operands);
    if op.code.is_element() {
        return Op { to: op.to + start(to), a: operand(op.a), b: op.b + base.words, ..op };
    }
    Op { to: op.to + start(to), a: operand(op.a), b: operand(op.b), c: operand(op.c), ..op }
}

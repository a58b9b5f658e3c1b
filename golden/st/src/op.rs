//! The operations of a lowered block. Their execution is elsewhere.

use super::kind::Kind;

/// The kind of an operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Code {
    /// real := real
    MoveReal,
    /// real := -real
    NegateReal,
    /// real := real + real
    AddReal,
    /// real := real - real
    SubtractReal,
    /// real := real * real
    MultiplyReal,
    /// real := real / real
    DivideReal,
    /// real := real * real + real, rounded once
    FusedAdd,
    /// real := real * real - real, rounded once
    FusedSubtract,
    /// real := third real - real * real, rounded once
    FusedSubtractFrom,
    /// bool := real < real
    LessReal,
    /// bool := real <= real
    AtMostReal,
    /// bool := real = real
    EqualReal,
    /// bool := real <> real
    UnequalReal,
    /// bool := bool
    MoveBool,
    /// bool := NOT bool
    Not,
    /// bool := bool AND bool
    And,
    /// bool := bool OR bool
    Or,
    /// bool := bool = bool
    EqualBool,
    /// bool := bool <> bool
    UnequalBool,
    /// word := word
    MoveWord,
    /// word := -word
    NegateWord,
    /// word := word + word; a DINT and a UDINT have the same bits
    AddWord,
    /// word := word - word
    SubtractWord,
    /// word := word * word
    MultiplyWord,
    /// DINT := DINT / DINT, towards 0
    DivideDint,
    /// DINT := DINT MOD DINT, with the sign of the first one
    RemainderDint,
    /// UDINT := UDINT / UDINT
    DivideUdint,
    /// UDINT := UDINT MOD UDINT
    RemainderUdint,
    /// bool := word = word
    EqualWord,
    /// bool := word <> word
    UnequalWord,
    /// bool := DINT < DINT
    LessDint,
    /// bool := DINT <= DINT
    AtMostDint,
    /// bool := UDINT < UDINT
    LessUdint,
    /// bool := UDINT <= UDINT
    AtMostUdint,
    /// real := DINT
    RealOfDint,
    /// real := UDINT
    RealOfUdint,
    /// DINT := whole part of real
    Truncate,
    /// real := real, rounded to single precision
    Single,
    /// INT := DINT
    Narrow,
    /// bool := real is finite, and between -real and real
    InRange,
    /// real := element of the `c` reals from `a` on, at the DINT `b`
    ElementReal,
    /// bool := element of the `c` bools from `a` on, at the DINT `b`
    ElementBool,
    /// word := element of the `c` words from `a` on, at the DINT `b`
    ElementWord,
    /// continue at operation `to`
    Jump,
    /// continue at operation `to`, unless bool `a`
    JumpUnless,
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
}

impl Code {
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
    /// BOOL
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
    let (to, operands) = places(op.code);
    let operand = |slot: u32| slot + start(operands);
    if op.code.is_element() {
        return Op { to: op.to + start(to), a: operand(op.a), b: op.b + base.words, ..op };
    }
    Op { to: op.to + start(to), a: operand(op.a), b: operand(op.b), c: operand(op.c), ..op }
}

/// The places of the result and of the operands of an operation.
fn places(code: Code) -> (Place, Place) {
    match code {
        Code::MoveReal
        | Code::NegateReal
        | Code::AddReal
        | Code::SubtractReal
        | Code::MultiplyReal
        | Code::DivideReal
        | Code::FusedAdd
        | Code::FusedSubtract
        | Code::FusedSubtractFrom
        | Code::ElementReal => (Place::Real, Place::Real),
        Code::LessReal | Code::AtMostReal | Code::EqualReal | Code::UnequalReal | Code::InRange => {
            (Place::Bool, Place::Real)
        }
        Code::MoveBool | Code::Not | Code::And | Code::Or | Code::EqualBool | Code::UnequalBool | Code::ElementBool => {
            (Place::Bool, Place::Bool)
        }
        Code::MoveWord
        | Code::NegateWord
        | Code::AddWord
        | Code::SubtractWord
        | Code::MultiplyWord
        | Code::Narrow
        | Code::DivideDint
        | Code::RemainderDint
        | Code::DivideUdint
        | Code::RemainderUdint
        | Code::ElementWord => (Place::Word, Place::Word),
        Code::EqualWord
        | Code::UnequalWord
        | Code::LessDint
        | Code::AtMostDint
        | Code::LessUdint
        | Code::AtMostUdint => (Place::Bool, Place::Word),
        Code::RealOfDint | Code::RealOfUdint => (Place::Real, Place::Word),
        Code::Truncate => (Place::Word, Place::Real),
        Code::Single => (Place::Real, Place::Real),
        Code::Jump | Code::JumpUnless => (Place::Op, Place::Bool),
    }
}

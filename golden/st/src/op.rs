//! The operations of a lowered block. What they do is elsewhere.

/// What is done.
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
    /// bool := real is finite, and between -real and real
    InRange,
    /// on to operation `to`
    Jump,
    /// on to operation `to`, unless bool `a`
    JumpUnless,
}

/// An operation. `to`, `a` and `b` are slots of the types that its code has; `b` is 0 where there is none.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Op {
    /// what is done
    pub(crate) code: Code,
    /// where the result goes
    pub(crate) to: u32,
    /// the first operand
    pub(crate) a: u32,
    /// the second operand
    pub(crate) b: u32,
}

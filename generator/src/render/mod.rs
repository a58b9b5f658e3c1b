//! What the templates are filled with. No logic: every field is text that a target has made.

mod c;
mod cdata;
mod st;
mod twincat;

pub(crate) use c::{CBlock, CFile, CHeader, CSelfTest, CSource, Noisy, Switch};
pub(crate) use cdata::Cdata;
pub(crate) use st::{CodesysFile, CodesysInRange, Origin, PlainFile, SclFile, StBlock};
pub(crate) use twincat::{
    Compile, Item, TcEnum, TcGuide, TcInRange, TcPou, TcProgram, TcProject, TcSuite, TcUnion, TcVector, Track,
};

/// A variable that is declared.
#[derive(Clone, Debug)]
pub(crate) struct Member {
    pub(crate) ty: &'static str,
    pub(crate) name: String,
    /// its meaning
    pub(crate) doc: String,
    /// its first value
    pub(crate) start: String,
}

/// Constants that belong together.
#[derive(Clone, Debug)]
pub(crate) struct Group {
    /// what they belong to; empty: said already
    pub(crate) note: String,
    pub(crate) constants: Vec<ConstantText>,
}

/// A named number.
#[derive(Clone, Debug)]
pub(crate) struct ConstantText {
    pub(crate) ty: &'static str,
    pub(crate) name: String,
    pub(crate) value: String,
    /// its meaning
    pub(crate) doc: String,
}

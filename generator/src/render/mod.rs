//! What the templates are filled with. No logic: every field is text that a target has made.

mod c;
mod cdata;
mod st;
mod twincat;

pub use c::{CBlock, CFile, CHeader, CSelfTest, CSource, Noisy, Switch};
pub use cdata::Cdata;
pub use st::{CodesysFile, CodesysUsable, Origin, PlainFile, SclFile, StBlock};
pub use twincat::{
    Compile, Item, TcEnum, TcGuide, TcPou, TcProgram, TcProject, TcSuite, TcUnion, TcUsable, TcVector, Track,
};

/// A variable that is declared.
#[derive(Clone, Debug)]
pub struct Member {
    /// its type
    pub ty: &'static str,
    /// its name
    pub name: String,
    /// its meaning
    pub doc: String,
    /// its first value
    pub start: String,
}

/// Constants that belong together.
#[derive(Clone, Debug)]
pub struct Group {
    /// what they belong to; empty: said already
    pub note: String,
    /// the constants
    pub constants: Vec<ConstantText>,
}

/// A named number.
#[derive(Clone, Debug)]
pub struct ConstantText {
    /// its type
    pub ty: &'static str,
    /// its name
    pub name: String,
    /// its value
    pub value: String,
    /// its meaning
    pub doc: String,
}

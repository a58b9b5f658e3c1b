//! State of the block `set_design`. Nothing is computed here.

use super::element::Element;
use crate::design::band::Band;
use crate::design::inputs::Wrong;
use crate::ipc::numbers::Numbers;
use crate::sets::check;
use portable::portable;

/// The pieces of a design.
#[portable]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Piece {
    /// no design is active
    #[default]
    Rest,
    /// the range of the limit
    Limit,
    /// the inputs of an element
    Element,
    /// the warped centre frequency
    Centre,
    /// the warped bandwidth
    Bandwidth,
    /// the argument of a square root of a pair of poles
    Argument,
    /// that square root
    Root,
    /// a section
    Section,
    /// the simulated oscillation
    Oscillation,
    /// the end of an element
    End,
    /// a number in the check word
    Seal,
}

/// State.
#[portable]
#[derive(Clone, Copy, Debug, Default)]
pub struct State<R> {
    /// execute in the previous call
    pub held: bool,
    /// a design is active
    pub works: bool,
    /// the numbers are a complete set
    pub complete: bool,
    /// the input that was refused
    pub wrong: Wrong,
    /// the next piece
    pub piece: Piece,
    /// the element whose turn it is
    pub turn: u32,
    /// its section or its square root whose turn it is
    pub part: u32,
    /// the element
    pub of: Element<R>,
    /// argument of the square root whose turn it is
    pub argument: R,
    /// its band
    pub band: Band<R>,
    /// limit of the set before it is rounded
    pub limit: R,
    /// norm of its stage so far
    pub norm: R,
    /// norms of the stages so far, added up
    pub norms: R,
    /// numbers of the set
    pub numbers: Numbers<R>,
    /// check word of the numbers
    pub check: check::State<R>,
    /// number of the set
    pub set_id: u32,
}

//! A designed filter and its band. No coefficient.

use crate::axis::Filter;
use crate::design::band::Band;

/// A filter and its edges.
#[derive(Clone, Copy, Debug)]
pub struct FilterDesign {
    pub index: usize,
    pub filter: Filter,
    pub band: Band,
    /// lower and upper edge [Hz]: -3 dB of a band-pass, -90 and -270 degrees of an all-pass
    pub edges: [f64; 2],
}

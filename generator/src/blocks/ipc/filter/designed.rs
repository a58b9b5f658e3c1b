//! A filter as it is designed: where it lies. No coefficient.

use crate::axis::Filter;
use crate::design::band::Band;

/// A filter and where it lies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FilterDesign {
    pub index: usize,
    pub filter: Filter,
    pub band: Band,
    /// lower and upper edge [Hz]: -3 dB of a band-pass, -90 and -270 degrees of an all-pass
    pub edges: [f64; 2],
}

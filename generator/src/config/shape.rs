//! The parts of a written path and its indices. No parameter is known here.

use std::ops::Range;

/// A well-formed path.
pub(super) struct Shape {
    pub(super) index: [u32; 2],
    /// with `[]` for an index
    pub(super) length: usize,
    /// the ends of its first two parts; if it has only one, the second is 0
    pub(super) ends: [usize; 2],
    /// the name of its last part, without indices
    pub(super) last: Range<usize>,
}

impl Shape {
    /// `None` if the path is malformed.
    pub(super) fn of(path: &[u8]) -> Option<Self> {
        let mut shape = Self { index: [0; 2], length: path.len(), ends: [0; 2], last: 0..0 };
        let (mut at, mut parts, mut indices) = (0, 0, 0);
        if path.first().is_some_and(u8::is_ascii_digit) {
            return None;
        }
        loop {
            let start = at;
            at = end_of_name(path, at);
            if at == start {
                return None;
            }
            shape.last = start..at;
            while path.get(at) == Some(&b'[') {
                let (number, end) = number_at(path, at + 1);
                path.get(end).filter(|end| **end == b']')?;
                if let Some(index) = shape.index.get_mut(indices) {
                    *index = number;
                }
                indices += 1;
                shape.length -= end - (at + 1);
                at = end_of_name(path, end + 1);
            }
            if let Some(end) = shape.ends.get_mut(parts) {
                *end = at;
            }
            parts += 1;
            match path.get(at) {
                None => return Some(shape),
                Some(b'.') => at += 1,
                Some(_) => return None,
            }
        }
    }
}

/// The number at a place and its end. Empty brackets mean 0; no structure has an index beyond u32.
fn number_at(path: &[u8], mut at: usize) -> (u32, usize) {
    let mut number = 0_u32;
    while let Some(digit @ b'0'..=b'9') = path.get(at) {
        number = number.saturating_mul(10).saturating_add(u32::from(digit - b'0'));
        at += 1;
    }
    (number, at)
}

fn end_of_name(path: &[u8], mut at: usize) -> usize {
    while path.get(at).is_some_and(|byte| OF_NAME[usize::from(*byte)]) {
        at += 1;
    }
    at
}

static OF_NAME: [bool; 256] = {
    let mut is = [false; 256];
    let mut byte = 0;
    while byte < 128u8 {
        is[byte as usize] = byte.is_ascii_alphanumeric() || byte == b'_';
        byte += 1;
    }
    is
};

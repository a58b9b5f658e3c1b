//! The templates of C.

use super::{Group, Member};
use askama::Template;

/// The comment at a file's top, then its body.
#[derive(Template)]
#[template(path = "c/header.h")]
pub(crate) struct CFile<'a> {
    pub(crate) file: &'a str,
    pub(crate) version: &'a str,
    pub(crate) axis: &'a str,
    pub(crate) real: &'a str,
    pub(crate) cycle_time_ns: u32,
    pub(crate) parameters_digest: &'a str,
    pub(crate) checksum: &'a str,
    pub(crate) body: &'a str,
}

/// The body of a header.
#[derive(Template)]
#[template(path = "c/header_body.h")]
pub(crate) struct CHeader<'a> {
    pub(crate) guard: &'a str,
    pub(crate) blocks: &'a [CBlock],
}

/// The body of a source.
#[derive(Template)]
#[template(path = "c/source_body.c")]
pub(crate) struct CSource<'a> {
    pub(crate) header: &'a str,
    pub(crate) uses_magnitude: bool,
    pub(crate) uses_nearest: bool,
    pub(crate) real: &'a str,
    pub(crate) zero: &'a str,
    pub(crate) nearly_half: String,
    /// what GCC and Clang call the magnitude
    pub(crate) builtin_magnitude: &'a str,
    /// what they call a magnitude with the sign of another number
    pub(crate) builtin_copysign: &'a str,
    pub(crate) blocks: &'a [CBlock],
}

/// One block.
pub(crate) struct CBlock {
    /// what all its names begin with
    pub(crate) prefix: String,
    pub(crate) inputs: Vec<Member>,
    pub(crate) outputs: Vec<Member>,
    pub(crate) state: Vec<Member>,
    /// the constants, in groups that belong together
    pub(crate) constants: Vec<Group>,
    pub(crate) init: String,
    pub(crate) step: String,
    /// what is certain of its range, and its measured response
    pub(crate) certificate: String,
    pub(crate) samples: usize,
    pub(crate) self_test: String,
}

/// The self-test of a block.
#[derive(Template)]
#[template(path = "c/self_test.c")]
pub(crate) struct CSelfTest<'a> {
    /// what all names of the block begin with
    pub(crate) prefix: &'a str,
    /// what the names of the functions beside it begin with
    pub(crate) block: &'a str,
    pub(crate) real: &'a str,
    /// the unsigned integer of the same size
    pub(crate) bits_type: &'a str,
    /// its bits, less five
    pub(crate) turn: u32,
    /// the digest after each sample
    pub(crate) expected: &'a [String],
    /// the inputs that are set once
    pub(crate) switches: &'a [Switch],
    /// the inputs that get noise
    pub(crate) noisy: &'a [Noisy],
    pub(crate) not_a_number: &'a str,
    pub(crate) middle: &'a str,
    pub(crate) scales: [String; 2],
    /// the first sample with the second factor
    pub(crate) loud_from: usize,
    /// the bits of every output and every part of the state
    pub(crate) watched: &'a [String],
}

/// An input that the self-test sets.
pub(crate) struct Switch {
    pub(crate) name: String,
    pub(crate) value: String,
}

/// An input that gets noise.
pub(crate) struct Noisy {
    pub(crate) name: String,
    /// the sample in which it is no number
    pub(crate) bad_sample: usize,
}

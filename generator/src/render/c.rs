//! The templates of C.

use super::{Group, Member};
use askama::Template;

/// The comment at a file's top, then its body.
#[derive(Template)]
#[template(path = "c/header.h")]
pub struct CFile<'a> {
    /// the file's name
    pub file: &'a str,
    /// the tool's version
    pub version: &'a str,
    /// the axis
    pub axis: &'a str,
    /// C name of the real type
    pub real: &'a str,
    /// position-controller cycle
    pub cycle_time_ns: u32,
    /// digest of the axis's effective parameters
    pub parameters_digest: &'a str,
    /// digest of `body`
    pub body_digest: &'a str,
    /// everything below the comment
    pub body: &'a str,
}

/// The body of a header.
#[derive(Template)]
#[template(path = "c/header_body.h")]
pub struct CHeader<'a> {
    /// the include guard
    pub guard: &'a str,
    /// the blocks of the axis
    pub blocks: &'a [CBlock],
}

/// The body of a source.
#[derive(Template)]
#[template(path = "c/source_body.c")]
pub struct CSource<'a> {
    /// the header's name
    pub header: &'a str,
    /// whether a block asks for a magnitude
    pub uses_magnitude: bool,
    /// whether a block rounds to an integer
    pub uses_nearest: bool,
    /// C name of the real type
    pub real: &'a str,
    /// 0 of the real type
    pub zero: &'a str,
    /// the largest number below 1/2
    pub nearly_half: String,
    /// what GCC and Clang call the magnitude
    pub builtin_magnitude: &'a str,
    /// what they call a magnitude with the sign of another number
    pub builtin_copysign: &'a str,
    /// the blocks of the axis
    pub blocks: &'a [CBlock],
}

/// One block.
pub struct CBlock {
    /// what all its names begin with
    pub prefix: String,
    /// members of the inputs
    pub inputs: Vec<Member>,
    /// members of the outputs
    pub outputs: Vec<Member>,
    /// members of the state
    pub state: Vec<Member>,
    /// the constants, in groups that belong together
    pub constants: Vec<Group>,
    /// body of `init`
    pub init: String,
    /// body of `step`
    pub step: String,
    /// what is certain of its range, and its measured response
    pub certificate: String,
    /// samples of the self-test
    pub samples: usize,
    /// the self-test
    pub self_test: String,
}

/// The self-test of a block.
#[derive(Template)]
#[template(path = "c/self_test.c")]
pub struct CSelfTest<'a> {
    /// what all names of the block begin with
    pub prefix: &'a str,
    /// what the names of the functions beside it begin with
    pub block: &'a str,
    /// C name of the real type
    pub real: &'a str,
    /// the unsigned integer of the same size
    pub bits_type: &'a str,
    /// its bits, less five
    pub turn: u32,
    /// the digest after each sample
    pub expected: &'a [String],
    /// the inputs that are set once
    pub switches: &'a [Switch],
    /// the inputs that get noise
    pub noisy: &'a [Noisy],
    /// the bits of a quiet NaN
    pub not_a_number: &'a str,
    /// 2^23
    pub middle: &'a str,
    /// the factors of the noise
    pub scales: [String; 2],
    /// the first sample with the second factor
    pub loud_from: usize,
    /// the bits of every output and every part of the state
    pub watched: &'a [String],
}

/// An input that the self-test sets.
pub struct Switch {
    /// the member
    pub name: String,
    /// the value
    pub value: String,
}

/// An input that gets noise.
pub struct Noisy {
    /// the member
    pub name: String,
    /// the sample in which it is no number
    pub bad_sample: usize,
}

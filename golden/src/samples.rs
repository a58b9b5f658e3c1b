//! The values of all signals of a run, packed sample by sample, in the form that a compiled engine reads and writes.

use compiler::program::{Type, Variable};
use portable::{Literal, RealKind};
use std::ops::Range;

/// Names and types of the signals of one side of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// the real type
    pub real: RealKind,
    pub signals: Vec<Signal>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Signal {
    pub name: String,
    pub ty: Type,
    /// its value until it is written
    pub start: Literal,
}

impl Shape {
    /// The shape of a block's inputs or outputs.
    #[must_use]
    pub fn of(variables: &[Variable], real: RealKind) -> Self {
        let signal =
            |variable: &Variable| Signal { name: variable.path.clone(), ty: variable.ty, start: variable.start };
        Self { real, signals: variables.iter().map(signal).collect() }
    }

    /// The position of a signal.
    #[must_use]
    pub fn place(&self, name: &str) -> Option<usize> {
        self.signals.iter().position(|signal| signal.name == name)
    }

    /// The number of bytes of a signal's value.
    #[must_use]
    pub fn size(&self, ty: Type) -> usize {
        match (ty, self.real) {
            (Type::Bool, _) => 1,
            (Type::I32 | Type::U32, _) | (Type::Real, RealKind::F32) => 4,
            (Type::Real, RealKind::F64) => 8,
        }
    }

    /// The position of each signal's bytes in a sample.
    #[must_use]
    pub fn ranges(&self) -> Vec<Range<usize>> {
        let mut at = 0;
        let range = |signal: &Signal| {
            let start = at;
            at += self.size(signal.ty);
            start..at
        };
        self.signals.iter().map(range).collect()
    }

    /// The number of bytes of a sample.
    #[must_use]
    pub fn frame(&self) -> usize {
        self.signals.iter().map(|signal| self.size(signal.ty)).sum()
    }
}

/// A run: all samples in order, each with the values of the signals in order, little-endian.
#[derive(Clone, Debug, PartialEq)]
pub struct Samples {
    /// names and types
    pub shape: Shape,
    /// the values
    pub bytes: Vec<u8>,
}

impl Samples {
    /// An empty run with capacity for `count` samples.
    #[must_use]
    pub fn with_capacity(shape: Shape, count: usize) -> Self {
        let bytes = Vec::with_capacity(shape.frame() * count);
        Self { shape, bytes }
    }

    /// The number of samples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.bytes.len() / self.shape.frame().max(1)
    }

    /// Whether the run is empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    /// Appends a sample.
    ///
    /// # Panics
    /// If a value exists only while specialising.
    pub fn push(&mut self, values: &[Literal]) {
        for value in values {
            match *value {
                Literal::Bool(value) => self.bytes.push(u8::from(value)),
                Literal::I32(value) => self.bytes.extend(value.to_le_bytes()),
                Literal::U32(value) => self.bytes.extend(value.to_le_bytes()),
                Literal::F64(value) => self.bytes.extend(value.to_bits().to_le_bytes()),
                Literal::F32(value) => self.bytes.extend(value.to_bits().to_le_bytes()),
                Literal::Usize(_) | Literal::Variant(_) => panic!("samples: {value:?} is not a signal"),
            }
        }
    }

    /// Reads the values of a sample into `values`.
    pub fn read(&self, sample: usize, values: &mut Vec<Literal>) {
        values.clear();
        let frame = self.shape.frame();
        let mut rest = &self.bytes[sample * frame..][..frame];
        for signal in &self.shape.signals {
            let (value, after) = rest.split_at(self.shape.size(signal.ty));
            values.push(unpack(signal.ty, self.shape.real, value));
            rest = after;
        }
    }

    /// The run without the signals that keep their start value in all samples; the first signal stays.
    #[must_use]
    pub fn without_constant(&self) -> Self {
        let mut start = Self::with_capacity(self.shape.clone(), 1);
        start.push(&self.shape.signals.iter().map(|signal| signal.start).collect::<Vec<_>>());
        let moved = self.moved(&start);
        self.only(&(0..moved.len()).filter(|signal| *signal == 0 || moved[*signal]).collect::<Vec<_>>())
    }

    /// Whether each signal ever differs from its bits in the first sample of another run.
    #[must_use]
    pub fn moved(&self, from: &Self) -> Vec<bool> {
        let moves = |range: &Range<usize>| {
            self.frames().any(|frame| from.bytes.get(range.clone()).is_some_and(|first| frame[range.clone()] != *first))
        };
        self.shape.ranges().iter().map(moves).collect()
    }

    /// The run with some of its signals, by their positions.
    #[must_use]
    pub fn only(&self, signals: &[usize]) -> Self {
        let ranges = self.shape.ranges();
        let chosen = |frame: &[u8]| -> Vec<u8> {
            signals.iter().flat_map(|signal| &frame[ranges[*signal].clone()]).copied().collect()
        };
        let bytes = self.frames().flat_map(chosen).collect();
        let signals = signals.iter().map(|signal| self.shape.signals[*signal].clone()).collect();
        Self { shape: Shape { real: self.shape.real, signals }, bytes }
    }

    /// The run with all signals of a shape, in which its own have these positions; the others keep their start value.
    #[must_use]
    pub fn among(&self, positions: &[usize], shape: &Shape) -> Self {
        let mut start = Self::with_capacity(shape.clone(), 1);
        start.push(&shape.signals.iter().map(|signal| signal.start).collect::<Vec<_>>());
        let (own, all) = (self.shape.ranges(), shape.ranges());
        let mut bytes = Vec::with_capacity(shape.frame() * self.len());
        for frame in self.frames() {
            let first = bytes.len();
            bytes.extend_from_slice(&start.bytes);
            for (range, position) in own.iter().zip(positions) {
                bytes[first..][all[*position].clone()].copy_from_slice(&frame[range.clone()]);
            }
        }
        Self { shape: shape.clone(), bytes }
    }

    /// Whether two samples differ in any bit.
    #[must_use]
    pub fn differs(&self, one: usize, other: usize) -> bool {
        let frame = self.shape.frame();
        self.bytes[one * frame..][..frame] != self.bytes[other * frame..][..frame]
    }

    /// The samples' bytes.
    fn frames(&self) -> std::slice::Chunks<'_, u8> {
        self.bytes.chunks(self.shape.frame().max(1))
    }

    /// The run without its first samples.
    #[must_use]
    pub fn after(&self, count: usize) -> Self {
        let bytes = self.bytes[self.shape.frame() * count.min(self.len())..].to_vec();
        Self { shape: self.shape.clone(), bytes }
    }

    /// The samples from one to another, both included.
    #[must_use]
    pub fn between(&self, first: usize, last: usize) -> Self {
        self.first(last + 1).after(first)
    }

    /// The run followed by another one.
    #[must_use]
    pub fn joined(mut self, other: &Self) -> Self {
        self.bytes.extend_from_slice(&other.bytes);
        self
    }

    /// The run with these samples only.
    #[must_use]
    pub fn samples(&self, chosen: &[usize]) -> Self {
        let frame = self.shape.frame();
        let bytes = chosen.iter().flat_map(|sample| &self.bytes[sample * frame..][..frame]).copied().collect();
        Self { shape: self.shape.clone(), bytes }
    }

    /// The first samples of the run.
    #[must_use]
    pub fn first(&self, count: usize) -> Self {
        let bytes = self.bytes[..self.shape.frame() * count.min(self.len())].to_vec();
        Self { shape: self.shape.clone(), bytes }
    }
}

/// A packed value.
fn unpack(ty: Type, real: RealKind, bytes: &[u8]) -> Literal {
    let mut word = [0; 8];
    word[..bytes.len()].copy_from_slice(bytes);
    let [a, b, c, d, ..] = word;
    let half = u32::from_le_bytes([a, b, c, d]);
    match (ty, real) {
        (Type::Bool, _) => Literal::Bool(a != 0),
        (Type::I32, _) => Literal::I32(half.cast_signed()),
        (Type::U32, _) => Literal::U32(half),
        (Type::Real, RealKind::F32) => Literal::F32(f32::from_bits(half)),
        (Type::Real, RealKind::F64) => Literal::F64(f64::from_bits(u64::from_le_bytes(word))),
    }
}

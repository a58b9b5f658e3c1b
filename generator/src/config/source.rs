//! A file's text, with the line and column of each byte. No syntax is known here.

use super::encoding::Encoding;
use crate::diagnostics::Place;
use std::sync::{Arc, OnceLock};

#[derive(Debug)]
pub(crate) struct Source {
    pub(crate) name: String,
    /// the decoded bytes
    pub(crate) bytes: Vec<u8>,
    /// the encoding of the file
    pub(crate) encoding: Encoding,
    /// whether it is an option of the command line, which has no lines
    is_option: bool,
    /// whether axgen's own text replaces that of the file: its lines are those of the file, its columns are not
    is_converted: bool,
    /// computed for the first message that needs them
    lines: OnceLock<Lines>,
}

/// Bytes between two stored character counts: a line of many megabytes is not counted again for each message.
const STRIDE: usize = 1024;

/// The starts of lines, and counts of continuation bytes of UTF-8.
#[derive(Debug)]
struct Lines {
    starts: Vec<usize>,
    continuations: Vec<usize>,
}

impl Source {
    pub(crate) fn new(name: &str, bytes: Vec<u8>, encoding: Encoding) -> Arc<Self> {
        Arc::new(Self {
            name: name.to_owned(),
            bytes,
            encoding,
            is_option: false,
            is_converted: false,
            lines: OnceLock::new(),
        })
    }

    pub(crate) fn converted(name: &str, bytes: Vec<u8>, encoding: Encoding) -> Arc<Self> {
        let name = name.to_owned();
        Arc::new(Self { name, bytes, encoding, is_option: false, is_converted: true, lines: OnceLock::new() })
    }

    /// Whether the text differs from that of the file.
    pub(crate) fn is_converted(&self) -> bool {
        self.is_converted
    }

    pub(crate) fn option(name: &str, value: &str) -> Arc<Self> {
        let bytes = value.as_bytes().to_vec();
        let (name, encoding) = (name.to_owned(), Encoding::Plain);
        Arc::new(Self { name, bytes, encoding, is_option: true, is_converted: false, lines: OnceLock::new() })
    }

    /// Whether it is an option of the command line.
    pub(crate) fn is_option(&self) -> bool {
        self.is_option
    }

    pub(crate) fn whole(&self) -> Place {
        Place { file: self.name.clone(), line: 0, column: 0 }
    }

    pub(crate) fn place(&self, offset: usize) -> Place {
        if self.is_option {
            return self.whole();
        }
        let lines = self.lines.get_or_init(|| Lines::new(&self.bytes));
        let line = lines.starts.partition_point(|start| *start <= offset);
        if self.is_converted {
            return Place { line, ..self.whole() };
        }
        let start = lines.starts[line - 1];
        let characters = offset - start + lines.continuations_before(&self.bytes, start)
            - lines.continuations_before(&self.bytes, offset);
        Place { file: self.name.clone(), line, column: characters + 1 }
    }
}

impl Lines {
    fn new(bytes: &[u8]) -> Self {
        let mut starts = vec![0];
        starts.extend(memchr::memchr_iter(b'\n', bytes).map(|at| at + 1));
        let (mut sum, mut continuations) = (0, vec![0]);
        for chunk in bytes.chunks(STRIDE) {
            sum += count(chunk);
            continuations.push(sum);
        }
        Self { starts, continuations }
    }

    fn continuations_before(&self, bytes: &[u8], offset: usize) -> usize {
        let offset = offset.min(bytes.len());
        let chunk = offset / STRIDE;
        self.continuations[chunk] + count(&bytes[chunk * STRIDE..offset])
    }
}

/// The number of continuation bytes of UTF-8.
fn count(bytes: &[u8]) -> usize {
    if bytes.is_ascii() { 0 } else { bytes.iter().filter(|byte| **byte & 0xC0 == 0x80).count() }
}

//! The Structured Text that a file holds, and from where in the file each part of it comes.

/// A text put together from parts of a file.
#[derive(Default)]
pub(crate) struct Source {
    /// the whole
    pub(crate) text: String,
    /// the parts, in their order
    pieces: Vec<Piece>,
    /// from here on the text is the body; `None`: one text holds both
    pub(crate) body: Option<usize>,
    /// the name that the file gives to the block around its text
    pub(crate) name: Option<String>,
}

/// A part.
struct Piece {
    /// its first byte in the text
    at: usize,
    /// its first byte in the file
    from: usize,
    /// whether it stands in the file byte by byte
    copied: bool,
}

impl Source {
    /// The file is the text.
    pub(crate) fn plain(file: &str) -> Self {
        let mut source = Self::default();
        source.copy(file, 0);
        source
    }

    /// Appends what stands in the file.
    pub(crate) fn copy(&mut self, text: &str, from: usize) {
        let goes_on = |last: &Piece| last.copied && last.from + (self.text.len() - last.at) == from;
        if !self.pieces.last().is_some_and(goes_on) {
            self.pieces.push(Piece { at: self.text.len(), from, copied: true });
        }
        self.text.push_str(text);
    }

    /// Appends what something else in the file stands for.
    pub(crate) fn make(&mut self, text: &str, from: usize) {
        self.pieces.push(Piece { at: self.text.len(), from, copied: false });
        self.text.push_str(text);
    }

    /// The byte of the file that a byte of the text comes from.
    pub(crate) fn origin(&self, at: usize) -> usize {
        let after = self.pieces.partition_point(|piece| piece.at <= at);
        let Some(piece) = self.pieces[..after].last() else { return 0 };
        piece.from + if piece.copied { at - piece.at } else { 0 }
    }
}

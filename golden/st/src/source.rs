//! The Structured Text in a file, and the origin of each part of it in the file.

/// A text composed of parts of a file.
#[derive(Default)]
pub(crate) struct Source {
    /// the whole text
    pub(crate) text: String,
    /// the parts, in their order
    pieces: Vec<Piece>,
    /// position of the body in the text; `None` if one text contains both
    pub(crate) body: Option<usize>,
    /// the name of the block in the file around its text
    pub(crate) name: Option<String>,
}

/// A part.
struct Piece {
    /// its first byte in the text
    at: usize,
    /// its first byte in the file
    from: usize,
    /// whether it is a byte-for-byte copy
    copied: bool,
}

impl Source {
    /// The source of a file without a surrounding form.
    pub(crate) fn plain(file: &str) -> Self {
        let mut source = Self::default();
        source.copy(file, 0);
        source
    }

    /// Appends text from the file.
    pub(crate) fn copy(&mut self, text: &str, from: usize) {
        let goes_on = |last: &Piece| last.copied && last.from + (self.text.len() - last.at) == from;
        if !self.pieces.last().is_some_and(goes_on) {
            self.pieces.push(Piece { at: self.text.len(), from, copied: true });
        }
        self.text.push_str(text);
    }

    /// Appends text that represents another part of the file.
    pub(crate) fn make(&mut self, text: &str, from: usize) {
        self.pieces.push(Piece { at: self.text.len(), from, copied: false });
        self.text.push_str(text);
    }

    /// The byte of the file for a byte of the text.
    pub(crate) fn origin(&self, at: usize) -> usize {
        let after = self.pieces.partition_point(|piece| piece.at <= at);
        let Some(piece) = self.pieces[..after].last() else { return 0 };
        piece.from + if piece.copied { at - piece.at } else { 0 }
    }
}

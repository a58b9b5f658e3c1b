//! The encodings of lists and projects: from a file's bytes to its text, and back. The content of the text is not known
//! here.

/// The encoding of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    /// the bytes are the text: ASCII or UTF-8, with any byte in a comment
    Plain,
    /// every byte is the character of its number: XML that is not UTF-8
    Latin1,
    Utf16LittleEnd,
    Utf16BigEnd,
}

/// The text of a file as UTF-8, with its byte order mark; bytes in an unknown encoding stay unchanged.
pub(crate) fn decoded(bytes: Vec<u8>) -> (Vec<u8>, Encoding) {
    let (encoding, unit): (_, fn([u8; 2]) -> u16) = match bytes.as_slice() {
        [0xFF, 0xFE, ..] => (Encoding::Utf16LittleEnd, u16::from_le_bytes),
        [0xFE, 0xFF, ..] => (Encoding::Utf16BigEnd, u16::from_be_bytes),
        [b'<', ..] if str::from_utf8(&bytes).is_err() => {
            return (latin_1(&bytes).into_bytes(), Encoding::Latin1);
        }
        _ => return (bytes, Encoding::Plain),
    };
    let (pairs, rest) = bytes.as_chunks::<2>();
    let text: Result<String, _> = char::decode_utf16(pairs.iter().map(|pair| unit(*pair))).collect();
    match text {
        Ok(text) if rest.is_empty() => (text.into_bytes(), encoding),
        _ => (bytes, Encoding::Plain),
    }
}

/// Each byte as the character of its number.
pub(crate) fn latin_1(bytes: &[u8]) -> String {
    bytes.iter().copied().map(char::from).collect()
}

impl Encoding {
    /// The bytes of a file with this text; for Latin-1 an error with the first character outside Latin-1.
    pub(crate) fn encoded(self, text: Vec<u8>) -> Result<Vec<u8>, char> {
        let characters = || String::from_utf8_lossy(&text);
        let units = |bytes: fn(u16) -> [u8; 2]| characters().encode_utf16().flat_map(bytes).collect();
        match self {
            Self::Plain => Ok(text),
            Self::Latin1 => characters().chars().map(|letter| u8::try_from(letter).map_err(|_| letter)).collect(),
            Self::Utf16LittleEnd => Ok(units(u16::to_le_bytes)),
            Self::Utf16BigEnd => Ok(units(u16::to_be_bytes)),
        }
    }
}

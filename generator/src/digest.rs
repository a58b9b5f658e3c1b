//! Digests that show whether a text is unchanged. They do not protect against deliberate changes.

use crate::saved::taken_back;

/// The placeholder in a file's line `checksum` while its checksum is computed.
pub const NO_CHECKSUM: &str = "00000000000000000000000000000000";

/// The 128-bit XXH3 digest as 32 hexadecimal digits.
pub fn digest(bytes: &[u8]) -> String {
    format!("{:032x}", xxhash_rust::xxh3::xxh3_128(bytes))
}

/// Puts the checksum of a whole file, its digest, into its line `checksum`, which contains [`NO_CHECKSUM`].
///
/// # Panics
/// If there is no such line: every template has one.
pub fn with_checksum(mut text: String) -> String {
    let place = place(&text).expect("checksum: every generated file has a line for it");
    let digest = digest(text.as_bytes());
    text.replace_range(place..place + NO_CHECKSUM.len(), &digest);
    text
}

/// Whether the checksum of a file matches its content, apart from changes that `saved` undoes; `None` if it has no checksum.
pub fn has_right_checksum(text: &str) -> Option<bool> {
    let mut text = taken_back(text).into_owned();
    let place = place(&text)?;
    let stated = text[place..place + NO_CHECKSUM.len()].to_owned();
    text.replace_range(place..place + NO_CHECKSUM.len(), NO_CHECKSUM);
    Some(stated == digest(text.as_bytes()))
}

/// Whether a file contains the text, apart from changes that `saved` undoes.
pub fn is_text(file: &[u8], text: &str) -> bool {
    file == text.as_bytes() || std::str::from_utf8(file).is_ok_and(|file| taken_back(file) == text)
}

/// The position of the digits in the first line with `checksum` and a digest, with any comment signs.
fn place(text: &str) -> Option<usize> {
    text.match_indices("checksum").find_map(|(at, _)| {
        let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
        let line = text[start..].lines().next()?;
        let mut words = line.trim_start_matches([' ', '*', '/', '#', '\t']).split_ascii_whitespace();
        if let (Some("checksum"), Some(digits), None) = (words.next(), words.next(), words.next())
            && digits.len() == NO_CHECKSUM.len()
            && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
        {
            return line.find(digits).map(|column| start + column);
        }
        None
    })
}

//! Digests that tell whether a text is still the same. They are no protection against anybody who means harm.

/// What stands in a file's line `body` while the digest of the file is made.
pub const UNSEALED: &str = "00000000000000000000000000000000";

/// The 128-bit XXH3 digest as 32 hexadecimal digits.
#[must_use]
pub fn digest(bytes: &[u8]) -> String {
    format!("{:032x}", xxhash_rust::xxh3::xxh3_128(bytes))
}

/// Puts the digest of a whole file into its line `body`, which holds [`UNSEALED`].
///
/// # Panics
/// If there is no such line: every template has one.
#[must_use]
pub fn seal(mut text: String) -> String {
    let place = place(&text).expect("digest: every generated file has a line for it");
    let digest = digest(text.as_bytes());
    text.replace_range(place..place + UNSEALED.len(), &digest);
    text
}

/// Whether a file still has the content that it was sealed with, whatever its line ends are; `None`: it bears no seal.
#[must_use]
pub fn is_sealed(text: &str) -> Option<bool> {
    let mut text = text.replace("\r\n", "\n");
    let place = place(&text)?;
    let stated = text[place..place + UNSEALED.len()].to_owned();
    text.replace_range(place..place + UNSEALED.len(), UNSEALED);
    Some(stated == digest(text.as_bytes()))
}

/// Where the digits of the first line stand that reads `body` and a digest, whatever marks a comment has.
fn place(text: &str) -> Option<usize> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let mut words = line.trim_start_matches([' ', '*', '/', '\t']).split_ascii_whitespace();
        if let (Some("body"), Some(digits), None) = (words.next(), words.next(), words.next())
            && digits.len() == UNSEALED.len()
            && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
        {
            return line.find(digits).map(|column| start + column);
        }
        start += line.len();
    }
    None
}

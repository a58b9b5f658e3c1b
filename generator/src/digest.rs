//! Digests that tell whether a text is still the same. They are no protection against anybody who means harm.

/// The 128-bit XXH3 digest as 32 hexadecimal digits.
#[must_use]
pub fn digest(bytes: &[u8]) -> String {
    format!("{:032x}", xxhash_rust::xxh3::xxh3_128(bytes))
}

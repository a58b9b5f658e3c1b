//! Files as one archive, stored without compression: a page's blocks are small, and every program opens it. No time, no
//! owner: equal files give equal bytes.

/// Whether a name is UTF-8 (bit 11 of the flags).
const UTF_8: u16 = 0x0800;
/// 1 January 1980, the first day that the format has.
const FIRST_DAY: u16 = 0x0021;
const VERSION: u16 = 20;

/// The archive of files with their names. `None` if it would need the format's extension for more than 4 GiB or 65,535 files.
pub fn archive<'f>(files: impl Iterator<Item = (&'f str, &'f [u8])>) -> Option<Vec<u8>> {
    let (mut all, mut directory, mut count) = (Vec::new(), Vec::new(), 0_u16);
    for (name, bytes) in files {
        let at = u32::try_from(all.len()).ok()?;
        let about = about(name, bytes)?;
        all.extend(b"PK\x03\x04");
        all.extend(&about);
        all.extend(0_u16.to_le_bytes()); // no extra field
        all.extend(name.as_bytes());
        all.extend(bytes);
        directory.extend(b"PK\x01\x02");
        directory.extend(VERSION.to_le_bytes());
        directory.extend(&about);
        // No extra field, no comment, first disk, no attributes.
        directory.extend([0; 12]);
        directory.extend(at.to_le_bytes());
        directory.extend(name.as_bytes());
        count = count.checked_add(1)?;
    }
    let (from, length) = (u32::try_from(all.len()).ok()?, u32::try_from(directory.len()).ok()?);
    all.extend(directory);
    all.extend(b"PK\x05\x06\0\0\0\0");
    all.extend([count, count].map(u16::to_le_bytes).concat());
    all.extend([length, from].map(u32::to_le_bytes).concat());
    all.extend(0_u16.to_le_bytes());
    Some(all)
}

/// What both heads of a file say: version, flags, method, time, checksum, lengths.
fn about(name: &str, bytes: &[u8]) -> Option<Vec<u8>> {
    let length = u32::try_from(bytes.len()).ok()?;
    let head = [VERSION, UTF_8, 0, 0, FIRST_DAY].map(u16::to_le_bytes).concat();
    let sums = [checksum(bytes), length, length].map(u32::to_le_bytes).concat();
    let name = u16::try_from(name.len()).ok()?.to_le_bytes();
    Some([head, sums, name.to_vec()].concat())
}

/// CRC-32, polynomial 0xEDB88320.
fn checksum(bytes: &[u8]) -> u32 {
    let table: [u32; 256] = std::array::from_fn(|n| {
        let step = |value: u32| if value & 1 == 1 { (value >> 1) ^ 0xEDB8_8320 } else { value >> 1 };
        (0..8).fold(u32::try_from(n).unwrap_or(0), |value, _| step(value))
    });
    let next = |sum: u32, byte: &u8| (sum >> 8) ^ table[usize::from(sum.to_le_bytes()[0] ^ byte)];
    !bytes.iter().fold(u32::MAX, next)
}

//! Base 85 -> double precision numbers, as SINUMERIK writes the arrays of a measurement: the digits are not those of Ascii85
//! or of RFC 1924. No element is known here.

/// The digits, 0 first.
const DIGITS: &str = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ!#$`()*+-/:;=?@[]^_{|}~";
/// Number of digits of a 32-bit word, the most significant first.
const IN_A_WORD: usize = 5;
/// Replaces all digits of a word of 0.
const ZERO: char = '.';

/// A number with the line of its file.
pub(super) type At = (usize, f64);

/// The numbers of a text that begins in this line: two words each, the more significant first. Blanks and line ends may
/// occur anywhere.
///
/// # Errors
/// The line, and the text there.
pub(super) fn doubles(text: &str, line: usize) -> Result<Vec<At>, (usize, String)> {
    let (mut words, mut line): (Vec<(usize, u32)>, _) = (Vec::new(), line);
    let (mut word, mut digits) = (0_u64, 0);
    for letter in text.chars() {
        line += usize::from(letter == '\n');
        if letter.is_ascii_whitespace() {
            continue;
        }
        if letter == ZERO && digits == 0 {
            words.push((line, 0));
            continue;
        }
        let Some(digit) = DIGITS.find(letter) else {
            return Err((line, format!("`{}` is not a digit of base 85", letter.escape_default())));
        };
        word = DIGITS.len() as u64 * word + digit as u64;
        digits += 1;
        if digits == IN_A_WORD {
            let word_of_32 = u32::try_from(word).map_err(|_| (line, "five digits above 32 bits".to_owned()))?;
            words.push((line, word_of_32));
            (word, digits) = (0, 0);
        }
    }
    if digits != 0 || words.len() % 2 != 0 {
        return Err((line, "the digits end within a number".to_owned()));
    }
    let number = |pair: &[(usize, u32); 2]| {
        let [(line, high), (_, low)] = *pair;
        (line, f64::from_bits(u64::from(high) << 32 | u64::from(low)))
    };
    Ok(words.as_chunks::<2>().0.iter().map(number).collect())
}

//! Patterns of the texts that a set accepts: words in any case, numbers of words, times. ECMA 262.

use crate::parameters::Word;

/// A word in any of its spellings and cases, or its number.
pub(super) fn of_words(words: &[&Word]) -> String {
    format!("^(?:{})$", alternatives(words.iter().copied()))
}

/// Several words, separated by blanks or `|`, in any case; or the number of their bits.
pub(super) fn of_flags(words: &[Word]) -> String {
    let word = alternatives(words);
    let sums = sums(words).into_iter().map(number).collect::<Vec<_>>().join("|");
    format!("^(?:{sums}|{GAP}*(?:(?:{word})(?:{GAP}+(?:{word}))*{GAP}*)?)$")
}

const GAP: &str = r"[ \t\n\f\r|]";

/// Every number made of bits of these words.
pub(super) fn sums(words: &[Word]) -> Vec<u32> {
    let mut sums = vec![0];
    for bits in words.iter().filter_map(|word| word.number) {
        sums.extend(sums.clone().into_iter().map(|sum| sum | bits));
    }
    sums.sort_unstable();
    sums.dedup();
    sums
}

/// A time of at least `from` and roughly at most `to` ns: the whole part of the number decides.
pub(super) fn of_duration(from: u64, to: u64) -> String {
    let of_unit = |(unit, ns, digits): (&str, u64, u32)| {
        let fraction = if digits == 0 { r"(?:\.0*)?".to_owned() } else { format!(r"(?:\.[0-9]{{0,{digits}}}0*)?") };
        let whole = at_most(to / ns);
        // Without a digit before the point, at least one follows it.
        let below_one = if digits == 0 { String::new() } else { format!(r"|\.[0-9]{{1,{digits}}}0*") };
        format!(r"(?:0*{whole}{fraction}{below_one})\s*(?:{unit})")
    };
    let units = [("s", 1_000_000_000, 9), ("ms", 1_000_000, 6), ("us|\u{b5}s|\u{3bc}s", 1000, 3), ("ns", 1, 0)];
    let times = units.map(of_unit).join("|");
    if from == 0 { format!("^(?:{times})$") } else { format!("^(?=.*[1-9])(?:{times})$") }
}

fn alternatives<'w>(words: impl IntoIterator<Item = &'w Word>) -> String {
    let alternatives = |word: &'w Word| word.spellings().map(any_case).chain(word.number.map(number));
    words.into_iter().flat_map(alternatives).collect::<Vec<_>>().join("|")
}

fn any_case(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            c if c.is_ascii_alphabetic() => format!("[{}{}]", c.to_ascii_uppercase(), c.to_ascii_lowercase()),
            c if c.is_ascii_alphanumeric() || "_-=".contains(c) => c.to_string(),
            c => format!("\\{c}"),
        })
        .collect()
}

/// A number as text: decimal or hexadecimal, with optional leading zeros.
fn number(number: u32) -> String {
    let sign = if number == 0 { "[+-]?" } else { r"\+?" };
    format!("{sign}0*{number}|{sign}0[xX]0*{}", any_case(&format!("{number:x}")))
}

/// Whole numbers up to the largest, without leading zeros.
fn at_most(largest: u64) -> String {
    let digits = largest.to_string();
    let length = digits.len();
    let mut forms = vec!["0".to_owned()];
    if length > 1 {
        forms.push(format!("[1-9][0-9]{{0,{}}}", length - 2));
    }
    for (at, digit) in digits.bytes().enumerate() {
        let lowest = if at == 0 { b'1' } else { b'0' };
        if digit > lowest {
            let below = format!("[{}-{}]", char::from(lowest), char::from(digit - 1));
            forms.push(format!("{}{below}[0-9]{{{}}}", &digits[..at], length - 1 - at));
        }
    }
    forms.push(digits);
    format!("(?:{})", forms.join("|"))
}

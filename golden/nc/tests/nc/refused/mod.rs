//! What is refused: a text, and all that is reported for it.

mod axes;
mod brackets;
mod foreign;
mod program;
mod spindle;
mod words;

use crate::support::said;

/// What messages repeat, by the names that the rows have for it.
const REPEATED: [(&str, &str); 5] = [
    (
        "{allowed}",
        "allowed: straight moves (`G00`, `G01`), dwell, homing, feedforward, the words of spindle 1 and words that are passed over",
    ),
    ("{number}", "a number like `5`, `-5`, `.5` or `5.`, with up to 9 digits before the point and up to 30 after it"),
    ("{bracket}", "`G135`, `G136=` and a percentage, both of them, `G137`, `G74`, `PUTAX`"),
    (
        "{speed}",
        "a speed in rpm, no less than 0, with up to 9 digits before the point and up to 30 after it; write `S` and such a number",
    ),
    ("{functions}", "one of `M3`, `M4`, `M5`, `M19` in a block, or `M19` with `M3` or `M4`"),
];

/// Holds each text against what is reported for it.
fn refuses(rows: &[(&str, &[&str])]) {
    for (text, expected) in rows {
        let whole = |row: &&str| REPEATED.iter().fold((*row).to_owned(), |row, (name, part)| row.replace(name, part));
        let expected: Vec<String> = expected.iter().map(whole).collect();
        assert_eq!(said(text), expected, "{text:?}");
    }
}

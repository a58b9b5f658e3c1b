//! Refused: what is no word of the language, and what was meant by it.

use crate::refused::refuses;

#[test]
fn comments_and_letters() {
    refuses(&[
        (
            "G135 ;\u{1b}[2J\nM30",
            &["1:6: error: found `;\\u{1b}[2J`; allowed: comments in `( )`; write `( )` around the comment"],
        ),
        (
            "; a comment that goes on for more than forty letters\nM30",
            &[
                "1:1: error: found `; a comment that goes on for more than f...`; allowed: comments in `( )`; write `( )` around the comment",
            ],
        ),
        ("G135 ; on\nM30", &["1:6: error: found `; on`; allowed: comments in `( )`; write `( )` around the comment"]),
        (
            "G135 µm\nM30",
            &[
                "1:6: error: found \"µ\"; allowed: printable ASCII outside of comments; write ASCII, or `( )` around the text",
            ],
        ),
        (
            "G135\u{c}\nM30",
            &[
                "1:5: error: found \"\\u{c}\"; allowed: printable ASCII outside of comments; write ASCII, or `( )` around the text",
            ],
        ),
        (
            "\u{feff}G135\nM30",
            &[
                "1:1: error: found \"\\u{feff}\"; allowed: printable ASCII outside of comments; write ASCII, or `( )` around the text",
            ],
        ),
        (
            "G1\u{1b}35\nM30",
            &[
                "1:3: error: found \"\\u{1b}\"; allowed: printable ASCII outside of comments; write ASCII, or `( )` around the text",
            ],
        ),
    ]);
}

#[test]
fn words_of_other_languages() {
    refuses(&[
        ("G02 X1\nM30", &["1:1: error: found `G02`; allowed: {words}"]),
        ("T1\nM30", &["1:1: error: found `T1`; allowed: {words}"]),
        ("/ G135\nM30", &["1:1: error: found `/`; allowed: {words}"]),
        (
            "#TIME 2\nM30",
            &[
                "1:1: error: found `#TIME`; allowed: {words}",
                "1:7: error: found `2`; allowed: a letter before each number; write the letter, as in `G04 X2.5`",
            ],
        ),
        ("G91\nM30", &["1:1: error: found `G91`; allowed: {words}"]),
        ("A5\nM30", &["1:1: error: found `A5`; allowed: {words}"]),
        ("M2\nM30", &["1:1: error: found `M2`; allowed: {words}"]),
        ("hello\nM30", &["1:1: error: found `hello`; allowed: {words}"]),
    ]);
}

#[test]
fn other_spellings() {
    refuses(&[
        ("g135\nM30", &["1:1: error: found `g135`; allowed: words in upper case; write `G135`"]),
        ("G1 X1 F5\nM30", &["1:1: error: found `G1`; allowed: one spelling of a word; write `G01`"]),
        ("G0 X1\nM30", &["1:1: error: found `G0`; allowed: one spelling of a word; write `G00`"]),
        ("G4 X1\nM30", &["1:1: error: found `G4`; allowed: one spelling of a word; write `G04`"]),
        ("M03 S5\nM30", &["1:1: error: found `M03`; allowed: one spelling of a word; write `M3`"]),
        ("M04 S5\nM30", &["1:1: error: found `M04`; allowed: one spelling of a word; write `M4`"]),
        ("M05\nM30", &["1:1: error: found `M05`; allowed: one spelling of a word; write `M5`"]),
        ("S=100 M3\nM30", &["1:1: error: found `S=100`; allowed: one spelling of a word; write `S100`"]),
        ("M19 SPOS=5\nM30", &["1:5: error: found `SPOS=5`; allowed: one spelling of a word; write `S.POS=5`"]),
        (
            "G01X10Y20F100\nM30",
            &["1:1: error: found `G01X10Y20F100`; allowed: words with blanks between them; write `G01 X10 Y20 F100`"],
        ),
        ("S2[g135]\nM30", &["1:1: error: found `S2[g135]`; allowed: words in upper case; write `S2[G135]`"]),
        ("s[putax]\nM30", &["1:1: error: found `s[putax]`; allowed: words in upper case; write `S[PUTAX]`"]),
        ("M3S500\nM30", &["1:1: error: found `M3S500`; allowed: words with blanks between them; write `M3 S500`"]),
        (
            "G136=80\nM30",
            &[
                "1:1: error: found `G136=80`; allowed: `G136` and axes, or `G136=` in brackets; write `G136 X80` or `S[G136=80]`",
            ],
        ),
    ]);
}

#[test]
fn numbers() {
    refuses(&[
        ("G00 X1e3\nM30", &["1:5: error: found `X1e3`; allowed: {number}; write `X` and such a number"]),
        ("G00 X\nM30", &["1:5: error: found `X`; allowed: {number}; write `X` and such a number"]),
        ("G00 X.5\nM30", &["1:5: error: found `X.5`; allowed: {number}; write `X` and such a number"]),
        ("G00 X5.\nM30", &["1:5: error: found `X5.`; allowed: {number}; write `X` and such a number"]),
        ("G00 X1,5\nM30", &["1:5: error: found `X1,5`; allowed: {number}; write `X` and such a number"]),
        ("G00 X--1\nM30", &["1:5: error: found `X--1`; allowed: {number}; write `X` and such a number"]),
        ("G00 X=1\nM30", &["1:5: error: found `X=1`; allowed: {number}; write `X` and such a number"]),
        ("G00 X1234567890\nM30", &["1:5: error: found `X1234567890`; allowed: {number}; write `X` and such a number"]),
        ("G00 X0.1234567\nM30", &["1:5: error: found `X0.1234567`; allowed: {number}; write `X` and such a number"]),
        ("G00 Xnan\nM30", &["1:5: error: found `Xnan`; allowed: {words}"]),
        (
            "G01 X1 F0\nM30",
            &[
                "1:8: error: found `F0`; allowed: a feed in mm/min above 0, with up to 9 digits before the point and up to 6 behind it; write `F` and such a number",
            ],
        ),
        (
            "G01 X1 F-5\nM30",
            &[
                "1:8: error: found `F-5`; allowed: a feed in mm/min above 0, with up to 9 digits before the point and up to 6 behind it; write `F` and such a number",
            ],
        ),
        ("M3 S-5\nM30", &["1:4: error: found `S-5`; allowed: {speed}"]),
        ("M3 S1e3\nM30", &["1:4: error: found `S1e3`; allowed: {speed}"]),
        (
            "M19 S.POS=\nM30",
            &[
                "1:5: error: found `S.POS=`; allowed: `S.POS=` and an angle in deg, for spindle 1 only; write a word like `S.POS=180`",
            ],
        ),
        (
            "M19 S.POS180\nM30",
            &[
                "1:5: error: found `S.POS180`; allowed: `S.POS=` and an angle in deg, for spindle 1 only; write a word like `S.POS=180`",
            ],
        ),
        (
            "S1.POS=5 M19\nM30",
            &[
                "1:1: error: found `S1.POS=5`; allowed: `S.POS=` and an angle in deg, for spindle 1 only; write a word like `S.POS=180`",
            ],
        ),
    ]);
}

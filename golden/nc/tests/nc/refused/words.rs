//! Refused: text that is not a word of the language, and what was meant by it.

use crate::refused::refuses;

#[test]
fn comments_and_letters() {
    refuses(&[
        (
            "G135 µm\nM30",
            &[
                "1:6: error: found \"µ\"; allowed: printable ASCII outside of comments; write ASCII, or `( )` around the text",
            ],
        ),
        (
            "G135\u{c}\nM30",
            &["1:5: error: found ``, a word that programs here do not have; {allowed}; write the program without it"],
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
        (
            "G02 X1\nM30",
            &[
                "1:1: error: found `G02`, an arc; {allowed}; write straight moves, as a CAM system writes them with arcs switched off",
            ],
        ),
        (
            "A5\nM30",
            &[
                "1:1: error: found `A5` without its G word; allowed: axes after `G00` or `G01`, or with `G04`, `G74` or `G136` of the same block; write the G word before it, as in `G00 A5`",
            ],
        ),
        (
            "hello\nM30",
            &[
                "1:1: error: found `hello`, a word that programs here do not have; {allowed}; write the program without it",
            ],
        ),
    ]);
}

#[test]
fn other_spellings() {
    refuses(&[(
        "G136=80\nM30",
        &[
            "1:1: error: found `G136=80`; allowed: `G136` and axes, or `G136=` in brackets; write `G136 X80` or `S[G136=80]`",
        ],
    )]);
}

#[test]
fn numbers() {
    refuses(&[
        ("G00 X1e3\nM30", &["1:5: error: found `X1e3`; allowed: {number}; write `X` and such a number"]),
        ("G00 X\nM30", &["1:5: error: found `X`; allowed: {number}; write `X` and such a number"]),
        ("G00 X1,5\nM30", &["1:5: error: found `X1,5`; allowed: {number}; write `X` and such a number"]),
        ("G00 X--1\nM30", &["1:5: error: found `X--1`; allowed: {number}; write `X` and such a number"]),
        ("G00 X1234567890\nM30", &["1:5: error: found `X1234567890`; allowed: {number}; write `X` and such a number"]),
        (
            "G00 Xnan\nM30",
            &[
                "1:5: error: found `Xnan`, a word that programs here do not have; {allowed}; write the program without it",
            ],
        ),
        (
            "G01 X1 F0\nM30",
            &[
                "1:8: error: found `F0`; allowed: a feed above 0, with up to 9 digits before the point and up to 30 after it; write `F` and such a number",
            ],
        ),
        (
            "G01 X1 F-5\nM30",
            &[
                "1:8: error: found `F-5`; allowed: a feed above 0, with up to 9 digits before the point and up to 30 after it; write `F` and such a number",
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

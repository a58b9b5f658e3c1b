//! Refused: names, block numbers and ends of programs that are not read; several mistakes at once.

use crate::refused::refuses;

#[test]
fn names() {
    refuses(&[
        (
            "%%a\nM30",
            &[
                "1:1: error: found `%%a`; allowed: `%` and a name of letters, digits, `-`, `_` and `.`; write a name like `%spindle-position`",
            ],
        ),
        (
            "% a\nM30",
            &[
                "1:3: error: found `a` after the program name; allowed: a comment after the name; write the block in the next line",
            ],
        ),
        (
            "%a G135\nM30",
            &[
                "1:4: error: found `G135` after the program name; allowed: a comment after the name; write the block in the next line",
            ],
        ),
        (
            "G135\n%a\nM30",
            &[
                "2:1: error: found `%a`; allowed: `%` and the name of the program before the first block, once; write nothing here",
            ],
        ),
        (
            "%a\n%b\nM30",
            &[
                "2:1: error: found `%b`; allowed: `%` and the name of the program before the first block, once; write nothing here",
            ],
        ),
    ]);
}

#[test]
fn block_numbers() {
    refuses(&[
        (
            "N10 N20 G135\nM30",
            &[
                "1:5: error: found `N20` after another word; allowed: one block number, as the first word; write `N20` in front, or nothing",
            ],
        ),
        (
            "G135 N10\nM30",
            &[
                "1:6: error: found `N10` after another word; allowed: one block number, as the first word; write `N10` in front, or nothing",
            ],
        ),
        (
            "N G135\nM30",
            &["1:1: error: found `N`; allowed: a block number of up to 9 digits; write `N` and such a number"],
        ),
        (
            "N1.5 G135\nM30",
            &["1:1: error: found `N1.5`; allowed: a block number of up to 9 digits; write `N` and such a number"],
        ),
        (
            "N-1 G135\nM30",
            &["1:1: error: found `N-1`; allowed: a block number of up to 9 digits; write `N` and such a number"],
        ),
        (
            "N1000000000 G135\nM30",
            &[
                "1:1: error: found `N1000000000`; allowed: a block number of up to 9 digits; write `N` and such a number",
            ],
        ),
    ]);
}

#[test]
fn ends() {
    refuses(&[
        (
            "",
            &[
                "1:1: error: found no block with a command; allowed: a program with a block that does something, and `M30` as its last one; write the blocks, and `M30` in a line of its own",
            ],
        ),
        (
            "(M30",
            &[
                "1:1: error: found no block with a command; allowed: a program with a block that does something, and `M30` as its last one; write the blocks, and `M30` in a line of its own",
            ],
        ),
    ]);
}

#[test]
fn all_at_once() {
    refuses(&[(
        "M3 X1 G02\nM19\nG00 Q5 X2 X3\nM30",
        &[
            "1:7: error: found `G02`, an arc; {allowed}; write straight moves, as a CAM system writes them with arcs switched off",
            "2:1: error: found `M19` without `S.POS=`; allowed: `M19` with an angle; write `M19 S.POS=180`",
            "3:5: error: found `Q5`, a word of a cycle or a call that is not there; {allowed}; write the program without it",
            "3:11: error: found `X3` after `X2` in one block; allowed: each word once in a block; write one of them, or `X3` in a block of its own",
        ],
    )]);
}

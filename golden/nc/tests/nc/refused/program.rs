//! Refused: names, block numbers and ends of programs that are not read; several mistakes at once.

use crate::refused::refuses;

#[test]
fn names() {
    refuses(&[
        (
            "%\nM30",
            &[
                "1:1: error: found `%`; allowed: `%` and a name of letters, digits, `-` and `_`; write a name like `%spindle-position`",
            ],
        ),
        (
            "%%a\nM30",
            &[
                "1:1: error: found `%%a`; allowed: `%` and a name of letters, digits, `-` and `_`; write a name like `%spindle-position`",
            ],
        ),
        (
            "% a\nM30",
            &[
                "1:1: error: found `%`; allowed: `%` and a name of letters, digits, `-` and `_`; write a name like `%spindle-position`",
                "1:3: error: found `a` behind the program name; allowed: a comment behind the name; write the block in the next line",
            ],
        ),
        (
            "%a.b\nM30",
            &[
                "1:1: error: found `%a.b`; allowed: `%` and a name of letters, digits, `-` and `_`; write a name like `%spindle-position`",
            ],
        ),
        (
            "%a G135\nM30",
            &[
                "1:4: error: found `G135` behind the program name; allowed: a comment behind the name; write the block in the next line",
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
            "N10\nM30",
            &[
                "1:1: error: found `N10` and no word; allowed: a block number before other words; write the block, or a comment in `( )`",
            ],
        ),
        (
            "N10 N20 G135\nM30",
            &[
                "1:5: error: found `N20` behind another word; allowed: one block number, as the first word; write `N20` in front, or nothing",
            ],
        ),
        (
            "G135 N10\nM30",
            &[
                "1:6: error: found `N10` behind another word; allowed: one block number, as the first word; write `N10` in front, or nothing",
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
        ("n10 G135\nM30", &["1:1: error: found `n10`; allowed: words in upper case; write `N10`"]),
    ]);
}

#[test]
fn ends() {
    refuses(&[
        (
            "",
            &[
                "1:1: error: found no `M30`; allowed: a program whose last block is `M30`; write `M30` in a line of its own",
            ],
        ),
        (
            "G135",
            &[
                "1:5: error: found no `M30`; allowed: a program whose last block is `M30`; write `M30` in a line of its own",
            ],
        ),
        (
            "(M30",
            &[
                "1:1: error: found no `M30`; allowed: a program whose last block is `M30`; write `M30` in a line of its own",
            ],
        ),
        (
            "G135 M30",
            &[
                "1:1: error: found `G135` beside `M30`; allowed: nothing but a block number beside `M30`; write `M30` in a block of its own",
            ],
        ),
        (
            "M30 S5",
            &[
                "1:5: error: found `S5` beside `M30`; allowed: nothing but a block number beside `M30`; write `M30` in a block of its own",
                "1:5: error: found `S5` while the spindle does not turn; allowed: an S word alone only after `M3` or `M4`; write `M3 S5` or `M4 S5`",
            ],
        ),
        (
            "N5 M30 G135",
            &[
                "1:8: error: found `G135` beside `M30`; allowed: nothing but a block number beside `M30`; write `M30` in a block of its own",
            ],
        ),
        (
            "M30\nM30",
            &[
                "2:1: error: found `M30` after `M30` in line 1; allowed: comments after `M30`; write `M30` as the last block",
            ],
        ),
        (
            "M30\nG135\nG02\nG137",
            &[
                "2:1: error: found `G135` after `M30` in line 1; allowed: comments after `M30`; write `M30` as the last block",
                "3:1: error: found `G02`; allowed: {words}",
            ],
        ),
    ]);
}

#[test]
fn all_at_once() {
    refuses(&[(
        "M3 X1 G02\nM19\nG00 Q5 X2 X3\nM30",
        &[
            "1:7: error: found `G02`; allowed: {words}",
            "2:1: error: found `M19` without `S.POS=`; allowed: `M19` with an angle; write `M19 S.POS=180`",
            "3:5: error: found `Q5`; allowed: {words}",
        ],
    )]);
}

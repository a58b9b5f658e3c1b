//! Refused: G words, axes and feeds that do not go together, or lack each other.

use crate::refused::refuses;

#[test]
fn words_twice() {
    refuses(&[
        (
            "G00 X1 X2\nM30",
            &[
                "1:8: error: found `X2` after `X1` in one block; allowed: each word once in a block; write one of them, or `X2` in a block of its own",
            ],
        ),
        (
            "G00 X1 G00\nM30",
            &[
                "1:8: error: found `G00` after `G00` in one block; allowed: each word once in a block; write one of them, or `G00` in a block of its own",
            ],
        ),
        (
            "M3 M3 S5\nM30",
            &[
                "1:4: error: found `M3` after `M3` in one block; allowed: each word once in a block; write one of them, or `M3` in a block of its own",
            ],
        ),
        (
            "S[G135] S[G135]\nM30",
            &[
                "1:9: error: found `S[G135]` after `S[G135]` in one block; allowed: each word once in a block; write one of them, or `S[G135]` in a block of its own",
            ],
        ),
        (
            "M3 S5 S6\nM30",
            &[
                "1:7: error: found `S6` after `S5` in one block; allowed: each word once in a block; write one of them, or `S6` in a block of its own",
            ],
        ),
        (
            "G01 X1 F5 F6\nM30",
            &[
                "1:11: error: found `F6` after `F5` in one block; allowed: each word once in a block; write one of them, or `F6` in a block of its own",
            ],
        ),
    ]);
}

#[test]
fn g_words_beside_each_other() {
    refuses(&[
        (
            "G135 G137\nM30",
            &[
                "1:6: error: found `G137` with `G135`; allowed: one G word that moves, waits or sets feedforward in a block, or `G135` with `G136`; write `G137` in a block of its own",
            ],
        ),
        (
            "G135 G136 X1 G137\nM30",
            &[
                "1:14: error: found `G137` with `G135`; allowed: one G word that moves, waits or sets feedforward in a block, or `G135` with `G136`; write `G137` in a block of its own",
            ],
        ),
        (
            "G00 G01 X1 F5\nM30",
            &[
                "1:5: error: found `G01` with `G00`; allowed: one G word that moves, waits or sets feedforward in a block, or `G135` with `G136`; write `G01` in a block of its own",
            ],
        ),
        (
            "G135 G00 X1\nM30",
            &[
                "1:6: error: found `G00` with `G135`; allowed: one G word that moves, waits or sets feedforward in a block, or `G135` with `G136`; write `G00` in a block of its own",
            ],
        ),
        (
            "G136 G74 X1\nM30",
            &[
                "1:6: error: found `G74` with `G136`; allowed: one G word that moves, waits or sets feedforward in a block, or `G135` with `G136`; write `G74` in a block of its own",
            ],
        ),
    ]);
}

#[test]
fn axes_and_their_numbers() {
    refuses(&[
        (
            "G136\nM30",
            &[
                "1:1: error: found `G136` without an axis; allowed: an axis with it, such as X, Y or Z; write a block like `G136 X80`",
            ],
        ),
        (
            "G136 X80.5\nM30",
            &[
                "1:6: error: found `X80.5` with `G136`; allowed: an integer like `80`, with up to 9 digits; write `X` and such a number",
            ],
        ),
        (
            "G74\nM30",
            &[
                "1:1: error: found `G74` without an axis; allowed: an axis with it, such as X, Y or Z; write a block like `G74 X1`, or `S[G74]` for a spindle",
            ],
        ),
        (
            "G74 X2\nM30",
            &[
                "1:5: error: found `X2` with `G74`; allowed: 1 after each axis of `G74`: they are homed at once; write `X1`, in a later block if it comes later",
            ],
        ),
        (
            "G74 X1 Y0\nM30",
            &[
                "1:8: error: found `Y0` with `G74`; allowed: 1 after each axis of `G74`: they are homed at once; write `Y1`, in a later block if it comes later",
            ],
        ),
        (
            "G135 X1\nM30",
            &[
                "1:6: error: found `X1` without its G word; allowed: axes after `G00` or `G01`, or with `G04`, `G74` or `G136` of the same block; write the G word before it, as in `G00 X1`",
            ],
        ),
        (
            "G137 X1 Y1\nM30",
            &[
                "1:6: error: found `X1` without its G word; allowed: axes after `G00` or `G01`, or with `G04`, `G74` or `G136` of the same block; write the G word before it, as in `G00 X1`",
            ],
        ),
        (
            "X1\nM30",
            &[
                "1:1: error: found `X1` without its G word; allowed: axes after `G00` or `G01`, or with `G04`, `G74` or `G136` of the same block; write the G word before it, as in `G00 X1`",
            ],
        ),
    ]);
}

#[test]
fn feeds() {
    refuses(&[(
        "X1 Y1 F5\nM30",
        &[
            "1:1: error: found `X1` without its G word; allowed: axes after `G00` or `G01`, or with `G04`, `G74` or `G136` of the same block; write the G word before it, as in `G00 X1`",
        ],
    )]);
}

#[test]
fn dwell() {
    refuses(&[
        (
            "G04\nM30",
            &[
                "1:1: error: found `G04` without its time; allowed: `G04` with one time: `X` or `F` and seconds, or `P`, no less than 0; write a block like `G04 X2.5`",
            ],
        ),
        (
            "G04 Y1\nM30",
            &[
                "1:5: error: found `Y1` with `G04`; allowed: `G04` with one time: `X` or `F` and seconds, or `P`, no less than 0; write a block like `G04 X2.5`",
            ],
        ),
        (
            "G04 X1 Y1\nM30",
            &[
                "1:8: error: found `Y1` with `G04`; allowed: `G04` with one time: `X` or `F` and seconds, or `P`, no less than 0; write a block like `G04 X2.5`",
            ],
        ),
        (
            "G04 X-1\nM30",
            &[
                "1:5: error: found `X-1` with `G04`; allowed: `G04` with one time: `X` or `F` and seconds, or `P`, no less than 0; write a block like `G04 X2.5`",
            ],
        ),
        (
            "G04 X1 F5\nM30",
            &[
                "1:8: error: found `F5` with `G04`; allowed: `G04` with one time: `X` or `F` and seconds, or `P`, no less than 0; write a block like `G04 X2.5`",
            ],
        ),
        (
            "G04 X1 G00\nM30",
            &[
                "1:8: error: found `G00` with `G04`; allowed: one G word that moves, waits or sets feedforward in a block, or `G135` with `G136`; write `G00` in a block of its own",
            ],
        ),
        (
            "G04 2.5\nM30",
            &["1:5: error: found `2.5`; allowed: a letter before each number; write the letter, as in `G04 X2.5`"],
        ),
    ]);
}

//! Refused: brackets of a spindle that are not read.

use crate::refused::refuses;

#[test]
fn forms() {
    refuses(&[
        ("S[]\nM30", &["1:1: error: found `S[]` without a word; allowed: {bracket}; write one of them"]),
        ("S[ ]\nM30", &["1:1: error: found `S[ ]` without a word; allowed: {bracket}; write one of them"]),
        ("S[G135\nM30", &["1:1: error: found `S[G135` without its end; allowed: a bracket in one line; write `]`"]),
        (
            "S]\nM30",
            &[
                "1:1: error: found `S`; allowed: {speed}",
                "1:2: error: found `]`, an expression; {allowed}; write its result as a number",
            ],
        ),
        (
            "S0[G135]\nM30",
            &[
                "1:1: error: found `S0[G135]`; allowed: a spindle before `[`: `S`, or `S1` to `S99`; write a bracket like `S[G135]` or `S2[G135]`",
            ],
        ),
        (
            "S01[G135]\nM30",
            &[
                "1:1: error: found `S01[G135]`; allowed: a spindle before `[`: `S`, or `S1` to `S99`; write a bracket like `S[G135]` or `S2[G135]`",
            ],
        ),
        (
            "S100[G135]\nM30",
            &[
                "1:1: error: found `S100[G135]`; allowed: a spindle before `[`: `S`, or `S1` to `S99`; write a bracket like `S[G135]` or `S2[G135]`",
            ],
        ),
        ("X[G135]\nM30", &["1:1: error: found `X[G135]`, an expression; {allowed}; write its result as a number"]),
        (
            "S-1[G135]\nM30",
            &[
                "1:1: error: found `S-1[G135]`; allowed: a spindle before `[`: `S`, or `S1` to `S99`; write a bracket like `S[G135]` or `S2[G135]`",
            ],
        ),
        (
            "S[G135]X1\nM30",
            &[
                "1:8: error: found `X1` without its G word; allowed: axes after `G00` or `G01`, or with `G04`, `G74` or `G136` of the same block; write the G word before it, as in `G00 X1`",
            ],
        ),
        (
            "S[G135]S[G135]\nM30",
            &[
                "1:8: error: found `S[G135]` after `S[G135]` in one block; allowed: each word once in a block; write one of them, or `S[G135]` in a block of its own",
            ],
        ),
    ]);
}

#[test]
fn words_inside() {
    refuses(&[
        ("S[M3]\nM30", &["1:3: error: found `M3` in a bracket; allowed: {bracket}; write one of them"]),
        (
            "S[M3 S100]\nM30",
            &[
                "1:3: error: found `M3` in a bracket; allowed: {bracket}; write one of them",
                "1:6: error: found `S100` in a bracket; allowed: {bracket}; write one of them",
            ],
        ),
        (
            "S[G136]\nM30",
            &["1:3: error: found `G136`; allowed: `G136=` and a percentage in brackets; write a word like `G136=80`"],
        ),
        (
            "S[G136=8.5]\nM30",
            &[
                "1:3: error: found `G136=8.5`; allowed: an integer like `80`, with up to 9 digits; write `G136=` and such a number",
            ],
        ),
        (
            "S[G136=]\nM30",
            &[
                "1:3: error: found `G136=`; allowed: an integer like `80`, with up to 9 digits; write `G136=` and such a number",
            ],
        ),
        (
            "S[G136=1e1]\nM30",
            &[
                "1:3: error: found `G136=1e1`; allowed: an integer like `80`, with up to 9 digits; write `G136=` and such a number",
            ],
        ),
        (
            "S[X G135 Y]\nM30",
            &[
                "1:3: error: found `X` in a bracket; allowed: {bracket}; write one of them",
                "1:10: error: found `Y` in a bracket; allowed: {bracket}; write one of them",
            ],
        ),
        ("S[(a)]\nM30", &["1:3: error: found `(a)` in a bracket; allowed: {bracket}; write one of them"]),
    ]);
}

#[test]
fn words_beside_each_other() {
    refuses(&[
        (
            "S[G135 G137]\nM30",
            &[
                "1:8: error: found `G137` with another word of the bracket; allowed: {bracket}; write `S[G137]` in a block of its own",
            ],
        ),
        (
            "S[G137 G136=5]\nM30",
            &[
                "1:8: error: found `G136=5` with another word of the bracket; allowed: {bracket}; write `S[G136=5]` in a block of its own",
            ],
        ),
        (
            "S[G135 G135]\nM30",
            &[
                "1:8: error: found `G135` with another word of the bracket; allowed: {bracket}; write `S[G135]` in a block of its own",
            ],
        ),
        (
            "S[G136=1 G136=2]\nM30",
            &[
                "1:10: error: found `G136=2` with another word of the bracket; allowed: {bracket}; write `S[G136=2]` in a block of its own",
            ],
        ),
        (
            "S[PUTAX G74]\nM30",
            &[
                "1:9: error: found `G74` with another word of the bracket; allowed: {bracket}; write `S[G74]` in a block of its own",
            ],
        ),
    ]);
}

#[test]
fn other_spindle_words() {
    refuses(&[
        (
            "S[G135] M3 S5\nM30",
            &[
                "1:1: error: found `S[G135]` with `M3`; allowed: a bracket as the only spindle word of its block; write `S[G135]` in a block of its own",
            ],
        ),
        (
            "M5 S[G137]\nM30",
            &[
                "1:4: error: found `S[G137]` with `M5`; allowed: a bracket as the only spindle word of its block; write `S[G137]` in a block of its own",
            ],
        ),
        (
            "S[G136=5] S5\nM30",
            &[
                "1:1: error: found `S[G136=5]` with `S5`; allowed: a bracket as the only spindle word of its block; write `S[G136=5]` in a block of its own",
            ],
        ),
        (
            "S[G135] S2[G135]\nM30",
            &[
                "1:1: error: found `S[G135]` with `S2[G135]`; allowed: a bracket as the only spindle word of its block; write `S[G135]` in a block of its own",
            ],
        ),
        (
            "M5 S[G74]\nM30",
            &[
                "1:4: error: found `S[G74]` with `M5`; allowed: a bracket as the only spindle word of its block; write `S[G74]` in a block of its own",
            ],
        ),
        (
            "S2[PUTAX] M5\nM30",
            &[
                "1:1: error: found `S2[PUTAX]` with `M5`; allowed: a bracket as the only spindle word of its block; write `S2[PUTAX]` in a block of its own",
            ],
        ),
    ]);
}

//! Refused: spindle words that do not go together, or lack each other.

use crate::refused::refuses;

#[test]
fn functions() {
    refuses(&[
        (
            "M3 M4 S5\nM30",
            &[
                "1:4: error: found `M4` with another M word of the spindle; allowed: {functions}; write `M4` in a block of its own",
            ],
        ),
        (
            "M3 S5 M5\nM30",
            &[
                "1:7: error: found `M5` with another M word of the spindle; allowed: {functions}; write `M5` in a block of its own",
            ],
        ),
        (
            "M19 M5 S.POS=1\nM30",
            &[
                "1:5: error: found `M5` with another M word of the spindle; allowed: {functions}; write `M5` in a block of its own",
            ],
        ),
        (
            "M19 M3 M4 S.POS=1\nM30",
            &[
                "1:8: error: found `M4` with another M word of the spindle; allowed: {functions}; write `M4` in a block of its own",
            ],
        ),
    ]);
}

#[test]
fn what_is_missing() {
    refuses(&[
        (
            "M19\nM30",
            &["1:1: error: found `M19` without `S.POS=`; allowed: `M19` with an angle; write `M19 S.POS=180`"],
        ),
        (
            "M19 M4 S5\nM30",
            &["1:1: error: found `M19` without `S.POS=`; allowed: `M19` with an angle; write `M19 S.POS=180`"],
        ),
    ]);
}

#[test]
fn angles() {
    refuses(&[
        (
            "S.POS=1\nM30",
            &[
                "1:1: error: found `S.POS=1` without `M19`; allowed: `S.POS=` with `M19`; write the block without `S.POS=1`",
            ],
        ),
        (
            "M3 S5 S.POS=1\nM30",
            &["1:7: error: found `S.POS=1` with `M3`; allowed: `S.POS=` with `M19`; write the block without `S.POS=1`"],
        ),
        (
            "M5 S.POS=1\nM30",
            &["1:4: error: found `S.POS=1` with `M5`; allowed: `S.POS=` with `M19`; write the block without `S.POS=1`"],
        ),
        (
            "S5 S.POS=1\nM30",
            &[
                "1:4: error: found `S.POS=1` without `M19`; allowed: `S.POS=` with `M19`; write the block without `S.POS=1`",
            ],
        ),
    ]);
}

//! Refused: spindle words that do not go together, or lack each other.

use crate::refused::refuses;

#[test]
fn functions() {
    refuses(&[
        (
            "M3 M4 S5\nM30",
            &[
                "1:4: error: found `M4` beside another M word of the spindle; allowed: {functions}; write `M4` in a block of its own",
            ],
        ),
        (
            "M3 S5 M5\nM30",
            &[
                "1:7: error: found `M5` beside another M word of the spindle; allowed: {functions}; write `M5` in a block of its own",
            ],
        ),
        (
            "M5 S5\nM30",
            &[
                "1:4: error: found `S5` beside `M5`; allowed: a speed beside `M3`, `M4`, `M19`, or alone; write the block without `S5`",
            ],
        ),
        (
            "M19 M5 S.POS=1\nM30",
            &[
                "1:5: error: found `M5` beside another M word of the spindle; allowed: {functions}; write `M5` in a block of its own",
            ],
        ),
        (
            "M19 M3 M4 S.POS=1\nM30",
            &[
                "1:8: error: found `M4` beside another M word of the spindle; allowed: {functions}; write `M4` in a block of its own",
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
        (
            "M3\nM30",
            &["1:1: error: found `M3` without an S word; allowed: `M3` and `M4` with a speed; write `M3 S1000`"],
        ),
        (
            "M4\nM30",
            &["1:1: error: found `M4` without an S word; allowed: `M3` and `M4` with a speed; write `M4 S1000`"],
        ),
    ]);
}

#[test]
fn angles() {
    refuses(&[
        (
            "S.POS=1\nM30",
            &[
                "1:1: error: found `S.POS=1` beside no `M19`; allowed: `S.POS=` beside `M19`; write the block without `S.POS=1`",
            ],
        ),
        (
            "M3 S5 S.POS=1\nM30",
            &[
                "1:7: error: found `S.POS=1` beside `M3`; allowed: `S.POS=` beside `M19`; write the block without `S.POS=1`",
            ],
        ),
        (
            "M5 S.POS=1\nM30",
            &[
                "1:4: error: found `S.POS=1` beside `M5`; allowed: `S.POS=` beside `M19`; write the block without `S.POS=1`",
            ],
        ),
        (
            "S5 S.POS=1\nM30",
            &[
                "1:1: error: found `S5` while the spindle does not turn; allowed: an S word alone only after `M3` or `M4`; write `M3 S5` or `M4 S5`",
                "1:4: error: found `S.POS=1` beside no `M19`; allowed: `S.POS=` beside `M19`; write the block without `S.POS=1`",
            ],
        ),
    ]);
}

#[test]
fn a_speed_without_a_direction() {
    refuses(&[
        (
            "S5\nM30",
            &[
                "1:1: error: found `S5` while the spindle does not turn; allowed: an S word alone only after `M3` or `M4`; write `M3 S5` or `M4 S5`",
            ],
        ),
        (
            "M3 S5\nM5\nS6\nM30",
            &[
                "3:1: error: found `S6` while the spindle does not turn; allowed: an S word alone only after `M3` or `M4`; write `M3 S6` or `M4 S6`",
            ],
        ),
        (
            "M3 S5\nM19 S.POS=1\nS6\nM30",
            &[
                "3:1: error: found `S6` while the spindle does not turn; allowed: an S word alone only after `M3` or `M4`; write `M3 S6` or `M4 S6`",
            ],
        ),
        (
            "M3 S5\nS[G74]\nS6\nM30",
            &[
                "3:1: error: found `S6` while the spindle does not turn; allowed: an S word alone only after `M3` or `M4`; write `M3 S6` or `M4 S6`",
            ],
        ),
        (
            "M3 S5\nS1[PUTAX]\nS6\nM30",
            &[
                "3:1: error: found `S6` while the spindle does not turn; allowed: an S word alone only after `M3` or `M4`; write `M3 S6` or `M4 S6`",
            ],
        ),
    ]);
}

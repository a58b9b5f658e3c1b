//! Refused by name: words of NC languages that are not read, each said once with its first place and the number of them.

use crate::support::said;

/// A line with such a word: what is reported for it.
#[test]
fn each_word_says_what_it_is() {
    for (line, column, word, what) in [
        ("G2 X1 Y1 R5", 1, "G2", "an arc"),
        ("N1G03X1I5J0", 3, "G03", "an arc"),
        ("X1 Y2 I5", 7, "I5", "an arc"),
        ("G98 G81 X1 Z-5 R2 F100", 5, "G81", "a canned cycle"),
        ("g76 p5", 1, "g76", "a canned cycle"),
        ("CYCLE81(5, 0)", 1, "CYCLE81", "a canned cycle"),
        ("G33 Z-5 K1", 1, "G33", "a thread"),
        ("G92 X1 F5", 1, "G92", "a thread"),
        ("G38.2 Z-5 F5", 1, "G38.2", "a measurement"),
        ("#1 = 5 ; set", 1, "#1 = 5", "a variable"),
        ("#<depth>=[#1*2]", 1, "#<depth>=[#1*2]", "a variable"),
        ("G0 X#1", 4, "X#1", "a variable"),
        ("G0 X-#1", 4, "X-#1", "a variable"),
        ("R1=5", 1, "R1=5", "a variable"),
        ("P5=1", 1, "P5=1", "a variable"),
        ("V.E.A = 5", 1, "V.E.A", "a variable"),
        ("#VAR", 1, "#VAR", "a variable"),
        ("G0 X[5*2]", 4, "X[5*2]", "an expression"),
        ("X=5*2", 1, "X=5*2", "an expression"),
        ("$IF V.E.A == 5", 1, "$IF", "a loop, a condition or a jump"),
        ("WHILE [1 LT 2] DO1", 1, "WHILE", "a loop, a condition or a jump"),
        ("GOTO 5", 1, "GOTO", "a loop, a condition or a jump"),
        ("o<cut> call", 1, "o<cut>", "a subprogram or its call"),
        ("O100 sub", 6, "sub", "a subprogram or its call"),
        ("M98 P1000", 1, "M98", "a subprogram or its call"),
        ("LL UP1", 1, "LL", "a subprogram or its call"),
        ("%L UP1", 1, "%L", "a subprogram or its call"),
        ("G41 X1", 1, "G41", "tool radius or tool tip compensation"),
        ("G43.4 H1", 1, "G43.4", "tool radius or tool tip compensation"),
        ("G68 R45", 1, "G68", "a change of the coordinates"),
        ("G10 L2 P1 X0", 1, "G10", "a shift of the coordinates"),
        ("#TRAFO ON", 1, "#TRAFO ON", "a change of the coordinates"),
        ("G95 F0.1", 1, "G95", "a feed or a speed in another unit"),
        ("G96 S100", 1, "G96", "a feed or a speed in another unit"),
        ("G0 X1 Q5", 7, "Q5", "a word of a cycle or a call that is not there"),
        ("G999", 1, "G999", "a word that programs here do not have"),
        ("hello", 1, "hello", "a word that programs here do not have"),
    ] {
        let said = said(&format!("{line}\nM30"));
        let start = format!("1:{column}: error: found `{word}`, {what}");
        assert!(said.iter().any(|said| said.starts_with(&start)), "{line}: {start}\n{said:#?}");
    }
}

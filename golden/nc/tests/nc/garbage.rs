//! Texts that are no programs: whatever a file holds, reading it ends, and nothing panics.

use nc::{Command, read};
use proptest::prelude::*;

/// Reads a text; what is read ends once, what is wrong has its place in the text and is reported in order.
fn check(text: &str) {
    match read(text) {
        Ok(program) => {
            let ends = |block: &nc::Block| block.commands.contains(&Command::End);
            assert!(program.blocks.last().is_some_and(ends), "{text:?}");
            assert_eq!(program.blocks.iter().filter(|block| ends(block)).count(), 1, "{text:?}");
            assert!(program.blocks.iter().all(|block| !block.commands.is_empty()), "{text:?}: {program:?}");
        }
        Err(mistakes) => {
            assert!(!mistakes.is_empty() && mistakes.is_sorted(), "{text:?}: {mistakes:#?}");
            for mistake in &mistakes {
                let end = if text.contains('\n') { '\n' } else { '\r' };
                let line = text.split(end).nth(mistake.line - 1).expect("a line of the text");
                assert!((1..=line.chars().count() + 1).contains(&mistake.column), "{text:?}: {mistake}");
                assert!(!mistake.to_string().contains(char::is_control), "{text:?}: {mistake}");
            }
        }
    }
}

/// Pieces of which broken programs are made.
fn piece() -> impl Strategy<Value = String> {
    let words = "%a % N10 N G00 G01 G04 G74 G135 G136 G137 M3 M4 M5 M19 M30 S1000 S-1 S S= S.POS=180 S.POS= S[G135] S2[G135 G136=90]
        S[ ] [ S[PUTAX] S[G74] S0[G137] S1[] X1 Y-2.5 Z0 X X1e3 X1.5.2 F600 F0 ( ) ; / # g135 G1X10F5 M03 é µ G01 X0 F1";
    let words: Vec<String> = words.split_ascii_whitespace().map(str::to_owned).collect();
    prop_oneof![8 => proptest::sample::select(words), 3 => Just("\n".to_owned()), 1 => any::<String>(), 1 => "[ -~]{0,8}"]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn any_letters(text in any::<String>()) {
        check(&text);
    }

    #[test]
    fn any_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..500)) {
        check(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn any_words(words in proptest::collection::vec(piece(), 0..100)) {
        check(&words.join(" "));
    }

    #[test]
    fn any_words_in_brackets(words in proptest::collection::vec("G135|G136=[0-9.+-]{1,3}|G137|G74|PUTAX|[ -~]{1,5}", 0..4)) {
        check(&format!("S2[{}]\nM30", words.join(" ")));
    }

    #[test]
    fn the_same_text_says_the_same(words in proptest::collection::vec(piece(), 0..100)) {
        let text = words.join(" ");
        prop_assert_eq!(read(&text), read(&text));
    }
}

#[test]
fn heaps_of_the_same() {
    for word in [
        "(", "[", "S[", "G", "G01X", "1", "% ", "; ", "N1 ", "M30 ", "M30\n", "S[G135 ", "é", "\n", "\r", "G135 ",
        "X1 ", "S[G135] ",
    ] {
        check(&word.repeat(50_000));
    }
}

//! Texts that are none: whatever a file holds, reading it ends, and nothing panics.

use portable::{Literal, RealKind};
use proptest::prelude::*;
use st::{Block, Dialect};

/// A block of which a text may have instances.
const INNER: &str = "FUNCTION_BLOCK inner\nVAR_INPUT\n    a : BOOL;\nEND_VAR\nVAR_OUTPUT\n    b : BOOL;\nEND_VAR\nb := NOT a;\nEND_FUNCTION_BLOCK\n";

/// Reads a text in each form, and runs what can be read.
fn read(text: &str) {
    for dialect in Dialect::ALL {
        for real in [RealKind::F64, RealKind::F32] {
            let inner = Block::read(Dialect::Plain, INNER, "inner", real).expect("a block without a mistake");
            let Ok(block) = Block::read_with(dialect, text, "probe", real, &[inner]) else { continue };
            let x = match real {
                RealKind::F64 => Literal::F64(1.0),
                RealKind::F32 => Literal::F32(1.0),
            };
            let changed = [block.contracted(None), block.without(0), block.with_other_constant(0)];
            for block in changed.into_iter().flatten().chain([block.clone().wide(), block]) {
                if let Ok(mut instance) = block.start(&[("x", x)], &[], &[]) {
                    instance.cycle(&[x], &mut Vec::new());
                }
            }
        }
    }
}

/// Pieces of which broken texts are made.
fn piece() -> impl Strategy<Value = String> {
    let words = "FUNCTION_BLOCK END_FUNCTION_BLOCK probe VAR VAR_INPUT VAR_OUTPUT END_VAR CONSTANT x : LREAL REAL ; := 1.0 1 ( ) + - * /
        IF THEN ELSIF ELSE END_IF FOR TO DO END_FOR CASE OF 1: -1, END_CASE AND OR NOT < <= = <> MOD ** (* *) // { } ' \" # 16#FF .. . [ ] ^ % & é
        DINT_TO_LREAL F_axgen_in_range_LREAL <POU Name=\"probe\"> </POU> <![CDATA[ ]]> <ST> </ST> &lt; &#0; &x; <!-- --> BEGIN VERSION 0.1 { S7_Optimized_Access := 'TRUE' } #x \"probe\" VAR_TEMP inner \"inner\" x( a := => x.b";
    let words: Vec<String> = words.split_ascii_whitespace().map(str::to_owned).collect();
    prop_oneof![8 => proptest::sample::select(words), 1 => any::<String>(), 1 => "[ -~]{0,8}"]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn any_letters(text in any::<String>()) {
        read(&text);
    }

    #[test]
    fn any_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..2000)) {
        read(&String::from_utf8_lossy(&bytes));
    }

    #[test]
    fn any_words(words in proptest::collection::vec(piece(), 0..200)) {
        read(&words.join(" "));
    }

    #[test]
    fn a_text_with_a_part_replaced(
        form in 0usize..4, from in any::<prop::sample::Index>(), length in 0usize..40, put in piece(),
    ) {
        let text = [crate::forms::PLAIN, crate::forms::TWINCAT, crate::forms::CODESYS, crate::forms::SCL][form];
        let from = from.index(text.len());
        let end = (from + length).min(text.len());
        read(&format!("{}{put}{}", &text[..from], &text[end..]));
    }
}

#[test]
fn heaps_of_the_same() {
    let block = |body: &str| {
        format!(
            "FUNCTION_BLOCK probe\nVAR_INPUT\n    x : LREAL;\nEND_VAR\nVAR_OUTPUT\n    y : LREAL;\n    q : BOOL;\n    j : DINT;\nEND_VAR\n{body}\nEND_FUNCTION_BLOCK\n"
        )
    };
    let many = 20_000;
    for text in [
        "(".repeat(many),
        "(*".repeat(many),
        "'".repeat(many),
        "{".repeat(many),
        "16#".repeat(many),
        "<a>".repeat(many),
        "<![CDATA[".repeat(many),
        "FUNCTION_BLOCK ".repeat(many),
        "IF x THEN ".repeat(many),
        "VAR x : ".repeat(many),
        block(&"CASE j OF 1: ".repeat(many)),
        block(&format!("y := x{};", ".x".repeat(many))),
        block(&format!("x({}a := q);", "a := q, ".repeat(many))),
        block("x(a := q);")
            .replace("VAR_OUTPUT", "VAR x : inner; END_VAR VAR_OUTPUT")
            .replace("q);", &"q AND ".repeat(many)),
        block(&format!("CASE j OF {}1: y := x; END_CASE;", "1, ".repeat(many))),
        block(&format!("CASE j OF {}END_CASE;", "1: y := x; ".repeat(many))),
        block(&"IF ( y := + ) THEN\n".repeat(many)),
        block(&format!("y := {}x{};", "(".repeat(many), ")".repeat(many))),
        block(&format!("y := x{};", " + x".repeat(many))),
        block(&format!("q := {}q;", "NOT ".repeat(many))),
        block(&format!("y := {}x;", "- ".repeat(many))),
        block(&format!("{}y := x;{}", "IF q THEN ".repeat(many), "END_IF; ".repeat(many))),
        block(&format!("y := {};", "DINT_TO_LREAL(".repeat(many))),
        block(&format!("y := x{};", "[1]".repeat(many))),
    ] {
        read(&text);
    }
}

#[test]
fn what_is_allowed_inside_each_other_does_not_exhaust_the_stack() {
    let text = |levels: usize| {
        let (open, close) = ("(".repeat(levels), ")".repeat(levels));
        format!("FUNCTION_BLOCK probe\nVAR_OUTPUT\n    y : LREAL;\nEND_VAR\ny := {open}y{close};\nEND_FUNCTION_BLOCK\n")
    };
    let read = |text: &str| Block::read(Dialect::Plain, text, "probe", RealKind::F64).err().unwrap_or_default();
    assert_eq!(read(&text(498)), []);
    let said = read(&text(499));
    assert_eq!(said.len(), 1);
    assert_eq!(
        said[0].to_string(),
        "5:505: found more than 500 levels inside each other; write a part of it by itself"
    );
}

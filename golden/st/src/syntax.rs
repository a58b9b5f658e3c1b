//! The text as a tree, with a third party's grammar; and the errors of the grammar.

use super::lexical::Letters;
use super::mistake::Mistakes;
use super::number::MINUS_ZERO;
use std::ops::ControlFlow;
use tree_sitter::{Node, ParseOptions, ParseState, Parser, Tree};

/// Calls of the parser's progress function, per byte and at least, after which parsing is aborted: a valid text takes far
/// fewer, and error recovery in a text full of errors would take minutes.
const PATIENCE: (usize, usize) = (1, 10_000);

/// Parses a text; `None` if parsing was aborted.
pub(crate) fn parse(text: &str) -> Option<Tree> {
    let mut parser = Parser::new();
    parser.set_language(&tree_sitter_iec61131_3_st::LANGUAGE.into()).expect("engine: grammar and parser fit");
    let mut left = PATIENCE.1 + PATIENCE.0 * text.len();
    let mut progress = |_: &ParseState| {
        left = left.saturating_sub(1);
        if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let options = ParseOptions::new().progress_callback(&mut progress);
    let bytes = text.as_bytes();
    parser.parse_with_options(&mut |at, _| bytes.get(at..).unwrap_or_default(), None, Some(options))
}

/// Reports errors of the grammar. A place with a reported lexical error is not reported twice.
pub(crate) fn check(tree: &Tree, text: &str, letters: &Letters, mistakes: &mut Mistakes<'_>) {
    let broken_off = if letters.end < text.len() { text[..letters.end].trim_end().len() } else { usize::MAX };
    let mut cursor = tree.walk();
    loop {
        let node = cursor.node();
        let here = node.is_error() || node.is_missing();
        let named = near(text, &node, &letters.places) || node.end_byte() >= broken_off;
        if here && !named {
            say(node, text, mistakes);
        }
        if !here && node.has_error() && cursor.goto_first_child() {
            continue;
        }
        while !cursor.goto_next_sibling() {
            if !cursor.goto_parent() {
                return;
            }
        }
    }
}

/// Whether one of the positions, which are in ascending order, is in the node or in its first line.
fn near(text: &str, node: &Node<'_>, places: &[usize]) -> bool {
    let (start, end) = (node.start_byte(), node.end_byte());
    let line = start - node.start_position().column;
    let after =
        text.as_bytes()[start..].iter().position(|&byte| byte == b'\n').map_or(text.len(), |length| start + length);
    let first = places.partition_point(|&at| at < line);
    places.get(first).is_some_and(|&at| at <= end.max(after))
}

fn say(node: Node<'_>, text: &str, mistakes: &mut Mistakes<'_>) {
    let at = node.start_byte();
    if node.is_missing() {
        let missing =
            if node.kind() == "identifier" { "name or number".to_owned() } else { format!("`{}`", node.kind()) };
        mistakes.push(at, format!("no {missing}"), if node.is_named() { format!("a {missing}") } else { missing });
    } else {
        mistakes.push(at, shown(node, text), "declarations, `:=` and `IF`");
    }
}

/// The text of a node, shortened to a part of a line.
pub(crate) fn shown(node: Node<'_>, text: &str) -> String {
    let whole = text.get(node.byte_range()).unwrap_or_default();
    let line = whole.lines().next().unwrap_or_default();
    let part: String = line.chars().take(40).collect();
    if part.len() == whole.len() { format!("`{part}`") } else { format!("`{part}...`") }
}

pub(crate) fn said<'t>(node: Node<'_>, text: &'t str) -> &'t str {
    text.get(node.byte_range()).unwrap_or_default()
}

/// The children of a node with the names of their fields, without comments.
pub(crate) fn children<'n>(node: Node<'n>) -> Vec<(Node<'n>, Option<&'n str>)> {
    let (mut cursor, mut list) = (node.walk(), Vec::new());
    let mut more = cursor.goto_first_child();
    while more {
        if cursor.node().kind() != "comment" {
            list.push((cursor.node(), cursor.field_name()));
        }
        more = cursor.goto_next_sibling();
    }
    list
}

/// Reports a plus before an operand, and a minus before 0.0, whose sign some compilers drop. The grammar includes the sign
/// of a number in the number.
pub(crate) fn signs(tree: &Tree, text: &str, mistakes: &mut Mistakes<'_>) {
    let mut cursor = tree.walk();
    loop {
        let node = cursor.node();
        let number = matches!(node.kind(), "integer_literal" | "real_literal");
        if (number || node.kind() == "unary_expression") && said(node, text).starts_with('+') {
            mistakes.push(node.start_byte(), "`+` before an operand", "the operand alone");
        }
        if is_minus_zero(node, text) {
            mistakes.push(node.start_byte(), shown(node, text), format!("`{MINUS_ZERO}`"));
        }
        if cursor.goto_first_child() {
            continue;
        }
        while !cursor.goto_next_sibling() {
            if !cursor.goto_parent() {
                return;
            }
        }
    }
}

fn is_minus_zero(node: Node<'_>, text: &str) -> bool {
    let is_zero = |node: Node<'_>| node.kind() == "real_literal" && said(node, text).parse() == Ok(0.0);
    if node.kind() != "unary_expression" {
        return is_zero(node) && said(node, text).starts_with('-');
    }
    let mut operand = node.child_by_field_name("operand");
    while let Some(inside) = operand.filter(|operand| operand.kind() == "parenthesized_expression") {
        operand = children(inside).into_iter().map(|(part, _)| part).find(Node::is_named);
    }
    // A zero with a sign has been reported separately.
    said(node, text).starts_with('-') && operand.is_some_and(|zero| is_zero(zero) && !said(zero, text).starts_with('-'))
}

//! What the macro refuses: `refused.txt`, each construct outside the subset with its messages. No rule stands here.

use crate::copy::Copy;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use syn::parse::{ParseStream, Parser};

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("unit/refused.txt")
}

#[test]
fn every_rejection_says_what_to_write() {
    transcript::compare(file(), |form, text| match form {
        "item" => rejected(text),
        "copy" => syn::parse_str::<Copy>(text).map_or_else(|error| said(&error), |copy| copy.expand().to_string()),
        other => panic!("no such form: {other}"),
    });
}

#[test]
fn the_guide_has_a_row_for_every_rejection() {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(file()).expect("the rejections");
    let names: BTreeSet<_> =
        text.lines().filter_map(|line| line.strip_prefix("== ")?.split_once(": ")).map(|(_, name)| name).collect();
    let guide = fs::read_to_string(package.join("../../../docs/portable-rust.md")).expect("the guide");
    let (_, table) = guide.split_once("## What is rejected").expect("the chapter");
    let (table, _) = table.split_once("\n## ").expect("the next chapter");
    let rows: BTreeSet<_> = table
        .lines()
        .filter(|line| line.starts_with("| ") && line.ends_with("` |"))
        .filter_map(|line| line.rsplit('`').nth(1))
        .collect();
    assert_eq!(names, rows, "a row of the guide ends with the name of its rejection");
}

/// What is rejected of all portable items of a text, with the place of each.
fn rejected(text: &str) -> String {
    let mut items = Vec::new();
    portable_items(text.parse().expect("tokens"), &mut items);
    assert!(!items.is_empty(), "nothing is portable: {text}");
    let of_item = |(arguments, item): (TokenStream, TokenStream)| {
        let (_, rejections) = crate::describe(arguments, item);
        rejections.errors().iter().map(said).collect::<Vec<_>>()
    };
    items.into_iter().flat_map(of_item).collect::<Vec<_>>().join("\n")
}

/// Line and columns, from the first to the last that is marked, and the message.
fn said(error: &syn::Error) -> String {
    let (start, end) = (error.span().start(), error.span().end());
    let end_line = if end.line == start.line { String::new() } else { format!("{}:", end.line) };
    format!("{}:{}-{end_line}{}: {error}", start.line, start.column + 1, end.column)
}

/// The arguments of each attribute `#[portable]`, and the item after it.
fn portable_items(tokens: TokenStream, found: &mut Vec<(TokenStream, TokenStream)>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, tree) in trees.iter().enumerate() {
        let TokenTree::Group(group) = tree else { continue };
        let mut inside = group.stream().into_iter();
        if group.delimiter() == Delimiter::Bracket
            && matches!(inside.next(), Some(TokenTree::Ident(name)) if name == "portable")
        {
            let arguments = match inside.next() {
                Some(TokenTree::Group(arguments)) => arguments.stream(),
                _ => TokenStream::new(),
            };
            let first = |input: ParseStream<'_>| {
                let item: syn::Item = input.parse()?;
                input.parse::<TokenStream>()?;
                Ok(item.into_token_stream())
            };
            let item = first.parse2(trees[index + 1..].iter().cloned().collect()).expect("an item");
            found.push((arguments, item));
        } else {
            portable_items(group.stream(), found);
        }
    }
}

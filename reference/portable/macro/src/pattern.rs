//! Patterns of a `match`: constants and the wildcard.

use crate::reject::Rejections;
use proc_macro2::TokenStream;
use quote::quote;

/// Describes the values that choose an arm; none: the wildcard.
pub fn describe(pattern: &syn::Pat, rejections: &mut Rejections) -> Vec<TokenStream> {
    match pattern {
        syn::Pat::Wild(_) => Vec::new(),
        syn::Pat::Or(alternatives) => {
            alternatives.cases.iter().flat_map(|case| describe(case, rejections)).collect()
        }
        syn::Pat::Paren(paren) => describe(&paren.pat, rejections),
        syn::Pat::Path(path) => vec![quote!(|| ::portable::scalar(&#path))],
        syn::Pat::Lit(literal) => literal_pattern(literal, rejections),
        syn::Pat::Guard(guard) => {
            rejections.push(guard, "a guard has no counterpart; write an `if` inside the arm");
            Vec::new()
        }
        syn::Pat::Range(range) => {
            rejections.push(range, "a range has no counterpart in a match; write `if` with comparisons");
            Vec::new()
        }
        other => {
            rejections.push(other, "an arm is chosen by constants; write a variant, a literal or `_`");
            Vec::new()
        }
    }
}

fn literal_pattern(literal: &syn::PatLit, rejections: &mut Rejections) -> Vec<TokenStream> {
    match &literal.lit {
        syn::Lit::Bool(_) => vec![quote!(|| ::portable::scalar(&#literal))],
        syn::Lit::Int(integer) if !integer.suffix().is_empty() => vec![quote!(|| ::portable::scalar(&#literal))],
        syn::Lit::Int(integer) => {
            rejections.push(integer, format!("an integer names its type; write `{integer}i32` or `{integer}u32`"));
            Vec::new()
        }
        other => {
            rejections.push(other, "an arm is chosen by a variant, an integer or a bool; write `if` for anything else");
            Vec::new()
        }
    }
}

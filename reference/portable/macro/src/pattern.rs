//! Patterns of a `match`: constants and the wildcard.

use crate::reject::Rejections;
use proc_macro2::TokenStream;
use quote::quote;
use syn::Pat;

/// Describes the values that choose an arm; empty for the wildcard.
pub fn describe(pattern: &Pat, rejections: &mut Rejections) -> Vec<TokenStream> {
    match pattern {
        Pat::Wild(_) => Vec::new(),
        Pat::Paren(paren) => describe(&paren.pat, rejections),
        Pat::Or(alternatives) => {
            let mut values = Vec::new();
            for alternative in &alternatives.cases {
                if matches!(alternative, Pat::Wild(_)) {
                    rejections.push(alternative, "`_` includes the others; write it alone");
                }
                values.extend(describe(alternative, rejections));
            }
            values
        }
        Pat::Path(path) => vec![quote!(|| ::portable::scalar(&#path))],
        // A name of one segment in capital letters is a constant: rustc reports an error if it does not exist.
        Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() && is_upper(&name.ident) => {
            vec![quote!(|| ::portable::scalar(&#name))]
        }
        Pat::Lit(literal) => literal_pattern(literal, rejections),
        other => {
            rejections.push(other, instead(other));
            Vec::new()
        }
    }
}

fn literal_pattern(literal: &syn::PatLit, rejections: &mut Rejections) -> Vec<TokenStream> {
    match &literal.lit {
        syn::Lit::Bool(_) => return vec![quote!(|| ::portable::scalar(&#literal))],
        syn::Lit::Int(integer) => match integer.suffix() {
            "i32" | "u32" | "usize" => return vec![quote!(|| ::portable::scalar(&#literal))],
            _ => {
                let digits = integer.base10_digits();
                rejections.push(integer, format!("an integer names its type; write `{digits}i32` or `{digits}u32`"));
            }
        },
        other => {
            rejections.push(other, "an arm is chosen by a variant, an integer or a bool; write `if` for anything else")
        }
    }
    Vec::new()
}

fn instead(pattern: &Pat) -> &'static str {
    match pattern {
        Pat::Guard(_) => "a guard has no counterpart; write an `if` inside the arm",
        Pat::Range(_) => "a range has no counterpart; write `if` with comparisons",
        Pat::Ident(_) => "an arm gives no name to the value; write `_`, and the value's own name in the arm",
        Pat::Tuple(_) | Pat::TupleStruct(_) | Pat::Struct(_) | Pat::Slice(_) | Pat::Reference(_) => {
            "a pattern takes nothing apart; write a `match` on one field or element"
        }
        _ => "an arm is chosen by constants; write a variant, a literal or `_`",
    }
}

fn is_upper(name: &syn::Ident) -> bool {
    name.to_string().starts_with(char::is_uppercase)
}

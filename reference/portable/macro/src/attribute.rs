//! Attributes. An attribute that changes an item in Rust would not change its description in the IR.

use crate::reject::Rejections;
use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// Rejects every attribute inside a function except doc comments. Works on the tokens, where no attribute can hide.
pub fn reject_inside(tokens: TokenStream, rejections: &mut Rejections) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Group(group) => reject_inside(group.stream(), rejections),
            TokenTree::Punct(ref hash) if hash.as_char() == '#' => {
                let inner = tokens.next_if(|next| matches!(next, TokenTree::Punct(mark) if mark.as_char() == '!'));
                if let Some(TokenTree::Group(content)) = tokens.next_if(|next| is_bracket(next) && !is_doc(next)) {
                    let attribute: TokenStream =
                        [Some(token), inner, Some(content.into())].into_iter().flatten().collect();
                    rejections.push(
                        attribute,
                        "an attribute here is not seen by the description; put it on the item or remove it",
                    );
                }
            }
            _ => {}
        }
    }
}

fn is_bracket(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket)
}

fn is_doc(token: &TokenTree) -> bool {
    let TokenTree::Group(group) = token else { return false };
    matches!(group.stream().into_iter().next(), Some(TokenTree::Ident(name)) if name == "doc")
}

/// Rejects attributes that may remove a field or a variant while its description stays. An attribute of the item itself is
/// harmless: rustc evaluates it before it runs the macro.
pub fn reject_conditions(attributes: &[syn::Attribute], rejections: &mut Rejections) {
    for attribute in attributes {
        if attribute.path().is_ident("cfg") || attribute.path().is_ident("cfg_attr") {
            rejections.push(attribute, "the description does not know this condition; write it at the whole item");
        }
    }
}

//! Paths as seen from one module further inside, where the IR is.

use proc_macro2::{Group, Ident, Spacing, TokenStream, TokenTree};
use quote::quote;

/// The tokens for use in an inner module: `super::x` becomes `super::super::x`, `self::x` becomes `super::x`.
pub fn from_inside(tokens: TokenStream) -> TokenStream {
    let mut moved = TokenStream::new();
    let (mut colon, mut continues) = (false, false);
    for token in tokens {
        let separator = matches!(&token, TokenTree::Punct(mark) if mark.as_char() == ':');
        let joint = matches!(&token, TokenTree::Punct(mark) if mark.spacing() == Spacing::Joint);
        match token {
            TokenTree::Group(group) => {
                let mut inner = Group::new(group.delimiter(), from_inside(group.stream()));
                inner.set_span(group.span());
                moved.extend([TokenTree::from(inner)]);
            }
            TokenTree::Ident(head) if head == "super" && !continues => moved.extend(quote!(#head::super)),
            TokenTree::Ident(head) if head == "self" => {
                moved.extend([TokenTree::from(Ident::new("super", head.span()))]);
            }
            other => moved.extend([other]),
        }
        continues = separator && colon;
        colon = separator && joint;
    }
    moved
}

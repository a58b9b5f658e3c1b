//! The violations of the subset that one item has, gathered so that all are shown at once. No rule stands here.

use proc_macro2::TokenStream;
use quote::ToTokens;

/// Violations in the order of their discovery.
#[derive(Default)]
pub struct Rejections {
    errors: Vec<syn::Error>,
}

impl Rejections {
    /// Rejects `tokens`; the message says what to write instead.
    pub fn push(&mut self, tokens: impl ToTokens, message: impl std::fmt::Display) {
        self.errors.push(syn::Error::new_spanned(tokens, message));
    }

    /// Rejects every attribute but a doc comment: what it would change in Rust, it would not change in the IR.
    pub fn attributes(&mut self, attributes: &[syn::Attribute]) {
        for attribute in attributes.iter().filter(|attribute| !attribute.path().is_ident("doc")) {
            self.push(attribute, "an attribute has no counterpart here; put it on the item or remove it");
        }
    }

    /// Whether nothing was rejected.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// One `compile_error!` for each violation.
    pub fn into_compile_errors(self) -> TokenStream {
        self.errors.into_iter().map(|error| error.to_compile_error()).collect()
    }
}

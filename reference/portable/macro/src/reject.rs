//! Collects the violations of the subset in one item, so that all are shown at once. No rules here.

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

    /// Whether nothing was rejected.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// The number of violations.
    pub fn len(&self) -> usize {
        self.errors.len()
    }

    /// The violations.
    #[cfg(test)]
    pub fn errors(&self) -> &[syn::Error] {
        &self.errors
    }

    /// One `compile_error!` for each violation.
    pub fn into_compile_errors(self) -> TokenStream {
        self.errors.into_iter().map(|error| error.to_compile_error()).collect()
    }
}

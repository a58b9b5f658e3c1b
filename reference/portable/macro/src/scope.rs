//! The names that are visible at a place of a function, and their kinds.

use crate::kind::Kind;
use crate::name;
use crate::reject::Rejections;
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::Ident;

/// The names that are visible at a place of a function.
pub struct Scope {
    /// the function itself, which must not call itself
    pub function: Ident,
    /// the type parameter
    pub real: Option<Ident>,
    names: Vec<(Ident, Kind)>,
}

impl Scope {
    /// The scope of a function, before its parameters.
    pub fn new(function: Ident, real: Option<Ident>) -> Self {
        Self { function, real, names: Vec::new() }
    }

    /// Enters a parameter, a local or a loop variable.
    pub fn enter(&mut self, name: &Ident, kind: Kind, rejections: &mut Rejections) {
        name::check(name, rejections);
        if self.kind(name).is_some() {
            rejections.push(
                name,
                format!("`{name}` is already visible here and Structured Text has one scope; write another name"),
            );
        }
        self.names.push((name.clone(), kind));
    }

    /// Enters every name in a rejected pattern, so that uses of the names are not rejected too.
    pub fn enter_rejected(&mut self, pattern: &impl ToTokens) {
        self.enter_tokens(pattern.to_token_stream());
    }

    fn enter_tokens(&mut self, tokens: TokenStream) {
        for token in tokens {
            match token {
                TokenTree::Ident(name) => self.names.push((name, Kind::Unknown)),
                TokenTree::Group(group) => self.enter_tokens(group.stream()),
                _ => {}
            }
        }
    }

    /// The kind of a parameter or a local; `None` for any other name.
    pub fn kind(&self, name: &Ident) -> Option<Kind> {
        self.names.iter().rev().find(|(known, _)| known == name).map(|(_, kind)| *kind)
    }

    /// The number of visible names: [`Scope::leave`] takes it at the end of their block.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// Removes the names that were entered since.
    pub fn leave(&mut self, len: usize) {
        self.names.truncate(len);
    }
}

//! `copy!(to = from: field, field)`: copies fields by name. One assignment per field, in Rust and in the IR.

use proc_macro2::TokenStream;
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Expr, ExprAssign, Ident, Token, parse_quote};

const FORM: &str = "fields are taken over by their names; write `copy!(to = from: field, field);`";

/// The assignments of a `copy!`, in the order of its fields.
pub struct Copy(Vec<ExprAssign>);

impl Parse for Copy {
    fn parse(input: ParseStream) -> syn::Result<Self> {
        let ExprAssign { left, right, .. } = input.parse().map_err(|error| syn::Error::new(error.span(), FORM))?;
        input.parse::<Token![:]>().map_err(|error| syn::Error::new(error.span(), FORM))?;
        let fields = Punctuated::<Ident, Token![,]>::parse_terminated(input)?;
        if fields.is_empty() {
            return Err(input.error(FORM));
        }
        Ok(Self(fields.iter().map(|field| parse_quote!(#left.#field = #right.#field)).collect()))
    }
}

impl Copy {
    /// The statements in Rust.
    pub fn expand(&self) -> TokenStream {
        let assignments = &self.0;
        quote!(#(#assignments;)*)
    }
}

/// The assignments, if the macro is a well-formed `copy!`. The macro itself rejects any other form.
pub fn assignments(call: &syn::Macro) -> Option<Vec<Expr>> {
    call.path.segments.last().filter(|last| last.ident == "copy")?;
    let copy = call.parse_body::<Copy>().unwrap_or(Copy(Vec::new()));
    Some(copy.0.into_iter().map(Expr::Assign).collect())
}

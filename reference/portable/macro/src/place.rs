//! Places: a local or a parameter, or a field or an element of one. Indices are described in `expr`.

use crate::reject::Rejections;
use crate::scope::Scope;
use crate::{expr, outside};
use proc_macro2::TokenStream;
use quote::quote;

/// Describes a place; rejects every other expression.
pub fn describe(expression: &syn::Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    let mut projections = Vec::new();
    let mut inner = expression;
    loop {
        match inner {
            syn::Expr::Field(field) => {
                match &field.member {
                    syn::Member::Named(name) => {
                        projections.push(quote!(::portable::Projection::Field { name: stringify!(#name) }));
                    }
                    member @ syn::Member::Unnamed(_) => {
                        rejections.push(member, "a tuple has no counterpart; write a struct with named fields");
                    }
                }
                inner = &field.base;
            }
            syn::Expr::Index(element) => {
                let index = expr::index(&element.index, scope, rejections);
                projections.push(quote!(::portable::Projection::Index { index: &#index }));
                inner = &element.expr;
            }
            syn::Expr::Paren(paren) => inner = &paren.expr,
            syn::Expr::Group(group) => inner = &group.expr,
            syn::Expr::Path(path) if root(path, scope).is_some() => {
                projections.reverse();
                return quote!(::portable::Place { root: stringify!(#path), projections: &[#(#projections),*] });
            }
            syn::Expr::Path(path) => {
                rejections
                    .push(path, "a place begins with a local or a parameter; write one, or pass this as a parameter");
                return TokenStream::new();
            }
            other => {
                outside::reject(other, scope, rejections);
                return TokenStream::new();
            }
        }
    }
}

/// Whether the expression has the form of a place that begins with a visible name.
pub fn is_place(expression: &syn::Expr, scope: &Scope) -> bool {
    match expression {
        syn::Expr::Field(field) => is_place(&field.base, scope),
        syn::Expr::Index(element) => is_place(&element.expr, scope),
        syn::Expr::Paren(paren) => is_place(&paren.expr, scope),
        syn::Expr::Group(group) => is_place(&group.expr, scope),
        syn::Expr::Path(path) => root(path, scope).is_some(),
        _ => false,
    }
}

fn root<'p>(path: &'p syn::ExprPath, scope: &Scope) -> Option<&'p syn::Ident> {
    path.path.get_ident().filter(|name| scope.kind(name).is_some())
}

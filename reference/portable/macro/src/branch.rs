//! `if` and `match`, with or without a value.

use crate::reject::Rejections;
use crate::scope::Scope;
use crate::{block, expr, pattern};
use proc_macro2::TokenStream;
use quote::quote;

/// Describes an `if`.
pub fn describe_if(
    branch: &syn::ExprIf,
    wants_value: bool,
    scope: &mut Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    let outer = scope.len();
    let condition = expr::operand(&branch.cond, scope, rejections);
    let then = block::describe(&branch.then_branch, wants_value, scope, rejections);
    scope.leave(outer);
    let otherwise = match &branch.else_branch {
        Some((_, otherwise)) => describe_body(otherwise, wants_value, scope, rejections),
        None => quote!(::portable::CodeBlock { statements: &[], value: None }),
    };
    quote!(::portable::Expr::If { condition: &#condition, then: #then, otherwise: #otherwise })
}

/// Describes a `match`.
pub fn describe_match(
    choice: &syn::ExprMatch,
    wants_value: bool,
    scope: &mut Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    let scrutinee = expr::operand(&choice.expr, scope, rejections);
    let mut arms = Vec::new();
    for arm in &choice.arms {
        let (outer, before) = (scope.len(), rejections.len());
        let patterns = pattern::describe(&arm.pat, rejections);
        if rejections.len() > before {
            scope.enter_rejected(&arm.pat);
        }
        let body = describe_body(&arm.body, wants_value, scope, rejections);
        scope.leave(outer);
        arms.push(quote!(::portable::Arm { patterns: &[#(#patterns),*], body: #body }));
    }
    quote!(::portable::Expr::Match { scrutinee: &#scrutinee, arms: &[#(#arms),*] })
}

/// Describes the body of an arm or of `else`: a block, or an expression without braces.
fn describe_body(body: &syn::Expr, wants_value: bool, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match body {
        syn::Expr::Block(inner) if inner.label.is_none() => {
            block::describe(&inner.block, wants_value, scope, rejections)
        }
        _ if wants_value => {
            let value = expr::whole(body, scope, rejections);
            quote!(::portable::CodeBlock { statements: &[], value: Some(&#value) })
        }
        _ => {
            let statement = block::expression(body, scope, rejections);
            quote!(::portable::CodeBlock { statements: &[#statement], value: None })
        }
    }
}

//! Blocks and statements. Expressions are described in `expr`.

use crate::kind::{self, Kind};
use crate::reject::Rejections;
use crate::scope::Scope;
use crate::{branch, call, copy, expr, outside, place, real, ty};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{BinOp, Expr, Pat, Stmt};

/// Describes a block. The names that it declares end with it.
pub fn describe(block: &syn::Block, wants_value: bool, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    let outer = scope.len();
    let mut statements = Vec::new();
    let mut value = quote!(None);
    for (position, statement) in block.stmts.iter().enumerate() {
        let last = position + 1 == block.stmts.len();
        match statement {
            Stmt::Expr(tail, None) if last && wants_value => {
                let tail = expr::whole(tail, scope, rejections);
                value = quote!(Some(&#tail));
            }
            _ => statements.push(describe_statement(statement, scope, rejections)),
        }
    }
    scope.leave(outer);
    quote!(::portable::CodeBlock { statements: &[#(#statements),*], value: #value })
}

fn describe_statement(statement: &Stmt, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match statement {
        Stmt::Local(local) => return describe_let(local, scope, rejections),
        Stmt::Expr(value, _) => return expression(value, scope, rejections),
        Stmt::Item(item) => {
            rejections.push(item, "an item inside a function is not described; write it next to the function")
        }
        Stmt::Macro(call) => match copy::assignments(&call.mac) {
            Some(assignments) => {
                let described = assignments.iter().map(|each| expression(each, scope, rejections));
                return quote!(#(#described),*);
            }
            None => rejections.push(call, outside::MACRO),
        },
    }
    TokenStream::new()
}

fn describe_let(local: &syn::Local, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    let (pattern, declared) = match &local.pat {
        Pat::Type(typed) => {
            ty::held(&typed.ty, rejections);
            (&*typed.pat, ty::scalar(&typed.ty, scope.real.as_ref()))
        }
        pattern => (pattern, None),
    };
    let (mut value, mut kind) = (TokenStream::new(), Kind::Unknown);
    match &local.init {
        Some(init) => {
            if let (None, Some(ty), Pat::Ident(name)) = (&init.diverge, default_of(&init.expr, scope), pattern) {
                return describe_default(&name.ident, &ty, scope, rejections);
            }
            if let Some((token, _)) = &init.diverge {
                rejections.push(token, "`let ... else` has no counterpart; write `if`");
            }
            value = expr::initial(&init.expr, scope, rejections);
            kind = declared.unwrap_or_else(|| kind::classify(&init.expr, scope));
        }
        None => rejections.push(local, "a local has a value from the start; write `let name = value;`"),
    }
    match pattern {
        Pat::Ident(name) if name.by_ref.is_none() && name.subpat.is_none() => {
            let name = &name.ident;
            scope.enter(name, kind, rejections);
            return quote!(::portable::Statement::Let { name: stringify!(#name), value: &#value });
        }
        Pat::Wild(_) => rejections.push(pattern, "a local has a name; write the call alone, as a statement"),
        _ => rejections.push(pattern, "a local is one plain name; write one `let` for each value"),
    }
    scope.enter_rejected(pattern);
    TokenStream::new()
}

/// Describes a local struct that starts with the values of `Type::default()`.
fn describe_default(name: &Ident, ty: &syn::Type, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    scope.enter(name, Kind::Unknown, rejections);
    ty::held(ty, rejections);
    quote! {
        ::portable::Statement::Default {
            name: stringify!(#name),
            ty: <#ty as ::portable::Portable>::TY,
            leaves: |take| ::portable::Portable::visit(&<#ty as ::core::default::Default>::default(), take),
        }
    }
}

/// The type in `Type::default()`: the start value of a local struct.
fn default_of(value: &Expr, scope: &Scope) -> Option<syn::Type> {
    let Expr::Call(call) = expr::bare(value) else { return None };
    let Expr::Path(function) = &*call.func else { return None };
    let mut path = function.path.clone();
    let last = path.segments.pop()?;
    path.segments.pop_punct();
    let named = path.segments.last()?.ident.to_string();
    let is_default = last.ident == "default" && last.arguments.is_none() && call.args.is_empty();
    let is_struct = function.qself.is_none() && named.starts_with(char::is_uppercase) && !real::is_path(&path, scope);
    (is_default && is_struct).then(|| syn::Type::Path(syn::TypePath { attrs: Vec::new(), qself: None, path }))
}

/// Describes an expression whose value is not used.
pub fn expression(expression: &Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    let value = match expression {
        Expr::Group(group) => return self::expression(&group.expr, scope, rejections),
        Expr::Assign(assign) => {
            let place = place::describe(&assign.left, scope, rejections);
            let value = expr::whole(&assign.right, scope, rejections);
            return quote!(::portable::Statement::Assign { place: #place, value: &#value });
        }
        Expr::Binary(binary) if is_compound(&binary.op) => {
            let place = place::describe(&binary.left, scope, rejections);
            let value = expr::compound(binary, &place, scope, rejections);
            return quote!(::portable::Statement::Assign { place: #place, value: &#value });
        }
        Expr::ForLoop(each) => return describe_for(each, scope, rejections),
        Expr::Call(call) if is_note(call) => return describe_note(call, rejections),
        Expr::Call(call) => call::describe(call, true, scope, rejections),
        Expr::If(branch) => branch::describe_if(branch, false, scope, rejections),
        Expr::Match(choice) => branch::describe_match(choice, false, scope, rejections),
        other => {
            outside::reject_statement(other, scope, rejections);
            return TokenStream::new();
        }
    };
    quote!(::portable::Statement::Expr { value: &#value })
}

/// Whether a call is a call of `note`.
fn is_note(call: &syn::ExprCall) -> bool {
    matches!(&*call.func, Expr::Path(function) if function.path.segments.last().is_some_and(|last| last.ident == "note"))
}

fn describe_note(call: &syn::ExprCall, rejections: &mut Rejections) -> TokenStream {
    match call.args.first() {
        Some(Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. })) if call.args.len() == 1 => {
            quote!(::portable::Statement::Note { text: #text })
        }
        _ => {
            rejections.push(call, "a note is a text in quotes");
            TokenStream::new()
        }
    }
}

/// Whether the operator is a compound assignment such as `+=`.
pub fn is_compound(operator: &BinOp) -> bool {
    matches!(
        operator,
        BinOp::AddAssign(_)
            | BinOp::SubAssign(_)
            | BinOp::MulAssign(_)
            | BinOp::DivAssign(_)
            | BinOp::RemAssign(_)
            | BinOp::BitXorAssign(_)
            | BinOp::BitAndAssign(_)
            | BinOp::BitOrAssign(_)
            | BinOp::ShlAssign(_)
            | BinOp::ShrAssign(_)
    )
}

/// Describes a loop.
pub fn describe_for(each: &syn::ExprForLoop, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    if let Some(label) = &each.label {
        rejections.push(label, "loops run to their end; remove the label");
    }
    let (mut from, mut to) = (TokenStream::new(), TokenStream::new());
    match expr::bare(&each.expr) {
        Expr::Range(syn::ExprRange {
            start: Some(start),
            end: Some(end),
            limits: syn::RangeLimits::HalfOpen(_),
            ..
        }) => {
            from = expr::index(start, scope, rejections);
            to = expr::index(end, scope, rejections);
        }
        other => rejections.push(other, "a loop counts over a range with known ends; write `for i in 0..N`"),
    }
    let outer = scope.len();
    let mut variable = TokenStream::new();
    match &*each.pat {
        Pat::Ident(name) if name.by_ref.is_none() && name.mutability.is_none() && name.subpat.is_none() => {
            scope.enter(&name.ident, Kind::Integer, rejections);
            variable = quote!(#name);
        }
        other => {
            rejections.push(other, "the loop variable is a plain name; write `for i in 0..N`");
            scope.enter_rejected(other);
        }
    }
    let body = describe(&each.body, false, scope, rejections);
    scope.leave(outer);
    quote!(::portable::Statement::For { variable: stringify!(#variable), from: &#from, to: &#to, body: #body })
}

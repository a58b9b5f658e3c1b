//! Blocks and statements, and the names that are visible in them. Expressions are described in `expr`.

use crate::expr;
use crate::function::Mode;
use crate::place;
use crate::reject::Rejections;
use proc_macro2::TokenStream;
use quote::quote;
use syn::Ident;

/// The names that are visible at a place of a function.
pub struct Scope {
    /// the function itself, which must not call itself
    pub function: Ident,
    /// the type parameter
    pub real: Option<Ident>,
    names: Vec<(Ident, Option<Mode>)>,
}

impl Scope {
    /// Of a function, before its parameters.
    pub fn new(function: Ident, real: Option<Ident>) -> Self {
        Self { function, real, names: Vec::new() }
    }

    /// Enters a parameter.
    pub fn enter_parameter(&mut self, name: &Ident, mode: Mode, rejections: &mut Rejections) {
        self.enter(name, Some(mode), rejections);
    }

    /// Enters a local.
    fn enter_local(&mut self, name: &Ident, rejections: &mut Rejections) {
        self.enter(name, None, rejections);
    }

    fn enter(&mut self, name: &Ident, mode: Option<Mode>, rejections: &mut Rejections) {
        if self.names.iter().any(|(known, _)| known == name) {
            rejections.push(
                name,
                format!("`{name}` is already visible here and Structured Text has one scope; write another name"),
            );
        }
        self.names.push((name.clone(), mode));
    }

    /// Whether the name is a parameter or a local.
    pub fn has(&self, name: &Ident) -> bool {
        self.names.iter().any(|(known, _)| known == name)
    }

    /// How the name is borrowed, if it is a borrowed parameter.
    pub fn borrowed(&self, name: &Ident) -> Option<Mode> {
        let mode = self.names.iter().rev().find(|(known, _)| known == name)?.1?;
        (mode != Mode::Value).then_some(mode)
    }
}

/// Describes a block; the names that it declares end with it.
pub fn describe(
    block: &syn::Block,
    wants_value: bool,
    scope: &mut Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    let outer = scope.names.len();
    let mut statements = Vec::new();
    let mut value = quote!(None);
    for (position, statement) in block.stmts.iter().enumerate() {
        let last = position + 1 == block.stmts.len();
        match statement {
            syn::Stmt::Expr(tail, None) if last && wants_value => {
                let tail = expr::whole(tail, scope, rejections);
                value = quote!(Some(&#tail));
            }
            _ => statements.push(describe_statement(statement, scope, rejections)),
        }
    }
    scope.names.truncate(outer);
    quote!(::portable::Block { statements: &[#(#statements),*], value: #value })
}

/// Describes an arm or a branch that may be a bare expression.
pub fn describe_branch(
    body: &syn::Expr,
    wants_value: bool,
    scope: &mut Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    match body {
        syn::Expr::Block(block) if block.label.is_none() => describe(&block.block, wants_value, scope, rejections),
        _ if wants_value => {
            let value = expr::whole(body, scope, rejections);
            quote!(::portable::Block { statements: &[], value: Some(&#value) })
        }
        _ => {
            let statement = expression_statement(body, scope, rejections);
            quote!(::portable::Block { statements: &[#statement], value: None })
        }
    }
}

fn describe_statement(statement: &syn::Stmt, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match statement {
        syn::Stmt::Local(local) => describe_let(local, scope, rejections),
        syn::Stmt::Expr(expression, _) => expression_statement(expression, scope, rejections),
        syn::Stmt::Item(item) => {
            rejections.push(item, "an item inside a function has no description; write it beside the function");
            TokenStream::new()
        }
        syn::Stmt::Macro(call) => {
            rejections.push(call, "a macro has no counterpart in C or Structured Text; write what it expands to");
            TokenStream::new()
        }
    }
}

fn describe_let(local: &syn::Local, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    rejections.attributes(&local.attrs);
    let pattern = match &local.pat {
        syn::Pat::Type(typed) => &*typed.pat,
        pattern => pattern,
    };
    let syn::Pat::Ident(syn::PatIdent { by_ref: None, subpat: None, ident, .. }) = pattern else {
        rejections.push(pattern, "a local is one plain name; write one `let` for each value");
        return TokenStream::new();
    };
    let Some(init) = &local.init else {
        rejections.push(local, "a local has a value from the start; write `let name = value;`");
        return TokenStream::new();
    };
    if let Some((_, diverge)) = &init.diverge {
        rejections.push(diverge, "`let ... else` has no counterpart; write `if`");
    }
    let value = expr::whole(&init.expr, scope, rejections);
    scope.enter_local(ident, rejections);
    quote!(::portable::Statement::Let { name: stringify!(#ident), value: &#value })
}

/// Describes an expression whose value is not used.
fn expression_statement(expression: &syn::Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match expression {
        syn::Expr::Assign(assign) => {
            rejections.attributes(&assign.attrs);
            let place = place::describe(&assign.left, scope, rejections);
            let value = expr::whole(&assign.right, scope, rejections);
            quote!(::portable::Statement::Assign { place: #place, value: &#value })
        }
        syn::Expr::Binary(binary) if is_compound(&binary.op) => {
            let place = place::describe(&binary.left, scope, rejections);
            let value = expr::compound(binary, scope, rejections);
            quote!(::portable::Statement::Assign { place: #place, value: &#value })
        }
        syn::Expr::ForLoop(each) => describe_for(each, scope, rejections),
        syn::Expr::If(_) | syn::Expr::Match(_) | syn::Expr::Call(_) => {
            let value = expr::statement(expression, scope, rejections);
            quote!(::portable::Statement::Expr { value: &#value })
        }
        other => {
            expr::reject(other, rejections);
            TokenStream::new()
        }
    }
}

/// Whether the operator is `+=` or one of its kind.
pub fn is_compound(operator: &syn::BinOp) -> bool {
    use syn::BinOp;
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

fn describe_for(each: &syn::ExprForLoop, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    rejections.attributes(&each.attrs);
    if let Some(label) = &each.label {
        rejections.push(label, "loops run to their end; remove the label");
    }
    let range = match &*each.expr {
        syn::Expr::Range(syn::ExprRange {
            start: Some(start),
            end: Some(end),
            limits: syn::RangeLimits::HalfOpen(_),
            ..
        }) => Some((&**start, &**end)),
        other => {
            rejections.push(other, "a loop counts over a constant range; write `for i in 0..N`");
            None
        }
    };
    let variable = match &*each.pat {
        syn::Pat::Ident(syn::PatIdent { by_ref: None, mutability: None, subpat: None, ident, .. }) => ident.clone(),
        other => {
            rejections.push(other, "the loop variable is a plain name; write `for i in 0..N`");
            quote::format_ident!("i")
        }
    };
    let (from, to) = match range {
        Some((from, to)) => (expr::index(from, scope, rejections), expr::index(to, scope, rejections)),
        None => (TokenStream::new(), TokenStream::new()),
    };
    let outer = scope.names.len();
    scope.enter_local(&variable, rejections);
    let body = describe(&each.body, false, scope, rejections);
    scope.names.truncate(outer);
    quote!(::portable::Statement::For { variable: stringify!(#variable), from: &#from, to: &#to, body: #body })
}

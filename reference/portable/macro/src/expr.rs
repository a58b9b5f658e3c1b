//! Expressions and their descriptions in the IR. The reasons for rejecting other expressions are in `outside`.
//!
//! A call with a mutable argument, an `if` and a `match` may only be a whole value: alone to the right of `let` or `=`, or
//! at the end of a block. Languages disagree about when such an operand is evaluated.

use crate::kind::{self, Kind};
use crate::reject::Rejections;
use crate::scope::Scope;
use crate::{block, branch, call, outside, place, real};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote, quote_spanned};
use syn::spanned::Spanned;
use syn::{BinOp, Expr, Lit, UnOp};

/// The expression without parentheses around it.
pub fn bare(expression: &Expr) -> &Expr {
    match expression {
        Expr::Paren(paren) => bare(&paren.expr),
        Expr::Group(group) => bare(&group.expr),
        other => other,
    }
}

/// Describes the right side of `let`: a whole value or an array.
pub fn initial(expression: &Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match bare(expression) {
        Expr::Array(array) => {
            let elements: Vec<_> = array.elems.iter().map(|element| operand(element, scope, rejections)).collect();
            quote!(::portable::Expr::Array { elements: &[#(#elements),*] })
        }
        Expr::Repeat(repeat) => {
            let (value, len) = (operand(&repeat.expr, scope, rejections), &repeat.len);
            quote!(::portable::Expr::Repeat { value: &#value, len: #len })
        }
        other => whole(other, scope, rejections),
    }
}

/// Describes a whole value: the right side of `let` or `=`, or the end of a block.
pub fn whole(expression: &Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match bare(expression) {
        Expr::Call(call) => call::describe(call, true, scope, rejections),
        Expr::If(branch) => branch::describe_if(branch, true, scope, rejections),
        Expr::Match(choice) => branch::describe_match(choice, true, scope, rejections),
        other => operand(other, scope, rejections),
    }
}

/// Describes an expression without side effects, which may be an operand.
pub fn operand(expression: &Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match bare(expression) {
        Expr::Lit(literal) => describe_literal(&literal.lit, rejections),
        Expr::Path(path) => describe_path(path, scope, rejections),
        Expr::Field(_) | Expr::Index(_) => {
            let place = place::describe(expression, scope, rejections);
            quote!(::portable::Expr::Read { place: #place })
        }
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_) | UnOp::Not(_)) => {
            describe_unary(unary, scope, rejections)
        }
        Expr::Binary(binary) if !block::is_compound(&binary.op) => {
            let operator = operator(&binary.op, rejections);
            kind::check_binary(binary, scope, rejections);
            let (left, right) = (operand(&binary.left, scope, rejections), operand(&binary.right, scope, rejections));
            quote!(::portable::Expr::Binary { operator: ::portable::Binary::#operator, left: &#left, right: &#right })
        }
        Expr::Call(call) => call::describe(call, false, scope, rejections),
        other => {
            outside::reject(other, scope, rejections);
            TokenStream::new()
        }
    }
}

/// Describes an index or the bound of a loop: a `usize` that is known when the function is specialised.
pub fn index(expression: &Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match bare(expression) {
        Expr::Lit(syn::ExprLit { lit: Lit::Int(integer), .. }) if matches!(integer.suffix(), "" | "usize") => {
            quote!(::portable::Expr::Constant { value: || ::portable::Literal::Usize(#integer) })
        }
        Expr::Lit(literal) => {
            rejections.push(literal, "an index and the bound of a loop are a `usize`; write the number alone");
            TokenStream::new()
        }
        Expr::Path(path) if !place::is_place(expression, scope) => {
            quote!(::portable::Expr::Constant { value: || ::portable::Literal::Usize(#path) })
        }
        Expr::Binary(binary) if matches!(binary.op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_)) => {
            let operator = operator(&binary.op, rejections);
            let (left, right) = (index(&binary.left, scope, rejections), index(&binary.right, scope, rejections));
            quote!(::portable::Expr::Binary { operator: ::portable::Binary::#operator, left: &#left, right: &#right })
        }
        Expr::Binary(binary) => {
            rejections.push(binary, "an index is counted with + - *; write the others as a `const` or a coefficient");
            TokenStream::new()
        }
        other => operand(other, scope, rejections),
    }
}

/// Describes the value of `place += operand`. `place` has already been described.
pub fn compound(
    binary: &syn::ExprBinary,
    place: &TokenStream,
    scope: &mut Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    let operator = operator(&binary.op, rejections);
    kind::check_divisor(binary, rejections);
    let right = operand(&binary.right, scope, rejections);
    quote! {
        ::portable::Expr::Binary {
            operator: ::portable::Binary::#operator,
            left: &::portable::Expr::Read { place: #place },
            right: &#right,
        }
    }
}

/// A value that rustc evaluates. A wrong type is an error at the place of the value.
pub fn constant(value: &(impl ToTokens + Spanned)) -> TokenStream {
    let scalar = quote_spanned!(value.span()=> ::portable::scalar(&#value));
    quote!(::portable::Expr::Constant { value: || #scalar })
}

fn describe_literal(literal: &Lit, rejections: &mut Rejections) -> TokenStream {
    match literal {
        Lit::Bool(_) => return constant(literal),
        Lit::Int(integer) => match integer.suffix() {
            "i32" | "u32" | "usize" => return constant(integer),
            "" => rejections.push(
                integer,
                format!("an integer names its type; write `{integer}u32`, `{integer}i32` or `{integer}usize`"),
            ),
            _ => rejections.push(integer, "integers are u32 or i32, indices usize; write one of these"),
        },
        Lit::Float(float) => {
            let digits = float.base10_digits();
            rejections.push(float, format!("a real constant belongs to the real type; write `R::lit({digits})`"));
        }
        other => rejections.push(other, "text has no counterpart; write a number, a bool or an enum"),
    }
    TokenStream::new()
}

/// A name without a dot: a local, a parameter or a constant.
fn describe_path(path: &syn::ExprPath, scope: &Scope, rejections: &mut Rejections) -> TokenStream {
    if real::is_path(&path.path, scope) {
        return real::describe_path(path, rejections);
    }
    match path.path.get_ident().and_then(|name| scope.kind(name)) {
        None => constant(path),
        Some(Kind::Unknown | Kind::Real | Kind::Integer) => quote! {
            ::portable::Expr::Read { place: ::portable::Place { root: stringify!(#path), projections: &[] } }
        },
        Some(Kind::Array) => {
            rejections.push(path, "an array is not a value; write its elements, or pass it with `&` or `&mut`");
            TokenStream::new()
        }
        Some(Kind::Shared | Kind::Mutable) => {
            rejections.push(path, "a borrowed parameter is not a value; write its fields, or pass it to a call");
            TokenStream::new()
        }
    }
}

fn describe_unary(unary: &syn::ExprUnary, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    let operator = match (&unary.op, bare(&unary.expr)) {
        // Rust reads `-2147483648i32` as one number; without its minus the number would be too large.
        (UnOp::Neg(_), Expr::Lit(syn::ExprLit { lit: Lit::Int(integer), .. })) if integer.suffix() == "i32" => {
            return constant(unary);
        }
        (UnOp::Not(_), _) => quote!(Not),
        _ => quote!(Negate),
    };
    kind::check_unary(unary, scope, rejections);
    let operand = operand(&unary.expr, scope, rejections);
    quote!(::portable::Expr::Unary { operator: ::portable::Unary::#operator, operand: &#operand })
}

fn operator(operator: &BinOp, rejections: &mut Rejections) -> TokenStream {
    match operator {
        BinOp::Add(_) | BinOp::AddAssign(_) => quote!(Add),
        BinOp::Sub(_) | BinOp::SubAssign(_) => quote!(Subtract),
        BinOp::Mul(_) | BinOp::MulAssign(_) => quote!(Multiply),
        BinOp::Div(_) | BinOp::DivAssign(_) => quote!(Divide),
        BinOp::Rem(_) | BinOp::RemAssign(_) => quote!(Remainder),
        BinOp::Lt(_) => quote!(Less),
        BinOp::Le(_) => quote!(LessEqual),
        BinOp::Gt(_) => quote!(Greater),
        BinOp::Ge(_) => quote!(GreaterEqual),
        BinOp::Eq(_) => quote!(Equal),
        BinOp::Ne(_) => quote!(NotEqual),
        BinOp::And(_) => quote!(And),
        BinOp::Or(_) => quote!(Or),
        other => {
            rejections.push(other, outside::operator(other));
            TokenStream::new()
        }
    }
}

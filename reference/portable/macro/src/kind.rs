//! What is known of a value without rustc's types: enough to reject in the editor what the generator would reject.

use crate::reject::Rejections;
use crate::scope::Scope;
use crate::{expr, real};
use syn::{BinOp, Expr, Lit};

/// The kind of a name or an expression.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// a scalar, or a kind that only rustc knows
    Unknown,
    /// a scalar of the real type
    Real,
    /// a scalar of an integer type
    Integer,
    /// a local array
    Array,
    /// a parameter `&T`
    Shared,
    /// a parameter `&mut T`
    Mutable,
}

/// The kind of an expression, as far as its text shows it.
pub fn classify(expression: &Expr, scope: &Scope) -> Kind {
    match expr::bare(expression) {
        Expr::Path(path) if real::is_path(&path.path, scope) => Kind::Real,
        Expr::Path(path) => path.path.get_ident().and_then(|name| scope.kind(name)).unwrap_or(Kind::Unknown),
        Expr::Call(call) => match &*call.func {
            Expr::Path(function) if real::is_path(&function.path, scope) => Kind::Real,
            _ => Kind::Unknown,
        },
        Expr::Lit(literal) if matches!(literal.lit, Lit::Int(_)) => Kind::Integer,
        Expr::Lit(literal) if matches!(literal.lit, Lit::Float(_)) => Kind::Real,
        Expr::Array(_) | Expr::Repeat(_) => Kind::Array,
        Expr::Unary(unary) => classify(&unary.expr, scope),
        Expr::Binary(binary)
            if matches!(binary.op, BinOp::Add(_) | BinOp::Sub(_) | BinOp::Mul(_) | BinOp::Div(_) | BinOp::Rem(_)) =>
        {
            match classify(&binary.left, scope) {
                Kind::Unknown => classify(&binary.right, scope),
                known => known,
            }
        }
        _ => Kind::Unknown,
    }
}

/// Rejects an operator that some language does not have for these operands.
pub fn check_binary(binary: &syn::ExprBinary, scope: &Scope, rejections: &mut Rejections) {
    let kinds = [classify(&binary.left, scope), classify(&binary.right, scope)];
    match binary.op {
        BinOp::Eq(_) | BinOp::Ne(_) if kinds.contains(&Kind::Real) => {
            rejections
                .push(binary, "reals are never compared for equality; write `<` or `>`, or `within(a - b, tolerance)`");
        }
        BinOp::Div(_) if kinds.contains(&Kind::Integer) && !kinds.contains(&Kind::Real) => {
            check_divisor(binary, rejections);
        }
        BinOp::Rem(_) => check_divisor(binary, rejections),
        _ => {}
    }
}

/// Rejects an integer divisor that is not a literal of at least 1: languages differ for division by 0, and for the smallest
/// number divided by -1.
pub fn check_divisor(binary: &syn::ExprBinary, rejections: &mut Rejections) {
    let is_number = match expr::bare(&binary.right) {
        Expr::Lit(syn::ExprLit { lit: Lit::Int(integer), .. }) => {
            integer.base10_parse::<u32>().is_ok_and(|divisor| divisor > 0)
        }
        _ => false,
    };
    let divides = matches!(binary.op, BinOp::Div(_) | BinOp::DivAssign(_) | BinOp::Rem(_) | BinOp::RemAssign(_));
    if divides && !is_number {
        rejections
            .push(binary, "integers are divided by a number from 1 on; write it, with its type, right of the operator");
    }
}

/// Rejects `!` of an integer.
pub fn check_unary(unary: &syn::ExprUnary, scope: &Scope, rejections: &mut Rejections) {
    if matches!(unary.op, syn::UnOp::Not(_)) && classify(&unary.expr, scope) == Kind::Integer {
        rejections.push(unary, "an integer has no bits here; write the number itself, or `!` of a bool");
    }
}

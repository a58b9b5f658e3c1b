//! Constants of the real type, such as `R::ZERO` and `R::lit(0.5)`, which rustc evaluates.

use crate::expr;
use crate::reject::Rejections;
use crate::scope::Scope;
use proc_macro2::TokenStream;
use syn::Expr;

/// Whether a path begins with the real type.
pub fn is_path(path: &syn::Path, scope: &Scope) -> bool {
    scope.real.is_some()
        && path.segments.len() > 1
        && path.segments.first().map(|head| &head.ident) == scope.real.as_ref()
}

/// Describes `R::ZERO` or `R::ONE`.
pub fn describe_path(path: &syn::ExprPath, rejections: &mut Rejections) -> TokenStream {
    if path.path.segments.last().is_some_and(|name| name.ident == "ZERO" || name.ident == "ONE") {
        return expr::constant(path);
    }
    rejections.push(
        path,
        "a block is the same in every real type; write `R::ZERO`, `R::ONE`, `R::lit(0.5)` or `R::per_kind(1.0, 2.0)`",
    );
    TokenStream::new()
}

/// Describes `R::lit(0.5)` or `R::per_kind(1.0, 2.0)`.
pub fn describe_call(
    call: &syn::ExprCall,
    function: &syn::Path,
    scope: &Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    let name = function.segments.last().map(|name| name.ident.to_string()).unwrap_or_default();
    match name.as_str() {
        "lit" | "per_kind" => {}
        "from_u32" => {
            rejections.push(function, "the real type offers constants; write `from_u32(value)`");
            return TokenStream::new();
        }
        _ => {
            rejections.push(function, "the real type offers constants; write `R::lit(0.5)`, and operators for values");
            return TokenStream::new();
        }
    }
    for argument in call.args.iter().filter(|argument| !is_constant(argument, scope)) {
        rejections.push(
            argument,
            "this makes a constant of a number; write a literal or a `const`, or `from_u32(value)` for a value",
        );
    }
    expr::constant(call)
}

/// Whether rustc knows the value: a literal or the name of a constant, optionally with a minus.
fn is_constant(argument: &Expr, scope: &Scope) -> bool {
    match argument {
        Expr::Unary(syn::ExprUnary { op: syn::UnOp::Neg(_), expr, .. }) => is_constant(expr, scope),
        Expr::Lit(_) => true,
        Expr::Path(path) => {
            let local = path.path.get_ident().is_some_and(|name| scope.kind(name).is_some());
            !local && path.path.segments.last().is_some_and(|name| is_constant_name(&name.ident))
        }
        _ => false,
    }
}

/// Whether a name has the form of a constant.
fn is_constant_name(name: &syn::Ident) -> bool {
    !name.to_string().contains(char::is_lowercase)
}

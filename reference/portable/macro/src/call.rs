//! Calls of portable functions and their arguments.

use crate::kind::Kind;
use crate::reject::Rejections;
use crate::scope::Scope;
use crate::{expr, place, real};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{Expr, GenericArgument, Ident, PathArguments, Type};

/// Describes a call; `alone` says whether the call is a whole value, so that it may change its arguments.
pub fn describe(call: &syn::ExprCall, alone: bool, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    let mut mutates = false;
    let function = match &*call.func {
        Expr::Path(function) if real::is_path(&function.path, scope) => {
            return real::describe_call(call, &function.path, scope, rejections);
        }
        Expr::Path(function) => callee(function, scope, rejections),
        other => {
            rejections.push(other, "a call names a portable function; write its path");
            TokenStream::new()
        }
    };
    let arguments: Vec<_> =
        call.args.iter().map(|argument| describe_argument(argument, &mut mutates, scope, rejections)).collect();
    if mutates && !alone {
        rejections.push(
            call,
            "languages disagree about when this call changes its argument; write `let value = ...;` before it",
        );
    }
    let real = scope.real.as_ref().map_or_else(|| quote!(R), |real| quote!(#real));
    quote! {
        ::portable::Expr::Call { function: &#function::Ir::<#real>::IR, arguments: &[#(#arguments),*] }
    }
}

/// The path of the function without the real type.
fn callee(function: &syn::ExprPath, scope: &Scope, rejections: &mut Rejections) -> TokenStream {
    if let Some(message) = no_free_function(function) {
        rejections.push(function, message);
        return TokenStream::new();
    }
    let mut path = function.path.clone();
    let names: Vec<_> = path.segments.iter().map(|segment| &segment.ident).collect();
    if matches!(names[..], [name] if *name == scope.function)
        || matches!(names[..], [own, name] if own == "self" && *name == scope.function)
    {
        rejections.push(function, "a function that calls itself has no bounded time; write `for i in 0..N`");
    }
    for segment in &mut path.segments {
        if !is_callers_real(&segment.arguments, scope) {
            rejections
                .push(&segment.arguments, "a function runs in the real type of its caller; write `::<R>` or nothing");
        }
        segment.arguments = PathArguments::None;
    }
    quote!(#path)
}

/// What to write instead of a call that reaches into a type.
fn no_free_function(function: &syn::ExprPath) -> Option<&'static str> {
    let mut names = function.path.segments.iter().rev().map(|segment| segment.ident.to_string());
    let is_type = |name: String| {
        name.starts_with(char::is_uppercase)
            || matches!(name.as_str(), "f64" | "f32" | "bool" | "usize" | "i32" | "u32" | "i64" | "u64")
    };
    if names.next().is_some_and(is_type) {
        return Some("a value with parts is not made by a call; write its fields through a `&mut` parameter");
    }
    (function.qself.is_some() || names.any(is_type))
        .then_some("a function of a type has no counterpart; write a free portable function")
}

/// Whether the angle brackets contain only the caller's real type.
fn is_callers_real(arguments: &PathArguments, scope: &Scope) -> bool {
    let arguments = match arguments {
        PathArguments::None => return true,
        PathArguments::AngleBracketed(arguments) => &arguments.args,
        PathArguments::Parenthesized(_) => return false,
    };
    let is_real = |ty: &syn::TypePath| ty.path.get_ident().is_some() && ty.path.get_ident() == scope.real.as_ref();
    matches!((arguments.first(), arguments.len()), (Some(GenericArgument::Type(Type::Path(ty))), 1) if is_real(ty))
}

fn describe_argument(
    argument: &Expr,
    mutates: &mut bool,
    scope: &mut Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    if let Expr::Reference(reference) = argument {
        if let Some(numbers) = numbers(reference, scope, rejections) {
            return numbers;
        }
        *mutates |= reference.mutability.is_some();
        // `&*state`: the function only reads the parameter that the caller may change.
        let of = match &*reference.expr {
            Expr::Unary(syn::ExprUnary { op: syn::UnOp::Deref(_), expr, .. }) if borrowed(expr, scope).is_some() => {
                expr
            }
            of => of,
        };
        let place = place::describe(of, scope, rejections);
        return quote!(::portable::Argument::Borrow { place: #place });
    }
    if let Some((name, kind)) = borrowed(argument, scope) {
        *mutates |= kind == Kind::Mutable;
        let place = quote!(::portable::Place { root: stringify!(#name), projections: &[] });
        return quote!(::portable::Argument::Borrow { place: #place });
    }
    let value = expr::operand(argument, scope, rejections);
    quote!(::portable::Argument::Value { value: #value })
}

/// `&with_numbers(&structure, &numbers)`, the only call whose value is borrowed, by itself or as a field of a struct whose other
/// fields are those of the place that the structure is in. `None`: another expression.
fn numbers(reference: &syn::ExprReference, scope: &mut Scope, rejections: &mut Rejections) -> Option<TokenStream> {
    let (mut value, mut whole) = (&*reference.expr, None::<&Expr>);
    // The place of the value as text, if it is a field.
    let mut field: Option<String> = None;
    let text = |of: &Expr| of.to_token_stream().to_string();
    while let Expr::Struct(of) = value {
        let (Some(rest), [only]) = (of.rest.as_deref(), &of.fields.iter().collect::<Vec<_>>()[..]) else { return None };
        if field.is_some_and(|field| field != text(rest)) {
            return None;
        }
        let member = &only.member;
        field = Some(quote!(#rest.#member).to_string());
        whole = whole.or(Some(rest));
        value = &only.expr;
    }
    let Expr::Call(call) = value else { return None };
    if !matches!(&*call.func, Expr::Path(path) if path.path.is_ident("with_numbers")) {
        return None;
    }
    let mut places = call.args.iter().map(|argument| match argument {
        Expr::Reference(of) if of.mutability.is_none() => Some(place::describe(&of.expr, scope, rejections)),
        argument => {
            let (name, _) = borrowed(argument, scope)?;
            Some(quote!(::portable::Place { root: stringify!(#name), projections: &[] }))
        }
    });
    let places: Option<Vec<TokenStream>> = places.by_ref().collect();
    let is_there = |field: &String| matches!(call.args.first(), Some(Expr::Reference(of)) if text(&of.expr) == *field);
    let Some([part, numbers]) =
        places.as_deref().filter(|_| reference.mutability.is_none() && field.as_ref().is_none_or(is_there))
    else {
        rejections.push(call, "two structs become one; write `&with_numbers(&structure, &numbers)`, or `&Type { part: with_numbers(&whole.part, &numbers), ..whole }`");
        return Some(TokenStream::new());
    };
    let structure = whole.map_or_else(|| part.clone(), |whole| place::describe(whole, scope, rejections));
    Some(quote!(::portable::Argument::Numbers { structure: #structure, part: #part, numbers: #numbers }))
}

/// The name of a borrowed parameter that is passed on unchanged.
fn borrowed<'a>(argument: &'a Expr, scope: &Scope) -> Option<(&'a Ident, Kind)> {
    let Expr::Path(path) = argument else { return None };
    let name = path.path.get_ident()?;
    let kind = scope.kind(name)?;
    matches!(kind, Kind::Shared | Kind::Mutable).then_some((name, kind))
}

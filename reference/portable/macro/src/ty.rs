//! The types that a parameter, a result, a field or a local may have. Only rustc knows what a name stands for.

use crate::kind::Kind;
use crate::reject::Rejections;
use proc_macro2::TokenStream;
use quote::quote_spanned;
use syn::spanned::Spanned;
use syn::{GenericArgument, Ident, PathArguments, Type};

/// The kind of a parameter, and its type without the borrow.
pub fn parameter<'t>(ty: &'t Type, real: Option<&Ident>, rejections: &mut Rejections) -> (Kind, &'t Type) {
    match ty {
        Type::Paren(paren) => parameter(&paren.elem, real, rejections),
        Type::Group(group) => parameter(&group.elem, real, rejections),
        Type::Reference(reference) => {
            if let Some(lifetime) = &reference.lifetime {
                rejections.push(lifetime, "a borrow ends with the call; remove the lifetime");
            }
            let inner = &*reference.elem;
            if scalar(inner, real).is_some() {
                rejections.push(ty, "a scalar is passed by value; remove the `&`, or borrow the struct that holds it");
            } else {
                held(inner, rejections);
            }
            (if reference.mutability.is_some() { Kind::Mutable } else { Kind::Shared }, inner)
        }
        Type::Array(_) => {
            rejections.push(ty, "an array is passed by borrow; write `&` or `&mut` before it");
            (Kind::Shared, ty)
        }
        Type::Path(path) if has_arguments(path) => {
            rejections.push(ty, "a struct is passed by borrow; write `&` or `&mut` before it");
            (Kind::Shared, ty)
        }
        _ => {
            held(ty, rejections);
            (scalar(ty, real).unwrap_or(Kind::Unknown), ty)
        }
    }
}

/// Rejects a type that a function cannot return.
pub fn result(ty: &Type, rejections: &mut Rejections) {
    match ty {
        Type::Tuple(tuple) if tuple.elems.is_empty() => {
            rejections.push(ty, "a function without a value says nothing; remove `-> ()`");
        }
        Type::Path(path) if !has_arguments(path) => held(ty, rejections),
        _ => rejections.push(ty, "a function gives one scalar; write further results through a `&mut` parameter"),
    }
}

/// Rejects a type that a field, a local or an element cannot have.
pub fn held(ty: &Type, rejections: &mut Rejections) {
    match ty {
        Type::Paren(paren) => held(&paren.elem, rejections),
        Type::Group(group) => held(&group.elem, rejections),
        Type::Array(array) => held(&array.elem, rejections),
        Type::Path(path) => named(path, rejections),
        Type::Infer(_) => {}
        other => rejections.push(other, instead(other)),
    }
}

fn named(path: &syn::TypePath, rejections: &mut Rejections) {
    if path.qself.is_some() {
        rejections.push(path, "a type is named by its path; write it out");
    }
    match path.path.get_ident().map(ToString::to_string).unwrap_or_default().as_str() {
        "f64" | "f32" => {
            rejections.push(path, "a block exists in each real type; write `R`, with `<R: Real>` or `<R>` at the item")
        }
        "i8" | "i16" | "i64" | "i128" | "isize" | "u8" | "u16" | "u64" | "u128" => {
            rejections.push(path, "integers are `i32` or `u32`, an index is a `usize`; write one of these");
        }
        "char" | "str" | "String" => rejections.push(path, "text has no counterpart; write a number or an enum"),
        _ => {}
    }
    for segment in &path.path.segments {
        let PathArguments::AngleBracketed(arguments) = &segment.arguments else { continue };
        for argument in &arguments.args {
            match argument {
                GenericArgument::Type(ty) => held(ty, rejections),
                GenericArgument::Lifetime(lifetime) => {
                    rejections.push(lifetime, "nothing portable holds a borrow; remove the lifetime")
                }
                other => rejections
                    .push(other, "a portable struct has no parameter but the real type; write `<R>` or nothing"),
            }
        }
    }
}

fn instead(ty: &Type) -> &'static str {
    match ty {
        Type::Reference(_) | Type::Ptr(_) => "a borrow is a parameter and nothing else; write the type without it",
        Type::Slice(_) => "a length is known; write `[T; N]`",
        Type::Tuple(_) => "a tuple has no counterpart; write a struct with named fields",
        Type::FnPtr(_) | Type::ImplTrait(_) | Type::TraitObject(_) => {
            "what runs is known; write the type itself, or an enum and a `match`"
        }
        _ => "this type has no counterpart; write a scalar, an array, a struct or an enum",
    }
}

/// The kind of a scalar, if the type is recognisable as one.
pub fn scalar(ty: &Type, real: Option<&Ident>) -> Option<Kind> {
    let Type::Path(path) = ty else { return None };
    let name = path.path.get_ident()?;
    match name.to_string().as_str() {
        _ if Some(name) == real => Some(Kind::Real),
        "f64" | "f32" => Some(Kind::Real),
        "i32" | "u32" | "usize" => Some(Kind::Integer),
        "bool" => Some(Kind::Unknown),
        _ => None,
    }
}

fn has_arguments(path: &syn::TypePath) -> bool {
    path.path.segments.iter().any(|segment| !segment.arguments.is_none())
}

/// For a type that is only a name, lets rustc check that it is a scalar: an error at the type if it is not.
pub fn assertion(ty: &Type, borrowed: bool, real: Option<&Ident>) -> TokenStream {
    match ty {
        Type::Path(path) if !has_arguments(path) && scalar(ty, real).is_none() => {}
        _ => return TokenStream::new(),
    }
    let (holds, message) = if borrowed {
        (quote_spanned!(ty.span()=> is_aggregate), "a scalar is passed by value; remove the `&`")
    } else {
        (quote_spanned!(ty.span()=> !is_aggregate), "a struct or an array is passed by borrow; write `&` or `&mut`")
    };
    quote_spanned! {ty.span()=>
        const _: () = {
            let is_aggregate = ::core::matches!(
                <#ty as ::portable::Portable>::TY,
                ::portable::Ty::Struct { .. } | ::portable::Ty::Array { .. }
            );
            ::core::assert!(#holds, #message);
        };
    }
}

//! Generic parameters: none, or the real type.

use crate::reject::Rejections;
use syn::{GenericParam, Generics, TypeParam, TypeParamBound};

/// The real type of a function. The parameter must have the bound of a real type.
pub fn of_function(generics: &Generics, rejections: &mut Rejections) -> Option<syn::Ident> {
    let real = type_parameter(generics, rejections)?;
    if !is_real(real) {
        rejections.push(real, format!("the type parameter is the real type; write `<{}: Real>`", real.ident));
    }
    Some(real.ident.clone())
}

/// The real type of a struct. The parameter needs no bound.
pub fn of_struct(generics: &Generics, rejections: &mut Rejections) -> Option<syn::Ident> {
    let real = type_parameter(generics, rejections)?;
    if !real.bounds.is_empty() && !is_real(real) {
        rejections.push(real, format!("the type parameter is the real type; write `<{}>`", real.ident));
    }
    if let Some((_, default)) = &real.default {
        rejections.push(default, "the block chooses the real type; remove the default");
    }
    Some(real.ident.clone())
}

fn type_parameter<'g>(generics: &'g Generics, rejections: &mut Rejections) -> Option<&'g TypeParam> {
    let mut real = None;
    for param in &generics.params {
        match param {
            GenericParam::Type(first) if real.is_none() => real = Some(first),
            GenericParam::Type(_) => {
                rejections.push(param, "the real type is the only type parameter; remove this one")
            }
            GenericParam::Lifetime(_) => rejections.push(param, "a borrow ends with the call; remove the lifetime"),
            GenericParam::Const(_) => {
                rejections.push(param, "a length is a `const` next to the item; write one and its name")
            }
        }
    }
    if let Some(clause) = &generics.where_clause {
        rejections.push(clause, "the one bound stands with the type parameter; write `<R: Real>`");
    }
    real
}

fn is_real(parameter: &TypeParam) -> bool {
    let mut bounds = parameter.bounds.iter();
    let (Some(TypeParamBound::Trait(bound)), None) = (bounds.next(), bounds.next()) else { return false };
    bound.maybe.is_none() && bound.path.segments.last().is_some_and(|name| name.ident == "Real")
}

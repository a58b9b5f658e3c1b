//! The attribute `#[portable]`: checks that an item keeps to the subset, leaves it unchanged, and adds its description;
//! and `copy!`, the only macro that an item may contain. `docs/portable-rust.md` defines the subset.
#![forbid(unsafe_code)]

mod attribute;
mod block;
mod branch;
mod call;
mod copy;
mod expr;
mod function;
mod generics;
mod item;
mod kind;
mod name;
mod outside;
mod outward;
mod pattern;
mod place;
mod real;
mod reject;
mod scope;
mod ty;

use proc_macro::TokenStream;
use quote::quote;
use reject::Rejections;

/// Makes a struct, an enum of unit variants or a function portable.
///
/// The item stays ordinary Rust. A struct or an enum gets an implementation of `portable::Portable`; a function gets a
/// hidden module of its own name with `Ir<R>::IR`, so that one `use` imports both. Everything outside the subset is an error
/// at its own place that says what to write instead. All errors are reported at once.
#[proc_macro_attribute]
pub fn portable(attribute: TokenStream, item: TokenStream) -> TokenStream {
    let original = proc_macro2::TokenStream::from(item.clone());
    let (description, rejections) = describe(attribute.into(), item.into());
    let errors = rejections.into_compile_errors();
    quote!(#original #description #errors).into()
}

/// The description of an item, and what is rejected of it.
fn describe(
    attribute: proc_macro2::TokenStream,
    item: proc_macro2::TokenStream,
) -> (proc_macro2::TokenStream, Rejections) {
    let mut rejections = Rejections::default();
    if !attribute.is_empty() {
        rejections.push(attribute, "#[portable] takes no arguments; write #[portable]");
    }
    let description = match syn::parse2::<syn::Item>(item) {
        Ok(syn::Item::Fn(function)) => function::describe(&function, &mut rejections),
        Ok(syn::Item::Struct(item)) => item::describe_struct(&item, &mut rejections),
        Ok(syn::Item::Enum(item)) => item::describe_enum(&item, &mut rejections),
        Ok(other) => {
            item::reject(&other, &mut rejections);
            proc_macro2::TokenStream::new()
        }
        Err(error) => error.to_compile_error(),
    };
    (description, rejections)
}

/// `copy!(to = from: field, field);` copies fields by name: each is `to.field = from.field;`.
///
/// rustc checks that both structs have the field, with the same type.
#[proc_macro]
pub fn copy(fields: TokenStream) -> TokenStream {
    syn::parse::<copy::Copy>(fields).map_or_else(|error| error.to_compile_error(), |copy| copy.expand()).into()
}

#[cfg(test)]
#[path = "../unit/refused.rs"]
mod refused;

/// Checks that the examples of the guide compile or fail as the guide states.
#[cfg(doctest)]
#[doc = include_str!("../../../../docs/portable-rust.md")]
struct Guide;

//! Functions: the signature, and the hidden module that holds the IR. Bodies are described in `block`.

use crate::block::{self, Scope};
use crate::item;
use crate::reject::Rejections;
use proc_macro2::TokenStream;
use quote::quote;

/// How a parameter is passed.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    Value,
    Shared,
    Mutable,
}

/// Describes a function.
pub fn describe(function: &syn::ItemFn, rejections: &mut Rejections) -> TokenStream {
    let signature = &function.sig;
    qualifiers(signature, rejections);
    let real = real_parameter(&signature.generics, rejections);
    let mut scope = Scope::new(signature.ident.clone(), real.clone());
    let params = parameters(signature, &mut scope, rejections);
    let returns = match &signature.output {
        syn::ReturnType::Default => quote!(None),
        syn::ReturnType::Type(_, ty) => {
            if matches!(**ty, syn::Type::Reference(_) | syn::Type::Tuple(_) | syn::Type::ImplTrait(_)) {
                rejections.push(
                    ty,
                    "a function gives one scalar; write further results through a `&mut` parameter",
                );
            }
            quote!(Some(<#ty as ::portable::Portable>::TY))
        }
    };
    let wants_value = !matches!(signature.output, syn::ReturnType::Default);
    let body = block::describe(&function.block, wants_value, &mut scope, rejections);
    let body = if rejections.is_empty() { body } else { quote!(::portable::Block { statements: &[], value: None }) };
    let (name, visibility, doc) = (&signature.ident, &function.vis, item::doc(&function.attrs));
    let real = real.unwrap_or_else(|| quote::format_ident!("R"));
    quote! {
        #[doc(hidden)]
        #visibility mod #name {
            #[allow(unused_imports, reason = "most bodies name something of their own module")]
            use super::*;

            /// The function as data, for the real type that it is instantiated with.
            pub struct Ir<#real>(::core::marker::PhantomData<#real>);

            impl<#real: ::portable::Real> Ir<#real> {
                /// The function as data.
                pub const IR: ::portable::Fn = ::portable::Fn {
                    name: stringify!(#name),
                    module: module_path!(),
                    doc: #doc,
                    params: &[#(#params),*],
                    returns: #returns,
                    body: ::portable::Body { intrinsic: None, block: #body },
                };
            }
        }
    }
}

/// Rejects what stands before `fn`.
fn qualifiers(signature: &syn::Signature, rejections: &mut Rejections) {
    if let Some(token) = &signature.asyncness {
        rejections.push(token, "a block runs within one cycle; remove `async`");
    }
    if let Some(token) = &signature.constness {
        rejections.push(token, "a portable function is not const; remove `const`");
    }
    if let syn::Safety::Unsafe(token) = &signature.safety {
        rejections.push(token, "nothing here needs it; remove `unsafe`");
    }
    if let Some(token) = &signature.abi {
        rejections.push(token, "the generator chooses the calling convention; remove `extern`");
    }
    if let Some(token) = &signature.variadic {
        rejections.push(token, "the number of parameters is fixed; remove `...`");
    }
}

/// The type parameter that stands for the real type, if there is one.
fn real_parameter(generics: &syn::Generics, rejections: &mut Rejections) -> Option<syn::Ident> {
    if let Some(clause) = &generics.where_clause {
        rejections.push(clause, "the bound stands with the type parameter; write `<R: Real>`");
    }
    let mut real = None;
    for (position, param) in generics.params.iter().enumerate() {
        match param {
            syn::GenericParam::Type(ty) if position == 0 => {
                let bound = match (ty.bounds.first(), ty.bounds.len()) {
                    (Some(syn::TypeParamBound::Trait(bound)), 1) => bound.path.segments.last(),
                    _ => None,
                };
                if bound.is_none_or(|segment| segment.ident != "Real") {
                    rejections.push(ty, "the type parameter is the real type; write `<R: Real>`");
                }
                real = Some(ty.ident.clone());
            }
            _ => rejections.push(param, "at most one parameter, the real type; write `<R: Real>`"),
        }
    }
    real
}

/// Describes the parameters and enters them into the scope.
fn parameters(signature: &syn::Signature, scope: &mut Scope, rejections: &mut Rejections) -> Vec<TokenStream> {
    let mut described = Vec::new();
    for input in &signature.inputs {
        let syn::FnArg::Typed(param) = input else {
            rejections.push(input, "a method has no counterpart; write a free function with the state as a `&mut` parameter");
            continue;
        };
        rejections.attributes(&param.attrs);
        let syn::Pat::Ident(pattern) = &*param.pat else {
            rejections.push(&param.pat, "a parameter is a plain name; take it apart in the body");
            continue;
        };
        if pattern.mutability.is_some() || pattern.by_ref.is_some() {
            rejections.push(pattern, "a parameter is not changed; write `let mut local = parameter;`");
        }
        let (mode, ty) = match &*param.ty {
            syn::Type::Reference(reference) => {
                if let Some(lifetime) = &reference.lifetime {
                    rejections.push(lifetime, "a borrow ends with the call; remove the lifetime");
                }
                (if is_mutable(reference) { Mode::Mutable } else { Mode::Shared }, &*reference.elem)
            }
            ty => (Mode::Value, ty),
        };
        scope.enter_parameter(&pattern.ident, mode, rejections);
        let name = &pattern.ident;
        let mode = match mode {
            Mode::Value => quote!(Value),
            Mode::Shared => quote!(Shared),
            Mode::Mutable => quote!(Mutable),
        };
        described.push(quote! {
            ::portable::Param {
                name: stringify!(#name),
                mode: ::portable::Mode::#mode,
                ty: <#ty as ::portable::Portable>::TY,
            }
        });
    }
    described
}

fn is_mutable(reference: &syn::TypeReference) -> bool {
    reference.mutability.is_some()
}

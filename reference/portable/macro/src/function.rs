//! Functions: the signature, and the hidden module that holds the IR. Bodies are described in `block`.

use crate::kind::Kind;
use crate::reject::Rejections;
use crate::scope::Scope;
use crate::{attribute, block, generics, item, name, outward, ty};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

/// Describes a function.
pub fn describe(function: &syn::ItemFn, rejections: &mut Rejections) -> TokenStream {
    let signature = &function.sig;
    qualifiers(signature, rejections);
    name::check(&signature.ident, rejections);
    let real = generics::of_function(&signature.generics, rejections);
    let mut scope = Scope::new(signature.ident.clone(), real.clone());
    let mut assertions = TokenStream::new();
    let params = parameters(signature, &mut scope, &mut assertions, rejections);
    let returns = match &signature.output {
        syn::ReturnType::Default => quote!(None),
        syn::ReturnType::Type(_, ty) => {
            ty::result(ty, rejections);
            assertions.extend(ty::assertion(ty, false, real.as_ref()));
            quote!(Some(<#ty as ::portable::Portable>::TY))
        }
    };
    let wants_value = !matches!(signature.output, syn::ReturnType::Default);
    let body = block::describe(&function.block, wants_value, &mut scope, rejections);
    attribute::reject_inside(signature.to_token_stream(), rejections);
    attribute::reject_inside(function.block.to_token_stream(), rejections);
    if signature.receiver().is_some() {
        return TokenStream::new(); // inside an `impl`, which cannot contain a module
    }
    let parts = if rejections.is_empty() {
        [quote!(#(#params),*), returns, body, assertions]
    } else {
        let body = quote!(::portable::CodeBlock { statements: &[], value: None });
        [TokenStream::new(), quote!(None), body, TokenStream::new()]
    };
    let real = real.unwrap_or_else(|| quote::format_ident!("R"));
    module(function, &real, parts.map(outward::from_inside))
}

/// The hidden module of a function, from the parts of its IR and the assertions about its types.
fn module(function: &syn::ItemFn, real: &Ident, [params, returns, body, assertions]: [TokenStream; 4]) -> TokenStream {
    let signature = &function.sig;
    let (name, visibility, doc) = (&signature.ident, &function.vis, item::doc(&function.attrs));
    quote! {
        #[doc(hidden)]
        #visibility mod #name {
            #[allow(unused_imports, reason = "most bodies name something of their own module")]
            use super::*;

            #assertions

            /// The function as data, for the real type that it is instantiated with.
            pub struct Ir<#real>(::core::marker::PhantomData<#real>);

            impl<#real: ::portable::Real> Ir<#real> {
                /// The function as data.
                pub const IR: ::portable::Fn = ::portable::Fn {
                    name: stringify!(#name),
                    module: module_path!(),
                    doc: #doc,
                    params: &[#params],
                    returns: #returns,
                    body: ::portable::Body { intrinsic: None, block: #body },
                };
            }
        }
    }
}

/// Rejects qualifiers before `fn`.
fn qualifiers(signature: &syn::Signature, rejections: &mut Rejections) {
    if let Some(token) = &signature.asyncness {
        rejections.push(token, "a function runs within one cycle; remove `async`");
    }
    if let Some(token) = &signature.constness {
        rejections.push(token, "a portable function is not const; remove `const`");
    }
    if let syn::Safety::Unsafe(token) = &signature.safety {
        rejections.push(token, "nothing here needs it; remove `unsafe`");
    }
    if let Some(abi) = &signature.abi {
        rejections.push(abi, "the generator chooses the calling convention; remove `extern`");
    }
}

/// Describes the parameters and enters them into the scope.
fn parameters(
    signature: &syn::Signature,
    scope: &mut Scope,
    assertions: &mut TokenStream,
    rejections: &mut Rejections,
) -> Vec<TokenStream> {
    let describe = |input: &_| match input {
        syn::FnArg::Typed(param) => parameter(param, scope, assertions, rejections),
        syn::FnArg::Receiver(_) => {
            scope.enter_rejected(input);
            let message = "a method has no counterpart; write a free function with the state as a `&mut` parameter";
            rejections.push(input, message);
            None
        }
    };
    signature.inputs.iter().filter_map(describe).collect()
}

fn parameter(
    param: &syn::PatType,
    scope: &mut Scope,
    assertions: &mut TokenStream,
    rejections: &mut Rejections,
) -> Option<TokenStream> {
    let (kind, ty) = ty::parameter(&param.ty, scope.real.as_ref(), rejections);
    let pattern = match &*param.pat {
        syn::Pat::Ident(pattern) if pattern.by_ref.is_none() && pattern.subpat.is_none() => pattern,
        other => {
            rejections.push(other, "a parameter is a plain name; write one, and its parts in the body");
            scope.enter_rejected(other);
            return None;
        }
    };
    if pattern.mutability.is_some() {
        rejections.push(pattern, "a parameter keeps its value; write `let mut local = parameter;`");
    }
    let name = &pattern.ident;
    scope.enter(name, kind, rejections);
    let (mode, borrowed) = match kind {
        Kind::Shared => (quote!(Shared), true),
        Kind::Mutable => (quote!(Mutable), true),
        _ => (quote!(Value), false),
    };
    assertions.extend(ty::assertion(ty, borrowed, scope.real.as_ref()));
    Some(quote! {
        ::portable::Param {
            name: stringify!(#name),
            mode: ::portable::Mode::#mode,
            ty: <#ty as ::portable::Portable>::TY,
        }
    })
}

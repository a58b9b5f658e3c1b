//! Structs and enums: `impl Portable`, which describes the type and splits a value into scalars. No functions here.

use crate::reject::Rejections;
use crate::{attribute, generics, name, ty};
use proc_macro2::TokenStream;
use quote::quote;
use syn::Item;

/// Describes a struct.
pub fn describe_struct(item: &syn::ItemStruct, rejections: &mut Rejections) -> TokenStream {
    name::check(&item.ident, rejections);
    let real = generics::of_struct(&item.generics, rejections);
    let unnamed = "a portable struct has named fields; write `struct Name { field: Type }`";
    match &item.fields {
        syn::Fields::Named(fields) => fields.named.iter().for_each(|field| check_field(field, rejections)),
        syn::Fields::Unnamed(fields) => rejections.push(fields, unnamed),
        syn::Fields::Unit => rejections.push(&item.ident, unnamed),
    }
    let name = &item.ident;
    if !rejections.is_empty() {
        let def = quote!(::portable::StructDef { name: stringify!(#name), fields: &[], leaves: 0 });
        return undescribed(name, &item.generics, &quote!(::portable::Ty::Struct { def: &#def }));
    }
    described(item, real.as_ref())
}

/// The implementation for a struct that is not rejected.
fn described(item: &syn::ItemStruct, real: Option<&syn::Ident>) -> TokenStream {
    let name = &item.ident;
    let (_, arguments, _) = item.generics.split_for_impl();
    let bounds = real.map(|real| quote!(<#real: ::portable::Real>));
    let field: Vec<_> = item.fields.iter().map(|field| &field.ident).collect();
    let ty: Vec<_> = item.fields.iter().map(|field| &field.ty).collect();
    let first: Vec<_> = (0..ty.len()).map(|count| leaves(&ty[..count])).collect();
    let end = (1..=ty.len()).map(|count| leaves(&ty[..count]));
    let def = definition(item, &ty, &first);
    quote! {
        impl #bounds ::portable::Portable for #name #arguments {
            const TY: ::portable::Ty = ::portable::Ty::Struct { def: &#def };

            fn visit(&self, visit: &mut dyn FnMut(::portable::Literal)) {
                #(::portable::Portable::visit(&self.#field, visit);)*
            }

            fn leaf(&self, place: usize) -> ::portable::Literal {
                #(if place < const { #end } {
                    return ::portable::Portable::leaf(&self.#field, place - const { #first });
                })*
                panic!("scalar {place} does not exist in {}", stringify!(#name))
            }

            fn build(next: &mut dyn FnMut() -> ::portable::Literal) -> Self {
                Self { #(#field: <#ty as ::portable::Portable>::build(next)),* }
            }
        }
    }
}

/// The definition of a struct, from the types of its fields and the positions of their first scalars.
fn definition(item: &syn::ItemStruct, ty: &[&syn::Type], first: &[TokenStream]) -> TokenStream {
    let (name, leaves) = (&item.ident, leaves(ty));
    let field = item.fields.iter().map(|field| &field.ident);
    let doc = item.fields.iter().map(|field| doc(&field.attrs));
    quote! {
        ::portable::StructDef {
            name: stringify!(#name),
            fields: &[#(
                ::portable::Field {
                    name: stringify!(#field),
                    doc: #doc,
                    ty: <#ty as ::portable::Portable>::TY,
                    first: #first,
                }
            ),*],
            leaves: #leaves,
        }
    }
}

/// The number of scalars in fields of these types.
fn leaves(ty: &[&syn::Type]) -> TokenStream {
    quote!(0 #(+ <#ty as ::portable::Portable>::TY.leaves())*)
}

/// Describes an enum of unit variants.
pub fn describe_enum(item: &syn::ItemEnum, rejections: &mut Rejections) -> TokenStream {
    name::check(&item.ident, rejections);
    if !item.generics.params.is_empty() || item.generics.where_clause.is_some() {
        rejections.push(&item.generics, "a portable enum has no parameter; remove it");
    }
    if item.variants.is_empty() {
        rejections.push(&item.ident, "a portable enum has a value; write at least one variant");
    }
    for variant in &item.variants {
        check_variant(variant, rejections);
    }
    let name = &item.ident;
    if !rejections.is_empty() {
        let def = quote!(::portable::EnumDef { name: stringify!(#name), doc: "", variants: &[] });
        return undescribed(name, &item.generics, &quote!(::portable::Ty::Enum { def: &#def }));
    }
    let variant: Vec<_> = item.variants.iter().map(|variant| &variant.ident).collect();
    let docs: Vec<_> = item.variants.iter().map(|variant| doc(&variant.attrs)).collect();
    let meaning = doc(&item.attrs);
    let number: Vec<_> = (0u32..).take(variant.len()).collect();
    let unknown = quote!(other => panic!("a variant of {} expected, found {other:?}", stringify!(#name)));
    quote! {
        impl ::portable::Portable for #name {
            const TY: ::portable::Ty = ::portable::Ty::Enum {
                def: &::portable::EnumDef { name: stringify!(#name), doc: #meaning, variants: &[#(::portable::VariantDef { name: stringify!(#variant), doc: #docs }),*] },
            };

            fn visit(&self, visit: &mut dyn FnMut(::portable::Literal)) {
                let ::portable::Ty::Enum { def: of } = <Self as ::portable::Portable>::TY else { return };
                visit(::portable::Literal::Variant(::portable::Variant { of, index: match self { #(Self::#variant => #number),* } }));
            }

            fn build(next: &mut dyn FnMut() -> ::portable::Literal) -> Self {
                match next() {
                    #(::portable::Literal::Variant(::portable::Variant { index: #number, .. }) => Self::#variant,)*
                    #unknown
                }
            }
        }
    }
}

/// Rejects every other item.
pub fn reject(item: &Item, rejections: &mut Rejections) {
    let message = match item {
        Item::Const(_) | Item::Static(_) => {
            "a constant needs no description; remove #[portable], or write a function without parameters"
        }
        Item::Impl(_) | Item::Trait(_) => "methods have no counterpart; write free functions, each with #[portable]",
        Item::Union(_) => "a union has no counterpart; write a struct",
        Item::Mod(_) => "a module is described by its items; write #[portable] at each",
        _ => "only a struct, an enum or a function can be portable; remove #[portable]",
    };
    rejections.push(item, message);
}

fn check_field(field: &syn::Field, rejections: &mut Rejections) {
    attribute::reject_conditions(&field.attrs, rejections);
    field.ident.iter().for_each(|ident| name::check(ident, rejections));
    ty::held(&field.ty, rejections);
}

fn check_variant(variant: &syn::Variant, rejections: &mut Rejections) {
    attribute::reject_conditions(&variant.attrs, rejections);
    name::check(&variant.ident, rejections);
    if !matches!(variant.fields, syn::Fields::Unit) {
        rejections.push(variant, "a variant holds nothing; write its name alone, and the data as fields of a struct");
    }
    if let Some((_, discriminant)) = &variant.discriminant {
        rejections.push(discriminant, "variants are numbered from 0 in their order; remove the discriminant");
    }
}

/// Replaces the description of a rejected type, so that its uses are not reported as well.
fn undescribed(name: &syn::Ident, generics: &syn::Generics, ty: &TokenStream) -> TokenStream {
    let (bounds, arguments, clause) = generics.split_for_impl();
    quote! {
        impl #bounds ::portable::Portable for #name #arguments #clause {
            const TY: ::portable::Ty = #ty;

            fn visit(&self, _: &mut dyn FnMut(::portable::Literal)) {}

            fn build(_: &mut dyn FnMut() -> ::portable::Literal) -> Self {
                unreachable!("a rejected type does not compile")
            }
        }
    }
}

/// The text of the doc comments, joined to one line.
pub fn doc(attributes: &[syn::Attribute]) -> String {
    let mut lines = Vec::new();
    for attribute in attributes {
        if let syn::Meta::NameValue(meta) = &attribute.meta
            && meta.path.is_ident("doc")
            && let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &meta.value
        {
            let text = text.value();
            if text.trim().is_empty() {
                break; // the first paragraph is the description
            }
            lines.push(text.trim().to_owned());
        }
    }
    lines.join(" ")
}

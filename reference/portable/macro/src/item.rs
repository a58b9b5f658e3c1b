//! Structs and enums: `impl Portable`, which describes the type and takes a value apart. No functions here.

use crate::reject::Rejections;
use proc_macro2::TokenStream;
use quote::quote;

/// Describes a struct.
pub fn describe_struct(item: &syn::ItemStruct, rejections: &mut Rejections) -> TokenStream {
    let bounded = generics(&item.generics, rejections);
    let syn::Fields::Named(fields) = &item.fields else {
        rejections.push(&item.fields, "a portable struct has named fields; write `struct Name { field: Type }`");
        return TokenStream::new();
    };
    let name = &item.ident;
    let (_, arguments, _) = item.generics.split_for_impl();
    let field = fields.named.iter().map(|field| field.ident.as_ref());
    let (field, field_again) = (field.clone(), field);
    let ty = fields.named.iter().map(|field| &field.ty);
    let described = fields.named.iter().map(|field| {
        let (ident, ty, doc) = (&field.ident, &field.ty, doc(&field.attrs));
        quote!(::portable::Field { name: stringify!(#ident), doc: #doc, ty: <#ty as ::portable::Portable>::TY })
    });
    quote! {
        impl #bounded ::portable::Portable for #name #arguments {
            const TY: ::portable::Ty = ::portable::Ty::Struct {
                def: &::portable::StructDef { name: stringify!(#name), fields: &[#(#described),*] },
            };

            fn visit(&self, visit: &mut dyn FnMut(::portable::Literal)) {
                #(::portable::Portable::visit(&self.#field, visit);)*
            }

            fn build(next: &mut dyn FnMut() -> ::portable::Literal) -> Self {
                Self { #(#field_again: <#ty as ::portable::Portable>::build(next)),* }
            }
        }
    }
}

/// Describes an enum of unit variants.
pub fn describe_enum(item: &syn::ItemEnum, rejections: &mut Rejections) -> TokenStream {
    if !item.generics.params.is_empty() {
        rejections.push(&item.generics, "a portable enum has no type parameter; remove it");
    }
    for variant in &item.variants {
        if !variant.fields.is_empty() {
            rejections.push(
                &variant.fields,
                "a variant with data has no counterpart in Structured Text; write a unit variant and keep the data in a struct",
            );
        }
        if let Some((_, discriminant)) = &variant.discriminant {
            rejections.push(discriminant, "variants are numbered from 0 in their order; remove the discriminant");
        }
    }
    if !rejections.is_empty() {
        return TokenStream::new();
    }
    let name = &item.ident;
    let variant: Vec<_> = item.variants.iter().map(|variant| &variant.ident).collect();
    let number = 0u32..;
    let number_again = number.clone();
    let unknown = quote!(other => panic!("a variant of {} expected, found {other:?}", stringify!(#name)));
    quote! {
        impl ::portable::Portable for #name {
            const TY: ::portable::Ty = ::portable::Ty::Enum {
                def: &::portable::EnumDef { name: stringify!(#name), variants: &[#(stringify!(#variant)),*] },
            };

            fn visit(&self, visit: &mut dyn FnMut(::portable::Literal)) {
                visit(::portable::Literal::Variant(match self { #(Self::#variant => #number),* }));
            }

            fn build(next: &mut dyn FnMut() -> ::portable::Literal) -> Self {
                match next() {
                    #(::portable::Literal::Variant(#number_again) => Self::#variant,)*
                    #unknown
                }
            }
        }
    }
}

/// The generics of a struct with the bound that its description needs: none, or one type parameter.
fn generics(generics: &syn::Generics, rejections: &mut Rejections) -> TokenStream {
    if let Some(clause) = &generics.where_clause {
        rejections.push(clause, "the real type needs no where clause; remove it");
    }
    let mut parameter = None;
    for (position, param) in generics.params.iter().enumerate() {
        match param {
            syn::GenericParam::Type(ty) if position == 0 => parameter = Some(&ty.ident),
            _ => rejections.push(param, "at most one type parameter, the real type; write `<R>`"),
        }
    }
    parameter.map_or_else(TokenStream::new, |parameter| quote!(<#parameter: ::portable::Real>))
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
                break; // the first paragraph says what it is
            }
            lines.push(text.trim().to_owned());
        }
    }
    lines.join(" ")
}

//! Expressions: what each becomes in the IR, and why the others are rejected.
//!
//! A call with a mutable argument, an `if` and a `match` may only be a whole value, alone right of `let` or `=` or at a
//! block's end: languages disagree about when such an operand would run.

use crate::block::{self, Scope};
use crate::function::Mode;
use crate::reject::Rejections;
use crate::{pattern, place};
use proc_macro2::TokenStream;
use quote::quote;

/// Describes a whole value: right of `let` or `=`, or at a block's end.
pub fn whole(expression: &syn::Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match expression {
        syn::Expr::Call(call) => describe_call(call, true, scope, rejections),
        syn::Expr::If(_) | syn::Expr::Match(_) => branching(expression, true, scope, rejections),
        syn::Expr::Array(array) => {
            let elements: Vec<_> = array.elems.iter().map(|element| operand(element, scope, rejections)).collect();
            quote!(::portable::Expr::Array { elements: &[#(#elements),*] })
        }
        syn::Expr::Repeat(repeat) => {
            let (value, len) = (operand(&repeat.expr, scope, rejections), &repeat.len);
            quote!(::portable::Expr::Repeat { value: &#value, len: #len })
        }
        syn::Expr::Paren(paren) => whole(&paren.expr, scope, rejections),
        other => operand(other, scope, rejections),
    }
}

/// Describes a call, an `if` or a `match` whose value is not used.
pub fn statement(expression: &syn::Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match expression {
        syn::Expr::Call(call) => describe_call(call, true, scope, rejections),
        _ => branching(expression, false, scope, rejections),
    }
}

/// Describes the value of `place += operand`.
pub fn compound(binary: &syn::ExprBinary, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    let operator = match binary.op {
        syn::BinOp::AddAssign(_) => quote!(Add),
        syn::BinOp::SubAssign(_) => quote!(Subtract),
        syn::BinOp::MulAssign(_) => quote!(Multiply),
        syn::BinOp::DivAssign(_) => quote!(Divide),
        _ => {
            rejections.push(binary.op, "only + - * / have counterparts; write the arithmetic or comparison instead");
            return TokenStream::new();
        }
    };
    let place = place::describe(&binary.left, scope, rejections);
    let right = operand(&binary.right, scope, rejections);
    quote! {
        ::portable::Expr::Binary {
            operator: ::portable::Binary::#operator,
            left: &::portable::Expr::Read { place: #place },
            right: &#right,
        }
    }
}

/// Describes an index or the bound of a loop: a `usize` that is known when the function is specialised.
pub fn index(expression: &syn::Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match expression {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(integer), .. }) if integer.suffix().is_empty() => {
            quote!(::portable::Expr::Constant { value: || ::portable::Literal::Usize(#integer) })
        }
        syn::Expr::Paren(paren) => index(&paren.expr, scope, rejections),
        syn::Expr::Binary(binary) => {
            let operator = operator(&binary.op, rejections);
            let (left, right) = (index(&binary.left, scope, rejections), index(&binary.right, scope, rejections));
            quote!(::portable::Expr::Binary { operator: ::portable::Binary::#operator, left: &#left, right: &#right })
        }
        other => operand(other, scope, rejections),
    }
}

/// Describes an expression without effect, which may stand anywhere.
fn operand(expression: &syn::Expr, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    match expression {
        syn::Expr::Paren(paren) => operand(&paren.expr, scope, rejections),
        syn::Expr::Group(group) => operand(&group.expr, scope, rejections),
        syn::Expr::Lit(literal) => describe_literal(&literal.lit, rejections),
        _ if place::is_place(expression, scope) => {
            let place = place::describe(expression, scope, rejections);
            quote!(::portable::Expr::Read { place: #place })
        }
        syn::Expr::Path(path) => quote!(::portable::Expr::Constant { value: || ::portable::scalar(&#path) }),
        syn::Expr::Unary(unary) => {
            let operator = match unary.op {
                syn::UnOp::Neg(_) => quote!(Negate),
                syn::UnOp::Not(_) => quote!(Not),
                _ => {
                    rejections.push(unary, "a dereference has no counterpart; borrow a struct and write its field");
                    return TokenStream::new();
                }
            };
            let operand = operand(&unary.expr, scope, rejections);
            quote!(::portable::Expr::Unary { operator: ::portable::Unary::#operator, operand: &#operand })
        }
        syn::Expr::Binary(binary) => {
            let operator = operator(&binary.op, rejections);
            let (left, right) = (operand(&binary.left, scope, rejections), operand(&binary.right, scope, rejections));
            quote!(::portable::Expr::Binary { operator: ::portable::Binary::#operator, left: &#left, right: &#right })
        }
        syn::Expr::Call(call) => describe_call(call, false, scope, rejections),
        other => {
            reject(other, rejections);
            TokenStream::new()
        }
    }
}

fn describe_literal(literal: &syn::Lit, rejections: &mut Rejections) -> TokenStream {
    match literal {
        syn::Lit::Bool(_) => quote!(::portable::Expr::Constant { value: || ::portable::scalar(&#literal) }),
        syn::Lit::Int(integer) if matches!(integer.suffix(), "i32" | "u32" | "usize") => {
            quote!(::portable::Expr::Constant { value: || ::portable::scalar(&#integer) })
        }
        syn::Lit::Int(integer) if integer.suffix().is_empty() => {
            rejections.push(integer, format!("an integer names its type; write `{integer}u32` or `{integer}i32`"));
            TokenStream::new()
        }
        syn::Lit::Int(integer) => {
            rejections.push(integer, "integers are u32 or i32, indices usize; write one of these");
            TokenStream::new()
        }
        syn::Lit::Float(float) => {
            rejections.push(float, format!("a real constant belongs to the real type; write `R::lit({float})`"));
            TokenStream::new()
        }
        other => {
            rejections.push(other, "text has no counterpart; write a number, a bool or an enum");
            TokenStream::new()
        }
    }
}

fn operator(operator: &syn::BinOp, rejections: &mut Rejections) -> TokenStream {
    match operator {
        syn::BinOp::Add(_) => quote!(Add),
        syn::BinOp::Sub(_) => quote!(Subtract),
        syn::BinOp::Mul(_) => quote!(Multiply),
        syn::BinOp::Div(_) => quote!(Divide),
        syn::BinOp::Lt(_) => quote!(Less),
        syn::BinOp::Le(_) => quote!(LessEqual),
        syn::BinOp::Gt(_) => quote!(Greater),
        syn::BinOp::Ge(_) => quote!(GreaterEqual),
        syn::BinOp::Eq(_) => quote!(Equal),
        syn::BinOp::Ne(_) => quote!(NotEqual),
        syn::BinOp::And(_) => quote!(And),
        syn::BinOp::Or(_) => quote!(Or),
        other => {
            rejections.push(other, "only + - * / have counterparts; write the arithmetic or comparison instead");
            quote!(Add)
        }
    }
}

/// Describes an `if` or a `match`.
fn branching(
    expression: &syn::Expr,
    wants_value: bool,
    scope: &mut Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    match expression {
        syn::Expr::If(branch) => {
            rejections.attributes(&branch.attrs);
            let condition = operand(&branch.cond, scope, rejections);
            let then = block::describe(&branch.then_branch, wants_value, scope, rejections);
            let otherwise = match &branch.else_branch {
                Some((_, otherwise)) => block::describe_branch(otherwise, wants_value, scope, rejections),
                None => quote!(::portable::Block { statements: &[], value: None }),
            };
            quote!(::portable::Expr::If { condition: &#condition, then: #then, otherwise: #otherwise })
        }
        syn::Expr::Match(choice) => {
            rejections.attributes(&choice.attrs);
            let scrutinee = operand(&choice.expr, scope, rejections);
            let arms: Vec<_> = choice
                .arms
                .iter()
                .map(|arm| {
                    rejections.attributes(&arm.attrs);
                    let patterns = pattern::describe(&arm.pat, rejections);
                    let body = block::describe_branch(&arm.body, wants_value, scope, rejections);
                    quote!(::portable::Arm { patterns: &[#(#patterns),*], body: #body })
                })
                .collect();
            quote!(::portable::Expr::Match { scrutinee: &#scrutinee, arms: &[#(#arms),*] })
        }
        other => {
            reject(other, rejections);
            TokenStream::new()
        }
    }
}

/// Describes a call; `alone` says whether it is a whole value, where it may change something.
fn describe_call(call: &syn::ExprCall, alone: bool, scope: &mut Scope, rejections: &mut Rejections) -> TokenStream {
    rejections.attributes(&call.attrs);
    let syn::Expr::Path(function) = &*call.func else {
        rejections.push(&call.func, "a call names a portable function; write its path");
        return TokenStream::new();
    };
    let first = function.path.segments.first().map(|segment| &segment.ident);
    if scope.real.is_some() && first == scope.real.as_ref() && function.path.segments.len() > 1 {
        return real_constant(call, rejections);
    }
    if function.path.is_ident(&scope.function) {
        rejections.push(function, "a function that calls itself has no bounded time; write a bounded loop");
        return TokenStream::new();
    }
    let mut path = function.path.clone();
    for segment in &mut path.segments {
        let is_real = |arguments: &syn::AngleBracketedGenericArguments| {
            matches!((arguments.args.first(), arguments.args.len(), &scope.real),
                (Some(syn::GenericArgument::Type(syn::Type::Path(ty))), 1, Some(real)) if ty.path.is_ident(real))
        };
        match &segment.arguments {
            syn::PathArguments::None => {}
            syn::PathArguments::AngleBracketed(arguments) if is_real(arguments) => {}
            arguments => rejections.push(arguments, "a portable function has the caller's real type; write `::<R>` or nothing"),
        }
        segment.arguments = syn::PathArguments::None;
    }
    let mut mutates = false;
    let arguments: Vec<_> =
        call.args.iter().map(|argument| describe_argument(argument, &mut mutates, scope, rejections)).collect();
    if mutates && !alone {
        rejections.push(call, "languages disagree about when a call inside an expression changes its argument; write `let value = ...;` before");
    }
    let real = scope.real.as_ref().map_or_else(|| quote!(R), |real| quote!(#real));
    quote! {
        ::portable::Expr::Call { function: &#path::Ir::<#real>::IR, arguments: &[#(#arguments),*] }
    }
}

/// `R::lit(0.5)` and its kind: rustc evaluates it.
fn real_constant(call: &syn::ExprCall, rejections: &mut Rejections) -> TokenStream {
    for argument in &call.args {
        let number = match argument {
            syn::Expr::Unary(syn::ExprUnary { op: syn::UnOp::Neg(_), expr, .. }) => expr,
            other => other,
        };
        if !matches!(number, syn::Expr::Lit(_)) && !matches!(number, syn::Expr::Path(path) if path.path.segments.last().is_some_and(|name| name.ident.to_string().chars().all(|c| !c.is_lowercase()))) {
            rejections.push(argument, "the real type makes constants of literals; write a number, or `from_u32(value)` for a value");
        }
    }
    quote!(::portable::Expr::Constant { value: || ::portable::scalar(&#call) })
}

fn describe_argument(
    argument: &syn::Expr,
    mutates: &mut bool,
    scope: &mut Scope,
    rejections: &mut Rejections,
) -> TokenStream {
    match argument {
        syn::Expr::Reference(reference) => {
            *mutates |= reference.mutability.is_some();
            let place = place::describe(&reference.expr, scope, rejections);
            quote!(::portable::Argument::Borrow { place: #place })
        }
        syn::Expr::Path(path) if path.path.get_ident().is_some_and(|name| scope.borrowed(name).is_some()) => {
            let name = path.path.get_ident();
            *mutates |= name.and_then(|name| scope.borrowed(name)) == Some(Mode::Mutable);
            quote!(::portable::Argument::Borrow {
                place: ::portable::Place { root: stringify!(#name), projections: &[] },
            })
        }
        value => {
            let value = operand(value, scope, rejections);
            quote!(::portable::Argument::Value { value: #value })
        }
    }
}

/// Rejects an expression that is outside the subset.
pub fn reject(expression: &syn::Expr, rejections: &mut Rejections) {
    use syn::Expr;
    let message = match expression {
        Expr::While(_) | Expr::Loop(_) => "the number of cycles is fixed; write `for i in 0..N`",
        Expr::Break(_) | Expr::Continue(_) => "a loop runs to its end; write an `if` around the rest of its body",
        Expr::Return(_) => "a function ends at its end; give the value in the last expression",
        Expr::MethodCall(_) => "a method has no counterpart; write a portable function or the operators",
        Expr::Closure(_) => "a closure has no counterpart; write a portable function",
        Expr::Macro(_) => "a macro has no counterpart in C or Structured Text; write what it expands to",
        Expr::Cast(_) => "a cast rounds or wraps differently in each language; write `from_u32(value)`, or keep one type",
        Expr::Tuple(_) => "a tuple has no counterpart; write a struct with named fields, or separate locals",
        Expr::Struct(_) => "a struct value has no counterpart; write its fields through a `&mut` parameter",
        Expr::Reference(_) | Expr::RawAddr(_) => "a borrow stands only in a call; pass the place there",
        Expr::Range(_) => "a range stands only in `for i in 0..N`",
        Expr::Try(_) | Expr::TryBlock(_) => "`?` has no counterpart; write `if`",
        Expr::Let(_) => "`if let` has no counterpart; write `match` on an enum",
        Expr::Unsafe(_) => "nothing here needs it; remove `unsafe`",
        Expr::Block(_) | Expr::Const(_) => "a bare block has no counterpart; write its statements without it",
        Expr::Async(_) | Expr::Await(_) => "a block runs within one cycle; write plain statements",
        Expr::If(_) | Expr::Match(_) => {
            "an `if` or a `match` inside an expression has no counterpart; write `let value = if ...;` before"
        }
        Expr::Array(_) | Expr::Repeat(_) => "an array stands alone right of `let` or `=`; write `let name = [...];` before",
        Expr::Assign(_) => "an assignment is a statement; write it on a line of its own",
        Expr::ForLoop(_) => "a loop is a statement; write it on a line of its own",
        _ => "this has no counterpart in C and Structured Text; write it with operators, `if`, `for` and calls",
    };
    rejections.push(expression, message);
}

//! Expressions outside the subset, and what to write instead of each. Their contents are checked too, so that all violations
//! are reported at once.

use crate::reject::Rejections;
use crate::scope::Scope;
use crate::{block, branch, call, expr, place};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{BinOp, Expr, Stmt};

/// What to write instead of a macro.
pub const MACRO: &str = "a macro has no counterpart; write what it expands to";

/// Rejects an expression that is outside the subset.
pub fn reject(expression: &Expr, scope: &mut Scope, rejections: &mut Rejections) {
    rejections.push(head(expression), instead(expression));
    check_inside(expression, scope, rejections);
}

/// Rejects an expression that is not a statement.
pub fn reject_statement(expression: &Expr, scope: &mut Scope, rejections: &mut Rejections) {
    match expression {
        Expr::Tuple(tuple) if tuple.elems.is_empty() => {
            rejections.push(expression, "nothing is written as an empty block; write `{}`, or remove this");
        }
        Expr::Lit(_)
        | Expr::Path(_)
        | Expr::Field(_)
        | Expr::Index(_)
        | Expr::Unary(_)
        | Expr::Binary(_)
        | Expr::Paren(_) => {
            rejections
                .push(expression, "a value that nobody takes has no effect; write `let name = ...;` or remove it");
            check_value(expression, scope, rejections);
        }
        _ => reject(expression, scope, rejections),
    }
}

fn instead(expression: &Expr) -> &'static str {
    match expression {
        Expr::While(_) | Expr::Loop(_) => "the time of a cycle is bounded; write `for i in 0..N`",
        Expr::Break(_) | Expr::Continue(_) => "a loop runs to its end; write an `if` around the rest of its body",
        Expr::Return(_) => "a function ends at its end; write the value as the last expression",
        Expr::MethodCall(_) => "a method has no counterpart; write a portable function or the operators",
        Expr::Closure(_) => "a closure has no counterpart; write a portable function",
        Expr::Macro(_) => MACRO,
        Expr::Cast(_) => {
            "a cast rounds or wraps differently in each language; write `from_u32(value)`, or keep one type"
        }
        Expr::Tuple(_) => "a tuple has no counterpart; write a struct with named fields, or separate locals",
        Expr::Struct(_) => "a struct is not made inside a function; write its fields through a `&mut` parameter",
        Expr::Reference(_) | Expr::RawAddr(_) => {
            "a borrow is an argument and nothing else; write it in the call, `f(&place)`"
        }
        Expr::Range(_) => "a range stands only in a loop; write `for i in 0..N`",
        Expr::Try(_) | Expr::TryBlock(_) => "`?` leaves the function; write an `if` around the rest",
        Expr::Let(_) => "a condition binds no name; write a `match` on an enum",
        Expr::Unsafe(_) => "nothing here needs it; remove `unsafe`",
        Expr::Block(_) => "a block of its own has no counterpart; write its statements without the braces",
        Expr::Const(_) => "a `const` block has no counterpart; write a `const` next to the function, and its name",
        Expr::Async(_) | Expr::Await(_) | Expr::Yield(_) => "a function runs within one cycle; write plain statements",
        Expr::If(_) | Expr::Match(_) => "an `if` or a `match` is not an operand; write `let value = if ...;` before",
        Expr::Array(_) | Expr::Repeat(_) => "an array is not a value; write `let name = [...];`, each element a scalar",
        Expr::Assign(_) | Expr::Binary(_) => "an assignment has no value; write it as a statement",
        Expr::ForLoop(_) => "a loop has no value; write it as a statement",
        Expr::Infer(_) => "`_` takes no value; write the call alone, as a statement",
        Expr::Call(_) => "a call gives no place; write `let value = ...;` before",
        Expr::Unary(_) => "a dereference has no counterpart; write the field, or pass a borrowed parameter by its name",
        _ => "this has no counterpart; write it with operators, `if`, `match`, `for` and calls",
    }
}

/// What to write instead of an operator.
pub fn operator(operator: &BinOp) -> &'static str {
    match operator {
        BinOp::BitAnd(_) | BinOp::BitAndAssign(_) => {
            "bits have no counterpart; write `&&` between bools, or a bool of its own for each bit"
        }
        BinOp::BitOr(_) | BinOp::BitOrAssign(_) => {
            "bits have no counterpart; write `||` between bools, or a bool of its own for each bit"
        }
        BinOp::BitXor(_) | BinOp::BitXorAssign(_) => {
            "bits have no counterpart; write `!=` between bools, or a bool of its own for each bit"
        }
        BinOp::Shl(_) | BinOp::ShlAssign(_) | BinOp::Shr(_) | BinOp::ShrAssign(_) => {
            "a shift has no counterpart; write a product, or a constant"
        }
        _ => "this operator has no counterpart; write + - * / % or a comparison",
    }
}

/// Where the error is shown: at the first word of an expression that may fill many lines, else at the whole expression.
fn head(expression: &Expr) -> TokenStream {
    match expression {
        Expr::While(each) => each.while_token.to_token_stream(),
        Expr::Loop(each) => each.loop_token.to_token_stream(),
        Expr::ForLoop(each) => each.for_token.to_token_stream(),
        Expr::If(branch) => branch.if_token.to_token_stream(),
        Expr::Match(choice) => choice.match_token.to_token_stream(),
        Expr::Unsafe(block) => block.unsafe_token.to_token_stream(),
        Expr::Async(block) => block.async_token.to_token_stream(),
        Expr::Const(block) => block.const_token.to_token_stream(),
        Expr::MethodCall(call) => call.method.to_token_stream(),
        Expr::Let(pattern) => {
            let (word, pattern) = (&pattern.let_token, &pattern.pat);
            quote!(#word #pattern)
        }
        other => other.to_token_stream(),
    }
}

/// Checks the contents of a rejected expression, as far as they have a meaning without it.
fn check_inside(expression: &Expr, scope: &mut Scope, rejections: &mut Rejections) {
    match expression {
        Expr::While(each) => {
            let outer = scope.len();
            check_value(&each.cond, scope, rejections);
            check_block(&each.body, scope, rejections);
            scope.leave(outer);
        }
        Expr::Loop(each) => check_block(&each.body, scope, rejections),
        Expr::Block(inner) => check_block(&inner.block, scope, rejections),
        Expr::Unsafe(inner) => check_block(&inner.block, scope, rejections),
        Expr::ForLoop(each) => drop(block::describe_for(each, scope, rejections)),
        Expr::If(branch) => drop(branch::describe_if(branch, branch.else_branch.is_some(), scope, rejections)),
        Expr::Match(choice) => drop(branch::describe_match(choice, true, scope, rejections)),
        Expr::Call(call) => drop(call::describe(call, true, scope, rejections)),
        Expr::MethodCall(call) => {
            check_value(&call.receiver, scope, rejections);
            check_values(&call.args, scope, rejections);
        }
        Expr::Let(pattern) => {
            check_value(&pattern.expr, scope, rejections);
            scope.enter_rejected(&pattern.pat);
        }
        Expr::Tuple(tuple) => check_values(&tuple.elems, scope, rejections),
        Expr::Array(array) => check_values(&array.elems, scope, rejections),
        Expr::Struct(made) => check_values(made.fields.iter().map(|field| &field.expr), scope, rejections),
        Expr::Repeat(repeat) => check_value(&repeat.expr, scope, rejections),
        Expr::Cast(cast) => check_value(&cast.expr, scope, rejections),
        Expr::Reference(borrow) => check_value(&borrow.expr, scope, rejections),
        Expr::Unary(unary) => check_value(&unary.expr, scope, rejections),
        Expr::Try(tried) => check_value(&tried.expr, scope, rejections),
        Expr::Return(end) => check_values(end.expr.as_deref(), scope, rejections),
        Expr::Break(end) => check_values(end.expr.as_deref(), scope, rejections),
        Expr::Assign(assign) => check_value(&assign.right, scope, rejections),
        Expr::Binary(assign) => check_value(&assign.right, scope, rejections),
        _ => {}
    }
}

fn check_values<'e>(values: impl IntoIterator<Item = &'e Expr>, scope: &mut Scope, rejections: &mut Rejections) {
    for value in values {
        check_value(value, scope, rejections);
    }
}

/// Checks a value. A number or a place alone is not the reason why the surrounding expression is rejected.
fn check_value(value: &Expr, scope: &mut Scope, rejections: &mut Rejections) {
    if !matches!(value, Expr::Lit(_)) && !place::is_place(value, scope) {
        expr::whole(value, scope, rejections);
    }
}

fn check_block(inner: &syn::Block, scope: &mut Scope, rejections: &mut Rejections) {
    block::describe(inner, gives_value(inner), scope, rejections);
}

fn gives_value(inner: &syn::Block) -> bool {
    matches!(inner.stmts.last(), Some(Stmt::Expr(last, None)) if is_value(last))
}

fn is_value(expression: &Expr) -> bool {
    match expression {
        Expr::If(branch) => branch.else_branch.is_some() && gives_value(&branch.then_branch),
        Expr::Match(choice) => choice.arms.first().is_some_and(|arm| is_value(&arm.body)),
        Expr::Block(inner) => gives_value(&inner.block),
        Expr::Binary(binary) => !block::is_compound(&binary.op),
        Expr::Assign(_) | Expr::ForLoop(_) | Expr::While(_) | Expr::Loop(_) | Expr::Call(_) => false,
        _ => true,
    }
}

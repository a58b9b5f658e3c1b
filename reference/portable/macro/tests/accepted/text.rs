//! The IR as text, so that a test says in one line what it expects. Constants are evaluated.

use portable::{
    Argument, Binary, CodeBlock, Expr, Fn, Literal, Mode, Place, Projection, RealKind, Statement, Ty, Unary,
};

/// `name(params) -> type { body }`.
pub fn function(function: &Fn) -> String {
    let params: Vec<_> =
        function.params.iter().map(|param| format!("{}: {}{}", param.name, mode(param.mode), ty(param.ty))).collect();
    let returns = function.returns.map_or_else(String::new, |returns| format!(" -> {}", ty(returns)));
    format!("{}({}){returns} {}", function.name, params.join(", "), block(&function.body.block))
}

/// A type.
pub fn ty(of: Ty) -> String {
    match of {
        Ty::Bool => "bool".into(),
        Ty::I32 => "i32".into(),
        Ty::U32 => "u32".into(),
        Ty::Usize => "usize".into(),
        Ty::Real(RealKind::F64) => "f64".into(),
        Ty::Real(RealKind::F32) => "f32".into(),
        Ty::Array { element, len } => format!("[{}; {len}]", ty(*element)),
        Ty::Struct { def } => def.name.into(),
        Ty::Enum { def } => def.name.into(),
    }
}

fn mode(mode: Mode) -> &'static str {
    match mode {
        Mode::Value => "",
        Mode::Shared => "&",
        Mode::Mutable => "&mut ",
    }
}

fn block(of: &CodeBlock) -> String {
    let mut parts: Vec<_> = of.statements.iter().map(statement).collect();
    parts.extend(of.value.map(expr));
    if parts.is_empty() { "{}".into() } else { format!("{{ {} }}", parts.join(" ")) }
}

fn statement(of: &Statement) -> String {
    match of {
        Statement::Let { name, value } => format!("let {name} = {};", expr(value)),
        Statement::Default { name, leaves, .. } => {
            let mut values = Vec::new();
            leaves(&mut |literal| values.push(format!("{literal:?}")));
            format!("let {name} = default({});", values.join(", "))
        }
        Statement::Note { text } => format!("note({text});"),
        Statement::Assign { place: target, value } => format!("{} = {};", place(target), expr(value)),
        Statement::For { variable, from, to, body } => {
            format!("for {variable} in {}..{} {}", expr(from), expr(to), block(body))
        }
        Statement::Expr { value } => format!("{};", expr(value)),
    }
}

fn expr(of: &Expr) -> String {
    match of {
        Expr::Constant { value } => literal(value()),
        Expr::Read { place: source } => place(source),
        Expr::Unary { operator: Unary::Negate, operand } => format!("-{}", expr(operand)),
        Expr::Unary { operator: Unary::Not, operand } => format!("!{}", expr(operand)),
        Expr::Binary { operator, left, right } => format!("({} {} {})", expr(left), binary(*operator), expr(right)),
        Expr::Call { function, arguments } => format!("{}({})", function.name, list(arguments, argument)),
        Expr::If { condition, then, otherwise } => {
            format!("if {} {} else {}", expr(condition), block(then), block(otherwise))
        }
        Expr::Match { scrutinee, arms } => {
            let arm = |arm: &portable::Arm| {
                let patterns: Vec<_> = arm.patterns.iter().map(|pattern| literal(pattern())).collect();
                let patterns = if patterns.is_empty() { "_".into() } else { patterns.join(" | ") };
                format!("{patterns} => {}", block(&arm.body))
            };
            format!("match {} {{ {} }}", expr(scrutinee), list(arms, arm))
        }
        Expr::Array { elements } => format!("[{}]", list(elements, expr)),
        Expr::Repeat { value, len } => format!("[{}; {len}]", expr(value)),
    }
}

fn argument(of: &Argument) -> String {
    match of {
        Argument::Value { value } => expr(value),
        Argument::Borrow { place: borrowed } => format!("&{}", place(borrowed)),
        Argument::Numbers { structure, part, numbers } => {
            let [structure, part, numbers] = [structure, part, numbers].map(place);
            let with = format!("with_numbers(&{part}, &{numbers})");
            if structure == part { format!("&{with}") } else { format!("&{structure} with {with}") }
        }
    }
}

fn place(of: &Place) -> String {
    of.projections.iter().fold(of.root.to_owned(), |text, projection| match projection {
        Projection::Field { name } => format!("{text}.{name}"),
        Projection::Index { index } => format!("{text}[{}]", expr(index)),
    })
}

fn literal(of: Literal) -> String {
    match of {
        Literal::Bool(value) => value.to_string(),
        Literal::I32(value) => format!("{value}i32"),
        Literal::U32(value) => format!("{value}u32"),
        Literal::Usize(value) => value.to_string(),
        Literal::F64(value) => format!("{value:?}f64"),
        Literal::F32(value) => format!("{value:?}f32"),
        Literal::Variant(variant) => format!("variant {}", variant.index),
    }
}

fn binary(operator: Binary) -> &'static str {
    match operator {
        Binary::Add => "+",
        Binary::Subtract => "-",
        Binary::Multiply => "*",
        Binary::Remainder => "%",
        Binary::Divide => "/",
        Binary::Less => "<",
        Binary::LessEqual => "<=",
        Binary::Greater => ">",
        Binary::GreaterEqual => ">=",
        Binary::Equal => "==",
        Binary::NotEqual => "!=",
        Binary::And => "&&",
        Binary::Or => "||",
    }
}

fn list<T>(of: &[T], text: impl core::ops::Fn(&T) -> String) -> String {
    of.iter().map(text).collect::<Vec<_>>().join(", ")
}

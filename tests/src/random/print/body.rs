//! Statements and expressions as Rust text, one to one.

use super::Text;
use crate::random::syntax::{
    Argument, Block, Call, Callee, Choice, Expr, Length, Mode, Place, Selection, Statement, Step, Value,
};
use portable::{Binary, Intrinsic, Unary};
use std::fmt::Write;

/// The text of a length.
pub fn length(length: Length) -> String {
    length.named.map_or_else(|| length.count.to_string(), |position| format!("LEN{position}"))
}

impl Text<'_> {
    /// The inside of a block.
    pub fn block(&mut self, block: &Block) {
        self.level += 1;
        for statement in &block.statements {
            self.statement(statement);
        }
        if let Some(value) = &block.value {
            let value = self.whole(value);
            self.line(&value);
        }
        self.level -= 1;
    }

    fn statement(&mut self, statement: &Statement) {
        let line = match statement {
            Statement::Let { name, mutable, value } => {
                format!("let {}{name} = {};", if *mutable { "mut " } else { "" }, self.whole(value))
            }
            Statement::Assign { place, value } => format!("{} = {};", self.place(place), self.whole(value)),
            Statement::Compound { place, operator, value } => {
                format!("{} {}= {};", self.place(place), symbol(*operator).0, self.expr(value, 0, false))
            }
            Statement::For { variable, from, to, body } => {
                let range = format!("{}..{}", self.expr(from, 3, true), self.expr(to, 3, true));
                self.line(&format!("for {variable} in {range} {{"));
                self.block(body);
                "}".to_owned()
            }
            Statement::If(choice) => self.choice(choice),
            Statement::Match(selection) => self.selection(selection),
            Statement::Call(call) => format!("{};", self.call(call)),
        };
        self.line(&line);
    }

    /// What stands inside, written for its own place, at the present level.
    fn inside(&mut self, write: impl FnOnce(&mut Self)) -> String {
        let outside = std::mem::take(&mut self.text);
        let level = std::mem::take(&mut self.level);
        write(self);
        self.level = level;
        std::mem::replace(&mut self.text, outside).trim_end().to_owned()
    }

    fn choice(&mut self, choice: &Choice) -> String {
        let condition = self.expr(&choice.condition, 0, false);
        let then = self.inside(|text| text.block(&choice.then));
        let mut written = format!("if {condition} {{\n{then}\n}}");
        if let Some(otherwise) = &choice.otherwise {
            match (otherwise.statements.as_slice(), otherwise.value.as_deref()) {
                ([Statement::If(next)], None) => {
                    let _ = write!(written, " else {}", self.choice(next));
                }
                ([], Some(Expr::If(next))) => {
                    let _ = write!(written, " else {}", self.choice(next));
                }
                _ => {
                    let otherwise = self.inside(|text| text.block(otherwise));
                    let _ = write!(written, " else {{\n{otherwise}\n}}");
                }
            }
        }
        written
    }

    fn selection(&mut self, selection: &Selection) -> String {
        let mut written = format!("match {} {{\n", self.expr(&selection.scrutinee, 0, false));
        for arm in &selection.arms {
            let patterns: Vec<String> = arm.patterns.iter().map(|pattern| self.value(*pattern, false)).collect();
            let patterns = if patterns.is_empty() { "_".to_owned() } else { patterns.join(" | ") };
            let body = match (arm.body.statements.as_slice(), arm.body.value.as_deref()) {
                ([], Some(value)) => format!("{},", self.whole(value)),
                _ => format!("{{\n{}\n}}", self.inside(|text| text.block(&arm.body))),
            };
            let _ = write!(written, "{}", indented(&format!("{patterns} => {body}")));
        }
        written + "}"
    }

    /// A value that stands alone: right of `let` or `=`, or at a block's end.
    fn whole(&mut self, expr: &Expr) -> String {
        match expr {
            Expr::If(choice) => self.choice(choice),
            Expr::Match(selection) => self.selection(selection),
            Expr::Array(elements) => {
                let elements: Vec<String> = elements.iter().map(|element| self.expr(element, 0, false)).collect();
                format!("[{}]", elements.join(", "))
            }
            Expr::Repeat(element, count) => format!("[{}; {}]", self.expr(element, 0, false), length(*count)),
            scalar => self.expr(scalar, 0, false),
        }
    }

    /// An expression that binds at least so tightly; `index`: where a number alone is a `usize`.
    fn expr(&self, expr: &Expr, least: u8, index: bool) -> String {
        match expr {
            Expr::Literal(value) => self.value(*value, index),
            Expr::Read(place, _) => self.place(place),
            Expr::Unary(operator, operand) => {
                let symbol = if *operator == Unary::Not { "!" } else { "-" };
                // After a second minus rustc takes the number of the first alone, which is too large.
                match **operand {
                    Expr::Literal(Value::I32(i32::MIN)) => format!("{symbol}i32::MIN"),
                    _ => format!("{symbol}{}", self.expr(operand, 7, index)),
                }
            }
            Expr::Binary(operator, left, right) => {
                let (symbol, binds) = symbol(*operator);
                let left_binds = if binds == 4 { 5 } else { binds };
                let (left, right) = (self.expr(left, left_binds, index), self.expr(right, binds + 1, index));
                let text = format!("{left} {symbol} {right}");
                if binds < least { format!("({text})") } else { text }
            }
            Expr::Call(call) => self.call(call),
            Expr::If(_) | Expr::Match(_) | Expr::Array(_) | Expr::Repeat(..) => {
                panic!("print: {expr:?} stands inside an expression")
            }
        }
    }

    fn call(&self, call: &Call) -> String {
        let (path, hides_real) = match call.callee {
            Callee::Intrinsic(Intrinsic::InRange) => ("in_range".to_owned(), false),
            Callee::Intrinsic(Intrinsic::Within) => ("within".to_owned(), false),
            Callee::Intrinsic(Intrinsic::FromU32) => ("from_u32".to_owned(), true),
            Callee::Intrinsic(Intrinsic::FromI32) => ("from_i32".to_owned(), true),
            Callee::Intrinsic(Intrinsic::Truncate) => ("truncate".to_owned(), false),
            Callee::Intrinsic(Intrinsic::Nearest) => ("nearest".to_owned(), false),
            Callee::Intrinsic(Intrinsic::Unsigned) => ("unsigned".to_owned(), false),
            Callee::Intrinsic(Intrinsic::Narrow) => panic!("print: the specialiser alone narrows"),
            Callee::Function(which) => {
                let function = &self.program.functions[which];
                let module = match (self.inner, function.inner) {
                    (true, false) => "super::",
                    (false, true) => "inner::",
                    _ => "",
                };
                let hides_real = self.generic[which] && !self.program.shows_real(function);
                (format!("{module}{}", function.name), hides_real)
            }
        };
        let arguments: Vec<String> = call.arguments.iter().map(|argument| self.argument(argument)).collect();
        format!("{path}{}({})", if hides_real { "::<R>" } else { "" }, arguments.join(", "))
    }

    fn argument(&self, argument: &Argument) -> String {
        match argument {
            Argument::Value(value) => self.expr(value, 0, false),
            Argument::Shared(place) if self.is_borrowed(place, Mode::Shared) => place.root.clone(),
            Argument::Shared(place) => format!("&{}", self.place(place)),
            Argument::Mutable(place) if self.is_borrowed(place, Mode::Mutable) => place.root.clone(),
            Argument::Mutable(place) => format!("&mut {}", self.place(place)),
        }
    }

    /// Whether a place is a whole parameter that is borrowed already: it is passed on by its name.
    fn is_borrowed(&self, place: &Place, mode: Mode) -> bool {
        let mut params = self.program.functions[self.function].params.iter();
        place.steps.is_empty() && params.any(|param| param.name == place.root && param.mode == mode)
    }

    fn place(&self, place: &Place) -> String {
        let mut text = place.root.clone();
        for step in &place.steps {
            match step {
                Step::Field(name) => {
                    let _ = write!(text, ".{name}");
                }
                Step::Index(index) => {
                    let _ = write!(text, "[{}]", self.expr(index, 0, true));
                }
            }
        }
        text
    }

    /// A constant.
    pub fn value(&self, value: Value, index: bool) -> String {
        match value {
            Value::Zero => "R::ZERO".to_owned(),
            Value::One => "R::ONE".to_owned(),
            Value::Lit(value) => format!("R::lit({value:?})"),
            Value::PerKind(double, single) => format!("R::per_kind({double:?}, {single:?})"),
            Value::Bool(value) => value.to_string(),
            Value::I32(value) => format!("{value}i32"),
            Value::U32(u32::MAX) => "u32::MAX".to_owned(),
            Value::U32(value) => format!("{value}u32"),
            Value::Usize(value) if index => value.to_string(),
            Value::Usize(value) => format!("{value}usize"),
            Value::Length(position) => format!("LEN{position}"),
            Value::Variant(which, variant) => format!("E{which}::V{variant}"),
        }
    }
}

/// Each line one level further in.
fn indented(text: &str) -> String {
    text.lines().map(|line| format!("    {line}\n")).collect()
}

/// How an operator is written, and how tightly it binds.
fn symbol(operator: Binary) -> (&'static str, u8) {
    match operator {
        Binary::Multiply => ("*", 6),
        Binary::Divide => ("/", 6),
        Binary::Remainder => ("%", 6),
        Binary::Add => ("+", 5),
        Binary::Subtract => ("-", 5),
        Binary::Less => ("<", 4),
        Binary::LessEqual => ("<=", 4),
        Binary::Greater => (">", 4),
        Binary::GreaterEqual => (">=", 4),
        Binary::Equal => ("==", 4),
        Binary::NotEqual => ("!=", 4),
        Binary::And => ("&&", 3),
        Binary::Or => ("||", 2),
    }
}

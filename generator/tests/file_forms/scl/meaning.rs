//! What an SCL block means: its names, its types, and that each temporary has a value before it is read.

use super::syntax::{Block, Declaration, Expr, Section, Statement};
use super::token::is_name;
use super::words::is_reserved;
use std::collections::{BTreeMap, BTreeSet};

/// The type of an expression. Digits alone have none of their own: they take that of what stands on the other side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Type {
    Bool,
    Dint,
    Udint,
    Real,
    Lreal,
}

struct Scope<'b> {
    declared: BTreeMap<&'b str, (&'b Declaration, Type)>,
}

/// What is wrong with a block.
pub fn check(block: &Block) -> Result<(), String> {
    let mut scope = Scope { declared: BTreeMap::new() };
    let mut names = BTreeSet::new();
    for declaration in &block.declarations {
        let Declaration { section, name, line, .. } = declaration;
        let fail = |what: &str| Err(format!("line {line}: {name}: {what}"));
        if !is_name(name) || is_reserved(name) {
            return fail("no name");
        }
        if !names.insert(name.to_ascii_lowercase()) {
            return fail("declared twice");
        }
        let Some(ty) = type_of(&declaration.ty) else { return fail("no type") };
        match (&declaration.value, section) {
            (None, Section::Constant) => return fail("a constant without a value"),
            (Some(_), Section::Temp) => return fail("a temporary with a value"),
            (Some(value), _) if !fits(value, ty) => return fail("its value is of another type"),
            _ => scope.declared.insert(name, (declaration, ty)),
        };
    }
    scope.list(&block.body, BTreeSet::new()).map(|_| ())
}

fn type_of(name: &str) -> Option<Type> {
    match name {
        "BOOL" => Some(Type::Bool),
        "DINT" => Some(Type::Dint),
        "UDINT" => Some(Type::Udint),
        "REAL" => Some(Type::Real),
        "LREAL" => Some(Type::Lreal),
        _ => None,
    }
}

/// Whether digits or a truth value are one of a type, and within its range.
fn fits(value: &Expr, ty: Type) -> bool {
    let (digits, is_negative) = match value {
        Expr::Bool(_) => return ty == Type::Bool,
        Expr::Number(digits) => (digits, false),
        Expr::Unary(operator, operand) => match operand.as_ref() {
            Expr::Number(digits) if operator == "-" => (digits, true),
            _ => return false,
        },
        _ => return false,
    };
    let sign = if is_negative { "-" } else { "" };
    match ty {
        Type::Bool => false,
        Type::Dint => format!("{sign}{digits}").parse::<i32>().is_ok(),
        Type::Udint => !is_negative && digits.parse::<u32>().is_ok(),
        Type::Real => digits.contains('.') && digits.parse::<f32>().is_ok_and(f32::is_finite),
        Type::Lreal => digits.contains('.') && digits.parse::<f64>().is_ok_and(f64::is_finite),
    }
}

impl<'b> Scope<'b> {
    /// The temporaries that have a value behind the statements, if `known` have one before.
    fn list(&self, list: &'b [Statement], mut known: BTreeSet<&'b str>) -> Result<BTreeSet<&'b str>, String> {
        for statement in list {
            match statement {
                Statement::Assign { target, value, line } => {
                    let fail = |what: &str| Err(format!("line {line}: #{target}: {what}"));
                    let Some((declaration, ty)) = self.declared.get(target.as_str()) else {
                        return fail("not declared");
                    };
                    self.has_type(value, *ty, &known).map_err(|what| format!("line {line}: {what}"))?;
                    match declaration.section {
                        Section::Input | Section::Constant => return fail("must not be written"),
                        Section::Temp => _ = known.insert(target),
                        Section::Output | Section::Static => {}
                    }
                }
                Statement::If { branches, otherwise } => {
                    let mut behind: Option<BTreeSet<&str>> = None;
                    let mut merge = |branch: BTreeSet<&'b str>| {
                        behind = Some(match behind.take() {
                            Some(others) => others.intersection(&branch).copied().collect(),
                            None => branch,
                        });
                    };
                    for ((condition, line), list) in branches {
                        self.has_type(condition, Type::Bool, &known).map_err(|what| format!("line {line}: {what}"))?;
                        merge(self.list(list, known.clone())?);
                    }
                    merge(otherwise.as_ref().map_or(Ok(known.clone()), |list| self.list(list, known.clone()))?);
                    known = behind.unwrap_or_default();
                }
            }
        }
        Ok(known)
    }

    /// Whether an expression has a type: digits by themselves fit it, everything else is of it.
    fn has_type(&self, expr: &Expr, ty: Type, known: &BTreeSet<&str>) -> Result<(), String> {
        if fits(expr, ty) {
            return Ok(());
        }
        let found = self.ty(expr, known)?;
        if found == ty { Ok(()) } else { Err(format!("{found:?} instead of {ty:?}")) }
    }

    fn ty(&self, expr: &Expr, known: &BTreeSet<&str>) -> Result<Type, String> {
        match expr {
            Expr::Bool(_) => Ok(Type::Bool),
            Expr::Number(digits) => Err(format!("{digits} takes no type here")),
            Expr::Variable(name) => match self.declared.get(name.as_str()) {
                None => Err(format!("#{name} is not declared")),
                Some((declaration, _)) if declaration.section == Section::Temp && !known.contains(name.as_str()) => {
                    Err(format!("#{name} is read before it has a value on every way"))
                }
                Some((_, ty)) => Ok(*ty),
            },
            Expr::Call(function, operand) => {
                // TRUNC gives a DINT of either real type.
                if function == "TRUNC" {
                    return match self.ty(operand, known)? {
                        Type::Real | Type::Lreal => Ok(Type::Dint),
                        ty => Err(format!("TRUNC of {ty:?}")),
                    };
                }
                let (from, ty) = match function.as_str() {
                    "UDINT_TO_LREAL" => (Type::Udint, Type::Lreal),
                    "UDINT_TO_REAL" => (Type::Udint, Type::Real),
                    "DINT_TO_LREAL" => (Type::Dint, Type::Lreal),
                    "DINT_TO_REAL" => (Type::Dint, Type::Real),
                    _ => return Err(format!("{function} is no conversion")),
                };
                self.has_type(operand, from, known).map(|()| ty)
            }
            Expr::Unary(operator, operand) => match (operator.as_str(), self.ty(operand, known)?) {
                ("NOT", Type::Bool) => Ok(Type::Bool),
                ("-", ty @ (Type::Dint | Type::Real | Type::Lreal)) => Ok(ty),
                (_, ty) => Err(format!("{operator} of {ty:?}")),
            },
            Expr::Binary(operator, left, right) => self.binary(operator, left, right, known),
        }
    }

    /// Both sides are of one type. Digits beside a variable are whole numbers: whether `0.5` beside a REAL makes the
    /// expression LREAL is for the compiler to say, so that reals have names.
    fn binary(&self, operator: &str, left: &Expr, right: &Expr, known: &BTreeSet<&str>) -> Result<Type, String> {
        let ty = match (left, right) {
            (Expr::Number(_), _) => self.ty(right, known)?,
            _ => self.ty(left, known)?,
        };
        for side in [left, right] {
            self.has_type(side, ty, known)?;
            if matches!(side, Expr::Number(digits) if digits.contains('.')) {
                return Err("a real number without a name in an expression".to_owned());
            }
        }
        let is_real = matches!(ty, Type::Real | Type::Lreal);
        match operator {
            "AND" | "OR" if ty == Type::Bool => Ok(Type::Bool),
            "=" | "<>" => Ok(Type::Bool),
            "<" | ">" | "<=" | ">=" if ty != Type::Bool => Ok(Type::Bool),
            "+" | "-" | "*" if ty != Type::Bool => Ok(ty),
            "/" if is_real => Ok(ty),
            _ => Err(format!("{operator} of {ty:?}")),
        }
    }
}

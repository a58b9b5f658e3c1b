//! Programs as the text of a Rust module: the items. Statements and expressions stand in `body`.

mod body;

use super::syntax::{COEFFS, Function, INPUTS, Mode, OUTPUTS, Program, STATE, Scalar, Tree, Type};
use std::collections::BTreeSet;
use std::fmt::Write;

/// The text of a program's module. `name` is what the block is called.
#[must_use]
pub fn module(program: &Program, name: &str) -> String {
    let mut text =
        Text { program, generic: program.generic(), function: 0, inner: false, level: 0, text: String::new() };
    let (used, cloned) = (used_structs(program), parts(program, &[INPUTS]));
    for which in used {
        text.structure(which, cloned.contains(&which));
    }
    text.functions();
    text.subject(name);
    let items = std::mem::take(&mut text.text);
    text.line("use portable::{Real, from_i32, from_u32, nearest, portable, truncate, in_range, within};\n");
    let is_named = |name: &str| items.split(|c: char| !c.is_ascii_alphanumeric()).any(|word| word == name);
    for (position, count) in program.lengths.iter().enumerate().filter(|(at, _)| is_named(&format!("LEN{at}"))) {
        text.line(&format!("pub const LEN{position}: usize = {count};\n"));
    }
    for (position, variants) in program.enums.iter().enumerate().filter(|(at, _)| is_named(&format!("E{at}"))) {
        let variants: Vec<String> = (0..*variants).map(|variant| format!("V{variant}")).collect();
        text.line("#[portable]\n#[derive(Clone, Copy, PartialEq)]");
        text.line(&format!("pub enum E{position} {{ {} }}\n", variants.join(", ")));
    }
    text.text + &items
}

/// How many lines of a module are written by its author: all but the blank ones and what makes a block of it.
#[must_use]
pub fn lines(program: &Program) -> usize {
    let module = module(program, "block");
    let own = module.split("inside::subject!").next().unwrap_or_default();
    own.lines().filter(|line| !line.trim().is_empty() && !line.starts_with("use ")).count()
}

/// The text so far.
struct Text<'p> {
    program: &'p Program,
    /// which functions have the real type as a parameter
    generic: Vec<bool>,
    /// the function that is being written
    function: usize,
    /// whether the inner module is being written
    inner: bool,
    level: usize,
    text: String,
}

impl Text<'_> {
    fn line(&mut self, line: &str) {
        let indent = "    ".repeat(self.level);
        for part in line.split('\n') {
            if !part.is_empty() {
                let _ = write!(self.text, "{indent}{part}");
            }
            self.text.push('\n');
        }
    }

    fn structure(&mut self, which: usize, cloned: bool) {
        let ty = Type::Struct(which);
        self.line("#[portable]");
        if cloned {
            self.line("#[derive(Clone)]");
        }
        let fields = &self.program.structs[which].fields;
        if fields.is_empty() {
            self.line(&format!("pub struct {} {{}}\n", self.ty(&ty)));
            return;
        }
        self.line(&format!("pub struct {} {{", self.ty(&ty)));
        for (name, ty) in fields {
            self.line(&format!("    pub {name}: {},", self.ty(ty)));
        }
        self.line("}\n");
    }

    fn functions(&mut self) {
        let functions = &self.program.functions;
        let reached = reached(self.program);
        let shown = |inner: bool| {
            let of_module = functions.iter().enumerate().filter(|(_, function)| function.inner == inner);
            of_module.filter(|(which, _)| reached.contains(which)).collect::<Vec<_>>()
        };
        if !shown(true).is_empty() {
            self.line("pub mod inner {\n    use super::*;\n");
            (self.inner, self.level) = (true, 1);
            shown(true).into_iter().for_each(|(which, function)| self.function(which, function));
            (self.inner, self.level) = (false, 0);
            self.line("}\n");
        }
        shown(false).into_iter().for_each(|(which, function)| self.function(which, function));
    }

    fn function(&mut self, which: usize, function: &Function) {
        self.function = which;
        let generic = if self.generic[which] { "<R: Real>" } else { "" };
        let params: Vec<String> = function
            .params
            .iter()
            .map(|param| {
                let borrow = match param.mode {
                    Mode::Value => "",
                    Mode::Shared => "&",
                    Mode::Mutable => "&mut ",
                };
                format!("{}: {borrow}{}", param.name, self.ty(&param.ty))
            })
            .collect();
        let returns = function.returns.map(|scalar| format!(" -> {}", scalar_name(scalar))).unwrap_or_default();
        self.line("#[portable]");
        self.line(&format!("pub fn {}{generic}({}){returns} {{", function.name, params.join(", ")));
        self.block(&function.body);
        self.line("}\n");
    }

    fn subject(&mut self, name: &str) {
        let ty = |which| self.ty(&Type::Struct(which));
        let types = [STATE, COEFFS, INPUTS, OUTPUTS].map(ty).join(", ");
        let coefficients = self.tree(&self.program.coefficients);
        self.line(&format!("inside::subject!(\"{name}\", {types}, {coefficients});"));
    }

    fn tree(&self, tree: &Tree) -> String {
        match tree {
            Tree::Leaf(value) => self.value(*value, false),
            Tree::Array(elements) => {
                let elements: Vec<String> = elements.iter().map(|element| self.tree(element)).collect();
                format!("[{}]", elements.join(", "))
            }
            Tree::Struct(which, fields) => {
                let fields = fields.iter().map(|(name, tree)| format!("{name}: {}", self.tree(tree)));
                let fields = fields.collect::<Vec<_>>().join(", ");
                format!("{} {{ {fields} }}", self.program.structs[*which].name)
            }
        }
    }

    fn ty(&self, ty: &Type) -> String {
        match ty {
            Type::Scalar(scalar) => scalar_name(*scalar),
            Type::Struct(which) => {
                let real = if self.program.is_real(ty) { "<R>" } else { "" };
                format!("{}{real}", self.program.structs[*which].name)
            }
            Type::Array(element, length) => format!("[{}; {}]", self.ty(element), body::length(*length)),
        }
    }
}

fn scalar_name(scalar: Scalar) -> String {
    match scalar {
        Scalar::Real => "R".to_owned(),
        Scalar::Bool => "bool".to_owned(),
        Scalar::I32 => "i32".to_owned(),
        Scalar::U32 => "u32".to_owned(),
        Scalar::Usize => "usize".to_owned(),
        Scalar::Enum(which) => format!("E{which}"),
    }
}

/// The functions that `init` and `step` call, those two included.
#[must_use]
pub fn reached(program: &Program) -> BTreeSet<usize> {
    let count = program.functions.len();
    let mut reached: BTreeSet<usize> = [count - 2, count - 1].into();
    for which in (0..count).rev() {
        if reached.contains(&which) {
            reached.extend(program.functions[which].body.callees());
        }
    }
    reached
}

/// The structs that the block or a reached function has.
fn used_structs(program: &Program) -> BTreeSet<usize> {
    parts(program, &[STATE, COEFFS, INPUTS, OUTPUTS])
}

/// The structs that are part of some, those included.
fn parts(program: &Program, roots: &[usize]) -> BTreeSet<usize> {
    let (mut found, mut open) = (BTreeSet::new(), roots.to_vec());
    while let Some(which) = open.pop() {
        if found.insert(which) {
            open.extend(program.structs[which].fields.iter().filter_map(|(_, ty)| struct_of(ty)));
        }
    }
    found
}

fn struct_of(ty: &Type) -> Option<usize> {
    match ty {
        Type::Scalar(_) => None,
        Type::Struct(which) => Some(*which),
        Type::Array(element, _) => struct_of(element),
    }
}

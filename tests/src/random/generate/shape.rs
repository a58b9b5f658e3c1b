//! The types of a program: enums, named lengths, structs, and the value of the coefficients.

use super::constant;
use crate::random::choices::Choices;
use crate::random::syntax::{COEFFS, Length, OUTPUTS, Program, Scalar, Struct, Tree, Type};

/// Names of fields. Some are words of C, which the C printer has to change; none has a digit or an underscore, which
/// stand in the names that C gives to elements and parts.
const FIELDS: [&str; 18] = [
    "a", "b", "gain", "x", "y", "level", "w", "k", "m", "double", "int", "register", "sum", "auto", "old", "step",
    "limit", "u",
];

/// A program without functions.
pub fn types(choices: &mut Choices) -> Program {
    let enums = (0..choices.weighted(&[40, 50, 10])).map(|_| choices.between(2, 4)).collect();
    let lengths = (0..choices.weighted(&[45, 45, 10])).map(|_| choices.between(2, 4)).collect();
    let coefficients = Tree::Array(Vec::new());
    let structs = ["State", "Coeffs", "Inputs", "Outputs"].map(|name| Struct { name: name.to_owned(), fields: vec![] });
    let mut program = Program { enums, lengths, structs: structs.into(), functions: Vec::new(), coefficients };
    let parts = choices.weighted(&[45, 43, 12]);
    for part in 0..parts {
        program.structs.push(Struct { name: format!("Part{part}"), fields: Vec::new() });
    }
    let first = OUTPUTS + 1;
    // A part may hold those after it, so that none holds itself.
    for part in (0..parts).rev() {
        let count = choices.between(1, 2);
        program.structs[first + part].fields = fields(count, first + part + 1, None, &program, choices);
    }
    for (which, most) in [3, 3, 3, 2].into_iter().enumerate() {
        let count = choices.between(if which == COEFFS || which == OUTPUTS { 1 } else { 2 }, most);
        program.structs[which].fields = fields(count, first, Some(which), &program, choices);
    }
    program.coefficients = tree(&Type::Struct(COEFFS), &program, choices);
    program
}

/// Fields of a struct; `of_block`: of one that every program has. Only coefficients may hold a `usize`.
fn fields(
    count: usize,
    first_part: usize,
    of_block: Option<usize>,
    program: &Program,
    choices: &mut Choices,
) -> Vec<(String, Type)> {
    let mut names = FIELDS.to_vec();
    let mut fields = Vec::new();
    for position in 0..count {
        choices.enter();
        let name = names.remove(choices.of_place(names.len()));
        let own = ty(first_part, of_block == Some(COEFFS), program, choices);
        // Something real goes in, is kept and comes out: most errors of arithmetic show there.
        let is_real = position == 0 && of_block.is_some_and(|which| which != COEFFS);
        if choices.is_there() {
            fields.push((name.to_owned(), if is_real { Type::Scalar(Scalar::Real) } else { own }));
        }
        choices.leave();
    }
    fields
}

fn ty(first_part: usize, known: bool, program: &Program, choices: &mut Choices) -> Type {
    let has_parts = usize::from(first_part < program.structs.len());
    match choices.weighted(&[60, 20, 22 * has_parts, 10 * has_parts, 3]) {
        0 => Type::Scalar(scalar(known, program, choices)),
        1 => Type::Array(Box::new(Type::Scalar(scalar(known, program, choices))), length(program, choices)),
        2 => Type::Struct(choices.between(first_part, program.structs.len() - 1)),
        3 => {
            let part = Type::Struct(choices.between(first_part, program.structs.len() - 1));
            Type::Array(Box::new(part), Length { count: 2, named: None })
        }
        _ => {
            let row = Type::Array(Box::new(Type::Scalar(Scalar::Real)), Length { count: 2, named: None });
            Type::Array(Box::new(row), length(program, choices))
        }
    }
}

/// The type of a scalar.
pub fn scalar(known: bool, program: &Program, choices: &mut Choices) -> Scalar {
    let enums = usize::from(!program.enums.is_empty());
    match choices.weighted(&[42, 16, 17, 18, 25 * usize::from(known), 14 * enums]) {
        0 => Scalar::Real,
        1 => Scalar::Bool,
        2 => Scalar::I32,
        3 => Scalar::U32,
        4 => Scalar::Usize,
        _ => Scalar::Enum(choices.below(program.enums.len())),
    }
}

/// The length of an array.
pub fn length(program: &Program, choices: &mut Choices) -> Length {
    if !program.lengths.is_empty() && choices.chance(50) {
        let named = choices.below(program.lengths.len());
        return Length { count: program.lengths[named], named: Some(named) };
    }
    Length { count: choices.between(2, 4), named: None }
}

/// A value of a type.
fn tree(ty: &Type, program: &Program, choices: &mut Choices) -> Tree {
    match ty {
        Type::Scalar(scalar) => Tree::Leaf(constant::value(*scalar, &program.enums, choices)),
        Type::Array(element, length) => {
            Tree::Array((0..length.count).map(|_| tree(element, program, choices)).collect())
        }
        Type::Struct(which) => {
            let fields = program.structs[*which].fields.iter();
            let mut field = |(name, ty): &(String, Type)| {
                choices.enter_named(name);
                let value = tree(ty, program, choices);
                choices.leave();
                (name.clone(), value)
            };
            Tree::Struct(*which, fields.map(&mut field).collect())
        }
    }
}

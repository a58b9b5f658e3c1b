//! The types of a program: enums, named lengths, structs, and the value of the coefficients.

use super::constant;
use crate::random::rng::Rng;
use crate::random::syntax::{COEFFS, INPUTS, Length, OUTPUTS, Program, STATE, Scalar, Struct, Tree, Type};

/// Names of fields. Some are words of C, which the C printer has to change; none has a digit or an underscore, which
/// stand in the names that C gives to elements and parts.
const FIELDS: [&str; 18] = [
    "a", "b", "gain", "x", "y", "level", "w", "k", "m", "double", "int", "register", "sum", "auto", "old", "step",
    "limit", "u",
];

/// A program without functions.
pub fn types(rng: &mut Rng) -> Program {
    let enums = (0..rng.weighted(&[40, 50, 10])).map(|_| rng.between(2, 4)).collect();
    let lengths = (0..rng.weighted(&[45, 45, 10])).map(|_| rng.between(2, 4)).collect();
    let coefficients = Tree::Array(Vec::new());
    let structs = ["State", "Coeffs", "Inputs", "Outputs"].map(|name| Struct { name: name.to_owned(), fields: vec![] });
    let mut program = Program { enums, lengths, structs: structs.into(), functions: Vec::new(), coefficients };
    let parts = rng.weighted(&[45, 43, 12]);
    for part in 0..parts {
        program.structs.push(Struct { name: format!("Part{part}"), fields: Vec::new() });
    }
    let first = OUTPUTS + 1;
    // A part may hold those after it, so that none holds itself.
    for part in (0..parts).rev() {
        let count = rng.between(1, 2);
        program.structs[first + part].fields = fields(count, first + part + 1, false, &program, rng);
    }
    for (which, most) in [3, 3, 3, 2].into_iter().enumerate() {
        let count = rng.between(if which == COEFFS || which == OUTPUTS { 1 } else { 2 }, most);
        program.structs[which].fields = fields(count, first, which == COEFFS, &program, rng);
    }
    // Something real goes in, is kept and comes out: most errors of arithmetic show there.
    for which in [STATE, INPUTS, OUTPUTS] {
        program.structs[which].fields[0].1 = Type::Scalar(Scalar::Real);
    }
    program.coefficients = tree(&Type::Struct(COEFFS), &program, rng);
    program
}

/// Fields of a struct; `known`: of the coefficients, which alone may hold a `usize`.
fn fields(count: usize, first_part: usize, known: bool, program: &Program, rng: &mut Rng) -> Vec<(String, Type)> {
    let mut names = FIELDS.to_vec();
    (0..count)
        .map(|_| {
            let name = names.remove(rng.below(names.len()));
            (name.to_owned(), ty(first_part, known, program, rng))
        })
        .collect()
}

fn ty(first_part: usize, known: bool, program: &Program, rng: &mut Rng) -> Type {
    let has_parts = usize::from(first_part < program.structs.len());
    match rng.weighted(&[60, 20, 22 * has_parts, 10 * has_parts, 3]) {
        0 => Type::Scalar(scalar(known, program, rng)),
        1 => Type::Array(Box::new(Type::Scalar(scalar(known, program, rng))), length(program, rng)),
        2 => Type::Struct(rng.between(first_part, program.structs.len() - 1)),
        3 => {
            let part = Type::Struct(rng.between(first_part, program.structs.len() - 1));
            Type::Array(Box::new(part), Length { count: 2, named: None })
        }
        _ => {
            let row = Type::Array(Box::new(Type::Scalar(Scalar::Real)), Length { count: 2, named: None });
            Type::Array(Box::new(row), length(program, rng))
        }
    }
}

/// The type of a scalar.
pub fn scalar(known: bool, program: &Program, rng: &mut Rng) -> Scalar {
    let enums = usize::from(!program.enums.is_empty());
    match rng.weighted(&[42, 16, 17, 18, 25 * usize::from(known), 14 * enums]) {
        0 => Scalar::Real,
        1 => Scalar::Bool,
        2 => Scalar::I32,
        3 => Scalar::U32,
        4 => Scalar::Usize,
        _ => Scalar::Enum(rng.below(program.enums.len())),
    }
}

/// The length of an array.
pub fn length(program: &Program, rng: &mut Rng) -> Length {
    if !program.lengths.is_empty() && rng.chance(50) {
        let named = rng.below(program.lengths.len());
        return Length { count: program.lengths[named], named: Some(named) };
    }
    Length { count: rng.between(2, 4), named: None }
}

/// A value of a type.
fn tree(ty: &Type, program: &Program, rng: &mut Rng) -> Tree {
    match ty {
        Type::Scalar(scalar) => Tree::Leaf(constant::value(*scalar, &program.enums, rng)),
        Type::Array(element, length) => Tree::Array((0..length.count).map(|_| tree(element, program, rng)).collect()),
        Type::Struct(which) => {
            let fields = program.structs[*which].fields.iter();
            Tree::Struct(*which, fields.map(|(name, ty)| (name.clone(), tree(ty, program, rng))).collect())
        }
    }
}

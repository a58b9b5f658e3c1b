//! Values of portable Rust as their scalars.

use portable::{Literal, Portable, Real};

/// The scalar that a real is.
pub fn leaf<R: Real>(value: R) -> Literal {
    leaves(&value)[0]
}

/// The scalars of a value, in the order of its type.
pub fn leaves<T: Portable>(value: &T) -> Vec<Literal> {
    let mut leaves = Vec::new();
    value.visit(&mut |literal| leaves.push(literal));
    leaves
}

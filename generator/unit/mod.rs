//! Tests of the inside of this crate: of the design, of the certificates, and of numbers as text. No golden files.

mod certificate;
mod design;
mod number;
pub(crate) mod sets;

//! Tests of the inside of this crate: of the design, of the certificates, of numbers and names as text. No golden files.

mod certificate;
mod design;
mod number;
pub mod sets;
mod text;
mod twincat;

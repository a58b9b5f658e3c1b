//! Tests of the inside of this crate: of the design, and of the certificates. No golden files.

mod certificate;
mod design;
pub(crate) mod sets;

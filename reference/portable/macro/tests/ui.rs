//! Each construct outside the subset has a file in `ui` and the message that it gets beside it.
//!
//! `TRYBUILD=overwrite cargo test -p axgen-portable-macro --test ui` writes the messages anew.

use std::fs;
use std::path::Path;

#[test]
fn every_rejection_says_what_to_write() {
    trybuild::TestCases::new().compile_fail("tests/ui/*.rs");
}

//! Hostile and broken input through the real command, one test a row; `docs/hostile-input.md` is the list of them, and is
//! read here, so that it cannot say anything else than what happens.
//!
//! `UPDATE_EXPECT=1 cargo test -p axgen --test cli hostile` writes the document anew.

/// A row of the document, and a test: what the input is, and the making of it in a folder, which gives the arguments.
macro_rules! rows {
    ($($name:ident: $input:literal => $given:expr;)+) => {
        pub const ROWS: &[crate::hostile::row::Row] = &[$(crate::hostile::row::Row { input: $input, given: $given }),+];

        $(#[test]
        fn $name() {
            crate::hostile::row::check(&crate::hostile::row::Row { input: $input, given: $given });
        })+
    };
}

mod document;
mod encodings;
mod legal;
mod lists;
mod names;
mod paths;
mod row;
mod run;
mod sets;
mod sizes;
mod values;

/// All rows, in the order of the document.
fn rows() -> impl Iterator<Item = &'static row::Row> {
    let files =
        [sets::ROWS, values::ROWS, lists::ROWS, encodings::ROWS, sizes::ROWS, paths::ROWS, names::ROWS, legal::ROWS];
    files.into_iter().flatten()
}

//! Text inside a CDATA section: only the mark that ends it has to be taken apart.

use askama::filters::Escaper;
use std::fmt::{self, Write};

/// The escaper of TwinCAT's files.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cdata;

impl Escaper for Cdata {
    fn write_escaped_str<W: Write>(&self, mut to: W, text: &str) -> fmt::Result {
        let mut pieces = text.split("]]>");
        to.write_str(pieces.next().unwrap_or_default())?;
        pieces.try_for_each(|piece| {
            to.write_str("]]]]><![CDATA[>")?;
            to.write_str(piece)
        })
    }
}

//! The source in SCL in which `refused/changes/scl.txt` replaces something: it passes as it stands.

use crate::support::said;
use portable::RealKind;
use st::Dialect;

/// Everything that a source may have.
pub const SOURCE: &str = include_str!("forms/source.scl");

#[test]
fn the_source_without_a_mistake_passes() {
    let check = |text: &str| said(Dialect::Scl, text, "FB_x", RealKind::F64).join("; ");
    assert_eq!(check(SOURCE), "");
    let two = SOURCE.to_owned() + &SOURCE.replace("FB_x", "FB_y");
    assert_eq!(check(&two), "");
    assert_eq!(check(""), "1:1: found no block `FB_x`; write `FUNCTION_BLOCK FB_x`");
}

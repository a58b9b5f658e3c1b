//! What is refused: `texts/*.txt`, programs with all that is reported for them. No rule stands here.

use crate::support::said;
use std::path::Path;

#[test]
fn what_is_reported() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/nc/refused/texts");
    for file in folder.read_dir().expect("the texts") {
        let file = file.expect("a file");
        transcript::compare(file.path(), |_, text| said(text).join("\n"));
    }
}

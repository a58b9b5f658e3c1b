//! Where a message about what is missing points, and that its advice is in the language of its file.

use generator::codes::{CODES, explain};

#[test]
fn every_code_is_explained() {
    assert!(CODES.windows(2).all(|pair| pair[0].code < pair[1].code));
    assert_eq!(explain("ax206").unwrap().title, "a parameter is missing");
    assert!(explain("AX999").is_none());
    assert!(CODES.iter().all(|code| code.explanation.ends_with('.') && !code.title.ends_with('.')));
}

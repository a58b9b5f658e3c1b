//! Every listing that the manuals print, as their text has it, and the parameters of a spindle with their printed defaults: accepted as they
//! stand, or refused at the line with the reason.

use super::{assert_transcript, read};
use std::path::{Path, PathBuf};

fn listings() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/real_files/listings");
    let mut found: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    found.sort();
    found
}

#[test]
fn each_has_its_verdict() {
    let mut transcript = String::new();
    let mut accepted = 0;
    for path in listings() {
        let (set, report) = read(&[("x.lis", &std::fs::read(&path).unwrap())]);
        let verdict = if set.is_some() { "accepted" } else { "refused" };
        accepted += usize::from(set.is_some());
        transcript += &format!("== {}: {verdict}\n{report}\n", path.file_stem().unwrap().to_string_lossy());
    }
    assert_eq!((listings().len(), accepted), (23, 13));
    assert_transcript("listings.txt", &transcript);
}

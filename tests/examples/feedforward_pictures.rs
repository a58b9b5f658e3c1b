//! Draws the pictures of feedforward into `docs/pictures`; what they show is in `axgen_tests::pictures`.

use axgen_tests::pictures;
use std::path::Path;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/pictures");
    std::fs::create_dir_all(&folder)?;
    for (name, svg) in pictures::all() {
        std::fs::write(folder.join(name), svg)?;
    }
    Ok(())
}

//! Writes the JavaScript that calls a WebAssembly file, and the file without what it no longer needs: `bind FILE FOLDER`. With
//! the feature `small`, also that file compressed.

use std::error::Error;
use std::path::Path;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (file, folder) = (arguments.next().ok_or("which file?")?, arguments.next().ok_or("which folder?")?);
    let mut bindgen = Bindgen::new();
    bindgen.input_path(&file).no_modules(true)?.typescript(false);
    bindgen.remove_name_section(true).remove_producers_section(true);
    bindgen.generate(&folder)?;
    let name = Path::new(&file).file_stem().ok_or("a file without a name")?.to_string_lossy();
    compress(&Path::new(&folder).join(format!("{name}_bg.wasm")))
}

/// Writes the file as gzip next to it: slowly, for the smallest one.
#[cfg(feature = "small")]
fn compress(file: &Path) -> Result<(), Box<dyn Error>> {
    // More iterations save less than 0.1 %.
    let options =
        zopfli::Options { iteration_count: std::num::NonZeroU64::MIN.saturating_add(2), ..Default::default() };
    let into = std::fs::File::create(file.with_extension("wasm.gz"))?;
    Ok(zopfli::compress(options, zopfli::Format::Gzip, std::fs::File::open(file)?, into)?)
}

#[cfg(not(feature = "small"))]
fn compress(_: &Path) -> Result<(), Box<dyn Error>> {
    Ok(())
}

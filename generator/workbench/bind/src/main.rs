//! Writes the JavaScript that calls a WebAssembly file, and the file without what it no longer needs: `bind FILE FOLDER`.

use std::error::Error;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (file, folder) = (arguments.next().ok_or("which file?")?, arguments.next().ok_or("which folder?")?);
    Ok(Bindgen::new().input_path(file).no_modules(true)?.typescript(false).generate(folder)?)
}

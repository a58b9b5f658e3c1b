//! The crate that all generated programs depend on: the compiler, the generator's printers, file by file, and what compares
//! them. It is the generator without its front end, whose dependencies take a minute to build.

use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What is left out of the folders for targets: what fills templates.
const TEMPLATES: [&str; 7] = ["mod.rs", "file.rs", "outline.rs", "block.rs", "plain.rs", "codesys.rs", "scl.rs"];

/// The crate's only file. It stands for both the generator and this package.
///
/// # Errors
/// The generator's files cannot be listed.
pub fn source(root: &Path) -> io::Result<String> {
    let (generator, random) = (root.join("generator/src"), root.join("tests/src/random"));
    let target = generator.join("target");
    Ok(format!(
        "#![allow(warnings)]\n\nextern crate self as generator;\n\npub mod target {{\n{}\n    pub mod c {{\n{}    }}\n    pub mod st {{\n{}    }}\n}}\n\n\
         pub mod random {{\n{}}}\n",
        modules("    ", files(&target)?),
        modules("        ", files(&target.join("c"))?),
        modules("        ", files(&target.join("st"))?),
        modules("    ", ["rng", "inside"].map(|name| file(&random, name))),
    ))
}

/// The file of a module, in a folder of its own or not.
fn file(folder: &Path, name: &str) -> PathBuf {
    let inner = folder.join(name).join("mod.rs");
    if inner.exists() { inner } else { folder.join(name).with_extension("rs") }
}

/// The modules of a folder that need no template, in the order of their names.
fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let paths: io::Result<Vec<PathBuf>> = fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.path())).collect();
    let is_module = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default();
        path.is_file() && TEMPLATES.iter().all(|template| name != *template)
    };
    let mut modules: Vec<PathBuf> = paths?.into_iter().filter(is_module).collect();
    modules.sort();
    Ok(modules)
}

fn modules(indent: &str, files: impl IntoIterator<Item = PathBuf>) -> String {
    files.into_iter().fold(String::new(), |mut text, file| {
        let stem = if file.ends_with("mod.rs") { file.parent() } else { Some(file.as_path()) };
        let name = stem.and_then(Path::file_stem).unwrap_or_default().display();
        let _ = writeln!(text, "{indent}#[path = {:?}]\n{indent}pub mod {name};", file.display().to_string());
        text
    })
}

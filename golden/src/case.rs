//! Golden cases: a folder with an axis set, a stimulus, and the answers that were recorded.
//!
//! ```text
//! case.toml      purpose, axis, block, stimulus
//! set.toml       the axis set (or what case.toml names)
//! vectors.csv    the first 2,000 samples of inputs and outputs, as bits
//! digest         128-bit digests of inputs and outputs of 1,000,000 samples
//! emitted/       the files that the axis gets
//! ```

use crate::csv::{self, Reals};
use crate::engine::{self, Engine};
use crate::samples::{Samples, Shape};
use crate::stimulus::{self, Stimulus};
use generator::axis::Axis;
use generator::block::{self, Block};
use generator::config::{self, ListOptions};
use generator::digest::digest;
use generator::target::{File, TARGETS};
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// Samples that stand in `vectors.csv`.
pub const VECTOR_SAMPLES: usize = 2_000;
/// Samples that the digests cover.
pub const DIGEST_SAMPLES: usize = 1_000_000;

/// A case, read.
#[derive(Clone, Debug)]
pub struct Case {
    /// its folder
    pub folder: PathBuf,
    /// what it is there for
    pub purpose: String,
    /// the axis
    pub axis: Axis,
    /// the block
    pub block: Block,
    /// what its inputs do
    pub stimulus: Stimulus,
}

/// `case.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Description {
    purpose: String,
    #[serde(default = "set_beside")]
    set: String,
    cycle_time: Option<String>,
    axis: String,
    block: String,
    stimulus: Stimulus,
}

fn set_beside() -> String {
    "set.toml".to_owned()
}

/// Reads a case.
///
/// # Errors
/// What is wrong with its files, in words.
pub fn read(folder: &Path) -> Result<Case, String> {
    let path = folder.join("case.toml");
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let description: Description = toml::from_str(&text).map_err(|error| format!("{}: {error}", path.display()))?;
    let options = ListOptions { cycle_time: description.cycle_time, name: None };
    let (set, report) = config::read(&folder.join(&description.set), &options);
    let set = set.ok_or_else(|| report.to_string())?;
    let axis = set.axes.into_iter().find(|axis| axis.name == description.axis);
    let axis = axis.ok_or_else(|| format!("{}: no axis `{}`", path.display(), description.axis))?;
    Ok(Case {
        folder: folder.to_owned(),
        purpose: description.purpose,
        block: named_block(&axis, &description.block)?,
        axis,
        stimulus: description.stimulus,
    })
}

/// The block of an axis by its name.
///
/// # Errors
/// The axis has none of that name; the text lists those it has.
pub fn named_block(axis: &Axis, name: &str) -> Result<Block, String> {
    let blocks = block::blocks(axis).map_err(|defect| defect.to_string())?;
    let names: Vec<&str> = blocks.iter().map(|block| block.program.block).collect();
    let position = names.iter().position(|known| *known == name);
    let position = position.ok_or_else(|| format!("no block `{name}`; this axis has: {}", names.join(", ")))?;
    Ok(blocks[position].clone())
}

/// The inputs of a case.
///
/// # Errors
/// The stimulus does not fit the block.
pub fn inputs(case: &Case, count: usize) -> Result<Samples, String> {
    let shape = Shape::of(&case.block.program.inputs, case.axis.real);
    stimulus::samples(&case.stimulus, &shape, count)
        .map_err(|mistake| format!("{}: {mistake}", case.folder.join("case.toml").display()))
}

/// What a case's folder has to hold, as the reference answers now.
///
/// # Errors
/// The stimulus does not fit the block.
pub fn recorded(case: &Case) -> Result<Vec<File>, String> {
    let inputs = inputs(case, DIGEST_SAMPLES)?;
    let outputs = engine::run(Engine::Reference, &case.axis, &case.block, &inputs).map_err(|failure| failure.to_string())?;
    let vectors = csv::write(&[&inputs.first(VECTOR_SAMPLES), &outputs.first(VECTOR_SAMPLES)], Reals::Hexadecimal);
    let digests = format!(
        "samples {DIGEST_SAMPLES}\ninputs {}\noutputs {}\n",
        digest(&inputs.bytes),
        digest(&outputs.bytes)
    );
    let mut files = vec![
        File { name: "vectors.csv".to_owned(), text: vectors },
        File { name: "digest".to_owned(), text: digests },
    ];
    let blocks = std::slice::from_ref(&case.block);
    let emitted = TARGETS.iter().flat_map(|target| (target.files)(&case.axis, blocks));
    files.extend(emitted.map(|file| File { name: format!("emitted/{}", file.name), text: file.text }));
    Ok(files)
}

/// Writes what [`recorded`] gives.
///
/// # Errors
/// The stimulus does not fit, or the folder does not take the files.
pub fn record(case: &Case) -> Result<(), String> {
    let emitted = case.folder.join("emitted");
    std::fs::create_dir_all(&emitted).map_err(|error| format!("{}: {error}", emitted.display()))?;
    for file in recorded(case)? {
        let path = case.folder.join(&file.name);
        std::fs::write(&path, file.text).map_err(|error| format!("{}: {error}", path.display()))?;
    }
    Ok(())
}

/// Compares the folder with what [`recorded`] gives; names every file that differs.
///
/// # Errors
/// The stimulus does not fit the block.
pub fn verify(case: &Case) -> Result<Vec<String>, String> {
    let mut differing = Vec::new();
    for file in recorded(case)? {
        let found = std::fs::read(case.folder.join(&file.name));
        if found.ok().as_deref() != Some(file.text.as_bytes()) {
            differing.push(file.name);
        }
    }
    Ok(differing)
}

/// The folders of all cases below a folder, in the order of their names.
///
/// # Errors
/// The folder cannot be read.
pub fn folders(below: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut folders = Vec::new();
    for entry in std::fs::read_dir(below)? {
        let path = entry?.path();
        if path.join("case.toml").is_file() {
            folders.push(path);
        }
    }
    folders.sort();
    Ok(folders)
}

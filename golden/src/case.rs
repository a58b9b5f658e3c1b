//! Golden cases: a folder with an axis set, a stimulus or a scenario, and the recorded answers.
//!
//! ```text
//! case.toml      purpose, axis, block, stimulus, required constructs and events
//! set.toml       the axis set (or another file named in case.toml)
//! inputs.csv     the first 200 samples as bits, without inputs that keep their start value; all samples of a scenario
//! outputs.csv    the answers
//! digest         128-bit digests of inputs and outputs of 1,000,000 samples, or of all samples of a scenario
//! emitted/       the files of the block, except its self-tests
//! ```
//!
//! `axgen run set.toml --axis X --stimulus inputs.csv --hex` prints outputs.csv, with every engine. For a scenario without
//! `--hex`: its numbers are short decimals. `source` has the source of the inputs.

use crate::csv::{self, Reals, cell};
use crate::engine::{self, Engine};
use crate::samples::{Samples, Shape};
use crate::shows::shown;
use crate::source::{self, Source};
use crate::stimulus::{self, Event, Stimulus, Window};
use compiler::program::Variable;
use generator::blocks::Designed;
use generator::blocks::{self, Block};
use generator::config::{self, ListOptions};
use generator::diagnostics::Slashes;
use generator::digest::digest;
use generator::generate::identity;
use generator::pipeline;
use generator::target::{File, TARGETS, Target};
use generator::write;
use serde::Deserialize;
use std::path::{Path, PathBuf};

/// Samples of a stimulus that must contain the constructs and events of the case.
pub const VECTOR_SAMPLES: usize = 2_000;
/// Samples of a stimulus in `inputs.csv` and `outputs.csv`.
pub const KEPT_SAMPLES: usize = 200;
/// Samples covered by the digests.
pub const DIGEST_SAMPLES: usize = 1_000_000;

/// The folder of the emitted files.
const EMITTED: &str = "emitted";

/// A case as read from its folder.
#[derive(Clone, Debug)]
pub struct Case {
    pub folder: PathBuf,
    pub purpose: String,
    /// constructs and events that the axis or the recorded samples must contain, in the words of [`shown`]
    pub shows: Vec<String>,
    pub axis: Designed,
    pub block: Block,
    /// the source of its inputs
    pub source: Source,
    /// the targets whose files it keeps; `None` for all
    pub emitted: Option<Vec<String>>,
}

/// `case.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Description {
    purpose: String,
    #[serde(default)]
    shows: Vec<String>,
    #[serde(default = "set_of_the_folder")]
    set: String,
    cycle_time: Option<String>,
    axis: String,
    block: String,
    stimulus: Option<Stimulus>,
    #[serde(default)]
    offer: Vec<Offer>,
    scenario: Option<PathBuf>,
    emitted: Option<Vec<String>>,
}

/// An offered parameter set: that of the same axis in another file. The events of the stimulus override it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Offer {
    set: String,
    window: Window,
}

fn set_of_the_folder() -> String {
    "set.toml".to_owned()
}

/// Reads only the axis of a case.
///
/// # Errors
/// The errors in its files, in words.
pub fn axis(folder: &Path) -> Result<Designed, String> {
    let description = described(folder)?;
    axis_of(folder, &description, &description.set)
}

fn described(folder: &Path) -> Result<Description, String> {
    let path = folder.join("case.toml");
    toml::from_str(&source::text(&path)?).map_err(|error| format!("{}: {error}", path.slashes()))
}

/// The axis of a case, from that file.
fn axis_of(folder: &Path, description: &Description, file: &str) -> Result<Designed, String> {
    let options = ListOptions { cycle_time: description.cycle_time.clone(), ..ListOptions::default() };
    let (set, report) = pipeline::read(&folder.join(file), &options);
    let set = set.ok_or_else(|| report.to_string())?;
    let axis = set.axes.into_iter().find(|of| of.axis.name == description.axis);
    axis.ok_or_else(|| format!("{}: no axis `{}`", folder.join("case.toml").slashes(), description.axis))
}

/// Reads a case.
///
/// # Errors
/// The errors in its files, in words.
pub fn read(folder: &Path) -> Result<Case, String> {
    let path = folder.join("case.toml");
    let mut description = described(folder)?;
    let axis = axis_of(folder, &description, &description.set)?;
    let source = match (description.stimulus.take(), description.scenario.take()) {
        (Some(mut stimulus), None) => {
            for (place, Offer { set, window }) in description.offer.iter().enumerate() {
                let events = offered(&named_block(&axis_of(folder, &description, set)?, &description.block)?, *window);
                let first = place * events.len();
                stimulus.event.splice(first..first, events);
            }
            Source::Stimulus(stimulus)
        }
        (None, Some(program)) => Source::Scenario(folder.join(program)),
        _ => return Err(format!("{}: either `stimulus` or `scenario` is needed", path.slashes())),
    };
    let names = TARGETS.map(|target| target.name);
    if let Some(unknown) = description.emitted.iter().flatten().find(|name| !names.contains(&name.as_str())) {
        return Err(format!("{}: no target `{unknown}`; there are: {}", path.slashes(), names.join(", ")));
    }
    Ok(Case {
        folder: folder.to_owned(),
        purpose: description.purpose,
        shows: description.shows,
        block: named_block(&axis, &description.block)?,
        axis,
        source,
        emitted: description.emitted,
    })
}

/// The events that offer the parameter set with which a block is generated.
pub(crate) fn offered(block: &Block, window: Window) -> Vec<Event> {
    let parts = block.program.inputs.iter().filter(|input| block.program.in_set(input).is_some());
    let event = |input: &Variable| {
        let mut value = String::new();
        cell(input.start, Reals::Decimal, &mut value);
        Event { signal: input.path.clone(), value, window }
    };
    parts.map(event).collect()
}

/// The block of an axis by its name.
///
/// # Errors
/// The axis has no block of that name; the text lists its blocks.
pub fn named_block(designed: &Designed, name: &str) -> Result<Block, String> {
    let unknown = || format!("no block `{name}`; this axis has: {}", blocks::names(&designed.axis).join(", "));
    let kind = blocks::of_axis(&designed.axis).find(|kind| kind.name() == name).ok_or_else(unknown)?;
    kind.block(designed).map_err(|defect| defect.to_string())
}

/// The inputs of a case, at most this number of samples.
///
/// # Errors
/// The stimulus does not fit the block, or the inputs of the scenario are not recorded.
pub fn inputs(case: &Case, count: usize) -> Result<Samples, String> {
    let shape = Shape::of(&case.block.program.inputs, case.block.program.real);
    match &case.source {
        Source::Stimulus(stimulus) => stimulus::samples(stimulus, &shape, count)
            .map_err(|mistake| format!("{}: {mistake}", case.folder.join("case.toml").slashes())),
        Source::Scenario(_) => Ok(source::recorded(&case.folder, &shape)?.first(count)),
    }
}

/// The inputs that must contain the events of the case: for a scenario all inputs, from `inputs.csv`.
///
/// # Errors
/// As [`inputs`].
pub fn vectors(case: &Case) -> Result<Samples, String> {
    match case.source {
        Source::Stimulus(_) => inputs(case, VECTOR_SAMPLES),
        Source::Scenario(_) => inputs(case, usize::MAX),
    }
}

/// A run of a case and what it must leave in the case's folder.
struct CaseFiles {
    files: Vec<File>,
    /// constructs and events that the case requires and does not contain
    missing: Vec<String>,
}

/// What the reference and the targets give now.
fn case_files(case: &Case, inputs: &Samples) -> Result<CaseFiles, String> {
    let outputs =
        engine::run(Engine::Reference, &case.axis, &case.block, inputs).map_err(|failure| failure.to_string())?;
    let (count, kept, reals) = match case.source {
        Source::Stimulus(_) => (VECTOR_SAMPLES, KEPT_SAMPLES, Reals::Hexadecimal),
        Source::Scenario(_) => (inputs.len(), inputs.len(), Reals::Decimal),
    };
    let shown = shown(&case.axis.axis, &inputs.first(count), &outputs.first(count));
    let (first, answers) = (inputs.first(kept), outputs.first(kept));
    let mut digests =
        format!("samples {}\ninputs {}\noutputs {}\n", inputs.len(), digest(&inputs.bytes), digest(&outputs.bytes));
    if let Source::Scenario(program) = &case.source {
        digests += &source::program_line(program)?;
    }
    let texts = [
        (source::INPUTS, csv::write(&[&first.without_constant()], reals)),
        ("outputs.csv", csv::write(&[&answers.only(&case.block.recorded_outputs())], reals)),
        (source::DIGEST, digests),
    ];
    let is_kept =
        |target: &&Target| case.emitted.as_ref().is_none_or(|kept| kept.iter().any(|name| name == target.name));
    let mut emitted = Vec::new();
    for target in TARGETS.iter().filter(is_kept) {
        let files = target.files(&identity(&case.axis.axis, &case.block), &case.block);
        emitted.extend(files.map_err(|defect| defect.to_string())?);
    }
    // Self-tests are derived from the blocks and run by tests; without them the folder stays small.
    emitted.retain(|file: &File| !file.name.contains("_self_test."));
    let emitted = emitted.into_iter().map(|file| File { name: format!("{EMITTED}/{}", file.name), text: file.text });
    let texts = texts.into_iter().map(|(name, text)| File { name: name.to_owned(), text });
    Ok(CaseFiles {
        files: texts.chain(emitted).collect(),
        missing: case.shows.iter().filter(|word| !shown.contains(*word)).cloned().collect(),
    })
}

/// The inputs that the scenario of a case generates now, if none are recorded yet, or with `again`; otherwise the recorded
/// ones are kept. `None` for a stimulus.
///
/// # Errors
/// The program cannot be run, or differs from that of the recorded inputs.
pub fn scenario_inputs(case: &Case, again: bool) -> Result<Option<Samples>, String> {
    match &case.source {
        Source::Scenario(program) => source::made(program, &case.folder, &case.axis, &case.block, again),
        Source::Stimulus(_) => Ok(None),
    }
}

/// The files to keep: the reference's answers, the emitted files, and the inputs of a stimulus or those in `made`.
///
/// # Errors
/// The stimulus does not fit, or a required construct or event is missing.
pub fn recorded(case: &Case, made: Option<Samples>) -> Result<Vec<File>, String> {
    let keeps_inputs = made.is_none() && matches!(case.source, Source::Scenario(_));
    let inputs = made.map_or_else(|| inputs(case, DIGEST_SAMPLES), Ok)?;
    let CaseFiles { mut files, missing } = case_files(case, &inputs)?;
    files.retain(|file| !(keeps_inputs && file.name == source::INPUTS));
    if missing.is_empty() {
        Ok(files)
    } else {
        Err(format!("{}: the case does not show {}", case.folder.slashes(), missing.join(", ")))
    }
}

/// Writes the files to keep. Other files in the folder of emitted files are removed.
///
/// # Errors
/// The folder does not accept the files.
pub fn keep(case: &Case, files: &[File]) -> Result<(), String> {
    let refused = |refusal: write::Refusal| {
        let said = refusal.report().diagnostics.into_iter().map(|of| format!("{}: {}", of.place.file, of.found));
        said.collect::<Vec<_>>().join("\n")
    };
    let folder = write::open(&case.folder).map_err(refused)?;
    let staged = files.iter().map(|file| write::stage(&folder, file)).collect();
    write::commit(folder, staged, true).map_err(refused)?;
    for path in left_over(case, files) {
        std::fs::remove_file(&path).map_err(|error| format!("{}: {error}", path.slashes()))?;
    }
    Ok(())
}

/// Compares the folder with the present results of the reference and the targets; returns every difference.
///
/// # Errors
/// As [`inputs`].
pub fn verify(case: &Case) -> Result<Vec<String>, String> {
    differing(case, DIGEST_SAMPLES)
}

/// Compares all files of the folder that depend only on the first samples: everything except the digest of a stimulus, which
/// covers a million.
///
/// # Errors
/// As [`inputs`].
pub fn verify_first(case: &Case) -> Result<Vec<String>, String> {
    differing(case, VECTOR_SAMPLES)
}

fn differing(case: &Case, count: usize) -> Result<Vec<String>, String> {
    let is_stimulus = matches!(case.source, Source::Stimulus(_));
    let inputs = inputs(case, if is_stimulus { count } else { usize::MAX })?;
    let CaseFiles { mut files, missing } = case_files(case, &inputs)?;
    let left_over = left_over(case, &files);
    files.retain(|file| file.name != source::DIGEST || !is_stimulus || count == DIGEST_SAMPLES);
    let mut differing: Vec<String> = missing.iter().map(|word| format!("shows: {word}")).collect();
    if let Source::Scenario(program) = &case.source {
        differing.extend(source::same_program(program, &case.folder).err());
    }
    for file in &files {
        let found = config::load(&case.folder.join(&file.name));
        if found.ok().as_deref() != Some(file.text.as_bytes()) {
            differing.push(file.name.clone());
        }
    }
    differing.extend(left_over.iter().map(|path| format!("{} (no such file is emitted)", path.slashes())));
    Ok(differing)
}

/// Emitted files that are no longer generated, in the order of their names.
fn left_over(case: &Case, files: &[File]) -> Vec<PathBuf> {
    let mut paths = files_below(&case.folder.join(EMITTED));
    paths.retain(|path| !files.iter().any(|file| case.folder.join(&file.name) == *path));
    paths.sort();
    paths
}

/// All files of a folder and of its subfolders.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    entries.flat_map(|path| if path.is_dir() { files_below(&path) } else { vec![path] }).collect()
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

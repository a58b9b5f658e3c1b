//! Writes single requested files, or standard output, but never over an input. Of contents, only the first bytes of a picture
//! are known here.

use crate::exit::Exit;
use crate::output;
use generator::diagnostics::{Diagnostic, Place, Slashes};
use generator::write::{self, One, Replace};
use generator::{codes, config};
use golden::svg;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

/// The existing files that a command replaces, and its message about the others.
#[derive(Clone, Copy)]
pub struct Rule<'r> {
    replace: Replace<'r>,
    found: &'static str,
}

impl<'r> Rule<'r> {
    /// No existing file.
    pub const NEVER: Self = Self { replace: Replace::None, found: "is there already; give another name" };

    /// Any existing file, with `force`.
    pub fn by_force(force: bool) -> Self {
        let replace = if force { Replace::All } else { Replace::None };
        Self { replace, found: "is there already; give another name, or --force to replace it" }
    }

    /// Empty files, and files that begin like an output of the same command, which is often run again; others with `force`.
    pub fn earlier_output(force: bool, begins: &'r dyn Fn(&[u8]) -> bool) -> Self {
        Self {
            replace: if force { Replace::All } else { Replace::Those(begins) },
            found: "is not an earlier output of this command; give another name, or --force to replace it",
        }
    }

    /// The same for a picture.
    pub fn earlier_picture(force: bool) -> Self {
        Self::earlier_output(force, &|found: &[u8]| found.starts_with(svg::HEAD.as_bytes()))
    }

    /// Reports beforehand that a file would not be replaced, so that no long run is wasted.
    pub fn allows(self, path: &Path) -> Result<(), Exit> {
        write::is_replaced(path, self.replace).map(|_| ()).map_err(|error| self.failed(path, &error))
    }

    fn failed(self, path: &Path, error: &io::Error) -> Exit {
        match error.kind() {
            ErrorKind::AlreadyExists => Exit::input(codes::NOT_OURS, path.slashes(), self.found),
            _ => Exit::unwritable(path.slashes(), format!("{error}; nothing was written")),
        }
    }
}

/// Writes to the file; without one, or to `-`, to standard output.
pub fn write(out: Option<&Path>, bytes: &[u8], rule: Rule<'_>) -> Result<(), Exit> {
    match out.filter(|path| path.as_os_str() != "-") {
        Some(path) => commit([stage(path, bytes, rule)?]),
        None => output::print(bytes),
    }
}

/// Writes a file next to its target; it is removed together with the returned value.
pub fn stage<'p>(path: &'p Path, bytes: &[u8], rule: Rule<'p>) -> Result<Staged<'p>, Exit> {
    let one = write::stage_one(path, bytes, rule.replace).map_err(|error| rule.failed(path, &error))?;
    Ok(Staged { path, one, rule })
}

/// A staged file.
pub struct Staged<'p> {
    path: &'p Path,
    one: One,
    rule: Rule<'p>,
}

/// Moves staged files to their targets.
pub fn commit<'p>(files: impl IntoIterator<Item = Staged<'p>>) -> Result<(), Exit> {
    let mut files = files.into_iter();
    files.try_for_each(|Staged { path, one, rule }| one.commit().map_err(|error| rule.failed(path, &error)))
}

/// Refuses outputs that would replace an input, each other, or a file of the user, before anything runs.
pub fn allowed<'p>(
    outs: impl IntoIterator<Item = (Option<&'p Path>, Rule<'p>)>,
    inputs: impl IntoIterator<Item = &'p Path> + Clone,
) -> Result<(), Exit> {
    let asked: Vec<_> = outs.into_iter().filter_map(|(out, rule)| Some((out?, rule))).collect();
    told_apart(&asked.iter().map(|(out, _)| *out).collect::<Vec<_>>())?;
    asked.into_iter().try_for_each(|(out, rule)| {
        kept_apart(out, inputs.clone())?;
        rule.allows(out)
    })
}

/// Refuses a name with which the next command would read a set as a list, or a list as a set. A device has any name.
pub fn named(out: Option<&Path>, is_set: bool) -> Result<(), Exit> {
    let is_other =
        |out: &&Path| out.as_os_str() != "-" && config::is_set(out) != is_set && (out.is_file() || !out.exists());
    let Some(out) = out.filter(is_other) else { return Ok(()) };
    let (found, instead) = match is_set {
        true => ("a set with this name would be read as an axis list", "a name that ends with .toml"),
        false => ("an axis list with this name would be read as a set", "a name with another extension, such as x.lis"),
    };
    let said = Diagnostic::error(codes::USAGE, Place::whole(out.slashes()), format!("{found}; nothing was written"));
    Err(Exit::Input(said.instead(instead).into()))
}

/// Refuses an output file that is an input of the command.
pub fn kept_apart<'p>(
    out: impl Into<Option<&'p Path>>,
    inputs: impl IntoIterator<Item = &'p Path>,
) -> Result<(), Exit> {
    match out.into().filter(|out| inputs.into_iter().any(|input| is_same(input, out))) {
        Some(out) => Err(Exit::input(codes::NOT_OURS, out.slashes(), "is an input of this run; give another name")),
        None => Ok(()),
    }
}

/// Refuses two outputs of one command in one file, which may not exist yet.
pub fn told_apart(outs: &[&Path]) -> Result<(), Exit> {
    let place = |path: &Path| match (path.parent(), path.file_name()) {
        (Some(folder), Some(name)) => {
            let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
            fs::canonicalize(folder).unwrap_or_else(|_| folder.to_owned()).join(name)
        }
        _ => path.to_owned(),
    };
    let is_one = |(one, other): (&&Path, &&Path)| is_same(one, other) || place(one) == place(other);
    let mut pairs = outs.iter().enumerate().flat_map(|(n, one)| outs[n + 1..].iter().map(move |other| (one, other)));
    match pairs.find(|pair| is_one(*pair)) {
        Some((_, other)) => {
            Err(Exit::input(codes::NOT_OURS, other.slashes(), "is to take two outputs of this run; give two names"))
        }
        None => Ok(()),
    }
}

/// Whether two paths lead to the same regular file, also by different names. Devices may be used twice.
fn is_same(one: &Path, other: &Path) -> bool {
    let (Ok(one), Ok(other)) = (fs::canonicalize(one), fs::canonicalize(other)) else { return false };
    let (Ok(found), Ok(of_other)) = (fs::metadata(&one), fs::metadata(&other)) else { return false };
    found.is_file() && (one == other || has_one_content(&found, &of_other))
}

#[cfg(unix)]
fn has_one_content(one: &fs::Metadata, other: &fs::Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    (one.dev(), one.ino()) == (other.dev(), other.ino())
}

#[cfg(not(unix))]
fn has_one_content(_: &fs::Metadata, _: &fs::Metadata) -> bool {
    false
}

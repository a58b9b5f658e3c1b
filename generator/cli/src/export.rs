//! `axgen export`: an axis of a set as an axis list.

use crate::arguments::OneFile;
use crate::exit::Exit;
use crate::input::said;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use generator::{config, import_export};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Runs the command. The axis is optional if the set has only one.
pub fn run(set: &Path, axis: Option<&str>, to: &OneFile, format: Format) -> Result<Exit, Exit> {
    let read = Mutex::new(vec![set.to_owned()]);
    let load = |path: &Path| {
        read.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
        config::load(path)
    };
    let (list, report) = import_export::export(set, axis, &load);
    let list = said(list, &report, format)?;
    let read = read.into_inner().unwrap_or_else(PoisonError::into_inner);
    let out = to.out.as_deref();
    one_file::kept_apart(out, read.iter().map(PathBuf::as_path))?;
    one_file::named(out, false)?;
    one_file::write(out, &list, Rule::by_force(to.force))?;
    Ok(Exit::Done)
}

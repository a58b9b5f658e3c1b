//! `axgen params-of`: the parameter set of an axis for the block that is on the machine.

use crate::arguments::{AxisArguments, ParamsOfArguments};
use crate::diff;
use crate::exit::Exit;
use crate::input::said;
use crate::messages::Format;
use crate::one_file::{self, Rule};
use commands::refused;
use commands::words::made;
use generator::codes;
use generator::config;
use generator::diagnostics::{Diagnostic, Place, Slashes};
use generator::params_of::{self, Form};

/// Runs the command.
pub fn run(of: &ParamsOfArguments, format: Format) -> Result<Exit, Exit> {
    let ParamsOfArguments { subject: AxisArguments { set: arguments, axis }, on, form, to } = of;
    let form =
        Form::named(form).ok_or_else(|| refused::no_such("--as", "form", form, &Form::ALL.map(|(name, _)| name)))?;
    one_file::kept_apart(to.out.as_deref(), [arguments.set.as_path(), on.as_path()])?;
    let options = arguments.list.options(Vec::new());
    let versions = commands::diff::read_for_set([on, &arguments.set], &options, &config::load);
    let (before, after) = diff::both(versions, format)?;
    let new = commands::axis(&after, axis.as_deref())?;
    let old = before.axes.iter().find(|of| of.axis.name == new.axis.name).ok_or_else(|| {
        let names: Vec<&str> = before.axes.iter().map(|of| of.axis.name.as_str()).collect();
        let missing = Diagnostic::error(
            codes::NO_SUCH,
            Place::whole(on.slashes()),
            format!("no axis `{}`", new.axis.name.escape_default()),
        );
        Exit::Input(missing.allowed(names.join(", ")).into())
    })?;
    let report = params_of::check(new, old, [&arguments.set.slashes(), &on.slashes()]);
    said((!report.has_errors()).then_some(()), &report, format)?;
    let bytes = made(params_of::bytes(new, form));
    one_file::write(to.out.as_deref(), &bytes, Rule::by_force(to.force))?;
    Ok(Exit::Done)
}

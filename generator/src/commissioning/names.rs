//! The names of blocks and signals on the page, as its targets have them. No numbers.

use crate::axis::Axis;
use crate::blocks;
use crate::parameters::words::{TargetName, Words};
use crate::target::Target;

/// Names in backquotes. Where the targets differ, each name is followed by the targets that have it.
pub(super) struct Names {
    pub(super) block: String,
    pub(super) ipc: String,
    pub(super) self_test: String,
    pub(super) fault: String,
    pub(super) error_id: String,
    /// the output with the id of a notice
    pub(super) notice: String,
    /// the output with the id of a refused parameter set
    pub(super) refusal: String,
    /// the option that writes a parameter set for the target
    pub(super) set_form: String,
    /// the targets whose blocks have `Enable`; may be empty
    pub(super) enabled: String,
    /// whether all targets have it
    pub(super) are_enabled: bool,
    /// whether some targets have a function as self-test, some a function block
    pub(super) has_function: bool,
    pub(super) has_function_block: bool,
    pub(super) is_twincat: bool,
    /// a position controller that may replace the block; may be empty
    pub(super) other_controllers: String,
}

impl Names {
    /// The names for the block to call, `kind`.
    pub(super) fn new(axis: &Axis, kind: &str, targets: &[Target]) -> Self {
        let blocks = |target: &Target, kind: &str| target.called(&axis.name, kind, axis.short_names);
        let called = |name: &dyn Fn(&Target) -> String| called(targets, name);
        let enabled: Vec<&str> =
            targets.iter().filter(|target| target.has_enable()).map(|target| target.name).collect();
        let others = targets.iter().filter_map(|target| other_controller(target.name));
        Self {
            block: called(&|target| blocks(target, kind)[0].clone()),
            ipc: called(&|target| blocks(target, blocks::IPC)[0].clone()),
            self_test: called(&|target| blocks(target, kind)[1].clone()),
            fault: called(&|target| target.output("fault").to_owned()),
            error_id: called(&|target| target.output("error_id").to_owned()),
            notice: called(&|target| target.notice().to_owned()),
            refusal: called(&|target| match target.has_enable() {
                true => format!("{}` or `{}", target.output("error_id"), target.notice()),
                false => target.notice().to_owned(),
            }),
            set_form: called(&|target| format!("--as {}", set_form(target.name))),
            are_enabled: enabled.len() == targets.len(),
            enabled: enabled.join(", "),
            has_function: targets.iter().any(Target::tests_by_function),
            has_function_block: !targets.iter().all(Target::tests_by_function),
            is_twincat: targets.iter().any(|target| target.name == "twincat"),
            other_controllers: others.collect::<Vec<_>>().join(" or "),
        }
    }
}

/// A name in each of the targets.
fn called(targets: &[Target], name: &dyn Fn(&Target) -> String) -> String {
    let mut names: Vec<(String, Vec<&str>)> = Vec::new();
    for target in targets {
        let name = name(target);
        match names.iter_mut().find(|(known, _)| *known == name) {
            Some((_, of)) => of.push(target.name),
            None => names.push((name, vec![target.name])),
        }
    }
    match names.as_slice() {
        [(name, _)] => format!("`{name}`"),
        _ => {
            let each = names.iter().map(|(name, of)| format!("`{name}` ({})", of.join(", ")));
            each.collect::<Vec<_>>().join(", ")
        }
    }
}

/// The usual position controller on a target whose programs often contain none.
fn other_controller(target: &str) -> Option<&'static str> {
    match target {
        "twincat" => Some("TwinCAT NC"),
        "codesys" => Some("SoftMotion"),
        "scl" => Some("a technology object"),
        _ => None,
    }
}

/// The form in which `axgen params-of` writes a set for a target.
fn set_form(target: &str) -> &'static str {
    match TargetName::named(target).expect("commissioning: a target is a word of its parameter") {
        TargetName::C => "c",
        TargetName::Rust => "rust",
        TargetName::St | TargetName::TwinCat | TargetName::Codesys => "st",
        TargetName::Scl => "scl",
    }
}

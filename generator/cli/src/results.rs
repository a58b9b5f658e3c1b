//! Results of checks as files for other programs: JUnit for a release pipeline, JSON for everything else.

use crate::exit::Exit;
use crate::one_file::{self, Rule};
use clap::Args;
use serde_json::json;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Where results go, next to what is printed.
#[derive(Args, Clone, Debug, Default)]
pub struct Files {
    /// Writes the results as JUnit XML too
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Writes the results as JSON too
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Replace any file of these names, not only earlier results
    #[arg(long)]
    force: bool,
}

/// The result of one check.
pub struct Outcome {
    /// the checked axis or case
    pub group: String,
    /// the checked block and engine
    pub name: String,
    /// the reason of the failure; `None` if it passed
    pub failure: Option<String>,
}

/// Writes outcomes in a form for programs.
type Form = fn(&str, &[Outcome]) -> String;

/// Whether a file begins like one in such a form.
type Begins = &'static dyn Fn(&[u8]) -> bool;

impl Files {
    /// The requested files, each with its form and the beginning of such a file.
    fn forms(&self) -> impl Iterator<Item = (&Path, Form, Rule<'static>)> {
        let forms: [(_, Form, Begins); 2] =
            [(&self.junit, junit, &|found| found.starts_with(JUNIT.as_bytes())), (&self.json, as_json, &is_json)];
        forms
            .into_iter()
            .filter_map(|(path, form, begins)| Some((path.as_deref()?, form, Rule::earlier_output(self.force, begins))))
    }

    /// Refuses to write over an input of the command, or over a file that is not one of its results.
    pub fn kept_apart(&self, input: Option<&Path>) -> Result<(), Exit> {
        one_file::allowed(self.forms().map(|(file, _, rule)| (Some(file), rule)), input)
    }

    /// Writes the requested files, after all of them are staged.
    pub fn write(&self, suite: &str, outcomes: &[Outcome]) -> Result<(), Exit> {
        let staged =
            self.forms().map(|(file, form, rule)| one_file::stage(file, form(suite, outcomes).as_bytes(), rule));
        one_file::commit(staged.collect::<Result<Vec<_>, Exit>>()?)
    }
}

/// The beginning of the results of any `verify`.
const JUNIT: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<testsuites>\n  <testsuite name=\"axgen ";

/// Whether a file begins like the JSON results: with the first of three keys and a number.
fn is_json(found: &[u8]) -> bool {
    let digits = found.strip_prefix(b"{\n  \"failures\": ").unwrap_or_default();
    let end = digits.iter().position(|byte| !byte.is_ascii_digit()).unwrap_or_default();
    end > 0 && digits[end..].starts_with(b",\n  \"results\": [")
}

fn failures(outcomes: &[Outcome]) -> usize {
    outcomes.iter().filter(|outcome| outcome.failure.is_some()).count()
}

fn junit(suite: &str, outcomes: &[Outcome]) -> String {
    let (tests, failures) = (outcomes.len(), failures(outcomes));
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<testsuites>\n  \
         <testsuite name=\"{}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"0\" skipped=\"0\">\n",
        escaped(suite)
    );
    for Outcome { group, name, failure } in outcomes {
        let head = format!("    <testcase classname=\"{}\" name=\"{}\"", escaped(group), escaped(name));
        let _ = match failure {
            None => writeln!(text, "{head} />"),
            Some(why) => {
                let why = escaped(why);
                writeln!(text, "{head}>\n      <failure message=\"{why}\" />\n    </testcase>")
            }
        };
    }
    text + "  </testsuite>\n</testsuites>\n"
}

/// Text in an attribute; characters that XML 1.0 cannot contain become blanks.
fn escaped(text: &str) -> String {
    text.chars().fold(String::new(), |mut to, character| {
        match character {
            '&' => to.push_str("&amp;"),
            '<' => to.push_str("&lt;"),
            '>' => to.push_str("&gt;"),
            '"' => to.push_str("&quot;"),
            '\n' => to.push_str("&#10;"),
            control if control.is_control() => to.push(' '),
            other => to.push(other),
        }
        to
    })
}

fn as_json(suite: &str, outcomes: &[Outcome]) -> String {
    let results: Vec<_> = outcomes
        .iter()
        .map(|Outcome { group, name, failure }| {
            json!({ "group": group, "name": name, "passed": failure.is_none(), "failure": failure })
        })
        .collect();
    let object = json!({ "suite": suite, "failures": failures(outcomes), "results": results });
    format!("{object:#}\n")
}

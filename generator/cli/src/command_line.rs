//! Parses the command line. Its errors have the form of messages, for programs too.

use crate::arguments::Cli;
use crate::exit::Exit;
use crate::messages::Format;
use crate::output;
use clap::Parser;
use clap::error::ErrorKind;
use generator::codes;
use std::ffi::{OsStr, OsString};
use std::io::{self, Write};

/// The command with its options; otherwise the exit code, after a reported error.
pub fn read() -> Result<Cli, Exit> {
    Cli::try_parse().map_err(|error| {
        let arguments: Vec<OsString> = std::env::args_os().collect();
        let format = if asks_for_json(&arguments) { Format::Json } else { Format::Human };
        match error.kind() {
            // The text was requested.
            ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
                let printed = output::taken(error.print().and_then(|()| io::stdout().flush()));
                printed.err().map_or(Exit::Done, |exit| exit.say(format))
            }
            _ if format == Format::Json => Exit::input(codes::USAGE, "axgen", found(&error)).say(format),
            // For readers it has colours.
            _ => {
                let _ = error.print();
                Exit::Input(generator::diagnostics::Report::default())
            }
        }
    })
}

/// Whether messages are for programs, on a command line that may have other errors.
fn asks_for_json(arguments: &[OsString]) -> bool {
    let pairs = arguments.iter().zip(arguments.iter().skip(1).map(Some).chain([None]));
    let is = |text: &OsString, wanted: &str| text.as_os_str() == OsStr::new(wanted);
    let mut given = pairs.take_while(|(argument, _)| !is(argument, "--"));
    given.any(|(argument, next)| {
        is(argument, "--message-format=json")
            || (is(argument, "--message-format") && next.is_some_and(|next| is(next, "json")))
    })
}

/// The message of clap without its constant parts.
fn found(error: &clap::Error) -> String {
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return "a command is missing".to_owned();
    }
    let text = error.render().to_string();
    let text = text.strip_prefix("error: ").unwrap_or(&text);
    let ends = ["\n\nUsage:", "\n\nFor more information"];
    let end = ends.iter().filter_map(|end| text.find(end)).min().unwrap_or(text.len());
    text[..end].split_ascii_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_is_asked_for_in_two_ways_and_not_behind_two_dashes() {
        let asks = |text: &str| asks_for_json(&text.split(' ').map(OsString::from).collect::<Vec<_>>());
        assert!(asks("axgen check x --message-format json"));
        assert!(asks("axgen --message-format=json"));
        assert!(!asks("axgen check x --message-format human json"));
        assert!(!asks("axgen check x --message-format"));
        assert!(!asks("axgen check -- --message-format json"));
    }
}

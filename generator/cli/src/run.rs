//! `axgen run`: one block, one engine, samples from a CSV file to a CSV file.

use crate::SetArguments;
use crate::exit::Exit;
use crate::input;
use golden::case::named_block;
use golden::csv::{self, Reals};
use golden::engine::{self, ENGINES, Engine, Failure};
use golden::samples::Shape;
use std::io::{Read, Write};
use std::path::Path;

/// Runs the command.
pub fn run(
    arguments: &SetArguments,
    axis: Option<&str>,
    block: &str,
    engine: &str,
    stimulus: &Path,
    out: &Path,
    hex: bool,
) -> Result<Exit, Exit> {
    let (set, _) = input::read(arguments)?;
    let axis = input::axis(&set, axis)?;
    let block = named_block(axis, block).map_err(Exit::input)?;
    let engine = named_engine(engine)?;
    let text = read(stimulus)?;
    let inputs = csv::read(&text, &Shape::of(&block.program.inputs, axis.real)).map_err(|mistakes| {
        let line = |mistake: &csv::Mistake| {
            let csv::Mistake { line, column, found, allowed } = mistake;
            format!("{}:{line}:{column}: {found}; allowed: {allowed}\n", stimulus.display())
        };
        Exit::input(mistakes.iter().map(line).collect::<String>())
    })?;
    let outputs = engine::run(engine, axis, &block, &inputs).map_err(|failure| match failure {
        Failure::Environment(text) => Exit::environment(text),
        failure => Exit::environment(format!("engine {engine}: {failure}")),
    })?;
    let text = csv::write(&[&outputs], if hex { Reals::Hexadecimal } else { Reals::Decimal });
    write(out, &text)?;
    Ok(Exit::Done)
}

fn named_engine(name: &str) -> Result<Engine, Exit> {
    let names = || ENGINES.map(|engine| engine.to_string()).join(", ");
    ENGINES
        .into_iter()
        .find(|engine| engine.to_string() == name)
        .ok_or_else(|| Exit::input(format!("no engine `{}`; there is: {}", name.escape_default(), names())))
}

fn read(path: &Path) -> Result<String, Exit> {
    if path.as_os_str() == "-" {
        let mut text = String::new();
        let read = std::io::stdin().read_to_string(&mut text);
        return read.map(|_| text).map_err(|error| Exit::input(format!("standard input: {error}")));
    }
    std::fs::read_to_string(path).map_err(|error| Exit::input(format!("{}: {error}", path.display())))
}

fn write(path: &Path, text: &str) -> Result<(), Exit> {
    let written =
        if path.as_os_str() == "-" { std::io::stdout().write_all(text.as_bytes()) } else { std::fs::write(path, text) };
    written.map_err(|error| Exit::environment(format!("{}: {error}", path.display())))
}

//! The axis of a program that the axis of a set follows.

use super::notes::Note;
use super::{Options, refused};
use generator::codes;
use nc::{Axis, Command, Mistake, Program, Target};

/// The axis of the program from the option, else from the name: `X`; `X1`, or `X` if the program has no `X1`; `X_left` is X.
pub(super) fn of(program: &Program, name: &str, options: &Options, notes: &mut Vec<Note>) -> Result<Axis, Mistake> {
    let line = program.blocks.first().map_or(1, |block| block.line);
    const ALLOWED: &str = "a letter of an axis (X, Y, Z, A, B, C, U, V, W, E), or one with a number as in `X1=50`";
    if let Some(wanted) = &options.program_axis {
        return match Axis::named(wanted) {
            Some(axis) => Ok(moved(program, axis, axis, notes)),
            None => Err(refused(line, format!("`{wanted}` for --program-axis"), ALLOWED, "such a name")),
        };
    }
    let Some(own) = Axis::named(name).or_else(|| Axis::named(name.split('_').next().unwrap_or_default())) else {
        let found = format!("axis `{name}`, which NC programs do not have");
        return Err(refused(line, found, ALLOWED, "--program-axis X, or another name for the axis in its set"));
    };
    let axis = if moves(program, own) { own } else { own.without_number() };
    let axis = if moves(program, axis) { axis } else { own };
    if !axis.to_string().eq_ignore_ascii_case(name) {
        let found = format!("axis `{name}` follows axis {axis} of the program");
        notes.push(Note::new(codes::NC_FOLLOWS, line, found, "--program-axis with another one, if it is that"));
    }
    Ok(moved(program, axis, own, notes))
}

/// The axis; reports it if the program does not move it.
fn moved(program: &Program, axis: Axis, own: Axis, notes: &mut Vec<Note>) -> Axis {
    if !moves(program, axis) {
        let line = program.blocks.first().map_or(1, |block| block.line);
        let found = format!("a program that never moves axis {own}: it stands still");
        notes.push(Note::new(codes::NC_OTHER_DRIVE, line, found, "--program-axis with an axis that it moves"));
    }
    axis
}

fn moves(program: &Program, axis: Axis) -> bool {
    program.blocks.iter().flat_map(|block| &block.commands).any(|command| match command {
        Command::Move { axes, .. } => axes.iter().any(|(other, _)| *other == axis),
        Command::Home { target } => *target == Target::Axis(axis),
        _ => false,
    })
}

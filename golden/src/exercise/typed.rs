//! The operator of a block whose real inputs are typed: it changes one input after the other and presses the button, with values
//! inside and outside their ranges.

use crate::stimulus::Event;
use compiler::program::{Type, Variable};
use generator::blocks::{Block, Designed};
use portable::{Extreme, Literal};

/// Values that no input accepts, or that only a weight, a damping ratio or a limit does.
const HOSTILE: [&str; 6] = ["nan", "inf", "-1", "1e300", "5e-324", "-0"];

/// The events; none if the block has no such input. Each design has a period in which it can end.
pub(super) fn events(designed: &Designed, block: &Block) -> Vec<Event> {
    if !block.program.typed {
        return Vec::new();
    }
    let period = generator::blocks::calls_of_design(designed) as u64 + 8;
    let mut events = vec![Event::new("execute", "1", 2, period / 2, period)];
    let typed: Vec<&Variable> = block.for_axis.program.inputs.iter().filter(|input| input.ty == Type::Real).collect();
    let periods = typed.len() as u64 * (1 + HOSTILE.len() as u64) + 1;
    for (n, input) in (1..).zip(&typed) {
        let mut values = vec![other(designed, input)];
        values.extend(HOSTILE.map(str::to_owned));
        for (round, value) in (0..).zip(values) {
            let at = (n + round * typed.len() as u64) * period;
            events.push(Event::new(&input.path, &value, at, period, periods * period));
        }
    }
    events
}

/// Another value within the range of an input.
fn other(designed: &Designed, input: &Variable) -> String {
    let start = if let Literal::F64(start) = input.start { start } else { 0.0 };
    let value = match input.path.rsplit('.').next() {
        Some("f0") => (0.97 * start).larger(designed.set_design.lowest_f0),
        Some("q_factor") => (start + 1.5).smaller(10.0),
        Some("damping") => 0.25 + start / 2.0,
        _ => start / 2.0,
    };
    format!("{value}")
}

//! The design of a parameter set on the controller: from centre frequencies, quality factors, damping ratios, weights and a
//! limit to the numbers of a set, with its check word, bit for bit as the generator makes it.
//!
//! The rising edge of `execute` starts a design. Each call then does one piece of it:
//!
//! ```text
//! limit          its range
//! element        for each filter: reads its inputs, and tests their ranges
//!   centre       Omega0 = tan(pi f0 Ts)
//!   bandwidth    B = (1 + Omega0^2) tan(pi f0 Ts / Q)
//!   argument     of a pair of poles: the argument of one of five square roots
//!   root         that square root
//!   section      one section of the filter
//!   oscillation  the simulated oscillation that has its centre
//!   end          the norm; after the last filter of a stage its gain
//! seal           one piece of one number in the check word
//! ```
//!
//! So the longest call is one tangent or one square root. A block may run in any task, as often in a cycle as it likes: it
//! touches no other block. An input outside its range ends the design, and there is no set.

mod coeffs;
pub mod element;
pub mod piece;
mod signals;
mod state;

pub use coeffs::{Coeffs, Prototypes};
pub use signals::{Inputs, Outputs};
pub use state::{Piece, State};

use crate::design::inputs::Wrong;
use crate::ipc::numbers::{self, Params};
use crate::signal::{error_damping, error_f0, error_limit, error_low_f0, error_none, error_q_factor, error_weight};
use portable::{Block, Enable, Off, Real, note, portable};

/// Before the first call.
#[portable]
pub fn init<R: Real>(state: &mut State<R>) {
    state.held = false;
    state.works = false;
    state.complete = false;
    state.wrong = Wrong::Nothing;
    state.piece = Piece::Rest;
}

/// Starts a design.
#[portable]
pub fn start<R: Real>(state: &mut State<R>) {
    state.works = true;
    state.complete = false;
    state.wrong = Wrong::Nothing;
    state.piece = Piece::Limit;
    state.turn = 0u32;
    state.norms = R::ZERO;
}

/// The next piece. Returns which input is outside its range.
#[portable]
pub fn go_on<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>) -> Wrong {
    let mut wrong = Wrong::Nothing;
    match state.piece {
        Piece::Limit => wrong = piece::limit(state, coeffs, inputs),
        Piece::Element => wrong = piece::inputs(state, coeffs, inputs),
        Piece::Centre | Piece::Bandwidth => piece::tangent(state, coeffs),
        Piece::Argument => piece::argument(state, coeffs),
        Piece::Root => piece::root(state, coeffs),
        Piece::Section => piece::section(state, coeffs),
        Piece::Oscillation => piece::oscillation_section(state, coeffs),
        Piece::End => piece::end(state, coeffs),
        Piece::Seal => piece::seal(state, coeffs),
        _ => {
            note("the state was corrupted: the design ends without a set");
            state.works = false;
        }
    }
    wrong
}

/// The reason why an input was refused.
#[portable]
pub fn error_of(wrong: Wrong) -> u32 {
    match wrong {
        Wrong::Nothing => error_none(),
        Wrong::Frequency => error_f0(),
        Wrong::LowFrequency => error_low_f0(),
        Wrong::QualityFactor => error_q_factor(),
        Wrong::Damping => error_damping(),
        Wrong::Weight => error_weight(),
        _ => error_limit(),
    }
}

/// The outputs.
#[portable]
pub fn put_out<R: Real>(state: &State<R>, coeffs: &Coeffs<R>, outputs: &mut Outputs<R>) {
    outputs.active = state.works;
    outputs.designed = state.complete && !state.works;
    let error_id = error_of(state.wrong);
    outputs.fault = error_id != error_none();
    outputs.error_id = error_id;
    let is_of_element = outputs.fault && state.wrong != Wrong::Limit;
    let is_of_filter = is_of_element && state.wrong != Wrong::Damping && state.wrong != Wrong::Weight;
    outputs.wrong_stage = 0u32;
    if element::has_later_stages(coeffs) && is_of_element {
        outputs.wrong_stage = state.of.stage;
    }
    outputs.wrong_filter = 0u32;
    if element::has_later_filters(coeffs) && is_of_filter {
        outputs.wrong_filter = state.of.filter;
    }
    let none = Params::<R>::default();
    outputs.params = none;
    if outputs.designed {
        outputs.params.structure = coeffs.set.structure;
        outputs.params.set_id = state.set_id;
        numbers::show(&mut outputs.params, &coeffs.set.ipc, &state.numbers);
    }
}

/// One call: a piece of the active design.
#[portable]
pub fn step<R: Real>(state: &mut State<R>, coeffs: &Coeffs<R>, inputs: &Inputs<R>, outputs: &mut Outputs<R>) {
    if inputs.execute && !state.held {
        start(state);
    } else if state.works {
        let wrong = go_on(state, coeffs, inputs);
        if wrong != Wrong::Nothing {
            state.wrong = wrong;
            state.works = false;
        }
    }
    state.held = inputs.execute;
    put_out(state, coeffs, outputs);
}

/// The block.
#[derive(Clone, Copy, Debug)]
pub struct SetDesign;

impl<R: Real> Block<R> for SetDesign {
    types_init_and_step!(R, State<R>);

    const NAME: &'static str = "set_design";
    const MADE: Option<&'static str> = Some("params");
    const TYPED: bool = true;

    fn enable(_: &Coeffs<R>) -> Option<Enable> {
        Some(Enable { input: "execute", off: Off::Execute("works") })
    }

    fn inputs(coeffs: &Coeffs<R>) -> Inputs<R> {
        Inputs { execute: false, limit: coeffs.set.ipc.limit, stage: coeffs.generated }
    }

    fn exercise(inputs: &mut Inputs<R>, _: &Coeffs<R>) {
        inputs.execute = true;
    }
}

//! The block `excitation`: a maximum-length sequence on the commanded velocity, to measure the response of the drive.

pub(crate) mod check;
mod design;
mod notes;

use super::effects::{Effect, Effects, of_part};
use super::{BlockKind, Design, Drill, Figure, Summary};
use crate::axis::Axis;
use crate::blocks::designed::Designed;
use crate::design::rounding::literal;
use portable::Literal;
use reference::excitation::{Coeffs, Excitation};

/// The longest fade that a self-test waits for [cycles]: 0.1 s with a cycle of 250 us. Each of its cycles is two lines there.
const LONGEST_FADE: u32 = 400;

impl Design for Excitation {
    type Single = f32;

    fn design(designed: &Designed) -> Coeffs<f64> {
        design::coefficients(&designed.axis)
    }
}

impl BlockKind for Excitation {
    fn is_asked_for(&self, axis: &Axis) -> bool {
        axis.excitation.is_some()
    }

    fn short_name(&self) -> &'static str {
        "ex"
    }

    fn purpose(&self, _: &Designed) -> String {
        "Test signal on the velocity command, for measuring the response of the drive: add v_excite. The first call starts nothing, also \
         with hold_to_run TRUE: each start needs a rising edge. While the block is not called, v_excite keeps its last value and must \
         not be added."
            .to_owned()
    }

    fn notes(&self, designed: &Designed) -> Vec<(String, String)> {
        notes::notes(&designed.axis)
    }

    fn ranges(&self, designed: &Designed) -> [f64; 2] {
        let amplitude = amplitude(designed);
        [amplitude / 16.0, 4.0 * amplitude]
    }

    /// The button is released and pressed; the motor moves on until the fade is complete, then turns round. A second start in
    /// the other direction is released.
    fn drill(&self, designed: &Designed) -> Vec<Drill> {
        let speed = 4.0 * amplitude(designed);
        let part = |input, value, samples| Drill { input, value, samples };
        let turns = design::coefficients(&designed.axis).fade_cycles.min(LONGEST_FADE) as usize + 24;
        vec![
            part("hold_to_run", Literal::Bool(false), 0..2),
            part("v_motor", Literal::F64(speed), 0..turns),
            part("v_motor", Literal::F64(-speed), turns..turns + 40),
            part("hold_to_run", Literal::Bool(false), turns + 16..turns + 18),
            part("hold_to_run", Literal::Bool(false), turns + 28..turns + 34),
        ]
    }

    fn summary(&self, designed: &Designed) -> Summary {
        Summary { lines: notes::lines(&designed.axis), ..Summary::default() }
    }

    fn effects(&self, designed: &Designed) -> Effects {
        let Some(of) = &designed.axis.excitation else { return Effects::new() };
        let number = |value: u32, unit| Some(Effect::Number(f64::from(value), unit));
        let unit = if designed.axis.control.is_rotary { " 0.001 deg/s" } else { " um/s" };
        let values = [
            ("amplitude", Some(Effect::Number(of.amplitude, unit))),
            ("bits", number(of.sequence.bits(), "")),
            ("clock", number(of.sequence.clock(), " cycles")),
            ("periods", number(of.periods, "")),
        ];
        of_part("excitation", values)
    }

    fn limit(&self, designed: &Designed) -> Option<Figure> {
        let value = literal(amplitude(designed), designed.axis.real);
        let doc = format!("largest |v_excite| [{}]", designed.axis.control.velocity_unit());
        Some(Figure { name: "V_EXCITE_LIMIT", doc, value })
    }
}

fn amplitude(designed: &Designed) -> f64 {
    designed.axis.excitation.map_or(1.0, |of| of.amplitude)
}

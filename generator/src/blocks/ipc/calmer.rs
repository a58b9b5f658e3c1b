//! What a message about a loop says of a stage: its place, the loop that it acts through, and the weight that keeps the loop calm.

use super::closed_loop::{acts_through_position, looks_at_load, position_words};
use super::stage::StageDesign;
use crate::axis::Mode;
use crate::blocks::designed::Designed;
use crate::config::values::Key;
use crate::number::down_to;
use crate::parameters::Name;
use portable::Extreme;
use stability::{Loop, MAX_MS};

/// The loop without the stages that take `v_command`.
pub(super) fn without_set_point<'a>(designed: &Designed, closed: &Loop<'a>) -> Loop<'a> {
    closed.with(designed.stage.each_ref().map(|design| match design.as_ref().map(|design| &design.stage) {
        Some(stage) if !matches!(stage.mode, Mode::SetPoint { .. }) => stage.weight(),
        Some(_) | None => 0.0,
    }))
}

/// The weight of a stage (P-AXIS-00754).
pub(super) fn place(stage: usize) -> Key {
    (Name::WeightFactNum, [u32::try_from(stage).expect("design: there are three stages"), 0])
}

/// The loop through which a stage acts; empty for one that looks at the motor.
pub(super) fn through(designed: &Designed, design: &StageDesign) -> String {
    // The design is that on a rigid axis; the parameters are as they were given.
    if designed.axis.ipc.stage[design.index].as_ref().is_some_and(|given| looks_at_load(given.mode)) {
        return "; it is judged as on a rigid axis, where v_direct is v_motor".to_owned();
    }
    let is_through = acts_through_position(&designed.axis.control, design.stage.mode);
    let position = position_words(designed).filter(|_| is_through);
    position.map_or_else(String::new, |position| format!("; SET_POINT acts inside the position loop ({position})"))
}

/// The weight of a stage up to which the loop stays well damped; if there is none with the weights of the others, the
/// fraction of all weights. And the parameter that takes a stage out of the loop, where nothing says that it is in one.
pub(super) fn calmer(designed: &Designed, closed: &Loop<'_>, design: &StageDesign) -> String {
    let ([_, calm], [_, calm_part]) = (closed.largest_weights(design.index), closed.largest_parts());
    let down = |value: f64| down_to(value, 3);
    // With the weights of the others the loop may not be calm even without this stage.
    let weight = match calm > 0.0 {
        true => match best(design).filter(|best| *best < calm) {
            Some(best) => format!(
                "a weight of at most {}, the best one at this damping; the loop stays calm up to {} (Ms <= {MAX_MS})",
                down(best),
                down(calm)
            ),
            None => format!("a weight of at most {}, up to which the loop stays calm (Ms <= {MAX_MS})", down(calm)),
        },
        false => {
            let own = design.stage.weight() * calm_part;
            let [own, others] = [best(design).map_or(own, |best| own.smaller(best)), calm_part * 100.0].map(down);
            format!("a weight of {own}, and {others} % of the other weights")
        }
    };
    let control = &designed.axis.control;
    match acts_through_position(control, design.stage.mode) && control.location.is_none() {
        true => format!("{weight}; or antr.operation_mode DRIVE_POSITION_CONTROL, if the drive controls the position"),
        false => weight,
    }
}

/// The best weight of SET_POINT against the vibration; `None` for another mode.
pub(super) fn best(design: &StageDesign) -> Option<f64> {
    let Mode::SetPoint { osc_damping } = design.stage.mode else { return None };
    let four_d_squared = 4.0 * osc_damping * osc_damping;
    Some(four_d_squared / (four_d_squared + 1.0))
}

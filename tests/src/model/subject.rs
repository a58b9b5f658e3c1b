//! The reference's blocks as the model sees them: inputs by name, outputs by name as numbers. The only file of the model that
//! knows how the generator makes a block.

use super::history::Inputs;
use generator::blocks::{self, Designed};
use generator::config::ListOptions;
use generator::pipeline::read_to_look_at;
use portable::{Block, Portable, Real, RealKind};
use std::path::Path;

/// A block that runs: one cycle's inputs to all outputs.
pub type Run = Box<dyn FnMut(&Inputs, &mut Vec<(&'static str, f64)>)>;

/// Reads a set whose axis is X.
///
/// # Panics
/// If there is an error in it.
#[must_use]
pub fn read(set: &str) -> Designed {
    let load = |_: &Path| Ok(set.as_bytes().to_vec());
    let (read, report) = read_to_look_at(Path::new("model.toml"), &ListOptions::default(), &load);
    let read = read.unwrap_or_else(|| panic!("model: axgen refuses\n{set}\n{report:#?}"));
    read.axes.into_iter().find(|of| of.axis.name == "X").expect("the axis X")
}

/// The blocks `feedforward`, `position_control` and `axis`; one that the axis does not have is missing.
#[must_use]
pub fn blocks(designed: &Designed) -> [Option<Run>; 3] {
    match designed.axis.real {
        RealKind::F64 => blocks_as::<f64>(designed),
        RealKind::F32 => blocks_as::<f32>(designed),
    }
}

/// Runs a block: copies inputs, one cycle, hands out outputs.
macro_rules! runs {
    ($designed:expr, $block:ty, [$($input:ident)*], [$($real:ident)*], [$($number:ident)*], [$($flag:ident)*], $rest:expr) => {{
        let kind = blocks::named(<$block as Block<R>>::NAME).expect("the registry has the block");
        kind.is_asked_for(&$designed.axis).then(|| {
            let mut leaves = kind.coefficients($designed).into_iter();
            let coeffs: <$block as Block<R>>::Coeffs = Portable::build(&mut || leaves.next().expect("all coefficients"));
            let (mut state, mut outputs) = (<$block as Block<R>>::state(), <$block as Block<R>>::outputs());
            let mut inputs = <$block as Block<R>>::inputs(&coeffs);
            let run: Run = Box::new(move |given, found| {
                $(inputs.$input = R::lit(given.$input);)*
                inputs.position_controlled = given.position_controlled;
                inputs.reset = given.reset;
                inputs.task_cycle_ns = given.task_cycle_ns;
                inputs.cycle_counter = given.cycle_counter;
                $rest(&mut inputs, given);
                <$block as Block<R>>::step(&mut state, &coeffs, &inputs, &mut outputs);
                found.clear();
                $(found.push((stringify!($real), outputs.$real.to_f64()));)*
                $(found.push((stringify!($number), f64::from(outputs.$number)));)*
                $(found.push((stringify!($flag), f64::from(u8::from(outputs.$flag))));)*
            });
            run
        })
    }};
}

fn blocks_as<R: Real>(designed: &Designed) -> [Option<Run>; 3] {
    let feedforward = runs!(
        designed,
        reference::feedforward::Feedforward,
        [v_interpolator a_interpolator j_interpolator],
        [v_feedforward v_additive],
        [additive_velocity additive_torque error_id],
        [velocity_limited torque_limited fault],
        |inputs: &mut reference::feedforward::Inputs<R>, given: &Inputs| {
            inputs.feedforward_active = given.feedforward_active;
            inputs.feedforward_percentage = given.feedforward_percentage;
        }
    );
    let position_control = runs!(
        designed,
        reference::position_control::PositionControl,
        [x_command x_actual following_error v_feedforward v_additive v_add],
        [v_command x_drive],
        [manipulated_variable xerr additive_velocity additive_torque error_id],
        [limited fault],
        |inputs: &mut reference::position_control::Inputs<R>, given: &Inputs| {
            inputs.torque_feedforward = given.torque_feedforward;
        }
    );
    let whole = runs!(
        designed,
        reference::axis::Axis,
        [x_command x_actual following_error v_interpolator a_interpolator j_interpolator v_motor v_direct v_add_master],
        [v_command v_feedforward v_add v_add_calculated x_drive],
        [manipulated_variable xerr additive_torque additive_velocity error_id],
        [limited held tripped fault],
        |inputs: &mut reference::axis::Inputs<R>, given: &Inputs| {
            inputs.mode = given.mode;
            inputs.tuning_weight = given.tuning_weight.map(R::lit);
            inputs.tuning_limit = R::lit(given.tuning_limit);
            inputs.feedforward_active = given.feedforward_active;
            inputs.feedforward_percentage = given.feedforward_percentage;
        }
    );
    [feedforward, position_control, whole]
}

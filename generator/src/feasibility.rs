//! Errors in a designed axis that must not run on a machine, then advice for its user. Nothing is designed here.

use crate::blocks::ipc::{advice as ipc, feasibility as sections};
use crate::blocks::spindle::advice as spindle;
use crate::blocks::{
    Designed, excitation::check as excitation, feedforward::advice as feedforward,
    position_control::advice as position_control,
};
use crate::check::{assumed, gear, inert, units};
use crate::design::rounding::{largest, sample_limit};
use crate::{codes, config::values::key, design::scale, diagnostics::Diagnostic};
use crate::{parameters::Name, rules::effective::Effective};
use portable::Extreme;

/// Reports errors; if there are none, advice.
pub(crate) fn validate(designed: &Designed, gear: u32, e: &mut Effective<'_>) {
    let axis = &designed.axis;
    sections::validate(designed, e);
    excitation::validate(axis, e);
    if !e.report.has_errors() {
        overflow(designed, gear, e);
    }
    if !e.report.has_errors() {
        gear::advise(axis, e);
        assumed::advise(axis, gear, e);
        units::advise(axis, gear, e);
        ipc::advise(designed, gear, e);
        feedforward::inert(axis, gear, e);
        inert::advise(axis, gear, e);
        feedforward::advise(axis, e);
        position_control::advise(axis, gear, e);
        spindle::advise(axis, gear, e);
    }
}

/// Rejects a scaling whose product with the largest sample in range overflows the axis's real type.
fn overflow(designed: &Designed, gear: u32, e: &mut Effective<'_>) {
    let (sample, largest) = (sample_limit(designed.axis.real), largest(designed.axis.real));
    let Some(feedforward) = &designed.axis.control.feedforward else { return };
    let weight = feedforward.weight.value();
    let mut factors = vec![(key(Name::VsVFaktor), "the weight of feedforward", weight)];
    if let Some(torque) = feedforward.torque_scale.as_ref().map(scale::torque) {
        let of_torque = |factor: f64| ((Name::Load, [gear, 0]), "the scaling of the additive torque", torque * factor);
        factors.push(of_torque(feedforward.acceleration.value().larger(1.0)));
        factors.push(of_torque(feedforward.jerk.value()));
    }
    // 16 for sums of a few products.
    let is_beyond = |factor: f64| factor.is_nan() || factor * weight.larger(1.0) * sample * 16.0 > largest;
    if let Some((key, what, factor)) = factors.into_iter().find(|(.., factor)| is_beyond(*factor)) {
        let found = format!("{what} is {factor:e}: a sample in range times it is beyond the numbers of this axis");
        let diagnostic = Diagnostic::error(codes::SCALE, e.place_of(key), found);
        e.report.push(diagnostic.instead("the scaling of the drive's manual"));
    }
}

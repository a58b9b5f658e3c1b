//! The keys of a set for the drive, for the stability of the loop.

use crate::axis::DriveModel;
use crate::config::values::key;
use crate::parameters::{Name, Value};
use crate::rules::{drive::stated_delay, effective::Effective};

/// The drive of an axis with active stages; `None` after a reported error. The pipeline reads a measured response.
pub(crate) fn check(e: &mut Effective<'_>) -> Option<DriveModel> {
    let gear = e.validated_integer(key(Name::Gear))?;
    let given = |e: &mut Effective<'_>, key| match e.given(key) {
        Some(_) => e.validated(key).map(Some),
        None => Some(None),
    };
    let delay = given(e, key(Name::DriveDelay));
    let delay_cycles = stated_delay(e).map(|(cycles, _)| cycles);
    let time_constant = given(e, key(Name::DriveTimeConstant));
    let position_gain = given(e, (Name::Kv, [gear, 0]));
    let number = |value: Option<Value>| match value {
        Some(Value::Real(x)) => Some(x),
        Some(Value::Integer(n)) => Some(n as f64),
        Some(Value::Duration(ns)) => Some(ns as f64),
        Some(Value::Word(_) | Value::Words(_) | Value::Text(_)) | None => None,
    };
    delay?;
    Some(DriveModel {
        delay_cycles,
        time_constant: number(time_constant?).map(|ns| ns / 1e9),
        response: None,
        position_gain: number(position_gain?).map(|hundredths| hundredths / 100.0),
    })
}

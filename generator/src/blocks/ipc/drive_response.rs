//! The measured response of a drive that a set names (`drive.response`), with its speed controller if it was measured from
//! the current.

use super::closed_loop;
use crate::axis::{Filter, MeasuredDrive};
use crate::blocks::designed::Designed;
use crate::codes;
use crate::config::values::{Values, key};
use crate::config::{Load, file};
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::words::ResponseFrom;
use crate::parameters::{Name, Value};
use crate::response_file::{self, Band, From};
use crate::rules::{drive::given_number, effective::Effective};
use std::path::Path;
use std::sync::Arc;

/// Reads the response; `None` if there is none, or after a reported error. The path of the file is relative to the set.
pub(crate) fn read(
    designed: &Designed,
    values: &Values,
    (set, load): (&Path, Load<'_>),
    e: &mut Effective<'_>,
) -> Option<MeasuredDrive> {
    unused(e);
    let (name, setting) = values.text(Name::DriveResponse)?;
    let from = from(designed, e)?;
    let folder = if setting.source.is_option() { Path::new("") } else { set.parent().unwrap_or(Path::new("")) };
    let is_stated = e.given(key(Name::DriveResponseFrom)).is_some();
    let read = file::bytes(&folder.join(name), "a frequency response", Some(setting), load).and_then(|bytes| {
        let read = response_file::read(name, &bytes, from, designed.axis.cycle_time(), &bands(designed));
        let is_another = |report: &Report| report.diagnostics.iter().any(|said| said.code == codes::RESPONSE_TABLE);
        let is_known = is_stated || !response_file::is_without_names(&bytes) || read.as_ref().is_err_and(is_another);
        if is_known { read } else { Err(without_names(name).into()) }
    });
    let measured = read.map_err(|report| e.report.extend(report)).ok()?;
    e.report.extend(measured.said);
    let (From::Command { delay } | From::Current { delay, .. }) = from;
    let drive = MeasuredDrive { file: name.to_owned(), response: Arc::new(measured.response), delay };
    let [_, gain_in_drive] = designed.axis.control.placed(designed.axis.drive.position_gain);
    Some(drive.in_position_loop(gain_in_drive))
}

/// Reports what is stated of the drive and not used: a warning for a key, an error for an option of the command line. A
/// response replaces the time constant, and only one from the current has a speed controller.
fn unused(e: &mut Effective<'_>) {
    let has_response = e.given(key(Name::DriveResponse)).is_some();
    let from = e.validated_word(key(Name::DriveResponseFrom));
    let speed = [Name::DriveSpeedGain, Name::DriveSpeedIntegralTime];
    let (names, why): (&[Name], _) = match (has_response, from) {
        (false, _) => (&[Name::DriveResponseFrom, speed[0], speed[1]], "without a response (drive.response)"),
        (true, Some(ResponseFrom::Current)) => {
            (&[Name::DriveTimeConstant], "with a measured response, which contains it")
        }
        (true, Some(ResponseFrom::Velocity) | None) => (
            &[Name::DriveTimeConstant, speed[0], speed[1]],
            "with a measured response from the commanded velocity, which contains it",
        ),
    };
    for name in names {
        let Some(setting) = e.given(key(*name)) else { continue };
        let (is_option, title) = (setting.source.is_option(), e.title(key(*name)));
        let found = format!("{title} has no effect {why}");
        let instead = match (has_response, is_option) {
            (true, false) => format!("no {}", name.parameter().path),
            (true, true) => "no such option, or --axis with an axis without a response".to_owned(),
            (false, false) => format!("drive.response with the measured response, or no {}", name.parameter().path),
            (false, true) => "--response with the measured response".to_owned(),
        };
        match is_option {
            true => e.refuse(codes::UNUSED_OF_DRIVE, key(*name), found, [None, Some(instead)]),
            false => e.warn(codes::UNUSED_OF_DRIVE, key(*name), found, Some(instead)),
        }
    }
}

/// An error: a default for the input of the response would be a guess.
fn without_names(file: &str) -> Diagnostic {
    Diagnostic::error(codes::RESPONSE_FROM, Place::whole(file), "XML, in which signals have numbers instead of names")
        .allowed("a response of which the set, or the option --response-from, states what it is from")
        .instead(
            "`drive.response_from = \"v_cmd\"` from the speed setpoint, `\"current\"` from that of current or torque",
        )
}

/// The input of the response. `drive.delay` is the delay that the measurement lacks.
fn from(designed: &Designed, e: &mut Effective<'_>) -> Option<From> {
    // P-AXIS-00191 is a part of what was measured.
    let delay = given_number(e, Name::DriveDelay).unwrap_or(0.0) * designed.axis.cycle_time();
    match e.validated_word(key(Name::DriveResponseFrom))? {
        ResponseFrom::Velocity => Some(From::Command { delay }),
        ResponseFrom::Current => {
            let kp = e.validated(key(Name::DriveSpeedGain));
            let tn = match e.given(key(Name::DriveSpeedIntegralTime)) {
                Some(_) => e.validated(key(Name::DriveSpeedIntegralTime)),
                None => Some(Value::Duration(0)),
            };
            match (kp?, tn?) {
                (Value::Real(kp), Value::Duration(ns)) => Some(From::Current { kp, tn: ns as f64 / 1e9, delay }),
                _ => None,
            }
        }
    }
}

/// The bands in which the response decides: of stages that look at the motor. At those of SET_POINT the drive follows.
fn bands(designed: &Designed) -> Vec<Band> {
    let band = |design: &super::stage::StageDesign| {
        let filters = design.stage.filter.iter().filter(|filter| super::filter::is_selective(filter));
        let of = |[f0, q_factor]: [f64; 2]| Band { stage: design.index, f0, width: f0 / q_factor };
        filters.filter_map(Filter::f0_and_q).map(of).collect::<Vec<_>>()
    };
    let stages = designed.stage.iter().flatten().filter(|of| closed_loop::looks_at_motor(of.stage.mode));
    stages.flat_map(band).collect()
}

//! Functions of the CNC that no block has, and that change what the blocks meet: command filters, reversed signs, a Kv that depends
//! on the velocity. A warning for each that is on. Nothing else of them is read here.

use crate::axis::{Axis, Location};
use crate::config::other_functions::{Found, OtherFunctions};
use crate::number::digits;
use crate::{codes, diagnostics::Diagnostic, rules::effective::Effective};

/// Number of filters in series.
const FILTERS: u32 = 3;
/// The types of HSC filters (P-AXIS-00204), and their prototype (P-AXIS-00153). The NC program switches them on.
const HSC_TYPES: [f64; 2] = [8.0, 12.0];
const HSC_PROTOTYPE: f64 = 5.0;

pub(crate) fn advise(axis: &Axis, list: &OtherFunctions, e: &mut Effective<'_>) {
    signs(list, e);
    variable_kv(axis, list, e);
    if axis.ipc.is_active() {
        filters(list, e);
    }
}

/// Signs that the CNC changes between itself and the drive.
fn signs(list: &OtherFunctions, e: &mut Effective<'_>) {
    const OUT: &str =
        "what the block gives to the drive: v_add, manipulated_variable, x_drive, additive values, velocity_command";
    const IN: &str = "what the caller takes from the drive or its encoder: x_actual, v_actual, v_motor, v_direct";
    for (start, end, id, does, signals) in [
        ("lr_hw[", ".vz_istw", "P-AXIS-00230", "takes the opposite of the encoder's position", vec![IN]),
        ("lr_hw[", ".vz_stellgr", "P-AXIS-00231", "puts out the opposite of its manipulated variable", vec![OUT]),
        (
            "getriebe[",
            ".reverse",
            "P-AXIS-00159",
            "changes the signs of all that it gives to the drive and takes from it",
            vec![IN, OUT],
        ),
    ] {
        let on = list.all(start, end).filter(|(_, found)| number(found) > 0.0);
        e.report.diagnostics.extend(on.map(|(path, at)| {
            let found = format!("{path} is on ({id}): the CNC {does}, the blocks do not");
            let instead =
                format!("in the program that calls the block, the opposite sign for {}", signals.join("; and for "));
            Diagnostic::warning(codes::REVERSED, at.place.clone(), found).instead(instead)
        }));
    }
}

/// The Kv that the CNC interpolates between two velocities, where it controls the position.
fn variable_kv(axis: &Axis, list: &OtherFunctions, e: &mut Effective<'_>) {
    if axis.control.position_control.as_ref().is_some_and(|of| of.location != Location::Cnc) {
        return;
    }
    let on = list.all("getriebe[", ".dyn_kv_active").filter(|(_, found)| number(found) > 0.0);
    let kv = axis.control.kv.map_or_else(String::new, |kv| format!(", {}/s,", digits(f64::from(kv) / 100.0)));
    e.report.diagnostics.extend(on.map(|(path, at)| {
        let found = format!(
            "{path} is on (P-AXIS-00244): the Kv of the CNC depends on the velocity; the blocks and the margins have the one of \
             P-AXIS-00099{kv} at every velocity"
        );
        let instead = "dyn_kv_active 0; or, for the margins, getriebe[i].kv as the larger of kv1 and kv2 (P-AXIS-00245, 00247)";
        Diagnostic::warning(codes::VARIABLE_KV, at.place.clone(), found).instead(instead)
    }));
}

/// Filters of the position command.
fn filters(list: &OtherFunctions, e: &mut Effective<'_>) {
    let on = (0..FILTERS).filter_map(|i| filter(list, i)).chain(fir(list));
    e.report.diagnostics.extend(on.map(|(what, at)| {
        let found = format!("{what}: it delays the command, and turns its phase");
        let said = Diagnostic::warning(codes::COMMAND_FILTER, at.place.clone(), found);
        said.instead("the filter off while the stages are tuned; or tune with it, and again when it changes")
    }));
}

/// A filter `filter[i]` that is on, or that an NC program can switch on.
fn filter(list: &OtherFunctions, i: u32) -> Option<(String, &Found)> {
    let get = |name: &str| list.get(&format!("filter[{i}].{name}"));
    let is = |name: &str, wanted: &[f64]| get(name).is_some_and(|found| wanted.contains(&number(found)));
    let order = get("order").filter(|order| number(order) > 0.0);
    if is("type", &HSC_TYPES) || is("prototype", &[HSC_PROTOTYPE]) {
        let time = get("time_constant").filter(|time| number(time) > 0.0);
        let at = order.or(time)?;
        return Some((format!("filter[{i}] is an HSC filter, which the NC program switches on"), at));
    }
    let enable = get("enable").filter(|enable| number(enable) > 0.0)?;
    order.map(|_| (format!("the command filter filter[{i}] is on (P-AXIS-00319, 00140)"), enable))
}

/// The filter `filter_fir`.
fn fir(list: &OtherFunctions) -> Option<(String, &Found)> {
    let [enable, kind] = ["filter_fir.enable", "filter_fir.type"].map(|path| list.get(path));
    let enable = enable.filter(|enable| number(enable) > 0.0)?;
    let is_chosen = kind.is_some_and(|kind| number(kind) > 0.0);
    is_chosen.then(|| ("the command filter filter_fir is on (P-AXIS-00573, 00586)".to_owned(), enable))
}

/// A number or a truth value; 0 for anything else.
fn number(found: &Found) -> f64 {
    match found.text.as_str() {
        word if word.eq_ignore_ascii_case("TRUE") => 1.0,
        text => text.parse().unwrap_or(0.0),
    }
}

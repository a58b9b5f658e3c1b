//! Filters of the position command, which belong to another function: a warning if stages act. Only their activation is read
//! here.

use crate::axis::Axis;
use crate::config::other_functions::{Found, OtherFunctions};
use crate::{codes, diagnostics::Diagnostic, rules::effective::Effective};

/// Number of filters in series.
const FILTERS: u32 = 3;
/// The types of HSC filters (P-AXIS-00204), and their prototype (P-AXIS-00153). The NC program switches them on.
const HSC_TYPES: [f64; 2] = [8.0, 12.0];
const HSC_PROTOTYPE: f64 = 5.0;

pub(crate) fn advise(axis: &Axis, list: &OtherFunctions, e: &mut Effective<'_>) {
    if !axis.ipc.is_active() {
        return;
    }
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

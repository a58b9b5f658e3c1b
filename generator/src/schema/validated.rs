//! Ranges that apply only where a value is used, as far as the set alone decides: those of an active stage, and of the gear
//! step 0. The list of an axis may change that.

use super::{leaf, words};
use crate::parameters::Name;
use crate::parameters::words::{FilterType, StageMode, Words};
use serde_json::{Value, json};

/// The rules of an axis in addition to the types of its values.
pub(super) fn rules() -> Value {
    let stages = json!({ "lr_param": { "properties": { "improved_position_control": { "properties": {
        "stage": { "items": stage() },
    } } } } });
    let steps = json!({ "getriebe": { "prefixItems": [{ "properties": { "dynamik": { "properties": {
        "vb_max": leaf(Name::VbMax.parameter(), true),
    } } } }] } });
    json!([
        { "if": { "not": { "required": ["list"] } }, "then": { "properties": stages } },
        { "if": { "not": { "required": ["gear"] } }, "then": { "properties": steps } },
    ])
}

/// A stage with a mode other than NOT_ACTIVE.
fn stage() -> Value {
    let strict = |name: Name| leaf(name.parameter(), true);
    let damping = json!({ "exclusiveMaximum": 1.0 });
    json!({ "allOf": [
        {
            "if": given(Name::Mode, &[StageMode::Direct, StageMode::Indirect, StageMode::SetPoint]),
            "then": { "properties": {
                "weight_fact_num": strict(Name::WeightFactNum),
                "weight_fact_denom": strict(Name::WeightFactDenom),
                "filter": filters(),
            } },
        },
        {
            "if": given(Name::Mode, &[StageMode::Indirect, StageMode::SetPoint]),
            // A damping below 0 means that it is not given; then the other parameter gives it.
            "then": { "properties": {
                "osc_damping": damping,
                "filter": { "properties": { "damping": damping }, "prefixItems": [{ "properties": { "damping": damping } }] },
            } },
        },
    ] })
}

/// Filters of an active stage, as an array, or the first one as a table.
fn filters() -> Value {
    let bandpass = given(Name::FilterType, &[FilterType::Bandpass]);
    // A first filter without a type is a band-pass.
    let by_default = json!({ "properties": bandpass["properties"] });
    let mut first = filter(&by_default);
    first["prefixItems"] = json!([filter(&by_default), filter(&bandpass)]);
    first
}

fn filter(is_bandpass: &Value) -> Value {
    let ranges = |names: &[Name]| {
        let of = |name: &Name| (name.parameter().short().to_owned(), leaf(name.parameter(), true));
        json!({ "properties": names.iter().map(of).collect::<serde_json::Map<_, _>>() })
    };
    let is_other = |ty: &FilterType| ![FilterType::NoFilter, FilterType::Bandpass].contains(ty);
    let others: Vec<FilterType> = FilterType::ALL.iter().copied().filter(is_other).collect();
    json!({ "allOf": [
        { "if": is_bandpass, "then": ranges(&[Name::FilterOrder, Name::FilterF0, Name::FilterQ]) },
        { "if": given(Name::FilterType, &others), "then": ranges(&[Name::FilterF0, Name::FilterQ]) },
    ] })
}

/// A table in which the parameter is one of the words.
fn given<T: Words>(name: Name, chosen: &[T]) -> Value {
    let short = name.parameter().short();
    let chosen = T::ALL.iter().zip(T::WORDS).filter(|(word, _)| chosen.contains(word)).map(|(_, word)| word);
    json!({ "required": [short], "properties": { short: words(chosen) } })
}

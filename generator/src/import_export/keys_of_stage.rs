//! A stage as the keys that a set or a list has below `stage[i].`. No text of a file.

use crate::axis::{Filter, Mode, Stage};
use crate::parameters::Name;
use crate::parameters::words::Words;

/// A key of a stage below `stage[i].`, with its value as a text, which is a word or a number.
pub(super) struct Given {
    pub(super) name: Name,
    /// of a filter its number, else 0
    pub(super) filter: u32,
    pub(super) text: String,
    /// whether it has to be written: else only where the axis has the key already
    pub(super) is_needed: bool,
}

/// All keys that make a stage; those that are not needed have their defaults, or no effect.
pub(super) fn keys(stage: &Stage) -> Vec<Given> {
    let mut keys = Vec::new();
    let mut add = |name, filter, text: String, is_needed| keys.push(Given { name, filter, text, is_needed });
    add(Name::Mode, 0, stage.mode.word().to_owned(), true);
    match stage.mode {
        Mode::Direct { source } => add(Name::DirectSource, 0, source.name().to_owned(), source.name() != "v_motor"),
        Mode::Indirect { osc_damping } | Mode::SetPoint { osc_damping } => {
            add(Name::OscDamping, 0, osc_damping.to_string(), true);
        }
    }
    add(Name::WeightFactNum, 0, stage.weight_fact_num.to_string(), true);
    add(Name::WeightFactDenom, 0, stage.weight_fact_denom.to_string(), true);
    for (k, filter) in (0..).zip(&stage.filter) {
        let is_first = k == 0;
        let kind = filter.kind().name();
        add(Name::FilterType, k, kind.to_owned(), kind != if is_first { "BANDPASS" } else { "NO_FILTER" });
        if let Filter::Bandpass { prototype, order, .. } = filter {
            add(Name::FilterPrototype, k, prototype.name().to_owned(), !is_first || *order > 1);
            add(Name::FilterOrder, k, order.to_string(), true);
        }
        if let Filter::Bandpass { f0, q_factor, .. } | Filter::Allpass { f0, q_factor } = filter {
            add(Name::FilterF0, k, f0.to_string(), true);
            add(Name::FilterQ, k, q_factor.to_string(), true);
        }
    }
    keys
}

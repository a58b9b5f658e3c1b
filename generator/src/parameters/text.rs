//! The text of parameters, values and ranges in messages and in the canonical form. Nothing is read here.

use super::{Kind, Parameter, Value, Word};

/// A path template with these indices in place of its letters.
pub(crate) fn path_with(template: &str, index: [u32; 2]) -> String {
    let mut path = String::with_capacity(template.len());
    let mut indices = index.into_iter();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('[') {
        path.extend([before, "[", &indices.next().unwrap_or(0).to_string(), "]"]);
        rest = after.split_once(']').map_or("", |(_, after)| after);
    }
    path + rest
}

/// A time with the largest unit that needs no more than a few digits: `62.5us`, `1ms`.
pub(crate) fn time_text(ns: u64) -> String {
    let (unit, per_unit, digits) = match ns {
        0 => return "0s".to_owned(),
        1_000_000_000.. => ("s", 1_000_000_000, 9),
        1_000_000.. => ("ms", 1_000_000, 6),
        1000.. => ("us", 1000, 3),
        _ => ("ns", 1, 0),
    };
    let fraction = format!("{:0digits$}", ns % per_unit);
    let fraction = if digits == 0 { "" } else { fraction.trim_end_matches('0') };
    let point = if fraction.is_empty() { "" } else { "." };
    format!("{}{point}{fraction}{unit}", ns / per_unit)
}

/// The shortest decimal that is read back to the same bits.
pub(crate) fn real_text(x: f64) -> String {
    if x != 0.0 && !(1e-5..1e16).contains(&x.abs()) { format!("{x:e}") } else { format!("{x}") }
}

impl Value {
    /// The text in the canonical form.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::Word(word) => (*word).to_owned(),
            Self::Words(words) => words.join(" "),
            Self::Integer(n) => n.to_string(),
            Self::Real(x) => real_text(*x),
            Self::Duration(ns) => time_text(*ns),
            Self::Text(text) => text.clone(),
        }
    }
}

impl Parameter {
    /// The allowed values, for a message: `1 <= order <= 3`.
    pub fn allowed(&self) -> String {
        let short = self.short();
        let unit = if self.unit.is_empty() { String::new() } else { format!(" [{}]", self.unit) };
        match self.kind {
            Kind::Word(words) => words.iter().map(spellings).collect::<Vec<_>>().join(", "),
            Kind::Words(words) => format!("any of {}", words.iter().map(spellings).collect::<Vec<_>>().join(", ")),
            Kind::Flags(words) => words.iter().map(flag).collect::<Vec<_>>().join(", ") + ", and sums of these",
            Kind::Integer { .. } if !self.numbers.is_empty() => {
                let of = |(number, meaning): (usize, &&str)| format!("{number} ({meaning})");
                self.numbers.iter().enumerate().map(of).collect::<Vec<_>>().join(", ")
            }
            Kind::Integer { from, to } => format!("{from} <= {short} <= {to}{unit}"),
            Kind::Real { from, to, open } => {
                let [above, below] = open.map(|is_open| if is_open { "<" } else { "<=" });
                format!("{} {above} {short} {below} {}{unit}", real_text(from), real_text(to))
            }
            Kind::Duration { from, to } => format!("{} <= {short} <= {}", time_text(from), time_text(to)),
            Kind::Text => "a text".to_owned(),
        }
    }

    pub(crate) fn title(&self, template: &str, index: [u32; 2]) -> String {
        let path = path_with(template, index);
        self.id.map_or_else(|| format!("`{path}`"), |id| format!("`{path}` ({id})"))
    }
}

/// A word with all its spellings: `ON (TRUE, 1)`.
fn spellings(word: &Word) -> String {
    let number = word.number.map(|number| number.to_string());
    let others: Vec<&str> = word.also.iter().copied().chain(number.as_deref()).collect();
    if others.is_empty() { word.name.to_owned() } else { format!("{} ({})", word.name, others.join(", ")) }
}

/// A flag with its bits: `VEL (0x001)`.
fn flag(word: &Word) -> String {
    format!("{} (0x{:03x})", word.name, word.number.unwrap_or(0))
}

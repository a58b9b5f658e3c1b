//! Stages of the command line (`--stage mode=DIRECT,fg_f0=53,...`) as keys of an axis. No value is read, no file.

use super::closest;
use super::given::{ABOVE_STAGES as ABOVE, OptionKey, is_of_stage};
use super::path::{self, Path};
use super::value::shown;
use crate::codes;
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Name, STAGES};

/// Keys of the first filter that need no `filter[0].`.
const OF_FILTER: [&str; 5] = ["fg_f0", "q_factor", "order", "prototype", "type"];
/// Keys of a stage; `weight` and `allpass` are short for two and three.
const KEYS: &str = "mode, direct_source, osc_damping, weight=0.5 (weight_fact_num, weight_fact_denom), fg_f0, q_factor, order, \
    prototype, allpass=F0/Q (filter[1].type, filter[1].fg_f0, filter[1].q_factor)";
/// The denominator of a weight that is a decimal number, and its digits.
const DENOMINATOR: &str = "1000";
const DIGITS: usize = 3;

/// The keys of stages, each as `KEY=VALUE,KEY=VALUE`, named as below `stage` in a set. They replace all stages that an axis has.
/// A filter without `order` has order 1.
///
/// # Errors
/// All mistakes: unknown keys, parts without `=`, weights and all-passes that are none. Values are judged where they are read.
pub fn stage_keys(specs: &[String]) -> Result<Vec<OptionKey>, Report> {
    let mut report = Report::default();
    let mut keys = Vec::new();
    if specs.len() > STAGES as usize {
        let found = format!("{} stages", specs.len());
        report.push(Diagnostic::error(codes::USAGE, Place::whole("--stage"), found).allowed("1 to 3 stages"));
    }
    for (stage, spec) in specs.iter().enumerate().take(STAGES as usize) {
        let option = if specs.len() == 1 { "--stage".to_owned() } else { format!("--stage {}", stage + 1) };
        let mut of = OfStage { option, stage, keys: Vec::new(), report: &mut report };
        spec.split(',').for_each(|part| of.part(part.trim()));
        let is_there = |name: Name| of.keys.iter().any(|key| key.name == name && key.index[1] == 0);
        if is_there(Name::FilterF0) && !is_there(Name::FilterOrder) {
            of.add("filter[0].order", "1");
        }
        keys.append(&mut of.keys);
    }
    if report.has_errors() { Err(report) } else { Ok(keys) }
}

struct OfStage<'r> {
    option: String,
    stage: usize,
    keys: Vec<OptionKey>,
    report: &'r mut Report,
}

impl OfStage<'_> {
    fn part(&mut self, part: &str) {
        let Some((key, value)) = part.split_once('=').map(|(key, value)| (key.trim(), value.trim())) else {
            return self.refuse(format!("{} has no value", shown(part)), "KEY=VALUE,KEY=VALUE");
        };
        match key {
            "weight" => self.weight(value),
            "allpass" => match value.split_once('/') {
                Some((f0, q)) => {
                    self.add("filter[1].type", "ALLPASS");
                    self.add("filter[1].fg_f0", f0);
                    self.add("filter[1].q_factor", q);
                }
                None => self.refuse(format!("allpass={value}"), "allpass=F0/Q, such as allpass=24.5/2"),
            },
            _ if OF_FILTER.contains(&key) => self.add(&format!("filter[0].{key}"), value),
            _ => self.add(key, value),
        }
    }

    /// `0.5`, or `NUM/DENOM`.
    fn weight(&mut self, value: &str) {
        if let Some((num, denom)) = value.split_once('/') {
            self.add("weight_fact_num", num);
            self.add("weight_fact_denom", denom);
            return;
        }
        let (whole, digits) = value.split_once('.').unwrap_or((value, ""));
        let is_number = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        let is_decimal = is_number(whole) && is_number(digits) && digits.len() <= DIGITS && !value.is_empty();
        match format!("{whole}{digits:0<DIGITS$}").parse::<u32>() {
            Ok(num) if is_decimal => {
                self.add("weight_fact_num", &num.to_string());
                self.add("weight_fact_denom", DENOMINATOR);
            }
            _ => self.refuse(format!("weight={value}"), "a number with up to 3 digits after its point, or NUM/DENOM"),
        }
    }

    fn add(&mut self, key: &str, value: &str) {
        match path::find(&format!("{ABOVE}[{}].{key}", self.stage)) {
            Path::Known { name, index, misprint: false, .. } if is_of_stage(name) => {
                if self.keys.iter().any(|known| (known.name, known.index) == (name, index)) {
                    return self.refuse(format!("{} is given twice", shown(key)), "each key once");
                }
                self.keys.push(OptionKey {
                    axis: None,
                    option: self.option.clone(),
                    name,
                    index,
                    text: value.to_owned(),
                });
            }
            _ => {
                let place = Place::whole(&self.option);
                let said = Diagnostic::error(codes::UNKNOWN, place, format!("{} is not a key of a stage", shown(key)));
                let known = KEYS.split(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_');
                let meant = closest::nearest(key, known.filter(|word| word.len() > 3)).map(str::to_owned);
                self.report.push(Diagnostic { instead: meant, ..said.allowed(KEYS) });
            }
        }
    }

    fn refuse(&mut self, found: String, allowed: &str) {
        self.report.push(Diagnostic::error(codes::USAGE, Place::whole(&self.option), found).allowed(allowed));
    }
}

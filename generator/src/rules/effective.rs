//! The effective value of a parameter: the given value, else its default; a message if it is out of range. No rule that
//! connects two parameters.

use crate::config::is_set;
use crate::config::values::{Key, Setting, Values};
use crate::diagnostics::{Diagnostic, Place, Report};
use crate::parameters::{Name, Value, path_with};
use crate::{codes, config::value, parameters::words::Words};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::LazyLock;

/// The given values of an axis, the messages about them, and the values that its block uses.
#[derive(Debug)]
pub(crate) struct Effective<'a> {
    values: &'a Values,
    home: Place,
    pub(crate) report: Report,
    /// the block whose rules are checked; `None` if all blocks depend on the value
    pub(crate) block: Option<&'static str>,
    /// values that replace a default
    adopted: BTreeMap<Key, Value>,
    /// a value that replaces what is given
    varied: Option<(Key, Value)>,
    used: BTreeMap<Key, Used>,
}

/// A value that blocks use.
#[derive(Debug)]
struct Used {
    value: Value,
    by: BTreeSet<Option<&'static str>>,
}

/// Parameters with the ones that they replaced.
const PREDECESSORS: [(Name, Name); 4] = [
    (Name::OscDamping, Name::FilterDamping),
    (Name::VVelocityControlOn, Name::VelocityPositionControlOn),
    (Name::VPositionControlOn, Name::VelocityPositionControlOff),
    (Name::FeedForwardVWeighting, Name::ChangeFeedForwardVWeighting),
];

impl<'a> Effective<'a> {
    pub(crate) fn new(values: &'a Values, home: Place) -> Self {
        let (adopted, used) = (BTreeMap::new(), BTreeMap::new());
        Self { values, home, report: Report::default(), block: None, adopted, varied: None, used }
    }

    /// The same with another value of a parameter.
    pub(crate) fn varied(values: &'a Values, home: Place, other: (Key, Value)) -> Self {
        Self { varied: Some(other), ..Self::new(values, home) }
    }

    /// The values that blocks use, in the order of the table.
    pub(crate) fn used(&self) -> impl Iterator<Item = (Key, &Value)> {
        self.used.iter().map(|(key, used)| (*key, &used.value))
    }

    pub(crate) fn given(&self, key: Key) -> Option<&'a Setting> {
        self.values.get(key)
    }

    /// The value that is given, or the one that replaces it, whether it is allowed or not.
    pub(crate) fn written(&self, key: Key) -> Option<&Value> {
        let varied = self.varied.as_ref().filter(|(varied, _)| *varied == key).map(|(_, other)| other);
        varied.or_else(|| self.given(key)?.value.as_ref())
    }

    /// The parameter that a value comes from: its predecessor, if only that is given.
    pub(crate) fn source(&self, (name, index): Key) -> Key {
        let Some((_, predecessor)) = PREDECESSORS.into_iter().find(|(own, _)| *own == name) else {
            return (name, index);
        };
        let is_given = |name: Name| self.given((name, index)).is_some();
        (if !is_given(name) && is_given(predecessor) { predecessor } else { name }, index)
    }

    pub(crate) fn all_given(&self) -> impl Iterator<Item = (Key, &'a Setting)> + use<'a> {
        self.values.iter()
    }

    /// Replaces the default of a parameter that is not given: with the value of its predecessor, or of a rule.
    pub(crate) fn adopt(&mut self, key: Key, value: Value) {
        self.adopted.insert(key, value);
    }

    /// The place of a parameter; if it is not given that of its stage; else where the axis is named.
    pub(crate) fn place_of(&self, key: Key) -> Place {
        let (name, [i, _]) = key;
        let of_stage = || self.given((Name::Mode, [i, 0])).filter(|_| name.parameter().path.contains("stage[i]"));
        match self.given(key) {
            Some(setting) => setting.value_place(),
            None => of_stage().map_or_else(|| self.home.clone(), Setting::path_place),
        }
    }

    /// The place of a parameter; if a list does not give it, that of the first related one. The home of a list has no
    /// column.
    pub(crate) fn place_near(&self, key: Key, is_about_it: impl Fn(Name) -> bool) -> Place {
        let place = self.place_of(key);
        if place != self.home || place.column > 0 {
            return place;
        }
        let near = self.all_given().find(|((name, _), _)| is_about_it(*name));
        near.map_or(place, |(_, setting)| setting.path_place())
    }

    /// The effective value, validated; it is not added to the canonical form. An error is reported only once.
    pub(crate) fn validated(&mut self, key: Key) -> Option<Value> {
        let parameter = key.0.parameter();
        if self.varied.as_ref().is_some_and(|(varied, _)| *varied == key) {
            return self.written(key).cloned();
        }
        let refused = match self.given(key) {
            Some(setting) => match &setting.value {
                Some(value) if parameter.contains(value) => return Some(value.clone()),
                Some(value) => {
                    let found = format!("{} is {}", self.title(key), value.text());
                    let diagnostic = Diagnostic::error(codes::RANGE, setting.value_place(), found);
                    Some(diagnostic.allowed(parameter.allowed()))
                }
                None => setting.refused.clone(),
            },
            None => {
                if let Some(adopted) = self.adopted.get(&key) {
                    return Some(adopted.clone());
                }
                if let Some(default) = default(key) {
                    return Some(default.clone());
                }
                let text = parameter.default_at(key.1).unwrap_or_default();
                let found = format!("{} is missing; its default {text} is outside of its range", self.title(key));
                let diagnostic = Diagnostic::error(codes::MISSING, self.place_of(key), found);
                let instead = format!("{} with a value", path_with(parameter.path, key.1));
                Some(diagnostic.allowed(parameter.allowed()).instead(instead))
            }
        };
        let unsaid = refused.filter(|refused| !self.report.diagnostics.contains(refused));
        self.report.diagnostics.extend(unsaid);
        None
    }

    /// The effective word, validated; it is not added to the canonical form.
    pub(crate) fn validated_word<T: Words>(&mut self, key: Key) -> Option<T> {
        self.validated(key).map(|value| word_of(key, &value))
    }

    pub(crate) fn validated_words<T: Words>(&mut self, key: Key) -> Option<Vec<T>> {
        let value = self.validated(key)?;
        let Value::Words(words) = value else { wrong_kind(key, &value) };
        Some(words.into_iter().map(|word| word_of(key, &Value::Word(word))).collect())
    }

    pub(crate) fn validated_integer(&mut self, key: Key) -> Option<u32> {
        self.validated(key).and_then(|value| integer_of(key, &value))
    }

    /// The effective word, validated and used.
    pub(crate) fn word<T: Words>(&mut self, key: Key) -> Option<T> {
        self.used_value(key).map(|value| word_of(key, &value))
    }

    /// A word that decides which values of its table are used. If it is refused, all that are given are checked.
    pub(crate) fn deciding_word<T: Words>(&mut self, key: Key) -> Option<T> {
        let word = self.word(key);
        if word.is_none() {
            let path = |(name, index): Key| path_with(name.parameter().path, index);
            let own = path(key);
            let table = &own[..=own.rfind('.').unwrap_or(0)];
            for (given, _) in self.all_given().filter(|(given, _)| path(*given).starts_with(table)) {
                self.validated(given);
            }
        }
        word
    }

    pub(crate) fn integer(&mut self, key: Key) -> Option<u32> {
        self.used_value(key).and_then(|value| integer_of(key, &value))
    }

    /// A whole number that may be negative.
    pub(crate) fn signed(&mut self, key: Key) -> Option<i32> {
        let value = self.used_value(key)?;
        let Value::Integer(n) = value else { wrong_kind(key, &value) };
        i32::try_from(n).ok()
    }

    pub(crate) fn real(&mut self, key: Key) -> Option<f64> {
        let value = self.used_value(key)?;
        let Value::Real(x) = value else { wrong_kind(key, &value) };
        Some(x)
    }

    /// The effective time, in ns, validated and used.
    pub(crate) fn duration(&mut self, key: Key) -> Option<u64> {
        let value = self.used_value(key)?;
        let Value::Duration(ns) = value else { wrong_kind(key, &value) };
        Some(ns)
    }

    fn used_value(&mut self, key: Key) -> Option<Value> {
        let value = self.validated(key)?;
        self.note(key, &value);
        Some(value)
    }

    pub(crate) fn warn(
        &mut self,
        code: &'static str,
        key: Key,
        found: impl Into<String>,
        instead: impl Into<Option<String>>,
    ) {
        let diagnostic = Diagnostic::warning(code, self.place_of(key), found);
        self.report.push(Diagnostic { instead: instead.into(), ..diagnostic });
    }

    pub(crate) fn refuse(
        &mut self,
        code: &'static str,
        key: Key,
        found: impl Into<String>,
        [allowed, instead]: [Option<String>; 2],
    ) {
        let diagnostic = Diagnostic::error(code, self.place_of(key), found);
        self.report.push(Diagnostic { allowed, instead, ..diagnostic });
    }

    /// Path and id of a parameter as given.
    pub(crate) fn title(&self, key: Key) -> String {
        let spelling = self.given(key).map_or(key.0.parameter().path, |setting| setting.spelling);
        key.0.parameter().title(spelling, key.1)
    }

    pub(crate) fn is_used(&self, key: Key) -> bool {
        self.used.contains_key(&key)
    }

    /// Used values that were not given: `vb_max 200000 (P-AXIS-00212)`.
    pub(crate) fn assumed(&self, is_told: impl Fn(Name) -> bool) -> Vec<String> {
        let used = self.used.iter().filter(|(key, _)| is_told(key.0) && self.given(**key).is_none());
        let text = |((name, _), Used { value, .. }): (&Key, &Used)| {
            let parameter = name.parameter();
            format!("{} {} ({})", parameter.short(), value.text(), parameter.id.unwrap_or_default())
        };
        used.map(text).collect()
    }

    /// Adds a value that the block uses to the canonical form.
    pub(crate) fn note(&mut self, key: Key, value: &Value) {
        let unused = || Used { value: value.clone(), by: BTreeSet::new() };
        let used = self.used.entry(key).or_insert_with(unused);
        used.value.clone_from(value);
        used.by.insert(self.block);
    }

    /// The values that all blocks use and that differ from their defaults, one `path value` per line, in the order of the
    /// table, independent of the spelling; and the values that each of some blocks uses. A parameter that is new in this
    /// version does not change the result for a set that does not use it.
    pub(crate) fn canonical<const N: usize>(&self, blocks: [&'static str; N]) -> (String, [String; N]) {
        let mut all = String::new();
        let mut own = [const { String::new() }; N];
        let is_default = |key, used: &Used| default(key).is_some_and(|default| *default == used.value);
        for (key, used) in self.used.iter().filter(|(key, used)| !is_default(**key, used)) {
            let line = line(*key, used);
            for (own, block) in own.iter_mut().zip(blocks) {
                if used.by.contains(&None) || used.by.contains(&Some(block)) {
                    own.push_str(&line);
                }
            }
            all.push_str(&line);
        }
        (all, own)
    }
}

/// The defaults of each parameter as values, in the order of the table.
static DEFAULTS: LazyLock<[Vec<Option<Value>>; Name::ALL.len()]> = LazyLock::new(|| {
    Name::ALL.map(Name::parameter).map(|parameter| {
        let texts = if parameter.default.is_empty() { &[""] } else { parameter.default };
        let read = |text: &&str| value::of_text(parameter, text).ok().filter(|value| parameter.contains(value));
        texts.iter().map(read).collect()
    })
});

/// The default of a parameter; `None` if it has none, or none within its range.
fn default((name, index): Key) -> Option<&'static Value> {
    name.parameter().at(&DEFAULTS[name as usize], index)?.as_ref()
}

fn line((name, index): Key, used: &Used) -> String {
    [&path_with(name.parameter().path, index), " ", &used.value.text(), "\n"].concat()
}

/// The notation of a parameter's word in the file of a message: as a line of a list, or as a key of a set.
pub(crate) fn as_written(place: &Place, (name, index): Key, words: &[&str]) -> String {
    let path = path_with(name.parameter().path, index);
    if !is_in_set(place) {
        return format!("{path} {}", words.join(" or "));
    }
    let words = words.iter().map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(" or ");
    match path.split_once("improved_position_control.stage").and(path.rsplit_once('.')) {
        // Stages and filters are tables.
        Some((table, short)) => format!("{short} = {words} in {table}"),
        None => format!("{path} = {words}"),
    }
}

/// The notation of a parameter's number in the file of a message: as a line of a list, or as a key of a set.
pub(crate) fn number_as_written(place: &Place, (name, index): Key, number: u32) -> String {
    let equals = if is_in_set(place) { " =" } else { "" };
    format!("{}{equals} {number}", path_with(name.parameter().path, index))
}

fn is_in_set(place: &Place) -> bool {
    is_set(Path::new(&place.file))
}

fn word_of<T: Words>(key: Key, value: &Value) -> T {
    let word = if let Value::Word(word) = value { T::named(word) } else { None };
    word.unwrap_or_else(|| wrong_kind(key, value))
}

fn integer_of(key: Key, value: &Value) -> Option<u32> {
    let Value::Integer(n) = value else { wrong_kind(key, value) };
    u32::try_from(*n).ok()
}

/// A rule requests a value of another kind than the table declares.
fn wrong_kind(key: Key, value: &Value) -> ! {
    panic!("check: {key:?} is {value:?}, another kind than the rule expects")
}

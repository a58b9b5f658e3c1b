//! The JSON schema of a set, from the table of parameters, for completion and checks in an editor. It accepts every set that
//! `check` accepts. It rejects what `check` rejects, as far as the place of a value alone decides.

mod pattern;
mod validated;

use crate::parameters::{Kind, Name, Parameter, Scope, Word};
use serde_json::{Map, Value, json};

/// The schema, JSON Schema draft 2020-12, as text.
pub fn text() -> String {
    let mut axis = Node::tree(|parameter| parameter.scope != Scope::Set).schema();
    axis["allOf"] = validated::rules();
    let mut set = Node::tree(|parameter| parameter.scope == Scope::Set).schema();
    set["description"] = json!("A set of axes for axgen");
    set["$schema"] = json!("https://json-schema.org/draft/2020-12/schema");
    set["title"] = json!("axgen set");
    set["properties"]["axis"] = json!({
        "description": "the axes, by name",
        "type": "object",
        "propertyNames": { "pattern": "^[A-Za-z](_?[A-Za-z0-9])*$", "maxLength": 32 },
        "additionalProperties": axis,
        "minProperties": 1,
    });
    set["required"] = json!(["cycle_time", "axis"]);
    format!("{set:#}")
}

#[derive(Default)]
struct Node {
    leaf: Option<Value>,
    children: Vec<(String, Node)>,
    /// the maximum number of tables if it may be an array of tables
    items: Option<u32>,
    /// whether it may also be a single table: an older spelling without an index
    single: bool,
}

impl Node {
    fn tree(chosen: impl Fn(&Parameter) -> bool) -> Self {
        let mut root = Self::default();
        for parameter in Name::ALL.map(Name::parameter).into_iter().filter(|parameter| chosen(parameter)) {
            parameter.paths().for_each(|path| root.enter(path, parameter));
        }
        root
    }

    fn enter(&mut self, path: &str, parameter: &Parameter) {
        let (mut node, mut indices) = (self, parameter.indices.iter());
        for part in path.split('.') {
            let (name, is_indexed) = part.split_once('[').map_or((part, false), |(name, _)| (name, true));
            let position = node.children.iter().position(|(known, _)| known == name);
            let position = position.unwrap_or_else(|| {
                node.children.push((name.to_owned(), Self::default()));
                node.children.len() - 1
            });
            node = &mut node.children[position].1;
            if is_indexed {
                node.items = indices.next().copied().or(node.items);
            } else if path != parameter.path {
                node.single = true;
            }
        }
        node.single = false;
        // If other values decide whether a value is used, its range is only described.
        let is_always_validated = !parameter.is_shared && parameter.indices.is_empty();
        let mut leaf = leaf(parameter, is_always_validated);
        leaf["description"] = json!(description(parameter));
        node.leaf = Some(leaf);
    }

    fn schema(&self) -> Value {
        if let Some(leaf) = &self.leaf {
            return leaf.clone();
        }
        let properties: Map<_, _> = self.children.iter().map(|(name, child)| (name.clone(), child.schema())).collect();
        let table = json!({ "type": "object", "properties": properties, "additionalProperties": false });
        match self.items {
            Some(count) if self.single => {
                json!({ "anyOf": [{ "type": "array", "items": table, "minItems": 1, "maxItems": count }, table] })
            }
            Some(count) => json!({ "type": "array", "items": table, "minItems": 1, "maxItems": count }),
            None => table,
        }
    }
}

fn description(parameter: &Parameter) -> String {
    let of_vendor = parameter.id.map_or_else(String::new, |id| {
        let comma = if parameter.data_type.is_empty() { "" } else { ", " };
        format!(" ({id}{comma}{})", parameter.data_type)
    });
    let is_number = matches!(parameter.kind, Kind::Integer { .. } | Kind::Real { .. });
    let range = if is_number { format!(": {}", parameter.allowed()) } else { String::new() };
    format!("{}{of_vendor}{range}", parameter.meaning)
}

/// The allowed values; without the range if it is not validated. A default outside the range means that there is no default.
fn leaf(parameter: &Parameter, is_validated: bool) -> Value {
    match parameter.kind {
        Kind::Word(all) => words(all),
        Kind::Words(all) => json!({ "type": "array", "items": words(all), "uniqueItems": true }),
        Kind::Flags(all) => json!({ "anyOf": [
            { "type": "string", "enum": all.iter().map(|word| word.name).collect::<Vec<_>>() },
            { "type": "string", "pattern": pattern::of_flags(all) },
            { "type": "integer", "enum": pattern::sums(all) },
        ] }),
        Kind::Integer { from, to } if is_validated => json!({ "type": "integer", "minimum": from, "maximum": to }),
        Kind::Integer { .. } => json!({ "type": "integer" }),
        Kind::Real { from, to, open: [above, below] } if is_validated => {
            let low = if above { "exclusiveMinimum" } else { "minimum" };
            let high = if below { "exclusiveMaximum" } else { "maximum" };
            json!({ "type": "number", low: from, high: to })
        }
        Kind::Real { .. } => json!({ "type": "number" }),
        Kind::Duration { from, to } => json!({ "type": "string", "pattern": pattern::of_duration(from, to) }),
        Kind::Text => json!({ "type": "string" }),
    }
}

/// One of the words: in the spelling that an editor completes, in any case, or by its number.
fn words<'w>(words: impl IntoIterator<Item = &'w Word>) -> Value {
    let words: Vec<&Word> = words.into_iter().collect();
    let spellings: Vec<&str> = words.iter().flat_map(|word| word.spellings()).collect();
    let mut choices = vec![
        json!({ "type": "string", "enum": spellings }),
        json!({ "type": "string", "pattern": pattern::of_words(&words) }),
    ];
    let numbers: Vec<u32> = words.iter().filter_map(|word| word.number).collect();
    if !numbers.is_empty() {
        choices.push(json!({ "type": "integer", "enum": numbers }));
    }
    let words_of = [("FALSE", false), ("TRUE", true)];
    let booleans = words_of.iter().filter(|(word, _)| spellings.contains(word));
    let booleans: Vec<bool> = booleans.map(|(_, boolean)| *boolean).collect();
    if !booleans.is_empty() {
        choices.push(json!({ "enum": booleans }));
    }
    json!({ "anyOf": choices })
}

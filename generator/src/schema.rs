//! The JSON schema of a set, from the table of parameters: what an editor completes and checks as one types.

use crate::parameters::{Bound, Kind, Name, Parameter, Scope, Word};
use serde_json::{Map, Value, json};

/// The schema, JSON Schema draft 2020-12, as text.
#[must_use]
pub fn text() -> String {
    let axis = Node::of(|parameter| parameter.scope != Scope::Set).schema();
    let mut set = Node::of(|parameter| parameter.scope == Scope::Set);
    set.description = "A set of axes for axgen".to_owned();
    let mut set = set.schema();
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

/// A place in the tree of keys.
#[derive(Default)]
struct Node {
    description: String,
    /// what a value may be
    leaf: Option<Value>,
    /// the keys below it
    children: Vec<(String, Node)>,
    /// whether it may be given as an array of tables, and how many
    items: Option<u32>,
    /// whether it may also be given as a single table: an older spelling without an index
    single: bool,
}

impl Node {
    /// The tree of the parameters that are chosen.
    fn of(chosen: impl Fn(&Parameter) -> bool) -> Self {
        let mut root = Self::default();
        for parameter in Name::ALL.map(Name::parameter).into_iter().filter(|parameter| chosen(parameter)) {
            for path in [parameter.path].into_iter().chain(parameter.aliases.iter().copied()) {
                root.enter(path, parameter);
            }
        }
        root
    }

    /// Enters a parameter at a path.
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
        node.leaf = Some(leaf(parameter));
        node.description = parameter.id.map_or_else(
            || parameter.meaning.to_owned(),
            |id| format!("{} ({id}){}", parameter.meaning, in_unit(parameter.unit)),
        );
    }

    fn schema(&self) -> Value {
        if let Some(leaf) = &self.leaf {
            let mut leaf = leaf.clone();
            leaf["description"] = json!(self.description);
            return leaf;
        }
        let mut properties = Map::new();
        for (name, child) in &self.children {
            properties.insert(name.clone(), child.schema());
        }
        let mut table = json!({ "type": "object", "properties": properties, "additionalProperties": false });
        if !self.description.is_empty() {
            table["description"] = json!(self.description);
        }
        match self.items {
            Some(count) if self.single => {
                json!({ "anyOf": [{ "type": "array", "items": table, "maxItems": count }, table] })
            }
            Some(count) => json!({ "type": "array", "items": table, "maxItems": count }),
            None => table,
        }
    }
}

/// What a value may be. A default outside of the range means that there is none.
fn leaf(parameter: &Parameter) -> Value {
    match parameter.kind {
        Kind::Word(words) => {
            let numbers: Vec<u32> = words.iter().filter_map(|word| word.number).collect();
            let has_booleans = words.iter().any(|word| word.name == "TRUE" || word.also.contains(&"TRUE"));
            let mut choices = vec![json!({ "type": "string", "enum": spellings(words) })];
            if !numbers.is_empty() {
                choices.push(json!({ "type": "integer", "enum": numbers }));
            }
            if has_booleans {
                choices.push(json!({ "type": "boolean" }));
            }
            json!({ "anyOf": choices })
        }
        Kind::Words(words) => {
            json!({ "type": "array", "items": { "type": "string", "enum": spellings(words) }, "uniqueItems": true })
        }
        Kind::Flags(_) => json!({ "anyOf": [{ "type": "string" }, { "type": "integer", "minimum": 0 }] }),
        Kind::Integer { from, to } => json!({ "type": "integer", "minimum": from, "maximum": to }),
        Kind::Real { from, to } => {
            let (low, from) = match from {
                Bound::Open(end) => ("exclusiveMinimum", end),
                Bound::Closed(end) => ("minimum", end),
            };
            let (high, to) = match to {
                Bound::Open(end) => ("exclusiveMaximum", end),
                Bound::Closed(end) => ("maximum", end),
            };
            json!({ "type": "number", low: from, high: to })
        }
        Kind::Duration { .. } => json!({ "type": "string", "pattern": "^[0-9.]+ ?(s|ms|us|ns)$" }),
        Kind::Text => json!({ "type": "string" }),
    }
}

/// Every spelling of the words; a set takes any case, an editor completes these.
fn spellings(words: &[Word]) -> Vec<&str> {
    words.iter().flat_map(|word| std::iter::once(word.name).chain(word.also.iter().copied())).collect()
}

fn in_unit(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" [{unit}]") }
}

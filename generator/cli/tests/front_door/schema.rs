//! JSON Schema, as far as the schema of a set uses it. An unknown keyword is a panic: nothing is passed over.

use serde_json::Value;

/// The first place where a value is not what the schema allows.
pub fn mistake(schema: &Value, value: &Value, at: &str) -> Option<String> {
    let keywords = schema.as_object().expect("a schema is an object");
    keywords.iter().find_map(|(keyword, rule)| match keyword.as_str() {
        "$schema" | "title" | "description" | "properties" => None,
        "type" => (!is_of(value, rule.as_str()?)).then(|| format!("{at}: {value} is no {rule}")),
        "enum" => (!rule.as_array()?.contains(value)).then(|| format!("{at}: {value} is none of {rule}")),
        "minimum" => number(value).filter(|x| *x < limit(rule)).map(|x| format!("{at}: {x} < {rule}")),
        "maximum" => number(value).filter(|x| *x > limit(rule)).map(|x| format!("{at}: {x} > {rule}")),
        "exclusiveMinimum" => number(value).filter(|x| *x <= limit(rule)).map(|x| format!("{at}: {x} <= {rule}")),
        "exclusiveMaximum" => number(value).filter(|x| *x >= limit(rule)).map(|x| format!("{at}: {x} >= {rule}")),
        "anyOf" => {
            let all: Option<Vec<String>> = rule.as_array()?.iter().map(|rule| mistake(rule, value, at)).collect();
            all.map(|all| all.join(" | "))
        }
        "items" => value.as_array()?.iter().find_map(|item| mistake(rule, item, &format!("{at}[]"))),
        "maxItems" => (value.as_array()?.len() as u64 > rule.as_u64()?).then(|| format!("{at}: too many")),
        "uniqueItems" => {
            let items = value.as_array()?;
            let twice = items.iter().enumerate().any(|(position, item)| items[..position].contains(item));
            twice.then(|| format!("{at}: twice"))
        }
        "required" => {
            let missing = rule.as_array()?.iter().find(|key| value.get(key.as_str().unwrap_or_default()).is_none());
            missing.map(|key| format!("{at}: no {key}"))
        }
        "minProperties" => ((value.as_object()?.len() as u64) < rule.as_u64()?).then(|| format!("{at}: too few")),
        "propertyNames" => value.as_object()?.keys().find_map(|key| mistake(rule, &Value::String(key.clone()), at)),
        "maxLength" => (value.as_str()?.len() as u64 > rule.as_u64()?).then(|| format!("{at}: too long")),
        "pattern" => (!fits(value.as_str()?, rule.as_str()?)).then(|| format!("{at}: {value} is not as {rule}")),
        "additionalProperties" => properties(schema, rule, value, at),
        other => panic!("the schema has a keyword that this test does not know: {other}"),
    })
}

/// Every key of a table by its rule, or by the rule for all others.
fn properties(schema: &Value, others: &Value, value: &Value, at: &str) -> Option<String> {
    value.as_object()?.iter().find_map(|(key, value)| {
        let at = format!("{at}.{key}");
        match (schema.get("properties").and_then(|properties| properties.get(key)), others) {
            (Some(rule), _) => mistake(rule, value, &at),
            (None, Value::Bool(false)) => Some(format!("{at} is not known")),
            (None, rule) => mistake(rule, value, &at),
        }
    })
}

fn is_of(value: &Value, ty: &str) -> bool {
    match ty {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        other => panic!("the schema has a type that this test does not know: {other}"),
    }
}

fn number(value: &Value) -> Option<f64> {
    value.as_f64()
}

fn limit(rule: &Value) -> f64 {
    rule.as_f64().expect("a limit is a number")
}

/// The two patterns that the schema has.
fn fits(text: &str, pattern: &str) -> bool {
    match pattern {
        "^[A-Za-z](_?[A-Za-z0-9])*$" => {
            let plain = text.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
            let ends = text.starts_with(|c: char| c.is_ascii_alphabetic()) && !text.ends_with('_');
            plain && ends && !text.contains("__")
        }
        "^[0-9.]+ ?(s|ms|us|ns)$" => {
            let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic()).trim_end();
            !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.')
        }
        other => panic!("the schema has a pattern that this test does not know: {other}"),
    }
}

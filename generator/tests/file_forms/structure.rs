//! Checks a tree of elements against a table: which attributes an element has, and which elements in which order.

use super::xml::Element;

pub struct Rule {
    pub element: &'static str,
    /// its attributes: all of them have to be there
    pub attributes: &'static [Attribute],
    /// attributes that may be missing
    pub perhaps: &'static [Attribute],
    /// what is inside it
    pub inside: Inside,
}

/// The name of an attribute, and whether a value is right.
pub type Attribute = (&'static str, fn(&str) -> bool);

/// An element without attributes that may be missing.
pub const fn rule(element: &'static str, attributes: &'static [Attribute], inside: Inside) -> Rule {
    Rule { element, attributes, perhaps: &[], inside }
}

/// What is inside an element.
pub enum Inside {
    Nothing,
    Text,
    /// elements in this order: one of these names, so often
    Elements(&'static [(&'static [&'static str], Times)]),
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Times {
    Once,
    Perhaps,
    Any,
    Some,
}

/// Whether a value is any at all.
pub fn any(_: &str) -> bool {
    true
}

/// What the table does not allow.
pub fn faults(rules: &[Rule], element: &Element) -> Vec<String> {
    let name = &element.name;
    let Some(rule) = rules.iter().find(|rule| rule.element == name) else { return vec![format!("<{name}>")] };
    let mut faults = Vec::new();
    let is_there = |key: &str| element.attributes.iter().any(|(found, _)| found == key);
    let missing = rule.attributes.iter().filter(|(key, _)| !is_there(key));
    faults.extend(missing.map(|(key, _)| format!("<{name}> without {key}")));
    for (key, value) in &element.attributes {
        match rule.attributes.iter().chain(rule.perhaps).find(|(known, _)| known == key) {
            None => faults.push(format!("<{name} {key}>")),
            Some((_, is_right)) if !is_right(value) => faults.push(format!("<{name} {key}=\"{value}\">")),
            Some(_) => {}
        }
    }
    if !matches!(rule.inside, Inside::Text) && !element.text.trim().is_empty() {
        faults.push(format!("text in <{name}>: {}", element.text.trim()));
    }
    let parts: &[(&[&str], Times)] = if let Inside::Elements(parts) = rule.inside { parts } else { &[] };
    faults.extend(order(parts, element));
    faults.extend(element.children.iter().flat_map(|child| self::faults(rules, child)));
    faults
}

/// What is wrong with the order of the elements inside one.
fn order(parts: &[(&[&str], Times)], element: &Element) -> Vec<String> {
    let mut faults = Vec::new();
    let mut children = element.children.iter().map(|child| child.name.as_str()).peekable();
    for (names, times) in parts {
        let most = if matches!(times, Times::Once | Times::Perhaps) { 1 } else { usize::MAX };
        let mut count = 0;
        while count < most && children.next_if(|child| names.contains(child)).is_some() {
            count += 1;
        }
        if count == 0 && matches!(times, Times::Once | Times::Some) {
            faults.push(format!("<{}> without <{}>", element.name, names.join("|")));
        }
    }
    faults.extend(children.map(|child| format!("<{child}> at this place in <{}>", element.name)));
    faults
}

#[test]
fn what_the_table_does_not_allow_is_found() {
    const RULES: [Rule; 3] = [
        rule(
            "a",
            &[("x", |value| value == "1")],
            Inside::Elements(&[(&["b"], Times::Once), (&["c"], Times::Perhaps), (&["b", "c"], Times::Any)]),
        ),
        Rule { perhaps: &[("z", |value| value == "1")], ..rule("b", &[], Inside::Text) },
        rule("c", &[], Inside::Nothing),
    ];
    let found = |text: &str| faults(&RULES, &super::xml::read(text).unwrap()).join(", ");
    for (text, fault) in [
        ("<a x='1'><b>t</b><c/><c/><b/></a>", ""),
        ("<a x='1'> <b z='1'/> </a>", ""),
        ("<a x='1'> <b z='2'/> </a>", "<b z=\"2\">"),
        ("<a><b/></a>", "<a> without x"),
        ("<a x='2'><b/></a>", "<a x=\"2\">"),
        ("<a x='1' y=''><b/></a>", "<a y>"),
        ("<a x='1'/>", "<a> without <b>"),
        ("<a x='1'>t<b/></a>", "text in <a>: t"),
        ("<a x='1'><b/><d/></a>", "<d> at this place in <a>, <d>"),
        ("<a x='1'><c/><b/></a>", "<a> without <b>"),
        ("<a x='1'><b><c/></b></a>", "<c> at this place in <b>"),
        ("<a x='1'><b/><c>t</c></a>", "text in <c>: t"),
        ("<d/>", "<d>"),
    ] {
        assert_eq!(found(text), fault, "{text}");
    }
}

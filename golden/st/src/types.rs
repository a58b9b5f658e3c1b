//! `TYPE x : STRUCT ... END_STRUCT END_TYPE` -> a structure: its parts with their types and start values.

use super::kind::Kind;
use super::known::Known;
use super::mistake::Mistakes;
use super::structure::{Part, Structure};
use super::syntax::{children, said, shown};
use super::{Dialect, constant, names};
use portable::RealKind;
use tree_sitter::Node;

/// The data for the declaration of a structure.
pub(crate) struct Place<'a> {
    pub(crate) text: &'a str,
    /// the form of the file
    pub(crate) dialect: Dialect,
    /// the type of its reals
    pub(crate) real: RealKind,
    /// previous declarations
    pub(crate) known: Known<'a>,
}

impl Place<'_> {
    /// The structure that a node declares; `None` after a reported error.
    pub(crate) fn structure(&self, node: Node<'_>, mistakes: &mut Mistakes<'_>) -> Option<Structure> {
        let definition = children(node).into_iter().find(|(part, _)| part.kind() == "type_definition");
        let structure = definition.and_then(|(definition, _)| {
            let fields = definition.child_by_field_name("definition")?;
            let name = said(definition.child_by_field_name("name")?, self.text);
            (fields.kind() == "structure_type_inline").then(|| self.parts(name, fields, mistakes))
        });
        if structure.is_none() {
            let instead = "`TYPE x : STRUCT ... END_STRUCT END_TYPE`";
            mistakes.push(node.start_byte(), shown(node, self.text), instead);
        }
        structure
    }

    fn parts(&self, name: &str, fields: Node<'_>, mistakes: &mut Mistakes<'_>) -> Structure {
        let mut parts: Vec<Part> = Vec::new();
        for (field, _) in children(fields).into_iter().filter(|(part, _)| part.kind() == "structure_field") {
            let (Some(own), Some(ty)) = (field.child_by_field_name("name"), field.child_by_field_name("type")) else {
                continue;
            };
            if let Some((found, instead)) = names::mistake(self.dialect, said(own, self.text))
                && !self.known.is_program
            {
                mistakes.push(own.start_byte(), found, instead);
            }
            let (own, word) = (said(own, self.text), said(ty, self.text));
            if parts.iter().any(|part| part.path.eq_ignore_ascii_case(own)) {
                mistakes.push(field.start_byte(), format!("a second part `{own}`"), "another name");
            }
            let inside = self.known.structures.iter().find(|of| of.name.eq_ignore_ascii_case(word));
            let kind = if self.known.is_program { Kind::of_program } else { Kind::of }(word, self.real);
            match (kind, inside) {
                (Some(kind), _) => {
                    let start = field.child_by_field_name("default");
                    let place = (self.dialect, self.real);
                    let start = start.and_then(|start| constant::initial(place, start, self.text, kind, mistakes));
                    // Some compilers of the plain form ignore it.
                    let start = start.filter(|_| self.dialect != Dialect::Plain);
                    parts.push(Part { path: own.to_owned(), kind, start });
                }
                (None, Some(inside)) => {
                    let within = |part: &Part| Part { path: format!("{own}.{}", part.path), ..*part };
                    parts.extend(inside.parts.iter().map(within));
                }
                (None, None) => {
                    let instead = "a type of a variable, or a structure of a file before this one";
                    mistakes.push(ty.start_byte(), format!("the type {}", shown(ty, self.text)), instead);
                }
            }
        }
        Structure { name: name.to_owned(), parts }
    }
}

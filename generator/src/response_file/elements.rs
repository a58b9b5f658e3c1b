//! The elements of a SINUMERIK measurement: by their names, with their places; arrays and spectra. The meaning of the
//! signals is not known here.

use super::Said;
use super::base85::{self, At};
use crate::codes;
use crate::diagnostics::{Diagnostic, Report};
use roxmltree::{Document, Node};
use stability::Complex64;

pub(super) const WHAT: &str = "a SINUMERIK frequency response measurement with its spectra, or a table as text";
pub(super) const EXPORT: &str =
    "the file that the frequency response measurement saves, as it is, or its curve as a table: f [Hz];re;im;coherence";

/// A document, with the collector of messages about it.
pub(super) struct Elements<'a, 'i> {
    pub document: &'a Document<'i>,
    pub said: &'a Said<'a>,
}

/// A spectrum: of one signal with itself, or with another one.
pub(super) struct Spectrum {
    pub hz: Vec<At>,
    pub values: Vec<Complex64>,
    /// number of averaged spectra
    pub averages: f64,
    /// its line in the file
    pub line: usize,
}

/// The children with this name.
fn named<'a, 'i>(of: Node<'a, 'i>, element: &str, name: &str) -> impl Iterator<Item = Node<'a, 'i>> {
    of.children().filter(move |node| node.has_tag_name(element) && node.attribute("name") == Some(name))
}

/// The text of a child, if there is one, without blanks around it.
pub(super) fn text_of<'a>(of: Node<'a, '_>, element: &str, name: &str) -> Option<&'a str> {
    named(of, element, name).next().map(|node| node.text().unwrap_or_default().trim())
}

impl<'a, 'i> Elements<'a, 'i> {
    /// A message about an element.
    pub(super) fn wrong(&self, code: &'static str, node: Node<'_, '_>, found: impl Into<String>) -> Diagnostic {
        let at = self.document.text_pos_at(node.range().start);
        self.said.error(code, [at.row as usize, at.col as usize], found).instead(EXPORT)
    }

    /// A message about a missing element that a measurement always has.
    pub(super) fn lacks(&self, node: Node<'_, '_>, found: impl Into<String>) -> Diagnostic {
        self.wrong(codes::RESPONSE_TABLE, node, found).allowed(WHAT)
    }

    pub(super) fn child(&self, of: Node<'a, 'i>, element: &str, name: &str) -> Result<Node<'a, 'i>, Report> {
        let mut found = named(of, element, name);
        match (found.next(), found.next()) {
            (Some(node), None) => Ok(node),
            (None, _) => Err(self.lacks(of, format!("no element `{element}` with the name `{name}`")).into()),
            (_, Some(second)) => Err(self.lacks(second, format!("`{name}` a second time")).into()),
        }
    }

    pub(super) fn text(&self, of: Node<'a, 'i>, element: &str, name: &str) -> Result<&'a str, Report> {
        Ok(self.child(of, element, name)?.text().unwrap_or_default().trim())
    }

    /// The spectrum of a `SigNodeCrossSpectrumInfo`.
    pub(super) fn spectrum(&self, info: Node<'a, 'i>) -> Result<Spectrum, Report> {
        let count = self.text(info, "unsigned_int", "m_uNumSpectraInAvg")?;
        let Some(averages) = count.parse::<u32>().ok().filter(|count| *count > 0) else {
            let found = format!("m_uNumSpectraInAvg is `{}`", count.escape_default());
            return Err(self.wrong(codes::RESPONSE_CELL, info, found).allowed("1 or more").into());
        };
        let spectrum = self.child(info, "CrossSpectrum", "m_avgCrossSpec")?;
        let hz = self.array(spectrum, "m_FrequencyVector", "double", 1)?;
        let values = self.array(spectrum, "m_ValueVector", "ComplexNumber", 2)?;
        if values.len() != 2 * hz.len() {
            let found = format!("{} values for {} frequencies", values.len() / 2, hz.len());
            return Err(self
                .wrong(codes::RESPONSE_CELLS, spectrum, found)
                .allowed("a value for each frequency")
                .into());
        }
        let values = values.as_chunks::<2>().0.iter().map(|[re, im]| Complex64::new(re.1, im.1)).collect();
        let line = self.document.text_pos_at(spectrum.range().start).row as usize;
        Ok(Spectrum { hz, values, averages: f64::from(averages), line })
    }

    /// The finite numbers of an array, `parts` for each of its values.
    fn array(&self, of: Node<'a, 'i>, name: &str, kind: &str, parts: usize) -> Result<Vec<At>, Report> {
        let array = self.child(of, "NumericArray", name)?;
        let written = ["elementtype", "format"].map(|name| array.attribute(name).unwrap_or_default());
        if written != [kind, "base85"] {
            let found =
                format!("{name} has {}", written.map(|word| format!("`{}`", word.escape_default())).join(" as "));
            return Err(self.lacks(array, found).allowed(format!("`{kind}` as `base85`")).into());
        }
        let raw = self.child(array, "raw", "m_pNumberArray")?;
        let first = self.document.text_pos_at(raw.range().start).row as usize;
        let cell = |line, found: String| {
            let said = self.said.error(codes::RESPONSE_CELL, [line, 0], format!("{name}: {found}"));
            said.allowed("finite numbers in double precision, as base 85").instead(EXPORT)
        };
        let numbers =
            base85::doubles(raw.text().unwrap_or_default(), first).map_err(|(line, found)| cell(line, found))?;
        if let Some((line, number)) = numbers.iter().find(|(_, number)| !number.is_finite()) {
            return Err(cell(*line, format!("{number} is not a finite number")).into());
        }
        let length = self.text(array, "unsigned_int", "m_length")?;
        if length.parse::<usize>().ok().and_then(|length| length.checked_mul(parts)) != Some(numbers.len()) {
            let found = format!("{name} has {} numbers, its m_length is {}", numbers.len(), length.escape_default());
            let allowed = format!("{parts} for each of its values");
            return Err(self.wrong(codes::RESPONSE_CELLS, array, found).allowed(allowed).into());
        }
        Ok(numbers)
    }
}

//! The XML file of a frequency response measurement of SINUMERIK -> its lines, or the reason why it cannot be read. It
//! contains spectra instead of a response:
//!
//! ```text
//! S_ab = mean of conj(A) B             the cross spectrum in the list of node a, with the id of node b
//! P = S_uy/S_uu                        u, y: the input and the output of the measurement
//! coherence = |S_uy|^2/(S_uu S_yy)     from averaged spectra; for a single spectrum it is always 1
//! ```
//!
//! In a real file, whose output lags its input, the first factor is the conjugate (a wrong sign of the phase is also
//! detected later). Ids of nodes and of units are numbers without a public meaning: the set states the input of the
//! response.

use super::columns::Unit;
use super::elements::{EXPORT, Elements, Spectrum, WHAT, text_of};
use super::numbers::{Columns, Line, Used, Value};
use super::order::hz;
use super::{Reading, Said};
use crate::codes;
use crate::diagnostics::{Diagnostic, Report};
use crate::xml;
use portable::Extreme;
use roxmltree::Node;

/// Rounding error of a coherence.
const ROUNDED: f64 = 1e-9;

/// A signal: the number in the spectra is that of its kind, not of its element.
struct Signal<'a, 'i> {
    node: Node<'a, 'i>,
    /// kind and axis
    id: [&'a str; 2],
}

pub(super) fn is_xml(text: &str) -> bool {
    text.trim_start().starts_with('<')
}

pub(super) fn read(text: &str, said: &Said<'_>) -> Result<Reading<'static>, Report> {
    let document = xml::parse(text.trim_start()).map_err(|xml::Refused { found, place }| {
        let place = place.map_or([0, 0], |(line, column)| [line, column]);
        said.error(codes::RESPONSE_TABLE, place, found).allowed(WHAT).instead(EXPORT)
    })?;
    let elements = Elements { document: &document, said };
    let root = document.root_element();
    if !root.has_tag_name("ResponseTestCustom") {
        return Err(another(&elements, root).into());
    }
    let [input, output] = pair(&elements, root)?;
    let auto = |of: &Signal<'_, '_>| {
        let info = elements.child(of.node, "SigNodeCrossSpectrumInfo", "m_autospectrumInfo");
        elements.spectrum(info.map_err(|_| without_spectra(&elements, of.node))?)
    };
    let powers = [auto(&input)?, auto(&output)?];
    let cross = cross(&elements, &input, &output)?;
    let lines = lines(&powers, &cross, said)?;
    let used = |name, unit| Used { index: 0, name, place: [cross.line, 0], unit };
    let frequency = used("m_FrequencyVector", Some(Unit::Hertz));
    let value = Value::Parts([used("m_avgCrossSpec", None), used("m_avgCrossSpec", None)]);
    let columns = Columns { frequency, value, coherence: None, error: None, averages: None };
    let without_errors = (cross.averages < 2.0).then(|| {
        let found = "one spectrum, not the mean of several: the response counts as exact";
        let instead = "a measurement in both directions: its file has two";
        said.warning(codes::WITHOUT_ERRORS, [cross.line, 0], found).instead(instead)
    });
    Ok(Reading { lines, columns, without_errors })
}

/// The message for another file of SINUMERIK, or for any other file.
fn another(elements: &Elements<'_, '_>, root: Node<'_, '_>) -> Diagnostic {
    let has = |name: &str| root.descendants().any(|node| node.has_tag_name(name));
    let found = if has("traceData") {
        "a trace of signals over time: no response is estimated from it".to_owned()
    } else if has("DynamicModelPositionController840DSL") {
        "the result of an automatic tuning, not a measurement".to_owned()
    } else {
        format!("XML with the element `{}`", root.tag_name().name().escape_default())
    };
    elements.lacks(root, found)
}

fn without_spectra(elements: &Elements<'_, '_>, node: Node<'_, '_>) -> Diagnostic {
    let is_over_time = node.descendants().any(|node| node.has_tag_name("TimeSeries"));
    let what = if is_over_time { "signals over time without their spectra" } else { "a signal without its spectra" };
    elements.lacks(node, what)
}

/// The input and the output of the only response of the measurement.
fn pair<'a, 'i>(elements: &Elements<'a, 'i>, root: Node<'a, 'i>) -> Result<[Signal<'a, 'i>; 2], Report> {
    let list = elements.child(root, "LinkedList", "m_listPrimaryFreqRespSigNodeData")?;
    let pairs: Vec<Node<'a, 'i>> = list.children().filter(Node::is_element).collect();
    let [pair] = pairs[..] else {
        let found = format!("{} pairs of an input and an output", pairs.len());
        let said = elements.wrong(codes::TWO_COLUMNS, list, found).allowed("one pair");
        return Err(said.instead("a measurement of one response, to the velocity of the motor").into());
    };
    let nodes = elements.child(root, "LinkedList", "m_MeasurementSignalNodeList")?;
    let nodes: Vec<Node<'a, 'i>> = nodes.children().filter(Node::is_element).collect();
    let id = |node: Node<'a, 'i>| ["m_uNodeId", "m_uAxis"].map(|name| text_of(node, "unsigned_int", name));
    let signal = |name: &str| {
        let instance = elements.text(pair, "integer", name)?;
        let is_it = |node: &Node<'a, 'i>| text_of(*node, "integer", "m_iUniqueInstanceId") == Some(instance);
        let of: Vec<Node<'a, 'i>> = nodes.iter().copied().filter(is_it).collect();
        let [node] = of[..] else {
            return Err(Report::from(elements.lacks(pair, format!("{name}: {} signals with this number", of.len()))));
        };
        let [Some(kind), Some(axis)] = id(node) else {
            return Err(Report::from(elements.lacks(node, "a signal without m_uNodeId and m_uAxis")));
        };
        if nodes.iter().filter(|other| id(**other) == id(node)).count() > 1 {
            return Err(Report::from(
                elements.lacks(node, "two signals of one m_uNodeId and m_uAxis: their spectra look alike"),
            ));
        }
        as_measured(elements, node)?;
        Ok(Signal { node, id: [kind, axis] })
    };
    Ok([signal("m_iInputSigNodeUniqueInstanceID")?, signal("m_iOutputSigNodeUniqueInstanceID")?])
}

/// Checks that the measurement contains no setting that changes a signal: it is unknown whether its spectra include it.
fn as_measured<'a, 'i>(elements: &Elements<'a, 'i>, node: Node<'a, 'i>) -> Result<(), Report> {
    let distortion = elements.child(node, "TransferFunction", "m_MeasurementLinearDistortion")?;
    let changed = |found: String, neutral: f64| {
        let said = elements.wrong(
            codes::RESPONSE_UNIT,
            distortion,
            format!("{found}: whether the spectra contain it is unknown"),
        );
        Err(said.allowed(format!("{neutral}")).instead("the curve as a table: f [Hz];re;im;coherence").into())
    };
    for (name, neutral) in [("m_GainValue_real", 1.0), ("m_GainValue_imag", 0.0), ("m_TimeDelay", 0.0)] {
        let text = elements.text(distortion, "float", name)?;
        if text.parse() != Ok(neutral) {
            return changed(format!("{name} of a signal is `{}`", text.escape_default()), neutral);
        }
    }
    for name in ["m_PolesVector", "m_ZerosVector"] {
        let length = elements.text(elements.child(distortion, "NumericArray", name)?, "unsigned_int", "m_length")?;
        if length != "0" {
            return changed(format!("{name} of a signal has `{}` values", length.escape_default()), 0.0);
        }
    }
    Ok(())
}

/// S_uy, which may be in the list of either signal.
fn cross<'a, 'i>(
    elements: &Elements<'a, 'i>,
    input: &Signal<'a, 'i>,
    output: &Signal<'a, 'i>,
) -> Result<Spectrum, Report> {
    let of = |from: &Signal<'a, 'i>, to: &Signal<'a, 'i>| {
        let list = elements.child(from.node, "LinkedList", "m_crossSpecInfoList").ok()?;
        let id = |node: &Node<'a, 'i>| ["m_uSignodeId", "m_uAxisId"].map(|name| text_of(*node, "unsigned_int", name));
        list.children().find(|node| id(node) == to.id.map(Some))
    };
    match (of(input, output), of(output, input)) {
        (Some(info), _) => elements.spectrum(info),
        (None, Some(info)) => {
            let mut spectrum = elements.spectrum(info)?;
            spectrum.values.iter_mut().for_each(|value| *value = value.conj());
            Ok(spectrum)
        }
        (None, None) => Err(without_spectra(elements, output.node).into()),
    }
}

/// The lines of the response, without the line at 0 Hz, which is a mean value.
fn lines(powers: &[Spectrum; 2], cross: &Spectrum, said: &Said<'_>) -> Result<Vec<Line>, Report> {
    let wrong = |code, line, found: String, allowed: &str| {
        Err(said.error(code, [line, 0], found).allowed(allowed).instead(EXPORT).into())
    };
    let key = |of: &Spectrum| (of.averages.to_bits(), of.hz.iter().map(|(_, hz)| hz.to_bits()).collect::<Vec<_>>());
    if let Some(other) = powers.iter().find(|other| key(other) != key(cross)) {
        let found = "a spectrum of other frequencies, or another number of averages, than the cross spectrum";
        return wrong(codes::RESPONSE_CELLS, other.line, found.to_owned(), "the spectra of one measurement");
    }
    let is_mean = cross.averages >= 2.0;
    let mut lines = Vec::with_capacity(cross.hz.len());
    for (n, (line, f)) in cross.hz.iter().enumerate().filter(|(_, (_, f))| f.abs() > 0.0) {
        let [uu, yy] = [0, 1].map(|signal: usize| powers[signal].values[n]);
        if uu.re <= 0.0 || yy.re <= 0.0 || uu.im.abs() + yy.im.abs() > 0.0 {
            let found = format!("the power of a signal at {} Hz is {}", hz(*f), if uu.re <= 0.0 { uu } else { yy });
            return wrong(codes::RESPONSE_CELL, *line, found, "a real number above 0");
        }
        let p = cross.values[n] / uu.re;
        let coherence = p.norm_sqr() * uu.re / yy.re;
        if coherence.is_nan() || coherence > 1.0 + ROUNDED {
            let found = format!("|S_uy|^2/(S_uu S_yy) is {coherence} at {} Hz", hz(*f));
            return wrong(codes::COHERENCE, *line, found, "a coherence of 0 to 1");
        }
        lines.push(Line {
            line: *line,
            hz: *f,
            columns: [0; 3],
            value: [p.re, p.im],
            coherence: is_mean.then(|| coherence.smaller(1.0)),
            error: None,
            averages: is_mean.then_some(cross.averages),
        });
    }
    Ok(lines)
}

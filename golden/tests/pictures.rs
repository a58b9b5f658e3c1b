//! Pictures: colours that people with every kind of colour vision distinguish, that read on white and on black, and files that are
//! well-formed XML with all that was drawn. The colour model is that of Machado, Oliveira and Fernandes (2009).

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

use golden::svg::{Across, Curve, Curves, Over, Panel, Part, Picture, Plane, Rows, STYLES};
use std::collections::BTreeSet;

/// Severity 1 of protanopia, deuteranopia and tritanopia, on linear red, green and blue; and usual vision.
const VISIONS: [[[f64; 3]; 3]; 4] = [
    [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    [[0.152_286, 1.052_583, -0.204_868], [0.114_503, 0.786_281, 0.099_216], [-0.003_882, -0.048_116, 1.051_998]],
    [[0.367_322, 0.860_646, -0.227_968], [0.280_085, 0.672_501, 0.047_413], [-0.011_820, 0.042_940, 0.968_881]],
    [[1.255_528, -0.076_749, -0.178_779], [-0.078_411, 0.930_809, 0.147_602], [0.004_733, 0.691_367, 0.303_900]],
];
/// Two colours that differ by less look alike (CIE 1976; 2.3 is just noticeable).
const LEAST_DIFFERENCE: f64 = 12.0;
/// Contrast of graphics (WCAG 2.1, 1.4.11).
const LEAST_CONTRAST: f64 = 3.0;

/// Linear red, green and blue, 0 to 1.
fn linear(colour: &str) -> [f64; 3] {
    [1, 3, 5].map(|at| {
        let part = f64::from(u8::from_str_radix(&colour[at..at + 2], 16).unwrap()) / 255.0;
        if part <= 0.04045 { part / 12.92 } else { ((part + 0.055) / 1.055).powf(2.4) }
    })
}

fn seen(vision: &[[f64; 3]; 3], colour: [f64; 3]) -> [f64; 3] {
    vision.map(|row| row.iter().zip(colour).map(|(factor, part)| factor * part).sum::<f64>().clamp(0.0, 1.0))
}

fn luminance([red, green, blue]: [f64; 3]) -> f64 {
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// L*, a*, b* with the white of D65.
fn lab([red, green, blue]: [f64; 3]) -> [f64; 3] {
    let f = |value: f64| if value > 0.008_856 { value.cbrt() } else { 7.787 * value + 16.0 / 116.0 };
    let x = f((0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.9505);
    let y = f(luminance([red, green, blue]));
    let z = f((0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.089);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

#[test]
fn everybody_distinguishes_the_curves_of_a_panel() {
    for vision in &VISIONS {
        let colours = STYLES.map(|(colour, _)| lab(seen(vision, linear(colour))));
        for (n, one) in colours.iter().enumerate() {
            for (m, other) in colours.iter().enumerate().skip(n + 1) {
                let difference: f64 = one.iter().zip(other).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt();
                assert!(difference >= LEAST_DIFFERENCE, "curves {n} and {m} differ by {difference:.1}");
            }
        }
    }
    // Without any colour the dashes do it.
    assert_eq!(STYLES.map(|(_, dashes)| dashes).into_iter().collect::<BTreeSet<_>>().len(), STYLES.len());
}

#[test]
fn the_curves_read_on_white_and_on_black() {
    for (colour, _) in STYLES {
        let of = luminance(linear(colour)) + 0.05;
        let [on_white, on_black] = [1.05 / of, of / 0.05];
        assert!(on_white >= LEAST_CONTRAST && on_black >= LEAST_CONTRAST, "{colour}: {on_white:.2}, {on_black:.2}");
    }
}

/// Every form of panel, with names that XML has other uses for.
fn everything() -> Picture {
    let curves = Curves {
        name: "a < b & c".to_owned(),
        curves: vec![Curve::new("<>", vec![(0.0, 1.0), (2.0, 3.0)])],
        ..Curves::default()
    };
    let rows = Rows { rows: vec![("row".to_owned(), vec![[0.5, 1.0]])] };
    let beyond = Curves {
        scale: Some([0.0, 1.0, 0.5]),
        curves: vec![Curve::new("beyond", vec![(10.0, 0.5), (100.0, 7.0)])],
        ..Curves::default()
    };
    let plane = Plane {
        name: "plane".to_owned(),
        across: [-3.0, 1.5],
        circles: vec![((-1.0, 0.0), 0.5, "circle".to_owned())],
        marks: vec![((-1.0, 0.0), "-1".to_owned())],
        curves: vec![Curve::new("L", vec![(0.0, 0.0), (1.0, 1.0)])],
    };
    let time = Over {
        across: Across::Time { until: 2.0 },
        events: vec![(1.0, "N10".to_owned())],
        panels: vec![Panel::Curves(curves), Panel::Rows(rows)],
    };
    let frequency = Over {
        across: Across::Frequency { from: 1.0, to: 500.0 },
        events: Vec::new(),
        panels: vec![Panel::Curves(beyond)],
    };
    Picture {
        title: "<title>".to_owned(),
        setup: vec!["one".to_owned(), "two".to_owned()],
        parts: vec![Part::Over(time), Part::Over(frequency), Part::Plane(plane)],
    }
}

#[test]
fn a_picture_is_well_formed_and_has_what_was_drawn() {
    let text = everything().svg();
    let document = roxmltree::Document::parse(&text).unwrap();
    let texts: Vec<&str> = document.descendants().filter_map(|node| node.text()).map(str::trim).collect();
    let names = "<title>|one|two|a < b & c|<>|row|N10|time [s]|frequency [Hz]|plane|circle|-1|200";
    for name in names.split('|') {
        assert!(texts.contains(&name), "{name} is missing: {texts:?}");
    }
    let count = |name: &str| {
        document.descendants().filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", name))).count()
    };
    assert_eq!([count("polyline"), count("circle"), count("rect")], [3, 1, 1]);
}

/// The places of a curve by hand: 564 units wide from 126, a decade of 500 is log 10 by log 500 of it.
#[test]
fn frequencies_lie_on_a_logarithmic_scale() {
    let text = everything().svg();
    let document = roxmltree::Document::parse(&text).unwrap();
    let beyond = document
        .descendants()
        .filter(|node| node.has_tag_name(("http://www.w3.org/2000/svg", "polyline")))
        .nth(1)
        .unwrap();
    let x: Vec<f64> = (beyond.attribute("points").unwrap().split_whitespace())
        .map(|point| point.split_once(',').unwrap().0.parse().unwrap())
        .collect();
    let decade = 564.0 / 500.0_f64.log10();
    for (found, expected) in x.iter().zip([126.0 + decade, 126.0 + 2.0 * decade]) {
        assert!((found - expected).abs() <= 0.05 + 1e-9, "{found}, {expected} expected");
    }
    // What leaves the scale is cut off at the frame.
    assert!(beyond.parent().unwrap().attribute("viewBox").is_some_and(|frame| frame.starts_with("126.0 ")));
}

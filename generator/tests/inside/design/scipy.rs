//! The designs of scipy, stored as data: its poles, its gain and its response against ours. `../data/scipy_designs.py` says
//! how they were made: by its own methods, from the edges of the band, and not from our sections.

use super::oscillation_of;
use super::rounding::of_section;
use crate::inside::sets::filter as coefficients_of;
use generator::axis::{Filter, Prototype};
use generator::design::band::warped;
use generator::design::response::{self, Complex, Section, magnitude, product};
use portable::Extreme;
use reference::oscillation;

const DATA: &str = include_str!("../data/scipy_designs.csv");

/// A design of scipy.
struct Row {
    kind: String,
    cycle_time: f64,
    f0: f64,
    gain: f64,
    poles: Vec<Complex>,
    response: Vec<(f64, Complex)>,
    ours: Ours,
}

/// The same by this crate.
struct Ours {
    /// a1 and a2 of each section
    denominators: Vec<[f64; 2]>,
    /// product of the first numerator coefficients
    gain: f64,
    response: Box<dyn Fn(f64) -> Complex>,
}

fn rows() -> impl Iterator<Item = Row> {
    DATA.lines().skip(1).map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let [kind, order, ns, f0, q, gain, poles, frequencies, response] = cells[..] else {
            panic!("nine cells: {line}")
        };
        let cycle_time = number(ns) / 1e9;
        let frequencies = frequencies.split(';').map(number);
        Row {
            kind: kind.to_owned(),
            cycle_time,
            f0: number(f0),
            gain: number(gain),
            poles: poles.split(';').map(complex).collect(),
            response: frequencies.zip(response.split(';').map(complex)).collect(),
            ours: ours(kind, order.parse().expect("an order"), number(f0), number(q), cycle_time),
        }
    })
}

fn number(cell: &str) -> f64 {
    cell.parse().expect("a number")
}

fn complex(cell: &str) -> Complex {
    let (re, im) = cell.split_once(' ').expect("two numbers");
    Complex { re: number(re), im: number(im) }
}

fn ours(kind: &str, order: usize, f0: f64, q_or_d: f64, cycle_time: f64) -> Ours {
    let filter = match kind {
        "OSCILLATION" => {
            let coeffs = oscillation_of(warped(f0, cycle_time), q_or_d);
            let oscillation::Coeffs { b0, a1, a2, .. } = coeffs;
            return Ours {
                denominators: vec![[a1, a2]],
                gain: b0,
                response: Box::new(move |t| Section::of_oscillation(&coeffs).at(t)),
            };
        }
        "ALLPASS" => Filter::Allpass { f0, q_factor: q_or_d },
        "CRIT_DAMPING" => Filter::Bandpass { prototype: Prototype::CritDamping, order, f0, q_factor: q_or_d },
        "BUTTERWORTH" => Filter::Bandpass { prototype: Prototype::Butterworth, order, f0, q_factor: q_or_d },
        "BESSEL" => Filter::Bandpass { prototype: Prototype::Bessel, order, f0, q_factor: q_or_d },
        other => panic!("{other}"),
    };
    let coeffs = coefficients_of(&filter, cycle_time);
    let sections = &coeffs.bandpass[..coeffs.order];
    let (denominators, gain) = match filter {
        Filter::Bandpass { .. } => {
            (sections.iter().map(|s| [s.a1, s.a2]).collect(), sections.iter().map(|s| -s.b2).product())
        }
        _ => (vec![[coeffs.allpass.a1, coeffs.allpass.a2]], coeffs.allpass.a2),
    };
    Ours { denominators, gain, response: Box::new(move |t| product(&response::sections(&coeffs), t)) }
}

#[test]
fn there_are_enough_of_every_kind() {
    let count = |kind: &str| rows().filter(|row| row.kind == kind).count();
    assert_eq!(["CRIT_DAMPING", "BUTTERWORTH", "BESSEL", "ALLPASS", "OSCILLATION"].map(count), [72, 72, 72, 24, 24]);
}

/// Relative to the peak of the response. Both designs are rounded: twice the bound for one.
#[test]
fn responses_agree() {
    let mut worst = 0.0_f64;
    for row in rows() {
        let peak = row.response.iter().map(|(_, h)| magnitude(*h)).fold(1.0, f64::larger);
        for (frequency, expected) in &row.response {
            let t = warped(*frequency, row.cycle_time);
            let h = (row.ours.response)(t);
            let deviation = magnitude(Complex { re: h.re - expected.re, im: h.im - expected.im }) / peak;
            let rounding: f64 = row.ours.denominators.iter().map(|[a1, a2]| of_section(*a1, *a2, t)).sum();
            let allowed = 3.0 * rounding + 4e-14;
            assert!(deviation <= allowed, "{deviation:e} > {allowed:e}: {} {} {}", row.kind, row.f0, row.cycle_time);
            let below = (6e-4 / (row.f0 * row.cycle_time)).larger(1.0);
            assert!(allowed <= 2e-9 * below * below);
            worst = worst.larger(deviation / allowed);
        }
    }
    assert!(worst > 0.01, "the tolerance is far too wide, worst {worst}");
}

#[test]
fn gains_agree() {
    for row in rows() {
        let deviation = (row.ours.gain / row.gain - 1.0).abs();
        assert!(deviation <= 1e-13, "{deviation:e}: {} {} {}", row.kind, row.f0, row.cycle_time);
    }
}

/// A pole moves by (|da1| + |da2|) / |p - p*|; where a pair is nearly one double pole, by the root of it.
#[test]
fn poles_agree() {
    for row in rows() {
        let ours: Vec<_> = row.ours.denominators.iter().flat_map(|[a1, a2]| poles(*a1, *a2)).collect();
        assert_eq!(ours.len(), row.poles.len());
        for (p, distance) in ours {
            let away = |other: &Complex| magnitude(Complex { re: p.re - other.re, im: p.im - other.im });
            let deviation = row.poles.iter().map(away).fold(f64::INFINITY, f64::smaller);
            let moved = 4.0 * f64::EPSILON / distance;
            let allowed = moved.smaller(2.0 * libm::sqrt(f64::EPSILON)) + 8.0 * f64::EPSILON;
            assert!(deviation <= allowed, "{deviation:e} > {allowed:e}: {} {} {}", row.kind, row.f0, row.cycle_time);
        }
    }
}

/// The poles of 1 + a1 z^-1 + a2 z^-2, each with its distance from the other, by way of s = (1 - z^-1) / (1 + z^-1).
fn poles(a1: f64, a2: f64) -> [(Complex, f64); 2] {
    let (nyquist, dc) = ((1.0 - a1) + a2, (1.0 + a1) + a2);
    let (sigma, square) = ((1.0 - a2) / nyquist, dc / nyquist);
    let discriminant = sigma * sigma - square;
    let root = libm::sqrt(discriminant.abs());
    let [p, q] = if discriminant < 0.0 {
        [root, -root].map(|im| bilinear(-sigma, im))
    } else {
        [-sigma - root, -square / (sigma + root)].map(|re| bilinear(re, 0.0))
    };
    let distance = magnitude(Complex { re: p.re - q.re, im: p.im - q.im });
    [(p, distance), (q, distance)]
}

/// z = (1 + s) / (1 - s)
fn bilinear(re: f64, im: f64) -> Complex {
    let square = (1.0 - re) * (1.0 - re) + im * im;
    Complex { re: ((1.0 + re) * (1.0 - re) - im * im) / square, im: 2.0 * im / square }
}

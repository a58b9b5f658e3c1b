//! Parses times of options. The command decides which of them are allowed.

/// A time of an option [s]: a number and one of these units, each with its size [s]. A unit that ends like another one comes
/// first.
pub fn seconds(text: &str, units: &[(&str, f64)]) -> Option<f64> {
    let (number, size) = units.iter().find_map(|(unit, size)| Some((text.strip_suffix(unit)?, size)))?;
    number.trim().parse::<f64>().ok().map(|number| number * size)
}

//! The meaning of a column name: a quantity and its unit, in English or German. No cell is known here.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Quantity {
    Frequency,
    Real,
    Imaginary,
    Magnitude,
    Phase,
    Coherence,
    StandardError,
    Averages,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unit {
    Hertz,
    Kilohertz,
    RadiansPerSecond,
    Decibel,
    Degrees,
    Radians,
    Percent,
    /// a factor
    Linear,
}

/// The meaning of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Meaning {
    pub quantity: Quantity,
    pub unit: Option<Unit>,
    /// a unit in brackets that is not one of these
    pub unknown: Option<String>,
}

/// The words of each quantity, in lower case.
const WORDS: [(Quantity, &[&str]); 8] = [
    (
        Quantity::Frequency,
        &["f", "freq", "frequency", "frequencies", "frequenz", "hz", "omega", "w", "ω", "kreisfrequenz"],
    ),
    (Quantity::Real, &["re", "real", "realteil", "realpart"]),
    (Quantity::Imaginary, &["im", "imag", "imaginary", "imaginär", "imaginärteil", "imaginaerteil", "imagpart"]),
    (
        Quantity::Magnitude,
        &[
            "mag",
            "magnitude",
            "gain",
            "amplitude",
            "ampl",
            "amp",
            "abs",
            "betrag",
            "verstärkung",
            "amplitudengang",
            "db",
        ],
    ),
    (Quantity::Phase, &["phase", "phas", "ph", "arg", "angle", "winkel", "phasengang", "phasenwinkel", "deg", "°"]),
    (Quantity::Coherence, &["coherence", "coh", "kohärenz", "kohaerenz", "gamma2", "gamma", "γ2", "γ²", "γ"]),
    (Quantity::StandardError, &["se", "stderr", "standarderror", "standardfehler", "standard"]),
    (Quantity::Averages, &AVERAGES),
];

/// Words for the number of averages, in columns and in comments.
pub(super) const AVERAGES: [&str; 8] =
    ["averages", "averaging", "averagings", "navg", "avg", "mittelungen", "mittelung", "mittelungszahl"];

/// Words for a frequency that mean an angular frequency if there is no unit.
const ANGULAR: [&str; 4] = ["omega", "w", "ω", "kreisfrequenz"];

/// The unit that a text names.
pub(super) fn unit(text: &str) -> Option<Unit> {
    let text: String = text.to_lowercase().chars().filter(|letter| !letter.is_whitespace()).collect();
    let text = text.trim_matches(['[', ']', '(', ')']);
    Some(match text {
        "hz" => Unit::Hertz,
        "khz" => Unit::Kilohertz,
        "rad/s" | "rad/sec" | "rads" => Unit::RadiansPerSecond,
        "db" => Unit::Decibel,
        "deg" | "degree" | "degrees" | "°" | "grad" => Unit::Degrees,
        "rad" | "radian" | "radians" => Unit::Radians,
        "%" => Unit::Percent,
        "-" | "1" | "lin" | "linear" | "abs" => Unit::Linear,
        _ => return None,
    })
}

/// The meaning of a column name, with the text below it in a line of units.
pub(super) fn meaning(name: &str, below: Option<&str>) -> Option<Meaning> {
    let lower = name.to_lowercase();
    let (bare, bracket) = bracketed(&lower);
    let is_part = |letter: char| letter.is_alphanumeric() || letter == '°';
    let mut words: Vec<&str> = bare.split(|letter: char| !is_part(letter)).filter(|word| !word.is_empty()).collect();
    let mut named = bracket.and_then(unit).or_else(|| below.and_then(unit));
    let trailing = match words.as_slice() {
        [.., "rad", "s" | "sec"] => Some((2, Unit::RadiansPerSecond)),
        [_, .., last] => unit(last).map(|unit| (1, unit)),
        _ => None,
    };
    if let Some((count, unit)) = trailing {
        words.truncate(words.len() - count);
        named = named.or(Some(unit));
    }
    let of_word = |word: &str| WORDS.iter().find(|(_, known)| known.contains(&word)).map(|(quantity, _)| *quantity);
    let quantity = match bare {
        bare if bare.contains('|') => Quantity::Magnitude,
        bare if bare.contains('∠') => Quantity::Phase,
        bare => decisive(words.iter().filter_map(|word| of_word(word))).or_else(|| of_word(bare.trim()))?,
    };
    let quantity = match (quantity, named) {
        (Quantity::Frequency | Quantity::Magnitude, Some(Unit::Degrees)) => Quantity::Phase,
        (Quantity::Frequency, Some(Unit::Decibel)) => Quantity::Magnitude,
        (quantity, _) => quantity,
    };
    let is_angular = || words.iter().any(|word| ANGULAR.contains(word) || *word == "angular");
    let alone = match (quantity, words.as_slice()) {
        (Quantity::Frequency, _) if is_angular() => Some(Unit::RadiansPerSecond),
        (Quantity::Frequency, _) => Some(Unit::Hertz),
        (Quantity::Magnitude, ["db"]) => Some(Unit::Decibel),
        (Quantity::Phase, ["deg" | "°"]) => Some(Unit::Degrees),
        _ => None,
    };
    let unknown = bracket.or(below).filter(|text| named.is_none() && !text.trim().is_empty()).map(str::to_owned);
    Some(Meaning { quantity, unit: named.or(alone), unknown })
}

/// The quantity of a name with several words: `Gain: Phase` is a phase, and `Frequency response magnitude` a magnitude. Among
/// words of one rank the first one decides.
fn decisive(words: impl Iterator<Item = Quantity>) -> Option<Quantity> {
    let rank = |quantity: &Quantity| match quantity {
        Quantity::Phase | Quantity::Coherence => 0,
        Quantity::Real | Quantity::Imaginary | Quantity::Magnitude | Quantity::StandardError | Quantity::Averages => 1,
        Quantity::Frequency => 2,
    };
    words.min_by_key(rank)
}

/// A name without its unit in brackets, or after `/` or `in`. Round brackets that contain no unit belong to the name:
/// `re(H)`.
fn bracketed(name: &str) -> (&str, Option<&str>) {
    let within = |open: char, close: char| {
        let start = name.rfind(open)?;
        let end = start + name[start..].find(close)?;
        Some((&name[..start], name[start + open.len_utf8()..end].trim()))
    };
    if let Some((bare, text)) = within('[', ']') {
        return (bare, Some(text));
    }
    if let Some((bare, text)) = within('(', ')').filter(|(_, text)| unit(text).is_some()) {
        return (bare, Some(text));
    }
    let after = name.split_once('/').or_else(|| name.split_once(" in "));
    match after.filter(|(_, text)| unit(text).is_some()) {
        Some((bare, text)) => (bare, Some(text)),
        None => (name, None),
    }
}

//! The words and the meaning of each by itself. Nothing about combinations of words, and no messages.

use super::bracket::{self, Bracket};
use super::foreign::{self, Foreign};
use super::lexical::Piece;
use super::mistake::Mistakes;
use super::number;
use super::passed::PassedKind;
use super::program::{Axis, Direction};

/// A word of a block.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Word {
    /// N
    Number(u32),
    /// `/`: the block can be skipped
    Skip,
    /// a G word that acts in its block
    Function(Function),
    /// a G word that stays in force
    Modal(Modal),
    /// M3, M4
    Turn(Direction),
    /// M5
    Stop,
    /// M19
    Position,
    /// M2, M30
    End,
    /// S, in rpm
    Speed(f64),
    /// S.POS=, in deg
    Angle(f64),
    /// S[...]
    Bracket(Bracket),
    /// F
    Feed(f64),
    /// X, Y1: the function decides the meaning of the number
    Axis(Axis, f64),
    /// P, Q, R, L, I, J, K: of another word of the block; also whether the number is an integer without a point
    Parameter { value: f64, letter: char, is_integer: bool },
    /// #TIME, in s
    Wait(f64),
    /// without effect; whether words of the letters above belong to it
    Passed(PassedKind, Parameters),
    /// of another language, or not read
    Foreign(Foreign),
}

/// The words of a block that belong to a skipped word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parameters {
    No,
    /// P, Q, R, L
    Letters,
    /// those, and if the block has no G word also S, F and axes, which are then not speed, feed or position
    All,
}

/// A word and its place.
#[derive(Clone, Debug)]
pub(crate) struct Placed<'t> {
    /// character of the line, from 1
    pub(crate) column: usize,
    pub(crate) text: &'t str,
    pub(crate) word: Word,
}

/// The use of the axis words of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Function {
    Rapid,
    Linear,
    Dwell,
    Home,
    /// G28, G30, G53
    MachinePosition,
    /// G92
    Preset,
    FeedforwardOn,
    Percentage,
    FeedforwardOff,
}

/// The meaning of the numbers of later axis words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Modal {
    Absolute,
    Incremental,
    Inches,
    Millimetres,
    /// G92.1, G92.2
    NoPreset,
}

/// The meaning of a word, if it is one.
pub(crate) fn parse(text: &str) -> Option<Word> {
    let upper = text.to_ascii_uppercase();
    let first = upper.chars().next()?;
    if matches!(first, '/' | '%' | '$' | '#' | ':') {
        return command(&upper);
    }
    let name = upper.split(['[', '=']).next().unwrap_or_default();
    if upper.contains('[') && name.starts_with('S') && name.bytes().skip(1).all(|byte| byte.is_ascii_digit()) {
        return bracket::read(Piece { column: 1, text: &upper }, &mut Mistakes::default()).map(Word::Bracket);
    }
    // X1=50, X=50, S=1000, S.POS=90
    if let Some((name, number)) = upper.split_once('=') {
        let number = number::decimal(number)?;
        return match name {
            "S" | "S1" => speed(number),
            "S.POS" | "SPOS" => Some(Word::Angle(number)),
            "F" => feed(number),
            _ => Axis::named(name).map(|axis| Word::Axis(axis, number)),
        };
    }
    let number = upper.get(first.len_utf8()..)?.trim_start();
    match first {
        'N' => number::count(number).map(Word::Number),
        'G' => Some(g_word(&plain(number)?)),
        'M' => Some(m_word(&plain(number)?)),
        // The M word gives the direction of a spindle, never a sign.
        'S' => speed(number::decimal(number)?),
        'F' => feed(number::decimal(number)?),
        'T' | 'D' | 'H' => number::decimal(number).map(|_| Word::Passed(PassedKind::Tool, Parameters::No)),
        'O' => number::count(number).map(|_| Word::Passed(PassedKind::Setting, Parameters::No)),
        'P' | 'Q' | 'R' | 'L' | 'I' | 'J' | 'K' => {
            let is_integer = number::count(number).is_some();
            number::decimal(number).map(|value| Word::Parameter { value, letter: first, is_integer })
        }
        _ => Axis::named(&upper[..first.len_utf8()]).and_then(|axis| Some(Word::Axis(axis, number::decimal(number)?))),
    }
}

/// The number of a G or M word without leading zeros.
fn plain(number: &str) -> Option<String> {
    let (whole, part) = number.split_once('.').unwrap_or((number, ""));
    let is_plain = whole.bytes().chain(part.bytes()).all(|byte| byte.is_ascii_digit()) && !whole.is_empty();
    let whole = whole.trim_start_matches('0');
    let whole = if whole.is_empty() { "0" } else { whole };
    is_plain.then(|| if part.is_empty() { whole.to_owned() } else { format!("{whole}.{part}") })
}

fn speed(rpm: f64) -> Option<Word> {
    (rpm >= 0.0).then_some(Word::Speed(rpm))
}

fn feed(feed: f64) -> Option<Word> {
    (feed > 0.0).then_some(Word::Feed(feed))
}

/// A word that begins with a special character.
fn command(upper: &str) -> Option<Word> {
    let (first, rest) = upper.split_at(1);
    let name = rest.split(|letter: char| !letter.is_ascii_alphanumeric()).next().unwrap_or_default();
    Some(match (first, name) {
        ("/", _) => Word::Skip,
        (":", _) => number::count(rest).map(|_| Word::Passed(PassedKind::Setting, Parameters::No))?,
        ("#", "TIME") => Word::Wait(number::decimal(rest["TIME".len()..].trim()).filter(|seconds| *seconds >= 0.0)?),
        ("#", "MSG" | "FLUSH") => Word::Passed(PassedKind::Setting, Parameters::No),
        ("#", "SLOPE" | "HSC" | "CONTOUR" | "FILTER") => Word::Passed(PassedKind::PathMode, Parameters::No),
        ("#" | "$", _) => Word::Foreign(foreign::text(upper)),
        _ => return None,
    })
}

/// A G word by its number without leading zeros.
fn g_word(number: &str) -> Word {
    let passed = |kind| Word::Passed(kind, Parameters::Letters);
    match number {
        "0" => Word::Function(Function::Rapid),
        "1" => Word::Function(Function::Linear),
        "4" => Word::Function(Function::Dwell),
        "74" => Word::Function(Function::Home),
        "28" | "30" | "53" => Word::Function(Function::MachinePosition),
        "92" => Word::Function(Function::Preset),
        "135" => Word::Function(Function::FeedforwardOn),
        "136" => Word::Function(Function::Percentage),
        "137" => Word::Function(Function::FeedforwardOff),
        "90" => Word::Modal(Modal::Absolute),
        "91" => Word::Modal(Modal::Incremental),
        "20" | "70" => Word::Modal(Modal::Inches),
        "21" | "71" => Word::Modal(Modal::Millimetres),
        "92.1" | "92.2" => Word::Modal(Modal::NoPreset),
        "40" | "43" | "44" | "49" => Word::Passed(PassedKind::Tool, Parameters::No),
        "17" | "18" | "19" | "15" | "50.1" | "64.1" | "69" | "80" | "90.1" | "91.1" | "94" | "97" => {
            Word::Passed(PassedKind::Setting, Parameters::No)
        }
        "5.1" | "8" | "9" | "60" | "61" | "61.1" | "64" | "187" | "260" | "261" => passed(PassedKind::PathMode),
        "54" | "55" | "56" | "57" | "58" | "59" | "54.1" | "54.2" | "59.1" | "59.2" | "59.3" => {
            passed(PassedKind::Offset)
        }
        _ => Word::Foreign(foreign::g_word(number)),
    }
}

/// An M word by its number without leading zeros.
fn m_word(number: &str) -> Word {
    match number {
        "2" | "30" => Word::End,
        "3" => Word::Turn(Direction::Positive),
        "4" => Word::Turn(Direction::Negative),
        "5" => Word::Stop,
        "6" => Word::Passed(PassedKind::Tool, Parameters::No),
        "19" => Word::Position,
        "17" | "96" | "97" | "98" | "99" => Word::Foreign(Foreign::Subprogram),
        "29" => Word::Foreign(Foreign::Cycle),
        // M66 E0 L0; of printers: M92 E415, M205 X8.
        _ if number.len() > 2 || number.starts_with(['6', '8', '9']) && number.len() == 2 => {
            Word::Passed(PassedKind::Machine, Parameters::All)
        }
        _ => Word::Passed(PassedKind::Machine, Parameters::Letters),
    }
}

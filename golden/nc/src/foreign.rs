//! Words of NC languages that are not read: their kinds, and their replacements.

/// The kind of a word that is not read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Foreign {
    Arc,
    Cycle,
    Thread,
    Probe,
    Variable,
    Expression,
    Branch,
    Subprogram,
    Compensation,
    Transformation,
    Preset,
    FeedMode,
    /// a word of a cycle, of an arc or of a call, without it
    Parameter,
    Unknown,
}

impl Foreign {
    /// Its description, and what to write instead.
    pub(crate) fn said(self) -> (&'static str, &'static str) {
        match self {
            Self::Arc => ("an arc", "straight moves, as a CAM system writes them with arcs switched off"),
            Self::Cycle => ("a canned cycle", "the moves of the cycle"),
            Self::Thread => ("a thread", "the program without the thread"),
            Self::Probe => ("a measurement", "the program without the measurement"),
            Self::Variable => ("a variable", "numbers"),
            Self::Expression => ("an expression", "its result as a number"),
            Self::Branch => ("a loop, a condition or a jump", "its blocks, as often as they run"),
            Self::Subprogram => ("a subprogram or its call", "the blocks of the subprogram"),
            Self::Compensation => ("tool radius or tool tip compensation", "the path of the tool's centre"),
            Self::Transformation => ("a change of the coordinates", "positions of the axes"),
            Self::Preset => ("a shift of the coordinates", "positions in one system of coordinates"),
            Self::FeedMode => ("a feed or a speed in another unit", "a feed in mm/min (G94), a speed in rpm (G97)"),
            Self::Parameter => ("a word of a cycle or a call that is not there", "the program without it"),
            Self::Unknown => ("a word that programs here do not have", "the program without it"),
        }
    }
}

/// G words that are known and not read, by their numbers without leading zeros.
pub(crate) fn g_word(number: &str) -> Foreign {
    match number {
        "2" | "3" | "2.1" | "3.1" | "2.2" | "3.2" | "2.3" | "3.3" | "12" | "13" | "102" | "103" | "302" | "303" => {
            Foreign::Arc
        }
        "5" | "5.2" | "5.3" | "6" | "6.2" | "150" | "151" => Foreign::Arc,
        "73" | "76" | "81" | "82" | "83" | "84" | "85" | "86" | "87" | "88" | "89" | "72" | "75" | "77" | "78"
        | "79" | "98" | "99" => Foreign::Cycle,
        "32" | "33" | "33.1" | "34" | "63" | "331" | "332" => Foreign::Thread,
        "31" | "36" | "37" | "38" | "38.2" | "38.3" | "38.4" | "38.5" | "100" | "106" | "108" | "310" => Foreign::Probe,
        "65" | "66" | "66.1" | "67" => Foreign::Subprogram,
        "41" | "42" | "41.1" | "42.1" | "43.1" | "43.2" | "43.4" | "43.5" | "138" | "139" | "140" => {
            Foreign::Compensation
        }
        "7.1" | "12.1" | "13.1" | "16" | "51" | "51.1" | "51.2" | "22" | "23" | "24" | "68" | "68.2" | "107"
        | "112" => Foreign::Transformation,
        "10" | "50" | "52" | "92.3" | "159" | "160" => Foreign::Preset,
        "93" | "95" | "96" | "194" | "195" => Foreign::FeedMode,
        _ => Foreign::Unknown,
    }
}

/// The kind of a word that is not a letter with a number.
pub(crate) fn text(upper: &str) -> Foreign {
    let word = upper.trim_start_matches(['#', '$']);
    let starts = |words: &[&str]| words.iter().any(|start| word.starts_with(start));
    let is = |words: &[&str]| words.contains(&word.trim_end_matches([':', '(', '[']));
    if is(&["L", "LL", "RET", "PROC", "SUB", "ENDSUB", "RETURN"])
        || starts(&["O<", "CALL", "EXTERN", "L=", "%L", "M98", "M99"])
    {
        Foreign::Subprogram
    } else if is(&["DO", "OR", "AND", "LOOP", "END"])
        || starts(&[
            "IF", "ELSE", "ELIF", "END", "WHILE", "FOR", "GOTO", "REPEAT", "UNTIL", "SWITCH", "CASE", "DEFAULT",
            "BREAK", "CONTINUE", "DO[",
        ])
        || word.starts_with("DO") && word[2..].bytes().all(|byte| byte.is_ascii_digit())
    {
        Foreign::Branch
    } else if starts(&["CYCLE", "HOLES", "POCKET", "SLOT"]) {
        Foreign::Cycle
    } else if starts(&[
        "TRANS", "ATRANS", "ROT", "AROT", "SCALE", "MIRROR", "AMIRROR", "TRAFO", "TRAORI", "CS ", "ACS", "TLC", "MCS",
    ]) {
        Foreign::Transformation
    } else if upper.starts_with('#')
        && word.starts_with(|first: char| first.is_ascii_digit() || first == '<' || first == '[')
        || upper.contains('#') && !upper.starts_with('#')
        || starts(&["V.", "VAR", "DEF", "REAL", "INT", "STRING"])
        || upper.starts_with('$')
        || upper.starts_with(['P', 'Q', 'R', 'L']) && upper.contains('=')
    {
        Foreign::Variable
    } else if upper.contains(['[', ']', '*', '=']) {
        Foreign::Expression
    } else {
        Foreign::Unknown
    }
}

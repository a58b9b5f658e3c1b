//! The one list of diagnostics: code, title, what it means and what to do.
//!
//! AX0 files and the command line, AX1 paths and lines, AX2 values, AX3 rules that are errors, AX4 warnings. A code
//! keeps its meaning for ever.

/// What a code means.
#[derive(Debug)]
pub struct Code {
    /// as it is printed
    pub code: &'static str,
    /// in a few words
    pub title: &'static str,
    /// why it is said, and what to do
    pub explanation: &'static str,
}

/// The meaning of a code, in any case.
#[must_use]
pub fn explain(code: &str) -> Option<&'static Code> {
    CODES.iter().find(|known| known.code.eq_ignore_ascii_case(code))
}

macro_rules! codes {
    ($($name:ident = $code:literal, $title:literal, $explanation:literal;)+) => {
        $(#[doc = $title] pub const $name: &str = $code;)+

        /// All codes, in the order of their numbers.
        pub static CODES: &[Code] = &[$(Code { code: $code, title: $title, explanation: $explanation }),+];
    };
}

codes! {
    UNREADABLE = "AX001", "a file cannot be read",
        "The set, or an axis list that it names, cannot be opened. The path of a list is relative to the file of the set.";
    TOO_LARGE = "AX002", "a file is too large",
        "No set and no axis list has as many bytes; it is probably another file.";
    UTF8 = "AX003", "a set is no UTF-8",
        "TOML is UTF-8. An axis list may have any byte in its comments, a set may not: save it as UTF-8.";
    SYNTAX = "AX004", "a set is no TOML",
        "The file breaks the syntax of TOML at this place. Until it is mended nothing else of it is judged.";
    NO_AXIS = "AX005", "a set without an axis",
        "A set names at least one axis: a table [axis.NAME] with a list, or with parameters.";
    AXIS_NAME = "AX006", "a name that an axis cannot have",
        "The name becomes part of identifiers and of file names in every target: letters, digits and single underscores, \
         a letter first, at most 32.";
    AXIS_TWICE = "AX007", "two axes whose names differ in case only",
        "Structured Text and some file systems do not tell upper and lower case apart.";
    OPTION = "AX008", "an option that a set does not take",
        "--cycle-time and --name belong to an axis list that stands alone; a set says both itself.";
    CYCLE_TIME = "AX009", "no cycle time",
        "The coefficients hold for one cycle time of the position controller only, and no axis list holds it: give it as \
         cycle_time in a set, or with --cycle-time. The generated block can check it against its task.";
    NOT_LISTED = "AX010", "more messages than anybody reads",
        "A thousand messages were listed. Mend the first ones: the others often follow from them.";

    LINE = "AX101", "no line of an axis list",
        "A line is `path value`, with blanks or tabs between and no `=`; `#`, or `(` at the start of a line or behind a \
         blank, begins a comment.";
    BYTE = "AX102", "a byte outside of ASCII",
        "Bytes that are not printable ASCII are legal in comments only.";
    NO_VALUE = "AX103", "a parameter without a value",
        "The line names a parameter and ends.";
    UNKNOWN = "AX104", "an unknown parameter",
        "The path lies in a structure that axgen owns, or in a set, and no parameter has it. Passing it over could leave \
         out a parameter that you rely on. The name that was probably meant is given.";
    PASSED_OVER = "AX105", "an unknown parameter was passed over",
        "The path lies in a structure that axgen owns, but resembles no parameter: a newer build of the controller may \
         have it. It has no effect on the generated blocks.";
    INDEX = "AX106", "an index that does not exist",
        "There are three stages (0 to 2), each with two filters (0 and 1), and sixteen gear steps (0 to 15).";
    GIVEN_TWICE = "AX107", "given twice",
        "The same parameter stands in two lines. filter.x and filter[0].x are one parameter, stage[].x and stage[0].x too.";
    MISPRINT = "AX108", "a misprint of a manual",
        "The path is read as it was meant. A controller may not do so: write it as given.";
    KEY_OF_A_SET = "AX109", "a key of a set in an axis list",
        "The name is a key of axgen's own, which no controller knows. Write it in a TOML set whose axis names this list.";
    NO_LIST = "AX110", "not an axis list",
        "So many lines cannot be read that the file is probably of another kind.";

    NUMBER = "AX201", "not a number",
        "A number is decimal, with a point and an exponent where a real number is allowed, or hexadecimal with 0x. NaN and \
         infinities are none.";
    WORD = "AX202", "an unknown word",
        "The parameter takes one of the words given, in any case, or the number that stands for it.";
    RANGE = "AX203", "outside of the range",
        "The value lies outside of the range that the parameter has. Values are never clamped: a block inside a control \
         loop must do what its list says, or not be there.";
    TYPE = "AX204", "a value of another type",
        "TOML tells numbers, strings, arrays and tables apart: numbers stand without quotes, words and times with quotes, \
         stages and filters are arrays of tables.";
    DURATION = "AX205", "not a time",
        "A time is a number with its unit, such as \"1ms\", \"62.5us\" or \"0.1s\", and a whole number of nanoseconds.";
    MISSING = "AX206", "a parameter is missing",
        "An active stage needs the parameter, and its default lies outside of its range on purpose: the controller wants it \
         in writing too.";

    NO_BANDPASS = "AX301", "an active stage without a band-pass",
        "Without a band-pass the whole velocity would be fed back. Every active stage needs a BANDPASS in one of its two \
         filters (P-AXIS-00849).";
    PROTOTYPE = "AX302", "a band-pass in the second filter without a prototype",
        "In the first filter the prototype has a default, in the second it must be written (P-AXIS-00848).";
    DAMPING = "AX303", "two values for one damping",
        "P-AXIS-00850 replaces P-AXIS-00756. Both are given, and differ: which one is meant cannot be told.";
    NYQUIST = "AX304", "a frequency too high for the cycle time",
        "Above 0.45 of the sampling frequency the design runs into the pole of its tangent at one half.";
    GANTRY_SLAVE = "AX305", "enabled on a gantry slave (70600)",
        "The controller includes the master's additive velocity in its slaves by itself. A slave with improved position \
         control of its own is its error 70600: configure the master.";
    FADE = "AX306", "fading takes too many cycles",
        "The gate counts its cycles, up to 2^24, which single precision still counts exactly. It takes at least one period of \
         the lowest frequency.";
    TOO_LOW = "AX307", "a filter too low for the precision",
        "A biquad that is low against the sampling frequency adds its own rounding rather than the vibration: in single \
         precision below 0.01 of the sampling frequency, in double precision below a millionth. Use double precision, or \
         a longer cycle time.";
    ROUNDING = "AX308", "a filter that rounding spoils",
        "Rounded to the real type, the coefficients of this section are unstable, or its centre frequency is elsewhere.";
    TOO_FAST = "AX309", "a velocity that the block takes for a bad sample",
        "A block takes a velocity beyond its sample limit, 1e9 in single precision, for a bad sample: it would stop at speed. \
         Use double precision.";

    NO_STAGE = "AX401", "no stage is active",
        "The block is generated, and puts out 0.";
    MUTED = "AX402", "the limit is 0",
        "v_add_max_fact is 0, which is its default: whatever the stages want to add is limited to 0. Set it, in 0.1 % of \
         the largest velocity of the axis.";
    GEAR = "AX403", "several gear steps",
        "Parameters of several gear steps are given, and one of them is used: step 0, or the one that the key `gear` names.";
    GENERATIONS = "AX404", "old beside new parameters",
        "P-AXIS-00756 is still valid, but should not be combined with filter[k] and P-AXIS-00850, which came with its \
         successor.";
    SET_POINT = "AX405", "a weight too large for SET_POINT",
        "SET_POINT is an open-loop pre-filter 1 - w H. With the damping ratio D its best weight is 4 D^2 / (4 D^2 + 1); above \
         twice that it amplifies. Weights that suit INDIRECT do not suit SET_POINT.";
    LAG = "AX406", "feedback from the load",
        "v_direct lags behind the command by the drive, the mechanics and the delay. Up to 90 degrees of lag at f0 the stage \
         damps, beyond it an all-pass is mandatory and the weight should stay at or below 1. Measure the lag first.";
    SQUEEZED = "AX407", "a frequency near half the sampling frequency",
        "The filter is exact at its centre and its edges, but its upper skirt ends at half the sampling frequency.";
    DELAY = "AX408", "the delay turns the phase",
        "The delay costs 360 f0 Ts (cycles + 0.5) degrees at f0: one cycle at the least, and half a cycle for the hold. \
         Drive and mechanics come on top. Beyond 90 degrees the stage excites the vibration, unless an all-pass turns the \
         phase back.";
    OVERLAP = "AX409", "stages overlap",
        "The -3 dB bands of two stages intersect, so that each acts on the other's vibration. Put them in operation together, \
         with small weights.";
    POLARITY = "AX410", "an all-pass that inverts",
        "At its own frequency an all-pass turns by 180 degrees: the stage pushes where it pulled. That is right only where the \
         lag is near 180 degrees.";
    NO_TYPE = "AX411", "a filter without a type",
        "filter[1] is NO_FILTER unless its type says otherwise; its other parameters then have no effect.";
    SLAVE_STAGES = "AX412", "stages on a gantry slave",
        "The slave's stages are not enabled, but the mode is an input of the block: it must stay OFF.";
    INERT = "AX413", "a key without effect",
        "The key acts in another mode of its stage only.";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_ascend() {
        assert!(CODES.windows(2).all(|pair| pair[0].code < pair[1].code));
    }

    #[test]
    fn every_code_is_explained() {
        assert_eq!(explain("ax206").unwrap().title, "a parameter is missing");
        assert!(explain("AX999").is_none());
        assert!(CODES.iter().all(|code| code.explanation.ends_with('.') && !code.title.ends_with('.')));
    }
}

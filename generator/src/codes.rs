//! The only list of diagnostics: code, title, meaning and remedy.
//!
//! AX0 files and the command line, AX1 paths and lines, AX2 values, AX3 rules that are errors, AX4 warnings, AX5 recordings
//! that are measured. The meaning of a code never changes.

#[derive(Debug)]
pub struct Code {
    /// the printed code
    pub code: &'static str,
    pub title: &'static str,
    /// the cause and the remedy
    pub explanation: &'static str,
}

/// The codes whose titles name this error of the controller.
pub fn of_controller(error: u32) -> impl Iterator<Item = &'static Code> {
    let named = format!("({error})");
    CODES.iter().filter(move |code| code.title.ends_with(&named))
}

/// The entry of a code, in upper or lower case.
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
        "The set, an axis list that it names, or a CSV file cannot be opened. The path of a list is relative to the file of the \
         set.";
    TOO_LARGE = "AX002", "a file is too large",
        "Samples may have up to 256 MiB, other files up to 64 MiB. A larger file is probably the wrong one.";
    UTF8 = "AX003", "a set is not UTF-8",
        "TOML is UTF-8. An axis list may have any byte in its comments, a set may not: save it as UTF-8.";
    SYNTAX = "AX004", "a set is not TOML",
        "The file breaks the syntax of TOML at this place. Nothing else in the file is checked until this is corrected.";
    NO_AXIS = "AX005", "a set without an axis",
        "A set names at least one axis: a table [axis.NAME] with a list, or with parameters.";
    AXIS_NAME = "AX006", "a name that an axis cannot have",
        "The name becomes part of identifiers and of file names in every target: letters, digits and single underscores, \
         a letter first, at most 32. With short_names at most 12: the names that linkers see have 31 characters then.";
    AXIS_TWICE = "AX007", "two axes whose names give one name",
        "Structured Text and some file systems do not tell upper and lower case apart. The name of a block contains those of its \
         axis and of its kind: the block spindle_axis of S has the name that the block axis of S_spindle would have.";
    OPTION = "AX008", "an option that a set does not take",
        "--cycle-time and --name are for an axis list without a set; a set states both itself.";
    CYCLE_TIME = "AX009", "no cycle time",
        "The coefficients hold for one cycle time of the position controller only, and no axis list holds it: give it as \
         cycle_time in a set, or with --cycle-time. The generated block can check it against its task.";
    NOT_LISTED = "AX010", "too many messages",
        "A thousand messages were listed. Correct the first ones: the others often follow from them.";
    USAGE = "AX011", "a command line that cannot be carried out",
        "An option is unknown or missing, or its value is invalid. `axgen help COMMAND` lists the options.";
    NO_SUCH = "AX012", "an unknown name",
        "The axis, the target, the stage, the engine, the block, the parameter or the code that the command line names does \
         not exist.";
    EDITED = "AX013", "a generated file that was changed by hand",
        "The digest in its line `checksum` is no longer that of its content. Overwriting it would lose the change: make it in \
         the set, or give --force.";
    NOT_OURS = "AX014", "a file that would be lost",
        "Where the command would write there is a file that it did not make, or that it reads itself. Give another name; \
         --force, where the command has it, replaces a file that it does not read.";
    SAMPLES = "AX015", "a mistake in a CSV file of samples",
        "The first line has the names of signals, each further line a value of each. Reals are decimal, or 0x and the digits of \
         their bits; BOOL is 0 or 1, or TRUE or FALSE.";
    CASE = "AX016", "a golden case that cannot be used",
        "The case's case.toml, its set or its stimulus is wrong, what `shows` names does not happen in it, or its folder \
         cannot be written.";
    UNWRITABLE = "AX017", "a place that cannot be written",
        "The system does not let the command write to the file, the folder or the standard output: no permission, no space, or \
         something else is in the way. This is not a mistake in the set.";
    NO_ENGINE = "AX018", "an engine that cannot run",
        "The engine needs a program that is not there, or that does not work: mostly the C compiler, `cc` or what the variable \
         CC names. This is not a mistake in the set.";
    NC_PROGRAM = "AX019", "a mistake in an NC program",
        "A scenario is an NC program of the words that docs/scenarios.md lists, run on one axis: a spindle, or a path axis \
         named X, Y or Z. Every block must be over at some time, and no error of the generated block may occur.";
    NO_SETS = "AX020", "an axis that takes no parameter sets",
        "A parameter set is for the block of an axis with the key `tunable = \"all\"` or `\"parameters\"`. The set of \
         parameters that the block on the machine was generated from must have the key, and the new one too. Add it to \
         both, and generate the block again.";
    OTHER_STRUCTURE = "AX021", "a parameter set for another block",
        "The real type, the cycle time, the fade in cycles, the stages, their modes and filters, the cycles of the watch and of \
         ride_through, cycle_counter, and whether the axis is a gantry slave are the structure of a block: it refuses a set of \
         another structure with error_id 6. Generate the block again. A lower f0 \
         than before can make the fade longer, which is one period of the lowest f0 at least: with the key `fade` large enough \
         in both sets, other frequencies are a matter of a parameter set.";
    SET_REFUSED = "AX022", "a parameter set that the block refuses",
        "The block on the machine takes no limit above the one that it was generated with, and no number beyond its ranges: it \
         refuses the set with error_id 7. Take a smaller limit, or generate the block again.";
    RESPONSE_TABLE = "AX023", "a file without the table of a frequency response",
        "A measured response is text: a line of column names, below it a line of numbers for each frequency, separated by \
         tabs, semicolons, commas or blanks. Of XML, the file of a frequency response measurement of SINUMERIK is read, if it has the \
         spectra of its signals; traces over time and results of an automatic tuning are not. Binary files are not read: export \
         the response as text. docs/response.md says what is read.";

    LINE = "AX101", "not a line of an axis list",
        "A line is `path value`, with blanks or tabs between and no `=`; `#`, `(`, `/*`, `;` or `//` begins a comment, to the \
         end of the line. So `*/` ends no comment: write a `#` before each line of a longer one.";
    BYTE = "AX102", "a byte outside of ASCII",
        "Bytes that are not printable ASCII are legal in comments, and in the values of other functions' parameters.";
    NO_VALUE = "AX103", "a parameter without a value",
        "The line names a parameter and ends. Write the value after the path, with a blank between, or take the line away: \
         then the default holds.";
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
        "The file is of another kind: no line of it gives a parameter of an axis, or most lines cannot be read. What the \
         file seems to be is said. The name of a set in TOML ends with .toml; every other file is taken for an axis list.";
    TEXT_BEHIND = "AX111", "text after a value",
        "A controller takes the text after a value for a comment, and so does axgen. Write a `#` before it: a unit or a \
         second value that somebody relies on would be lost otherwise.";
    WRAPPED = "AX112", "a comment without its sign",
        "Manuals print long comments over several lines, and such a line is taken for the rest of the comment above; so are \
         words that are not a path. A controller may take them for a parameter: begin them with `#`.";
    COMMENT = "AX113", "text after a comment",
        "A comment that begins with /* ends with its line, whatever follows */. The controller does not read the parameter \
         after it.";
    BEHIND_END = "AX114", "a parameter after the end of a list",
        "A line `Ende` ends a list: the controller reads nothing after it.";
    NC_WORD = "AX115", "a word of an NC program",
        "G135, G136 and G137 switch and weight feedforward while a program runs. The blocks have inputs for them: \
         feedforward_active is TRUE from G135 on and FALSE from G137 on, feedforward_percentage is the number of G136.";
    PROJECT = "AX116", "XML without an axis list",
        "Of XML, axgen reads the axis lists in projects of TwinCAT (.xti, .tsproj): each element AchsMds holds one as CDATA. Of \
         an axis of the NC it reads what the message AX478 names. An NC project whose axes are in files of their own has none: \
         take the file of the axis. XML with a document type, with 1,000 attributes in an element or 200 name spaces is not a \
         project.";
    RESPONSE_COLUMN = "AX117", "a frequency response without a column that it needs",
        "A response has a frequency, and real and imaginary part or magnitude and phase. A column is recognised by its \
         name, in English or German, with its unit in brackets. docs/response.md lists the names.";
    TWO_COLUMNS = "AX118", "two columns for one quantity of a frequency response",
        "Which of them is meant cannot be known. A file holds one response: remove the columns of the others, or rename \
         what is not to be read.";
    RESPONSE_CELLS = "AX119", "a line of a frequency response with another number of cells",
        "Each line has a cell for each name. With commas between the cells, decimal commas look like separators. In XML, each spectrum \
         has a value for each frequency, and all spectra have the same frequencies.";
    NEARLY = "AX120", "a name that is nearly one of axgen's",
        "A list has parameters of other functions, which are passed over. One that differs in a letter or two, or by the \
         structures above it, from a parameter of axgen's without a value is probably that parameter, mistyped: its default \
         would be used. Correct the name, or give the parameter its value.";
    OWN_KEYS = "AX121", "keys of axgen in the comments of a list",
        "`axgen export` writes keys that no controller knows as comments, `# axgen: fade 200ms`, and only `axgen import` reads \
         them. Where the list is read directly, its blocks are those of an axis without these keys: import the list, or write \
         the keys into the set that names it. A list whose comment has another cycle time than the given one is an error.";
    UNFIT_TEXT = "AX122", "a text that no list can hold",
        "`axgen export` writes the text into a line of the list. A line end in it would begin another line, with a parameter \
         that the set does not have, and `]]>` would end the list in a TwinCAT project.";

    NUMBER = "AX201", "not a number",
        "A number is decimal, with a point and an exponent where a real number is allowed, or hexadecimal with 0x. NaN and \
         infinities are none. In a list it is a warning where nothing uses a parameter that other functions have too.";
    WORD = "AX202", "an unknown word",
        "The parameter takes one of the words given, in any case, or the number that stands for it. In a list it is a warning \
         where nothing uses a parameter that other functions have too.";
    RANGE = "AX203", "outside of the range",
        "The value lies outside of the range that the parameter has. Values are never clamped: a block inside a control \
         loop must do what its list says, or not be there.";
    TYPE = "AX204", "a value of another type",
        "TOML distinguishes numbers, strings, arrays and tables: write numbers without quotes, words and times with quotes, \
         stages and filters as arrays of tables.";
    DURATION = "AX205", "not a time",
        "A time is a number with its unit, such as \"1ms\", \"62.5us\" or \"0.1s\", and a whole number of nanoseconds.";
    MISSING = "AX206", "a parameter is missing",
        "An active stage, or the changeover of a spindle, needs the parameter, and its default lies outside of its range on \
         purpose: the controller wants it in writing too, or manuals do not agree on it.";
    RESPONSE_CELL = "AX207", "a cell of a frequency response without a number",
        "Each column that is used has a finite number in each line. Lines that are uncertain stay in with their \
         coherence: where they are cut, a smooth curve hides what the machine does there, and unstable loops look calm.";
    COHERENCE = "AX208", "a coherence outside of 0 to 1, or a negative standard error",
        "The squared coherence of two signals lies between 0 and 1. Other values are another quantity, or another unit. \
         The standard error of a magnitude is not negative.";
    NEGATIVE_FREQUENCY = "AX209", "a frequency of a response that is not above 0",
        "A response is read one-sided, above 0 Hz. Only a first line at 0 Hz, which every FFT has, is left out with a \
         warning.";
    RESPONSE_UNIT = "AX210", "a unit that a column of a frequency response does not have",
        "A frequency is in Hz, kHz or rad/s, a phase in deg or rad. A signal of a measurement in XML has no gain, delay, poles or zeros \
         of its own.";
    RESPONSE_FROM = "AX211", "a frequency response whose signals have no names",
        "The XML file of a measurement has numbers instead of the names of its signals. What the response is from must be stated: \
         `drive.response_from = \"v_cmd\"` for the speed setpoint, `\"current\"` for the current or torque setpoint, with \
         `drive.speed_gain` and `drive.speed_integral_time`.";

    NO_BANDPASS = "AX301", "an active stage without a band-pass",
        "Without a band-pass the whole velocity would be fed back. Every active stage needs a BANDPASS in one of its two \
         filters (P-AXIS-00849).";
    PROTOTYPE = "AX302", "a band-pass in the second filter without a prototype",
        "In the first filter the prototype has a default, in the second it must be written (P-AXIS-00848).";
    DAMPING = "AX303", "two values for one damping",
        "P-AXIS-00850 replaces P-AXIS-00756. Both are given, and differ: the intended one is not known.";
    NYQUIST = "AX304", "a frequency too high for the cycle time",
        "Above 0.45 of the sampling frequency the design runs into the pole of its tangent at one half.";
    GANTRY_SLAVE = "AX305", "enabled on a gantry slave (70600)",
        "The controller includes the master's additive velocity in its slaves by itself. A slave with improved position \
         control of its own is its error 70600: configure the master.";
    FADE = "AX306", "fading takes too many cycles",
        "The fade counts its cycles, up to 2^24, which single precision still counts exactly. It takes at least one period of \
         the lowest frequency.";
    ROUNDING = "AX308", "a filter that rounding spoils",
        "Rounded to the real type, the coefficients of this section are unstable, or its centre frequency is elsewhere.";
    TOO_FAST = "AX309", "a velocity that the block takes for a bad sample",
        "A block takes a velocity beyond its sample limit, 1e9 in single precision, for a bad sample: it would stop at speed. \
         Use double precision.";
    NO_WAY_OUT = "AX310", "improved position control without an additive velocity",
        "The drive controls the position, so that the additive velocity of improved position control is process data of the \
         drive: SERCOS S-0-0037, CANopen 60B1h, PROFIdrive NSOLL_B. No axis list holds the process data; the key \
         process_data.additive_velocity says that it is there, and how wide.";
    ADD_JERK = "AX311", "additive torque from the jerk",
        "No document gives the formula of ADD_JERK. Ours is inferred from the units: a torque from a jerk needs a time, for \
         which the jerk factor is read in seconds. The key add_jerk = \"experimental\" generates it.";
    WITHOUT_DELAY = "AX312", "feedforward without delay of more than the velocity (110624)",
        "feedforward_without_delay (P-AXIS-00566) holds for VEL alone. The controller reports its error 110624.";
    RESOLUTION = "AX313", "no increments per revolution",
        "The angle that the motor turns by follows from the path resolution and the increments per revolution \
         (P-AXIS-00092), which is 0. With a feed constant a PROFIdrive drive would get 0 for every control deviation, too.";
    SCALE = "AX314", "a scaling beyond the numbers",
        "The parameters of a scaling are so large that their product with a velocity or an acceleration is not a number any \
         more.";
    MASTER = "AX315", "a gantry slave without a valid master",
        "A gantry slave outputs the additive velocity of its master. The master is another axis of the set, and is not itself \
         a slave. Logical axis numbers (P-AXIS-00016) name one axis each.";
    LINEAR_MOTOR = "AX316", "a linear motor that turns",
        "A linear motor moves a translatory axis. The torque of a rotary axis or a spindle comes from a rotary motor.";
    NO_GEAR = "AX317", "a gear step without parameters",
        "The key `gear` names a gear step of which the axis has no parameter, while it has other steps. Every parameter of the \
         step would have its default, and without Kv there would be no position control. Name one of the steps that are given.";

    NUMBER_TWICE = "AX318", "a logical axis number that two axes have",
        "A logical axis number (P-AXIS-00016) names one axis of a controller. Two axes of a set with one number are mostly one \
         list that was copied, or named twice. Give each axis its own number; a key below the axis of a set overrides its list.";
    GEAR_RATIO = "AX319", "a gear ratio in other parameters",
        "The angle that the motor turns by is computed from the increments per revolution (P-AXIS-00092), the feed constant \
         (P-AXIS-00362/00363) and the gear ratio in wegaufz and wegaufn (P-AXIS-00234/00233). A list may have the ratio in \
         gear_fact_num and gear_fact_denom (P-AXIS-00511/00512) instead: it would be lost, and every increment would be wrong \
         by that factor.";
    CHANGEOVER = "AX320", "changeover velocities the wrong way round",
        "A spindle changes to velocity control at P-AXIS-00767 and back at P-AXIS-00768, which is not above it. The manual's \
         second example has its values one line too low: it changes at 0.001 deg/s, if it is taken as it stands.";
    NO_CHANGEOVER = "AX321", "a drive that does not change its operation mode",
        "Where the drive controls the position, it changes to velocity control itself: it gets the operation mode and displays \
         it. The controller does so with SERCOS and CANopen drives only. With position control in the CNC (P-AXIS-00320) any \
         drive will do.";
    ONE_MODE = "AX322", "one operation mode for position and velocity control",
        "The changeover is over when the drive displays the new operation mode. If both modes have one number, the \
         display does not distinguish them: of SERCOS velocity control is an auxiliary mode (P-AXIS-00264), of CANopen another number \
         (P-AXIS-00463, 00464).";
    HALF_A_REVOLUTION = "AX323", "position control at half a revolution in a cycle",
        "A drive that controls the position of a spindle cannot determine the direction of a move of 180 deg or more in a \
         cycle: the speed must stay below 30/T rpm, at a cycle time of 2 ms below 15000 rpm. The limit holds for the velocity up to which position \
         control lasts (P-AXIS-00767, or 00212 if it is lower) and for that at which it is taken up again (P-AXIS-00768) with \
         its window.";
    TWO_VELOCITIES = "AX324", "two values for one velocity",
        "P-AXIS-00767 replaces P-AXIS-00265, and P-AXIS-00768 replaces P-AXIS-00266. Both are given, and differ: it is not \
         clear which one is meant.";
    NOT_OFFERED = "AX325", "a drive without what the changeover needs",
        "A drive that changes its operation mode gets the commands of both modes in its cyclic telegram, and answers with its \
         actual values. A SERCOS drive needs its operation modes and rotary scaling, too. The keys process_data.objects and \
         drive_settings name what the drive has: where they are given, all of it must be there.";
    TOO_SHORT = "AX326", "a time that the changeover cannot keep",
        "The drive's answer takes the cycles of P-AXIS-00191, and braking takes its ramp. A time that ends before would stop the \
         spindle with an error at each changeover.";
    TOO_LONG = "AX327", "a time of too many cycles",
        "The times of the changeover are counted in cycles, up to 2^24, which single precision still counts exactly. A brake's \
         time follows from the deceleration, where it is not given.";
    GANTRY_SPINDLE = "AX328", "a changeover in a gantry",
        "The axes of a gantry have one position. In velocity control they would lose it, and each other.";
    STEP = "AX329", "conventional feedforward together with a changeover in the drive",
        "Where the drive controls the position, conventional feedforward leads its position command by v_feedforward / Kv. The \
         command that is computed for the change to position control does not, and would step by that at the changeover. This is \
         our inference from how the command is made. Use an additive velocity, or the feedforward of the drive.";
    NO_VELOCITY = "AX330", "a velocity command that is always 0",
        "In velocity control the drive gets its velocity command in the scaling of P-AXIS-00205 to 00207, whose numerator \
         (P-AXIS-00206) is 0.";
    LOOP_LAG = "AX331", "a position lag near half a revolution",
        "Position control takes the lag the shortest way: at half a revolution it would turn the spindle the other way. The lag \
         is (1 - w) v / Kv. In the CNC it counts up to Von, and the block spindle_axis stops the spindle with error_id 48 at \
         170 deg. In the drive it counts where position control is taken up, at Voff. Write a larger Kv (P-AXIS-00099), if the \
         drive follows it, a lower v_velocity_control_on in the CNC, a lower v_position_control_on in the drive.";
    NOT_RISING = "AX332", "frequencies of a response that do not rise",
        "The lines are sorted by frequency, and each frequency stands once. Two measurements in one file, one after the \
         other, look like that.";
    GAP = "AX333", "a gap in a frequency response",
        "Lines are missing, or they are further apart than a stage is wide. A vibration can hide there, and the loop \
         would be calculated with a smooth curve through the gap. Weak lines stay in, with their coherence.";
    TOO_FEW_LINES = "AX334", "too few lines of a frequency response",
        "Fewer than ten lines below half of the sampling frequency do not show a response.";
    NOT_REACHED = "AX335", "a frequency response that does not reach a stage",
        "The band of each active stage, f0 and its half-power width, must lie within the lines. What the drive does there \
         decides whether the stage is stable.";
    MAGNITUDE_UNIT = "AX336", "the magnitude of a response in another unit",
        "A factor is never negative, and dB of a response are below 0 above its bandwidth. The values contradict the unit \
         that the column has.";
    PHASE_UNIT = "AX337", "the phase of a response in another unit",
        "The phase falls by its dead time and by what belongs to the magnitude (minimum phase). In the unit that the \
         column has, the dead time cannot be; in the other one it can.";
    PHASE_SIGN = "AX338", "the phase of a response with the other sign",
        "A phase that rises with the frequency is that of a motor that answers before the command. Some programs count a \
         lag as positive, some divide input by output.";
    INTEGRATES = "AX339", "a frequency response that integrates",
        "From the commanded velocity to the motor's velocity the response is 1 at low frequencies. This one falls by 20 \
         dB a decade with -90 deg: it is that of a position, or of an open speed plant from current to velocity.";
    NOT_ONE = "AX340", "a frequency response that is not 1 at low frequencies",
        "A motor follows slow commands: the magnitude of the lowest lines is near 1 and their phase near 0. A factor \
         shows different units or a gear between the two velocities, 180 deg a sign; an open loop or a control deviation \
         is not a response from the commanded velocity.";
    CLOSED_LOOP = "AX341", "a closed loop given as an open speed plant",
        "The open speed plant, from current to velocity, integrates at low frequencies. A response of 1 at 0 deg is that \
         of the closed loop: with Kp and Tn it would be closed twice.";
    DEAD_TIME = "AX342", "a dead time below one cycle",
        "What a cycle commands is read in the next one at the earliest. A shorter dead time means that the signals were \
         recorded in the drive, or that a channel is late: the real loop has more delay, and less margin, than this \
         response shows.";
    UNCERTAIN = "AX343", "a frequency response that is not known at a stage",
        "Two standard errors of the magnitude at f0 are half of it or more. No weight of this stage can be said to be \
         safe. Measure again, or switch the stage off.";
    SPEED_LOOP = "AX344", "a speed loop that does not close",
        "The open speed plant with Kp and Tn is above 1 at the lowest line and below 1 at the highest. If it is not, Kp \
         has another unit than the plant, or the lines do not reach far enough.";
    UNSTABLE = "AX345", "a block that starts ON and is unstable",
        "With these weights the loop oscillates, though its drive is ideal: the motor does exactly what was commanded one cycle \
         before (or is the stated drive). A stage turns its phase from +90 n to -90 n degrees across its band of \
         order n; with a large weight the loop is lost where the gain is still 1 and the phase has turned by 180. Write the \
         smaller weight, a higher damping ratio or q_factor, a lower order. Where the position loop oscillates \
         without any stage, the message names Kv (P-AXIS-00099) instead. SET_POINT acts inside the position loop where the \
         CNC controls the position (assumed where neither kenngr.antr_typ nor antr.operation_mode says so). A stage whose \
         all-pass is made for the lag of a real drive is stable on that drive only: state it (drive.delay, drive.time_constant, \
         or drive.response with a measured response), or start with DRYRUN. On a test stand without a machine the key \
         accept_unstable makes a warning of it.";

    EXCITES_TOO_MUCH = "AX346", "an excitation above the limit of the axis",
        "v_excite is added to the commanded velocity as v_add is. Where the axis has improved position control, its limit \
         (P-AXIS-00757 times P-AXIS-00212) holds for the amplitude too. Write a smaller excitation.amplitude.";
    EXCITES_TOO_BRIEFLY = "AX347", "a period of the excitation that is shorter than its fade",
        "The excitation rises in 0.1 s within the first period, which is not measured. A period lasts (2^bits - 1) clock \
         cycles. Write more bits, or a longer clock.";

    LOWEST_F0 = "AX348", "no lowest f0 for the design on the controller, or one above an f0 of the set",
        "With tunable = \"parameters\" the controller designs sets for any f0 from lowest_f0 on. The fade lasts at least one period \
         of lowest_f0, and the watch counts in its periods: both are part of the code of the block, so no set changes them. Write \
         the lowest f0 that anybody may type, at or below every f0 of the set. A lower one makes the fade longer.";
    WINDOW_BEYOND = "AX349", "a window in which a spindle is taken into position control above Von",
        "Position control begins at up to Voff (P-AXIS-00768) + spindle.window, and ends at Von (P-AXIS-00767): the spindle \
         would be taken into position control faster than it leaves it. Without spindle.window the window is at least two \
         steps of the encoder (P-AXIS-00234/00233) in a cycle: a short cycle and an encoder with few increments make it wide. Write a \
         larger Von, a smaller spindle.window, a longer cycle, or use an encoder with more increments.";
    KV_UNSTABLE = "AX350", "a gain of the position controller with which its loop is unstable",
        "What the position controller in the CNC commands in a cycle is read back a cycle later at the earliest. With Kv \
         (P-AXIS-00099) and the cycle time T the loop is stable below Kv T = 2 sin(90 deg / (2 d + 1)), where d is the delay in \
         cycles: 1 with an ideal drive, 0.618 with two cycles. The delay is drive.delay, or else P-AXIS-00191, or else one \
         cycle; drive.time_constant counts too. The unit of P-AXIS-00099 is 0.01/s: 2000 is 20/s. Write the gain of the machine.";
    SWAPPED_MODES = "AX351", "operation modes of a CANopen drive the wrong way round",
        "P-AXIS-00463 is the mode of position control, 8 (cyclic synchronous position mode), and P-AXIS-00464 that of velocity \
         control, 9 (cyclic synchronous velocity mode). Swapped, the drive would take each command for the other one. One manual \
         prints `CSP(9)` for the velocity mode, which is CSV(9).";
    ONLY_VELOCITY = "AX352", "improved position control of a spindle that has velocity control alone",
        "With P-AXIS-00767 and 00768 at 0 and position control in the drive, the drive has velocity control alone: the spindle \
         is never under position control, and the stages would never act.";

    NO_STAGE = "AX401", "no stage is active",
        "Improved position control does nothing; without feedforward and position control the block is generated all the same, \
         and puts out 0. Give a stage the mode DIRECT, INDIRECT or SET_POINT (P-AXIS-00753), or enable OFF.";
    MUTED = "AX402", "the limit is 0",
        "v_add_max_fact is 0, which is its default: whatever the stages want to add is limited to 0. Set it, in 0.1 % of \
         the largest velocity of the axis.";
    GEAR = "AX403", "several gear steps",
        "Parameters of several gear steps are given, and one of them is used: step 0, or the one that the key `gear` names. \
         Write the key `gear` below the axis of a set to choose. What the chosen step lacks does not come from another one, but \
         is its default: write it as getriebe[i] of that step.";
    GENERATIONS = "AX404", "old and new parameters together",
        "P-AXIS-00756 is still valid, but should not be combined with filter[k] and P-AXIS-00850, which came with its \
         successor.";
    SET_POINT = "AX405", "a weight too large for SET_POINT",
        "SET_POINT multiplies the command by 1 - w H. With the damping ratio D its best weight is 4 D^2 / (4 D^2 + 1); above \
         twice that it amplifies. Weights that suit INDIRECT do not suit SET_POINT. With position control in the CNC the command \
         contains the actual position: the stage multiplies the position loop, which may then have little reserve (Ms above 2), \
         mostly with f0 below about Kv/6. Write the weight of the message, a larger q_factor, or a smaller Kv.";
    LAG = "AX406", "feedback from the load",
        "v_direct lags behind the command by the drive, the mechanics and the delay. Up to 90 degrees of lag at f0 the stage \
         damps, beyond it an all-pass is mandatory and the weight should stay at or below 1. Measure the lag first.";
    SQUEEZED = "AX407", "a frequency near half the sampling frequency",
        "The filter is exact at its centre and its edges, but its upper skirt ends at half the sampling frequency. Shorten the \
         cycle time, or keep fg_f0 below 0.35 of the sampling frequency; if neither is possible, nothing else is wrong with it.";
    DELAY = "AX408", "the delay turns the phase",
        "The delay costs 360 f0 Ts (cycles + 0.5) degrees at f0: the cycles of P-AXIS-00191 (antr.nbr_delay_cycles), where the \
         list has it, else one at the least, and half a cycle for the hold. Drive and mechanics come on top. Beyond 90 degrees \
         the stage excites the vibration, unless an all-pass turns the phase back.";
    OVERLAP = "AX409", "stages overlap",
        "The -3 dB bands of two stages intersect, so that each acts on the other's vibration. Put them in operation together, \
         with small weights.";
    POLARITY = "AX410", "an all-pass that inverts",
        "At its own frequency, and close to it, an all-pass turns by 180 degrees: the stage pushes where it pulled. That is \
         right only where the lag is near 180 degrees.";
    NO_TYPE = "AX411", "a filter without a type",
        "filter[1] is NO_FILTER unless its type says otherwise; its other parameters then have no effect.";
    SLAVE_STAGES = "AX412", "stages on a gantry slave",
        "The slave's stages are not enabled, but the mode is an input of the block: it must stay OFF.";
    INERT = "AX413", "a key without effect",
        "The key acts in another mode of its stage only.";
    NO_VELOCITY_DATA = "AX414", "ADD_VEL without an additive velocity in the process data (70350)",
        "The controller reports its error 70350. The output is switched off, as if ADD_VEL were not there. If the drive has the \
         process datum, the key process_data.additive_velocity says so: no axis list holds it.";
    NO_TORQUE_DATA = "AX415", "ADD_ACC or ADD_JERK without an additive torque in the process data (70351)",
        "The controller reports its error 70351. The output is switched off. If the drive has the process datum, the key \
         process_data.additive_torque says so: no axis list holds it.";
    VELOCITY_DELAY = "AX416", "delay of the additive velocity out of range (70349)",
        "The delay is below six cycles. The controller reports its error 70349 and corrects the delay to 0, and so does the \
         block. Where a manual speaks of one cycle in an example, its parameter reference says six.";
    TORQUE_DELAY = "AX417", "delay of the additive torque out of range (70348)",
        "The delay is below six cycles. The controller reports its error 70348 and corrects the delay to 0, and so does the \
         block. Where a manual speaks of one cycle in an example, its parameter reference says six.";
    TORQUE_SCALE = "AX418", "torque scaling with the denominator 0 (110465)",
        "The controller reports its error 110465, sets the factor to 0 and puts out no additive torque; the block does the same.";
    JERK_FACT = "AX419", "jerk factor with the denominator 0 (110473)",
        "The controller reports its error 110473 and corrects the denominator to 100; the block does the same.";
    DENOMINATOR = "AX420", "a denominator of 0",
        "The manual's range has the 0, by which nothing can be divided. What the quotient weights is left out; write 1 where no \
         denominator is meant.";
    NO_REFERENCE = "AX421", "no nominal torque",
        "The additive torque is scaled to the nominal torque of the motor (P-AXIS-00392), which is 0. It is switched off.";
    INERT_DEFAULT = "AX422", "a default that leaves feedforward without effect",
        "The parameter has its default, with which the quantity contributes next to nothing: a time constant of 1 us, a jerk \
         factor of 1/100, a load of 1e-6.";
    TWICE = "AX423", "feedforward in the CNC and in the drive",
        "A drive that controls the position mostly feeds forward itself: SERCOS has the gains S-0-0296 (velocity) and S-0-0348 \
         (acceleration), CANopen the weight 3062h. With both, the axis leads. P-AXIS-00833 (00766) says what the drive has of the \
         velocity; no parameter says what it has of the acceleration.";
    LEADS = "AX424", "feedforward weighted above 1",
        "Above 1 the axis leads its command and the contour suffers. 0.7 to 1 is usual. The torque of ADD_ACC has the plain weight \
         P-AXIS-00225/00226 in addition; the manual's example has 1.2.";
    TWO_MEANINGS = "AX425", "one parameter with two meanings",
        "With ADD_ACC the quotient P-AXIS-00225/00226 is a plain weight, without it a time constant in us. JERK takes it for \
         the time constant.";
    NO_EFFECT = "AX426", "parameters without effect",
        "The parameters are given, and nothing of what this axis does uses them: feedforward that P-AXIS-00223 does not switch \
         on, a scaling of a command that the drive does not get, process data that are not put out. The keys fade, ride_through, \
         tunable, lowest_f0, tuning_limit and tuning_weight are for active stages; in a gantry the stages of the master act.";
    SCALINGS = "AX427", "unequal scalings in a gantry",
        "A slave puts out its master's additive velocity in its own scaling. Where the scalings differ, so do the increments: \
         that is right for unequal drives only. Where one of the two turns and the other does not, not even the unit is the \
         same.";
    MASTER_UNKNOWN = "AX428", "the master of a gantry is not there",
        "A list alone has no master. In a set with both, the slave's block `axis` puts out the master's \
         additive velocity.";
    DISABLED = "AX429", "feedforward is disabled",
        "global_disable (P-AXIS-00256) wins over G135: the block puts out 0.";
    SINGLE_POSITION = "AX430", "positions in single precision",
        "Single precision has 24 bits: a position beyond 16.7 m, or 16777 deg, loses micrometres or thousandths of a degree, \
         and a quarter of that already below. A position controller in the CNC takes the following error instead.";
    KV_DEFAULT = "AX431", "the gain of the position controller is its default",
        "The list has no getriebe[i].kv (P-AXIS-00099). Where the drive controls the position, Kv must be that of the drive \
         (SERCOS S-0-0104 in 1000/min, where 20/s is 1.2; CANopen 30C0h:01 in 1/s).";
    NO_WAY_OUT_YET = "AX432", "improved position control that may not be enabled",
        "The drive controls the position, and its process data have no additive velocity: nothing would go out. The mode is \
         OFF at start; it must stay so until the drive has the process datum and process_data.additive_velocity says so.";
    ZERO = "AX433", "a factor of 0",
        "The factor is written as 0, and all that it weights is 0. This is legal, but usually the list is unfinished: \
         write the value, or remove what it weights.";
    SHORT_TIME = "AX434", "a time constant that no drive has",
        "With ACC and JERK the quotient P-AXIS-00225/00226 is the drive's time constant in us. Below a twentieth of a cycle it \
         does nothing: mostly it was meant as a weight, which it is with ADD_ACC only, or in ms. Above 0.1 s it adds far more to \
         the velocity command than any drive lags: mostly the denominator is missing. The factor of the jerk \
         (P-AXIS-00337/00338) is 1/2 for a delay and (T2/Ta)^2 for a drive of second order; above 1 no drive has it.";
    SATURATES = "AX435", "process data too small for the axis",
        "At the largest velocity of the axis (P-AXIS-00212), with v_add at its limit (P-AXIS-00757) if it is a part of the datum, the \
         command has more increments than the type of its process datum holds. The block saturates there, and says so at run \
         time in `limited`. Give the datum INT32, or scale it with fewer increments.";
    RESONANCE = "AX436", "a simulated oscillation with little damping",
        "In the mode INDIRECT the simulated oscillation has sqrt(1 + 1 / (4 D^2)) times its input at f0, which the weight \
         multiplies: more than 14 times the motor's velocity is fed back. Take a larger damping ratio or a smaller weight, \
         and look at v_add_calculated in DRYRUN first.";
    CAPPED = "AX437", "a weight above the cap",
        "The controller caps a weight (P-AXIS-00754/00755) above 7 at 7, without a message. Usually the denominator is \
         missing and therefore 1: 700 is meant as 700/100.";
    SLOW = "AX438", "a largest velocity that looks like another unit",
        "P-AXIS-00212 is in um/s, of a rotary axis in 0.001 deg/s. Below 5000, which is 5 mm/s or 5 deg/s, a value was mostly \
         written in mm/s, m/min, deg/s or revolutions/min. Above 10000000, which is 10 m/s, that of a linear axis was mostly \
         written in um/min or nm/s. The limit of improved position control is a part of it.";
    STARTS_ON = "AX439", "a block that starts ON with the whole velocity as its limit",
        "The block acts as soon as it is called, and its limit lets it add the largest velocity of the axis: a stage that \
         excites the vibration drives the axis at full speed. Start with DRYRUN, look at v_add_calculated, then write ON with a \
         v_add_max_fact (P-AXIS-00757) that is a little more than what the vibration needs.";
    ASSUMED = "AX440", "a default that motion depends on",
        "The parameter is not given, and its default scales or limits what the block puts out. A default fits no particular \
         machine: write the value, even if it equals the default. The line `assumed` of check and generate lists all such parameters.";
    PROBE = "AX441", "a measuring probe together with feedforward",
        "Feedforward adds a cycle at the least between interpolator and position controller, which the controller does not \
         count in a measuring run. Its manual wants a longer stroke of the probe (P-AXIS-00086).";
    PREDECESSOR = "AX442", "the predecessor of a parameter",
        "P-AXIS-00265 and P-AXIS-00266 still work, and their values are adopted. New lists have P-AXIS-00767 and P-AXIS-00768 in \
         their place.";
    TAKEN_FOR_SPINDLE = "AX443", "an axis without a type that has a changeover",
        "The velocities of the changeover (P-AXIS-00767, 00768) belong to spindles. The axis type (P-AXIS-00018), whose default \
         is a translatory axis, is not given: the axis is taken for a spindle, with positions in 0.001 deg. Write the axis type.";
    NEVER = "AX444", "a changeover that never comes",
        "Velocity control begins above P-AXIS-00767, whose default is 33333 rpm. The spindle does not turn so fast, or is not \
         meant to: it would stay in position control.";
    ADDS = "AX445", "an additive velocity together with a changeover",
        "ADD_VEL sends the whole velocity as an additive command. In velocity control, and while the drive changes its mode, it \
         would get it twice. `spindle_axis` takes it out of `velocity_command`. With the block `spindle` alone switch it off \
         (G137) while `loop_closed` is FALSE, or use the feedforward of the drive.";
    TWO_WEIGHTS = "AX446", "two weights of the drive's feedforward",
        "P-AXIS-00833 replaces P-AXIS-00766. Both are given, and differ: the new one holds. Write what the drive has (SERCOS \
         S-0-0296, CANopen 3062h).";
    NOT_IN_SET = "AX447", "a change that no parameter set carries",
        "The set is taken over, and the block goes on with what it was generated with: its mode at start, the velocity below \
         which a sum counts as 0, the other blocks of the axis. Generate the blocks again where they are to follow.";
    LAG_TAKEN_UP = "AX448", "a position lag near half a revolution where position control is taken up",
        "The drive can take up position control at up to Voff + window: a spindle that turns when its drive comes on has any \
         speed up to that. The lag (1 - w) v / Kv that the drive needs there reaches 170 deg; from 180 deg on the drive turns the \
         spindle the other way. Write a lower v_position_control_on, a smaller window, or a larger Kv, if the drive has it.";
    LAG_ALONE = "AX449", "a position lag near half a revolution without feedforward",
        "With its feedforward the loop in the CNC lags little. Without it (G137, or a smaller percentage of G136) the lag is v \
         / Kv, and the block spindle_axis stops the spindle with error_id 48 at 170 deg. Write a larger Kv (P-AXIS-00099), a \
         lower v_velocity_control_on, or vorsteuer.default_active TRUE (P-AXIS-00255).";
    NARROW_WINDOW = "AX450", "a window narrower than the encoder's steps, or than 1 % of Voff",
        "A smaller window than 1 % of Voff is replaced by 1 % of Voff. An actual velocity from an encoder has steps of one \
         increment in a cycle. The spindle has slowed down where it is within spindle.window for three cycles: with a window \
         below two steps it may never have, and stops with error_id 42.";
    WITHOUT_ERRORS = "AX451", "a frequency response without standard errors",
        "The margins are those of exactly this response. With coherence and the number of averages, or with a standard \
         error, they are lowered by what is uncertain.";
    BEYOND_NYQUIST = "AX452", "lines of a response above half of the sampling frequency",
        "The block sees nothing above half of its sampling frequency: the lines are left out.";
    ZERO_HERTZ = "AX453", "a line of a response at 0 Hz",
        "The first line of an FFT holds the mean values, which are not a response. It is left out; below the lowest line \
         the response goes to 1.";
    LINE_MISSING = "AX454", "a line of a response that seems to be missing",
        "The distance of two lines is larger than those around. A curve through the lines replaces what was between them.";
    COARSE = "AX455", "lines of a response that are far apart",
        "A vibration as narrow as the stage needs lines at a quarter of the half-power width f0/Q, or it lies between two \
         lines. So does a resonance of the drive at which the response turns by more than 30 degrees from one line to the \
         next: the largest calm weight may be far too large.";
    ENDS_EARLY = "AX456", "a frequency response that ends soon above a stage",
        "A stage with a large weight mostly loses its stability above f0. Beyond the last line the value of the last line \
         holds, which need not be true.";
    UNIT_TAKEN = "AX457", "a unit of a response that its file does not state",
        "Only one unit fits to the numbers, and it is taken. Write it into the name of the column.";
    SLOW_RESPONSE = "AX458", "a frequency response as slow as a position loop",
        "Speed loops have bandwidths of 20 Hz and more, position loops one of Kv. The response may be that of positions, \
         or of a closed position loop.";
    SPEED_LOOP_NEAR = "AX459", "a speed loop with hardly any margin",
        "With this Kp and Tn the speed loop alone nearly oscillates. A drive that runs does not: one of them, or its \
         unit, is probably wrong.";
    LOW_COHERENCE = "AX460", "a low coherence at a stage",
        "The number of averages is unknown, so that no standard error follows from the coherence. With few averages this \
         response says nothing at f0.";
    WOULD_BE_UNSTABLE = "AX461", "weights with which an ideal drive oscillates",
        "The motor does exactly what was commanded one cycle before, which no drive can better, and the loop oscillates all the \
         same as soon as the mode is ON. Write the weight of the message, up to which the largest |S| of the loop is 2, or a \
         higher damping ratio or q_factor, or a lower order. An all-pass that is made for the lag of a real drive is the one \
         good reason: then state the drive (drive.delay, drive.time_constant, drive.response), and `axgen analyze` shows the \
         loop with it.";
    SPINDLE_UNIT = "AX462", "a velocity of a spindle that looks like another unit",
        "The velocities of a spindle are in 0.001 deg/s: 1 rpm is 6000. Its deceleration is in 0.001 deg/s^2: 1 rpm/s is 6000. \
         A number written in rpm is 6000 times too small: the changeover then begins at a standstill, or braking takes an hour.";
    KV_UNIT = "AX463", "a gain of the position controller that looks like another unit",
        "P-AXIS-00099 is in 0.01/s: 2000 is 20/s. A number written in 1/s is 100 times too small, and the position lag, v / Kv, \
         100 times too large.";
    GANTRY_KV = "AX464", "unequal gains of the position controllers in a gantry",
        "Without feedforward an axis lags by v / Kv. With unequal Kv (P-AXIS-00099) the axes of a gantry lag differently, and \
         the bridge is askew by (1/Kv1 - 1/Kv2) v while it moves.";
    NO_DENOMINATOR = "AX465", "a weight without its denominator",
        "A weight is P-AXIS-00754 / P-AXIS-00755, and without a line the denominator is 1: a numerator of 5 is a weight of 5, \
         500 %. Write both.";
    OTHER_AXIS = "AX466", "a list of another axis",
        "The list that an axis of a set names has the name of another axis (kopf.log_achs_name). Mostly it is the wrong file, \
         and the block would be made from the parameters of another machine part. Name the right list, or give the axis of the \
         set the name in the list.";
    COMMAND_FILTER = "AX467", "a command filter together with improved position control",
        "The list has a filter of the position command that is on: filter[i] (P-AXIS-00319, 00140), filter_fir (P-AXIS-00573, \
         00586) or an HSC filter, which the NC program switches on. It delays the command and turns its phase. A stage in the \
         mode SET_POINT takes the command, and a comparison of the axis with and without stages includes the filter. Tune the \
         stages with the filters that the machine runs with, and tune again when a filter changes.";
    BLIND_WATCH = "AX468", "a watch that can see nothing in time",
        "The watch over the loop (key watch) looks for a sum of the stages that reaches the limit (P-AXIS-00757) again and \
         again. With a limit of 0, without a stage and on a gantry slave it looks at nothing. With a limit of the whole of \
         vb_max the axis oscillates at full speed before the watch sees it.";
    TUNED_TO_0 = "AX469", "tuning that starts at 0",
        "With tuning_limit, or the tuning_weight of each stage, 0 at start the block adds nothing until the caller writes the \
         input. Where nothing is connected to the input, it never acts.";
    NC_PASSED = "AX470", "words of an NC program that have no effect here",
        "A scenario moves one axis or one spindle. Words of the tool (T, D, H, M6, G40, G43, G44, G49), of the machine (M0, M1, \
         M7 to M9, most other M words) and settings (G17 to G19, G80, G94, O and the like) are passed over. G20 and G70 are \
         inches, G21 and G71 millimetres; a mirroring by G21 is not known.";
    NC_PATH_MODE = "AX471", "a path mode of an NC program that has no effect here",
        "G09, G60, G61, G64, #SLOPE, #HSC and the like say how blocks are joined. In a scenario each block ends with a stop \
         within the window of the axis: the motion is harder than on a machine that smooths the path, and takes longer.";
    NC_OFFSET = "AX472", "a position of an NC program that is not known",
        "Zero offsets (G54 to G59) are data of the machine and are taken as 0. A block with G28, G30 or G53 goes to a position \
         of the machine and is not made: the axis stays where it is until the next move.";
    NC_ASSUMED = "AX473", "an NC program that leaves something open",
        "Controllers differ here, and the message says what was taken: blocks with `/` run, P of a dwell without a point is ms \
         from 100 on, G92 gives the present position another number, G01 before any F is made with vb_max, a program without \
         M30 or M2 ends with its file, and nothing after its end is read.";
    NC_OTHER_DRIVE = "AX474", "commands of an NC program for another drive",
        "The scenario of an axis has no spindle, and that of a spindle has no axes; an axis that the program never moves stands \
         still. Run the program on the other axis of the set too, or name the axis with --program-axis.";
    NC_LIMITED = "AX475", "a feed or a speed above vb_max",
        "The controller limits what the program asks for to vb_max (P-AXIS-00212), and so does the scenario. The axis then moves \
         slower than the program demands: correct vb_max or the program to fit the real machine.";
    NC_STOPPED = "AX476", "an NC program that is longer than its scenario",
        "A scenario stops after 200,000 cycles, or after the number of --cycles. Everything before that is a whole stimulus. \
         More cycles take more memory, about 400 bytes each, and more time in every engine.";
    NC_FOLLOWS = "AX477", "an axis that follows an axis of another name",
        "NC programs name axes by a letter, X1=50 by a letter and a number. The axis of the set has another name, and follows \
         the program's axis that the message names. --program-axis chooses it.";
    NC_AXIS = "AX478", "an axis of TwinCAT NC",
        "The NC has no axis list. Its largest velocity is P-AXIS-00212, PosKp is P-AXIS-00099, the scale of the encoder \
         P-AXIS-00234 and 00233, and nothing else of it is taken. TwinCAT omits defaults from its files, and axgen \
         does not know them: write these values. The cycle time is that of the SAF task, which a file of one axis \
         does not hold. Stages of improved position control do not exist in the NC: write them in the set.";
    WIDE_WINDOW = "AX479", "a window wider than the velocity that it belongs to",
        "Position control begins when the spindle is within spindle.window of Voff (P-AXIS-00768), so that it can begin at more \
         than twice Voff, with a jerk of that size. Without spindle.window the window is at least two steps of the encoder \
         (P-AXIS-00234/00233) in a cycle: 1024 increments per turn and 250 us make 468.75 rpm. Write a larger Voff, use a longer \
         cycle or an encoder with more increments, or write a smaller spindle.window, if the encoder allows it.";
    OTHER_INTERVAL = "AX480", "a recording of another interval than the block's cycle",
        "A sample is one cycle of the block. The header or the column of times says that these columns were sampled at other \
         times. Record them in the task of the block with its cycle, or leave them out with --map NAME=-. A column of times \
         that counts something else is left out the same way.";
    SAMPLES_LOST = "AX481", "a recording in which samples are missing",
        "The column of times does not go on by one cycle from row to row. The block's state after a gap is unknown, so that \
         nothing after it can be compared. Record again, or cut the file before the gap. Nor is a spectrum taken across a gap.";
    PROVES_NOTHING = "AX482", "a recording that proves nothing",
        "Any block agrees with a recording in which nothing moves, or in which the mode is OFF throughout. Record a move with \
         mode ON, from a cycle on in which the block is at rest, with the outputs that the move changes.";

    KV_NEAR = "AX483", "a gain of the position controller with little phase margin",
        "The position loop in the CNC is an integrator with the delay of its drive. With an ideal drive, one cycle, it is \
         unstable from Kv T = 1 on, and up to Kv T = 2 sin(10 deg) = 0.347 it keeps a phase margin of 60 deg, with which a step \
         overshoots by about 5 %. AX350 says how other delays count. A real drive is slower and has less: write a smaller Kv \
         (P-AXIS-00099), or use a shorter cycle.";
    COARSE_COMMAND = "AX484", "a velocity command or an additive velocity of few increments",
        "The velocity command of the drive is rounded to whole increments: 0 or 1 here, at the velocity of the change to \
         position control, or at the largest one. An additive velocity needs 10 at its limit v_add_max_fact (P-AXIS-00757), \
         without stages at vb_max: it is mostly a small part of this, and less than half an increment is lost. The scaling is \
         P-AXIS-00205 to 00207, with position control in the CNC P-AXIS-00129 and 00128. Write the scaling of the drive.";
    OTHER_MODE = "AX485", "an operation mode of a CANopen drive for another purpose",
        "The changeover sends a new command in each cycle. The modes for that are 8, the cyclic synchronous position mode \
         (P-AXIS-00463), and 9, the cyclic synchronous velocity mode (P-AXIS-00464). The manual allows any number, because \
         manufacturers have modes of their own; the manual of the drive says whether this one takes a command in each cycle.";
    LIMITS_NOTHING = "AX486", "a limit of a changeover that limits nothing",
        "The value is so large that what it limits never reaches it: a deceleration with which the spindle stops within a \
         cycle, a takeover window of half a revolution, a time of more than 10 s for the change of the operation mode. \
         Write a value that fits the machine.";
    GANTRY_LEAD = "AX487", "unequal feedforward in a gantry",
        "Feedforward takes away the lag v / Kv of an axis. If only one axis of a gantry has it, or if its quantities, weights, \
         time constants, delays or shift_time (P-AXIS-00165) differ, the axes lag differently, and the bridge is askew while it \
         moves. Write the same feedforward for all axes of the gantry.";
    TORQUE = "AX488", "an additive torque that no motor has",
        "The load (P-AXIS-00391) times the acceleration, in units of the nominal torque (P-AXIS-00392), is the additive torque. With \
         these numbers the nominal torque accelerates the axis by less than 0.01 m/s^2 or 10 deg/s^2. The load of a rotary motor is \
         an inertia in kg m^2 at the motor, that of a linear one (motor = \"linear\") a mass in kg; the angle of the motor follows from \
         the feed constant (P-AXIS-00362/00363), the gear ratio (P-AXIS-00234/00233) and, without a feed constant, \
         incr_per_rev (P-AXIS-00092). The line `additive torque` of check states what an acceleration becomes.";
    TURNS = "AX489", "a rotary axis whose drive may get a position of another turn",
        "With shift_time (P-AXIS-00165) the deviation XERR takes a position command that is up to 4 cycles old. If the command of the \
         axis steps by a turn (modulo), XERR jumps by a turn for as many cycles, and the drive with it; converting the actual \
         position does not help. The command must count on across turns, or shift_time must be 0. With conventional feedforward \
         (VEL, ACC, JERK) a SERCOS or CANopen drive gets x_command + v_feedforward / Kv, which leaves 0 to 360 deg before a modulo \
         command wraps. The command must count on, x_drive must be wrapped before it is sent, or the feedforward must be ADD_VEL. \
         Where the command counts on, nothing is wrong.";

    LEFT_OVER = "AX490", "a file that is not generated any more, and was edited",
        "An earlier run generated the file from this set. Its axis, block or target is gone, so that this run would have \
         removed it; but somebody has changed it, or put another file in its place. It stays, and a project continues to \
         compile it: a function block with old numbers acts on the machine. Delete it. To keep it as yours, take its line out of \
         axgen.manifest and the line `checksum` out of the file.";
    UNLISTED = "AX491", "a generated file that no set is known to generate",
        "axgen generated the file, but this set does not generate it, and axgen.manifest does not list it. An axgen without a \
         manifest made it, it was copied here, or its line is lost. It stays: whether another set still needs it is not known. \
         If one does, generate that set into this folder once, which lists it; else delete it.";
    MANIFEST = "AX492", "a manifest that cannot be read",
        "The file axgen.manifest says which set generated which files of the folder. A line of it is not an entry: mostly a \
         merge has left its marks. Keep the entries of both versions, in any order. Without the file the next run lists its own \
         files again, but removes nothing that was generated before.";

    EXCITES_COARSELY = "AX493", "an excitation with a short period",
        "The lines of the response are one period apart: 0.25 Hz with 4 s. A vibration whose half-power width (2 zeta f) is not four \
         lines wide is not resolved. Leave out excitation.bits and excitation.clock, unless only a quick look is wanted.";
    EXCITES_TOO_FAST = "AX494", "an excitation for which the axis is too slow",
        "The axis must move at 2.5 times the amplitude or faster while it is excited, so that the motor keeps its direction; with \
         the excitation on it that is 3.5 times the amplitude. P-AXIS-00212 is below. Write a smaller excitation.amplitude.";
    NO_WAY_FOR_EXCITATION = "AX495", "an excitation that cannot reach the drive",
        "The drive controls the position: the velocity command is in the drive, and v_excite can be added to its additive velocity \
         only (SERCOS S-0-0037, CANopen 60B1h, PROFIdrive NSOLL_B). The process data have none. If the drive has it, write \
         process_data.additive_velocity, and add v_excite there in the scaling of the drive.";
    GANTRY_EXCITATION = "AX496", "an excitation of one axis of a gantry",
        "No block passes v_excite on to another axis: a gantry slave gets v_add of its master alone. If only one axis is excited, the \
         bridge is pulled askew by the whole excitation. Give all axes the same keys excitation and start them in the same cycle \
         with one button: their sequences are then equal, cycle by cycle.";
    REVERSED = "AX497", "a sign that the CNC changes and the blocks do not",
        "P-AXIS-00231 (lr_hw[i].vz_stellgr), P-AXIS-00230 (lr_hw[i].vz_istw) and, on a spindle, P-AXIS-00159 (getriebe[i].reverse) \
         change signs between the CNC and the drive. The blocks do not know them: a block that takes the place of the CNC's \
         position controller then moves the axis in the wrong direction without an end, and a stage with the wrong sign excites \
         the vibration that it should damp. Change the same signs in the program that calls the block, and compare all signs \
         before the outputs are connected, as the commissioning page describes.";
    VARIABLE_KV = "AX498", "a Kv of the CNC that depends on the velocity",
        "With P-AXIS-00244 (getriebe[i].dyn_kv.dyn_kv_active) the CNC interpolates Kv between P-AXIS-00245 (kv1) and 00247 (kv2). The \
         blocks position_control and axis have one Kv, P-AXIS-00099, and the margins of the stages are calculated with it. \
         SERCOS and CANopen drives do not have this function.";
    GANTRY_COUNTER = "AX499", "one axis of a gantry that counts its calls",
        "With the key cycle_counter a block stops with error 9 after skipped or doubled calls. If only one axis of a gantry has \
         the key, it stops alone, and the other one goes on: in a simulated loop the bridge was 95 mm askew, and 0.9 mm with the \
         key in both axes. Give all axes of the gantry the key, and stop all of them after an error of one.";

    NO_INTERVAL = "AX500", "a recording without a sampling interval",
        "The file has neither a column of times nor the line SampleTime of an export, or its times do not rise by the cycle of a \
         controller. Without it no frequency is known. Record the time too, or give --cycle-time with the interval of the rows.";
    TWO_RATES = "AX501", "channels that were not sampled together",
        "The channels have different sampling intervals, or were sampled at different moments within a cycle, or at uneven \
         times. Each would show a vibration with another phase, and a response between them would be wrong. Record all channels \
         in one task with its cycle, or leave the others out with --map NAME=-.";
    MEASURED_TOO_SHORT = "AX502", "a recording that is too short to be measured",
        "A vibration needs 0.55 s at constant speed, or 0.55 s after a ramp's end. A response needs 4 whole periods of \
         the excitation after the one in which the axis settles, 8 by default.";
    MEASURED_AT_REST = "AX503", "a recording in which nothing moves",
        "At rest nothing excites the vibrations of a move, and friction holds the axis. Record ramps with the usual acceleration, \
         at least 1.5 s at constant speed between them, and 1.2 s of rest after the last one.";
    MOTOR_REVERSES = "AX504", "an excited motor that changes its direction",
        "Friction changes its sign with the velocity of the motor and acts as an excitation of its own. It repeats with the \
         excitation, so that the coherence stays high while the response is wrong by several dB. Excite while the axis moves at \
         constant speed, 2.5 times the amplitude or faster.";
    CLIPPED = "AX505", "a channel that is clipped",
        "The channel stays at its largest value, to the last digit, and comes there and leaves from there suddenly: the sensor or \
         the recorder was at its limit. Clipping makes lines that the machine does not have. Choose a larger range.";
    UNITS_DIFFER = "AX506", "velocities that do not fit each other, or the kind of axis",
        "The motor follows the commanded velocity at low frequencies, so that both have the same size and sign. A factor of \
         1000 is mm/s instead of um/s, -1 a motor that counts in the other direction. The block takes both in um/s (rotary \
         axes: 0.001 deg/s) in the direction of the command. A rotary axis is recorded in degrees or revolutions: millimetres are \
         probably the recording of another axis.";
    NOT_OF_THE_TASK = "AX507", "channels of which one is from elsewhere",
        "Between the cycle that writes the commanded velocity and the cycle that reads its effect lies a whole number of cycles, \
         at least one, if the task of the block records both. The dead time of this recording is not one. A channel was recorded \
         in the drive or in another task. A response with a wrong dead time makes an unstable set look stable.";
    WHOLE_CYCLES = "AX508", "a dead time whose cycles cannot be checked",
        "One cycle more of delay and a channel that is recorded one cycle late give the same recording to the bit. Make sure that \
         the task that runs the block recorded both channels, in the cycle in which it used them; an unseen cycle of delay makes a \
         stated Ms of 1.7 truly 2.5.";
    CHANNEL_LATE = "AX509", "a channel that is later than another one",
        "Two channels that follow each other in a known way, as a position and its velocity, are apart in time. One of them is \
         filtered, or recorded by another task. Record both in the task of the block.";
    NOT_EXCITED = "AX510", "a recording without the excitation",
        "No periods of the sequence are found in v_excite, or else in v_cmd. Give --excitation BITSxCLOCK as the recording was \
         made, record v_excite too, and record all of the excitation.";
    STAGES_ACTED = "AX511", "a recording with active stages",
        "v_add is not 0: the recording shows what the stages leave of the vibrations. Record with all stages OFF or DRYRUN.";
    UNCERTAIN_LINES = "AX512", "a response that is uncertain",
        "Two standard errors are half of the response or more in these bands. A stage with f0 there cannot be proposed. Measure \
         more periods, or with a larger amplitude.";
    DOUBTFUL_PEAK = "AX513", "a vibration that is in doubt",
        "A second peak has 0.3 of the power of the first one or more, so that which of them matters is not known; or the peak is \
         at the edge of the spectrum, where its maximum may lie beyond. Record longer, or with a sensor at the tool.";
    SIDE_UNKNOWN = "AX514", "a vibration whose side is not known",
        "Stages damp what enters at the motor. What enters at the load looks the same to the motor. A sensor at the load shows \
         the side, if a_load and v_motor are recorded in a move and in an excitation (--excited FILE).";
    NO_CHANNEL = "AX515", "a recording without the channels that are needed",
        "Segments need a command: x_command, v_command or v_cmd. Vibrations need a_load, v_direct, v_motor or a following error. A \
         response needs v_cmd (or v_command) and v_motor. --map SCOPE=SIGNAL names the column of each.";
    WITHOUT_STAGE = "AX516", "a vibration without a stage",
        "A stage acts at the motor. It cannot damp what enters at the load, and |S| says nothing of what the load does then: \
         change its cause, a gear or a mesh for example. A block has three stages: the three strongest vibrations get one.";
    OTHER_CYCLE = "AX517", "a recording of another cycle time",
        "A stage is designed for the cycle time of the set. What it does to a recording is known only if the recording has a \
         sample for each cycle: record in the task that runs the block.";
    NOT_AT_REST = "AX518", "a recording that does not begin and end at rest",
        "What stages would have made of a recording is known only if nothing happens before and after it. Record from rest to \
         rest, or cut the file where the axis stands still.";
    NO_PROPOSAL = "AX519", "no stage can be proposed",
        "The recording shows no vibration at constant speed or after a ramp, the response has no line, or no weight is safe with \
         this drive. The message says which.";
    HARDLY_USEFUL = "AX520", "stages that are hardly useful",
        "They would leave more than 0.8 of every vibration: a larger weight would not be safe. Improve the response of the drive \
         first: less delay between the position controller and the drive, or a faster velocity controller.";
    FIRST_STAGES = "AX521", "first stages without a response",
        "The response of the drive is not known. A tenth of the weight that a usual drive bears is safe on nearly every axis, \
         and leaves about 0.9 of a vibration. Measure the response with an excitation, and give it with --excited or --response.";
    NOT_PREDICTED = "AX522", "stages whose effect is not known",
        "What stages would do to a recording follows from the response of the drive to v_motor. Without a response, for a stage \
         that takes another velocity, and without an active stage, nothing is predicted.";
    LIMIT_TOO_LOW = "AX523", "a limit of v_add below what the stages add",
        "P-AXIS-00757 limits v_add to a part of the largest velocity. Stages that reach the limit act less than predicted. The \
         message has the least v_add_max_fact for each proposal.";
    OSCILLATES = "AX524", "stages with which the loop oscillates",
        "With the response of the drive as measured, half a cycle later, or with 15 % less or more load the loop is unstable. \
         Where it is unstable as measured, nothing is predicted. Choose smaller weights.";
    NOT_WRITTEN = "AX525", "stages that cannot be written there",
        "--apply writes the stages where the axis has its parameters: in the set, or in an axis list that is given as the set. It \
         writes nothing where both have values of an axis, or where a key has a form that it cannot edit. The message says where \
         to write instead.";
    FOREIGN_LINE = "AX526", "a response with a line that the excitation does not make",
        "Something that turns with the axis, such as the mesh of a pinion, makes a line of its own. It repeats with the excitation, so \
         that its coherence is high, while the response is wrong there by up to 18 dB. Excite at another speed.";
    OUTLIER = "AX527", "a wrong sample in a recording",
        "One sample of a sensor is more than 10 times all others, as after a lost frame or a loose contact. It hides all lines \
         of the spectrum, and makes wrong which side a vibration comes from. Record again, or correct the sample in the file.";
    ASSUMED_UNIT = "AX528", "a unit of a recording that is assumed",
        "The file states no unit that axgen knows for these values or times. The unit is taken that makes them plausible, which \
         can be wrong by a factor of 10 or 1000. State the unit in the name of the column.";
    UNSETTLED = "AX529", "stages with which the load settles worse",
        "A stage also acts after a stop: the following error that it causes is made up for slowly, and a narrow stage rings on. \
         If the load moves more than 1.1 times as much then as without stages, the stages are not proposed. Choose smaller \
         weights or a smaller Q, or a smaller jerk of the ramps, so that a stop excites less.";
    UNUSABLE_TIMES = "AX530", "a recording whose rows do not show when its samples were taken",
        "Some times run backwards, as those of a counter that wraps, or have different samples, as times with too few digits. Or a \
         scope without columns of times filled the rows of its slower channels with their previous value. Each frequency would be \
         wrong by a factor. Export the times with all digits; rows that repeat a sample together with its time are skipped.";
    UNSTABLE_USUALLY = "AX531", "weights with which usual drives oscillate",
        "Nothing says which drive the axis has. The loop is stable with an ideal drive, and oscillates both with a delay of 1.5 \
         cycles and with the same delay and a time constant of 3 ms. Most drives are one of these or slower. Write the smaller \
         weight, or state the drive as measured: drive.delay, drive.time_constant, drive.response. The block may start ON: a \
         drive that is faster than both is possible.";
    SHORTER_DELAY = "AX532", "a stated delay below that of the controller",
        "drive.delay replaces P-AXIS-00191 in the tests of the loops. If the motor really answers after as many cycles as \
         P-AXIS-00191 says, a smaller drive.delay hides an unstable loop. Write the same number or more, or correct P-AXIS-00191.";
    UNUSED_OF_DRIVE = "AX533", "a property of the drive without effect",
        "A measured response contains the time constant, and replaces it; drive.delay counts with it, as the delay that the \
         measurement lacks. response_from, speed_gain and speed_integral_time describe a response: without one they do nothing, \
         and the last two belong to a response from the current. A key causes a warning, an option of the command line an error.";
    ACCELERATES_BEYOND = "AX535", "a changeover that ends near half a revolution in a cycle",
        "Above P-AXIS-00767 the drive gets the command to change to velocity control, and stays in position control until it has \
         done so. The spindle accelerates meanwhile. If it reaches 180 deg in a cycle before the drive displays velocity \
         control, it stops with error_id 44. The acceleration of the interpolator is taken as spindle.deceleration, and the \
         time as spindle.mode_timeout.";
    LAG_UNSEEN = "AX537", "a position lag that can grow unseen",
        "The block spindle_axis stops the spindle with error_id 48 where the loop in the CNC lags by 170 deg. It compares the lag \
         with that of the last valid sample. While three samples are missing, the lag of a blocked spindle grows by the way of \
         four cycles. If that is a turn or more, the spindle can turn the other way without an error.";
    LOW_F0 = "AX546", "a centre frequency that is probably in kHz",
        "The fade lasts at least one period of the lowest f0: below 0.5 Hz more than 2 s. OFF takes as long. fg_f0 (P-AXIS-00751) \
         is in Hz. If the vibration is as slow as this, nothing is wrong.";
    SLOW_UNCERTAIN = "AX547", "slow lines of a response that are not known",
        "At a fifth of the lowest f0 and below no stage acts. Lines whose two standard errors are half of their magnitude or more \
         are left out there: with them every weight would count as unstable. A curve through the other lines replaces them, which \
         goes to 1 at 0 Hz, because a motor follows slow commands.";
    MUCH_FOLLOWING_ERROR = "AX548", "stages with which the axis lags far behind its command",
        "Stages that damp a vibration also change slow motion: the following error may grow, and the axis reaches its position \
         later. The prediction is that of the recorded moves. Decide whether the process allows it.";
}

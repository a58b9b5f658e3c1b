//! Parameters in the manuals that axgen does not read, with the reason. No parameter of the table, no rule.

/// A parameter that is not read.
#[derive(Clone, Copy, Debug)]
pub struct Other {
    /// its name in the manuals
    pub name: &'static str,
    pub meaning: &'static str,
    /// the reason, and what axgen reads instead
    pub unread: &'static str,
}

const fn other(name: &'static str, meaning: &'static str, unread: &'static str) -> Other {
    Other { name, meaning, unread }
}

/// For settings of a drive.
const OF_DRIVE: &str = "A setting in the drive; no list of the controller holds it.";

/// All, in the order of docs/parameters.md.
pub static OTHERS: [Other; 18] = [
    other(
        "V_SATZ_ANZ",
        "constant of the controller: the largest number of buffered blocks. The manual of feedforward names it among what feedforward \
         needs, and gives no value",
        "It belongs to the build of the controller; a list has no parameter for it. Nothing in a block depends on it: the inputs of a \
         call are those of one cycle.",
    ),
    other(
        "P-CHAN-00071",
        "channel parameter: the profile of the acceleration. Feedforward of the jerk needs a jerk-limited profile; with every \
         other profile the controller feeds a jerk of 0",
        "It stands in the list of a channel, not of an axis. The interpolator follows it; a block takes j_interpolator as it comes.",
    ),
    other(
        "#SLOPE",
        "NC command #SLOPE [TYPE...]: the profile of the acceleration, as P-CHAN-00071, in the NC program",
        "It belongs to the interpolator. A scenario has a jerk-limited profile of its own, and passes the command over (AX471).",
    ),
    other(
        "P-AXIS-00405",
        "increments per revolution of the motor with which the controller computes, for SERCOS and CANopen: P-AXIS-00092, or what the \
         telegrams of the bus say",
        "The controller puts it out for display; it is not an input. axgen takes P-AXIS-00092: compare the two.",
    ),
    other(
        "P-AXIS-00065",
        "increments per revolution of the motor with which the controller computes, for PROFIdrive: P-AXIS-00092, or what the telegrams \
         of the bus say",
        "The controller puts it out for display; it is not an input. axgen takes P-AXIS-00092: compare the two.",
    ),
    other(
        "P-AXIS-00267",
        "name that the overview of the spindle manual has for the velocity at which velocity control begins",
        "The description of the same manual, and its examples, have P-AXIS-00767 with this path: axgen reads that.",
    ),
    other(
        "P-AXIS-00268",
        "name that the overview of the spindle manual has for the velocity at which position control is taken up again",
        "The description of the same manual, and its examples, have P-AXIS-00768 with this path: axgen reads that.",
    ),
    other(
        "CNC objects",
        "objects of the controller for the start-up of improved position control, from V3.1.3132.0 on. The parameter list of that build \
         announces them; their names and numbers are open",
        "They show and change values of the running controller. The blocks have signals for that: mode, v_add, v_add_calculated, \
         limited, and with the key tunable the inputs tuning_weight0 to 2 and tuning_limit, or parameter sets.",
    ),
    other(
        "S-0-0032",
        "SERCOS: main operation mode; 3 is position control with encoder 1. S-0-0033 to S-0-0035 are the auxiliary operation modes, where \
         2 is velocity control",
        "A setting in the drive. A spindle that changes over can have it in the key drive_settings, which is checked.",
    ),
    other(
        "S-0-0037",
        "SERCOS: additive velocity command, which takes v_add and the feedforward ADD_VEL where the drive controls the position",
        "A process datum. The key process_data.additive_velocity says that the telegram has it, and in which type.",
    ),
    other(
        "S-0-0081",
        "SERCOS: additive torque command, which takes the feedforward ADD_ACC",
        "A process datum. The key process_data.additive_torque says that the telegram has it, and in which type.",
    ),
    other(
        "S-0-0104",
        "SERCOS: gain Kv of the drive's position controller [1000/min: 20/s is 1.2]; P-AXIS-00099 must be equal to it",
        OF_DRIVE,
    ),
    other(
        "S-0-0296",
        "SERCOS: gain of the drive's own feedforward of the velocity. With it the CNC feeds nothing forward, or the axis leads (AX423)",
        "A setting in the drive. For the changeover of a spindle P-AXIS-00833 (00766) repeats it.",
    ),
    other(
        "S-0-0348",
        "SERCOS: gain of the drive's own feedforward of the acceleration. With it the CNC feeds no acceleration forward (AX423)",
        OF_DRIVE,
    ),
    other(
        "30C0h:01",
        "CANopen: gain Kv of the drive's position controller [1/s]; P-AXIS-00099 must be equal to it",
        OF_DRIVE,
    ),
    other(
        "3062h",
        "CANopen: weight of the drive's own feedforward of the velocity. With it the CNC feeds nothing forward, or the axis leads (AX423)",
        "A setting in the drive. For the changeover of a spindle P-AXIS-00833 (00766) repeats it.",
    ),
    other(
        "60B1h",
        "CANopen: velocity offset, which takes v_add and the feedforward ADD_VEL where the drive controls the position",
        "A process datum. The key process_data.additive_velocity says that the telegram has it, and in which type.",
    ),
    other(
        "60B2h",
        "CANopen: torque offset, which takes the feedforward ADD_ACC",
        "A process datum. The key process_data.additive_torque says that the telegram has it, and in which type.",
    ),
];

impl Other {
    /// Whether a text names it: its name in any case, with or without `#`; for a parameter also the digits.
    pub fn is(&self, wanted: &str) -> bool {
        let plain = |text: &str| text.trim_start_matches('#').to_ascii_lowercase();
        let digits = self.name.strip_prefix("P-").and_then(|id| id.rsplit('-').next());
        plain(wanted) == plain(self.name) || digits == Some(wanted)
    }
}

//! The words of enumerations: each set once, as a Rust enum with its spellings and numbers. `table.rs` assigns them to
//! parameters; their meaning for an axis is where they are matched.

use super::Word;

pub trait Words: Copy + Eq + 'static {
    const ALL: &'static [Self];
    /// In the order of `ALL`.
    const WORDS: &'static [Word];

    fn name(self) -> &'static str {
        let position = Self::ALL.iter().position(|word| *word == self);
        position.map_or("", |position| Self::WORDS[position].name)
    }

    /// The word of a [`super::Value`], which a reader has found in [`Self::WORDS`].
    fn named(name: &str) -> Option<Self> {
        let position = Self::WORDS.iter().position(|word| word.name == name);
        position.map(|position| Self::ALL[position])
    }
}

/// Declares enumerations: `Variant "WORD" = number | "another spelling"`.
macro_rules! words {
    ($($(#[$doc:meta])* $name:ident { $(
        $variant:ident $word:literal $(= $number:literal)? $(| $also:literal)*
    ),+ $(,)? })+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum $name { $($variant),+ }

        impl Words for $name {
            const ALL: &'static [Self] = &[$(Self::$variant),+];
            const WORDS: &'static [Word] = &[$(
                Word { name: $word, number: <[u32]>::first(&[$($number)?]).copied(), also: &[$($also),*] }
            ),+];
        }
    )+};
}

words! {
    Boolean { False "FALSE" = 0, True "TRUE" = 1 }
    TargetName { C "c", Rust "rust", St "st", TwinCat "twincat", Codesys "codesys", Scl "scl" }
    ListEncoding { Utf8 "utf-8", Latin1 "latin-1", Utf16LittleEnd "utf-16le", Utf16BigEnd "utf-16be" }
    LineEnd { Lf "LF", CrLf "CRLF" }
    /// What the caller may tune while a block acts.
    Tunable { Nothing "nothing", Weights "weights", All "all", Parameters "parameters" }
    /// What a measured response is from; it is to the velocity of the motor.
    ResponseFrom { Velocity "v_cmd" | "velocity", Current "current" }
    RealType { F64 "f64" | "LREAL", F32 "f32" | "REAL" }
    /// Integer type of process data.
    Width { Int16 "INT16" | "INT", Int32 "INT32" | "DINT" }
    /// Process data that a drive may lack.
    ProcessDatum { None "NONE", Int16 "INT16" | "INT", Int32 "INT32" | "DINT" }
    /// Cyclic data of a drive that a spindle needs whose drive changes its operation mode.
    DriveObject {
        SercosVelocityCommand "S-0-0036",
        SercosVelocity "S-0-0040",
        SercosPositionCommand "S-0-0047",
        SercosPosition1 "S-0-0051",
        SercosPosition2 "S-0-0053",
        Mode "6060h" | "0x6060",
        ModeDisplay "6061h" | "0x6061",
        TargetPosition "607Ah" | "0x607A",
        Position "6064h" | "0x6064",
        TargetVelocity "60FFh" | "0x60FF",
        Velocity "606Ch" | "0x606C",
    }
    /// Settings of a SERCOS drive that such a spindle needs: what an operation mode controls, and rotary scaling (bits 2 to 0).
    DriveSetting {
        MainPosition "S-0-0032=3",
        Auxiliary1Velocity "S-0-0033=2",
        Auxiliary2Velocity "S-0-0034=2",
        Auxiliary3Velocity "S-0-0035=2",
        RotaryPosition "S-0-0076=010",
        RotaryVelocity "S-0-0044=010",
        RotaryAcceleration "S-0-0160=010",
    }
    Motor { Rotary "rotary", Linear "linear" }
    /// Whether the inferred formula of ADD_JERK is generated.
    AddJerk { Refused "refused", Experimental "experimental" }
    /// Axis type (P-AXIS-00018).
    AxisType { Translator "ACHSTYP_TRANSLATOR" = 1, Rotator "ACHSTYP_ROTATOR" = 2, Spindle "ACHSTYP_SPINDEL" = 4 }
    /// Drive type (P-AXIS-00020).
    DriveType {
        Conventional "CONVENTIONAL" = 1 | "ANTR_TYP_KONV",
        Sercos "SERCOS" = 2 | "ANTR_TYP_SERCOS",
        Profidrive "PROFIDRIVE" = 3 | "ANTR_TYP_PROFIDRIVE",
        Simulation "SIMULATION" = 4 | "ANTR_TYP_SIMU",
        Lightbus "LIGHTBUS" = 5 | "ANTR_TYP_LIGHTBUS",
        Terminal "TERMINAL" = 6 | "ANTR_TYP_TERM",
        RtEthernet "RT_ETHERNET" = 7 | "ANTR_TYP_ETHERNET",
        CanOpen "CANOPEN" = 8 | "ANTR_TYP_CANOPEN",
        Virtual "VIRTUAL" = 16 | "ANTR_TYP_VIRTUELL",
        CanBus "CAN_BUS" = 32 | "ANTR_TYP_CAN",
    }
    /// Where the position is controlled (P-AXIS-00320); by default as the drive type says.
    OperationMode {
        DriveDefault "DRIVE_DEFAULT",
        DrivePositionControl "DRIVE_POSITION_CONTROL",
        CncPositionControl "CNC_POSITION_CONTROL",
    }
    /// Feedforward (P-AXIS-00223): quantities, and whether they are additive commands.
    FeedforwardWord {
        None "NONE" = 0x000,
        Vel "VEL" = 0x001,
        Acc "ACC" = 0x002,
        Jerk "JERK" = 0x004,
        AddVel "ADD_VEL" = 0x101,
        AddAcc "ADD_ACC" = 0x202,
        AddJerk "ADD_JERK" = 0x804,
    }
    /// Mode of improved position control at start (P-AXIS-00758); DRYRUN calculates and does not act. As a number it is the
    /// input `mode`.
    Enable { Off "OFF" = 0 | "FALSE", On "ON" = 1 | "TRUE", DryRun "DRYRUN" }
    /// Mode of a stage (P-AXIS-00753).
    StageMode { NotActive "NOT_ACTIVE" = 0, Direct "DIRECT" = 1, Indirect "INDIRECT" = 2, SetPoint "SET_POINT" = 3 }
    /// Whose velocity a DIRECT stage takes (key `direct_source`): motor encoder (v_ist1), direct measuring system (v_ist2).
    DirectSource { Motor "v_motor", Direct "v_direct" }
    /// Type of a filter (P-AXIS-00849).
    FilterType { NoFilter "NO_FILTER", Bandpass "BANDPASS", Allpass "ALLPASS" }
    /// Low-pass prototype of a band-pass (P-AXIS-00848): all poles in one place, flattest amplitude, flattest delay.
    Prototype { CritDamping "CRIT_DAMPING", Butterworth "BUTTERWORTH", Bessel "BESSEL" }
}

//! The parameters of an axis as the model understands them, and the set that says the same to `axgen`. No coefficient.

use std::fmt::Write as _;

/// Bits of the mode word, P-AXIS-00223.
pub const VELOCITY: u32 = 0x001;
/// Acceleration.
pub const ACCELERATION: u32 = 0x002;
/// Jerk.
pub const JERK: u32 = 0x004;
/// Output as additive velocity.
pub const ADDITIVE_VELOCITY: u32 = 0x100;
/// Acceleration as additive torque.
pub const ADDITIVE_TORQUE: u32 = 0x200;
/// Jerk as additive torque.
pub const JERK_TORQUE: u32 = 0x800;

/// A numerator and a denominator, as a list has them.
pub type Pair = [u32; 2];

/// Bits of an integer process datum: 16 or 32.
pub type Bits = u32;

/// One axis.
#[derive(Clone, Debug)]
pub struct Parameters {
    /// key `real`: REAL and not LREAL
    pub single: bool,
    /// `cycle_time` [ns]
    pub cycle_ns: u32,
    /// `kenngr.achs_typ` (P-AXIS-00018): 1, 2 or 4
    pub kind: u32,
    /// `kenngr.antr_typ` (P-AXIS-00020)
    pub drive: u32,
    /// `antr.operation_mode` (P-AXIS-00320)
    pub operation_mode: &'static str,
    /// `getriebe[0].kv` (P-AXIS-00099) [0.01/s]
    pub kv: Option<u32>,
    /// P-AXIS-00129, 00128
    pub multi_gain: Pair,
    /// P-AXIS-00092
    pub incr_per_rev: u32,
    /// P-AXIS-00234, 00233
    pub wegauf: Pair,
    /// P-AXIS-00362, 00363
    pub feed_const: Pair,
    /// P-AXIS-00391, in millionths
    pub load: u32,
    /// P-AXIS-00392, in thousandths
    pub reference: u32,
    /// P-AXIS-00325, 00326
    pub torque_scale: Pair,
    /// key `motor`
    pub linear: bool,
    /// P-AXIS-00206, 00205
    pub v_reso: Pair,
    /// P-AXIS-00207: 0 per minute, 1 per second, 2 per cycle
    pub v_time_base: u32,
    /// key `process_data.velocity_command`
    pub command_bits: Bits,
    /// key `process_data.additive_velocity`
    pub velocity_bits: Option<Bits>,
    /// key `process_data.additive_torque`
    pub torque_bits: Option<Bits>,
    /// P-AXIS-00223
    pub word: u32,
    /// P-AXIS-00225, 00226
    pub vs_a: Pair,
    /// P-AXIS-00228, 00229
    pub vs_v: Pair,
    /// P-AXIS-00337, 00338
    pub jerk_fact: Pair,
    /// P-AXIS-00389, 00390, 00547 [us]
    pub delay_us: [u32; 3],
    /// P-AXIS-00255
    pub default_active: bool,
    /// P-AXIS-00256
    pub global_disable: bool,
    /// P-AXIS-00165
    pub shift_time: Option<u32>,
    /// P-AXIS-00758 at the start
    pub enable: &'static str,
    /// P-AXIS-00757 [0.1 %]
    pub v_add_max_fact: u32,
    /// P-AXIS-00212
    pub vb_max: u32,
    /// key `fade` [ns]
    pub fade_ns: u32,
    /// `ride_through`
    pub ride_through: u32,
    /// key `tunable`: nothing, weights, all
    pub tunable: &'static str,
    /// `watch`
    pub watch: bool,
    /// `cycle_counter`
    pub counts_calls: bool,
    /// improved position control
    pub stages: Vec<Stage>,
    /// of a gantry slave
    pub master: Option<Master>,
}

/// The master of a gantry slave.
#[derive(Clone, Copy, Debug)]
pub struct Master {
    /// its P-AXIS-00757 [0.1 %]
    pub v_add_max_fact: u32,
    /// its P-AXIS-00212
    pub vb_max: u32,
    /// whether it has an active stage
    pub has_stage: bool,
}

/// Where a stage takes the vibration from, P-AXIS-00753.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// DIRECT, from `v_motor`
    DirectMotor,
    /// DIRECT, from `v_direct`
    DirectLoad,
    /// INDIRECT
    Indirect,
    /// SET_POINT
    SetPoint,
}

/// An active stage.
#[derive(Clone, Debug)]
pub struct Stage {
    /// P-AXIS-00753
    pub mode: Mode,
    /// P-AXIS-00754, 00755
    pub weight: Pair,
    /// P-AXIS-00850
    pub damping: f64,
    /// order 1 to 3, prototype, f0 [Hz], Q of the band-pass
    pub band_pass: (usize, &'static str, f64, f64),
    /// f0 [Hz] and Q of an all-pass
    pub all_pass: Option<(f64, f64)>,
    /// whether that is the first filter, not the second one
    pub is_all_pass_first: bool,
}

impl Parameters {
    /// Whether the drive is a PROFIdrive that controls the position, any drive that does so, or the CNC.
    #[must_use]
    pub fn location(&self) -> Location {
        let in_drive = match self.operation_mode {
            "CNC_POSITION_CONTROL" => false,
            "DRIVE_POSITION_CONTROL" => true,
            _ => matches!(self.drive, 2 | 3 | 8),
        };
        match (in_drive, self.drive) {
            (false, _) => Location::Cnc,
            (true, 3) => Location::Profidrive,
            (true, _) => Location::Drive,
        }
    }

    /// The set; the axis is X, its master M.
    #[must_use]
    pub fn set(&self) -> String {
        let mut text = format!("cycle_time = \"{}ns\"\n[axis.X]\n", self.cycle_ns);
        if self.single {
            text += "real = \"f32\"\n";
        }
        let mut line = |text_of_line: String| {
            text += &text_of_line;
            text.push('\n');
        };
        line(format!("kenngr.achs_typ = {}\nkenngr.antr_typ = {}", self.kind, self.drive));
        line(format!("antr.operation_mode = \"{}\"", self.operation_mode));
        let [num, denom] = self.feed_const;
        line(format!("antr.feed_const_num = {num}\nantr.feed_const_denom = {denom}"));
        let [num, denom] = self.torque_scale;
        line(format!("antr.torque_scale_num = {num}\nantr.torque_scale_denom = {denom}"));
        line(format!("antr.acc_reference_value = {}.{:03}", self.reference / 1000, self.reference % 1000));
        let [num, denom] = self.v_reso;
        line(format!("antr.v_reso_num = {num}\nantr.v_reso_denom = {denom}\nantr.v_time_base = {}", self.v_time_base));
        line(format!("process_data.velocity_command = \"INT{}\"", self.command_bits));
        for (key, bits) in [("additive_velocity", self.velocity_bits), ("additive_torque", self.torque_bits)] {
            if let Some(bits) = bits {
                line(format!("process_data.{key} = \"INT{bits}\""));
            }
        }
        if self.linear {
            line("motor = \"linear\"".to_owned());
        }
        if self.word & JERK_TORQUE != 0 {
            line("add_jerk = \"experimental\"".to_owned());
        }
        line(format!("fade = \"{}ns\"", self.fade_ns));
        line(format!("ride_through = {}", self.ride_through));
        line(format!("tunable = \"{}\"", self.tunable));
        line(format!("watch = {}", self.watch));
        if self.counts_calls {
            line("cycle_counter = true".to_owned());
        }
        if let Some(master) = self.master {
            line("kopf.achs_nr = 5\nkenngr.gantry_ax_nr = 4".to_owned());
            line(self.gear());
            line(self.feedforward());
            line(self.improved_position_control());
            line("[axis.M]\nkopf.achs_nr = 4".to_owned());
            line(format!("getriebe = [{{ kv = 2000, dynamik.vb_max = {} }}]", master.vb_max));
            line(format!("lr_param.improved_position_control.v_add_max_fact = {}", master.v_add_max_fact));
            if master.has_stage {
                line("lr_param.improved_position_control.stage = [{ mode = 1, filter = [{ order = 1, fg_f0 = 40, q_factor = 2 }] }]".to_owned());
            }
        } else {
            line(self.gear());
            line(self.feedforward());
            line(self.improved_position_control());
        }
        text
    }

    fn gear(&self) -> String {
        let mut gear = format!("getriebe = [{{ dynamik.vb_max = {}, incr_per_rev = {}", self.vb_max, self.incr_per_rev);
        let [z, n] = self.multi_gain;
        let [wz, wn] = self.wegauf;
        let _ = write!(gear, ", multi_gain_z = {z}, multi_gain_n = {n}, wegaufz = {wz}, wegaufn = {wn}");
        let _ = write!(gear, ", load = {}.{:06}", self.load / 1_000_000, self.load % 1_000_000);
        if let Some(kv) = self.kv {
            let _ = write!(gear, ", kv = {kv}");
        }
        gear + " }]"
    }

    fn feedforward(&self) -> String {
        let [a, a_denom] = self.vs_a;
        let [v, v_denom] = self.vs_v;
        let [j, j_denom] = self.jerk_fact;
        let [of_v, of_a, of_j] = self.delay_us;
        let mut text = format!(
            "vorsteuer.vorsteuerung = {:#x}\nvorsteuer.vs_a_faktor = {a}\nvorsteuer.vs_a_nenner = {a_denom}\n\
             vorsteuer.vs_v_faktor = {v}\nvorsteuer.vs_v_nenner = {v_denom}\n\
             vorsteuer.jerk_fact_num = {j}\nvorsteuer.jerk_fact_denom = {j_denom}\n\
             vorsteuer.velocity_delay_time = {of_v}\nvorsteuer.acceleration_delay_time = {of_a}\n\
             vorsteuer.jerk_delay_time = {of_j}\nvorsteuer.default_active = {}\nvorsteuer.global_disable = {}",
            self.word, self.default_active, self.global_disable
        );
        if let Some(shift_time) = self.shift_time {
            let _ = write!(text, "\nvorsteuer.shift_time = {shift_time}");
        }
        text
    }

    fn improved_position_control(&self) -> String {
        const PATH: &str = "lr_param.improved_position_control";
        let mut text = format!("{PATH}.enable = \"{}\"\n{PATH}.v_add_max_fact = {}", self.enable, self.v_add_max_fact);
        let stages: Vec<String> = self.stages.iter().map(Stage::text).collect();
        if !stages.is_empty() {
            let _ = write!(text, "\n{PATH}.stage = [{}]", stages.join(", "));
        }
        text
    }
}

impl Stage {
    fn text(&self) -> String {
        let mode = match self.mode {
            Mode::DirectMotor | Mode::DirectLoad => "DIRECT",
            Mode::Indirect => "INDIRECT",
            Mode::SetPoint => "SET_POINT",
        };
        let [num, denom] = self.weight;
        let mut text = format!("{{ mode = \"{mode}\", weight_fact_num = {num}, weight_fact_denom = {denom}");
        match self.mode {
            Mode::DirectLoad => text += ", direct_source = \"v_direct\"",
            Mode::DirectMotor => {}
            Mode::Indirect | Mode::SetPoint => {
                let _ = write!(text, ", osc_damping = {}", self.damping);
            }
        }
        let (order, prototype, f0, q) = self.band_pass;
        let band_pass = format!(
            "{{ type = \"BANDPASS\", prototype = \"{prototype}\", order = {order}, fg_f0 = {f0}, q_factor = {q} }}"
        );
        let mut filters = vec![band_pass];
        if let Some((f0, q)) = self.all_pass {
            let at = usize::from(!self.is_all_pass_first);
            filters.insert(at, format!("{{ type = \"ALLPASS\", fg_f0 = {f0}, q_factor = {q} }}"));
        }
        text + &format!(", filter = [{}] }}", filters.join(", "))
    }
}

/// Where the position is controlled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Location {
    /// in the CNC
    Cnc,
    /// in a drive that gets a position
    Drive,
    /// in a drive that gets a control deviation and a position
    Profidrive,
}

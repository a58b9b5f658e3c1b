//! Sequences of the block `spindle` as scripts in `sequences/*.txt`, each line with what its last cycle puts out.
//!
//! ```text
//! == both: title                    the bench: drive, cnc or both; where both put out the same, it stands once
//! > from Brake 75: m19, v=60, x3    where the sequence begins, what is TRUE for one cycle, what stays so, cycles
//! > to Position                     cycles until the next one begins in that state
//! ```
//!
//! Velocities are in rpm, positions in degrees; `x_command=free` ends what `x_command=90` has forced.

use super::bench::{Bench, RPM, T, V_OFF, V_STEP, V_WINDOW, VELOCITY_MODE};
use reference::spindle::{Coeffs, Inputs, SpindleState};

/// [0.001 deg]
const DEGREE: f64 = 1000.0;

/// The benches of the sequence that runs.
#[derive(Default)]
pub struct Session(Vec<Bench>);

impl Session {
    /// Runs lines; what the last cycle of the last one puts out.
    pub fn run(&mut self, form: &str, lines: &str) -> String {
        let mut counts = Vec::new();
        for line in lines.lines() {
            let items = match line.strip_prefix("from ") {
                Some(rest) => {
                    let (start, items) = rest.split_once(": ").unwrap_or((rest, "x0"));
                    self.0 = benches(form).into_iter().map(|bench| begin(bench, start)).collect();
                    items
                }
                None => line,
            };
            counts = self.0.iter_mut().map(|bench| cycles(bench, items)).collect();
        }
        let rows: Vec<String> = self.0.iter().map(row).collect();
        let said = |place: usize| format!("{}{}{}", counts[place], mode(&self.0[place]), rows[place]);
        match &*rows {
            [one, other] if one != other || counts[0] != counts[1] => format!("{}\nCNC: {}", said(0), said(1)),
            [] => panic!("no bench before: {lines}"),
            _ => said(0),
        }
    }
}

/// A bench with position control in the drive, after lines.
pub fn bench(lines: &str) -> Bench {
    let mut session = Session::default();
    session.run("drive", lines);
    session.0.remove(0)
}

fn benches(form: &str) -> Vec<Bench> {
    match form {
        "drive" => vec![Bench::in_drive()],
        "cnc" => vec![Bench::in_cnc()],
        "both" => Bench::both().into(),
        _ => panic!("unknown bench: {form}"),
    }
}

/// A bench whose next cycle is the first one in a state: `Brake 75`, `Velocity 1000 with Voff 0`.
fn begin(bench: Bench, start: &str) -> Bench {
    let (start, variant) = start.split_once(" with ").unwrap_or((start, ""));
    let bench = if variant.is_empty() { bench } else { Bench::with(varied(bench.coeffs, variant)) };
    let (state, v) = start.split_once(' ').unwrap_or((start, "1000"));
    match state {
        "start" => bench,
        "rest" => bench.at_rest(),
        "turning" => bench.turning(),
        "ToVelocity" => bench.before_to_velocity(),
        "Velocity" => bench.fast(number(v) * RPM),
        "Brake" => bench.before_brake(number(v) * RPM),
        "ToPosition" => bench.before_to_position(),
        "takeover" => bench.before_takeover(),
        "full" => bench.full(),
        _ => panic!("unknown start: {start}"),
    }
}

fn varied(coeffs: Coeffs<f64>, variant: &str) -> Coeffs<f64> {
    let voff_0 = Coeffs { v_position_control_on: 0.0, v_position_control_on_negative: 0.0, ..coeffs };
    match variant {
        "Voff 0" => Coeffs { window: 100.0, ..voff_0 },
        "Von 0" => Coeffs { v_velocity_control_on: 0.0, ..coeffs },
        "position control only" => Coeffs { only_position: true, ..coeffs },
        "velocity control only" => Coeffs {
            only_velocity: true,
            v_velocity_control_on: 0.0,
            v_taken_up: V_WINDOW,
            position_mode: VELOCITY_MODE,
            ..voff_0
        },
        "its own loop" => Coeffs { closes_loop: true, ..coeffs },
        _ => panic!("unknown variant: {variant}"),
    }
}

/// Sets the inputs of a line and runs its cycles. Says how many they were, if the line waits for a state.
fn cycles(bench: &mut Bench, items: &str) -> String {
    let (mut once, mut end) = (Vec::new(), "x1");
    for item in items.split(", ") {
        match item.split_once('=') {
            Some((name, value)) => keep(bench, name, value),
            None if END.iter().any(|word| item.starts_with(word)) => end = item,
            None => once.push(item),
        }
    }
    let kept = bench.inputs;
    once.into_iter().for_each(|name| set_once(&mut bench.inputs, name));
    let count = run(bench, end, kept);
    bench.inputs = kept;
    count
}

/// How a line ends: `x3`, `until Brake`, `to Brake`, `arrives`.
const END: [&str; 4] = ["x", "until ", "to ", "arrives"];

fn run(bench: &mut Bench, end: &str, kept: Inputs<f64>) -> String {
    if let Some(count) = end.strip_prefix('x') {
        for _ in 0..count.parse().unwrap_or_else(|_| panic!("no count: {end}")) {
            bench.cycle();
            bench.inputs = kept;
        }
        return String::new();
    }
    if end == "arrives" {
        return arrive(bench);
    }
    let (word, state) = end.split_once(' ').unwrap_or_else(|| panic!("no state: {end}"));
    for cycle in 1..200 {
        bench.cycle();
        bench.inputs = kept;
        let reached = if word == "until" { bench.outputs.spindle_state } else { bench.next() };
        if format!("{reached:?}") == state || bench.outputs.fault {
            return format!("{cycle} cycles: ");
        }
    }
    panic!("never {state}: {:?}", bench.outputs);
}

/// Until POSITION at rest, with a drive that follows: no faster than Voff and the window, and never the other way.
fn arrive(bench: &mut Bench) -> String {
    (bench.x_actual, bench.v_actual, bench.display) = (None, None, None);
    let direction = bench.outputs.v_spindle;
    assert!(direction != 0.0, "it stands");
    for cycle in 1..2000 {
        let v_actual = bench.outputs.v_spindle;
        bench.v = v_actual - v_actual.clamp(-V_STEP, V_STEP);
        let o = bench.cycle();
        assert!(o.spindle_state != SpindleState::Position || v_actual.abs() <= V_OFF + V_WINDOW, "{o:?}");
        assert!(o.v_spindle * direction >= 0.0 && o.error_id == 0, "{o:?}");
        if o.spindle_state == SpindleState::Position && o.v_spindle == 0.0 {
            return format!("{cycle} cycles: ");
        }
    }
    panic!("{:?}", bench.outputs);
}

/// What stays until another line changes it.
fn keep(bench: &mut Bench, name: &str, value: &str) {
    let forced = |scale: f64| (value != "free").then(|| number(value) * scale);
    let inputs = &mut bench.inputs;
    match name {
        "v" => bench.v = number(value) * RPM,
        "x_command" => bench.x_command = forced(DEGREE),
        // from where the commands lead
        "x_off" => {
            let next = bench.outputs.x_spindle + bench.outputs.v_spindle * T;
            bench.x_command = Some(next + number(value) * DEGREE);
        }
        "x_actual" => bench.x_actual = forced(DEGREE),
        "v_actual" => bench.v_actual = forced(RPM),
        "display" => bench.display = value.parse().ok(),
        "s" => inputs.s_word = number(value) * RPM,
        "s.pos" => inputs.s_position = number(value) * DEGREE,
        "percentage" => {
            inputs.feedforward_active = true;
            inputs.feedforward_percentage = value.parse().unwrap_or_else(|_| panic!("no integer: {value}"));
        }
        "task_cycle_ns" => inputs.task_cycle_ns = value.parse().unwrap_or_else(|_| panic!("no integer: {value}")),
        "drive" => inputs.drive_on = value == "on",
        _ => *flag(inputs, name) = value == "TRUE",
    }
}

/// What is so in the first cycle of its line only.
fn set_once(inputs: &mut Inputs<f64>, name: &str) {
    match name {
        "drive_off" => inputs.drive_on = false,
        "wrong_cycle" => inputs.task_cycle_ns = 1,
        _ => *flag(inputs, name) = true,
    }
}

fn flag<'i>(inputs: &'i mut Inputs<f64>, name: &str) -> &'i mut bool {
    match name {
        "m3" => &mut inputs.m3,
        "m4" => &mut inputs.m4,
        "m5" => &mut inputs.m5,
        "m19" => &mut inputs.m19,
        "putax" => &mut inputs.putax,
        "g74" => &mut inputs.g74,
        "reset" => &mut inputs.reset,
        "job_done" => &mut inputs.job_done,
        _ => panic!("unknown input: {name}"),
    }
}

fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| panic!("no number: {text}"))
}

/// What the last cycle has put out, and the state of the next one if it is another. The mode of a drive is in `mode`.
fn row(bench: &Bench) -> String {
    let o = &bench.outputs;
    assert_eq!(o.fault, o.error_id != 0, "{o:?}");
    let x = (o.x_spindle / DEGREE * 1e9).round() / 1e9;
    let mut row =
        format!("{:?}, {} rpm, {x} deg, job {} {:?}", o.spindle_state, o.v_spindle / RPM, o.job_number, o.job);
    let mut add = |is_so: bool, text: String| row += if is_so { &text } else { "" };
    add(o.job_speed != 0.0, format!(" {} rpm", o.job_speed / RPM));
    add(o.job_position != 0.0, format!(" {} deg", o.job_position / DEGREE));
    add(o.waiting != 0, format!(", {} waiting", o.waiting));
    add(o.loop_closed, ", closed".to_owned());
    add(o.error_id != 0, format!(", error {}", o.error_id));
    add(bench.next() != o.spindle_state, format!(" -> {:?}", bench.next()));
    row
}

/// The operation mode, which only a drive has that closes the loop. Its velocity command is the velocity.
fn mode(bench: &Bench) -> String {
    let o = &bench.outputs;
    if !bench.coeffs.in_drive {
        assert_eq!((o.operation_mode, o.velocity_command), (0, 0), "{o:?}");
        return String::new();
    }
    assert!(o.limited || (f64::from(o.velocity_command) - o.v_spindle).abs() <= 0.5, "{o:?}");
    format!("mode {}: ", o.operation_mode)
}

#[test]
fn each_sequence_puts_out_what_its_file_says() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/spindle/sequences");
    for name in ["requests", "position", "velocity", "brake", "start", "caught", "resets"] {
        let mut session = Session::default();
        transcript::compare(format!("{folder}/{name}.txt"), |form, lines| session.run(form, lines));
    }
}

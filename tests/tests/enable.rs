//! Enable, Valid, Busy, Error, ErrorID and NoticeID of the dialects for PLCs: sequences that a program gives, checked on the outputs
//! of the emitted text alone. What the other outputs are is for the golden cases.

#![expect(clippy::float_cmp, reason = "ids, states and speeds are exact")]

use axgen_tests::cases::{all, title};
use axgen_tests::model::subject::read;
use generator::blocks::{Block, Designed, blocks};
use golden::case;
use golden::engine::emitted;
use portable::Literal;
use st::{Dialect, Instance};

const DIALECTS: [Dialect; 3] = [Dialect::TwinCat, Dialect::Codesys, Dialect::Scl];

const IPC: &str = include_str!("enable.toml");

/// [0.001 deg/s^2]
const DECELERATION: f64 = 18_000_000.0;
/// [s]
const CYCLE: f64 = 0.002;

/// A spindle: with position control in the drive, and in the CNC.
fn spindle(in_cnc: bool) -> Designed {
    let of = match in_cnc {
        false => {
            "kenngr.antr_typ = 'SERCOS'\nantr.sercos.op_mode_for_velocity_control = 1\nantr.nbr_delay_cycles = 0\n\
             process_data.velocity_command = 'INT32'\n"
        }
        true => "vorsteuer.vorsteuerung = 'VEL'\n",
    };
    read(&format!(
        "cycle_time = '2ms'
[axis.X]
kenngr.achs_typ = 'ACHSTYP_SPINDEL'
antr.sai_op_mode_change.v_velocity_control_on = 1200000
antr.sai_op_mode_change.v_position_control_on = 300000
spindle.brake_timeout = '2s'
spindle.mode_timeout = '20ms'
spindle.deceleration = {DECELERATION:?}
getriebe = [{{ kv = 2000, dynamik = {{ vb_max = 18000000 }}, multi_gain_z = 10000000, multi_gain_n = 360 }}]
{of}"
    ))
}

/// Hands an instance of a block to a test, in each dialect.
fn in_each(designed: &Designed, name: &str, test: &mut dyn FnMut(&mut Run<'_>)) {
    let all = blocks(designed).unwrap_or_else(|defect| panic!("{defect}"));
    let block: &Block = all.iter().find(|block| block.program.block == name).unwrap_or_else(|| panic!("no {name}"));
    for dialect in DIALECTS {
        let [file, _] = emitted::files(dialect, designed, block).unwrap_or_else(|failure| panic!("{failure}"));
        let read = emitted::read(dialect, &file, designed, block).unwrap_or_else(|failure| panic!("{failure}"));
        let instance = read.start(&[], &[], &[]).unwrap_or_else(|mistakes| panic!("{mistakes:?}"));
        test(&mut Run { instance, of: format!("{dialect:?} {name}") });
    }
}

/// An instance that runs.
struct Run<'b> {
    instance: Instance<'b>,
    of: String,
}

impl Run<'_> {
    /// Writes an input, if the block has it.
    fn set(&mut self, input: &str, value: Literal) {
        let _ = self.instance.set(input, value);
    }

    fn cycle(&mut self) {
        self.instance.cycle(&[], &mut Vec::new());
    }

    fn is(&self, output: &str) -> bool {
        match self.instance.get(output) {
            Some(Literal::Bool(value)) => value,
            other => panic!("{}: {output}: {other:?}", self.of),
        }
    }

    fn number(&self, output: &str) -> f64 {
        match self.instance.get(output) {
            Some(Literal::F64(value)) => value,
            Some(Literal::I32(value)) => f64::from(value),
            Some(Literal::U32(value)) => f64::from(value),
            other => panic!("{}: {output}: {other:?}", self.of),
        }
    }

    /// Error, ErrorID and NoticeID.
    fn said(&self) -> (bool, f64, f64) {
        (self.is("Error"), self.number("ErrorID"), self.number("NoticeID"))
    }
}

/// A vibration for improved position control.
fn vibrate(run: &mut Run<'_>, cycle: i32) {
    run.set("v_motor", Literal::F64(100_000.0 * (f64::from(cycle) * 0.125_664).sin()));
    run.cycle();
}

#[test]
fn valid_and_busy_fall_with_the_last_value_to_add() {
    in_each(&read(IPC), "ipc", &mut |run| {
        let (mut faded, mut after) = (0, 0);
        for cycle in 0..2000 {
            run.set("Enable", Literal::Bool(cycle < 1000));
            vibrate(run, cycle);
            let (adds, valid, busy) = (run.number("v_add") != 0.0, run.is("Valid"), run.is("Busy"));
            assert!(!adds || valid, "{}: v_add without Valid in cycle {cycle}", run.of);
            assert_eq!(valid, busy, "{}: without an error both are the same", run.of);
            faded += i32::from(cycle >= 1000 && adds);
            after = if adds { 0 } else { after + 1 };
            assert!(cycle < 1000 || after < 3 || !valid, "{}: Valid and nothing to add in cycle {cycle}", run.of);
        }
        assert!(faded > 20 && after > 500, "{}: {faded} cycles of fading, then {after}", run.of);
    });
}

/// Enable is FALSE, and rises, while the button hangs; then it is pressed.
#[test]
fn enable_starts_no_excitation() {
    let designed = read(&IPC.replace("tunable = 'weights'", "excitation = { amplitude = 5000, periods = 8 }"));
    in_each(&designed, "excitation", &mut |run| {
        run.set("v_motor", Literal::F64(50_000.0));
        for cycle in 0..600 {
            let (enabled, presses) = (cycle % 300 > 5, [100, 400].contains(&cycle));
            run.set("Enable", Literal::Bool(enabled));
            run.set("hold_to_run", Literal::Bool(!presses));
            run.cycle();
            assert_eq!(run.number("v_excite") != 0.0, enabled && cycle % 300 > 101, "{}: cycle {cycle}", run.of);
            assert_eq!((run.is("Busy"), run.is("Valid")), (enabled, enabled), "{}: cycle {cycle}", run.of);
        }
    });
}

#[test]
fn the_falling_edge_of_enable_ends_an_error() {
    in_each(&read(IPC), "ipc", &mut |run| {
        run.set("Enable", Literal::Bool(true));
        (0..500).for_each(|cycle| vibrate(run, cycle));
        run.set("task_cycle_ns", Literal::U32(1));
        vibrate(run, 500);
        assert_eq!((run.said(), run.is("Valid")), ((true, 1.0, 0.0), false), "{}", run.of);
        run.set("Enable", Literal::Bool(false));
        vibrate(run, 501);
        assert_eq!((run.said(), run.is("Busy")), ((false, 0.0, 0.0), false), "{}", run.of);
        run.set("Enable", Literal::Bool(true));
        vibrate(run, 502);
        assert_eq!(run.said(), (true, 1.0, 0.0), "{}: it is shown again", run.of);
    });
}

#[test]
fn what_is_no_fault_is_a_notice() {
    in_each(&read(IPC), "ipc", &mut |run| {
        run.set("Enable", Literal::Bool(true));
        run.set("tuning_limit", Literal::F64(2.0));
        (0..10).for_each(|cycle| vibrate(run, cycle));
        assert_eq!((run.said(), run.is("Valid")), ((false, 0.0, 4.0), true), "{}", run.of);
        run.set("task_cycle_ns", Literal::U32(1));
        vibrate(run, 10);
        assert_eq!(run.said(), (true, 1.0, 0.0), "{}: an error comes before a notice", run.of);
    });
}

/// Of each golden case that can have a notice: it never stands next to an error, and an error never without Error.
#[test]
fn a_notice_and_an_error_exclude_each_other() {
    let mut seen = Vec::new();
    for case in
        all().iter().filter(|case| ["watch-of-an-unstable-loop, f64", "parameter-sets, f64"].contains(&&*title(case)))
    {
        let inputs = case::inputs(case, 5000).unwrap_or_else(|mistake| panic!("{mistake}"));
        let names: Vec<String> = inputs.shape.signals.iter().map(|signal| signal.name.clone()).collect();
        in_each(&case.axis, case.block.program.block, &mut |run| {
            run.set("Enable", Literal::Bool(true));
            let mut values = Vec::new();
            for sample in 0..inputs.len() {
                inputs.read(sample, &mut values);
                names.iter().zip(&values).for_each(|(name, value)| run.set(name, *value));
                run.cycle();
                let (error, id, notice) = run.said();
                assert_eq!(error, id != 0.0, "{} in {sample}", run.of);
                assert!(notice == 0.0 || id == 0.0, "{} in {sample}", run.of);
                assert!(![4.0, 5.0].contains(&id) && (notice == 0.0 || (4.0..=8.0).contains(&notice)), "{}", run.of);
                assert_eq!(
                    run.instance.get("tripped").is_some() && run.is("tripped") && !error,
                    notice == 5.0,
                    "{}",
                    run.of
                );
                if !seen.contains(&(notice, error)) {
                    seen.push((notice, error));
                }
            }
        });
    }
    assert!(seen.contains(&(5.0, false)), "{seen:?}");
}

/// A drive and an interpolator around a spindle: M3 far above the changeover, then Enable FALSE.
fn turn_and_disable(run: &mut Run<'_>) {
    let step = DECELERATION * CYCLE * (1.0 + 1e-9);
    let increments = run.instance.get("velocity_command").is_some().then_some(step * 10_000_000.0 / 360_000.0 * 60.0);
    let (mut before, mut was, mut modes) = (0.0, 0.0, Vec::new());
    let (mut fastest, mut braking) = (0.0_f64, 0);
    run.set("drive_on", Literal::Bool(true));
    for cycle in 0..6000 {
        let is_on = cycle < 3000;
        run.set("Enable", Literal::Bool(is_on));
        run.set("m3", Literal::Bool(cycle >= 20 && is_on));
        run.set("s_word", Literal::F64(12_000_000.0));
        // The interpolator moves on from what was put out, where it has a say.
        let wanted = if run.number("job") == 1.0 { run.number("job_speed") } else { 0.0 };
        let [v_spindle, x_spindle] = ["v_spindle", "x_spindle"].map(|output| run.number(output));
        let most = DECELERATION * CYCLE / 4.0;
        let v = v_spindle + (wanted - v_spindle).clamp(-most, most);
        run.set("v_interpolator", Literal::F64(v));
        run.set("x_command", Literal::F64(x_spindle + v * CYCLE));
        // The drive follows at once, and changes its mode after 5 cycles.
        run.set("x_actual", Literal::F64(x_spindle));
        run.set("v_actual", Literal::F64(v_spindle));
        modes.push(run.instance.get("operation_mode"));
        let displayed = modes[modes.len().saturating_sub(5)];
        displayed.into_iter().for_each(|mode| run.set("operation_mode_display", mode));
        run.cycle();
        let now = run.number("v_spindle");
        fastest = fastest.max(now);
        assert!((now - before).abs() <= step, "{}: {before} to {now} in cycle {cycle}", run.of);
        if let Some(most) = increments {
            let command = run.number("velocity_command");
            assert!((command - was).abs() <= most + 1.0, "{}: {was} to {command} in cycle {cycle}", run.of);
            was = command;
        }
        let is_in_position = displayed.is_none() || displayed == modes[0];
        if !is_on && (now != 0.0 || !is_in_position) {
            braking += 1;
            assert!(run.is("Busy") && run.is("Valid"), "{}: turning, or in velocity control, in cycle {cycle}", run.of);
        }
        assert!(now >= 0.0 && !run.is("Error"), "{}: {now}, {} in cycle {cycle}", run.of, run.number("ErrorID"));
        before = now;
    }
    assert_eq!(fastest, 12_000_000.0, "{}: it is in velocity control, at speed", run.of);
    // From the speed to Voff by the deceleration, then by the interpolator.
    assert!(braking > 300, "{}: {braking} cycles of braking", run.of);
    let [state, job] = ["spindle_state", "job"].map(|output| run.number(output));
    assert_eq!((state, job, before), (0.0, 0.0, 0.0), "{}: it stands still under position control", run.of);
    assert!(!run.is("Busy") && !run.is("Valid"), "{}", run.of);
}

#[test]
fn a_disabled_spindle_brakes() {
    in_each(&spindle(false), "spindle", &mut turn_and_disable);
    in_each(&spindle(true), "spindle_axis", &mut turn_and_disable);
}

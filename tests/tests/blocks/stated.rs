//! What documents state in numbers, against the reference as `axgen` designs it: formulas by hand, no recording. All engines
//! share a wrong coefficient, so that comparing them finds none of this.

#![expect(clippy::float_cmp, reason = "what is copied, held or a whole number is that number")]

use axgen_tests::model::history::Inputs;
use axgen_tests::model::subject::{Run, blocks, read};
use generator::config::ListOptions;
use generator::pipeline::read_with;
use std::path::Path;

/// The outputs of one cycle, by name.
struct Found(Vec<(&'static str, f64)>);

impl Found {
    fn value(&self, signal: &str) -> f64 {
        let found = self.0.iter().find(|(name, _)| *name == signal);
        found.unwrap_or_else(|| panic!("no output {signal}")).1
    }
}

/// A block of an axis whose cycle is 1 ms.
struct Block(Run);

impl Block {
    /// The blocks in their order: 0 `feedforward`, 1 `position_control`, 2 `axis`.
    fn new(which: usize, lines: &str) -> Self {
        let mut blocks = blocks(&read(&format!("cycle_time = \"1ms\"\n[axis.X]\n{lines}\n")));
        Self(blocks[which].take().expect("the axis has the block"))
    }

    fn step(&mut self, inputs: &Inputs) -> Found {
        let mut found = Vec::new();
        (self.0)(inputs, &mut found);
        Found(found)
    }
}

const DRIVE: &str = "kenngr.antr_typ = \"SERCOS\"\nprocess_data.additive_velocity = \"INT32\"";

/// 4.1 of the manual: 10000 increments are 3.333 mm/min.
const MANUAL: &str = "antr.v_reso_num = 10000\nantr.v_reso_denom = 3333\nvorsteuer.vorsteuerung = \"ADD_VEL\"";

fn at(v_interpolator: f64) -> Inputs {
    Inputs { v_interpolator, ..Inputs::USUAL }
}

/// P-AXIS-00256 wins over G135 and over P-AXIS-00255.
#[test]
fn global_disable_wins() {
    let additive = |lines: &str, active: bool| {
        let mut block = Block::new(0, &format!("{DRIVE}\n{MANUAL}\n{lines}"));
        let found = block.step(&Inputs { feedforward_active: active, ..at(1000.0) });
        [found.value("additive_velocity"), found.value("v_additive")]
    };
    // 1000 um/s * 60 s/min * 10000 / 3333 um
    let on = [180_018.0, 1000.0];
    assert_eq!(additive("", true), on);
    assert_eq!(additive("", false), [0.0; 2]);
    assert_eq!(additive("vorsteuer.default_active = true", false), on);
    for lines in ["", "vorsteuer.default_active = true\n"] {
        let disabled = format!("{lines}vorsteuer.global_disable = true");
        assert_eq!([true, false].map(|active| additive(&disabled, active)), [[0.0; 2]; 2], "{lines}");
    }
}

/// R has the increments of a revolution where one of the feed constant's parameters is not 1, whichever it is.
#[test]
fn a_feed_constant_is_given_by_either_of_its_parameters() {
    for (num, denom) in [(1, 1), (1, 7), (7, 1), (7, 7), (2, 3)] {
        let gear = "getriebe = [{ kv = 2000, incr_per_rev = 1048576, wegaufz = 3, wegaufn = 2, load = 0.25 }]";
        let feed = format!("{gear}\nantr.feed_const_num = {num}\nantr.feed_const_denom = {denom}");
        let given = (num, denom) != (1, 1);
        let revolution = if given { 1_048_576.0 * f64::from(denom) / f64::from(num) } else { 1.0 };
        let per_um = 10.0 * 1.5 * revolution;
        let mut profidrive = Block::new(1, &format!("kenngr.antr_typ = \"PROFIDRIVE\"\n{feed}"));
        let lag = if given { 0.25 } else { 4096.0 };
        let found = profidrive.step(&Inputs { x_command: lag, ..Inputs::USUAL });
        assert!((found.value("xerr") - lag * per_um).abs() <= 0.5, "{num}/{denom}: {}", found.value("xerr"));

        let torque = "kenngr.antr_typ = \"SERCOS\"\nprocess_data.additive_torque = \"INT32\"\n\
                      vorsteuer.vorsteuerung = \"ADD_ACC\"";
        let mut torque = Block::new(0, &format!("{torque}\n{feed}"));
        let alpha = per_um / 1_048_576.0 * std::f64::consts::TAU;
        let a = if given { 4096.0 } else { 1e10 };
        let found = torque.step(&Inputs { a_interpolator: a, ..Inputs::USUAL });
        assert!((found.value("additive_torque") - 0.25 * alpha * a).abs() <= 0.5, "{num}/{denom}");
    }
}

/// Without increments per revolution, XERR is always 0 where there is a feed constant: an error, whichever parameter gives it.
#[test]
fn a_feed_constant_needs_increments() {
    let is_taken = |num: u32, denom: u32| {
        let set = format!(
            "cycle_time = \"1ms\"\n[axis.X]\nkenngr.antr_typ = \"PROFIDRIVE\"\n\
             getriebe = [{{ kv = 2000, incr_per_rev = 0 }}]\nvorsteuer.vorsteuerung = \"VEL\"\n\
             antr.feed_const_num = {num}\nantr.feed_const_denom = {denom}\n"
        );
        let load = |_: &Path| Ok(set.clone().into_bytes());
        read_with(Path::new("set.toml"), &ListOptions::default(), &load).0.is_some()
    };
    let taken = [(1, 1), (1, 7), (7, 1), (7, 7)].map(|(num, denom)| is_taken(num, denom));
    assert_eq!(taken, [true, false, false, false]);
}

/// A ramp comes later by exactly the delay, to the microsecond.
#[test]
fn a_microsecond_of_delay_is_a_microsecond() {
    for us in [1, 2, 150, 999, 1000, 1001, 3000, 5001, 5999] {
        let lines = format!("{DRIVE}\n{MANUAL}\nvorsteuer.velocity_delay_time = {us}");
        let mut block = Block::new(0, &lines);
        for cycle in 0..20 {
            let v = 1000.0 * f64::from(cycle);
            let found = block.step(&at(v)).value("v_additive");
            // 1 um/s in each microsecond; the first cycle fills the delay with 0.
            let expected = if cycle < 7 { continue } else { v - f64::from(us) };
            assert!((found - expected).abs() < 1e-9, "{us} us: {found} instead of {expected}");
        }
    }
}

/// A step reaches the output through the oldest sample alone, and then whole.
#[test]
fn the_oldest_sample_of_a_delay() {
    let mut block = Block::new(0, &format!("{DRIVE}\n{MANUAL}\nvorsteuer.velocity_delay_time = 5750"));
    block.step(&at(0.0));
    let found: Vec<f64> = (0..8).map(|_| block.step(&at(1000.0)).value("v_additive")).collect();
    assert_eq!(found, [0.0, 0.0, 0.0, 0.0, 0.0, 250.0, 1000.0, 1000.0]);
}

#[test]
fn a_percentage_is_within_0_and_100() {
    let mut block = Block::new(0, &format!("{DRIVE}\n{MANUAL}"));
    for (given, taken) in [(-1, 0.0), (0, 0.0), (1, 1.0), (99, 99.0), (100, 100.0), (101, 100.0), (i32::MAX, 100.0)] {
        let found = block.step(&Inputs { feedforward_percentage: given, ..at(1000.0) }).value("v_additive");
        assert!((found - 10.0 * taken).abs() < 1e-9, "{given} %: {found}");
    }
}

/// After a cycle in which the block did not act, whatever the reason, a delay begins with what it finds.
#[test]
fn delays_are_filled_anew() {
    let lines = format!("{DRIVE}\n{MANUAL}\nvorsteuer.velocity_delay_time = 4500\ngetriebe = [{{ kv = 2000 }}]");
    type Off = (&'static str, fn(&mut Inputs));
    let off: [Off; 5] = [
        ("reset", |inputs| inputs.reset = true),
        ("not controlled", |inputs| inputs.position_controlled = false),
        ("wrong cycle", |inputs| inputs.task_cycle_ns = 2_000_000),
        ("bad velocity", |inputs| inputs.v_interpolator = f64::NAN),
        ("bad command", |inputs| inputs.x_command = f64::NAN),
    ];
    for (which, signal, scale) in [(0, "v_additive", 1.0), (2, "additive_velocity", 60.0 * 10000.0 / 3333.0)] {
        for (name, off) in off.iter().filter(|(name, _)| which == 2 || *name != "bad command") {
            let mut block = Block::new(which, &lines);
            (0..10).for_each(|_| _ = block.step(&at(1000.0)));
            let mut stopped = at(1000.0);
            off(&mut stopped);
            assert_eq!(block.step(&stopped).value(signal), 0.0, "{name}");
            for _ in 0..10 {
                let found = block.step(&at(2000.0)).value(signal);
                assert!((found - 2000.0 * scale).abs() <= 0.5, "{name}: {found}");
            }
        }
    }
}

/// One additive velocity: scale * (delay(W p v) + v_add), with v_add against the motion.
#[test]
fn v_add_is_added_to_the_feedforward_with_its_sign() {
    let stage = "lr_param.improved_position_control.v_add_max_fact = 2000\n\
                 lr_param.improved_position_control.stage = [{ mode = \"DIRECT\", filter = [{ order = 1, fg_f0 = 50, q_factor = 1 }] }]";
    let mut block = Block::new(2, &format!("{DRIVE}\n{MANUAL}\n{stage}\nfade = \"1ms\""));
    let mut seen = 0;
    for cycle in 0..400 {
        let v_motor = 1000.0 * (std::f64::consts::TAU * 0.05 * f64::from(cycle)).sin();
        let found = block.step(&Inputs { v_motor, ..at(500.0) });
        let v_add = found.value("v_add");
        let expected = 60.0 * 10000.0 / 3333.0 * (500.0 + v_add);
        assert!((found.value("additive_velocity") - expected).abs() <= 0.5, "cycle {cycle}");
        // At f0 the band-pass passes as it is, and the stage's sign is negative: v_add = -v_motor.
        if cycle > 200 {
            assert!((v_add + v_motor).abs() < 1.0, "cycle {cycle}: {v_add} for {v_motor}");
            seen += usize::from(v_add.abs() > 900.0);
        }
    }
    assert!(seen > 50, "{seen}");
}

/// Of a gantry: v_add_max_fact/1000 * vb_max of the master, not of the slave.
#[test]
fn a_slave_keeps_its_masters_limit() {
    let set = "kopf.achs_nr = 5\nkenngr.gantry_ax_nr = 4\ngetriebe = [{ kv = 2000, dynamik.vb_max = 300 }]\n\
               [axis.M]\nkopf.achs_nr = 4\ngetriebe = [{ kv = 2000, dynamik.vb_max = 40000 }]\n\
               lr_param.improved_position_control.v_add_max_fact = 250\n\
               lr_param.improved_position_control.stage = [{ mode = 1, filter = [{ order = 1, fg_f0 = 40, q_factor = 2 }] }]";
    let mut block = Block::new(2, set);
    for (given, expected, limited) in
        [(9999.0, 9999.0, 0.0), (10000.0, 10000.0, 0.0), (10001.0, 10000.0, 1.0), (-1e9, -10000.0, 1.0)]
    {
        let found = block.step(&Inputs { v_add_master: given, ..Inputs::USUAL });
        assert_eq!([found.value("v_add"), found.value("limited")], [expected, limited], "{given}");
        // 2000 increments at 1 m/min.
        assert!((found.value("manipulated_variable") - expected * 60e-6 * 2000.0).abs() <= 0.5, "{given}");
    }
}

/// x_drive = x_command + v_feedforward / Kv, kept as it was put out where there is no command in range.
#[test]
fn a_drive_keeps_its_position_without_a_command_in_range() {
    let lines = "kenngr.antr_typ = \"SERCOS\"\nvorsteuer.vorsteuerung = \"VEL\"\ngetriebe = [{ kv = 3000 }]";
    let mut block = Block::new(2, lines);
    let at = |x_command: f64| Inputs { x_command, ..at(30_000.0) };
    let drive = [f64::NAN, 1000.0, f64::NAN, f64::INFINITY, 500.0].map(|x| block.step(&at(x)).value("x_drive"));
    // 30000 um/s at 30/s are 1000 um; before the first command in range there is nothing to keep.
    assert_eq!(drive, [0.0, 2000.0, 2000.0, 2000.0, 1500.0]);
    let loose = block.step(&Inputs { position_controlled: false, ..at(700.0) }).value("x_drive");
    assert_eq!([loose, block.step(&at(f64::NAN)).value("x_drive")], [700.0; 2]);
}

/// A spindle whose drive controls the position: without a velocity in range the position goes on with error 14; with half a
/// turn in a cycle it is held with error 44.
#[test]
fn a_spindle_goes_on_without_its_velocity_and_holds_at_half_a_turn() {
    for feedforward in ["", "vorsteuer.vorsteuerung = \"VEL\""] {
        let lines = "kenngr.achs_typ = \"ACHSTYP_SPINDEL\"\nkenngr.antr_typ = \"SERCOS\"\n\
                     getriebe = [{ kv = 3000, dynamik.vb_max = 100000000 }]";
        let mut block = Block::new(2, &format!("{lines}\n{feedforward}"));
        let mut step = |x_command: f64, v_interpolator: f64| {
            let found = block.step(&Inputs { x_command, v_interpolator, feedforward_active: false, ..Inputs::USUAL });
            ["x_drive", "error_id", "fault"].map(|output| found.value(output))
        };
        assert_eq!(step(1000.0, 1e8), [1000.0, 0.0, 0.0], "{feedforward}");
        for none in [f64::NAN, f64::INFINITY, -1e16] {
            assert_eq!(step(2000.0, none), [2000.0, 14.0, 1.0], "{feedforward}, {none}");
        }
        assert_eq!(step(3000.0, -1.8e8), [2000.0, 44.0, 1.0], "{feedforward}");
        assert_eq!(step(3000.0, 1.79e8), [3000.0, 0.0, 0.0], "{feedforward}");
    }
}

/// A torque is limited where the number is rounded beyond INT16, not before. A kilogram, a newton at 1000 increments:
/// 1000 um/s^2 an increment.
#[test]
fn a_torque_is_limited_where_its_integer_ends() {
    let lines = "motor = \"linear\"\nkenngr.antr_typ = \"SERCOS\"\nprocess_data.additive_torque = \"INT16\"\n\
                 getriebe = [{ kv = 2000, load = 1 }]\nantr.torque_scale_num = 1000\nvorsteuer.vorsteuerung = \"ADD_ACC\"";
    for (which, limited) in [(0, "torque_limited"), (2, "limited")] {
        let mut block = Block::new(which, lines);
        for (increments, expected, is_limited) in [
            (32_767.4, 32_767.0, 0.0),
            (32_767.6, 32_767.0, 1.0),
            (-32_768.4, -32_768.0, 0.0),
            (-32_768.6, -32_768.0, 1.0),
            (1e9, 32_767.0, 1.0),
        ] {
            let found = block.step(&Inputs { a_interpolator: 1000.0 * increments, ..Inputs::USUAL });
            assert_eq!([found.value("additive_torque"), found.value(limited)], [expected, is_limited], "{increments}");
        }
    }
}

/// A stage at 50 Hz, where the band-pass passes as it is; 20 cycles of fading.
fn stage(mode: &str) -> String {
    format!(
        "lr_param.improved_position_control.v_add_max_fact = 2000\nfade = \"20ms\"\n\
         lr_param.improved_position_control.stage = [{{ {mode}, filter = [{{ order = 1, fg_f0 = 50, q_factor = 1 }}] }}]"
    )
}

/// A sine at 50 Hz.
fn sine(cycle: i32) -> f64 {
    1000.0 * (std::f64::consts::TAU * 0.05 * f64::from(cycle)).sin()
}

/// Lost position control: 0 at once, then 0 of preset filters, then the fade grows by a twentieth a cycle.
#[test]
fn improved_position_control_starts_anew_after_a_loss_of_position_control() {
    let lines = format!("getriebe = [{{ kv = 2000 }}]\n{}", stage("mode = \"DIRECT\""));
    let mut block = Block::new(2, &lines);
    let mut step = |cycle: i32, position_controlled| {
        let found = block.step(&Inputs { v_motor: 5000.0 + sine(cycle), position_controlled, ..Inputs::USUAL });
        [found.value("v_add"), found.value("v_add_calculated")]
    };
    (0..205).for_each(|cycle| _ = step(cycle, true));
    let [v_add, calculated] = step(205, true);
    assert!(v_add == calculated && v_add.abs() > 500.0, "{v_add}");
    assert_eq!(step(206, false), [0.0; 2]);
    assert_eq!(step(207, true), [0.0; 2]);
    for cycle in 208..240 {
        let [v_add, calculated] = step(cycle, true);
        let fade = f64::from((cycle - 207).min(20)) / 20.0;
        assert!((v_add - fade * calculated).abs() < 1e-9 && calculated.abs() > 1e-3, "{cycle}: {v_add}, {calculated}");
    }
}

/// At f0 the simulated oscillation is 1 + 1/(2 j D), of the interpolator's velocity where the drive controls the position.
#[test]
fn set_point_in_a_drive_reads_the_interpolator() {
    let lines = format!("{DRIVE}\ngetriebe = [{{ kv = 2000 }}]\n{}", stage("mode = \"SET_POINT\", osc_damping = 0.5"));
    let mut block = Block::new(2, &lines);
    for cycle in 0..600 {
        let found = block.step(&Inputs { x_command: 1e6 + 3.0 * sine(7 * cycle), v_motor: 1e5, ..at(sine(cycle)) });
        // -(1 - j) sin = -(sin - cos), with the cosine a quarter of a period, 5 cycles, before the sine
        let expected = -(sine(cycle) - sine(cycle + 5));
        if cycle > 300 {
            assert!(
                (found.value("v_add") - expected).abs() < 1.0,
                "{cycle}: {} instead of {expected}",
                found.value("v_add")
            );
        }
    }
}

/// P-AXIS-00165: the position comes after whatever the feedforward puts out: with 2 cycles 0, 0, 0, 10, 20 for 0, 10, 20, 30, 40.
#[test]
fn shift_time_in_all_combinations_of_process_data() {
    for (word, velocity, torque, is_shifted) in [
        ("VEL", "NONE", "NONE", true),
        ("ADD_VEL", "INT32", "NONE", true),
        ("ADD_ACC", "NONE", "INT32", true),
        ("ADD_VEL ADD_ACC", "INT32", "INT32", true),
        ("VEL ADD_ACC", "NONE", "INT32", true),
        ("VEL ADD_ACC", "INT32", "INT32", true),
        // Corrected: what no process datum takes is switched off, and leads nothing (70350, 70351).
        ("ADD_VEL", "NONE", "NONE", false),
        ("ADD_ACC", "INT32", "NONE", false),
        ("NONE", "INT32", "INT32", false),
    ] {
        let lines = format!(
            "kenngr.antr_typ = \"PROFIDRIVE\"\nvorsteuer.vorsteuerung = \"{word}\"\nvorsteuer.shift_time = 2\n\
             process_data.additive_velocity = \"{velocity}\"\nprocess_data.additive_torque = \"{torque}\"\n\
             antr.acc_reference_value = 0.45\ngetriebe = [{{ kv = 2000, load = 0.25 }}]"
        );
        let mut block = Block::new(1, &lines);
        let found = [0.0, 10.0, 20.0, 30.0, 40.0].map(|x_command| {
            block.step(&Inputs { x_command, feedforward_active: false, ..Inputs::USUAL }).value("x_drive")
        });
        let expected = if is_shifted { [0.0, 0.0, 0.0, 10.0, 20.0] } else { [0.0, 10.0, 20.0, 30.0, 40.0] };
        assert_eq!(found, expected, "{word}, {velocity}, {torque}");
    }
}

/// What a load of 0 takes out is not read: a bad acceleration does not take the velocity along.
#[test]
fn a_load_of_0_takes_the_torque_out() {
    let lines = |load: &str| {
        format!(
            "{DRIVE}\n{MANUAL}\nvorsteuer.vorsteuerung = \"ADD_VEL ADD_ACC\"\nprocess_data.additive_torque = \"INT32\"\n\
             antr.acc_reference_value = 0.45\ngetriebe = [{{ kv = 2000, load = {load} }}]"
        )
        .replace("vorsteuer.vorsteuerung = \"ADD_VEL\"\n", "")
    };
    let found = |load: &str| {
        let mut block = Block::new(0, &lines(load));
        let inputs = Inputs { feedforward_active: true, a_interpolator: f64::NAN, ..at(1000.0) };
        let found = block.step(&inputs);
        ["error_id", "additive_velocity"].map(|signal| found.value(signal))
    };
    assert_eq!(found("0"), [0.0, 180_018.0]);
    assert_eq!(found("0.25"), [15.0, 0.0]);
}

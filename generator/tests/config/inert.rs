//! Settings that leave a function without effect, and those that cut its output off.

use super::read_set;
use generator::axis::{Control, Quantities};

/// What is left out is not computed, and its input not judged: a bad acceleration must not take the velocity along.
#[test]
fn what_is_left_out_is_no_part_of_the_axis() {
    let control = |lines: &str| -> Control {
        let (set, _) = read_set(format!("cycle_time = \"1ms\"\n[axis.X]\ngetriebe = [{{ kv = 2000 }}]\n{lines}"));
        set.expect("a warning is no error").axes.remove(0).axis.control
    };
    let sums = |lines: &str| {
        let feedforward = control(lines).feedforward.expect("it has feedforward");
        [feedforward.conventional, feedforward.additive, feedforward.torque]
    };
    let none = Quantities::default();
    let all = "vorsteuer.vorsteuerung = 'VEL ACC JERK'\n";
    assert_eq!(sums(all), [Quantities { velocity: true, acceleration: true, jerk: true }, none, none]);
    let velocity = [Quantities { velocity: true, ..none }, none, none];
    for weight in ["vs_a_nenner", "vs_a_faktor"] {
        assert_eq!(sums(&format!("{all}vorsteuer.{weight} = 0")), velocity, "{weight}");
    }
    for weight in ["vs_v_nenner", "vs_v_faktor"] {
        assert_eq!(sums(&format!("{all}vorsteuer.{weight} = 0")), [none; 3], "{weight}");
    }
    let torque = "process_data.additive_torque = 'INT16'\nadd_jerk = 'experimental'\n\
                  vorsteuer.vorsteuerung = 'VEL ADD_ACC ADD_JERK'\nvorsteuer.vs_a_nenner = 0\n";
    assert_eq!(sums(torque), [velocity[0], none, Quantities { jerk: true, ..none }]);
}

/// P-AXIS-00165 delays the position for a feedforward that leads; one that is switched off leads nothing.
#[test]
fn a_position_waits_for_no_feedforward_that_is_off() {
    let shift = |datum: &str| {
        let lines = format!(
            "cycle_time = \"1ms\"\n[axis.P]\nkenngr.antr_typ = 'PROFIDRIVE'\nprocess_data.additive_velocity = '{datum}'\n\
             vorsteuer.vorsteuerung = 'ADD_VEL'\ngetriebe = [{{ kv = 2000, incr_per_rev = 1000 }}]\n"
        );
        let (set, _) = read_set(lines);
        let control = set.expect("a warning is no error").axes.remove(0).axis.control;
        control.position_control.expect("the drive controls the position").shift_time
    };
    assert_eq!([shift("INT32"), shift("NONE")], [3, 0]);
}

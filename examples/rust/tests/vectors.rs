//! The approved vectors: the crate computes the same bits as on the day when they were recorded (`axgen golden record golden/x`).

use drive::axis_x_ipc::{ErrorId, Inputs, Mode, Outputs, State, CYCLE_TIME_NS, LIMIT, MODE_ON};
use drive::Axis;

/// The rows of a file of vectors: for each signal its name and its cell.
fn rows(file: &str) -> Vec<Vec<(String, String)>> {
    let path = format!("{}/golden/x/{file}", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned));
    let names: Vec<String> = lines.next().expect("a header").collect();
    lines.map(|cells| names.iter().cloned().zip(cells).collect()).collect()
}

/// A number as the hexadecimal digits of its bits.
fn real(cell: &str) -> f64 {
    f64::from_bits(u64::from_str_radix(&cell[2..], 16).expect("0x and 16 digits"))
}

fn set(inputs: &mut Inputs, (name, cell): &(String, String)) {
    match name.as_str() {
        "v_command" => {} // this axis does not read it
        "v_motor" => inputs.v_motor = real(cell),
        "mode" => inputs.mode = cell.parse().expect("a number"),
        "position_controlled" => inputs.position_controlled = cell == "1",
        "reset" => inputs.reset = cell == "1",
        "task_cycle_ns" => inputs.task_cycle_ns = cell.parse().expect("a number"),
        _ => panic!("{name} is not an input"),
    }
}

fn shown(outputs: &Outputs, name: &str) -> String {
    match name {
        "v_add" => format!("0x{:016x}", outputs.v_add.to_bits()),
        "v_add_calculated" => format!("0x{:016x}", outputs.v_add_calculated.to_bits()),
        "limited" => u8::from(outputs.limited).to_string(),
        "held" => "0".to_owned(), // this axis rides through nothing
        "tripped" => "0".to_owned(), // and watches nothing
        "fault" => u8::from(outputs.fault).to_string(),
        "error_id" => outputs.error_id.to_string(),
        _ => panic!("{name} is not an output"),
    }
}

#[test]
fn the_vectors_are_as_approved() {
    let mut axis = Axis::<State>::start(CYCLE_TIME_NS).expect("the bits of the reference");
    let (inputs, outputs) = (rows("inputs.csv"), rows("outputs.csv"));
    assert_eq!((inputs.len(), outputs.len()), (200, 200));
    for (cycle, (inputs, expected)) in inputs.iter().zip(&outputs).enumerate() {
        inputs.iter().for_each(|cell| set(&mut axis.inputs, cell));
        let found = axis.cycle();
        for (name, cell) in expected {
            assert_eq!(&shown(found, name), cell, "cycle {cycle}: {name}");
        }
    }
}

#[test]
fn numbers_have_names() {
    let mut axis = Axis::<State>::start(1_000_000).expect("the cycle time of the set, and the bits of the reference");
    assert!(Axis::<State>::start(2_000_000).is_none());
    assert_eq!((axis.inputs.mode, Mode::from_number(MODE_ON)), (Mode::On.into(), Some(Mode::On)));
    assert!(axis.cycle().v_add.abs() <= LIMIT);
    assert_eq!(ErrorId::from_number(axis.error_id()), Some(ErrorId::None));
    axis.inputs.mode = 7;
    axis.cycle();
    assert_eq!(ErrorId::from_number(axis.error_id()), Some(ErrorId::Mode));
    assert_eq!((Mode::from_number(7), ErrorId::from_number(4711)), (None, None));
}

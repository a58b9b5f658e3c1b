//! The recorded runs of the suites: as many values as declared, all of them numbers, and what the block itself gives.

use crate::twincat::{code, object};
use crate::{CASES, Case};
use compiler::interp::Machine;
use compiler::print::identifier;
use compiler::program::{Type, Variable};
use generator::blocks::{Block, Designed, blocks};
use portable::{Literal, RealKind};
use std::collections::BTreeMap;

/// The values of each signal, by its name.
type Tracks = BTreeMap<String, (String, Vec<String>)>;

/// What a list of variables declares: a type and as many values as its bounds say.
fn tracks(text: &str) -> Tracks {
    let code = code(&object(text).at("Declaration").text);
    let inside = code.split_once("VAR_GLOBAL CONSTANT").unwrap().1.split_once("END_VAR").unwrap().0;
    let declarations = inside.split(';').map(str::trim).filter(|declaration| !declaration.is_empty());
    let mut tracks = Tracks::new();
    for declaration in declarations {
        let (name, rest) = declaration.split_once(" : ARRAY[0..").unwrap();
        let (last, rest) = rest.split_once("] OF ").unwrap();
        let (ty, values) = rest.split_once(" := [").unwrap();
        let values = expanded(values.strip_suffix(']').unwrap());
        assert_eq!(values.len(), last.parse::<usize>().unwrap() + 1, "{name}");
        assert!(tracks.insert(name.to_owned(), (ty.to_owned(), values)).is_none(), "{name} twice");
    }
    tracks
}

/// Values of which some are written `count(value)`.
fn expanded(values: &str) -> Vec<String> {
    values
        .split(',')
        .map(str::trim)
        .flat_map(|value| {
            let (count, value) = match value.strip_suffix(')').and_then(|value| value.split_once('(')) {
                Some((count, value)) => (count.parse().unwrap(), value),
                None => (1, value),
            };
            assert!(count > 0 && !value.is_empty() && !value.contains(['(', ')']), "{value}");
            std::iter::repeat_n(value.to_owned(), count)
        })
        .collect()
}

/// A value as the interpreter has it.
fn literal(variable: &Variable, real: RealKind, ty: &str, text: &str) -> Literal {
    let bits = |digits: usize| {
        let bits = text.strip_prefix("16#").unwrap();
        assert_eq!(bits.len(), digits, "{text}");
        u64::from_str_radix(bits, 16).unwrap()
    };
    match (variable.ty, real, ty) {
        (Type::Bool, _, "BOOL") => Literal::Bool(
            matches!(text, "TRUE") || {
                assert_eq!(text, "FALSE");
                false
            },
        ),
        (Type::I32, _, "DINT") => Literal::I32(text.parse().unwrap()),
        (Type::U32, _, "UDINT") => Literal::U32(text.parse().unwrap()),
        (Type::Real, RealKind::F64, "LWORD") => Literal::F64(f64::from_bits(bits(16))),
        (Type::Real, RealKind::F32, "DWORD") => Literal::F32(f32::from_bits(u32::try_from(bits(8)).unwrap())),
        other => panic!("{}: {other:?}", variable.path),
    }
}

/// The samples of some signals; one that is not in the list has its start in all of them.
fn samples(variables: &[Variable], real: RealKind, tracks: &Tracks, count: usize) -> Vec<Vec<Literal>> {
    let of = |variable: &Variable, sample: usize| match tracks.get(&identifier(&variable.path)) {
        Some((ty, values)) => literal(variable, real, ty, &values[sample]),
        None => variable.start,
    };
    (0..count).map(|sample| variables.iter().map(|variable| of(variable, sample)).collect()).collect()
}

/// Every block of a set with what its list holds.
fn each(mut visit: impl FnMut(&Case, &Designed, &Block, &Tracks)) {
    for case in CASES.iter() {
        for axis in &case.set.axes {
            for block in blocks(axis).unwrap() {
                let stem = format!("axis_{}_{}", axis.axis.name.to_ascii_lowercase(), block.program.block);
                let tracks = tracks(&case.files[&format!("twincat/Tests/GVL_{stem}_vector.TcGVL")]);
                visit(case, axis, &block, &tracks);
            }
        }
    }
}

fn is_number(value: &Literal) -> bool {
    match value {
        Literal::F64(value) => value.to_bits() & 0x7ff0_0000_0000_0000 != 0x7ff0_0000_0000_0000,
        Literal::F32(value) => value.to_bits() & 0x7f80_0000 != 0x7f80_0000,
        _ => true,
    }
}

/// Inputs that the list leaves out do not matter to the block.
#[test]
fn the_block_gives_what_the_list_holds() {
    let mut values = 0;
    each(|case, axis, block, tracks| {
        let program = &block.program;
        let count = tracks.values().next().unwrap().1.len();
        let inputs = samples(&program.inputs, axis.axis.real, tracks, count);
        let outputs = samples(&program.outputs, axis.axis.real, tracks, count);
        for output in &program.outputs {
            assert!(tracks.contains_key(&identifier(&output.path)), "{}: {}", case.name, output.path);
        }
        let names: Vec<String> =
            program.inputs.iter().chain(&program.outputs).map(|variable| identifier(&variable.path)).collect();
        assert!(tracks.keys().all(|name| names.contains(name)), "{}: {names:?}", case.name);
        let (mut machine, mut found) = (Machine::start(program), Vec::new());
        for (sample, (inputs, expected)) in inputs.iter().zip(&outputs).enumerate() {
            assert!(inputs.iter().chain(expected).all(is_number), "{}: {}: sample {sample}", case.name, axis.axis.name);
            machine.step(inputs, &mut found);
            let bits = |values: &[Literal]| -> Vec<String> { values.iter().map(bits_of).collect() };
            assert_eq!(bits(&found), bits(expected), "{}: {}: sample {sample}", case.name, axis.axis.name);
            values += found.len();
        }
    });
    assert!(values > 10_000, "{values} values");
}

/// A text that differs wherever a bit does.
fn bits_of(value: &Literal) -> String {
    match value {
        Literal::F64(value) => format!("{:016x}", value.to_bits()),
        Literal::F32(value) => format!("{:08x}", value.to_bits()),
        other => format!("{other:?}"),
    }
}

#[test]
fn a_list_shows_a_fault_a_dry_run_and_a_movement() {
    let mut shown = 0;
    each(|case, axis, block, tracks| {
        // Other blocks have no mode.
        if block.program.block != "ipc" || axis.axis.ipc.limit() == 0.0 {
            return;
        }
        let name = format!("{}: {}", case.name, axis.axis.name);
        let values = |signal: &str| &tracks[signal].1;
        assert!(values("fault").iter().any(|value| value == "TRUE"), "{name}: a fault");
        assert!(values("fault").iter().any(|value| value == "FALSE"), "{name}: no fault");
        let dry: Vec<usize> = (0..values("mode").len()).filter(|sample| values("mode")[*sample] == "2").collect();
        assert!(!dry.is_empty(), "{name}: DRYRUN");
        let is_zero = |value: &str| value.trim_start_matches("16#").trim_matches('0').is_empty();
        let moves = values("v_add_calculated").iter().filter(|value| !is_zero(value)).count();
        assert!(moves > 10, "{name}: {moves} samples that move");
        assert!(
            dry.iter().any(|sample| !is_zero(&values("v_add_calculated")[*sample])),
            "{name}: it calculates in DRYRUN"
        );
        shown += 1;
    });
    assert!(shown > 20, "{shown} blocks");
}

#[test]
fn counted_values_are_expanded() {
    assert_eq!(expanded("3(TRUE), FALSE,\n 2(16#00)"), ["TRUE", "TRUE", "TRUE", "FALSE", "16#00", "16#00"]);
}

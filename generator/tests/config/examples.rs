//! The examples of the repository: they load, and say nothing but what they should.

use crate::{options_of, shipped};
use generator::axis::{DirectSource, Enable, Filter, Mode, Prototype, Stage};
use generator::config::ListOptions;
use generator::pipeline::{Set, read};
use portable::RealKind;
use std::path::Path;

fn example(name: &str, options: &ListOptions) -> (Set, String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(name);
    let (set, report) = read(&path, options);
    (set.unwrap_or_else(|| panic!("{report}")), report.to_string())
}

/// The manual's example starts ON with a limit of 100 %: of that, and of nothing else, the user is told.
fn assert_starts_on(said: &str) {
    assert!(said.contains(":63: warning[AX439]") && said.lines().count() == 2, "{said}");
}

fn at_1ms() -> ListOptions {
    ListOptions { cycle_time: Some("1ms".to_owned()), ..ListOptions::default() }
}

#[test]
fn rack_and_pinion() {
    let (set, said) = example("rack-and-pinion.lis", &at_1ms());
    assert_starts_on(&said);
    assert_eq!((set.axes.len(), set.foreign), (1, 0));
    let axis = &set.axes[0].axis;
    assert_eq!((axis.name.as_str(), axis.real, axis.cycle_time_ns), ("rack_and_pinion", RealKind::F64, 1_000_000));
    assert_eq!((axis.ipc.enable, axis.ipc.v_add_max_fact), (Enable::On, 1000));
    assert_eq!((axis.ipc.v_max.to_bits(), axis.ipc.fade.to_bits()), (530_000f64.to_bits(), 0.1f64.to_bits()));
    let bandpass = |f0, q_factor| {
        [Filter::Bandpass { prototype: Prototype::CritDamping, order: 1, f0, q_factor }, Filter::NoFilter]
    };
    let direct = Stage {
        mode: Mode::Direct { source: DirectSource::Motor },
        weight_fact_num: 300,
        weight_fact_denom: 100,
        filter: bandpass(53.0, 10.0),
    };
    let indirect = Stage {
        mode: Mode::Indirect { osc_damping: 0.8 },
        weight_fact_num: 190,
        weight_fact_denom: 100,
        filter: bandpass(11.0, 2.0),
    };
    assert_eq!(axis.ipc.stage, [Some(direct), Some(indirect), None]);
}

#[test]
fn two_frequencies() {
    let (set, said) = example("two-frequencies.lis", &at_1ms());
    assert_starts_on(&said);
    assert_eq!(set.axes[0].axis.ipc.stage.iter().flatten().map(Stage::f0).collect::<Vec<_>>(), [53.0, 90.0]);
}

#[test]
fn machine() {
    let (set, said) = example("machine.toml", &ListOptions::default());
    assert_starts_on(&said);
    assert_eq!(set.targets, ["c"]);
    assert_eq!(set.axes.iter().map(|of| of.axis.name.as_str()).collect::<Vec<_>>(), ["X", "Y", "C"]);
    let [x, y, c] = &set.axes[..] else { panic!() };
    let [x, y, c] = [x, y, c].map(|of| &of.axis);
    assert_eq!(x.ipc.fade.to_bits(), 0.2f64.to_bits());
    let allpass = Filter::Allpass { f0: 28.1, q_factor: 2.0 };
    assert_eq!(y.ipc.stage[0].as_ref().unwrap().filter[1], allpass);
    assert_eq!((y.ipc.enable, c.real), (Enable::DryRun, RealKind::F32));
    assert_eq!(c.ipc.stage.iter().flatten().count(), 2);
}

/// What is shipped is warned of where that is right, and nowhere else: a new warning is looked at here.
#[test]
fn every_shipped_set_has_the_warnings_that_are_listed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut listed = String::new();
    for file in shipped(&root) {
        let (_, report) = read(&file, &options_of(&file));
        let mut codes: Vec<&str> = report.diagnostics.iter().map(|said| said.code).collect();
        codes.sort_unstable();
        if !codes.is_empty() {
            let name = file.strip_prefix(&root).unwrap_or(&file).to_string_lossy().replace('\\', "/");
            listed.push_str(&format!("{name}: {}\n", codes.join(" ")));
        }
    }
    transcript::equals(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/config/shipped.txt"), &listed);
}

//! The example `examples/set-design`: drive parameters that are typed while the axis moves become parameter sets of the generator.

use std::{fs, path::Path, process::Command};

fn succeeds(command: &mut Command) -> String {
    let output = command.output().unwrap();
    let [said, errors] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    assert!(output.status.success(), "{said}{errors}");
    said
}

/// The number of the set that `params-of` makes for the example's block, of other numbers.
fn set_id(example: &Path, folder: &Path, changes: &[(&str, &str)]) -> u32 {
    let generated = example.join("axes.toml");
    let mut text = fs::read_to_string(&generated).unwrap();
    for (old, new) in changes {
        assert_eq!(text.matches(old).count(), 1, "{old}");
        text = text.replace(old, new);
    }
    let typed = folder.join("typed.toml");
    fs::write(&typed, text).unwrap();
    let mut command = Command::new(crate::AXGEN);
    command.arg("params-of").arg(typed).args(["--axis", "X", "--as", "csv", "--on"]).arg(generated);
    let csv = succeeds(&mut command);
    csv.lines().find_map(|line| line.strip_prefix("set_id,")).unwrap().parse().unwrap()
}

#[test]
fn a_typed_set_is_that_of_params_of_and_damps_the_simulated_axis() {
    let example = Path::new(crate::EXAMPLES).join("set-design");
    let folder = tempfile::tempdir().unwrap();
    let mut run = Command::new(example.join("run.sh"));
    run.arg(folder.path()).env("AXGEN", crate::AXGEN);
    if std::env::var_os("CC").is_none() {
        run.env("CC", "cc");
    }
    let said = succeeds(&mut run);
    let shown: Vec<(u32, u32)> = (said.lines())
        .filter_map(|line| line.strip_prefix("set ")?.strip_suffix(" um/s")?.split_once(": amplitude "))
        .map(|(id, amplitude)| (u32::from_str_radix(id, 16).unwrap(), amplitude.parse().unwrap()))
        .collect();

    let weight = ("weight_fact_num = 1 ", "weight_fact_num = 3000 ");
    let sets = [&[][..], &[weight], &[weight, ("fg_f0 = 50,", "fg_f0 = 53,")]];
    let [generated, heavier, moved] = sets.map(|changes| set_id(&example, folder.path(), changes));
    // what was refused leaves the set in use as it is
    assert_eq!(
        shown.iter().map(|(id, _)| *id).collect::<Vec<_>>(),
        [generated, heavier, moved, moved, moved, moved],
        "{said}"
    );
    assert!(2 * shown[2].1 < shown[0].1, "{said}");
    assert_eq!(said.matches("refused: error 62, still 53\n").count(), 1, "{said}");
    assert_eq!(said.matches("refused: error 65, still 3\n").count(), 2, "{said}");
}

//! The digest in a file covers the parameters of its block: what changes a block changes its digest, and what is another block's
//! business leaves all its files as they are.

use generator::config::ListOptions;
use generator::generate::axis_files;
use generator::parameters::{Name, Scope};
use generator::pipeline::read_with;
use generator::target::{File, TARGETS, Target};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// An axis with all blocks, as a list: position control in the CNC, in a SERCOS drive, in a PROFIdrive.
const LISTS: [&str; 3] = [
    "kopf.achs_nr 1\nkenngr.antr_typ CONVENTIONAL\ngetriebe[0].kv 2000\ngetriebe[0].multi_gain_z 20000\n\
     getriebe[0].multi_gain_n 1\nvorsteuer.vorsteuerung VEL|ACC\nvorsteuer.vs_a_faktor 4000\n",
    "kopf.achs_nr 1\nkenngr.antr_typ SERCOS\ngetriebe[0].kv 2000\nvorsteuer.vorsteuerung ADD_VEL|ADD_ACC\n\
     vorsteuer.vs_v_faktor 9\nvorsteuer.vs_v_nenner 10\nvorsteuer.vs_a_faktor 3\nvorsteuer.vs_a_nenner 2\n\
     vorsteuer.velocity_delay_time 150\nvorsteuer.acceleration_delay_time 250\nantr.v_reso_num 10000\n\
     antr.v_reso_denom 3333\nantr.v_time_base 0\nantr.torque_scale_num 16000\nantr.acc_reference_value 12.5\n\
     getriebe[0].load 0.002\ngetriebe[0].incr_per_rev 4096\ngetriebe[0].wegaufz 4096\ngetriebe[0].wegaufn 100\n",
    "kopf.achs_nr 1\nkenngr.antr_typ PROFIDRIVE\ngetriebe[0].kv 2000\nvorsteuer.vorsteuerung VEL\nvorsteuer.shift_time 2\n\
     getriebe[0].incr_per_rev 4096\ngetriebe[0].wegaufz 4096\ngetriebe[0].wegaufn 100\n",
];

/// What all of them have.
const IPC: &str = "getriebe[0].dynamik.vb_max 500000\nlr_param.improved_position_control.enable ON\n\
    lr_param.improved_position_control.v_add_max_fact 100\n\
    lr_param.improved_position_control.stage[0].mode DIRECT\n\
    lr_param.improved_position_control.stage[0].weight_fact_num 3\n\
    lr_param.improved_position_control.stage[0].filter[0].order 1\n\
    lr_param.improved_position_control.stage[0].filter[0].fg_f0 53\n\
    lr_param.improved_position_control.stage[0].filter[0].q_factor 5\n\
    lr_param.improved_position_control.stage[1].mode INDIRECT\n\
    lr_param.improved_position_control.stage[1].osc_damping 0.8\n\
    lr_param.improved_position_control.stage[1].filter[0].order 1\n\
    lr_param.improved_position_control.stage[1].filter[0].fg_f0 11\n\
    lr_param.improved_position_control.stage[1].filter[0].q_factor 2\n";

const SET: &str = "cycle_time = \"CYCLE\"\n[axis.X]\nlist = \"x.lis\"\nreal = \"f64\"\nfade = \"0.1s\"\n\
    process_data.additive_velocity = \"INT32\"\nprocess_data.additive_torque = \"INT16\"\n";

/// The files of all targets by name; none: the parameters are refused.
fn files(set: &str, list: &str) -> Option<BTreeMap<String, String>> {
    files_for(&TARGETS, set, list)
}

fn files_for(targets: &[Target], set: &str, list: &str) -> Option<BTreeMap<String, String>> {
    let set = set.replace("CYCLE", "1ms");
    let load = |path: &Path| Ok(if path.ends_with("x.lis") { list } else { &set }.as_bytes().to_vec());
    let (set, _) = read_with(Path::new("set.toml"), &ListOptions::default(), &load);
    let files = axis_files(&set?.axes[0], targets).unwrap();
    Some(files.into_iter().map(|File { name, text }| (name, text)).collect())
}

/// The name of the block that a file holds.
fn block(text: &str) -> &str {
    let line = text.lines().find_map(|line| line.trim_start_matches([' ', '*', '/']).strip_prefix("block "));
    line.expect("a head names its block").trim()
}

/// A text without its digests, and the digest of its parameters.
fn parts(text: &str) -> (String, &str) {
    let of = |line: &str, word| line.trim_start_matches([' ', '*', '/']).starts_with(word);
    let digest = text.lines().find(|line| of(line, "parameters ")).unwrap();
    let rest = text.lines().filter(|line| !of(line, "parameters ") && !of(line, "checksum "));
    (rest.collect::<Vec<_>>().join("\n"), digest)
}

/// The files before a change and after it, each change for the next target.
struct InTurn {
    before: [BTreeMap<String, String>; TARGETS.len()],
    number: usize,
}

impl InTurn {
    fn of(list: &str) -> Self {
        Self { before: TARGETS.map(|target| files_for(&[target], SET, list).unwrap()), number: 0 }
    }

    /// None: the parameters are refused.
    fn change(&mut self, set: &str, list: &str) -> Option<[BTreeMap<String, String>; 2]> {
        self.number = (self.number + 1) % TARGETS.len();
        Some([self.before[self.number].clone(), files_for(&[TARGETS[self.number]], set, list)?])
    }
}

/// Other values that a value may have.
fn others(value: &str) -> Vec<String> {
    match value.parse::<f64>() {
        Ok(number) => [number + 1.0, number * 2.0, number / 2.0].map(|other| other.to_string()).into(),
        Err(_) => {
            ["OFF", "DRYRUN", "SET_POINT", "DIRECT", "VEL", "ADD_VEL", "ACC", "SERCOS", "PROFIDRIVE", "CONVENTIONAL"]
                .map(str::to_owned)
                .into()
        }
    }
}

#[test]
fn what_changes_a_block_changes_its_digest() {
    let (mut changes, mut changed_blocks) = (0, BTreeSet::new());
    for list in LISTS.map(|list| list.to_owned() + IPC) {
        let mut in_turn = InTurn::of(&list);
        assert!(
            in_turn.before.iter().all(|of| of.values().map(|text| block(text)).collect::<BTreeSet<_>>().len() == 4)
        );
        for line in list.lines() {
            let (path, value) = line.split_once(' ').unwrap();
            for other in others(value) {
                let changed = list.replace(line, &format!("{path} {other}"));
                let Some([before, after]) = in_turn.change(SET, &changed) else { continue };
                for (name, text) in &before {
                    let Some(new) = after.get(name) else { continue };
                    let ((old, old_digest), (new, new_digest)) = (parts(text), parts(new));
                    assert!(old == new || old_digest != new_digest, "{name}: {path} {value} -> {other}");
                    if old != new {
                        changes += 1;
                        changed_blocks.insert(block(text).to_owned());
                    }
                }
            }
        }
    }
    assert!(changes > 150 && changed_blocks.len() == 4, "{changes}, {changed_blocks:?}");
}

/// A weight is the business of `ipc`, and of `axis`, which holds it. A file of each target has to change, and no other.
#[test]
fn another_weight_changes_the_files_of_ipc_and_axis_alone() {
    for list in LISTS.map(|list| list.to_owned() + IPC) {
        let before = files(SET, &list).unwrap();
        let after = files(SET, &list.replace("weight_fact_num 3", "weight_fact_num 2")).unwrap();
        assert!(before.keys().eq(after.keys()));
        for target in TARGETS {
            let of_target = |name: &str| match target.name {
                "twincat" => name.starts_with("twincat/"),
                "c" => name.ends_with(".c") || name.ends_with(".h"),
                "rust" => name.ends_with(".rs"),
                "codesys" => name.ends_with(".xml"),
                dialect => name.ends_with(&format!(".{dialect}")),
            };
            let changed: BTreeSet<&str> = before
                .iter()
                .filter(|(name, text)| of_target(name) && after[*name] != **text)
                .map(|(_, text)| block(text))
                .collect();
            assert_eq!(changed, BTreeSet::from(["axis", "ipc"]), "{}", target.name);
            let all = before.iter().filter(|(name, _)| of_target(name)).map(|(_, text)| block(text));
            assert_eq!(all.collect::<BTreeSet<_>>().len(), 4, "{}", target.name);
        }
    }
}

/// And feedforward's is its own.
#[test]
fn another_delay_leaves_ipc_as_it_is() {
    let list = LISTS[1].to_owned() + IPC;
    let before = files(SET, &list).unwrap();
    let after = files(SET, &list.replace("velocity_delay_time 150", "velocity_delay_time 160")).unwrap();
    let changed: BTreeSet<&str> =
        before.iter().filter(|(name, text)| after[*name] != **text).map(|(_, text)| block(text)).collect();
    assert_eq!(changed, BTreeSet::from(["axis", "feedforward"]));
}

/// Each parameter of the table that an axis does not have, written with its default: so a key that is new in this
/// program leaves the files of a set without it as they were.
#[test]
fn a_default_that_is_written_changes_no_file() {
    let mut written: BTreeSet<String> = BTreeSet::new();
    for list in LISTS.map(|list| list.to_owned() + IPC) {
        let mut in_turn = InTurn::of(&list);
        for parameter in Name::ALL.iter().map(|name| name.parameter()).filter(|parameter| !parameter.default.is_empty())
        {
            let (path, default) = (at_zero(parameter.path), parameter.default[0]);
            let of_path = |line: &str| line.split([' ', '=']).next() == Some(&path);
            if list.lines().chain(SET.lines()).any(of_path) {
                continue;
            }
            let files = match parameter.scope {
                Scope::List => in_turn.change(SET, &format!("{list}{path} {default}\n")),
                Scope::Axis if default.parse::<f64>().is_ok() => {
                    in_turn.change(&format!("{SET}{path} = {default}\n"), &list)
                }
                Scope::Axis => in_turn.change(&format!("{SET}{path} = \"{default}\"\n"), &list),
                Scope::Set => continue,
            };
            // Some ask for a block where they stand at all.
            let Some([before, after]) = files.filter(|[before, after]| after.keys().eq(before.keys())) else {
                continue;
            };
            assert!(after == before, "{path} {default}");
            written.insert(path);
        }
    }
    assert!(written.len() > 60, "{}: {written:?}", written.len());
}

/// A path of the table with the first of each index.
fn at_zero(path: &str) -> String {
    path.replace("[i]", "[0]").replace("[k]", "[0]")
}

//! The canonical form: what the digest of an axis covers, and what does not change it.

use super::{IPC, direct, indirect, read, read_list, read_set};
use generator::config::ListOptions;

fn canonical(list: &str) -> String {
    let (set, report) = read_list(list.replace("ipc.", IPC));
    set.unwrap_or_else(|| panic!("{report}")).axes.remove(0).axis.canonical
}

/// A default is not in it: a parameter that is new changes no digest of a set that does not use it.
#[test]
fn every_effective_parameter_that_is_no_default_in_the_order_of_the_table() {
    let list = indirect(
        "ipc.enable TRUE\nipc.stage[0].osc_damping 0.8\nipc.stage[2].mode DIRECT\nipc.stage[2].filter.type ALLPASS\n\
         ipc.stage[2].filter.order 77\nipc.stage[2].filter.fg_f0 1e-1\nipc.stage[2].filter.q_factor 2.50\n\
         ipc.stage[2].filter[1].type BANDPASS\nipc.stage[2].filter[1].prototype BESSEL\nipc.stage[2].filter[1].order 2\n\
         ipc.stage[2].filter[1].fg_f0 200\nipc.stage[2].filter[1].q_factor 10",
    );
    let expected = "cycle_time 1ms
ipc.enable ON
ipc.v_add_max_fact 1000
ipc.stage[0].mode INDIRECT
ipc.stage[2].mode DIRECT
ipc.stage[0].osc_damping 0.8
ipc.stage[2].filter[0].type ALLPASS
ipc.stage[2].filter[1].type BANDPASS
ipc.stage[2].filter[1].prototype BESSEL
ipc.stage[0].filter[0].order 1
ipc.stage[2].filter[1].order 2
ipc.stage[0].filter[0].fg_f0 11
ipc.stage[2].filter[0].fg_f0 0.1
ipc.stage[2].filter[1].fg_f0 200
ipc.stage[0].filter[0].q_factor 2
ipc.stage[2].filter[0].q_factor 2.5
ipc.stage[2].filter[1].q_factor 10
";
    assert_eq!(canonical(&list).replace(IPC, "ipc."), expected);
}

#[test]
fn spelling_order_and_unused_values_change_nothing() {
    let plain = canonical(&indirect("ipc.enable ON\nipc.stage[0].osc_damping 0.5"));
    for same in [
        "# a comment\nipc.enable ON\nipc.stage[0].osc_damping 0.5",
        "ipc.stage[].osc_damping 5e-1\nipc.enable true",
        "ipc.enable 1\nipc.stage[0].filter.damping 0.50",
        "ipc.enable on\nipc.stage[0]osc_damping .5",
        "ipc.enable ON\nipc.stage[0].osc_damping 0.5\nipc.v_add_max_fact 0x3E8\nkenngr.swe_pos 1\nkopf.achs_nr 9",
        "ipc.enable ON\nipc.stage[0].osc_damping 0.5\nipc.stage[0].filter[0].order 1\nipc.stage[1].weight_fact_num 0",
        "ipc.enable ON\nipc.stage[0].osc_damping 0.5\nipc.stage[0].weight_fact_num 1\ngetriebe[].dynamik.vb_max 200000",
    ] {
        // A stage that is given twice would be an error.
        let list = indirect(same);
        let list =
            if same.contains("filter[0].order") { list.replace("\nipc.stage[0].filter.order 1", "") } else { list };
        assert_eq!(canonical(&list), plain, "{same}");
    }
}

#[test]
fn every_used_value_changes_it() {
    let plain = canonical(&direct(""));
    for other in [
        "ipc.enable ON",
        "ipc.v_add_max_fact 999",
        "ipc.stage[0].weight_fact_num 2",
        "ipc.stage[0].weight_fact_denom 2",
        "ipc.stage[0].filter.order 2",
        "ipc.stage[0].filter.prototype BESSEL",
        "ipc.stage[0].filter.fg_f0 53.000000000000007",
        "ipc.stage[0].filter.q_factor 9.999999999999998",
        "getriebe[0].dynamik.vb_max 200001",
    ] {
        assert_ne!(canonical(&direct(other)), plain, "{other}");
    }
}

#[test]
fn moving_an_axis_or_writing_it_as_toml_changes_nothing() {
    let list = direct("").replace("ipc.", IPC);
    let table = format!(
        "{IPC}v_add_max_fact = 0x3e8\n{IPC}stage = [{{ mode = 1, filter = {{ order = 1, fg_f0 = 53, q_factor = 10.0 }} }}]"
    );
    let forms = [
        "cycle_time = \"1000us\"\n[axis.X]\nlist = \"x.lis\"\n[axis.Y]\n".to_owned(),
        "cycle_time = \"1ms\"\n[axis.Y]\n[axis.X]\nlist = \"x.lis\"\nfade = \"0.1s\"\nreal = \"lreal\"\n".to_owned(),
        format!("cycle_time = \"1 ms\"\n[axis.X] # the same\n{table}\n"),
    ];
    for form in &forms {
        let files = [("set.toml", form.as_bytes()), ("x.lis", list.as_bytes())];
        let (set, report) = read("set.toml", &files, &ListOptions::default());
        let set = set.unwrap_or_else(|| panic!("{report}"));
        let axis = &set.axes.iter().find(|of| of.axis.name == "X").unwrap().axis;
        assert_eq!(axis.canonical, canonical(&direct("")), "{form}");
    }
}

#[test]
fn durations() {
    for (text, canonical) in
        [("101ms", "101ms"), ("0.25s", "250ms"), ("1500ms", "1.5s"), ("1us", "1us"), ("999ns", "999ns"), ("0s", "0s")]
    {
        let (set, _) = read_set(format!("cycle_time = \"1ms\"\n[axis.X]\nfade = \"{text}\""));
        assert!(set.unwrap().axes[0].axis.canonical.contains(&format!("\nfade {canonical}\n")), "{text}");
    }
}

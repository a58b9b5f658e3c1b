//! Commissioning pages: which axes have one, and what a page says of an axis that is not the shipped example. Whether
//! its steps lead anywhere is tested on a simulated machine, in the crate tests.

use crate::set_of;
use generator::digest::has_right_checksum;
use generator::generate::pages;
use generator::set_change::judge;
use generator::target::of_names;

/// The pages of a set for two targets, each with its name.
fn of_set(set: &str) -> Vec<(String, String)> {
    let read = set_of(set);
    let targets = of_names(|name| ["c", "st"].contains(&name));
    let pages = pages(&read, &[], &targets, |made| (made.file.name, made.file.text));
    for (name, page) in &pages {
        assert_eq!(has_right_checksum(page), Some(true), "{name}");
        assert!(page.is_ascii() && page.ends_with('\n') && !page.contains("\n\n\n"), "{name}: {page}");
        assert!(page.lines().all(|line| line == line.trim_end()), "{name}: {page}");
    }
    pages
}

/// A set of one axis: its keys, its improved position control.
fn page(keys: &str, ipc: &str) -> String {
    let set = format!(
        "cycle_time = \"500us\"\n[axis.X]\ngetriebe = [{{ dynamik.vb_max = 250000 }}]\n{keys}\n\
         [axis.X.lr_param.improved_position_control]\n{ipc}\n"
    );
    let Ok([(_, page)]) = <[_; 1]>::try_from(of_set(&set)) else { panic!("one page") };
    page
}

fn assert_says(page: &str, texts: &[&str]) {
    texts.iter().for_each(|text| assert!(page.contains(text), "`{text}` is not in\n{page}"));
}

const STAGE: &str = "mode = \"DIRECT\", filter = [{ order = 1, fg_f0 = 40.0, q_factor = 4.0 }]";

#[test]
fn a_page_belongs_to_an_axis_that_acts_itself() {
    let axis = |keys: &str, stage: &str| {
        format!(
            "[axis.{keys}\ngetriebe = [{{ dynamik.vb_max = 250000 }}]\n\
             lr_param.improved_position_control = {{ v_add_max_fact = 100{stage} }}\n"
        )
    };
    let (stage, slave) = (format!(", stage = [{{ {STAGE} }}]"), "S]\nkopf.achs_nr = 2\nkenngr.gantry_ax_nr = 1");
    let axes = axis("M]\nkopf.achs_nr = 1", &(", enable = \"ON\"".to_owned() + &stage)) + &axis(slave, &stage);
    let pages = of_set(&format!("cycle_time = \"1ms\"\n{axes}{}", axis("N]\nkopf.achs_nr = 3", "")));
    let [(master, page), (other, _)] = &pages[..] else { panic!("not the gantry slave") };
    assert_eq!([master, other], ["axis_m_commissioning.md", "axis_n_commissioning.md"]);
    assert_says(
        page,
        &["each slave (`S`) too, each after its own check. Unconnected,", "`v_add` of each slave (`S`) is"],
    );
}

/// Without a stage the page leads to the first ones; without the block `excitation` to that block.
#[test]
fn the_page_of_an_axis_without_a_stage() {
    assert_says(
        &page("excitation = { amplitude = 3000, bits = 10, clock = 8, periods = 5 }", ""),
        &[
            "It must be 500000 ns.",
            "| largest `v_excite` | 3000 um/s |",
            "| steps of the velocity command | 6000 um/s |",
            "| band of the excitation | up to 125 Hz |",
            // (M + 1) N T = 6 * 1023 * 8 * 0.5 ms, and the fade; at 2.5 A.
            "| duration | 24.7 s |",
            "at least 7500 um/s, in one direction, over at least 184.9 mm.",
            "`error_id` has the number of what is not a fault.",
            "axgen measure moves.csv --excited excited.csv --excitation 10x8 --response response.csv",
            "drive.response = \"response.csv\"",
            "axgen tune SET --axis X --recording moves.csv --excited excited.csv --excitation 10x8 --apply recommended",
        ],
    );
    let page = page("", "");
    assert_says(
        &page,
        &["excitation = { periods = 8 }", "axgen tune SET --axis X --recording moves.csv --apply first"],
    );
    assert!(!page.contains("hold_to_run"), "{page}");
}

#[test]
fn numbers_are_those_of_the_axis() {
    let page = page(
        "tunable = \"weights\"\nfade = \"250ms\"",
        &format!("v_add_max_fact = 7\nstage = [{{}}, {{}}, {{ {STAGE} }}]"),
    );
    assert_says(
        &page,
        &[
            "It must be 500000 ns.",
            "add `--cycle-time 500us` to each command",
            "`tuning_weight2` is the input for stage 2. In a recording for `axgen run` its column is `tuning_weight[2]`.",
            "Drive at a constant velocity for at least 1.5 s. Let the axis rest for 1.2 s",
            "**2.3** Stage 2. In the report, look at the lines of `v_motor`.",
            "**4.4** Stage 2, 40 Hz.",
            "The weight follows within 250 ms.",
            "| 0.1 | 175 | 1 |",
            "| 1 | 1750 | 7 |",
            // 1/1 has no tenth with the same denominator.
            "| 4.4.1 | 0.1 | 0.1 | 1 | 10 | 91 % |",
            "| 4.4.6 | 1 | 1 | 1 | 1 | 50 % |",
        ],
    );
    assert!(!page.contains("trial"), "{page}");
}

#[test]
fn limits_and_weights_are_whole_parameters_in_their_ranges() {
    for (ipc, says) in [
        // 10 % and more of 7: the next whole number.
        (
            "v_add_max_fact = 7",
            "| limit [um/s] | `v_add_max_fact` |\n| --- | --- |\n| 250 | 1 |\n| 500 | 2 |\n| 750 | 3 |\n| 1250 | 5 |\n",
        ),
        ("", "**3.3** The limit of this axis is 0, because `lr_param.improved_position_control.v_add_max_fact` is 0."),
        // A capped weight is stepped from what acts.
        (", weight_fact_num = 900, weight_fact_denom = 100", "| 4.4.1 | 0.7 | 7 | 10 |"),
        (", weight_fact_num = 900, weight_fact_denom = 100", "| 4.4.6 | 7 | 7 | 1 |"),
        (", weight_fact_num = 4294967291, weight_fact_denom = 4294967294", "| 4.4.1 | 0.1 | 100000 | 1000000 |"),
        (", weight_fact_num = 4294967291, weight_fact_denom = 4294967294", "| 4.4.6 | 1 | 4294967291 | 4294967294 |"),
    ] {
        let (limit, weight) = if ipc.starts_with(',') { ("v_add_max_fact = 10", ipc) } else { (ipc, "") };
        assert_says(&page("", &format!("{limit}\nstage = [{{ {STAGE}{weight} }}]")), &[says]);
    }
}

#[test]
fn a_filter_of_the_command_is_seen_at_the_load() {
    let stage = "mode = \"SET_POINT\", osc_damping = 0.8, weight_fact_num = 72, weight_fact_denom = 100, \
                 filter = [{ order = 1, fg_f0 = 20.0, q_factor = 2.0 }]";
    let page = page("kenngr.achs_typ = \"ACHSTYP_ROTATOR\"", &format!("v_add_max_fact = 10\nstage = [{{ {stage} }}]"));
    assert_says(
        &page,
        &[
            "| 0 | SET_POINT | `v_command` | 20 Hz |",
            "| `v_command` | the position controller with feedforward, before `v_add` is added | 0.001 deg/s |",
            "look at the lines of `a_load`",
            // abs(1 + w H) with H = -(1 - j / (2 D)).
            "| 4.4.6 | 0.72 | 72 | 100 | 53 % |",
        ],
    );
}

#[test]
fn a_block_that_holds_the_others_is_the_one_to_call() {
    let keys = "vorsteuer.vorsteuerung = \"VEL\"\nkenngr.antr_typ = 4";
    let page = page(keys, &format!("v_add_max_fact = 10\nstage = [{{ {STAGE} }}]"));
    assert_says(
        &page,
        &[
            "The block `axis_x_axis` contains the block `axis_x_ipc`. Call `axis_x_axis` only.",
            "do not add `v_add` once more",
            "`manipulated_variable` must have the sign of\nthe velocity command that the drive receives, and be within 2 %",
            "to the drive only with `x_command` equal to `x_actual` and `feedforward_active` FALSE.\nThere is no ramp",
            "`axis_x_axis_self_test`",
            "axgen run trial/SET --axis X --block axis --engine st --compare recorded.csv",
        ],
    );
}

/// With parameter sets each row of a weight, written to the copy of the set as the page says, is a set that the block takes over.
#[test]
fn each_row_of_a_page_is_a_parameter_set_for_its_block() {
    let other = "mode = \"INDIRECT\", osc_damping = 0.3, filter = [{ order = 2, fg_f0 = 60.0, q_factor = 3.0 }]";
    let of_weights = |weights: [[&str; 2]; 2], fact: &str| {
        let [first, second] =
            weights.map(|[num, denom]| format!("weight_fact_num = {num}, weight_fact_denom = {denom}"));
        format!(
            "cycle_time = \"500us\"\n[axis.X]\ntunable = \"all\"\ngetriebe = [{{ dynamik.vb_max = 250000 }}]\n\
             [axis.X.lr_param.improved_position_control]\nenable = \"OFF\"\nv_add_max_fact = {fact}\n\
             stage = [{{ {STAGE}, {first} }}, {{ {other}, {second} }}]\n"
        )
    };
    let designed = |set: &str| set_of(set).axes.remove(0);
    let old = of_weights([["3", "1"], ["5", "2"]], "100");
    let (_, page) = of_set(&old).remove(0);
    let path = "lr_param.improved_position_control.stage[1]";
    let nothing = format!("1 to `{path}.weight_fact_num` and 1000000 to `{path}.weight_fact_denom`");
    assert_says(&page, &["axgen params-of trial/SET --axis X --on SET", &nothing, "`error_id` is 6, 7 or 8"]);
    let row = |line: &str, number: &str| -> Option<Vec<String>> {
        line.starts_with(number).then(|| line.split('|').map(|cell| cell.trim().to_owned()).collect())
    };
    let rows = |number: &str| -> Vec<Vec<String>> { page.lines().filter_map(|line| row(line, number)).collect() };
    let (first, second) = (rows("| 4.4."), rows("| 4.5."));
    assert!(first.len() > 3 && second.len() > 3, "{page}");
    let last = first.last().expect("there are some");
    // Row, weight, numerator, denominator, what is left.
    let of_first = first.iter().map(|row| [[row[3].as_str(), &row[4]], ["1", "1000000"]]);
    let of_second = second.iter().map(|row| [[last[3].as_str(), &last[4]], [row[3].as_str(), &row[4]]]);
    for weights in of_first.chain(of_second) {
        let judgement = judge(&designed(&old), &designed(&of_weights(weights, "40")));
        assert!(judgement.reasons().is_empty(), "{weights:?}: {:?}", judgement.reasons());
    }
}

/// The manual changes parameters at standstill: what `tunable` gives to the caller need not wait for it, and the page says why.
#[test]
fn what_may_change_while_the_axis_moves() {
    let ipc = format!("enable = \"DRYRUN\"\nv_add_max_fact = 100\nstage = [{{ {STAGE} }}]");
    let manual = "The manual of the controller changes parameters at standstill only.";
    let of = |word: &str| page(&format!("tunable = \"{word}\"\nfade = \"50ms\""), &ipc);
    let acts = "each change acts over 50 ms, and\n  no number makes a weight or the limit larger than designed. Load a new block at standstill.";
    assert_says(&of("weights"), &[manual, acts]);
    let fades = "the block fades `v_add` out before it takes\n  the set, fades it in again in 50 ms, and takes no limit above its own.";
    assert_says(&of("all"), &[manual, fades]);
    assert!(!page("", &ipc).contains(manual));
}

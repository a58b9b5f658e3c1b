//! What depends on each parameter: its coefficients, and the words of the semantic diff.

use crate::{from_disk, options_of, shipped};
use generator::config::{ListOptions, load};
use generator::diff::lines;
use generator::trace::{Traced, parameters};
use std::path::Path;

/// No change of a coefficient is without words: of each shipped axis, with each other value of each parameter.
#[test]
fn the_diff_has_words_for_every_parameter() {
    let (mut versions, mut hidden) = (0, Vec::new());
    for file in shipped(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..")) {
        let set = from_disk(&file);
        for of in &set.axes {
            let traced =
                parameters(&file, &options_of(&file), &load, &of.axis.name).unwrap_or_else(|report| panic!("{report}"));
            for (Traced { path, coefficients, .. }, version) in
                traced.iter().flat_map(|traced| traced.versions.iter().map(move |version| (traced, version)))
            {
                let (lines, _) = lines(std::slice::from_ref(of), std::slice::from_ref(version));
                // The path resolution has the increments in both its terms: they cancel out.
                let is_same = path == "getriebe[0].incr_per_rev";
                let is_hidden =
                    |line: &String| line.contains(": coefficient ") || line.contains("their rounding") && !is_same;
                hidden.extend(lines.iter().any(is_hidden).then(|| format!("{} {path}: {lines:?}", file.display())));
                versions += usize::from(!coefficients.is_empty());
            }
        }
    }
    assert!(hidden.is_empty(), "{}", hidden.join("\n"));
    assert!(versions > 1000, "{versions}");
}

/// The parameters of the only axis of a set.
fn traced(set: &str) -> Vec<Traced> {
    let text = format!("cycle_time = '1ms'\n[axis.X]\n{set}");
    let load = |_: &Path| Ok(text.as_bytes().to_vec());
    parameters(Path::new("set.toml"), &ListOptions::default(), &load, "X").unwrap_or_else(|report| panic!("{report}"))
}

fn of_id<'t>(traced: &'t [Traced], id: &str) -> &'t Traced {
    traced.iter().find(|of| of.id == Some(id)).unwrap_or_else(|| panic!("{id}"))
}

/// A delay that the controller would correct, and a denominator of 0, are replaced like every other value.
#[test]
fn corrected_values_have_dependents() {
    let set = "kenngr.antr_typ = 'SERCOS'\ngetriebe = [{ kv = 2000, incr_per_rev = 1048576, load = 0.48 }]\n\
        antr = { feed_const_num = 50000, torque_scale_num = 500, acc_reference_value = 0.45 }\n\
        process_data = { additive_velocity = 'INT32', additive_torque = 'INT16' }\n\
        vorsteuer.vorsteuerung = 'ADD_VEL ADD_ACC'\n";
    for (more, ids) in [
        (
            "vorsteuer.velocity_delay_time = 150\nvorsteuer.acceleration_delay_time = 150",
            &["P-AXIS-00389", "P-AXIS-00390"][..],
        ),
        ("vorsteuer.vs_v_nenner = 0", &["P-AXIS-00229"]),
    ] {
        let traced = traced(&format!("{set}{more}"));
        for of in ids.iter().map(|id| of_id(&traced, id)) {
            assert!(!of.coefficients.is_empty() && of.given.is_some(), "{of:?}");
        }
    }
}

/// A value from the predecessor of a parameter has the place of the predecessor.
#[test]
fn a_predecessor_is_the_place_of_its_successors_value() {
    let traced = traced(
        "antr.velocity_position_control_on = 1200000\nantr.velocity_position_control_off = 300000\n\
         antr.sai_op_mode_change.feed_forward_v_weighting = 500\nkenngr.achs_typ = 'ACHSTYP_SPINDEL'\n\
         kenngr.antr_typ = 'SERCOS'\ngetriebe = [{ kv = 2000, dynamik.vb_max = 18000000 }]\n\
         antr.nbr_delay_cycles = 4\nantr.sercos.op_mode_for_velocity_control = 1\n",
    );
    for (id, line) in [("P-AXIS-00767", 3), ("P-AXIS-00768", 4), ("P-AXIS-00833", 5)] {
        let of = of_id(&traced, id);
        assert!(of.given.as_ref().is_some_and(|place| place.line == line) && !of.coefficients.is_empty(), "{of:?}");
    }
}

//! The largest calm weights of random stages, also of sharp and of two equal band-passes: Ms is 2 with each of them, and
//! larger with more. Ms is that of the product, which `eigenvalues` compares with a fine grid.

use crate::random::{axis, between, read};
use axgen_tests::environment::by_depth;
use generator::analysis::analyze;
use generator::axis::DriveModel;
use generator::blocks::Designed;
use inside::rng::Rng;

/// Cycle times [us].
const CYCLES: [&str; 5] = ["125", "500", "1000", "2000", "4000"];
/// Largest Ms of a calm loop, and how precise the search for it is.
const MS: f64 = 2.0;
const PRECISE: f64 = 1e-3;

/// A stage with one band-pass, or with two with almost the same frequency.
fn stage(rng: &mut Rng, cycle: f64) -> String {
    let f0 = between(rng, 3.0, (0.35 / cycle).min(200.0));
    let first = (f0, between(rng, 1.0, 10.0), rng.between(1, 3));
    let second = rng.chance(25).then(|| (f0 * between(rng, 0.8, 1.25), 3.0, 1));
    let filters: Vec<String> = [Some(first), second].into_iter().flatten().map(bandpass).collect();
    let mode = if rng.chance(50) {
        "mode = \"DIRECT\"".to_owned()
    } else {
        format!("mode = \"INDIRECT\", osc_damping = {:.3}", between(rng, 0.05, 0.95))
    };
    format!("{{ {mode}, weight_fact_num = 10, weight_fact_denom = 100, filter = [{}] }}", filters.join(", "))
}

fn bandpass((f0, q_factor, order): (f64, f64, usize)) -> String {
    format!(
        "{{ type = \"BANDPASS\", prototype = \"BUTTERWORTH\", order = {order}, fg_f0 = {f0:.3}, q_factor = {q_factor:.3} }}"
    )
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a weight is from 0 to 7")]
/// Ms with this weight of the first stage; infinite if the loop is unstable.
fn ms(designed: &Designed, model: &DriveModel, weight: f64) -> f64 {
    let mut axis = designed.axis.clone();
    let stage = axis.ipc.stage.iter_mut().flatten().next().expect("a stage");
    // Two numbers whose ratio is the weight: the set has whole numbers.
    (stage.weight_fact_num, stage.weight_fact_denom) = ((weight * 1e8) as u32, 100_000_000);
    analyze(&Designed::from(axis), model).drives[0].margins.ms.map_or(f64::INFINITY, |[ms, _]| ms)
}

#[test]
fn ms_exceeds_2_above_the_largest_calm_weight_and_not_below() {
    let count = by_depth(1200, 2000, 20_000);
    let mut rng = Rng::new(0xca13);
    let (mut bounded, mut none) = (0, 0);
    for _ in 0..count {
        let cycle = rng.pick(&CYCLES);
        let stages = [stage(&mut rng, cycle.parse::<f64>().expect("a number") * 1e-6)];
        let keys = rng.pick(&["", ", kv = 500", ", kv = 2000", ", kv = 6000"]);
        let set = format!("cycle_time = \"{cycle}us\"\n{}", axis("X", keys, "DRYRUN", &stages));
        let (axes, report) = read(&set);
        let designed = axes.unwrap_or_else(|| panic!("{report}\n{set}")).remove(0);
        let delay_cycles = Some([1.0, 1.5, 2.0, 3.0][rng.below(4)]);
        let time_constant = rng.chance(50).then_some(3e-3);
        let model = DriveModel { delay_cycles, time_constant, ..designed.axis.drive.clone() };
        let calm = analyze(&designed, &model).drives[0].stages[0].largest_weight;
        if calm == 0.0 {
            none += 1;
            assert!(ms(&designed, &model, 0.0) > MS * (1.0 - PRECISE), "{set}{model:?}");
            continue;
        }
        for part in [0.25, 0.5, 0.75, 1.0] {
            let ms = ms(&designed, &model, calm * part);
            assert!(ms <= MS * (1.0 + PRECISE), "Ms {ms} at {part} of {calm}: {set}{model:?}");
        }
        if calm < 7.0 {
            bounded += 1;
            let above = calm * (1.0 + 10.0 * PRECISE);
            assert!(above > 7.0 || ms(&designed, &model, above) > MS, "{calm}: {set}{model:?}");
        }
    }
    println!("{count} stages, {bounded} weights end below 7, {none} at 0");
    assert!(bounded > count / 3 && bounded < count);
}

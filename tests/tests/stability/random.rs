//! Random stages and drives, as sets.

use generator::blocks::Designed;
use generator::config::ListOptions;
use generator::diagnostics::Report;
use generator::pipeline::read_with;
use inside::rng::Rng;
use std::fmt::Write;
use std::path::Path;

/// A number between two, evenly on a logarithmic axis.
pub fn between(rng: &mut Rng, from: f64, to: f64) -> f64 {
    let part = rng.below(1_000_001) as f64 / 1e6;
    from * libm::pow(to / from, part)
}

/// A stage that looks at the motor: of the size that machines have.
pub fn stage(rng: &mut Rng, highest: f64) -> String {
    let f0 = between(rng, 5.0, highest);
    let order = rng.between(1, 3);
    let prototype = rng.pick(&["CRIT_DAMPING", "BUTTERWORTH", "BESSEL"]);
    let q_factor = between(rng, 1.0, 10.0);
    let mut filters = format!(
        "{{ type = \"BANDPASS\", prototype = \"{prototype}\", order = {order}, fg_f0 = {f0:.3}, q_factor = {q_factor:.3} }}"
    );
    if rng.chance(15) {
        let [f0, q_factor] = [f0 * between(rng, 0.4, 2.5), between(rng, 1.0, 5.0)];
        let _ = write!(filters, ", {{ type = \"ALLPASS\", fg_f0 = {:.3}, q_factor = {q_factor:.3} }}", f0.min(highest));
    }
    let mode = if rng.chance(50) {
        "mode = \"DIRECT\"".to_owned()
    } else {
        format!("mode = \"INDIRECT\", osc_damping = {:.3}", between(rng, 0.1, 0.95))
    };
    let weight = between(rng, 30.0, 700.0).round();
    format!("{{ {mode}, weight_fact_num = {weight}, weight_fact_denom = 100, filter = [{filters}] }}")
}

/// An axis of a set with these keys and stages.
pub fn axis(name: &str, keys: &str, enable: &str, stages: &[String]) -> String {
    format!(
        "[axis.{name}]\ngetriebe = [{{ dynamik.vb_max = 1000000{keys} }}]\n[axis.{name}.lr_param.improved_position_control]\n\
         enable = \"{enable}\"\nv_add_max_fact = 999\nstage = [\n{}\n]\n",
        stages.join(",\n")
    )
}

/// The axes of a set, or what is wrong with it.
pub fn read(set: &str) -> (Option<Vec<Designed>>, Report) {
    let load = |_: &Path| Ok(set.as_bytes().to_vec());
    let (read, report) = read_with(Path::new("set.toml"), &ListOptions::default(), &load);
    (read.map(|set| set.axes), report)
}

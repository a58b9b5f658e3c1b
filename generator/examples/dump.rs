use generator::axis::*;
fn main() {
    let bp = |order, f0, q| Filter::Bandpass { prototype: Prototype::Butterworth, order, f0, q_factor: q };
    let full = std::env::args().nth(1).as_deref() == Some("full");
    let stage = if full { [
        Some(Stage { mode: Mode::Direct { source: DirectSource::Motor }, weight_fact_num: 3, weight_fact_denom: 1, filter: [bp(3, 53.0, 10.0), Filter::Allpass { f0: 55.0, q_factor: 2.0 }] }),
        Some(Stage { mode: Mode::Indirect { osc_damping: 0.8 }, weight_fact_num: 190, weight_fact_denom: 100, filter: [Filter::Allpass { f0: 12.0, q_factor: 2.0 }, bp(3, 11.0, 2.0)] }),
        Some(Stage { mode: Mode::SetPoint { osc_damping: 0.8 }, weight_fact_num: 1, weight_fact_denom: 2, filter: [bp(3, 90.0, 5.0), Filter::Allpass { f0: 95.0, q_factor: 3.0 }] }),
    ] } else { [
        Some(Stage { mode: Mode::Direct { source: DirectSource::Motor }, weight_fact_num: 300, weight_fact_denom: 100, filter: [bp(1, 53.0, 10.0), Filter::NoFilter] }),
        Some(Stage { mode: Mode::Indirect { osc_damping: 0.8 }, weight_fact_num: 190, weight_fact_denom: 100, filter: [bp(1, 11.0, 2.0), Filter::NoFilter] }),
        None] };
    let axis = Axis { name: if full {"full".into()} else {"rack_and_pinion".into()}, real: portable::RealKind::F64, cycle_time_ns: 1_000_000, canonical: String::new(),
        ipc: Ipc { enable: Enable::On, v_add_max_fact: 1000, v_max: 530000.0, fade: 0.1, stage } };
    let blocks = generator::block::blocks(&axis).unwrap();
    let dir = std::env::args().nth(2).unwrap();
    for f in generator::target::c::files(&axis, &blocks) { std::fs::write(format!("{dir}/{}", f.name), f.text).unwrap(); }
}

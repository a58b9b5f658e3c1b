//! proof
use generator::config::{ListOptions, Unreadable};
use generator::pipeline;
use std::path::Path;
#[cfg(target_family = "wasm")]
use wasm_bindgen::prelude::wasm_bindgen;

/// check
#[cfg_attr(target_family = "wasm", wasm_bindgen)]
pub fn check(name: &str, bytes: &[u8], cycle: &str) -> String {
    let options = ListOptions { cycle_time: Some(cycle.to_owned()), ..ListOptions::default() };
    let load = |path: &Path| {
        if path == Path::new(name) { Ok(bytes.to_vec()) } else { Err(Unreadable::System("no file".into())) }
    };
    let (set, report) = pipeline::read_with(Path::new(name), &options, &load);
    let mut text = String::new();
    for d in &report.diagnostics { text += &format!("{d}\n"); }
    if let Some(set) = set {
        for d in &set.axes {
            text += &generator::summary::details(d);
            for b in generator::blocks::blocks(d).unwrap() {
                let inputs = golden::exercise::inputs(d, &b, 1000);
                for e in golden::engine::ENGINES {
                    if matches!(e, golden::engine::Engine::C | golden::engine::Engine::Rust) { continue; }
                    text += &format!("{e} {:?}\n", golden::engine::run(e, d, &b, &inputs).map(|s| s.len()));
                }
            }
        }
    }
    text
}

//! Compiles the emitted C. It fails where the files are not those of the parameters.

use std::env;
use std::process::Command;

fn main() {
    for path in ["axes.toml", "lists", "generated"] {
        println!("cargo::rerun-if-changed={path}");
    }
    run("axgen", &["generate", "axes.toml", "--out", "generated", "--check"]);
    let out = env::var("OUT_DIR").expect("cargo names the folder");
    let library = format!("{out}/libaxis_x.a");
    // A compiler that contracts a * b + c computes other bits; the self-test would find it.
    for name in ["axis_x_ipc", "axis_x_ipc_self_test"] {
        let (source, object) = (format!("generated/{name}.c"), format!("{out}/{name}.o"));
        run("cc", &["-std=c99", "-O2", "-ffp-contract=off", "-c", &source, "-o", &object]);
        run("ar", &["rcs", &library, &object]);
    }
    println!("cargo::rustc-link-search=native={out}");
    println!("cargo::rustc-link-lib=static=axis_x");
}

fn run(program: &str, arguments: &[&str]) {
    let status = Command::new(program).args(arguments).status();
    let status = status.unwrap_or_else(|error| panic!("{program} does not start: {error}"));
    assert!(status.success(), "{program} {}: {status}", arguments.join(" "));
}

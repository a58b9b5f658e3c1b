//! Emitted C in a loop with the ideal drive: the blocks of some axes in one program, which prints how much each loop grows.

use generator::blocks::Designed;
use generator::generate::axis_files;
use generator::target::TARGETS;
use std::fmt::Write;
use std::process::Command;

/// The loop: noise for 2 s, then 6 s without a command; the last second against the first one of them, rms. The motor does what was commanded
/// one cycle before. Infinite where the last second is as large as the limit makes it.
const LOOP: &str = r#"
#include <math.h>
#include <stdio.h>
static uint32_t seed = 1u;
static double noise(void)
{
    seed ^= seed << 13;
    seed ^= seed >> 17;
    seed ^= seed << 5;
    return (double)(seed % 2001u) - 1000.0;
}
static double growth(double first, double last)
{
    return last > 1000.0 * 300000.0 * 300000.0 ? HUGE_VAL : sqrt(last / first);
}
#define GROWTH(B) { \
    B##_state state; B##_inputs in; B##_outputs out; \
    double v_motor = 0.0; double first = 0.0; double last = 0.0; int n; \
    B##_init(&state); B##_inputs_init(&in); in.mode = 1; \
    for (n = 0; n < 8000; n++) { \
        double v_command = n < 2000 ? noise() : 0.0; \
        in.v_motor = v_motor; \
        B##_step(&state, &in, &out); \
        v_motor = v_command + out.v_add; \
        if (n >= 2000 && n < 3000) { first += v_motor * v_motor; } \
        if (n >= 7000) { last += v_motor * v_motor; } \
    } \
    printf("%.17g\n", growth(first, last)); \
}
"#;

/// How much the loop of each axis grows, by the block `ipc` that is emitted for it; the names of the axes differ.
pub fn growths(axes: &[Designed]) -> Vec<f64> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (mut included, mut calls) = (String::new(), String::new());
    for axis in axes {
        for file in axis_files(axis, &TARGETS[..1]).expect("the target prints the block") {
            std::fs::write(folder.path().join(&file.name), &file.text).expect("room in it");
            if let Some(stem) = file.name.strip_suffix("_ipc.c") {
                let _ = writeln!(included, "#include \"{}\"", file.name);
                let _ = writeln!(calls, "    GROWTH({stem}_ipc)");
            }
        }
    }
    let text = format!("{included}{LOOP}int main(void)\n{{\n{calls}    return 0;\n}}\n");
    std::fs::write(folder.path().join("loops.c"), text).expect("room in it");
    let said = Command::new("cc")
        .args(["-std=c99", "-O1", "loops.c", "-o", "loops", "-lm"])
        .current_dir(folder.path())
        .output()
        .expect("the compiler `cc` starts");
    assert!(said.status.success(), "{}", String::from_utf8_lossy(&said.stderr));
    let output = Command::new(folder.path().join("loops")).output().expect("the program starts");
    let text = String::from_utf8(output.stdout).expect("it prints numbers");
    let growths: Vec<f64> = text.lines().map(|line| line.parse().expect("it prints numbers")).collect();
    assert_eq!(growths.len(), axes.len());
    growths
}

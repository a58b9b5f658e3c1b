//! Other processors in an emulator: how a program of emitted blocks and their runners is built for one, and run. No test.

use axgen_tests::environment::has;
use generator::blocks::{self, Block, Designed};
use generator::generate::identity;
use generator::target::{File, TARGETS};
use std::borrow::Borrow;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// A processor.
pub struct Board {
    pub name: &'static str,
    compiler: &'static str,
    /// what makes a compiler build for it, as fast as its user may want it
    pub options: &'static [&'static str],
    /// the machine of `qemu-system-arm`; none: a program of Linux
    machine: Option<&'static str>,
    /// whether it can replace subnormal numbers by 0
    pub flushes: bool,
}

const ARM: &str = "arm-none-eabi-gcc";

/// Without a floating-point unit, with one for single precision, with one for both, and of 64 bits. Where a unit
/// multiplies and adds in one operation, the compiler is asked to use that.
pub const BOARDS: [Board; 5] = [
    Board {
        name: "Cortex-M0+",
        compiler: ARM,
        options: &["-mthumb", "-mcpu=cortex-m0plus", "-Os"],
        machine: Some("microbit"),
        flushes: false,
    },
    Board {
        name: "Cortex-M3",
        compiler: ARM,
        options: &["-mthumb", "-mcpu=cortex-m3", "-O2"],
        machine: Some("mps2-an385"),
        flushes: false,
    },
    Board {
        name: "Cortex-M4F",
        compiler: ARM,
        options: &["-mthumb", "-mcpu=cortex-m4", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard", "-O2", "-ffp-contract=fast"],
        machine: Some("mps2-an386"),
        flushes: true,
    },
    Board {
        name: "Cortex-M7",
        compiler: ARM,
        options: &["-mthumb", "-mcpu=cortex-m7", "-mfpu=fpv5-d16", "-mfloat-abi=hard", "-O3", "-ffp-contract=fast"],
        machine: Some("mps2-an500"),
        flushes: true,
    },
    Board {
        name: "AArch64",
        compiler: "aarch64-linux-gnu-gcc",
        options: &["-O3", "-ffp-contract=fast"],
        machine: None,
        flushes: true,
    },
];

/// The files of a block with its runner, and what their names begin with.
pub struct Emitted {
    pub prefix: String,
    pub files: Vec<File>,
}

impl Emitted {
    /// Makes them, with a runner of N samples.
    pub fn of(designed: &Designed, block: &Block, samples: usize) -> Self {
        let kind = blocks::named(block.program.block).expect("a block of the axis");
        let identity = identity(&designed.axis, block);
        let target = TARGETS[0].with_runners(samples).expect("C has runners");
        let mut files = target.files(&identity, block).expect("C prints every block");
        let prefix = files[0].name.trim_end_matches(".h").to_owned();
        let legal = target.block(block).expect("C says every block");
        let runner = target.runner(&identity, &legal, |samples| kind.runner(designed, block, samples));
        files.push(runner.expect("C has runners"));
        files.extend(golden::engine::headers(designed, block).expect("C prints every block"));
        Self { prefix, files }
    }
}

/// How a program is built next to its board's options.
#[derive(Clone, Copy, Default)]
pub struct Build<'o> {
    pub options: &'o [&'o str],
    /// of the emulator
    pub emulator: &'o [&'o str],
}

impl Board {
    /// Whether its compiler and its emulator are there.
    pub fn is_there(&self) -> bool {
        let gcc = "Free Software Foundation";
        match self.machine {
            Some(_) => has(ARM, gcc, "gcc-arm-none-eabi") && has("qemu-system-arm", "QEMU", "qemu-system-arm"),
            None => {
                let package = "gcc-aarch64-linux-gnu libc6-dev-arm64-cross";
                has(self.compiler, gcc, package) && has("qemu-aarch64", "qemu", "qemu-user")
            }
        }
    }

    /// Runs the runners one after another in one program; gives what they print. 64 KB of flash hold all of it.
    pub fn run(&self, emitted: &[&Emitted], build: Build<'_>) -> String {
        let folder = written(emitted);
        let cross = Path::new(env!("CARGO_MANIFEST_DIR")).join("cross");
        let path = |name: &str| cross.join(name).to_string_lossy().into_owned();
        let mut compile = compile(self.compiler, folder.path(), emitted);
        compile.args(self.options).args(build.options);
        match self.machine {
            Some(_) => {
                let bare = ["-ffreestanding", "-nostdlib", "-static", "-T", &path("cortex_m.ld"), &path("cortex_m.c")];
                compile.args(bare).arg("-lgcc")
            }
            None => compile.args(["-static", &path("linux.c")]),
        };
        finished(&mut compile, self.name);
        match self.machine {
            Some(machine) => said(emulator(machine, folder.path()).args(build.emulator).args(["-kernel", "program"])),
            None => said(limited(folder.path()).args(["qemu-aarch64", "./program"])),
        }
    }
}

/// A program that hangs must not keep a test from ending.
fn limited(folder: &Path) -> Command {
    let mut run = Command::new("timeout");
    run.arg("300").current_dir(folder);
    run
}

/// The emulator of a machine, without the program.
pub fn emulator(machine: &str, folder: &Path) -> Command {
    let mut run = limited(folder);
    run.args(["qemu-system-arm", "-M", machine, "-display", "none", "-monitor", "none", "-serial", "none"])
        .args(["-semihosting-config", "enable=on,target=native"]);
    run
}

/// Runs the runners on this host.
pub fn run_here(emitted: &[&Emitted]) -> String {
    let folder = written(emitted);
    let linux = Path::new(env!("CARGO_MANIFEST_DIR")).join("cross/linux.c");
    let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".to_owned());
    finished(compile(&compiler, folder.path(), emitted).arg("-O1").arg(linux), "the host");
    said(Command::new("./program").current_dir(folder.path()))
}

/// A folder with the object `blocks.o` of these blocks, without their runners.
pub fn object(board: &Board, emitted: &[Emitted], level: &str) -> TempDir {
    let folder = written(emitted);
    let sources = emitted.iter().flat_map(|of| &of.files).map(|file| &file.name);
    let sources = sources.filter(|name| name.ends_with(".c") && !name.ends_with("_runner.c"));
    let mut compile = Command::new(board.compiler);
    compile.current_dir(folder.path()).args(board.options).args([
        level,
        "-std=c99",
        "-nostdlib",
        "-r",
        "-o",
        "blocks.o",
    ]);
    finished(compile.args(sources), board.name);
    folder
}

pub fn written<E: Borrow<Emitted>>(emitted: &[E]) -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for File { name, text } in emitted.iter().flat_map(|of| &of.borrow().files) {
        std::fs::write(folder.path().join(name), text).expect("room in it");
    }
    folder
}

/// The compiler with all emitted sources, to make `program`.
fn compile(compiler: &str, folder: &Path, emitted: &[&Emitted]) -> Command {
    let mut command = Command::new(compiler);
    let runs: Vec<String> = emitted.iter().map(|of| format!("RUN({})", of.prefix)).collect();
    command.current_dir(folder).args(["-std=c99", "-I.", "-o", "program"]).arg(format!("-DRUNS={}", runs.join(" ")));
    let sources = emitted.iter().flat_map(|of| &of.files).map(|file| &file.name).filter(|name| name.ends_with(".c"));
    command.args(sources);
    command
}

/// Runs a program that must succeed.
pub fn finished(command: &mut Command, what: &str) {
    let output = command.output().unwrap_or_else(|error| panic!("{what}: {command:?}: {error}"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && errors.is_empty(), "{what}: {errors}");
}

/// What a program prints, whatever its exit code is.
pub fn said(command: &mut Command) -> String {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned()
}

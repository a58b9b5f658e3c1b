//! What a generated crate does: judges its programs, writes their C, their Rust and their Structured Text, and says what came of each, line by line.

use super::blocks::Blocks;
use super::defect::{self, DEFECTS, Defect};
use super::emit::Unit;
use super::emit_rust::Modules;
use super::gcc;
use super::judge::{attempt, judge};
use super::subject::Instance;
use compiler::legalise::WITH_OUTPUTS;
use compiler::program::Program;
use portable::RealKind;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// The fact that a program was not compared as C, nor as Rust, which reads the same words.
pub const NOT_IN_C: &str = "C: left out, because GCC would compute something else";

/// The programs of a crate: a number and an instance for each.
pub type Shard = fn() -> Vec<(usize, Instance)>;

/// Runs the shards. The command line: the folder for the C, and perhaps the name of a defect to plant.
///
/// # Panics
/// If a file cannot be written.
pub fn main(shards: &[Shard]) {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().expect("worker: a folder for the C"));
    let planted = arguments.next();
    let planted = planted.and_then(|name| DEFECTS.into_iter().find(|(known, _)| *known == name)).map(|(_, it)| it);
    std::panic::set_hook(Box::new(|_| {})); // a panic is one of the answers
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(shard) = shards.get(next.fetch_add(1, Ordering::Relaxed)) {
                    run(shard, planted, &folder);
                }
            });
        }
    });
}

/// Runs a shard. Its units bear the number of its first program.
fn run(shard: &Shard, planted: Option<Defect>, folder: &Path) {
    let instances = shard();
    let first = instances.first().map_or(0, |(number, _)| *number);
    let mut lines = String::new();
    for (real, name) in [(RealKind::F64, "f64"), (RealKind::F32, "f32")] {
        let (mut unit, mut modules, mut blocks) = (Unit::default(), Modules::default(), Blocks::default());
        for (number, instance) in instances.iter().filter(|(_, instance)| instance.real == real) {
            let judgement = judge(instance, planted);
            let (mut facts, mut differences) = (judgement.facts, judgement.differences);
            if let Some(compiled) = &judgement.compiled {
                let program = defect::printed(compiled.program.clone(), planted);
                let mut print = |attempted: Result<(), String>| {
                    differences.extend(attempted.err().map(|message| ("printed".to_owned(), message)));
                };
                print(attempt(|| blocks.add(*number, &program, compiled)));
                if gcc::subtracts_integer_from_zero(&compiled.program) {
                    facts.push(NOT_IN_C);
                } else {
                    let attempted = attempt(|| {
                        let indexed = indexed(program);
                        facts.extend((!indexed.rows.is_empty()).then_some("legalised: an array is read at an index"));
                        unit.add(*number, &indexed, compiled);
                        modules.add(*number, &indexed);
                    });
                    print(attempted);
                }
            }
            for (engine, message) in &differences {
                let message = message.replace(['\n', '\t'], " ");
                lines += &format!("differs\t{number}\t{name}\t{engine}\t{message}\n");
            }
            lines += &format!("facts\t{number}\t{}\n", facts.join("\t"));
        }
        let stem = folder.join(format!("{name}_{first}"));
        let bytes = |words: &[u64]| -> Vec<u8> { words.iter().flat_map(|word| word.to_ne_bytes()).collect() };
        let files = [
            ("c", unit.text().into_bytes()),
            ("rs", modules.text(real).into_bytes()),
            ("words", bytes(&unit.words)),
            ("st", blocks.source.into_bytes()),
            ("signals", blocks.signals.into_bytes()),
            ("answers", bytes(&blocks.words)),
        ];
        for (extension, content) in files {
            fs::write(stem.with_extension(extension), content).expect("worker: the files are written");
        }
    }
    std::io::stdout().lock().write_all(lines.as_bytes()).expect("worker: standard output takes the answers");
}

/// A program whose chains of numbers are arrays, as C and Rust get it.
fn indexed(program: Program) -> Program {
    let (_, pass) = WITH_OUTPUTS.iter().find(|(name, _)| *name == "indexed").expect("worker: the pass for C and Rust");
    pass(program).unwrap_or_else(|defect| panic!("{defect}"))
}

//! Runs an emitted block, the only one of a program or one of many: packed samples from standard input to standard output.
//! `layout.rs` names the block and its signals. Exit code 0: done; 2: the self-test failed, its result is on standard error;
//! 3: a read or a write failed.

use std::io::{BufWriter, ErrorKind, Read, Result, Write, stdin, stdout};
use std::process::ExitCode;

include!("layout.rs");

pub fn main() -> ExitCode {
    let differs = block::self_test();
    if differs != 0 {
        eprintln!("{differs}");
        return ExitCode::from(2);
    }
    if run().is_ok() { ExitCode::SUCCESS } else { ExitCode::from(3) }
}

fn run() -> Result<()> {
    let (mut state, mut inputs, mut outputs) = (block::State::new(), block::Inputs::new(), block::Outputs::new());
    let (mut from, mut to) = (stdin().lock(), BufWriter::new(stdout().lock()));
    let (mut sample, mut answer) = ([0; IN_FRAME], [0; OUT_FRAME]);
    loop {
        match from.read_exact(&mut sample) {
            Err(error) if error.kind() == ErrorKind::UnexpectedEof => return to.flush(),
            read => read?,
        }
        get(&sample, &mut inputs);
        block::step(&mut state, &inputs, &mut outputs);
        put(&outputs, &mut answer);
        to.write_all(&answer)?;
    }
}

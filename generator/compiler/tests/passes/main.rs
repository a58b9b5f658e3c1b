//! Passes on programs that are small enough to be read, in `*.txt`: a program, then what the pass makes of it. The random programs find
//! what these do not think of.

mod decided;
mod read;

use compiler::pass::{Defect, PASSES};
use compiler::program::{Program, Type};
use compiler::{legalise, ranges};
use portable::RealKind;

/// A pass by its name; the typing pass has run before those that simplify.
fn run(pass: &str, real: RealKind, text: &str) -> Result<[Program; 2], Defect> {
    let simplify = |name: &str| PASSES.into_iter().find(|(known, _)| *known == name);
    let Some((_, simplify_it)) = simplify(pass) else {
        let program = read::program(real, text, Some(Type::Real));
        return Ok([program.clone(), legal(pass, program)?]);
    };
    let program = read::program(real, text, None);
    if pass == "typed" {
        return Ok([program.clone(), simplify_it(program)?]);
    }
    let (_, typed) = simplify("typed").expect("a pass has that name");
    let program = typed(program)?;
    Ok([program.clone(), simplify_it(program)?])
}

/// What a legalising pass makes of a program.
fn legal(pass: &str, program: Program) -> Result<Program, Defect> {
    if pass == "decided" {
        return ranges::decide(program.clone(), &ranges::run(&program, &[]).decided);
    }
    let all = legalise::WITH_OUTPUTS.iter().chain(legalise::WITH_DIGITS);
    let (_, pass) = all.into_iter().find(|(name, _)| *name == pass).unwrap_or_else(|| panic!("unknown pass: {pass}"));
    pass(program)
}

/// The lines of a program that begin with these words.
fn lines<'d>(dump: &'d str, words: &str) -> Vec<&'d str> {
    dump.lines().filter(|line| line.starts_with(words)).collect()
}

/// What has become of a program: new constants, the locals if they are others, the statements.
fn became(before: &Program, after: &Program) -> String {
    let [before, after] = [before, after].map(|program| {
        let dump = program.to_string();
        ["inputs.", "outputs.", "state."].iter().fold(dump, |dump, kind| dump.replace(kind, ""))
    });
    let known = lines(&before, "constant");
    let mut said: Vec<&str> = lines(&after, "constant").into_iter().filter(|line| !known.contains(line)).collect();
    let step = |dump: &'_ str| dump.split_once("\nstep\n").map(|(_, step)| step.to_owned()).unwrap_or_default();
    let locals = lines(&after, "local");
    if said.is_empty() && locals == lines(&before, "local") && step(&before) == step(&after) {
        return "as it was".to_owned();
    }
    if locals != lines(&before, "local") {
        said.extend(locals);
    }
    let step = step(&after);
    said.extend(step.lines().map(|line| &line[4..]));
    if step.is_empty() {
        said.push("nothing");
    }
    said.join("\n")
}

#[test]
fn what_each_pass_makes_of_a_program() {
    for file in ["simplified", "settled", "chosen", "legalised"] {
        transcript::compare(format!("{}/tests/passes/{file}.txt", env!("CARGO_MANIFEST_DIR")), |form, text| {
            let (pass, real) = form.strip_suffix(" REAL").map_or((form, RealKind::F64), |pass| (pass, RealKind::F32));
            match run(pass, real, text) {
                Ok([before, after]) => became(&before, &after),
                Err(defect) => format!("defect: {defect}"),
            }
        });
    }
}

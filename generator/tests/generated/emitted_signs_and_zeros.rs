//! Signs, zeros and the digits of REAL in emitted Structured Text, read from the text alone. What the text computes is
//! compared by the engines, which read a bare sign and a double rounding as most compilers do; these are for the others.

use crate::{files, from_disk, set_of, without_comments};
use compiler::program::{Expr, Statement, Type, Var};
use generator::blocks::blocks;
use generator::generate::identity;
use generator::pipeline::Set;
use generator::target::TARGETS;
use portable::{Binary, Literal, RealKind, Unary};
use std::collections::BTreeMap;
use std::path::Path;

/// Stages of weight 1, whose sign is a negation, and a gantry slave.
const SIGNS: &str = include_str!("../data/signs.toml");

/// The sets of the golden cases, and the one above in both real types.
fn sets() -> Vec<Set> {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden/cases");
    let folders = std::fs::read_dir(cases).unwrap().map(|entry| entry.unwrap().path().join("set.toml"));
    let of_cases = folders.filter(|path| path.exists()).map(|path| from_disk(&path));
    let single = SIGNS.replace("[axis.X]\n", "[axis.X]\nreal = \"f32\"\n").replace("fg_f0 = 11,", "fg_f0 = 31,");
    of_cases.chain([set_of(SIGNS), set_of(&single)]).collect()
}

/// The Structured Text of a file without its comments; of an XML file what stands in its CDATA.
fn code(name: &str, text: &str) -> Option<String> {
    let text = match name.rsplit_once('.').unwrap().1 {
        "st" | "scl" => text.to_owned(),
        "TcPOU" => {
            let inside = text.split("<![CDATA[").skip(1).map(|part| part.split("]]>").next().unwrap());
            inside.collect::<Vec<_>>().join("\n")
        }
        _ => return None,
    };
    let code = without_comments(&text);
    let lines = code.lines().map(|line| line.split("//").next().unwrap());
    Some(lines.collect::<Vec<_>>().join(" "))
}

/// Minus signs that begin an operand: what stands before each.
fn before_signs(code: &str) -> Vec<&str> {
    let minuses = code.match_indices('-').map(|(at, _)| code[..at].trim_end());
    let is_sign = |before: &&str| {
        let is_word = |word: &str| before.ends_with(&format!(" {word}")) || before.ends_with(&format!("({word}"));
        before.ends_with(['(', '+', '-', '*', '/', '<', '>', '=', ','])
            || ["AND", "OR", "NOT"].map(is_word).contains(&true)
    };
    minuses.filter(is_sign).collect()
}

/// `a - -b` is a mistake to some compilers, and to others `-a * b` is `-(a * b)`.
#[test]
fn a_sign_stands_in_parentheses() {
    let (mut texts, mut in_parentheses) = (0, 0);
    let of_sets = sets();
    let full = of_sets.iter().rev().take(2).flat_map(full_of_signs);
    for (name, text) in of_sets.iter().flat_map(files).chain(full) {
        let Some(code) = code(&name, &text) else { continue };
        texts += 1;
        for before in before_signs(&code) {
            let shown: String = before.chars().rev().take(40).collect::<Vec<_>>().into_iter().rev().collect();
            assert!(before.ends_with('(') || before.ends_with(":=") || before.ends_with(','), "{name}: {shown} -");
            in_parentheses += usize::from(before.ends_with('('));
        }
    }
    assert!(texts > 100 && in_parentheses > 50, "{texts}, {in_parentheses}");
}

/// A block with a negation and a negative number on either side of every operator; real blocks have few of them.
fn full_of_signs(set: &Set) -> Vec<(String, String)> {
    let axis = &set.axes[0];
    let mut block = blocks(axis).unwrap().remove(0);
    let program = &mut block.for_axis.program;
    let reals: Vec<usize> = (0..program.inputs.len()).filter(|input| program.inputs[*input].ty == Type::Real).collect();
    let at = |path: &str| Var::Output(program.outputs.iter().position(|output| output.path == path).unwrap());
    let (v_add, limited) = (at("v_add"), at("limited"));
    let input = |index: usize| Expr::Var(Var::Input(reals[index]));
    let negated = |expr: Expr| Expr::Unary(Unary::Negate, Box::new(expr));
    let number = Expr::Literal(match axis.axis.real {
        RealKind::F64 => Literal::F64(-0.375),
        RealKind::F32 => Literal::F32(-0.375),
    });
    let operands = [negated(input(0)), number, input(1), negated(negated(input(0)))];
    let sums = [Binary::Add, Binary::Subtract, Binary::Multiply, Binary::Divide];
    let comparisons = [Binary::Less, Binary::LessEqual, Binary::Greater, Binary::GreaterEqual];
    for (left, right) in operands.iter().flat_map(|left| operands.iter().map(move |right| (left, right))) {
        let both = |operator| Expr::Binary(operator, Box::new(left.clone()), Box::new(right.clone()));
        let of_sum = |operator| Statement::Assign { target: v_add, value: both(operator) };
        let of_comparison = |operator| Statement::Assign { target: limited, value: both(operator) };
        program.step.extend(sums.map(of_sum).into_iter().chain(comparisons.map(of_comparison)));
    }
    let files = TARGETS.iter().flat_map(|target| target.files(&identity(&axis.axis, &block), &block).unwrap());
    files.map(|file| (file.name, file.text)).collect()
}

/// The real literals of a text.
fn reals(code: &str) -> Vec<&str> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '_' | '#');
    let mut found = Vec::new();
    let mut rest = code;
    while let Some(at) = rest.find(is_part) {
        rest = &rest[at..];
        let mut end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        // `1.0E-30`
        if rest[..end].ends_with('E')
            && rest[end..].starts_with(['+', '-'])
            && rest.starts_with(|c: char| c.is_ascii_digit())
        {
            end += 1 + rest[end + 1..].find(|c: char| !c.is_ascii_digit()).unwrap_or(0);
        }
        if rest.starts_with(|c: char| c.is_ascii_digit()) && rest[..end].contains('.') {
            found.push(&rest[..end]);
        }
        rest = &rest[end..];
    }
    found
}

/// The shortest digits of this REAL, 7.038531E-26, lie so near the middle between it and its neighbour that an LREAL of them
/// is that middle, and is rounded to the neighbour.
const BETWEEN: f32 = f32::from_bits(0x15ae_43fd);

/// Some compilers read every literal as an LREAL and round it where it goes into a REAL.
#[test]
#[expect(clippy::cast_possible_truncation, reason = "what such a compiler does")]
fn a_literal_of_a_real_is_the_same_read_as_an_lreal_that_is_rounded() {
    assert_ne!((format!("{BETWEEN:?}").parse::<f64>().unwrap() as f32).to_bits(), BETWEEN.to_bits(), "what this shows");
    // 1 um/s^2 moves a load of so many kg with a force of BETWEEN, and an increment is 1 N.
    let text = format!(
        "cycle_time = \"1ms\"\n[axis.X]\nreal = \"f32\"\nmotor = \"linear\"\nkenngr.antr_typ = \"SERCOS\"\n\
         process_data.additive_torque = \"INT32\"\ngetriebe = [{{ kv = 2000, load = {} }}]\n\
         vorsteuer.vorsteuerung = \"ADD_ACC\"\n",
        f64::from(BETWEEN) * 1e6
    );
    let mut found = BTreeMap::new();
    for (name, text) in files(&set_of(&text)) {
        let Some(code) = code(&name, &text) else { continue };
        for real in reals(&code) {
            let (narrow, wide) = (real.parse::<f32>().unwrap(), real.parse::<f64>().unwrap() as f32);
            assert_eq!(narrow.to_bits(), wide.to_bits(), "{name}: {real}");
            if narrow.to_bits() == BETWEEN.to_bits() {
                *found.entry(name.rsplit_once('.').unwrap().1.to_owned()).or_insert(0) += 1;
            }
        }
    }
    assert_eq!(found.keys().collect::<Vec<_>>(), ["TcPOU", "scl", "st"], "the number itself");
}

/// What is assigned as a zero, in the order of the statements.
fn zeros(code: &str) -> Vec<(String, bool)> {
    let assignments = code.split(';').filter_map(|part| part.rsplit_once(":="));
    let of = |(target, value): (&str, &str)| {
        let negative = match value.trim() {
            "0.0" => false,
            "-1.0 * 0.0" => true,
            _ => return None,
        };
        Some((target.split_whitespace().last()?.trim_start_matches('#').to_ascii_lowercase(), negative))
    };
    // The type of a declaration is not the target of an assignment.
    assignments.filter_map(of).filter(|(target, _)| !["real", "lreal"].contains(&&**target)).collect()
}

/// The zeros of SCL are those of TwinCAT, sign by sign; a sign never stands before a zero.
#[test]
fn a_zero_of_scl_has_the_sign_that_it_has_elsewhere() {
    let (mut negative, mut positive) = (0, 0);
    for set in sets() {
        let files = files(&set);
        for axis in &set.axes {
            for block in generator::blocks::names(&axis.axis) {
                let stem = format!("axis_{}_{block}", axis.axis.name.to_ascii_lowercase());
                let zeros = |name: &str| zeros(&code(name, &files[name]).unwrap());
                let (of_scl, of_twincat) =
                    (zeros(&format!("{stem}.scl")), zeros(&format!("twincat/POUs/FB_{stem}.TcPOU")));
                assert_eq!(of_scl, of_twincat.into_iter().filter(|zero| of_scl.contains(zero)).collect::<Vec<_>>());
                negative += of_scl.iter().filter(|(_, negative)| *negative).count();
                positive += of_scl.iter().filter(|(_, negative)| !*negative).count();
            }
        }
        for (name, text) in &files {
            let Some(code) = code(name, text) else { continue };
            let is_zero =
                |(at, sign): (usize, &str)| !code[at + sign.len()..].starts_with(|c: char| c.is_ascii_digit());
            assert!(!code.match_indices("-0.0").any(is_zero), "{name}");
        }
    }
    assert!(negative > 5 && positive > 50, "{negative}, {positive}");
}

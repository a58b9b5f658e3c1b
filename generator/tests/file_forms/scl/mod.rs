//! SCL: every source passes a checker that is stricter than the manufacturer's, and the checker refuses what is wrong.

mod meaning;
mod refused;
mod syntax;
mod token;
mod words;

use crate::CASES;
use syntax::{Block, Statement};

/// What is wrong with a source; the blocks, if nothing is.
fn check(source: &str) -> Result<Vec<Block>, String> {
    let blocks = syntax::parse(&token::tokens(source)?)?;
    blocks.iter().try_for_each(meaning::check)?;
    Ok(blocks)
}

#[test]
fn every_source_passes_the_checker() {
    let (mut sources, mut statements) = (0, 0);
    for case in CASES.iter() {
        for (name, text) in case.with(&[".scl"]) {
            let blocks = check(text).unwrap_or_else(|fault| panic!("{}: {name}: {fault}", case.name));
            let stem = name.strip_suffix(".scl").unwrap();
            let axis =
                case.set.axes.iter().find(|axis| stem == format!("axis_{}", axis.axis.name.to_ascii_lowercase()));
            let expected = generator::blocks::names(&axis.unwrap().axis);
            let expected: Vec<String> = expected.iter().map(|block| format!("FB_{stem}_{block}")).collect();
            let names: Vec<&str> = blocks.iter().map(|block| block.name.as_str()).collect();
            assert_eq!(names, expected, "{}", case.name);
            sources += 1;
            statements += blocks.iter().map(|block| count(&block.body)).sum::<usize>();
        }
    }
    assert!(sources > 20 && statements > 1000, "{sources} sources, {statements} statements");
}

fn count(list: &[Statement]) -> usize {
    let of = |statement: &Statement| match statement {
        Statement::Assign { .. } => 1,
        Statement::If { branches, otherwise } => {
            1 + branches.iter().map(|(_, list)| count(list)).sum::<usize>() + otherwise.as_deref().map_or(0, count)
        }
    };
    list.iter().map(of).sum()
}

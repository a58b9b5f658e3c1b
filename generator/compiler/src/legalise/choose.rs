//! Replaces a chain of questions for one enumeration, or a long one for one integer, by a choice: a state machine is then
//! readable as one, and a long chain costs one jump.
//!
//! ```text
//! if state == a { x } else if state == b { y } else { z }   ->   choose by state: a { x }, b { y }, c { z }
//! ```

use crate::pass::Defect;
use crate::program::{Arm, Constant, Expr, Origin, Program, Statement, Var, variant_name};
use portable::{Binary, Literal, Variant};

/// A chain of two arms stays an `if`.
const LEAST_ARMS: usize = 3;
/// A chain by numbers with fewer arms stays an `if`.
const LEAST_NUMBERS: usize = 8;

pub(super) fn run(mut program: Program) -> Result<Program, Defect> {
    in_list(&mut program.step, None, &mut program.constants);
    Ok(program)
}

/// `within`: the variable of the choice around the list, with the values that lead to it.
fn in_list(list: &mut [Statement], within: Option<(Var, &[Expr])>, constants: &mut Vec<Constant>) {
    for statement in list {
        if let Some(by) = by(statement, constants) {
            let possible = within.filter(|(outer, _)| *outer == by).map(|(_, labels)| labels);
            let chain = std::mem::replace(statement, Statement::Note(String::new()));
            *statement = Statement::Choose { by: Expr::Var(by), arms: arms(chain, by, possible, constants) };
        }
        if let Statement::Choose { by: Expr::Var(by), arms } = statement {
            for Arm { labels, body } in arms {
                let is_fixed = !body.iter().any(|inner| inner.writes(*by));
                in_list(body, is_fixed.then_some((*by, &**labels)), constants);
            }
        } else {
            statement.change_branches(|list| in_list(list, within, constants));
        }
    }
}

/// The variable that a chain of questions asks for, if the chain is long enough for a choice.
fn by(statement: &Statement, constants: &[Constant]) -> Option<Var> {
    let (by, labels) = asked(statement, constants)?;
    let least = if matches!(labels[..], [Expr::Literal(_), ..]) { LEAST_NUMBERS } else { LEAST_ARMS };
    let (mut link, mut arms) = (statement, 1);
    while let Statement::If { then, otherwise, .. } = link {
        // Structured Text has no branch without a statement.
        if then.iter().all(|inner| matches!(inner, Statement::Note(_))) {
            return None;
        }
        arms += 1;
        match &otherwise[..] {
            [next] if asked(next, constants).is_some_and(|(same, _)| same == by) => link = next,
            _ => break,
        }
    }
    (arms >= least).then_some(by)
}

/// The arms of a chain; the last one is for the variants that no question names, of those that are possible there.
fn arms(chain: Statement, by: Var, possible: Option<&[Expr]>, constants: &mut Vec<Constant>) -> Vec<Arm> {
    let (mut arms, mut rest) = (Vec::new(), vec![chain]);
    while let [link] = &rest[..]
        && let Some((_, labels)) = asked(link, constants).filter(|(same, _)| *same == by)
        && let Some(Statement::If { then, otherwise, .. }) = rest.pop()
    {
        arms.push(Arm { labels, body: then });
        rest = otherwise;
    }
    let mut labels = others(&arms, constants);
    if let Some(possible) = possible {
        labels.retain(|label| possible.contains(label));
    }
    arms.push(Arm { labels, body: rest });
    arms
}

/// The variable of a question, with its variants or numbers, if the statement does nothing else.
fn asked(statement: &Statement, constants: &[Constant]) -> Option<(Var, Vec<Expr>)> {
    let Statement::If { condition, .. } = statement else { return None };
    let mut labels = Vec::new();
    let by = questions(condition, constants, &mut labels)?;
    Some((by, labels))
}

fn questions(condition: &Expr, constants: &[Constant], labels: &mut Vec<Expr>) -> Option<Var> {
    match condition {
        Expr::Binary(Binary::Equal, left, right) => match (&**left, &**right) {
            (Expr::Var(by), label)
                if matches!(label, Expr::Literal(Literal::I32(_) | Literal::U32(_)))
                    || variant(label, constants).is_some() =>
            {
                labels.push(label.clone());
                Some(*by)
            }
            _ => None,
        },
        Expr::Binary(Binary::Or, left, right) => {
            let by = questions(left, constants, labels)?;
            questions(right, constants, labels).filter(|other| *other == by)
        }
        _ => None,
    }
}

fn variant(label: &Expr, constants: &[Constant]) -> Option<Variant> {
    let Expr::Var(Var::Constant(index)) = label else { return None };
    match constants[*index].origin {
        Origin::Variant(variant) => Some(variant),
        Origin::Coefficient(_) | Origin::Function | Origin::Runtime(_) => None,
    }
}

/// The variants that no arm names.
fn others(arms: &[Arm], constants: &mut Vec<Constant>) -> Vec<Expr> {
    let named: Vec<Variant> =
        arms.iter().flat_map(|arm| &arm.labels).filter_map(|label| variant(label, constants)).collect();
    let Some(of) = named.first().map(|variant| variant.of) else { return Vec::new() };
    let all = (0..).take(of.variants.len()).map(|index| Variant { of, index });
    let mut label = |variant: Variant| {
        let known = constants.iter().position(|constant| constant.origin == Origin::Variant(variant));
        let index = known.unwrap_or_else(|| {
            constants.push(Constant {
                path: variant_name(variant),
                doc: variant.def().doc,
                value: Literal::Variant(variant).at_run_time(),
                origin: Origin::Variant(variant),
            });
            constants.len() - 1
        });
        Expr::Var(Var::Constant(index))
    };
    all.filter(|variant| !named.contains(variant)).map(&mut label).collect()
}

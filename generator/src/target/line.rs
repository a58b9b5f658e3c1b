//! A line of code that is too long, broken before its operators.

/// Characters in a line of code, where it can be broken.
pub const WIDTH: usize = 120;

/// Begins a line.
pub fn indent(level: usize, text: &mut String) {
    for _ in 0..level {
        text.push_str("    ");
    }
}

/// Breaks the assignment that begins at `start`, if it is too long: behind its target, which ends at `end_of_target` before a
/// blank, then before operators.
pub fn fold_assignment(text: &mut String, start: usize, end_of_target: usize, level: usize, operators: &[&str]) {
    if text.len() - start > WIDTH {
        let mut next_line = "\n".to_owned();
        indent(level + 1, &mut next_line);
        text.replace_range(end_of_target..=end_of_target, &next_line);
        fold(text, end_of_target + 1, level + 2, operators);
    }
}

/// Where a line can be broken.
#[derive(Clone, Copy)]
struct Place {
    /// the blank before an operator
    at: usize,
    /// how many parentheses are open there
    depth: usize,
}

/// Breaks the last line of a text, which begins at `start`, if it is too long: before the operators outside of most
/// parentheses, and before those further inside only where that is not enough. What follows is indented to `level`, and by
/// one level more within each parenthesis that has been broken.
pub fn fold(text: &mut String, start: usize, level: usize, operators: &[&str]) {
    if text.len() - start <= WIDTH {
        return;
    }
    let line = text.split_off(start);
    let places = places(&line, operators);
    let mut depths: Vec<usize> = places.iter().map(|place| place.depth).collect();
    depths.sort_unstable();
    depths.dedup();
    let mut lines = vec![line.clone()];
    for (inside, deepest) in depths.iter().enumerate() {
        let indentation = |depth| "    ".repeat(level + depths[..=inside].partition_point(|other| *other < depth));
        let places = places.iter().copied().filter(|place| place.depth <= *deepest);
        lines = filled(&line, places, indentation);
        if lines.iter().all(|line| line.len() <= WIDTH) {
            break;
        }
    }
    text.push_str(&lines.join("\n"));
}

/// The places of a line. Comments have no operators.
fn places(line: &str, operators: &[&str]) -> Vec<Place> {
    let (mut places, mut depth, mut at) = (Vec::new(), 0, 0);
    while let Some(character) = line[at..].chars().next() {
        let rest = &line[at..];
        if let Some(end) = rest.starts_with("(*").then(|| rest.find("*)")).flatten() {
            at += end + 2;
            continue;
        }
        match character {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ if operators.iter().any(|operator| rest.starts_with(operator)) => places.push(Place { at, depth }),
            _ => {}
        }
        at += character.len_utf8();
    }
    places
}

/// The line broken at some of its places, so that each part is as long as it may be.
fn filled(line: &str, places: impl Iterator<Item = Place>, indentation: impl Fn(usize) -> String) -> Vec<String> {
    let (mut lines, mut part, mut last) = (Vec::new(), String::new(), 0);
    let mut behind = 0;
    for place in places.chain([Place { at: line.len(), depth: 0 }]) {
        let next = &line[last..place.at];
        if last > 0 && part.len() + next.len() > WIDTH {
            lines.push(part);
            part = indentation(behind) + next.trim_start();
        } else {
            part.push_str(next);
        }
        (last, behind) = (place.at, place.depth);
    }
    lines.push(part);
    lines
}

#[cfg(test)]
mod tests {
    use super::{WIDTH, fold};

    fn folded(line: &str) -> Vec<String> {
        let mut text = format!("before\n{line}");
        fold(&mut text, "before\n".len(), 2, &[" AND ", " OR "]);
        text.lines().skip(1).map(str::to_owned).collect()
    }

    #[test]
    fn a_line_that_fits_stays() {
        let line = format!("IF {} AND b THEN", "a".repeat(WIDTH - 14));
        assert_eq!(line.len(), WIDTH);
        assert_eq!(folded(&line), [line]);
    }

    #[test]
    fn the_outermost_operators_are_first() {
        let (a, b) = ("a".repeat(49), "b".repeat(49));
        assert_eq!(
            folded(&format!("IF ({a} OR {b}) AND (c OR d) AND e THEN")),
            [format!("IF ({a} OR {b}) AND (c OR d)"), "        AND e THEN".to_owned()]
        );
    }

    #[test]
    fn inner_operators_follow_where_it_must_be() {
        let (a, b) = ("a".repeat(70), "b".repeat(70));
        assert_eq!(
            folded(&format!("IF NOT (({a} OR {b}) AND e) THEN")),
            [format!("IF NOT (({a}"), format!("            OR {b}) AND e) THEN")]
        );
    }

    #[test]
    fn a_comment_is_not_broken_and_no_line_is_longer_than_it_must_be() {
        let line = format!("IF (x (* (y AND z *) < {}) AND {} THEN", "1".repeat(70), "v".repeat(60));
        let lines = folded(&line);
        assert_eq!(lines.len(), 2);
        assert!(lines[1].starts_with("        AND v"), "{lines:?}");
        let whole = "w".repeat(200);
        assert_eq!(folded(&whole), [whole]);
    }
}

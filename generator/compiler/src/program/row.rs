//! Arrays of the state: consecutive variables of one type, one of which a statement selects by a number.

use super::{Expr, Program, Var};

/// Consecutive variables of the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// the position of its first element in [`Program::state`]
    pub first: usize,
    /// the number of its elements
    pub length: usize,
}

impl Row {
    /// Its elements.
    pub fn elements(self) -> impl Iterator<Item = Var> {
        (self.first..self.first + self.length).map(Var::State)
    }
}

impl Program {
    /// The array that contains a part of the state.
    pub fn row_of(&self, part: usize) -> Option<Row> {
        self.rows.iter().copied().find(|row| (row.first..row.first + row.length).contains(&part))
    }

    /// The path that the elements of an array have in common; `None`: they are parts of several structs.
    pub fn path_of_row(&self, row: Row) -> Option<&str> {
        let mut paths = row.elements().map(|element| self.path(element));
        let mut common = paths.next()?.rsplit_once('.')?.0;
        for path in paths {
            while !path.strip_prefix(common).is_some_and(|rest| rest.starts_with('.')) {
                common = common.rsplit_once('.')?.0;
            }
        }
        Some(common)
    }

    /// Whether it reads an element of an array.
    pub fn has_elements(&self) -> bool {
        self.has(&|part| matches!(part, Expr::Element(..)))
    }
}

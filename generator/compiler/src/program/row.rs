//! Arrays of the state: consecutive variables of one type, one of which a statement selects by a number.

use super::{Program, Var};

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
        let is_end = |after: char| matches!(after, '.' | '[');
        let mut paths = row.elements().map(|element| self.path(element));
        let first = paths.next()?;
        let mut common = &first[..first.rfind(is_end)?];
        for path in paths {
            while !path.strip_prefix(common).is_some_and(|rest| rest.starts_with(is_end)) {
                common = &common[..common.rfind(is_end)?];
            }
        }
        Some(common)
    }
}

//! The parameters of a list in the tables and arrays of their paths, each with its comments; no text of TOML is here.

use crate::parameters::path_with;

/// A value with what stood beside it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Leaf {
    /// the value, as TOML
    pub value: String,
    /// the comments above it, `#` included; an empty line between paragraphs
    pub above: Vec<String>,
    /// whether a blank line stood above it
    pub apart: bool,
    /// the comment behind it
    pub beside: Option<String>,
}

/// What a key stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Node {
    /// a value
    Leaf(Leaf),
    /// a table
    Table(Table),
    /// an array of tables
    Array(Vec<Table>),
}

/// Keys in the order in which the list has them first.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// the keys
    pub entries: Vec<(String, Node)>,
}

impl Table {
    /// Puts a value at the path that a template and its indices give.
    pub fn insert(&mut self, template: &str, index: [u32; 2], leaf: Leaf) {
        let path = path_with(template, index);
        let (tables, key) = path.rsplit_once('.').unwrap_or(("", &path));
        let tables = tables.split('.').filter(|table| !table.is_empty());
        let table = tables.fold(self, |table, part| table.below(part));
        table.entries.push((key.to_owned(), Node::Leaf(leaf)));
    }

    /// The table below a key such as `stage[1]` or `kenngr`. Of an array the first is meant where no index is given: a list
    /// may mix `filter.x` and `filter[0].x`, TOML may not.
    fn below(&mut self, part: &str) -> &mut Self {
        let (key, index) = part
            .split_once('[')
            .map_or((part, None), |(key, index)| (key, index.trim_end_matches(']').parse::<usize>().ok()));
        let position = self.entries.iter().position(|(known, _)| known == key).unwrap_or_else(|| {
            self.entries.push((key.to_owned(), Node::Table(Self::default())));
            self.entries.len() - 1
        });
        let node = &mut self.entries[position].1;
        if let (Node::Table(table), Some(_)) = (&mut *node, index) {
            let first = std::mem::take(table);
            *node = Node::Array(vec![first]);
        }
        match node {
            Node::Table(table) => table,
            Node::Array(tables) => {
                let index = index.unwrap_or(0);
                tables.resize(tables.len().max(index + 1), Self::default());
                &mut tables[index]
            }
            Node::Leaf(_) => panic!("tree: `{part}` is a value and a table"),
        }
    }
}

impl Node {
    /// All values.
    #[must_use]
    pub fn leaves(&self) -> Vec<&Leaf> {
        match self {
            Self::Leaf(leaf) => vec![leaf],
            Self::Table(table) => table.leaves(),
            Self::Array(tables) => tables.iter().flat_map(Table::leaves).collect(),
        }
    }
}

impl Table {
    /// All values.
    #[must_use]
    pub fn leaves(&self) -> Vec<&Leaf> {
        self.entries.iter().flat_map(|(_, node)| node.leaves()).collect()
    }
}

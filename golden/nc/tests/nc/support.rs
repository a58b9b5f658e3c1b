//! What the tests of programs share: reading without the lines and numbers of blocks.

use nc::{Command, read};

/// The commands of a program that has no mistake, block by block, without `M30`.
pub fn commands(text: &str) -> Vec<Vec<Command>> {
    let program = read(text).unwrap_or_else(|mistakes| panic!("{text}\n{mistakes:#?}"));
    let mut blocks: Vec<Vec<Command>> = program.blocks.into_iter().map(|block| block.commands).collect();
    assert_eq!(blocks.pop(), Some(vec![Command::End]), "the last block of {text}");
    blocks
}

/// All that is reported for a text.
pub fn said(text: &str) -> Vec<String> {
    read(text).err().unwrap_or_default().iter().map(ToString::to_string).collect()
}

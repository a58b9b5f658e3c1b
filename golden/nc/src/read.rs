//! A text, line by line, which makes a program: its name, its block numbers, its end. Not what a block may hold.

use super::block::{self, InForce};
use super::lexical::{self, Piece};
use super::mistake::{Mistake, Mistakes, shown};
use super::program::{Block, Command, Program};
use super::unknown;
use super::word::{self, Placed, Word};

/// Reads a program; the error is all that is wrong with it, in the order of the file.
pub fn read(text: &str) -> Result<Program, Vec<Mistake>> {
    let mut reader = Reader::default();
    for (index, line) in text.split('\n').enumerate() {
        reader.mistakes.line = index + 1;
        reader.line(line.strip_suffix('\r').unwrap_or(line));
    }
    reader.end()
}

#[derive(Default)]
struct Reader {
    name: Option<String>,
    blocks: Vec<Block>,
    force: InForce,
    mistakes: Mistakes,
    /// where a missing `M30` would stand: behind the last word, line and column
    last: (usize, usize),
    /// a line with a word was there
    begun: bool,
    /// the line of `M30`
    ended: Option<usize>,
    /// that something stands behind `M30` is said
    beyond: bool,
}

impl Reader {
    fn line(&mut self, line: &str) {
        let said = self.mistakes.count();
        let pieces = lexical::pieces(line, &mut self.mistakes);
        let Some(last) = pieces.last() else { return };
        let begun = std::mem::replace(&mut self.begun, true);
        self.last = (self.mistakes.line, last.column + last.text.len());
        if !begun && pieces[0].text.starts_with('%') {
            self.program_name(pieces[0], pieces.get(1));
            return;
        }
        self.beyond(pieces[0]);
        let mut words: Vec<Placed<'_>> = Vec::new();
        for piece in pieces {
            match word::parse(piece.text) {
                Some(word) => words.push(Placed { column: piece.column, text: piece.text, word }),
                None => unknown::say(piece, &mut self.mistakes),
            }
        }
        let known = self.mistakes.count() == said;
        self.block(words, known);
    }

    /// `%` and the name of the program.
    fn program_name(&mut self, piece: Piece<'_>, behind: Option<&Piece<'_>>) {
        let name = piece.text.trim_start_matches('%');
        let letter = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_');
        if name.is_empty() || name.len() + 1 != piece.text.len() || !name.bytes().all(letter) {
            let allowed = "`%` and a name of letters, digits, `-` and `_`";
            self.mistakes.push(piece.column, shown(piece.text), allowed, "a name like `%spindle-position`");
        }
        if let Some(other) = behind {
            let found = format!("{} behind the program name", shown(other.text));
            self.mistakes.push(other.column, found, "a comment behind the name", "the block in the next line");
        }
        self.name = Some(name.to_owned());
    }

    /// Says once that something stands behind `M30`; what it is, is read all the same.
    fn beyond(&mut self, piece: Piece<'_>) {
        if let Some(line) = self.ended.filter(|_| !self.beyond) {
            let found = format!("{} after `M30` in line {line}", shown(piece.text));
            self.mistakes.push(piece.column, found, "comments after `M30`", "`M30` as the last block");
            self.beyond = true;
        }
    }

    fn block(&mut self, mut words: Vec<Placed<'_>>, known: bool) {
        let number = match words.first() {
            Some(Placed { word: Word::Number(number), .. }) => Some(*number),
            _ => None,
        };
        let first = number.map(|_| words.remove(0));
        words.retain(|placed| {
            let stray = matches!(placed.word, Word::Number(_));
            if stray {
                let found = format!("{} behind another word", shown(placed.text));
                let allowed = "one block number, as the first word";
                self.mistakes.push(
                    placed.column,
                    found,
                    allowed,
                    format!("{} in front, or nothing", shown(placed.text)),
                );
            }
            !stray
        });
        if let Some(first) = first.filter(|_| words.is_empty() && known) {
            let found = format!("{} and no word", shown(first.text));
            self.mistakes.push(
                first.column,
                found,
                "a block number before other words",
                "the block, or a comment in `( )`",
            );
        }
        // A word that is not known would lead to more mistakes, which are none when it is corrected.
        let mut unsaid = Mistakes::default();
        let mistakes = if known { &mut self.mistakes } else { &mut unsaid };
        let commands = block::commands(words, &mut self.force, mistakes);
        if commands.contains(&Command::End) {
            self.ended = self.ended.or(Some(self.mistakes.line));
        }
        self.blocks.push(Block { line: self.mistakes.line, number, commands });
    }

    fn end(mut self) -> Result<Program, Vec<Mistake>> {
        if self.ended.is_none() {
            let (line, column) = self.last;
            self.mistakes.line = line.max(1);
            let allowed = "a program whose last block is `M30`";
            self.mistakes.push(column.max(1), "no `M30`", allowed, "`M30` in a line of its own");
        }
        match self.mistakes.sorted() {
            none if none.is_empty() => Ok(Program { name: self.name, blocks: self.blocks }),
            mistakes => Err(mistakes),
        }
    }
}

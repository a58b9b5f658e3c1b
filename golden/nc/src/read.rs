//! Reads a text line by line into a program: its name, its block numbers, its end. Not the contents of a block.

use super::block::{self, InForce};
use super::foreign::Foreign;
use super::lexical::{self, Comment, Piece};
use super::mistake::{Mistake, Mistakes, shown};
use super::passed::PassedKind;
use super::program::{Block, Command, Program};
use super::unknown;
use super::word::{self, Placed, Word};

/// Reads a program. The error contains all its errors, in the order of the file.
pub fn read(text: &str) -> Result<Program, Vec<Mistake>> {
    let mut reader = Reader::default();
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    // A file of an old system has carriage returns only.
    let end = if text.contains('\n') { '\n' } else { '\r' };
    for (index, line) in text.split(end).enumerate() {
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
    comment: Comment,
    mistakes: Mistakes,
    /// place of a missing `M30`: after the last word, line and column
    last: (usize, usize),
    /// whether a line with a word has been read
    begun: bool,
    /// whether `M30`, `M2` or the closing `%` has been read
    ended: bool,
}

impl Reader {
    fn line(&mut self, line: &str) {
        let said = self.mistakes.count();
        let pieces = self.comment.pieces(line, &mut self.mistakes);
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return };
        if self.ended {
            if !first.text.starts_with('%') {
                self.mistakes.pass(PassedKind::AfterEnd, first.column, "");
            }
            return;
        }
        let begun = std::mem::replace(&mut self.begun, true);
        self.last = (self.mistakes.line, last.column + last.text.chars().count());
        if first.text.starts_with('%') && (!begun || first.text == "%") {
            self.percent(*first, pieces.get(1), begun);
            return;
        }
        let mut words: Vec<Placed<'_>> = Vec::new();
        for Piece { column, text } in pieces {
            match word::parse(text) {
                Some(Word::Foreign(foreign)) => self.mistakes.foreign(column, text, foreign),
                Some(word) => words.push(Placed { column, text, word }),
                None => unknown::say(Piece { column, text }, &mut self.mistakes),
            }
        }
        let known = self.mistakes.count() == said;
        self.block(words, known);
    }

    /// `%` and the name of the program, or the mark at the beginning and the end of a tape.
    fn percent(&mut self, piece: Piece<'_>, next: Option<&Piece<'_>>, begun: bool) {
        let name = piece.text.trim_start_matches('%');
        let letter = |byte: u8| byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b'.');
        if piece.text.eq_ignore_ascii_case("%L") {
            self.mistakes.foreign(piece.column, piece.text, Foreign::Subprogram);
            return;
        }
        if piece.text.len() > name.len() + 1 || !name.bytes().all(letter) {
            let allowed = "`%` and a name of letters, digits, `-`, `_` and `.`";
            self.mistakes.push(piece.column, shown(piece.text), allowed, "a name like `%spindle-position`");
        }
        if let Some(other) = next {
            let found = format!("{} after the program name", shown(other.text));
            self.mistakes.push(other.column, found, "a comment after the name", "the block in the next line");
        }
        if begun {
            self.finish(None);
        } else {
            self.name = (!name.is_empty()).then(|| name.to_owned());
        }
    }

    fn block(&mut self, mut words: Vec<Placed<'_>>, known: bool) {
        let place = words.iter().position(|placed| placed.word != Word::Skip);
        let number =
            place.and_then(|at| if let Word::Number(number) = words[at].word { Some((at, number)) } else { None });
        let number = number.map(|(at, number)| {
            words.remove(at);
            number
        });
        words.retain(|placed| {
            let stray = matches!(placed.word, Word::Number(_));
            if stray {
                let found = format!("{} after another word", shown(placed.text));
                let instead = format!("{} in front, or nothing", shown(placed.text));
                self.mistakes.push(placed.column, found, "one block number, as the first word", instead);
            }
            !stray
        });
        // An unknown word would cause more errors that vanish when it is corrected.
        let mut unsaid = Mistakes::default();
        let mistakes = if known { &mut self.mistakes } else { &mut unsaid };
        let commands = block::commands(words, &mut self.force, mistakes);
        self.ended = commands.contains(&Command::End);
        if !commands.is_empty() {
            self.blocks.push(Block { line: self.mistakes.line, number, commands });
        }
    }

    /// Notes an end without `M30`; with a `%`, at its line.
    fn finish(&mut self, place: Option<(usize, usize)>) {
        let (line, column) = place.unwrap_or((self.mistakes.line, 1));
        self.mistakes.line = line;
        self.mistakes.pass(PassedKind::NoEnd, column, "");
        self.blocks.push(Block { line, number: None, commands: vec![Command::End] });
        self.ended = true;
    }

    fn end(mut self) -> Result<Program, Vec<Mistake>> {
        lexical::open_comment(&self.comment, &mut self.mistakes);
        let (line, column) = self.last;
        let place = (line.max(1), column.max(1));
        if self.mistakes.count() == 0 && self.blocks.iter().all(|block| block.commands == [Command::End]) && !self.ended
        {
            self.mistakes.line = place.0;
            let allowed = "a program with a block that does something, and `M30` as its last one";
            self.mistakes.push(
                place.1,
                "no block with a command",
                allowed,
                "the blocks, and `M30` in a line of its own",
            );
        } else if !self.ended {
            self.finish(Some(place));
        }
        let Mistakes { passed, .. } = &mut self.mistakes;
        let passed = std::mem::take(passed).sorted();
        match self.mistakes.sorted() {
            none if none.is_empty() => Ok(Program { name: self.name, blocks: self.blocks, passed }),
            mistakes => Err(mistakes),
        }
    }
}

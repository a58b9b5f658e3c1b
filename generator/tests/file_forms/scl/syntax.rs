//! SCL as blocks, by recursive descent: function blocks with their sections, assignments and IF; nothing else.

use super::token::Token;

/// A function block.
pub struct Block {
    pub name: String,
    pub declarations: Vec<Declaration>,
    pub body: Vec<Statement>,
}

/// The sections in the order in which TIA writes them.
pub const SECTIONS: [Section; 5] = [Section::Input, Section::Output, Section::Static, Section::Temp, Section::Constant];

/// Where a variable is declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Section {
    Input,
    Output,
    Static,
    Temp,
    Constant,
}

/// `name : TYPE [:= literal];`
pub struct Declaration {
    pub section: Section,
    pub name: String,
    pub ty: String,
    pub value: Option<Expr>,
    pub line: usize,
}

pub enum Statement {
    Assign { target: String, value: Expr, line: usize },
    If { branches: Vec<((Expr, usize), Vec<Statement>)>, otherwise: Option<Vec<Statement>> },
}

#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    Bool(bool),
    Number(String),
    Variable(String),
    Unary(String, Box<Expr>),
    Binary(String, Box<Expr>, Box<Expr>),
    Call(String, Box<Expr>),
}

/// How operators bind, loosest first.
const LEVELS: [&[&str]; 6] = [&["OR"], &["AND"], &["=", "<>"], &["<", ">", "<=", ">="], &["+", "-"], &["*", "/"]];

/// The blocks of a source.
pub fn parse(tokens: &[(Token, usize)]) -> Result<Vec<Block>, String> {
    let mut parser = Parser { tokens, at: 0 };
    let mut blocks = Vec::new();
    while parser.at < tokens.len() || blocks.is_empty() {
        blocks.push(parser.block()?);
    }
    Ok(blocks)
}

struct Parser<'t> {
    tokens: &'t [(Token, usize)],
    at: usize,
}

impl Parser<'_> {
    fn peek(&self) -> Option<&Token> {
        self.tokens.get(self.at).map(|(token, _)| token)
    }

    fn line(&self) -> usize {
        self.tokens.get(self.at).or(self.tokens.last()).map_or(1, |(_, line)| *line)
    }

    fn fail<T>(&self, wanted: &str) -> Result<T, String> {
        Err(format!("line {}: {wanted} is wanted, {:?} found", self.line(), self.peek()))
    }

    fn takes(&mut self, token: &Token) -> bool {
        let found = self.peek() == Some(token);
        self.at += usize::from(found);
        found
    }

    fn takes_word(&mut self, word: &str) -> bool {
        self.takes(&Token::Word(word.to_owned()))
    }

    fn word(&mut self, word: &str) -> Result<(), String> {
        if self.takes_word(word) { Ok(()) } else { self.fail(word) }
    }

    fn mark(&mut self, mark: &'static str) -> Result<(), String> {
        if self.takes(&Token::Mark(mark)) { Ok(()) } else { self.fail(mark) }
    }

    fn block(&mut self) -> Result<Block, String> {
        self.word("FUNCTION_BLOCK")?;
        let Some(Token::Quoted(name)) = self.peek().cloned() else { return self.fail("\"name\"") };
        self.at += 1;
        self.mark("{")?;
        self.word("S7_Optimized_Access")?;
        self.mark(":=")?;
        if !self.takes(&Token::Text("TRUE".to_owned())) {
            return self.fail("'TRUE'");
        }
        self.mark("}")?;
        self.word("VERSION")?;
        self.mark(":")?;
        if !self.takes(&Token::Number("0.1".to_owned())) {
            return self.fail("0.1");
        }
        let mut declarations = Vec::new();
        for section in SECTIONS {
            self.section(section, &mut declarations)?;
        }
        self.word("BEGIN")?;
        let body = self.list()?;
        self.word("END_FUNCTION_BLOCK")?;
        Ok(Block { name, declarations, body })
    }

    /// A section, if it is there; VAR alone and VAR CONSTANT begin alike.
    fn section(&mut self, section: Section, declarations: &mut Vec<Declaration>) -> Result<(), String> {
        let word = match section {
            Section::Input => "VAR_INPUT",
            Section::Output => "VAR_OUTPUT",
            Section::Static | Section::Constant => "VAR",
            Section::Temp => "VAR_TEMP",
        };
        let is_constant =
            self.tokens.get(self.at + 1).is_some_and(|(token, _)| *token == Token::Word("CONSTANT".into()));
        if self.peek() != Some(&Token::Word(word.to_owned())) || is_constant != (section == Section::Constant) {
            return Ok(());
        }
        self.at += 1 + usize::from(is_constant);
        let before = declarations.len();
        while !self.takes_word("END_VAR") {
            let line = self.line();
            let Some(Token::Word(name)) = self.peek().cloned() else { return self.fail("a name") };
            self.at += 1;
            self.mark(":")?;
            let Some(Token::Word(ty)) = self.peek().cloned() else { return self.fail("a type") };
            self.at += 1;
            let value = if self.takes(&Token::Mark(":=")) { Some(self.literal()?) } else { None };
            self.mark(";")?;
            declarations.push(Declaration { section, name, ty, value, line });
        }
        if declarations.len() == before { self.fail("a declaration in every section") } else { Ok(()) }
    }

    /// A number with its sign, or a truth value.
    fn literal(&mut self) -> Result<Expr, String> {
        let is_negative = self.takes(&Token::Mark("-"));
        match self.primary()? {
            number @ Expr::Number(_) if is_negative => Ok(Expr::Unary("-".to_owned(), Box::new(number))),
            literal @ (Expr::Number(_) | Expr::Bool(_)) if !is_negative => Ok(literal),
            _ => self.fail("a literal"),
        }
    }

    /// One statement or more, up to a word that ends a list.
    fn list(&mut self) -> Result<Vec<Statement>, String> {
        let mut list = Vec::new();
        loop {
            match self.peek() {
                Some(Token::Word(word)) if word == "IF" => list.push(self.question()?),
                Some(Token::Local(_)) => list.push(self.assignment()?),
                _ if list.is_empty() => return self.fail("a statement"),
                _ => return Ok(list),
            }
        }
    }

    fn assignment(&mut self) -> Result<Statement, String> {
        let line = self.line();
        let Some(Token::Local(target)) = self.peek().cloned() else { return self.fail("#name") };
        self.at += 1;
        self.mark(":=")?;
        let value = self.expr(0)?;
        self.mark(";")?;
        Ok(Statement::Assign { target, value, line })
    }

    fn question(&mut self) -> Result<Statement, String> {
        let (mut branches, mut otherwise) = (Vec::new(), None);
        while self.takes_word(if branches.is_empty() { "IF" } else { "ELSIF" }) {
            let line = self.line();
            let condition = self.expr(0)?;
            self.word("THEN")?;
            branches.push(((condition, line), self.list()?));
        }
        if self.takes_word("ELSE") {
            otherwise = Some(self.list()?);
        }
        self.word("END_IF")?;
        self.mark(";")?;
        Ok(Statement::If { branches, otherwise })
    }

    fn expr(&mut self, level: usize) -> Result<Expr, String> {
        let Some(operators) = LEVELS.get(level) else { return self.unary() };
        let mut left = self.expr(level + 1)?;
        loop {
            let found = match self.peek() {
                Some(Token::Word(word)) => operators.iter().find(|operator| *operator == word),
                Some(Token::Mark(mark)) => operators.iter().find(|operator| *operator == mark),
                _ => None,
            };
            let Some(operator) = found else { return Ok(left) };
            self.at += 1;
            left = Expr::Binary((*operator).to_owned(), Box::new(left), Box::new(self.expr(level + 1)?));
        }
    }

    fn unary(&mut self) -> Result<Expr, String> {
        for (operator, token) in [("-", Token::Mark("-")), ("NOT", Token::Word("NOT".to_owned()))] {
            if self.takes(&token) {
                return Ok(Expr::Unary(operator.to_owned(), Box::new(self.primary()?)));
            }
        }
        self.primary()
    }

    fn primary(&mut self) -> Result<Expr, String> {
        let Some(token) = self.peek().cloned() else { return self.fail("an operand") };
        self.at += 1;
        match token {
            Token::Number(digits) => Ok(Expr::Number(digits)),
            Token::Local(name) => Ok(Expr::Variable(name)),
            Token::Word(word) if word == "TRUE" || word == "FALSE" => Ok(Expr::Bool(word == "TRUE")),
            Token::Word(function) if self.takes(&Token::Mark("(")) => {
                let operand = self.expr(0)?;
                self.mark(")")?;
                Ok(Expr::Call(function, Box::new(operand)))
            }
            Token::Mark("(") => {
                let inside = self.expr(0)?;
                self.mark(")")?;
                Ok(inside)
            }
            _ => {
                self.at -= 1;
                self.fail("an operand")
            }
        }
    }
}

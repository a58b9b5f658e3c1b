//! SCL as tokens, each with its line. What is not in the subset is an error.

/// A token.
#[derive(Clone, Debug, PartialEq)]
pub enum Token {
    /// a word: a keyword, a name that is declared, a conversion
    Word(String),
    /// `#name`
    Local(String),
    /// `"name"`
    Quoted(String),
    /// `'text'`
    Text(String),
    /// digits; with a point for a real
    Number(String),
    /// an operator or a mark
    Mark(&'static str),
}

/// Longest first.
const MARKS: [&str; 18] =
    [":=", "<=", ">=", "<>", "<", ">", "=", "+", "-", "*", "/", "(", ")", ";", ":", "{", "}", ","];

/// The tokens of a source.
pub fn tokens(source: &str) -> Result<Vec<(Token, usize)>, String> {
    let mut tokens = Vec::new();
    let mut rest = source;
    loop {
        rest = rest.trim_start_matches([' ', '\n']);
        let line = source[..source.len() - rest.len()].matches('\n').count() + 1;
        let Some(first) = rest.chars().next() else { return Ok(tokens) };
        let fail = |what: &str| Err(format!("line {line}: {what}"));
        if let Some(inside) = rest.strip_prefix("(*") {
            let Some((comment, behind)) = inside.split_once("*)") else { return fail("a comment without end") };
            if comment.contains("(*") {
                return fail("a comment in a comment");
            }
            rest = behind;
            continue;
        }
        let (token, length) = match first {
            '#' => {
                let name = word(&rest[1..]);
                (Token::Local(name.to_owned()), 1 + name.len())
            }
            '"' | '\'' => {
                let Some(end) = rest[1..].find([first, '\n']).filter(|end| rest[1 + end..].starts_with(first)) else {
                    return fail("a quote without end");
                };
                let inside = rest[1..=end].to_owned();
                (if first == '"' { Token::Quoted(inside) } else { Token::Text(inside) }, end + 2)
            }
            '0'..='9' => {
                let number = number(rest).map_err(|what| format!("line {line}: {what}"))?;
                (Token::Number(number.to_owned()), number.len())
            }
            'A'..='Z' | 'a'..='z' | '_' => (Token::Word(word(rest).to_owned()), word(rest).len()),
            _ => match MARKS.into_iter().find(|mark| rest.starts_with(mark)) {
                Some(mark) if !rest.starts_with("//") => (Token::Mark(mark), mark.len()),
                _ => return fail(&format!("`{first}`")),
            },
        };
        if matches!(&token, Token::Local(name) | Token::Quoted(name) if !is_name(name)) {
            return fail(&format!("{token:?} is no name"));
        }
        rest = &rest[length..];
        tokens.push((token, line));
    }
}

/// The letters, digits and underscores at the beginning.
fn word(text: &str) -> &str {
    &text[..text.find(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).unwrap_or(text.len())]
}

/// `12`, `1.5`, `1.5E-3`: digits on both sides of a point, a sign in every exponent, an exponent behind a point only.
fn number(text: &str) -> Result<&str, String> {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let mut end = digits(0);
    if text[end..].starts_with('.') {
        let fraction = digits(end + 1);
        if fraction == 0 {
            return Err("a number ends with its point".to_owned());
        }
        end += 1 + fraction;
        if text[end..].starts_with(['E', 'e']) {
            let exponent = if text[end + 1..].starts_with(['+', '-']) { digits(end + 2) } else { 0 };
            if exponent == 0 {
                return Err("an exponent without sign or digits".to_owned());
            }
            end += 2 + exponent;
        }
    }
    let goes_on = text[end..].starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.' || c == '#');
    if goes_on { Err(format!("`{}` goes on", &text[..end])) } else { Ok(&text[..end]) }
}

/// A name that TIA takes without quotes: letters, digits and single underscores, at most 125.
pub fn is_name(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name == word(name)
        && !name.contains("__")
        && !name.ends_with('_')
        && name.len() <= 125
}

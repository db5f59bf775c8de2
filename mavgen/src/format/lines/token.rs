//! What single tokens are for plain lines.

use proc_macro2::{Delimiter, TokenTree};

pub(super) fn is(tree: &TokenTree, char: char) -> bool {
    matches!(tree, TokenTree::Punct(punct) if punct.as_char() == char)
}

pub(super) fn is_brackets(tree: &TokenTree) -> bool {
    matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket)
}

/// What `doc = "…"` says, if that can be the text of a comment.
pub(super) fn documentation(attribute: &[TokenTree]) -> Option<String> {
    let [TokenTree::Ident(name), equals, TokenTree::Literal(text)] = attribute else { return None };
    if name != "doc" || !is(equals, '=') {
        return None;
    }
    let text = text.to_string();
    let raw = text.strip_prefix('r').map(|raw| raw.trim_matches('#'));
    let content = raw.unwrap_or(&text).strip_prefix('"')?.strip_suffix('"')?;
    let plain = if raw.is_none() && content.contains('\\') { unescaped(content)? } else { content.to_owned() };
    (!plain.contains(['\n', '\r'])).then_some(plain)
}

/// A text without escapes; `None` if it has others than those of quotes and backslashes.
fn unescaped(text: &str) -> Option<String> {
    let (mut plain, mut chars) = (String::with_capacity(text.len()), text.chars());
    while let Some(char) = chars.next() {
        plain.push(match char {
            '\\' => chars.next().filter(|escaped| matches!(escaped, '"' | '\\'))?,
            _ => char,
        });
    }
    Some(plain)
}

/// Whether brackets hold rows, and not a few numbers.
pub(super) fn is_table(content: &[TokenTree]) -> bool {
    match content.iter().position(|tree| is(tree, ',')) {
        None | Some(0) => false,
        Some(1) => matches!(content.first(), Some(TokenTree::Group(_))),
        Some(_) => true,
    }
}

/// Whether what comes behind braces belongs to their line.
pub(super) fn continues(next: Option<&TokenTree>) -> bool {
    match next {
        Some(TokenTree::Punct(punct)) => matches!(punct.as_char(), ',' | ';' | '.' | '?' | '=' | '|'),
        Some(TokenTree::Ident(word)) => word == "else" || word == "as" || word == "in",
        _ => false,
    }
}

/// The operators of more than one character.
pub(super) fn is_operator(text: &str) -> bool {
    matches!(
        text,
        "::" | "->"
            | "=>"
            | ".."
            | "..="
            | "..."
            | "=="
            | "!="
            | "<="
            | ">="
            | "&&"
            | "||"
            | "<<"
            | ">>"
            | "<<="
            | ">>="
            | "+="
            | "-="
            | "*="
            | "/="
            | "%="
            | "^="
            | "&="
            | "|="
    )
}

/// Whether two characters begin or go on with an operator or a comment, if they stand together.
pub(super) fn joins(before: char, first: char) -> bool {
    match first {
        '=' => matches!(before, '=' | '!' | '<' | '>' | '+' | '-' | '*' | '/' | '%' | '^' | '&' | '|' | '.'),
        '>' => matches!(before, '>' | '-' | '='),
        '&' | '|' | '.' | ':' | '<' | '/' | '#' => before == first,
        '-' => before == '<',
        '*' => before == '/',
        _ => false,
    }
}

/// The keywords before a value, a pattern or a type: an operator behind them stands before that alone.
pub(super) fn is_before_value(word: &str) -> bool {
    matches!(
        word,
        "as" | "break"
            | "const"
            | "dyn"
            | "else"
            | "for"
            | "if"
            | "in"
            | "let"
            | "match"
            | "move"
            | "mut"
            | "ref"
            | "return"
            | "use"
            | "where"
            | "while"
    )
}

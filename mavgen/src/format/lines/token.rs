//! What single tokens are for plain lines.

/// A line of documentation, also as `#[doc = "…"]`, if that is what comes, and what is behind it.
pub(super) fn documentation<'t>(tokens: &'t [&'t str]) -> Option<([&'t str; 2], &'t [&'t str])> {
    match tokens {
        [line, behind @ ..] if line.starts_with("//") => Some((["", line], behind)),
        ["#", "[", "doc", "=", text, "]", behind @ ..] => {
            let text = text.strip_prefix('r').map_or(*text, |raw| raw.trim_matches('#'));
            let text = text.strip_prefix('"')?.strip_suffix('"')?;
            // `////` would be no documentation, and an escape stays one.
            let is_line = !text.starts_with('/') && !text.contains('\\');
            is_line.then_some((["///", text], behind))
        }
        _ => None,
    }
}

/// Whether it is an identifier, a keyword or the like.
pub(super) fn is_word(token: &str) -> bool {
    token.starts_with(|letter: char| letter == '_' || letter.is_alphabetic())
}

/// Whether brackets that were opened hold rows, and not a few numbers.
pub(super) fn is_table(content: &[&str]) -> bool {
    let mut open = 0_usize;
    for (at, token) in content.iter().enumerate() {
        match *token {
            "," if open == 0 => return at > 1,
            "(" | "[" | "{" => open += 1,
            ")" | "]" | "}" if open == 0 => return false,
            ")" | "]" | "}" => open -= 1,
            _ => {}
        }
    }
    false
}

/// Whether what comes behind braces belongs to their line.
pub(super) fn continues(next: Option<&str>) -> bool {
    matches!(next, Some("," | ";" | "." | "?" | "=" | "=>" | "|" | "else" | "as" | "in"))
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
pub(super) const BEFORE_VALUE: [&str; 17] = [
    "as", "break", "const", "dyn", "else", "for", "if", "in", "let", "match", "move", "mut", "ref", "return", "use",
    "where", "while",
];

//! Prose: from the text of the XML to rustdoc that is safe and readable.
//!
//! The text is hostile input. Whatever it contains, what comes out is paragraphs: no code block, no list, no HTML, no link
//! but a whole URL, nothing that a rustdoc or clippy lint objects to.

/// Characters of a line of documentation, without indentation and `/// `.
const WIDTH: usize = 96;

/// The paragraphs of a text as lines of markdown, separated by empty lines.
#[cfg(test)]
fn prose(text: &str) -> Vec<String> {
    prose_with(text, Vec::new())
}

/// The paragraphs of a text, the first of which goes on with safe words of our own.
pub(crate) fn prose_with(text: &str, mut more: Vec<String>) -> Vec<String> {
    let mut paragraphs = paragraphs(text);
    match paragraphs.first_mut() {
        Some(first) => first.append(&mut more),
        None => paragraphs.push(more),
    }
    let wrapped: Vec<Vec<String>> = paragraphs.iter().map(|words| wrap(words, WIDTH)).collect();
    wrapped.join(&String::new())
}

/// A text as one line of markdown: for tables and lists.
pub(crate) fn line(text: &str) -> String {
    words(text).join(" ")
}

/// The first sentence of a text as one line of markdown, for tables of contents.
pub(crate) fn first_sentence(text: &str) -> String {
    let first = paragraphs(text).into_iter().next().unwrap_or_default();
    let end = first.iter().position(|word| word.ends_with('.')).map_or(first.len(), |at| at + 1);
    first.get(..end).unwrap_or_default().join(" ")
}

/// Breaks safe words into lines; no line begins with what markdown takes for the start of a block.
pub(crate) fn wrap(words: &[String], width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut filled = 0;
    for word in words {
        filled += 1 + word.chars().count();
        match lines.last_mut().filter(|_| filled <= width) {
            Some(line) => {
                line.push(' ');
                line.push_str(word);
            }
            None => {
                let first = not_a_block(word);
                filled = first.chars().count();
                lines.push(first);
            }
        }
    }
    lines
}

/// The words of a text, made safe.
pub(crate) fn words(text: &str) -> Vec<String> {
    text.split_whitespace().map(safe_word).filter(|word| !word.is_empty()).collect()
}

/// The paragraphs of a text (separated by blank lines), as safe words.
fn paragraphs(text: &str) -> Vec<Vec<String>> {
    let mut paragraphs = vec![Vec::new()];
    for line in text.lines() {
        match paragraphs.last_mut() {
            Some(open) if !line.trim().is_empty() => open.extend(words(line)),
            _ => paragraphs.push(Vec::new()),
        }
    }
    paragraphs.retain(|paragraph| !paragraph.is_empty());
    paragraphs
}

/// One word without anything that markdown, rustdoc or the compiler would act on.
fn safe_word(word: &str) -> String {
    if word.bytes().all(|byte| byte.is_ascii_alphanumeric() || b".,;!?()'\"-+%=".contains(&byte)) {
        return word.to_owned();
    }
    let word: String = word.chars().filter(|&c| !is_invisible(c)).collect();
    let (before, inner, after) = punctuation(&word);
    if is_url(inner) {
        format!("{}<{inner}>{}", escape(before), escape(after))
    } else if is_constant(inner) {
        format!("{}`{inner}`{}", escape(before), escape(after))
    } else if word.contains("://") {
        // Neither a URL nor safe to escape: the lint on bare URLs looks behind backslashes.
        escape(&word.replace("://", ": //"))
    } else {
        escape(&word)
    }
}

/// Splits a word into opening punctuation, what it encloses, and closing punctuation.
fn punctuation(word: &str) -> (&str, &str, &str) {
    let inner = word.trim_start_matches(['(', '[', '{', '"', '\'', '<']);
    let before = word.strip_suffix(inner).unwrap_or_default();
    let core = inner.trim_end_matches([')', ']', '}', '"', '\'', '>', '.', ',', ';', ':', '!', '?']);
    (before, core, inner.strip_prefix(core).unwrap_or_default())
}

fn is_url(word: &str) -> bool {
    let rest = word.strip_prefix("https://").or_else(|| word.strip_prefix("http://"));
    rest.is_some_and(|rest| {
        let allowed = |c: char| c.is_ascii_alphanumeric() || "-._~:/?#@!$&'*+,;=%".contains(c);
        rest.starts_with(|c: char| c.is_ascii_alphanumeric()) && rest.chars().all(allowed)
    })
}

/// `MAV_CMD_NAV_LAND`, `UINT16_MAX`: shown as code.
fn is_constant(word: &str) -> bool {
    let letters = |part: &str| part.bytes().all(|c| c.is_ascii_uppercase() || c.is_ascii_digit()) && !part.is_empty();
    word.contains('_') && word.starts_with(|c: char| c.is_ascii_uppercase()) && word.split('_').all(letters)
}

/// Puts a backslash before every character that means something inside a line of markdown.
fn escape(word: &str) -> String {
    let mut escaped = String::with_capacity(word.len());
    let mut before = None;
    let mut letters = word.chars().peekable();
    while let Some(c) = letters.next() {
        // An underscore inside a word is one.
        let inside = [before, letters.peek().copied()].iter().all(|next| next.is_some_and(char::is_alphanumeric));
        before = Some(c);
        if "\\`*[]<>&~|$".contains(c) || c == '_' && !inside {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

/// Escapes a word that would open a list, a heading or a rule at the start of a line.
fn not_a_block(word: &str) -> String {
    let number = word.trim_start_matches(|c: char| c.is_ascii_digit());
    let opens_list = number.len() < word.len() && number.starts_with(['.', ')']);
    if opens_list {
        let digits = word.len() - number.len();
        format!("{}\\{number}", word.get(..digits).unwrap_or_default())
    } else if word.starts_with(['-', '+', '#', '=', ':']) {
        format!("\\{word}")
    } else {
        word.to_owned()
    }
}

/// Control characters and those that turn the direction of text, which the compiler refuses in comments.
fn is_invisible(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}')
}

#[cfg(test)]
mod tests;

//! Plain lines: one for each item, statement, field and match arm, indented by its braces and as long as it is.
//!
//! A walk over the tokens that parses nothing. Where it has to guess, as with `<`, a wrong guess is ugly and not wrong: two tokens
//! that would read as another are never without a space between them.

mod token;

use std::iter::repeat_n;
use std::mem::take;

use crate::collect::CollectVec as _;
use crate::tokens::TokenStream;
use token::{BEFORE_VALUE, continues, documentation, is_table, is_word, joins};

/// The text of a file made of these items.
pub(super) fn lines(items: &TokenStream) -> String {
    let tokens = items.iter().collect_vec();
    let out = String::with_capacity(items.len() + items.len() / 2);
    let mut lines = Lines { out, indent: 0, last: Last::Nothing, tight: true, open: Open::default() };
    lines.block(&mut Trees(&tokens));
    lines.out
}

/// The tokens that are left.
struct Trees<'t>(&'t [&'t str]);

struct Lines {
    out: String,
    indent: usize,
    /// What the next token follows.
    last: Last,
    /// The next token follows it without a space, if it is nothing special.
    tight: bool,
    open: Open,
}

/// What a token follows.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Last {
    /// The start of a line, or of a group.
    Nothing,
    Fn,
    /// A word that is no value, like `as`, or a lifetime.
    Keyword,
    /// A word of which nothing more is known: `<` behind it compares.
    Word,
    /// A word that can have generics: `Option`, `impl`, the name of a function.
    Generic,
    Literal,
    /// A group, the `>` of generics, or `?`.
    Close,
    Operator,
}

/// What is open in a group.
#[derive(Default)]
struct Open {
    /// Generics, a `<` each.
    generics: usize,
    /// The parameters of a closure.
    closure: bool,
}

impl<'t> Trees<'t> {
    fn next(&mut self) -> Option<&'t str> {
        let (first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(first)
    }

    /// The next one, if there is one in this group.
    fn peek(&self) -> Option<&'t str> {
        self.0.first().copied().filter(|token| !matches!(*token, ")" | "]" | "}"))
    }
}

impl Lines {
    /// What is in a group or in a file, line by line.
    fn block(&mut self, trees: &mut Trees<'_>) {
        while trees.peek().is_some() {
            self.indentation();
            (self.last, self.tight, self.open) = (Last::Nothing, true, Open::default());
            if !self.attribute(trees) {
                self.line(trees);
            }
            self.out.push('\n');
        }
    }

    fn indentation(&mut self) {
        self.out.extend(repeat_n("    ", self.indent));
    }

    /// Writes documentation or an attribute, if that is what comes.
    fn attribute(&mut self, trees: &mut Trees<'_>) -> bool {
        if let Some((text, behind)) = documentation(trees.0) {
            self.out.extend(text);
            trees.0 = behind;
            return true;
        }
        let start = match trees.0 {
            ["#", "[", ..] => 2,
            ["#", "!", "[", ..] => 3,
            _ => return false,
        };
        (0..start).for_each(|_| self.out.extend(trees.next()));
        self.enclosed(trees, false);
        true
    }

    /// Writes up to what ends a line.
    fn line(&mut self, trees: &mut Trees<'_>) {
        while let Some(token) = trees.peek() {
            trees.next();
            self.token(token, trees);
            let ends = match token {
                ";" => true,
                "," => self.open.generics == 0 && !self.open.closure,
                "{" => !continues(trees.peek()),
                _ => false,
            };
            if ends {
                return;
            }
        }
    }

    /// Writes a token, and all of the group that it opens.
    fn token(&mut self, token: &str, behind: &mut Trees<'_>) {
        match token.as_bytes() {
            [b'(' | b'[' | b'{'] => self.group(token, behind),
            [b'/', b'/', ..] => {
                // Nothing stands behind a comment.
                self.out.extend([" ", token, "\n"]);
                self.indentation();
                self.tight = true;
            }
            [b'0'..=b'9' | b'"', ..] => self.literal(token),
            [.., b'\''] => self.literal(token),
            [.., b'"' | b'#'] if token.len() > 1 => self.literal(token),
            [b'\'', ..] => self.word(token),
            _ if is_word(token) => self.word(token),
            [b'-', b'0'..=b'9', ..] => self.literal(token),
            _ => self.operator(token, behind.peek()),
        }
    }

    fn word(&mut self, word: &str) {
        self.space(!self.tight);
        self.out.push_str(word);
        self.last = match word {
            "fn" => Last::Fn,
            "impl" => Last::Generic,
            _ if word.starts_with('\'') || BEFORE_VALUE.contains(&word) => Last::Keyword,
            _ if self.last == Last::Fn || word.starts_with(char::is_uppercase) => Last::Generic,
            _ => Last::Word,
        };
        self.tight = false;
    }

    fn literal(&mut self, literal: &str) {
        // `#"` begins a string of another kind, and `<-` is an operator.
        self.space(!self.tight || self.out.ends_with('#') || self.out.ends_with('<') && literal.starts_with('-'));
        self.out.push_str(literal);
        (self.last, self.tight) = (Last::Literal, false);
    }

    fn space(&mut self, wanted: bool) {
        if wanted {
            self.out.push(' ');
        }
    }

    fn operator(&mut self, operator: &str, behind: Option<&str>) {
        let would_join = self.would_join(operator, behind);
        let (before, behind, last) = self.stand(operator);
        self.space(!before || would_join);
        self.out.push_str(operator);
        (self.last, self.tight) = (last, behind);
    }

    /// How an operator stands: whether no space is before it, whether none is behind it, and what it is to what follows. Notes
    /// the generics and closures that it opens or closes.
    fn stand(&mut self, operator: &str) -> (bool, bool, Last) {
        let (is_behind_value, open) = (self.last.is_value(), &mut self.open);
        let prefix = (self.tight, true, Last::Operator);
        match operator {
            "," | ";" | ":" => (true, false, Last::Operator),
            "." => (true, true, Last::Operator),
            ".." | "..=" | "..." | "::" | "!" if is_behind_value => (true, true, Last::Operator),
            "?" if is_behind_value => (true, false, Last::Close),
            "<" if !matches!(self.last, Last::Word | Last::Literal | Last::Close) => {
                open.generics += 1;
                (self.tight || self.last == Last::Generic, true, Last::Operator)
            }
            ">" | ">>" if open.generics >= operator.len() => {
                open.generics -= operator.len();
                (true, false, Last::Close)
            }
            "|" if open.closure => {
                open.closure = false;
                (true, false, Last::Operator)
            }
            "|" if !is_behind_value => {
                open.closure = true;
                prefix
            }
            "&" | "&&" | "*" | "-" if !is_behind_value => prefix,
            "!" | "?" | "#" | "$" | "::" | ".." | "..=" | "..." => prefix,
            _ => (self.tight, false, Last::Operator),
        }
    }

    /// Whether an operator would read otherwise right behind what was written last.
    fn would_join(&self, operator: &str, behind: Option<&str>) -> bool {
        let before = self.out.as_bytes().last().map_or(' ', |byte| char::from(*byte));
        match self.last {
            // Two that close generics may stand together.
            Last::Close => false,
            // `1.` is a number, and `1.max` is not.
            Last::Literal if operator == "." => {
                before == '.' || before.is_alphanumeric() && !behind.is_some_and(is_word)
            }
            _ => operator.chars().next().is_some_and(|first| joins(before, first)),
        }
    }

    /// Writes a group, whose start was taken already.
    fn group(&mut self, start: &str, content: &mut Trees<'_>) {
        let is_called = self.last.is_value() || self.last == Last::Fn;
        self.space(!self.tight && (start == "{" || !is_called));
        let has_lines = match start {
            "{" => !self.out.ends_with("::"),
            "[" => is_table(content.0),
            _ => false,
        };
        let outside = take(&mut self.open);
        self.out.push_str(start);
        self.enclosed(content, has_lines);
        self.open = outside;
    }

    /// What a group has, on lines of its own or on the same line, and its end.
    fn enclosed(&mut self, content: &mut Trees<'_>, has_lines: bool) {
        (self.last, self.tight) = (Last::Nothing, true);
        if has_lines && content.peek().is_some() {
            self.out.push('\n');
            self.indent += 1;
            self.block(content);
            self.indent -= 1;
            self.indentation();
        }
        while let Some(token) = content.peek() {
            content.next();
            self.token(token, content);
        }
        self.out.extend(content.next());
        (self.last, self.tight) = (Last::Close, false);
    }
}

impl Last {
    /// Whether an operator behind it stands between two values.
    fn is_value(self) -> bool {
        matches!(self, Self::Word | Self::Generic | Self::Literal | Self::Close)
    }
}

#[cfg(test)]
mod tests;

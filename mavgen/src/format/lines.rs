//! Plain lines: one for each item, statement, field and match arm, indented by its braces and as long as it is.
//!
//! A walk over the tokens that parses nothing. Where it has to guess, as with `<`, a wrong guess is ugly and not wrong: two tokens
//! that would read as another are never without a space between them.

mod token;

use std::fmt::{Display, Write};
use std::iter::repeat_n;
use std::mem::take;

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, TokenStream, TokenTree};

use token::{continues, documentation, is, is_before_value, is_brackets, is_operator, is_table, joins};

type Trees = std::vec::IntoIter<TokenTree>;

/// The text of a file made of these items.
pub(super) fn lines(items: TokenStream) -> String {
    let mut lines = Lines { out: String::new(), indent: 0, last: Last::Nothing, tight: true, open: Open::default() };
    lines.block(trees(items));
    lines.out
}

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
    /// A word that is no value: `as`, `in`.
    Keyword,
    /// A word before which nothing more is known: `<` compares it.
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

/// How an operator stands: what is before and behind it follows without a space.
struct Stand {
    before: bool,
    behind: bool,
    last: Last,
}

impl Lines {
    /// What is in braces or in a file, line by line.
    fn block(&mut self, mut trees: Trees) {
        while !trees.as_slice().is_empty() {
            self.indentation();
            (self.last, self.tight, self.open) = (Last::Nothing, true, Open::default());
            if !self.attribute(&mut trees) {
                self.line(&mut trees);
            }
            self.out.push('\n');
        }
    }

    fn indentation(&mut self) {
        self.out.extend(repeat_n("    ", self.indent));
    }

    /// Writes an attribute, if that is what comes.
    fn attribute(&mut self, trees: &mut Trees) -> bool {
        let sign = match trees.as_slice() {
            [first, second, ..] if is(first, '#') && is_brackets(second) => "#",
            [first, second, third, ..] if is(first, '#') && is(second, '!') && is_brackets(third) => "#!",
            _ => return false,
        };
        let Some(TokenTree::Group(group)) = trees.nth(sign.len()) else { return true };
        let content = self::trees(into_stream(group));
        match (documentation(content.as_slice()), sign) {
            (Some(text), "#!") => self.out.extend(["//!", &text]),
            // `////` would be no documentation.
            (Some(text), _) if !text.starts_with('/') => self.out.extend(["///", &text]),
            _ => {
                self.out.push_str(sign);
                self.enclosed("[", content, "]");
            }
        }
        true
    }

    /// Writes up to what ends a line.
    fn line(&mut self, trees: &mut Trees) {
        while let Some(tree) = trees.next() {
            let ends = match &tree {
                TokenTree::Punct(punct) => match punct.as_char() {
                    ';' => true,
                    ',' => self.open.generics == 0 && !self.open.closure,
                    _ => false,
                },
                TokenTree::Group(group) => {
                    group.delimiter() == Delimiter::Brace && !continues(trees.as_slice().first())
                }
                _ => false,
            };
            self.tree(tree, trees);
            if ends {
                return;
            }
        }
    }

    /// Writes a token, and those behind it that are one operator with it.
    fn tree(&mut self, tree: TokenTree, behind: &mut Trees) {
        match tree {
            TokenTree::Ident(word) => self.word(&word),
            TokenTree::Literal(literal) => self.literal(&literal),
            TokenTree::Punct(first) => self.operator(&first, behind),
            TokenTree::Group(group) => self.group(group),
        }
    }

    fn word(&mut self, word: &Ident) {
        self.space(!self.tight);
        let start = self.written(word);
        let text = self.out.get(start..).unwrap_or_default();
        self.last = match text {
            "fn" => Last::Fn,
            "impl" => Last::Generic,
            // The name of a lifetime.
            _ if self.out.get(..start).is_some_and(|before| before.ends_with('\'')) => Last::Keyword,
            _ if self.last == Last::Fn || text.starts_with(char::is_uppercase) => Last::Generic,
            _ if is_before_value(text) => Last::Keyword,
            _ => Last::Word,
        };
        self.tight = false;
    }

    fn literal(&mut self, literal: &Literal) {
        // `#"` begins a string of another kind.
        self.space(!self.tight || self.out.ends_with('#'));
        self.written(literal);
        (self.last, self.tight) = (Last::Literal, false);
    }

    /// Writes something, and says where it begins.
    fn written(&mut self, token: impl Display) -> usize {
        let start = self.out.len();
        // Writing into a String cannot fail.
        let _ = write!(self.out, "{token}");
        start
    }

    fn space(&mut self, wanted: bool) {
        if wanted {
            self.out.push(' ');
        }
    }

    fn operator(&mut self, first: &Punct, behind: &mut Trees) {
        let (start, closes) = (self.out.len(), first.as_char() == '>' && self.open.generics > 0);
        self.out.push(first.as_char());
        let mut spacing = first.spacing();
        while spacing == Spacing::Joint
            && !closes
            && let Some(TokenTree::Punct(next)) = behind.as_slice().first()
        {
            spacing = next.spacing();
            self.out.push(next.as_char());
            if !is_operator(self.out.get(start..).unwrap_or_default()) {
                self.out.pop();
                break;
            }
            behind.next();
        }
        let stand = self.stand(start);
        if !stand.before || self.would_join(start, first.as_char(), behind.as_slice().first()) {
            self.out.insert(start, ' ');
        }
        (self.last, self.tight) = (stand.last, stand.behind);
    }

    /// How the operator stands that was just written, and what it opens or closes.
    fn stand(&mut self, start: usize) -> Stand {
        let (is_behind_value, open) = (self.last.is_value(), &mut self.open);
        let of = |before, behind| Stand { before, behind, last: Last::Operator };
        let closing = |before| Stand { before, behind: false, last: Last::Close };
        let prefix = of(self.tight, true);
        match self.out.get(start..).unwrap_or_default() {
            "," | ";" | ":" => of(true, false),
            "." => of(true, true),
            ".." | "..=" | "..." | "::" if is_behind_value => of(true, true),
            "?" if is_behind_value => closing(true),
            "!" if is_behind_value => of(true, true),
            "<" if !matches!(self.last, Last::Word | Last::Literal | Last::Close) => {
                open.generics += 1;
                of(self.tight || self.last == Last::Generic, true)
            }
            ">" if open.generics > 0 => {
                open.generics -= 1;
                closing(true)
            }
            "|" if open.closure => {
                open.closure = false;
                of(true, false)
            }
            "|" if !is_behind_value => {
                open.closure = true;
                prefix
            }
            "&" | "&&" | "*" | "-" if !is_behind_value => prefix,
            "!" | "?" | "#" | "$" | "'" | "::" | ".." | "..=" | "..." => prefix,
            _ => of(self.tight, false),
        }
    }

    /// Whether the operator that begins at `start` would read otherwise right behind what is before it.
    fn would_join(&self, start: usize, first: char, behind: Option<&TokenTree>) -> bool {
        let before =
            start.checked_sub(1).and_then(|at| self.out.as_bytes().get(at)).map_or(' ', |byte| char::from(*byte));
        match self.last {
            // Two that close generics may stand together.
            Last::Close => false,
            // `1.` is a number, and `1.max` is not.
            Last::Literal if self.out.len() == start + 1 && first == '.' => {
                before == '.' || before.is_alphanumeric() && !matches!(behind, Some(TokenTree::Ident(_)))
            }
            _ => joins(before, first),
        }
    }

    fn group(&mut self, group: Group) {
        let (delimiter, content) = (group.delimiter(), self::trees(into_stream(group)));
        let is_call = self.last.is_value() || self.last == Last::Fn;
        match delimiter {
            // Nothing that is generated has one: it is an operand of a macro.
            Delimiter::None => return self.inline(content),
            Delimiter::Brace => self.space(!self.tight),
            _ => self.space(!self.tight && !is_call),
        }
        let outside = take(&mut self.open);
        match delimiter {
            Delimiter::Brace if self.out.ends_with("::") => self.enclosed("{", content, "}"),
            Delimiter::Brace => self.enclosed_lines("{", content, "}"),
            Delimiter::Bracket if is_table(content.as_slice()) => self.enclosed_lines("[", content, "]"),
            Delimiter::Bracket => self.enclosed("[", content, "]"),
            _ => self.enclosed("(", content, ")"),
        }
        self.open = outside;
    }

    /// What is in parentheses or brackets, on the same line.
    fn enclosed(&mut self, start: &str, content: Trees, end: &str) {
        self.out.push_str(start);
        (self.last, self.tight) = (Last::Nothing, true);
        self.inline(content);
        self.out.push_str(end);
        (self.last, self.tight) = (Last::Close, false);
    }

    /// What is in braces, on lines of its own.
    fn enclosed_lines(&mut self, start: &str, content: Trees, end: &str) {
        self.out.push_str(start);
        if !content.as_slice().is_empty() {
            self.out.push('\n');
            self.indent += 1;
            self.block(content);
            self.indent -= 1;
            self.indentation();
        }
        self.out.push_str(end);
        (self.last, self.tight) = (Last::Close, false);
    }

    fn inline(&mut self, mut trees: Trees) {
        while let Some(tree) = trees.next() {
            self.tree(tree, &mut trees);
        }
    }
}

impl Last {
    /// Whether an operator behind it stands between two values.
    fn is_value(self) -> bool {
        matches!(self, Self::Word | Self::Generic | Self::Literal | Self::Close)
    }
}

fn trees(stream: TokenStream) -> Trees {
    stream.into_iter().collect::<Vec<_>>().into_iter()
}

/// The content of a group, which is not copied, because nothing else holds it.
fn into_stream(group: Group) -> TokenStream {
    group.stream()
}

#[cfg(test)]
mod tests;

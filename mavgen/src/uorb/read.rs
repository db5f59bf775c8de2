//! A `.msg` file: from text to spanned syntax.

use super::comment;
use super::line::{self, Piece, Statement};
use super::syntax::{Comment, ConstantSyntax, FieldSyntax, Group, MsgFile};
use crate::diag::Diagnostics;
use crate::source::{FileId, Sources, Spanned};

/// Reads a `.msg` file.
///
/// Returns what could be understood: a line with a mistake is left out, and each is an error in `diagnostics`.
pub fn read(id: FileId, sources: &Sources, diagnostics: &mut Diagnostics) -> MsgFile {
    let file = MsgFile { id, about: Vec::new(), topics: Vec::new(), fields: Vec::new(), constants: Vec::new() };
    let text = sources.get(id).map(|source| source.text()).unwrap_or_default();
    let mut reader = Reader { file, before: Before::Begin(Vec::new()), diagnostics };
    let mut start = 0;
    for line in text.split('\n') {
        reader.line(Piece { file: id, text: line, start });
        start += line.len() + 1;
    }
    reader.blank();
    reader.file
}

/// The comment lines that stand directly before a line.
enum Before {
    /// All lines so far were comments: they are about the message, also if a field follows directly.
    Begin(Vec<String>),
    /// They belong to the field that follows.
    Lines { groups: Vec<Group>, lines: Vec<String> },
}

struct Reader<'d> {
    file: MsgFile,
    before: Before,
    diagnostics: &'d mut Diagnostics,
}

impl Reader<'_> {
    fn line(&mut self, line: Piece<'_>) {
        if let Some(topics) = line.text.strip_prefix("# TOPICS ") {
            return self.topics(Piece { text: topics, start: line.start + line.text.len() - topics.len(), ..line });
        }
        let (code, comment) = match line.text.split_once('#') {
            Some((code, comment)) => {
                (code, Some(Piece { text: comment, start: line.start + line.text.len() - comment.len(), ..line }))
            }
            None => (line.text, None),
        };
        let code = Piece { text: code, ..line };
        match (code.text.trim().is_empty(), comment) {
            (true, None) => self.blank(),
            (true, Some(comment)) => self.comment(comment),
            (false, comment) => self.statement(code, comment),
        }
    }

    fn topics(&mut self, names: Piece<'_>) {
        for name in names.text.split_whitespace() {
            let start = names.start + name.as_ptr().addr() - names.text.as_ptr().addr();
            let span = crate::source::Span::new(names.file, start..start + name.len());
            self.file.topics.push(Spanned::new(name.to_owned(), span));
        }
    }

    /// A blank line ends what the comment lines before it belong to.
    fn blank(&mut self) {
        match &mut self.before {
            Before::Begin(lines) if lines.is_empty() => {}
            Before::Begin(lines) => {
                self.file.about = std::mem::take(lines);
                self.before = Before::Lines { groups: Vec::new(), lines: Vec::new() };
            }
            Before::Lines { groups, lines } => {
                groups.clear();
                lines.clear();
            }
        }
    }

    fn comment(&mut self, comment: Piece<'_>) {
        match &mut self.before {
            Before::Begin(lines) => lines.push(comment.text.trim().to_owned()),
            Before::Lines { groups, lines } => {
                let (found, prose) = comment::read(comment.file, comment.text, comment.start, self.diagnostics);
                groups.extend(found);
                lines.push(prose.to_owned());
            }
        }
    }

    fn statement(&mut self, code: Piece<'_>, behind: Option<Piece<'_>>) {
        let mut comment =
            match std::mem::replace(&mut self.before, Before::Lines { groups: Vec::new(), lines: Vec::new() }) {
                Before::Begin(about) => {
                    self.file.about = about;
                    Comment::default()
                }
                Before::Lines { groups, lines } => Comment { groups, lines },
            };
        if let Some(behind) = behind {
            let (groups, prose) = comment::read(behind.file, behind.text, behind.start, self.diagnostics);
            comment.groups.extend(groups);
            if !prose.is_empty() {
                comment.lines.push(prose.to_owned());
            }
        }
        match line::read(code) {
            Ok(Statement::Field { element, array, name }) => {
                self.file.fields.push(FieldSyntax { element, array, name, comment });
            }
            Ok(Statement::Constant { element, name, value }) => {
                self.file.constants.push(ConstantSyntax { element, name, value, comment });
            }
            Err(problem) => self.diagnostics.push(problem),
        }
    }
}

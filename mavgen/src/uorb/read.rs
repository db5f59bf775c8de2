//! A `.msg` file: from text to spanned syntax.

use super::comment;
use super::line::{self, Statement};
use super::syntax::{Comment, ConstantSyntax, FieldSyntax, MsgFile};
use crate::diag::Diagnostics;
use crate::source::{FileId, Part, Sources};

/// Reads a `.msg` file.
///
/// Returns what could be understood: a line with a mistake is left out, and each is an error in `diagnostics`.
pub fn read(id: FileId, sources: &Sources, diagnostics: &mut Diagnostics) -> MsgFile {
    let file = MsgFile { id, about: Vec::new(), topics: Vec::new(), fields: Vec::new(), constants: Vec::new() };
    let text = sources.get(id).map(|source| source.text()).unwrap_or_default();
    let mut reader = Reader { file, at_begin: true, before: Comment::default(), diagnostics };
    let whole = Part::whole(id, text);
    text.split('\n').for_each(|line| reader.line(whole.with(line)));
    reader.blank();
    reader.file
}

struct Reader<'d> {
    file: MsgFile,
    /// All lines so far were comments: they are about the message, also if a field follows directly.
    at_begin: bool,
    /// The comment lines that stand directly before a line. They belong to the field that follows.
    before: Comment,
    diagnostics: &'d mut Diagnostics,
}

impl Reader<'_> {
    fn line(&mut self, line: Part<'_>) {
        if let Some(topics) = line.text.strip_prefix("# TOPICS ") {
            return self.file.topics.extend(line.with(topics).words().map(Part::to_spanned));
        }
        let (code, comment) = match line.split_once(|letter| letter == '#') {
            Some((code, comment)) => (code, Some(comment)),
            None => (line, None),
        };
        match (code.text.trim().is_empty(), comment) {
            (true, None) => self.blank(),
            (true, Some(comment)) if self.at_begin => self.before.lines.push(comment.text.trim().to_owned()),
            (true, Some(comment)) => {
                let prose = comment::read(comment, &mut self.before.groups, self.diagnostics);
                self.before.lines.push(prose.to_owned());
            }
            (false, comment) => self.statement(code, comment),
        }
    }

    /// A blank line ends what the comment lines before it belong to.
    fn blank(&mut self) {
        let before = std::mem::take(&mut self.before);
        if self.at_begin && !before.lines.is_empty() {
            self.file.about = before.lines;
            self.at_begin = false;
        }
    }

    fn statement(&mut self, code: Part<'_>, behind: Option<Part<'_>>) {
        if self.at_begin {
            self.blank();
            self.at_begin = false;
        }
        let mut comment = std::mem::take(&mut self.before);
        if let Some(behind) = behind {
            let prose = comment::read(behind, &mut comment.groups, self.diagnostics);
            comment.lines.extend((!prose.is_empty()).then(|| prose.to_owned()));
        }
        match line::read(code) {
            Ok(Statement::Field(field)) => self.file.fields.push(FieldSyntax { comment, ..field }),
            Ok(Statement::Constant(constant)) => self.file.constants.push(ConstantSyntax { comment, ..constant }),
            Err(problem) => self.diagnostics.push(problem),
        }
    }
}

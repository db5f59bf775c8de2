//! Unified diffs of bounded length.

use std::fmt;
use std::fs;
use std::path::Path;
use std::time::Duration;

use clap::builder::styling::{AnsiColor, Style};
use similar::{Change, ChangeTag, TextDiff};

/// Lines of a diff that are shown for one file.
const LINES_OF_A_FILE: usize = 60;

/// Lines that are shown altogether.
const LINES: usize = 400;

/// After so long the search for the shortest diff is given up, and a longer one is good enough.
const PATIENCE: Duration = Duration::from_secs(1);

/// Differences as a person reads them.
#[derive(Default)]
pub(super) struct Unified {
    text: String,
    shown: usize,
    /// Entries that there was no room for.
    left_out: usize,
}

impl Unified {
    /// Adds the diff from a file to what it should be.
    pub(super) fn file(&mut self, path: &Path, wanted: &str) {
        if self.is_full() {
            return;
        }
        let present = fs::read(path).map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).unwrap_or_default();
        // Where all lines end as on Windows, that is no difference of each.
        let (present, line_ends) = match present.replace("\r\n", "\n") {
            unix if present.len() > unix.len() && !lone(&present) => (unix, " (with CRLF line ends)"),
            _ => (present, ""),
        };
        let diff = TextDiff::configure().timeout(PATIENCE).diff_lines(present.as_str(), wanted);
        let diff = diff.unified_diff();
        let mut lines = Vec::new();
        for hunk in diff.iter_hunks() {
            lines.push(styled(AnsiColor::Cyan.on_default(), format_args!("{}", hunk.header())));
            lines.extend(hunk.iter_changes().map(change));
        }
        let bold = Style::new().bold();
        let head = [
            styled(bold, format_args!("--- {}{line_ends}", path.display())),
            styled(bold, format_args!("+++ {} (as mavgen writes it)", path.display())),
        ];
        let room = LINES_OF_A_FILE.min(LINES - self.shown);
        for line in head.iter().chain(lines.iter().take(room)) {
            self.push(line);
        }
        if lines.len() > room {
            self.push(&format!("... {} more lines", lines.len() - room));
        }
    }

    /// Adds a line on a file.
    pub(super) fn line(&mut self, line: fmt::Arguments<'_>) {
        if !self.is_full() {
            self.push(&line.to_string());
        }
    }

    /// All of it, with a last line that says what was left out.
    pub(super) fn finish(mut self) -> String {
        if self.left_out > 0 {
            let left_out = self.left_out;
            self.push(&format!("... and {left_out} more files"));
        }
        self.text
    }

    /// Whether there is no room for one more file, which is counted then.
    fn is_full(&mut self) -> bool {
        let full = self.shown >= LINES;
        self.left_out += usize::from(full);
        full
    }

    fn push(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
        self.shown += 1;
    }
}

/// Whether some line ends as elsewhere.
fn lone(text: &str) -> bool {
    text.lines().count() > text.matches("\r\n").count()
}

fn change(change: Change<&str>) -> String {
    let line: String = change.value().trim_end_matches('\n').chars().map(visible).collect();
    let end = if change.missing_newline() { "\n\\ No newline at end of file" } else { "" };
    match change.tag() {
        ChangeTag::Equal => format!(" {line}{end}"),
        ChangeTag::Delete => styled(AnsiColor::Red.on_default(), format_args!("-{line}")) + end,
        ChangeTag::Insert => styled(AnsiColor::Green.on_default(), format_args!("+{line}")) + end,
    }
}

/// A character, or the picture of a control character: what line ends like those of Windows differ in has to be seen.
fn visible(c: char) -> char {
    let picture = (c.is_ascii_control() && c != '\t').then(|| char::from_u32(0x2400 + u32::from(c).min(0x21)));
    picture.flatten().unwrap_or(c)
}

fn styled(style: Style, text: fmt::Arguments<'_>) -> String {
    format!("{style}{text}{style:#}")
}

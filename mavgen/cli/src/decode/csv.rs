//! One message as a table: a row for each frame, a column for each value that it can hold.
//!
//! A column is named by the way to its value in JSON, `voltages[0]` or `escs[1].status.rpm`, with the unit behind it in
//! parentheses. What the sender does not know, and what a frame does not have, is empty; a secret key is one column, that
//! says `secret`.

use csv::WriterBuilder;
use mavgen::decode::Contents;

use super::columns::{Column, Columns, cells};
use super::received::Received;
use super::text::plain;

/// The columns in front of those of the message.
const FRAME: [&str; 5] = ["time", "unix_time (s)", "system_id", "component_id", "sequence"];

impl Columns {
    /// The first row.
    pub(super) fn head(&self) -> String {
        let names = self.columns.iter().map(|Column { path: (_, name), units, .. }| match units {
            Some(units) => format!("{name} ({units})"),
            None => name.clone(),
        });
        row(FRAME.map(str::to_owned).into_iter().chain(names))
    }

    /// The row of a frame.
    pub(super) fn row(&self, received: &Received<'_>, contents: &Contents) -> String {
        let cells = cells(contents);
        let Received { frame, time } = received;
        let unix_time = time.map(|time| time.unix()).unwrap_or_default();
        let time = time.map(|time| time.to_string()).unwrap_or_default();
        let sender = [frame.system_id().to_string(), frame.component_id().to_string(), frame.sequence().to_string()];
        let head = [time, unix_time].into_iter().chain(sender);
        let cell = |column: &Column| cells.get(&column.path).map(|node| plain(node)).unwrap_or_default();
        row(head.chain(self.columns.iter().map(cell)))
    }
}

/// Whether a file begins as these tables do.
pub(super) fn is_head(line: &str) -> bool {
    let head = row(FRAME.map(str::to_owned).into_iter());
    line.strip_prefix(head.trim_end()).is_some_and(|rest| rest.is_empty() || rest.starts_with([',', '\r', '\n']))
}

/// A line, with quotes where a cell needs them.
fn row(cells: impl Iterator<Item = String>) -> String {
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    // Writing into memory cannot fail.
    let _ = writer.write_record(cells.map(String::into_bytes));
    let line = writer.into_inner().unwrap_or_default();
    String::from_utf8_lossy(&line).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_known_by_their_head() {
        let head = row(FRAME.map(str::to_owned).into_iter());
        for line in [&head, "time,unix_time (s),system_id,component_id,sequence,roll\n", head.trim_end()] {
            assert!(is_head(line), "{line}");
        }
        for line in ["", "time,roll", "time,unix_time (s),system_id,component_id,sequences"] {
            assert!(!is_head(line), "{line}");
        }
    }
}

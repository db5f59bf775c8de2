//! One message as a table: a row for each frame, a column for each value that it can hold.
//!
//! A column is named by the way to its value in JSON, `voltages[0]` or `escs[1].status.rpm`, with the unit behind it in
//! parentheses. What the sender does not know, and what a frame does not have, is empty; a secret key is one column, that
//! says `secret`.

use std::fs::File;
use std::io::{self, BufRead as _, BufReader, BufWriter, Read as _, Write as _};

use csv::WriterBuilder;
use mavgen::decode::Contents;

use super::columns::{Column, Columns, cells};
use super::folder::Table;
use super::received::Received;
use super::text::plain;

/// The columns in front of those of the message.
const FRAME: [&str; 5] = ["time", "unix_time (s)", "system_id", "component_id", "sequence"];

/// No first row is longer, in bytes.
const LONGEST: u64 = 1 << 20;

/// A table in a file.
pub(super) struct Csv(BufWriter<File>);

impl Table for Csv {
    const EXTENSION: &str = "csv";
    type Error = io::Error;

    fn is_own(file: File) -> io::Result<bool> {
        let mut head = Vec::new();
        BufReader::new(file.take(LONGEST)).read_until(b'\n', &mut head)?;
        Ok(is_head(&String::from_utf8_lossy(&head)))
    }

    fn begin(file: File, _: &str, columns: &Columns) -> io::Result<Self> {
        let mut file = BufWriter::new(file);
        file.write_all(columns.head().as_bytes())?;
        Ok(Self(file))
    }

    fn add(&mut self, columns: &Columns, received: &Received<'_>, contents: &Contents) -> io::Result<()> {
        self.0.write_all(columns.row(received, contents).as_bytes())
    }

    fn finish(mut self) -> io::Result<()> {
        self.0.flush()
    }
}

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
fn is_head(line: &str) -> bool {
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

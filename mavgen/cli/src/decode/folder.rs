//! Tables in a folder: a file for each message, `ATTITUDE.csv`.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, BufRead, BufReader, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

use mavgen::Failure;
use mavgen::decode::Contents;

use super::columns::Columns;
use super::csv::is_head;
use super::received::Received;

/// The tables of a run.
pub(super) struct Folder {
    path: PathBuf,
    /// By the name of the message.
    tables: BTreeMap<String, Table>,
}

struct Table {
    columns: Columns,
    /// Made when the first row comes.
    file: Option<BufWriter<File>>,
}

impl Folder {
    /// A folder for these messages. Nothing is written before there is something to write.
    pub(super) fn new(path: &Path, messages: impl Iterator<Item = (String, Columns)>) -> Self {
        let tables = messages.map(|(name, columns)| (name, Table { columns, file: None }));
        Self { path: path.to_owned(), tables: tables.collect() }
    }

    /// Adds a row to the table of a message.
    pub(super) fn add(&mut self, name: &str, received: &Received<'_>, contents: &Contents) -> Result<(), Failure> {
        let Some(Table { columns, file }) = self.tables.get_mut(name) else { return Ok(()) };
        let path = self.path.join(format!("{name}.csv"));
        let refused = |error: io::Error| Failure::Usage(format!("{}: {error}", path.display()));
        let file = match file {
            Some(file) => file,
            None => {
                let mut made = create(&self.path, &path).map_err(refused)?;
                made.write_all(columns.head().as_bytes()).map_err(refused)?;
                file.insert(made)
            }
        };
        file.write_all(columns.row(received, contents).as_bytes()).map_err(refused)
    }

    /// Writes what is left; how many files there are.
    pub(super) fn finish(self) -> Result<usize, Failure> {
        let mut count = 0;
        for (name, table) in self.tables {
            let Some(mut file) = table.file else { continue };
            let refused = |error: io::Error| Failure::Usage(format!("{name}.csv: {error}"));
            file.flush().map_err(refused)?;
            count += 1;
        }
        Ok(count)
    }
}

/// A new file, in place of one of an earlier run; no other file is written over.
fn create(folder: &Path, path: &Path) -> io::Result<BufWriter<File>> {
    fs::create_dir_all(folder)?;
    match File::open(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
        Err(_) => {}
        Ok(file) => {
            let mut head = Vec::new();
            BufReader::new(file).read_until(b'\n', &mut head)?;
            if !is_head(&String::from_utf8_lossy(&head)) {
                return Err(io::Error::other(
                    "`mavgen decode` did not write this file: remove it, or choose another folder",
                ));
            }
        }
    }
    File::create(path).map(BufWriter::new)
}

//! Tables in a folder: a file for each message, `ATTITUDE.csv`. Each is called `ATTITUDE.csv.part` until all of them are whole, so
//! that no reader finds a part of one, and after an error there is what was there before.

use std::collections::BTreeMap;
use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use mavgen::Failure;
use mavgen::decode::Contents;

use super::columns::Columns;
use super::received::Received;

/// A kind of table, and one of them that is written.
pub(super) trait Table: Sized {
    /// What the names of its files end with, after a dot.
    const EXTENSION: &str;
    /// What the writing of it says.
    type Error: Display;

    /// Whether a file is a table of this kind that `mavgen decode` wrote.
    fn is_own(file: File) -> io::Result<bool>;

    /// Begins the table of a message.
    fn begin(file: File, message: &str, columns: &Columns) -> Result<Self, Self::Error>;

    /// Adds a row.
    fn add(&mut self, columns: &Columns, received: &Received<'_>, contents: &Contents) -> Result<(), Self::Error>;

    /// Writes what is left.
    fn finish(self) -> Result<(), Self::Error>;
}

/// The tables of a run, of any kind.
pub(super) trait Tables {
    /// Adds a row to the table of a message.
    fn add(&mut self, name: &str, received: &Received<'_>, contents: &Contents) -> Result<(), Failure>;

    /// Writes what is left; how many files there are.
    fn finish(self: Box<Self>) -> Result<usize, Failure>;
}

/// The tables of a run.
pub(super) struct Folder<T> {
    path: PathBuf,
    /// By the name of the message: its columns, and the table since its first row.
    tables: BTreeMap<String, (Columns, Option<(Unfinished, T)>)>,
}

impl<T: Table> Folder<T> {
    /// A folder for these messages. Nothing is written before there is something to write.
    pub(super) fn new(path: &Path, messages: Vec<(String, Columns)>) -> Self {
        let tables = messages.into_iter().map(|(name, columns)| (name, (columns, None)));
        Self { path: path.to_owned(), tables: tables.collect() }
    }
}

impl<T: Table> Tables for Folder<T> {
    fn add(&mut self, name: &str, received: &Received<'_>, contents: &Contents) -> Result<(), Failure> {
        let Some((columns, begun)) = self.tables.get_mut(name) else { return Ok(()) };
        let path = self.path.join(format!("{name}.{}", T::EXTENSION));
        let (_, table) = match begun {
            Some(begun) => begun,
            None => {
                let (unfinished, file) = Unfinished::create(&path, T::is_own).map_err(|error| refused(&path, error))?;
                let table = T::begin(file, name, columns).map_err(|error| refused(&path, error))?;
                begun.insert((unfinished, table))
            }
        };
        table.add(columns, received, contents).map_err(|error| refused(&path, error))
    }

    fn finish(self: Box<Self>) -> Result<usize, Failure> {
        let mut whole = Vec::new();
        for (unfinished, table) in self.tables.into_values().filter_map(|(_, begun)| begun) {
            table.finish().map_err(|error| refused(&unfinished.path, error))?;
            whole.push(unfinished);
        }
        let count = whole.len();
        whole.into_iter().try_for_each(Unfinished::finish)?;
        Ok(count)
    }
}

/// A table that is not whole: removed unless it is finished.
struct Unfinished {
    path: PathBuf,
    part: PathBuf,
}

impl Unfinished {
    /// A new file, for the place of one of an earlier run; no other file is written over.
    fn create(path: &Path, is_own: impl Fn(File) -> io::Result<bool>) -> io::Result<(Self, File)> {
        path.parent().map_or(Ok(()), fs::create_dir_all)?;
        let is_foreign = match File::open(path) {
            Ok(file) => !is_own(file)?,
            Err(error) if error.kind() == ErrorKind::NotFound => false,
            Err(error) => return Err(error),
        };
        if is_foreign {
            let text = "`mavgen decode` did not write this file: remove it, or choose another folder";
            return Err(io::Error::other(text));
        }
        let mut part = path.as_os_str().to_owned();
        part.push(".part");
        let part = PathBuf::from(part);
        let file = File::create(&part)?;
        Ok((Self { path: path.to_owned(), part }, file))
    }

    fn finish(self) -> Result<(), Failure> {
        fs::rename(&self.part, &self.path).map_err(|error| refused(&self.path, error))
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        // It is gone if the table is in place.
        let _ = fs::remove_file(&self.part);
    }
}

fn refused(path: &Path, error: impl Display) -> Failure {
    Failure::Usage(format!("{}: {error}", path.display()))
}

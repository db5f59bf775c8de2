//! What the program reads: a file, or standard input.

use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::progress;

/// Whether a name means standard input where something is read, and standard output where it is written.
pub(crate) fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// The output if nobody names one: a file beside the input with this extension; for standard input, standard output.
pub(crate) fn named_after(read: &Path, extension: &str) -> PathBuf {
    if is_standard(read) { read.to_owned() } else { read.with_extension(extension) }
}

/// Bytes that are read from their start to their end.
pub(crate) struct Input {
    /// What users call it.
    pub(crate) name: String,
    /// Zero where nobody knows how many bytes come.
    pub(crate) length: u64,
    pub(crate) bytes: Box<dyn Read>,
}

impl Input {
    /// Opens a file, or standard input.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        if is_standard(path) {
            return Ok(Self { name: "standard input".to_owned(), length: 0, bytes: Box::new(io::stdin()) });
        }
        let refused = |error| Failure::file(path, error);
        let file = File::open(path).map_err(refused)?;
        let metadata = file.metadata().map_err(refused)?;
        if metadata.is_dir() {
            return Err(Failure::file(path, "is a folder; give the name of a file"));
        }
        Ok(Self { name: path.display().to_string(), length: metadata.len(), bytes: Box::new(file) })
    }

    /// All of it in memory, with a bar if it is long.
    pub(crate) fn read_whole(self) -> Result<Vec<u8>, Failure> {
        let bar = progress::bar(self.length);
        let mut bytes = Vec::with_capacity(usize::try_from(self.length).unwrap_or_default());
        let read = bar.wrap_read(self.bytes).read_to_end(&mut bytes);
        bar.finish_and_clear();
        read.map(|_| bytes).map_err(|error| Failure::with(self.name, error))
    }
}

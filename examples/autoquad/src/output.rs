//! What the program writes: files that are whole or not there, recordings that grow, devices, and standard output.

#[cfg(test)]
mod tests;

use std::fmt::Display;
use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, BufWriter, Error, ErrorKind, IsTerminal as _, Stdout, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use tempfile::NamedTempFile;

use crate::failure::Failure;
use crate::input;
use crate::interrupt;

/// Whether files may be overwritten.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Overwriting {
    /// Overwrites the file if it exists.
    #[arg(long)]
    pub(crate) force: bool,
}

impl Overwriting {
    /// A file that has its name once all of it is written: until then, and after an error, there is what was there before.
    pub(crate) fn whole(self, path: &Path, read: Option<&Path>) -> Result<Output, Failure> {
        self.open(path, read, false)
    }

    /// A file that is of use before its end: it has its name from the start, and keeps what was written before an error.
    pub(crate) fn growing(self, path: &Path, read: Option<&Path>) -> Result<Output, Failure> {
        self.open(path, read, true)
    }

    /// Devices and pipes have nothing that could be lost, and are written to as they are. Nothing is written to what is read
    /// meanwhile, not even by force.
    fn open(self, path: &Path, read: Option<&Path>, growing: bool) -> Result<Output, Failure> {
        if is_standard(path) {
            return Ok(Output::standard());
        }
        let there = fs::metadata(path).ok();
        let to = match &there {
            Some(there) if there.is_dir() => Err(Error::other("is a folder; give the name of a file")),
            Some(there) if is_stream(there) => OpenOptions::new().write(true).open(path).map(To::Stream),
            _ if read.is_some_and(|read| is_same(read, path)) => {
                Err(Error::other("is what is read; give another name for what is written"))
            }
            _ if !self.force && path.symlink_metadata().is_ok() => Err(exists()),
            Some(there) if !there.is_file() || growing => File::create(path).map(To::Stream),
            // By force also where a link leads to nothing.
            None if growing && self.force => File::create(path).map(To::Stream),
            None if growing => File::create_new(path).map(To::Stream),
            _ => {
                let create = || Unfinished::create(path, self).map_err(|error| Failure::file(path, error));
                Ok(To::Unfinished(interrupt::catch_removing(create, |made| made.file.path())?))
            }
        };
        let to = to.map_err(|error| Failure::file(path, error))?;
        Ok(Output::new(path.display().to_string(), to))
    }
}

/// Whether a name means standard output. The device would begin a file anew that the shell appends to.
pub(crate) fn is_standard(path: &Path) -> bool {
    input::is_standard(path) || path == Path::new("/dev/stdout")
}

/// Something that is written to. Its errors say what it is called.
pub(crate) struct Output(BufWriter<Named>);

/// What is written to, without a buffer.
struct Named {
    name: String,
    to: To,
}

enum To {
    Standard(Stdout),
    Stream(File),
    Unfinished(Unfinished),
}

impl Output {
    pub(crate) fn standard() -> Self {
        Self::new("standard output".to_owned(), To::Standard(io::stdout()))
    }

    fn new(name: String, to: To) -> Self {
        Self(BufWriter::new(Named { name, to }))
    }

    /// Refuses a terminal, for bytes that are no text.
    pub(crate) fn of_bytes(self) -> Result<Self, Failure> {
        match &self.0.get_ref().to {
            To::Standard(output) if output.is_terminal() => {
                Err(Failure::new("standard output is a terminal, and a log is no text; name a file, or pipe it on"))
            }
            _ => Ok(self),
        }
    }

    /// What users call it.
    pub(crate) fn name(&self) -> &str {
        &self.0.get_ref().name
    }

    /// Whether it is a file of its own, of which there can be more than one.
    pub(crate) fn is_file(&self) -> bool {
        match &self.0.get_ref().to {
            To::Standard(_) => false,
            To::Stream(file) => file.metadata().is_ok_and(|metadata| metadata.is_file()),
            To::Unfinished(_) => true,
        }
    }

    /// Ends it, with all of it on the disk and under its name.
    pub(crate) fn finish(mut self) -> Result<(), Failure> {
        self.flush().map_err(Failure::written)?;
        // Pipes and devices have no disk.
        let is_file = self.is_file();
        let Named { name, to } = self.0.into_parts().0;
        let ended = match to {
            To::Stream(file) if is_file => file.sync_all(),
            To::Unfinished(unfinished) => unfinished.finish(),
            To::Standard(_) | To::Stream(_) => Ok(()),
        };
        ended.map_err(|error| Failure::with(name, error))
    }

    /// As [`finish`](Self::finish), and says what was written, but of standard output: its reader sees it.
    pub(crate) fn finish_saying(self, what: impl Display) -> Result<(), Failure> {
        let Named { name, to } = self.0.get_ref();
        let said = (!matches!(to, To::Standard(_))).then(|| format!("autoquad: {name}: {what}"));
        self.finish()?;
        said.into_iter().for_each(|said| eprintln!("{said}"));
        Ok(())
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

impl Named {
    fn to(&mut self) -> &mut dyn Write {
        match &mut self.to {
            To::Standard(output) => output,
            To::Stream(file) => file,
            To::Unfinished(unfinished) => &mut unfinished.file,
        }
    }

    fn named<T>(&self, result: io::Result<T>) -> io::Result<T> {
        result.map_err(|error| Error::new(error.kind(), format!("{}: {error}", self.name)))
    }
}

impl Write for Named {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.to().write(bytes);
        self.named(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        let flushed = self.to().flush();
        self.named(flushed)
    }
}

/// A file that is not whole yet: it lies in the folder where it is wanted, under another name, and is removed unless it is finished.
struct Unfinished {
    file: NamedTempFile,
    path: PathBuf,
    force: bool,
}

impl Unfinished {
    fn create(path: &Path, Overwriting { force }: Overwriting) -> io::Result<Self> {
        // What a link leads to is replaced, not the link.
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::metadata(folder)?;
        let mut builder = tempfile::Builder::new();
        builder.prefix(".autoquad-").suffix(".part");
        #[cfg(unix)]
        builder.permissions(<fs::Permissions as std::os::unix::fs::PermissionsExt>::from_mode(0o666));
        // The library's error has the other name in it, which nobody knows.
        let file = builder.tempfile_in(folder).map_err(|error| {
            Error::other(format!("no file can be made in its folder {}: {}", folder.display(), error.kind()))
        })?;
        if let Ok(replaced) = fs::metadata(&path) {
            OpenOptions::new().write(true).open(&path)?;
            file.as_file().set_permissions(replaced.permissions())?;
        }
        Ok(Self { file, path, force })
    }

    fn finish(self) -> io::Result<()> {
        self.file.as_file().sync_all()?;
        if self.force {
            return self.file.persist(&self.path).map(drop).map_err(|error| error.error);
        }
        match self.file.persist_noclobber(&self.path) {
            Ok(_) => Ok(()),
            Err(error) if error.error.kind() == ErrorKind::AlreadyExists => Err(exists()),
            // Not every file system can do that at once.
            Err(error) if self.path.symlink_metadata().is_err() => {
                error.file.persist(&self.path).map(drop).map_err(|error| error.error)
            }
            Err(error) => Err(error.error),
        }
    }
}

fn exists() -> Error {
    Error::new(ErrorKind::AlreadyExists, "exists already; give another name, or --force to overwrite it")
}

/// Whether what is written there goes away: no file, and no disk.
#[cfg(unix)]
fn is_stream(there: &Metadata) -> bool {
    use std::os::unix::fs::FileTypeExt as _;
    let kind = there.file_type();
    kind.is_char_device() || kind.is_fifo() || kind.is_socket()
}

#[cfg(not(unix))]
fn is_stream(there: &Metadata) -> bool {
    !there.is_file()
}

/// Whether two names are those of one file.
#[cfg(unix)]
fn is_same(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    let file = |path: &Path| fs::metadata(path).ok().map(|there| (there.dev(), there.ino()));
    file(one).is_some_and(|one| file(other) == Some(one))
}

#[cfg(not(unix))]
fn is_same(one: &Path, other: &Path) -> bool {
    let file = |path: &Path| fs::canonicalize(path).ok();
    file(one).is_some_and(|one| file(other) == Some(one))
}

//! Bytes of a file to text: size and encoding.

use std::fs::File;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use crate::diag::{Code, Diagnostic};
use crate::source::{FileId, Sources, Span};

/// How large a file may be, in bytes: about a hundred times the largest dialect of today.
pub(super) const MAX_SIZE: u64 = 64 << 20;

/// Why there is no text.
pub(super) enum NoText {
    /// The file system has none.
    Io(io::Error),
    /// There is a file, but it is no text.
    NotText(Box<Diagnostic>),
}

impl NoText {
    /// The problem of a file that was asked for by name.
    pub(super) fn diagnostic(self, path: &Path) -> Diagnostic {
        match self {
            Self::NotText(diagnostic) => *diagnostic,
            Self::Io(error) => {
                let message = format!("`{}` cannot be read: {}", path.display(), reason(&error));
                Diagnostic::without_place(Code::Unreadable, message)
            }
        }
    }
}

/// Adds the text of the file at `path` to the sources.
pub(super) fn read(path: &Path, sources: &mut Sources) -> Result<FileId, NoText> {
    add(path, load(path), sources)
}

/// The bytes of a file, and one more than is allowed if there are so many.
pub(crate) fn load(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_SIZE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Adds the text of what was [loaded](load) to the sources.
pub(super) fn add(path: &Path, bytes: io::Result<Vec<u8>>, sources: &mut Sources) -> Result<FileId, NoText> {
    let bytes = bytes.map_err(NoText::Io)?;
    if bytes.len() as u64 > MAX_SIZE {
        let message = format!("`{}` is larger than {} MiB", path.display(), MAX_SIZE >> 20);
        return Err(NoText::NotText(Diagnostic::without_place(Code::TooLarge, message).into()));
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok(sources.add(path, text)),
        Err(error) => Err(NoText::NotText(not_utf8(path, &error, sources).into())),
    }
}

/// Points at the first byte that is not UTF-8, in the text as far as it can be shown.
fn not_utf8(path: &Path, error: &std::string::FromUtf8Error, sources: &mut Sources) -> Diagnostic {
    let bytes = error.as_bytes();
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        let id = sources.add(path, "");
        return Diagnostic::new(Code::NotUtf8, Span::new(id, 0..0), "the file is UTF-16").help("save it as UTF-8");
    }
    let at = error.utf8_error().valid_up_to();
    let byte = bytes.get(at).copied().unwrap_or_default();
    let line = bytes.iter().take(at).filter(|&&byte| byte == b'\n').count() + 1;
    let message = format!("the byte 0x{byte:02X} in line {line} is not UTF-8");
    let lossy = String::from_utf8_lossy(bytes);
    // The text before the byte is the same in both; a byte order mark is not kept in the sources.
    let start = at - (lossy.len() - lossy.trim_start_matches('\u{feff}').len());
    let id = sources.add(path, lossy);
    Diagnostic::new(Code::NotUtf8, Span::new(id, start..start + 1), message)
        .help("save the file as UTF-8, whatever its XML declaration says")
}

/// What went wrong, in words that are the same on every system where the kind of error is known.
pub(super) fn reason(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => "there is no such file".to_owned(),
        ErrorKind::IsADirectory => "it is a folder".to_owned(),
        ErrorKind::PermissionDenied => "permission denied".to_owned(),
        _ => error.to_string(),
    }
}

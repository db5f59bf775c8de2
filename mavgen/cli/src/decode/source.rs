//! Where the bytes come from, and what they look like.

use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::Path;

use clap::ValueEnum;
use mavlink_wire::Table;

use super::hex::{HexReader, is_part};
use super::stream::Stream;

/// Bytes of the time in front of each frame of a tlog.
const TIME: usize = 8;

/// What the input holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Layout {
    /// Found out from its first bytes.
    Auto,
    /// Frames, one after the other, as a link carries them.
    Raw,
    /// A telemetry log: each frame behind a time, 8 bytes of microseconds since 1970, big-endian.
    Tlog,
    /// Frames in hexadecimal digits: blanks, lines, commas and `0x` between bytes.
    Hex,
}

/// The frames of a file, or of standard input.
pub(super) fn open<'t>(file: Option<&Path>, layout: Layout, table: &'t Table<'t>) -> io::Result<Stream<'t>> {
    let mut input: Box<dyn Read> = match file {
        Some(file) => Box::new(File::open(file)?),
        None => Box::new(io::stdin()),
    };
    let mut first = Vec::new();
    // One more than the time: where a tlog has the first byte of a frame.
    input.by_ref().take(TIME as u64 + 1).read_to_end(&mut first)?;
    let found = if layout == Layout::Auto { self::layout(&first) } else { layout };
    let bytes = Cursor::new(first).chain(input);
    Ok(match found {
        Layout::Hex => Stream::of_frames(Box::new(HexReader::new(bytes)), table),
        Layout::Tlog => Stream::of_log(Box::new(bytes), table),
        Layout::Raw | Layout::Auto => Stream::of_frames(Box::new(bytes), table),
    })
}

/// Whether a file that stands where a dialect should is standard input or something with frames: not called `.xml`, and of bytes
/// that begin no XML in any encoding.
pub(super) fn is_recording(path: &Path) -> bool {
    if path == Path::new("-") {
        return true;
    }
    // The reader of definitions says what cannot be read. A pipe is left to it: what is read here would be missing there.
    if !path.is_file() {
        return false;
    }
    let mut first = Vec::new();
    let is_xml = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("xml"));
    let read = File::open(path).and_then(|file| file.take(64).read_to_end(&mut first));
    !is_xml && read.is_ok() && !begins_xml(&first)
}

/// Nothing but blanks and marks of an encoding in front of a tag.
fn begins_xml(first: &[u8]) -> bool {
    let in_front = |byte: &u8| byte.is_ascii_whitespace() || [0, 0xef, 0xbb, 0xbf, 0xfe, 0xff].contains(byte);
    first.iter().find(|byte| !in_front(byte)).is_none_or(|byte| *byte == b'<')
}

/// What begins like this: text of hexadecimal digits; a time before the year 4253, which has a zero first, and a frame;
/// or frames, perhaps after noise.
fn layout(first: &[u8]) -> Layout {
    let text = first.iter().all(|byte| is_part(*byte)) && first.iter().any(u8::is_ascii_hexdigit);
    match (first.first(), first.get(TIME)) {
        _ if text => Layout::Hex,
        (Some(0), Some(0xfe | 0xfd)) => Layout::Tlog,
        _ => Layout::Raw,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn definitions_and_recordings_are_told_apart() {
        for xml in [&b"<mavlink>"[..], b"\xef\xbb\xbf\n <?xml", b"\xff\xfe<\0", b"\xfe\xff\0<", b"", b"\n"] {
            assert!(begins_xml(xml), "{xml:02x?}");
        }
        for other in [&[0xfe, 9, 0, 1, 1][..], &[0, 4, 0xf9, 0x4d, 0xba, 0xd8, 0x41, 0, 0xfe], b"fe 09", b"FMAV"] {
            assert!(!begins_xml(other), "{other:02x?}");
        }
    }

    #[test]
    fn layouts_are_told_apart() {
        for (first, expected) in [
            (&b"fe 09 00 "[..], Layout::Hex),
            (b"0xFE, 0x0", Layout::Hex),
            (b"\n\n\nfd", Layout::Hex),
            (b"\n\n", Layout::Raw),
            (b"", Layout::Raw),
            (b"hello, fe", Layout::Raw),
            (&[0xfe, 9, 0, 1, 1, 0, 0, 0, 0], Layout::Raw),
            (&[0xfd, 9, 0, 1, 1, 0, 0, 0, 0xfe], Layout::Raw),
            (&[0, 4, 0xf9, 0x4d, 0xba, 0xd8, 0x41, 0, 0xfe], Layout::Tlog),
            (&[0, 4, 0xf9, 0x4d, 0xba, 0xd8, 0x41, 0, 0xfd], Layout::Tlog),
            (&[0, 4, 0xf9, 0x4d, 0xba, 0xd8, 0x41, 0, 0xfc], Layout::Raw),
            (&[0, 0xfe, 9], Layout::Raw),
        ] {
            assert_eq!(layout(first), expected, "{first:02x?}");
        }
    }
}

//! Bytes that are written as hexadecimal digits.

use std::io::{self, BufRead, BufReader, Error, ErrorKind, Read};

/// Reads the bytes that a text spells: two digits each, with blanks, lines, commas, colons or `0x` between them.
pub(super) struct HexReader<R> {
    text: BufReader<R>,
    /// The first digit of a byte.
    half: Option<u8>,
    /// From 1.
    line: u64,
}

/// Whether such a text can have this byte.
pub(super) fn is_part(byte: u8) -> bool {
    byte.is_ascii_hexdigit() || is_separator(byte) || matches!(byte, b'x' | b'X')
}

fn is_separator(byte: u8) -> bool {
    byte.is_ascii_whitespace() || matches!(byte, b',' | b':')
}

impl<R: Read> HexReader<R> {
    pub(super) fn new(text: R) -> Self {
        Self { text: BufReader::new(text), half: None, line: 1 }
    }

    /// The byte that ends with this character of the text, if one does.
    fn take(&mut self, character: u8) -> io::Result<Option<u8>> {
        let digit = (character as char).to_digit(16).map(|digit| digit as u8);
        match (digit, self.half) {
            (Some(digit), None) => self.half = Some(digit),
            (Some(digit), Some(half)) => {
                self.half = None;
                return Ok(Some(half << 4 | digit));
            }
            (None, Some(0)) if matches!(character, b'x' | b'X') => self.half = None,
            (None, None) if is_separator(character) => self.line += u64::from(character == b'\n'),
            (None, Some(_)) if is_separator(character) => return Err(self.refused("a byte has two digits, not one")),
            (None, _) => {
                let shown = character.escape_ascii();
                return Err(self.refused(&format!("`{shown}` is no hexadecimal digit: for bytes, say `--input raw`")));
            }
        }
        Ok(None)
    }

    fn refused(&self, what: &str) -> Error {
        Error::new(ErrorKind::InvalidData, format!("line {}: {what}", self.line))
    }
}

impl<R: Read> Read for HexReader<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let mut written = 0;
        while written == 0 && !bytes.is_empty() {
            let text = self.text.fill_buf()?;
            if text.is_empty() {
                return if self.half.is_some() { Err(self.refused("the last byte lacks a digit")) } else { Ok(0) };
            }
            // At most as many characters as there is room for bytes: none of them is lost.
            let text = text.get(..bytes.len()).unwrap_or(text).to_vec();
            for character in &text {
                if let (Some(byte), Some(room)) = (self.take(*character)?, bytes.get_mut(written)) {
                    *room = byte;
                    written += 1;
                }
            }
            self.text.consume(text.len());
        }
        Ok(written)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<u8>, String> {
        let mut bytes = Vec::new();
        HexReader::new(text.as_bytes()).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
        let mut one_by_one = Vec::new();
        let mut reader = HexReader::new(text.as_bytes());
        let mut byte = [0];
        while reader.read(&mut byte).unwrap() == 1 {
            one_by_one.push(byte[0]);
        }
        assert_eq!(one_by_one, bytes);
        Ok(bytes)
    }

    #[test]
    fn bytes_in_many_spellings() {
        for text in ["fe09ff", "FE 09 Ff", "0xfe, 0x09,\n0XFF\n", "fe:09:ff", "\r\n\tfe\n\n09ff\n"] {
            assert_eq!(read(text), Ok(vec![0xfe, 9, 0xff]), "{text:?}");
        }
        assert_eq!(read(" \n"), Ok(vec![]));
        assert_eq!(read(&"0a".repeat(100_000)), Ok(vec![10; 100_000]));
    }

    #[test]
    fn what_is_no_byte_is_refused_with_its_line() {
        for (text, said) in [
            ("fe 9 00", "line 1: a byte has two digits, not one"),
            ("fe\n09\nf", "line 3: the last byte lacks a digit"),
            ("fe\ng0", "line 2: `g` is no hexadecimal digit: for bytes, say `--input raw`"),
            ("1x00", "line 1: `x` is no hexadecimal digit: for bytes, say `--input raw`"),
            ("fe \u{fffd}", "line 1: `\\xef` is no hexadecimal digit: for bytes, say `--input raw`"),
        ] {
            assert_eq!(read(text), Err(said.to_owned()), "{text:?}");
        }
    }
}

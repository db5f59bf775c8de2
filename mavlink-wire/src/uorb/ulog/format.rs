//! The format definitions of a log: what its records look like.

use core::{iter, str};

use super::Records;
use crate::uorb::Kind;

/// A field as a format definition has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FormatField<'a> {
    /// `uint8_t`, or the name of another format.
    pub(super) element: &'a str,
    pub(super) name: &'a str,
    /// 1 for what is no array.
    pub(super) len: u16,
}

impl FormatField<'_> {
    pub(super) fn kind(&self) -> Option<Kind> {
        Kind::of_log(self.element)
    }

    /// What a compiler puts between fields is written like a field.
    pub(super) fn is_padding(&self) -> bool {
        self.name.starts_with("_padding")
    }
}

/// The fields of a format; `None` in place of one that is none.
pub(super) fn fields(text: &str) -> impl Iterator<Item = Option<FormatField<'_>>> {
    let mut rest = text;
    let fields = iter::from_fn(move || {
        let (field, behind) = cut(rest, b';').or_else(|| (!rest.is_empty()).then_some((rest, "")))?;
        rest = behind;
        Some(field)
    });
    fields.filter(|field| !field.is_empty()).map(|field| {
        let (element, name) = cut(field, b' ')?;
        let Some((element, len)) = cut(element, b'[') else { return Some(FormatField { element, name, len: 1 }) };
        Some(FormatField { element, name, len: len.strip_suffix(']')?.parse().ok()? })
    })
}

/// What stands before and behind the first of these bytes. `str::split_once` could panic, as far as a linker can see.
fn cut(text: &str, byte: u8) -> Option<(&str, &str)> {
    let at = text.bytes().position(|other| other == byte)?;
    Some((text.get(..at)?, text.get(at + 1..)?))
}

/// The fields of the format with this name, as text. Scans the definitions anew, so that nothing has to be stored; they end
/// with the first record that is not one of theirs.
pub(super) fn find<'a>(records: &Records<'a>, name: &str) -> Option<&'a str> {
    records
        .clone()
        .take_while(|record| b"BFIMPQ".contains(&record.kind))
        .filter(|record| record.kind == b'F')
        .find_map(|record| str::from_utf8(record.payload.strip_prefix(name.as_bytes())?.strip_prefix(b":")?).ok())
}

/// What is looked up in other formats, and how often that is still done: a log can nest formats without end.
pub(super) struct Formats<'f, 'a> {
    find: &'f dyn Fn(&str) -> Option<&'a str>,
    lookups_left: u32,
}

/// Formats that nest deeper do not occur; what a log says of them is not believed.
pub(super) const DEEPEST: u32 = 4;

impl<'f, 'a> Formats<'f, 'a> {
    pub(super) fn new(find: &'f dyn Fn(&str) -> Option<&'a str>) -> Self {
        Self { find, lookups_left: 64 }
    }

    pub(super) fn find(&mut self, name: &str) -> Option<&'a str> {
        self.lookups_left = self.lookups_left.checked_sub(1)?;
        (self.find)(name)
    }

    /// Bytes of one element of a field; `depth` is how deep the field is nested.
    pub(super) fn size(&mut self, field: &FormatField<'_>, depth: u32) -> Option<u32> {
        if let Some(kind) = field.kind() {
            return Some(kind.size());
        }
        if depth == DEEPEST {
            return None;
        }
        let mut size = 0_u32;
        for field in fields(self.find(field.element)?) {
            let field = field?;
            size = size.checked_add(self.size(&field, depth + 1)?.checked_mul(field.len.into())?)?;
        }
        Some(size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_of_a_format() {
        let found: [_; 4] =
            core::array::from_fn(|i| fields("uint8_t a;esc_report[8] esc;float[x] b;c;").nth(i).flatten());
        assert_eq!(found[0], Some(FormatField { element: "uint8_t", name: "a", len: 1 }));
        assert_eq!(found[1], Some(FormatField { element: "esc_report", name: "esc", len: 8 }));
        assert_eq!(&found[2..], [None, None]);
    }

    #[test]
    fn a_format_that_nests_itself_has_no_size() {
        let mut formats = Formats::new(&|name| (name == "a").then_some("a x;uint8_t y;"));
        assert_eq!(formats.size(&FormatField { element: "a", name: "", len: 1 }, 0), None);
    }

    #[test]
    fn a_format_with_many_nested_ones_is_given_up() {
        let wide = "b x;".repeat(10_000);
        let formats = |name: &str| Some(if name == "a" { &wide[..] } else { "uint8_t y;" });
        assert_eq!(Formats::new(&formats).size(&FormatField { element: "a", name: "", len: 1 }, 0), None);
    }
}

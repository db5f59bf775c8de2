//! What an XML declaration says of the encoding, and whether it is so.

use super::characters::BLANKS;
use crate::diag::{Code, Diagnostic};
use crate::source::Part;

/// Looks at the declaration at the start of a text, which was read as UTF-8 whatever it says.
///
/// Other parsers believe it (expat does, and so pymavlink). A text of plain ASCII is the same in all encodings but the wide
/// ones.
pub(super) fn check(source: Part<'_>) -> Option<Diagnostic> {
    let text = source.text;
    let declaration = text.strip_prefix("<?xml")?;
    let declaration = declaration.get(..declaration.find("?>")?)?;
    let at = declaration.find("encoding")? + "encoding".len();
    let value = declaration.get(at..)?.trim_start_matches(BLANKS).strip_prefix('=')?.trim_start_matches(BLANKS);
    let quote = value.chars().next().filter(|first| matches!(first, '"' | '\''))?;
    let name = value.get(1..)?.split(quote).next()?;
    let lower = name.to_ascii_lowercase();
    let wide = ["utf-16", "utf-32", "ucs-", "iso-10646"].iter().any(|wide| lower.starts_with(wide));
    if lower == "utf-8" || !wide && text.is_ascii() {
        return None;
    }
    let message = format!("the file is UTF-8, but declares to be `{name}`");
    let problem = Diagnostic::new(Code::DeclaredEncoding, source.with(name).span(), message);
    Some(problem.label("other parsers believe this").help("write `encoding=\"UTF-8\"`"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Sources;

    #[test]
    fn declarations() {
        for (text, found) in [
            ("<?xml version=\"1.0\"?>°", None),
            ("<?xml version=\"1.0\" encoding=\"UTF-8\"?>°", None),
            ("<?xml version='1.0' encoding = 'utf-8' ?>°", None),
            ("<?xml version='1.0' encoding='ISO-8859-1'?>deg", None),
            ("<?xml version='1.0' encoding='ISO-8859-1'?>°", Some("ISO-8859-1")),
            ("<?xml version='1.0' encoding='us-ascii'?>°", Some("us-ascii")),
            ("<?xml version='1.0' encoding='UTF-16'?>deg", Some("UTF-16")),
            ("<?xml version='1.0' encoding=''?>°", Some("")),
            ("<?xml version='1.0' encoding=?>°", None),
            ("<?xml version='1.0'", None),
            ("°", None),
        ] {
            let problem = check(Part::whole(Sources::default().add("a.xml", text), text));
            let place = problem.map(|problem| text.get(problem.span.unwrap().range()).unwrap().to_owned());
            assert_eq!(place.as_deref(), found, "{text}");
        }
    }
}

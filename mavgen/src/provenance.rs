//! The comment at the head of a vendored file, by which it is known as a copy of somebody else's.

/// How every such comment starts.
pub(crate) const MARK: &str = "<!-- Vendored by mavgen ";

/// What follows [`MARK`] in a file that begins with it, and the XML declaration before it; the start of a file is enough.
pub(crate) fn split(text: &str) -> Option<(&str, &str)> {
    let (declaration, rest) = split_declaration(text.trim_start_matches('\u{feff}'));
    Some((declaration, rest.trim_start().strip_prefix(MARK)?))
}

/// The declaration and what follows it, if a text begins with one.
pub(crate) fn split_declaration(text: &str) -> (&str, &str) {
    let end = if text.starts_with("<?xml") { text.find("?>").map_or(0, |at| at + 2) } else { 0 };
    text.split_at_checked(end).unwrap_or(("", text))
}

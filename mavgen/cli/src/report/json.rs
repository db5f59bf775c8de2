//! Diagnostics for programs: one JSON object each, on one line.

use mavgen::diag::{Diagnostic, Severity, Style, render};
use mavgen::source::{Sources, Span};
use serde_json::{Map, Value, json as value};

/// One diagnostic as a JSON object on one line, without a line end: what `--message-format json` prints.
///
/// | key | value |
/// |---|---|
/// | `code` | the stable number, as in `"M304"`; `mavgen explain M304` says more; `null` in a [`message`] or [`usage`] |
/// | `severity` | `"error"`, `"warning"` or `"note"` |
/// | `message` | what is wrong, in one line |
/// | `label` | what is said of the place; may be empty |
/// | `help` | what to do, or `null` |
/// | `file` | the path as the command was given it or found it |
/// | `line`, `column` | the first character of the place, both counted from one; columns count characters |
/// | `end_line`, `end_column` | the character behind the last one |
/// | `byte_start`, `byte_end` | the same place in bytes from the start of the text, a byte order mark not counted |
/// | `related` | other places: a list of objects with `label` and the seven keys of a place |
/// | `rendered` | all of it drawn as plain text, as [`render`] does it |
///
/// The seven keys from `file` to `byte_end` are `null` where a problem has no place in a file. No key is ever left out; later
/// versions may add some.
pub(crate) fn diagnostic(diagnostic: &Diagnostic, sources: &Sources) -> String {
    let related = diagnostic.related.iter().map(|other| {
        let mut object = place(Some(other.span), sources);
        object.insert("label".to_owned(), value!(other.label));
        Value::Object(object)
    });
    let mut object = Map::new();
    object.insert("code".to_owned(), value!(diagnostic.code.to_string()));
    object.insert("severity".to_owned(), value!(diagnostic.severity().to_string()));
    object.insert("message".to_owned(), value!(diagnostic.message));
    object.insert("label".to_owned(), value!(diagnostic.label));
    object.insert("help".to_owned(), value!(diagnostic.help));
    object.append(&mut place(diagnostic.span, sources));
    object.insert("related".to_owned(), related.collect());
    object.insert("rendered".to_owned(), value!(render(diagnostic, sources, Style::Plain)));
    Value::Object(object).to_string()
}

/// A message that is none of the catalogue, like a folder that cannot be written, in the schema of [`diagnostic`]: its `code` is
/// `null`, and it has no place.
pub(crate) fn message(severity: Severity, message: &str) -> String {
    without_place(severity, message, None, &format!("{severity}: {message}"))
}

/// An error in how a program was called, in the schema of [`diagnostic`]: its `code` is `null`, and it has no place. `rendered` is what a
/// person would have been shown.
pub(crate) fn usage(message: &str, help: &str, rendered: &str) -> String {
    without_place(Severity::Error, message, Some(help), rendered)
}

fn without_place(severity: Severity, message: &str, help: Option<&str>, rendered: &str) -> String {
    let mut object = Map::new();
    object.insert("code".to_owned(), Value::Null);
    object.insert("severity".to_owned(), value!(severity.to_string()));
    object.insert("message".to_owned(), value!(message));
    object.insert("label".to_owned(), value!(""));
    object.insert("help".to_owned(), value!(help));
    object.append(&mut place(None, &Sources::default()));
    object.insert("related".to_owned(), value!([]));
    object.insert("rendered".to_owned(), value!(rendered));
    Value::Object(object).to_string()
}

/// The keys of a place.
fn place(span: Option<Span>, sources: &Sources) -> Map<String, Value> {
    let found = span.and_then(|span| Some((span, sources.get(span.file)?)));
    let (start, end) = found.map(|(span, file)| (file.position(span.start), file.position(span.end))).unzip();
    let keys = [
        ("file", value!(found.map(|(_, file)| file.path().to_string_lossy()))),
        ("line", value!(start.map(|at| at.line))),
        ("column", value!(start.map(|at| at.column))),
        ("end_line", value!(end.map(|at| at.line))),
        ("end_column", value!(end.map(|at| at.column))),
        ("byte_start", value!(found.map(|(span, _)| span.start))),
        ("byte_end", value!(found.map(|(span, _)| span.end))),
    ];
    keys.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

#[cfg(test)]
mod tests {
    use mavgen::diag::Code;

    use super::*;

    #[test]
    fn every_key_is_there() {
        let mut sources = Sources::default();
        let file = sources.add("xml/a.xml", "<a>\n é\"b\n</a>");
        let diagnostic = Diagnostic::new(Code::UnknownType, Span::new(file, 7..9), "what\n\"is\"")
            .label("here")
            .related(Span::new(file, 0..3), "there")
            .help("do");
        let line = super::diagnostic(&diagnostic, &sources);
        assert!(!line.contains('\n'), "{line}");
        let expected = value!({
            "code": "M304", "severity": "error", "message": "what\n\"is\"", "label": "here", "help": "do",
            "file": "xml/a.xml", "line": 2, "column": 3, "end_line": 2, "end_column": 5, "byte_start": 7, "byte_end": 9,
            "related": [{
                "file": "xml/a.xml", "line": 1, "column": 1, "end_line": 1, "end_column": 4, "byte_start": 0,
                "byte_end": 3, "label": "there",
            }],
            "rendered": render(&diagnostic, &sources, Style::Plain),
        });
        assert_eq!(serde_json::from_str::<Value>(&line).unwrap(), expected);
    }

    #[test]
    fn a_message_has_the_keys_of_a_diagnostic() {
        let keys = |line: &str| -> Vec<String> {
            let value: Value = serde_json::from_str(line).unwrap();
            value.as_object().unwrap().keys().cloned().collect()
        };
        let diagnostic = Diagnostic::without_place(Code::Unreadable, "x");
        let message = super::message(Severity::Error, "out: \"full\"");
        assert_eq!(keys(&message), keys(&super::diagnostic(&diagnostic, &Sources::default())));
        assert!(message.contains(r#""rendered":"error: out: \"full\"""#), "{message}");
    }

    #[test]
    fn without_a_place_its_keys_are_null() {
        let diagnostic = Diagnostic::without_place(Code::Unreadable, "`a.xml` cannot be read");
        let value: Value = serde_json::from_str(&super::diagnostic(&diagnostic, &Sources::default())).unwrap();
        for key in ["file", "line", "column", "end_line", "end_column", "byte_start", "byte_end", "help"] {
            assert_eq!(value.get(key), Some(&Value::Null), "{key}");
        }
        assert_eq!(value.get("related"), Some(&value!([])));
    }
}

//! Small dialects out of large ones.

use std::collections::{BTreeMap, BTreeSet};

/// Bytes of an enum that are kept.
const LONGEST: usize = 4000;

/// The messages and enums of some files, as text.
pub(crate) struct Definitions {
    messages: Vec<(String, String)>,
    /// An enum that several files define stands here with the entries of all.
    enums: BTreeMap<String, String>,
}

impl Definitions {
    pub(crate) fn of(files: &[String]) -> Self {
        let all = |element| files.iter().flat_map(move |text| elements(text, element));
        let mut enums: BTreeMap<String, String> = BTreeMap::new();
        for text in all("enum") {
            enums.entry(attribute(text, "name").unwrap().to_owned()).or_default().push_str(&shortened(text));
        }
        let messages = all("message").map(|text| (attribute(text, "name").unwrap().to_owned(), text.to_owned()));
        Self { messages: messages.collect(), enums }
    }

    pub(crate) fn messages(&self) -> usize {
        self.messages.len()
    }

    pub(crate) fn enums(&self) -> usize {
        self.enums.len()
    }

    /// A dialect of these messages (modulo their number) and the enums that their fields name, each once.
    pub(crate) fn excerpt(&self, picks: &[usize]) -> String {
        let picks: BTreeSet<usize> = picks.iter().map(|pick| pick % self.messages.len()).collect();
        self.dialect(picks.into_iter().filter_map(|pick| self.messages.get(pick)).collect(), &[])
    }

    /// The dialect that the AutoQuad overlay speaks of.
    pub(crate) fn carriers(&self) -> String {
        // Commands are spoken of by their entries.
        let names = ["AQ_ESC_TELEMETRY", "HEARTBEAT", "ATTITUDE", "MAV_CMD"];
        let overlay = super::OVERLAY.as_str();
        let spoken_of = |name: &String| names.contains(&name.as_str()) || overlay.contains(&format!("\"{name}\""));
        let messages = self.messages.iter().filter(|(name, _)| spoken_of(name)).collect();
        let enums: Vec<&str> = self.enums.keys().filter(|name| spoken_of(name)).map(String::as_str).collect();
        self.dialect(messages, &enums)
    }

    fn dialect(&self, messages: Vec<&(String, String)>, enums: &[&str]) -> String {
        let named = messages.iter().flat_map(|(_, text)| elements(text, "field").chain(tags(text, "field")));
        let names: BTreeSet<&str> =
            named.filter_map(|field| attribute(field, "enum")).chain(enums.iter().copied()).collect();
        let enums: String = names.iter().filter_map(|name| self.enums.get(*name)).map(String::as_str).collect();
        let messages: String = messages.iter().map(|(_, text)| text.as_str()).collect();
        format!("<mavlink><version>3</version><enums>{enums}</enums><messages>{messages}</messages></mavlink>")
    }
}

/// The first entries of a long enum: all 170 commands would be most of a case.
fn shortened(text: &str) -> String {
    match text.get(..LONGEST).and_then(|head| head.rfind("</entry>")) {
        Some(end) => format!("{}</entry></enum>", &text[..end]),
        None => text.to_owned(),
    }
}

/// The elements of this name that are not empty, from tag to tag.
fn elements<'t>(text: &'t str, name: &str) -> impl Iterator<Item = &'t str> {
    let (open, close) = (format!("<{name} "), format!("</{name}>"));
    let mut rest = text;
    std::iter::from_fn(move || {
        let start = rest.find(&open)?;
        let end = start + rest.get(start..)?.find(&close)? + close.len();
        let element = rest.get(start..end)?;
        rest = rest.get(end..)?;
        Some(element)
    })
}

/// The tags of this name.
fn tags<'t>(text: &'t str, name: &str) -> impl Iterator<Item = &'t str> {
    let open = format!("<{name} ");
    let starts: Vec<usize> = text.match_indices(&open).map(|(at, _)| at).collect();
    starts.into_iter().filter_map(|start| text.get(start..)?.split_inclusive('>').next())
}

/// The value of an attribute in the first tag.
fn attribute<'t>(text: &'t str, name: &str) -> Option<&'t str> {
    let tag = text.split('>').next()?;
    let value = tag.split(&format!(" {name}=\"")).nth(1)?;
    value.split('"').next()
}

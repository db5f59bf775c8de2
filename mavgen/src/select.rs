//! Selections: a dialect with fewer messages, and only what those need ([`Kept`]).
//!
//! It works on the resolved model. So what is kept is what it is in the whole dialect: the same types, the same bytes.

#[cfg(test)]
mod tests;

use crate::collect::CollectVec as _;
use crate::diag::nearest;
use crate::ir::{Dialect, Kept};
use crate::order;

/// Which messages to keep: names, and patterns in which `*` stands for any characters.
#[derive(Clone, Debug)]
pub(crate) struct Selection {
    patterns: Vec<Pattern>,
}

impl Selection {
    /// Understands names like `HEARTBEAT` and patterns like `PARAM_*`, in any order, each once or more often.
    ///
    /// # Errors
    /// With a sentence, if there is none or one of them is empty.
    pub(crate) fn new<'n>(names: impl IntoIterator<Item = &'n str>) -> Result<Self, String> {
        let mut patterns = names.into_iter().map(|name| Pattern::new(name.trim())).collect_vec();
        if patterns.is_empty() || patterns.iter().any(Pattern::is_empty) {
            return Err(
                "the list of messages is empty, or has an empty name: give names like HEARTBEAT, or PARAM_*".into()
            );
        }
        order::sort_and_dedup(&mut patterns);
        Ok(Self { patterns })
    }

    /// Whether each name means a message of at least one of these dialects.
    ///
    /// # Errors
    /// With a sentence that lists those that do not.
    pub(crate) fn check(&self, dialects: &[&Dialect]) -> Result<(), String> {
        let messages = || dialects.iter().flat_map(|dialect| &dialect.messages);
        let mut files = dialects.iter().filter_map(|dialect| Some(&*dialect.files.first()?.name)).collect_vec();
        // Two states of a dialect are mostly called the same.
        files.dedup();
        self.check_names(|| messages().map(|message| message.name.text.as_str()), &files.join(", "))
    }

    /// Whether each name means one of these, which are those of the messages of `files`.
    ///
    /// # Errors
    /// With a sentence that lists those that do not.
    pub(crate) fn check_names<'n, I: Iterator<Item = &'n str>>(
        &self,
        names: impl Fn() -> I,
        files: &str,
    ) -> Result<(), String> {
        let unmatched = self.patterns.iter().filter(|pattern| !names().any(|name| pattern.matches(name)));
        let unmatched: Vec<String> = unmatched
            .map(|pattern| match nearest(pattern.text(), names()) {
                Some(name) => format!("`{}` (did you mean `{name}`?)", pattern.text()),
                None => format!("`{}`", pattern.text()),
            })
            .collect_vec();
        if unmatched.is_empty() {
            return Ok(());
        }
        Err(format!("no message of {files} is called {}", unmatched.join(", ")))
    }

    /// The selected messages, their views and bindings, and the enums that those need.
    pub(crate) fn kept(&self, dialect: &Dialect) -> Kept {
        Kept::of(dialect, |message| self.has(&message.name.text), |_| false)
    }

    /// Whether a message of that name is one of them.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.patterns.iter().any(|pattern| pattern.matches(name))
    }
}

/// The list as one would write it: by name, separated by commas.
impl std::fmt::Display for Selection {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (index, pattern) in self.patterns.iter().enumerate() {
            let comma = if index == 0 { "" } else { "," };
            write!(f, "{comma}{}", pattern.text())?;
        }
        Ok(())
    }
}

/// A message name, or a pattern in which `*` stands for any characters, also none.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Pattern(String);

impl Pattern {
    fn new(text: &str) -> Self {
        Self(text.to_owned())
    }

    /// As it was given.
    fn text(&self) -> &str {
        &self.0
    }

    fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether it means this name; letter case counts, as it does in the XML.
    fn matches(&self, name: &str) -> bool {
        let Some((first, rest)) = self.0.split_once('*') else { return self.0 == name };
        let (middle, last) = rest.rsplit_once('*').unwrap_or(("", rest));
        let Some(mut name) = name.strip_prefix(first).and_then(|name| name.strip_suffix(last)) else { return false };
        // The earliest place for each part leaves the most room for the others.
        middle.split('*').all(|part| match name.split_once(part) {
            Some((_, after)) => {
                name = after;
                true
            }
            None => false,
        })
    }
}

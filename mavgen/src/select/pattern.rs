//! Names with wildcards.

/// A message name, or a pattern in which `*` stands for any characters, also none.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Pattern(String);

impl Pattern {
    pub(super) fn new(text: &str) -> Self {
        Self(text.to_owned())
    }

    /// As it was given.
    pub(super) fn text(&self) -> &str {
        &self.0
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether it means this name; letter case counts, as it does in the XML.
    pub(super) fn matches(&self, name: &str) -> bool {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stars_stand_for_any_characters() {
        for (pattern, name, expected) in [
            ("PARAM_SET", "PARAM_SET", true),
            ("PARAM_SET", "PARAM_SET_2", false),
            ("param_set", "PARAM_SET", false),
            ("PARAM_*", "PARAM_SET", true),
            ("PARAM_*", "PARAM_", true),
            ("PARAM_*", "XPARAM_SET", false),
            ("*", "ANY", true),
            ("*_INT", "GPS_RAW_INT", true),
            ("*_INT", "GPS_INTEGER", false),
            ("GPS*INT", "GPS_RAW_INT", true),
            ("GPS*SINT", "GPSINT", false),
            ("*GPS*", "RAW_GPS_INT", true),
            ("A*B*C*D", "A_B_C_D", true),
            ("A*B*C*D", "A_C_B_D", false),
            ("A**A", "AA", true),
            ("A**A", "A", false),
            ("*A*A*", "A", false),
        ] {
            assert_eq!(Pattern::new(pattern).matches(name), expected, "{pattern} and {name}");
        }
    }
}

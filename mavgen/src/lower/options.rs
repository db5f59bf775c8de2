//! How to make a tree.

/// What is not in the definitions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Options {
    /// The path of the runtime crate: `::mavlink_wire`.
    pub(crate) runtime: String,
    /// Whether `<deprecated>` becomes `#[deprecated]`; if not, it is only said in the documentation.
    pub(crate) deprecated: bool,
    /// Whether commands have types.
    pub(crate) commands: Commands,
    /// What the header of `mod.rs` says of the sources: their names and a digest.
    pub(crate) sources: String,
}

/// Whether each entry of `MAV_CMD` becomes a type in the module `commands`: [`Builder::commands`](crate::Builder::commands).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Commands {
    /// Each does.
    #[default]
    Always,
    /// None does; no file is written for them.
    Never,
    /// Each does, and the module is compiled only with this cargo feature of the crate that has the sources: it stands behind
    /// `#[cfg(feature = "…")]`. Declare the feature in that crate's `Cargo.toml`: `commands = []`.
    Feature(String),
}

impl Commands {
    /// Whether they are in the tree.
    pub(super) fn are_written(&self) -> bool {
        *self != Self::Never
    }

    /// The feature that the compiler needs for them.
    pub(crate) fn feature(&self) -> Option<&str> {
        match self {
            Self::Feature(name) => Some(name),
            Self::Always | Self::Never => None,
        }
    }
}

/// Whether cargo takes this as the name of a feature.
///
/// Cargo asks for `XID_Start` and `XID_Continue`, which differ from letters and digits in a few rare characters. A name that passes
/// here and not there cannot be declared, as cargo then says.
pub(crate) fn is_feature(name: &str) -> bool {
    let mut rest = name.chars();
    rest.next().is_some_and(|first| first == '_' || first.is_ascii_digit() || first.is_alphabetic())
        && rest.all(|other| matches!(other, '_' | '-' | '+' | '.') || other.is_alphanumeric())
}

#[cfg(test)]
mod tests {
    use super::is_feature;

    #[test]
    fn names_of_features_are_those_that_cargo_takes() {
        for name in ["commands", "typed-commands", "_x", "9p", "a+b", "v1.2", "C", "größe"] {
            assert!(is_feature(name), "{name}");
        }
        let others =
            ["", " ", "-x", "+x", ".x", "a b", "dep:commands", "a/b", "a?/b", "a\"b", "a\\", "a\n", "a]", "a,b", "²"];
        for name in others {
            assert!(!is_feature(name), "{name:?}");
        }
    }
}

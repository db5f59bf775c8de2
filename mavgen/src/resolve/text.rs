//! Optional texts of the syntax as the model keeps them.

use crate::syntax::Text;

/// The text, if it says anything.
pub(super) fn non_empty(text: Option<&Text>) -> Option<String> {
    text.map(|text| text.value.clone()).filter(|value| !value.is_empty())
}

/// The text, or an empty one.
pub(super) fn or_empty(text: Option<&Text>) -> String {
    text.map(|text| text.value.clone()).unwrap_or_default()
}

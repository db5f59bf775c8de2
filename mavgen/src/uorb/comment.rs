//! The comments of a `.msg` file: bracket groups at their beginning, then prose.

use super::syntax::{Group, GroupKind};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::source::Part;

/// Reads the comment of one line: adds its groups, and returns the prose behind them.
pub(super) fn read<'t>(comment: Part<'t>, groups: &mut Vec<Group>, diagnostics: &mut Diagnostics) -> &'t str {
    let mut rest = comment.text.trim_start();
    // Only leading groups count: older files write "[RPM]" in their prose.
    while let Some((inside, behind)) = rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
        let span = comment.with(rest).get(0..inside.len() + 2).span();
        match kind(inside.trim()) {
            Ok(kind) => groups.extend(kind.map(|kind| Group { kind, span })),
            Err(help) => diagnostics.push(
                Diagnostic::new(Code::UorbGroup, span, format!("`[{inside}]` says nothing that is known")).help(help),
            ),
        }
        rest = behind.trim_start();
    }
    rest.trim_end()
}

/// What the text between brackets says; `None` for `[-]`.
fn kind(inside: &str) -> Result<Option<GroupKind>, &'static str> {
    let Some(mark) = inside.strip_prefix('@') else {
        return Ok((inside != "-" && !inside.is_empty()).then(|| GroupKind::Units(inside.to_owned())));
    };
    let (name, value) = mark.split_once(char::is_whitespace).unwrap_or((mark, ""));
    let value = value.trim();
    Ok(Some(match name {
        "enum" if !value.is_empty() => GroupKind::Enum(value.split_whitespace().map(str::to_owned).collect_vec()),
        "range" => {
            let (low, high) = value.split_once(',').ok_or("write both ends: `[@range 0, 1]`")?;
            GroupKind::Range(low.trim().to_owned(), high.trim().to_owned())
        }
        "invalid" if !value.is_empty() => GroupKind::Invalid(value.to_owned()),
        "frame" if !value.is_empty() => GroupKind::Frame(value.to_owned()),
        "enum" | "invalid" | "frame" => {
            return Err("it needs a value: `[@enum NAME]`, `[@invalid NaN]`, `[@frame NED]`");
        }
        _ => return Err("known are `@enum`, `@range`, `@invalid` and `@frame`"),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Sources;

    fn groups(text: &str) -> (Vec<GroupKind>, String, usize) {
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let file = sources.add("A.msg", text);
        let mut groups = Vec::new();
        let rest = read(Part::whole(file, text), &mut groups, &mut diagnostics);
        (groups.into_iter().map(|group| group.kind).collect(), rest.to_owned(), diagnostics.len())
    }

    #[test]
    fn leading_groups_count_and_others_are_prose() {
        let (found, prose, problems) = groups(" [m/s] [@range -1, 1] [@invalid NaN if unknown] Speed [RPM] ");
        let range = GroupKind::Range("-1".into(), "1".into());
        assert_eq!(found, [GroupKind::Units("m/s".into()), range, GroupKind::Invalid("NaN if unknown".into())]);
        assert_eq!((prose.as_str(), problems), ("Speed [RPM]", 0));
    }

    #[test]
    fn no_unit_is_no_group() {
        assert_eq!(groups("[-] Count"), (vec![], "Count".to_owned(), 0));
    }

    #[test]
    fn several_prefixes_and_half_a_range() {
        let (found, ..) = groups("[@enum WARNING STATE] [@range 1,]");
        let range = GroupKind::Range("1".into(), String::new());
        assert_eq!(found, [GroupKind::Enum(vec!["WARNING".into(), "STATE".into()]), range]);
    }

    #[test]
    fn what_is_not_known_is_told() {
        for text in ["[@unit m]", "[@enum]", "[@range 3]"] {
            assert_eq!(groups(text), (vec![], String::new(), 1), "{text}");
        }
    }
}

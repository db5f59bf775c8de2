//! What holds of any two dialects.

use proptest::prelude::*;
use proptest::sample::Index;

use super::edits::EDITS;
use super::model::model;
use super::*;
use crate::compare::Kind;

/// The changes of some groups: kind, and whether it breaks something.
fn kinds(changes: &[Change], groups: &[Group]) -> Vec<(Kind, bool)> {
    let chosen = changes.iter().filter(|change| groups.contains(&change.group()));
    chosen.map(|change| (change.kind, change.breaking)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 10, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn one_edit_is_one_change(model in model(), at: Index) {
        let old = of(&model.xml());
        for (number, edit) in EDITS.into_iter().enumerate() {
            let mut edited = model.clone();
            let Some((wire, api)) = edit(&mut edited, &at) else { continue };
            let changes = compare(&old, &of(&edited.xml()), None).unwrap();
            let told: Vec<String> = changes.iter().map(shown).collect();
            // A checksum may be the same by chance: then a new name is none on the wire.
            let chance = changes.iter().any(|change| {
                matches!(change.kind, Kind::FieldName | Kind::MessageName)
                    && change.frame.is_none_or(|frame| frame.crc_extra.0 == frame.crc_extra.1)
            });
            if !chance {
                prop_assert_eq!(kinds(&changes, &[Group::Wire, Group::Enums]), vec![wire], "edit {}: {:#?}", number, told);
            }
            prop_assert_eq!(kinds(&changes, &[Group::Api]), Vec::from_iter(api), "edit {}: {:#?}", number, told);
            prop_assert_eq!(kinds(&changes, &[Group::Metadata]), vec![], "edit {}: {:#?}", number, told);
        }
    }

    #[test]
    fn a_dialect_is_the_same_as_itself(model in model()) {
        prop_assert_eq!(compare(&of(&model.xml()), &of(&model.xml()), None).unwrap(), vec![]);
    }

    /// Whatever changes a frame is told, with what it does to the frame; and forth and back the same number of messages differ.
    #[test]
    fn no_change_of_a_frame_is_missed(one in model(), other in model()) {
        let (old, new) = (of(&one.xml()), of(&other.xml()));
        let changes = compare(&old, &new, None).unwrap();
        for message in &old.messages {
            let about = |change: &&Change| {
                let item = change.item.split('.').next().unwrap();
                change.group() == Group::Wire && item == message.name.text
            };
            match new.messages.iter().find(|other| other.name == message.name) {
                Some(other) => {
                    let frames = [(message.crc_extra, other.crc_extra), (message.len_v1, other.len_v1), (message.len_v2, other.len_v2)];
                    if frames.iter().any(|(old, new)| old != new) {
                        let told = changes.iter().filter(about);
                        let told: Vec<_> = told.map(|change| change.frame.unwrap()).collect();
                        prop_assert!(!told.is_empty(), "{}", message.name.text);
                        prop_assert!(told.iter().all(|told| [told.crc_extra, told.len_v1, told.len_v2] == frames));
                    }
                }
                None => prop_assert_eq!(changes.iter().filter(about).count(), 1),
            }
        }
        let added = new.messages.iter().filter(|message| !old.messages.iter().any(|other| other.name == message.name));
        prop_assert_eq!(added.count(), changes.iter().filter(|change| change.kind == Kind::MessageAdded).count());
    }
}

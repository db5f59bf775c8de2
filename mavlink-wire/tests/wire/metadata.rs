//! Tables and the descriptions of messages, fields and parameters.

use mavlink_wire::generated::index;
use mavlink_wire::{Dialect, EnumInfo, FieldInfo, Invalid, Kind, Message, MessageInfo, ParamInfo, Sentinel, Table};

use crate::small::{AqEscTelemetry, Heartbeat, Small, Statustext};

const fn info(id: u32) -> MessageInfo {
    MessageInfo::new(id, "M", 0, 1)
}

const IDS: [u32; 14] = [0, 1, 24, 30, 150, 255, 256, 300, 331, 9000, 12900, 17000, 60053, 0x00FF_FFFF];

#[track_caller]
fn finds(table: &Table<'_>, ids: &[u32]) {
    for id in (0..70_000).chain([0x00FF_FFFE, 0x00FF_FFFF, u32::MAX]) {
        assert_eq!(table.get(id).map(|info| info.id), ids.contains(&id).then_some(id));
        assert_eq!(table.position(id), ids.iter().position(|known| *known == id));
    }
    assert_eq!((table.len(), table.is_empty()), (ids.len(), ids.is_empty()));
    assert!(table.iter().map(|info| info.id).eq(ids.iter().copied()));
}

#[test]
fn tables_find_what_is_in_them_and_nothing_else() {
    let all = IDS.map(info);
    let sorted: Vec<&MessageInfo> = all.iter().collect();
    let mut reversed = sorted.clone();
    reversed.reverse();
    let mut reversed_ids = IDS;
    reversed_ids.reverse();
    finds(&Table::of(&[]), &[]);
    finds(&Table::of(&sorted[2..5]), &IDS[2..5]);
    finds(&Table::of(&sorted), &IDS);
    finds(&Table::of(&reversed), &reversed_ids);
    finds(&Table::indexed(&sorted, &index::<1>(&sorted)), &IDS);
    finds(&Table::indexed(&sorted, &index::<301>(&sorted)), &IDS);
    finds(&Table::indexed(&reversed, &index::<301>(&reversed)), &reversed_ids);
    finds(Small::TABLE, &[0, 152, 253]);
}

/// As in a dialect of one's own, with ids that no index reaches.
#[test]
fn many_large_ids_are_found() {
    let ids: Vec<u32> = (0..200).map(|number| 10_000 + 3 * number).collect();
    let infos: Vec<MessageInfo> = ids.iter().map(|id| info(*id)).collect();
    let sorted: Vec<&MessageInfo> = infos.iter().collect();
    finds(&Table::of(&sorted), &ids);
    finds(&Table::indexed(&sorted, &index::<512>(&sorted)), &ids);
}

#[test]
fn of_two_messages_with_one_id_the_first_is_found() {
    static TWICE: [MessageInfo; 3] = [MessageInfo::new(7, "FIRST", 0, 1), info(7), info(600)];
    let infos: Vec<&MessageInfo> = TWICE.iter().collect();
    for table in [Table::of(&infos), Table::indexed(&infos, &index::<8>(&infos))] {
        assert_eq!(table.get(7).map(|info| info.name), Some("FIRST"));
        assert_eq!((table.position(7), table.position(600)), (Some(0), Some(2)));
    }
    // More than a search walks over.
    let many: Vec<&MessageInfo> = infos.iter().copied().cycle().take(30).collect();
    assert_eq!((Table::of(&many).position(7), Table::of(&many).position(600)), (Some(0), Some(2)));
}

#[test]
fn fields_fill_the_payload() {
    for (info, fields) in [
        (Heartbeat::INFO, Heartbeat::FIELDS),
        (AqEscTelemetry::INFO, AqEscTelemetry::FIELDS),
        (Statustext::INFO, Statustext::FIELDS),
    ] {
        let size = |extensions: bool| -> usize {
            fields.iter().filter(|field| extensions || !field.extension).map(FieldInfo::size).sum()
        };
        assert_eq!((size(false), size(true)), (info.len_v1.into(), info.len_v2.into()));
    }
}

#[test]
fn builders_set_what_they_name() {
    static VALUES: EnumInfo = EnumInfo::new("E", &[]);
    const UNKNOWN: Invalid = Invalid::All(Sentinel::Unsigned(65535));
    const FIELD: FieldInfo = FieldInfo::array("volts", Kind::U16, 10, 4).extension().units("mV").invalid(UNKNOWN);
    assert_eq!((FIELD.name, FIELD.kind, FIELD.array, FIELD.offset), ("volts", Kind::U16, Some(10), 4));
    assert_eq!((FIELD.extension, FIELD.units, FIELD.invalid), (true, Some("mV"), Some(UNKNOWN)));
    assert_eq!(FIELD.values(&VALUES).values, Some(&VALUES));
    const PARAM: ParamInfo = ParamInfo::new(3).label("Hold").units("s").min(0.0).max(9.0).increment(0.5).default(1.0);
    assert_eq!((PARAM.index, PARAM.label, PARAM.units, PARAM.values), (3, Some("Hold"), Some("s"), None));
    assert_eq!((PARAM.min, PARAM.max, PARAM.increment, PARAM.default), (Some(0.0), Some(9.0), Some(0.5), Some(1.0)));
    assert_eq!((PARAM.reserved, PARAM.reserved().reserved, PARAM.values("E").values), (false, true, Some("E")));
}

#[test]
fn kinds_have_the_names_that_enter_the_checksum() {
    assert_eq!((Kind::Version.wire_name(), Kind::Version.size()), ("uint8_t", 1));
    assert_eq!((Kind::F64.wire_name(), Kind::F64.size()), ("double", 8));
    assert_eq!((Kind::Char.wire_name(), Kind::I16.size(), Kind::U32.size()), ("char", 2, 4));
}

#[test]
fn a_dialect_knows_the_fields_of_its_messages() {
    for info in Small::TABLE.iter() {
        let fields = Small::fields(info.id).unwrap();
        assert_eq!(fields.iter().map(FieldInfo::size).sum::<usize>(), usize::from(info.len_v2), "{}", info.name);
    }
    assert_eq!(Small::fields(152), Some(<AqEscTelemetry as Message>::FIELDS));
    assert_eq!(Small::fields(1), None);
    assert_eq!(Small::fields(100_000), None);
}

/// Only dialects that are united have this; which name a value has must not depend on where a search begins.
#[test]
fn of_two_names_for_one_value_the_first_is_given() {
    for entries in 1..8 {
        let all = [(0, "LOW"), (1, "A"), (1, "B"), (1, "C"), (2, "HIGH"), (2, "HIGHER"), (3, "TOP")];
        let entries = &all[..entries];
        let info = mavlink_wire::EnumInfo::new("E", Vec::leak(entries.to_vec()));
        let first = |value: u64| entries.iter().find(|entry| entry.0 == value).map(|entry| entry.1);
        for value in 0..5 {
            assert_eq!(info.entry_name(value), first(value), "{value} of {entries:?}");
        }
        assert!(entries.iter().all(|&(value, name)| info.entry_value(name) == Some(value)));
    }
}

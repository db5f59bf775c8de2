//! Holds the metadata of a dialect against the definitions in the vectors.

use std::collections::BTreeSet;

use mavlink_wire::{Dialect, FieldInfo, Kind};

use crate::definition::Definition;
use crate::fault::{Check, Findings};
use crate::subject::Subject;

/// The dialect has exactly these messages; so has its table, and finds them by id.
pub fn check_messages<'d, D: Dialect>(
    subjects: &[Subject<D>],
    definitions: impl Iterator<Item = &'d Definition>,
    findings: &mut Findings,
) {
    let expected: BTreeSet<u32> = definitions.map(|definition| definition.id).collect();
    let subjects: BTreeSet<u32> = subjects.iter().map(|subject| subject.id).collect();
    findings.equal(Check::Messages, "subjects", &subjects, &expected);
    let table: BTreeSet<u32> = D::TABLE.iter().map(|info| info.id).collect();
    findings.equal(Check::Messages, "table", &table, &expected);
    findings.equal(Check::Messages, "table length", D::TABLE.len(), expected.len());
    for id in (0..1000).chain([1 << 16, 0xFF_FFFF, u32::MAX]) {
        let found = D::TABLE.get(id).map(|info| info.id);
        findings.equal(Check::Messages, "table", found, expected.contains(&id).then_some(id));
    }
}

/// `ID`, `INFO` and `FIELDS` of a message.
pub fn check_info<D: Dialect>(subject: &Subject<D>, definition: &Definition, findings: &mut Findings) {
    let (info, place) = (subject.info, definition.name.as_str());
    let found = (subject.id, info.id, info.name, info.crc_extra, info.len_v1, info.len_v2);
    let Definition { id, name, crc_extra, len_v1, len_v2, .. } = definition;
    findings.equal(Check::Info, place, found, (*id, *id, name, *crc_extra, *len_v1, *len_v2));
    findings.equal(Check::Info, place, D::TABLE.get(*id), Some(info));
    for (name, offset) in [("target_system", info.target_system), ("target_component", info.target_component)] {
        let target = definition.fields.iter().position(|field| {
            let manual_control = name == "target_system" && definition.name == "MANUAL_CONTROL";
            field.name == if manual_control { "target" } else { name }
        });
        let expected = target.map(|at| definition.offsets()[at] as u8);
        findings.equal(Check::Info, place, offset, expected);
    }
    check_fields(subject.fields, definition, findings);
}

fn check_fields(infos: &[FieldInfo], definition: &Definition, findings: &mut Findings) {
    let found = infos.iter().map(|info| {
        let ty = match info.kind {
            Kind::Version => "uint8_t_mavlink_version",
            kind => kind.wire_name(),
        };
        (info.name, ty, info.array, info.extension, usize::from(info.offset), info.size())
    });
    let fields = definition.fields.iter().zip(definition.offsets());
    let expected = fields.map(|(field, offset)| {
        let size = field.elements() * field.element_size();
        (field.name.as_str(), field.ty.as_str(), field.array, field.extension, offset, size)
    });
    findings.equal(Check::Fields, &definition.name, found.collect::<Vec<_>>(), expected.collect());
}

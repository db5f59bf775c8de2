//! Holds the frames of a case against what the generated code makes of its values, and its values against what the
//! generated code makes of its frames.

use mavlink_wire::{Dialect, Encode, EncodeError, Frame, MAX_FRAME, MAX_PAYLOAD, Parser, Sender, Version};

use crate::definition::Definition;
use crate::fault::{Check, Findings};
use crate::subject::Subject;
use crate::values::Values;
use crate::vectors::{Case, GoldenFrame, Vectors};
use crate::{facts, signature};

/// Every check of every message.
pub fn check<D: Dialect>(subjects: &[Subject<D>], vectors: &[Vectors]) -> Findings {
    let mut findings = Findings::default();
    facts::check_messages(subjects, vectors.iter().map(|vectors| &vectors.definition), &mut findings);
    for Vectors { definition, cases } in vectors {
        let Some(subject) = subjects.iter().find(|subject| subject.id == definition.id) else {
            continue;
        };
        findings.messages += 1;
        facts::check_info(subject, definition, &mut findings);
        for case in cases {
            check_case(subject, definition, case, &mut findings);
        }
    }
    findings
}

/// The frames of one case.
pub fn check_case<D: Dialect>(subject: &Subject<D>, definition: &Definition, case: &Case, findings: &mut Findings) {
    let place = &format!("{}, case {}", definition.name, case.name);
    check_encode(subject, case, place, findings);
    signature::check(case, place, findings);
    signature::check_runtime(subject, case, place, findings);
    signature::check_router(case, subject.id, place, findings);
    let golden = [(Version::V1, case.v1.as_ref()), (Version::V2, Some(&case.v2)), (Version::V2, Some(&case.signed))];
    for (version, frame) in golden {
        let Some(frame) = frame else { continue };
        let values = carried(definition, &case.values, version);
        Received { subject, case, frame, version, place, values }.check(findings);
        findings.frames += 1;
    }
    findings.cases += 1;
}

/// Values to frames.
fn check_encode<D: Dialect>(subject: &Subject<D>, case: &Case, place: &str, findings: &mut Findings) {
    let message = (subject.build)(&case.values);
    let in_dialect = (subject.build_in_dialect)(&case.values);
    let refusal = EncodeError::IdTooLarge { message_id: subject.id };
    let v1 = case.v1.as_ref().map(GoldenFrame::bytes).ok_or(refusal);
    findings.equal(Check::IdTooLarge, place, v1.is_err(), subject.id > 255);
    for (version, expected) in [(Version::V1, v1), (Version::V2, Ok(case.v2.bytes()))] {
        let check = if expected.is_err() { Check::IdTooLarge } else { Check::Encode };
        findings.equal(check, place, encode(case, version, &*message), expected.clone());
        findings.equal(Check::EncodeInDialect, place, encode(case, version, &in_dialect), expected);
    }
}

fn encode(case: &Case, version: Version, message: &dyn Encode) -> Result<Vec<u8>, EncodeError> {
    let mut sender = match version {
        Version::V1 => Sender::v1(case.system, case.component),
        Version::V2 => Sender::v2(case.system, case.component),
    };
    sender.set_sequence(case.sequence);
    sender.encode(message, &mut [0xA5; MAX_FRAME]).map(<[u8]>::to_vec)
}

/// What a frame of this version carries of the values: MAVLink 1 leaves out extensions, which then are zero.
fn carried(definition: &Definition, values: &Values, version: Version) -> Values {
    let fields = definition.fields.iter().zip(values);
    let carried = fields.map(|(field, values)| {
        let lost = field.extension && version == Version::V1;
        if lost { vec![0; values.len()] } else { values.clone() }
    });
    carried.collect()
}

/// A frame that arrives.
struct Received<'a, D> {
    subject: &'a Subject<D>,
    case: &'a Case,
    frame: &'a GoldenFrame,
    version: Version,
    place: &'a str,
    values: Values,
}

impl<D: Dialect> Received<'_, D> {
    fn check(&self, findings: &mut Findings) {
        let bytes = self.frame.bytes();
        let (mut parser, mut input) = (Parser::new(D::TABLE), &bytes[..]);
        let frame = parser.next(&mut input);
        findings.equal(Check::Parse, self.place, frame.is_some(), true);
        let Some(frame) = frame else { return };
        self.check_frame(&frame, &bytes, findings);
        self.check_decode(&frame, findings);
        self.check_dialect(&frame, findings);
        findings.equal(Check::Parse, self.place, (input.len(), parser.next(&mut input)), (0, None));
    }

    fn check_frame(&self, frame: &Frame<'_>, bytes: &[u8], findings: &mut Findings) {
        let Case { sequence, system, component, .. } = *self.case;
        let header = (frame.version(), frame.sequence(), frame.system_id(), frame.component_id(), frame.message_id());
        let expected = (self.version, sequence, system.into(), component.into(), self.subject.id);
        findings.equal(Check::Parse, self.place, header, expected);
        findings.equal(Check::Parse, self.place, frame.is_verified(), true);
        findings.equal(Check::Parse, self.place, (frame.bytes(), frame.payload()), (bytes, &self.frame.payload[..]));
        let signature = frame.signature().map(|signature| signature.bytes().to_vec());
        let expected = Some(self.frame.signature.clone()).filter(|signature| !signature.is_empty());
        findings.equal(Check::Parse, self.place, signature, expected);
        let stamp = frame.signature().map(|signature| (signature.link_id(), signature.timestamp().units()));
        let expected = frame.signature().map(|_| (self.case.link, self.case.timestamp));
        findings.equal(Check::Parse, self.place, stamp, expected);
    }

    fn check_decode(&self, frame: &Frame<'_>, findings: &mut Findings) {
        let decoded = (self.subject.decode_frame)(frame);
        findings.equal(Check::Decode, self.place, decoded.as_ref().map(|decoded| &decoded.values), Some(&self.values));
        let Some(decoded) = decoded else { return };
        let mut buffer = [0xA5; MAX_PAYLOAD];
        let payload = decoded.message.payload(self.version, &mut buffer);
        findings.equal(Check::Reencode, self.place, payload, &self.frame.payload);
    }

    fn check_dialect(&self, frame: &Frame<'_>, findings: &mut Findings) {
        let mut into = D::DEFAULT;
        let found = frame.decode_into(&mut into);
        findings.equal(Check::DecodeInDialect, self.place, found, true);
        for message in [frame.message::<D>(), Some(into)] {
            let values = message.and_then(self.subject.values_in_dialect);
            findings.equal(Check::DecodeInDialect, self.place, values.as_ref(), Some(&self.values));
        }
    }
}

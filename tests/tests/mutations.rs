//! The checks notice mistakes: every mutant of a dialect fails them, every mutant of the vectors too, and the dialect
//! without a mistake passes.

#![allow(deprecated, reason = "what is deprecated is tested like the rest")]
#![allow(
    dead_code,
    unreachable_pub,
    clippy::too_many_lines,
    reason = "generated code does not know where it is included"
)]

use std::collections::BTreeSet;
use std::sync::LazyLock;

use mavlink_autoquad::autoquad::Autoquad;
use mavlink_conformance::autoquad::SUBJECTS;
use mavlink_conformance::constants::{self, Constants};
use mavlink_conformance::definition::Definition;
use mavlink_conformance::fault::{Check, Findings};
use mavlink_conformance::frames;
use mavlink_conformance::random::Random;
use mavlink_conformance::subject::Subject;
use mavlink_conformance::vectors::{self, Case, GoldenFrame, Vectors};
use mavlink_wire::Dialect;

include!(concat!(env!("OUT_DIR"), "/mutants.rs"));

/// A dialect of `standard.xml` with one mistake, checked.
struct Mutant {
    name: &'static str,
    kinds: BTreeSet<Check>,
    messages: usize,
}

impl Mutant {
    fn of<D: Dialect>(name: &'static str, subjects: &[Subject<D>], constants: &[Constants]) -> Self {
        let mut expected = constants::read(constants::AUTOQUAD);
        expected.retain(|expected| constants.iter().any(|constants| constants.name() == expected.name));
        let findings = frames::check(subjects, &STANDARD);
        let mut kinds = findings.kinds();
        kinds.extend(constants::check(constants, &expected).kinds());
        Self { name, kinds, messages: findings.messages }
    }
}

/// The vectors of the messages in `standard.xml`.
static STANDARD: LazyLock<Vec<Vectors>> = LazyLock::new(|| {
    let mut vectors = vectors::read(vectors::AUTOQUAD);
    let names = ["HEARTBEAT", "GLOBAL_POSITION_INT", "AUTOPILOT_VERSION"];
    vectors.retain(|vectors| names.contains(&vectors.definition.name.as_str()));
    vectors
});

#[test]
fn every_mutant_fails_and_the_control_passes() {
    for Mutant { name, kinds, messages } in mutants() {
        println!("{name}: {kinds:?}");
        let expected: &[Check] = match name {
            "control" => &[],
            "field_name" | "field_order" | "no_extension" => &[Check::Info, Check::Fields, Check::Encode, Check::Parse],
            "crc_extra" => &[Check::Info, Check::Encode, Check::EncodeInDialect, Check::Parse],
            "id" => &[Check::Messages],
            "len_v1" | "len_v2" => &[Check::Info, Check::Encode, Check::Reencode],
            "decode_offset" => &[Check::Decode, Check::DecodeInDialect, Check::Reencode],
            "encode_offset" => &[Check::Encode, Check::EncodeInDialect, Check::Reencode],
            "offset" => &[Check::Encode, Check::Decode, Check::Fields],
            "field_info" => &[Check::Fields],
            "entry_value" => &[Check::Constants, Check::EnumInfo, Check::EnumText],
            "constant" | "bit" => &[Check::Constants],
            "entry_name" => &[Check::EnumInfo, Check::EnumText],
            other => panic!("what should notice {other}?"),
        };
        assert_eq!(messages, if name == "id" { 2 } else { 3 }, "{name}");
        assert!(kinds.is_superset(&expected.iter().copied().collect()), "{name} only fails {kinds:?}");
        assert_eq!(kinds.is_empty(), name == "control", "{name}");
    }
}

/// A wrong offset that encoder and decoder share is seen in the frames, though what was decoded encodes again as it was.
#[test]
fn a_round_trip_alone_would_not_notice_a_wrong_offset() {
    let offset = mutants().into_iter().find(|mutant| mutant.name == "offset").unwrap();
    assert!(!offset.kinds.contains(&Check::Reencode));
}

/// What of a case is damaged.
const PLACES: [fn(&mut Case, &mut Random); 12] = [
    |case, random| {
        let field = random.below(case.values.len());
        let element = random.below(case.values[field].len());
        // The lowest bit belongs to every type.
        case.values[field][element] ^= 1;
    },
    |case, random| flip(&mut case.v2.header, random),
    |case, random| flip(&mut case.v2.payload, random),
    |case, random| flip(&mut case.v2.checksum, random),
    |case, random| flip(&mut case.signed.header, random),
    |case, random| flip(&mut case.signed.payload, random),
    |case, random| flip(&mut case.signed.checksum, random),
    |case, random| flip(&mut case.signed.signature, random),
    |case, random| flip(&mut v1(case).header, random),
    |case, random| flip(&mut v1(case).payload, random),
    |case, random| flip(&mut v1(case).checksum, random),
    |case, _| case.timestamp ^= 1,
];

/// The MAVLink 1 frame; one without bytes where there should be none, which is a mistake as well.
fn v1(case: &mut Case) -> &mut GoldenFrame {
    case.v1.get_or_insert_default()
}

fn flip(bytes: &mut [u8], random: &mut Random) {
    let bit = random.below(8 * bytes.len().max(1));
    if let Some(byte) = bytes.get_mut(bit / 8) {
        *byte ^= 1 << (bit % 8);
    }
}

#[test]
fn every_flipped_bit_of_the_vectors_is_noticed() {
    let (mut random, mut flipped) = (Random::new(0x464C_4950), 0);
    for Vectors { definition, cases } in vectors::read(vectors::AUTOQUAD) {
        let subject: &Subject<Autoquad> = SUBJECTS.iter().find(|subject| subject.id == definition.id).unwrap();
        for (place, damage) in PLACES.iter().enumerate() {
            let mut case = cases[random.below(cases.len())].clone();
            damage(&mut case, &mut random);
            let mut findings = Findings::default();
            frames::check_case(subject, &definition, &case, &mut findings);
            assert!(!findings.faults.is_empty(), "{} {}: damage in {place} is not noticed", definition.name, case.name);
            flipped += 1;
        }
    }
    assert!(flipped >= 2_800, "{flipped}");
}

/// A fact in a `message` line that is wrong is noticed too.
#[test]
fn every_wrong_fact_is_noticed() {
    const FACTS: [fn(&mut Definition); 8] = [
        |definition| definition.crc_extra ^= 1,
        |definition| definition.len_v1 -= 1,
        |definition| definition.len_v2 -= 1,
        |definition| definition.name.push('_'),
        |definition| definition.fields[0].name.push('_'),
        |definition| definition.fields[0].extension ^= true,
        |definition| definition.fields[0].array = Some(1),
        |definition| definition.id += 1000,
    ];
    let mut facts = vectors::read(vectors::AUTOQUAD);
    for vectors in &mut facts {
        vectors.cases.clear();
    }
    assert!(frames::check(&SUBJECTS, &facts).faults.is_empty());
    for at in (0..SUBJECTS.len()).step_by(10) {
        for (fact, damage) in FACTS.iter().enumerate() {
            let mut wrong = facts.clone();
            damage(&mut wrong[at].definition);
            let name = &facts[at].definition.name;
            assert!(!frames::check(&SUBJECTS, &wrong).faults.is_empty(), "{name}: fact {fact}");
        }
    }
}

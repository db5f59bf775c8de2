//! The library that the other tests rest on.

use mavlink_conformance::payload::Fill;
use mavlink_conformance::random::Random;
use mavlink_conformance::vectors::{Vectors, read};

#[test]
fn a_vector_file_is_read() {
    let text = "# note\n\nmessage 300 M crc_extra=7 len_v2=13 len_v1=12 a:uint8_t b:uint16_t d:float[2] +c:int8_t\n\
                case x 01 02 03 04 00000000ff05\nvalues 01 0203 3f800000*2 fe\n\
                v2 fd 0102,00*5,03 aabb\nsigned fd01 03 ccdd 00*12,01\n";
    let [Vectors { definition, cases }] = &read(text)[..] else { panic!("one message") };
    assert_eq!((definition.id, definition.crc_extra, definition.offsets()), (300, 7, vec![10, 8, 0, 11]));
    let [case] = &cases[..] else { panic!("one case") };
    assert_eq!((case.component, case.link, case.timestamp), (3, 4, 0xff05));
    assert_eq!(case.values, [vec![1], vec![0x203], vec![0x3f80_0000; 2], vec![0xfe]]);
    assert_eq!((&case.v1, &case.v2.payload[..]), (&None, &[1, 2, 0, 0, 0, 0, 0, 3][..]));
    assert_eq!((case.v2.bytes().len(), case.signed.signature.len()), (11, 13));
}

#[test]
fn signalling_nans_are_signalling() {
    let payload = Fill::SignallingNan.payload(240, &mut Random::new(1));
    for bytes in payload.chunks(4) {
        let value = f32::from_le_bytes(bytes.try_into().unwrap());
        assert!(value.is_nan() && value.to_bits() & 0x0040_0000 == 0, "{bytes:02x?}");
    }
}

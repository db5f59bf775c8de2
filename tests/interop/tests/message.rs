//! A dialect's enum as a `mavlink_core::Message`.

use mavlink_autoquad::autoquad::{Autoquad, EscInfo, ManualControl, ParamSet};
use mavlink_autoquad::wire::{Dialect, Encode, MAX_PAYLOAD, Message as _, Version};
use mavlink_core::error::ParserError;
use mavlink_core::{MavlinkVersion, Message};

/// Every message, with different bytes everywhere.
fn messages() -> Vec<Autoquad> {
    let payload: [u8; MAX_PAYLOAD] = std::array::from_fn(|at| at as u8 + 1);
    Autoquad::TABLE.iter().map(|info| <Autoquad as Dialect>::decode(info.id, &payload).unwrap()).collect()
}

fn payload(message: &Autoquad) -> Vec<u8> {
    message.payload(Version::V2, &mut [0; MAX_PAYLOAD]).to_vec()
}

#[test]
fn every_message_says_what_it_is() {
    for message in messages() {
        let info = message.info();
        assert_eq!((message.message_id(), message.message_name()), (info.id, info.name));
        assert_eq!(Autoquad::message_id_from_name(info.name), Some(info.id));
        assert_eq!(Autoquad::extra_crc(info.id), info.crc_extra);
    }
    assert_eq!(Autoquad::message_id_from_name("NO_SUCH_MESSAGE"), None);
    assert_eq!(Autoquad::extra_crc(0xff_ffff), 0);
}

#[test]
fn every_message_is_written_and_read() {
    for message in messages() {
        let mut bytes = [0xa5; MAX_PAYLOAD];
        let length = message.ser(MavlinkVersion::V2, &mut bytes);
        assert_eq!(bytes[..length], payload(&message));
        let back = Autoquad::parse(MavlinkVersion::V2, message.message_id(), &bytes[..length]).unwrap();
        assert_eq!(payload(&back), payload(&message));
        assert_eq!(message.ser(MavlinkVersion::V1, &mut bytes), usize::from(message.info().len_v1));
        assert_eq!(message.ser(MavlinkVersion::V2, &mut []), 0, "no panic without room");
    }
    let unknown = Autoquad::parse(MavlinkVersion::V2, 0xff_ffff, &[]);
    assert!(matches!(unknown, Err(ParserError::UnknownMessage { id: 0xff_ffff })));
}

#[test]
fn defaults_are_those_of_the_messages() {
    for info in Autoquad::TABLE.iter() {
        assert_eq!(Autoquad::default_message_from_id(info.id).unwrap().info(), info);
    }
    assert_eq!(Autoquad::default_message_from_id(0), Some(Autoquad::DEFAULT), "with the version of the XML");
    assert_eq!(Autoquad::default_message_from_id(0xff_ffff), None);
}

#[test]
fn targets_are_read_and_rewritten() {
    let mut targeted = 0;
    for mut message in messages() {
        let info = message.info();
        let before = (message.target_system_id(), message.target_component_id());
        assert_eq!(
            (before.0.is_some(), before.1.is_some()),
            (info.target_system.is_some(), info.target_component.is_some())
        );
        if let Some(system) = message.target_system_id_mut() {
            assert_eq!(Some(*system), before.0);
            *system = 251;
            targeted += 1;
        }
        if let Some(component) = message.target_component_id_mut() {
            assert_eq!(Some(*component), before.1);
            *component = 252;
        }
        let after = (message.target_system_id(), message.target_component_id());
        assert_eq!(after, (before.0.map(|_| 251), before.1.map(|_| 252)), "{}", info.name);
    }
    assert!(targeted > 70, "{targeted}");
    let mut control = Autoquad::ManualControl(ManualControl { target: 9, ..ManualControl::DEFAULT });
    assert_eq!(control.target_system_id(), Some(9));
    *control.target_system_id_mut().unwrap() = 10;
    assert!(matches!(control, Autoquad::ManualControl(ManualControl { target: 10, .. })));
    assert_eq!(Autoquad::from(EscInfo::DEFAULT).target_system_id_mut(), None);
    assert_eq!(Autoquad::from(ParamSet::DEFAULT).target_component_id(), Some(0));
}

#[cfg(feature = "arbitrary")]
#[test]
fn random_messages_are_of_the_id_that_is_asked_for() {
    use rand::SeedableRng;
    let mut random = rand::rngs::StdRng::seed_from_u64(1);
    for info in Autoquad::TABLE.iter() {
        let [one, two] = [(); 2].map(|()| Autoquad::random_message_from_id(info.id, &mut random).unwrap());
        assert_eq!((one.info(), two.info()), (info, info));
        assert!(payload(&one) != payload(&two) || info.len_v2 < 4, "{}", info.name);
    }
    assert_eq!(Autoquad::random_message_from_id(0xff_ffff, &mut random), None);
}

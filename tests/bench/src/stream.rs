//! A telemetry stream: 59 messages of `common.xml` in random order, frequent ones more often.

use mavlink_autoquad::autoquad::*;
use mavlink_autoquad::wire::{Dialect as _, FieldInfo, MAX_FRAME, MAX_PAYLOAD, Message, MessageInfo, Sender};

use crate::corpus::Corpus;
use crate::random::Random;

/// How many frames.
const FRAMES: usize = 100_000;

/// What may be sent: how often, and of what it is made.
struct Kind {
    weight: usize,
    info: &'static MessageInfo,
    fields: &'static [FieldInfo],
}

impl Kind {
    const fn of<M: Message>(weight: usize) -> Self {
        Self { weight, info: M::INFO, fields: M::FIELDS }
    }
}

macro_rules! kinds {
    ($($weight:literal: $($message:ident)*;)*) => { [$($(Kind::of::<$message>($weight),)*)*] };
}

static KINDS: [Kind; 59] = kinds! {
    20: Attitude AttitudeQuaternion LocalPositionNed GlobalPositionInt HighresImu ServoOutputRaw;
    10: RawImu ScaledImu ScaledImu2 RcChannels RcChannelsRaw VfrHud AttitudeTarget PositionTargetLocalNed EscStatus
        ActuatorOutputStatus Odometry ManualControl RcChannelsOverride;
    5: GpsRawInt Gps2Raw NavControllerOutput ScaledPressure ScaledPressure2 Altitude Vibration DistanceSensor
       OpticalFlowRad WindCov EstimatorStatus EscInfo MountOrientation GimbalDeviceAttitudeStatus HilSensor SimState;
    2: Heartbeat SysStatus BatteryStatus SystemTime Timesync PowerStatus ExtendedSysState RadioStatus HomePosition
       GpsGlobalOrigin LinkNodeStatus ObstacleDistance HighLatency2 AdsbVehicle;
    1: Statustext ParamValue ParamSet CommandLong CommandInt CommandAck MissionCurrent MissionItemInt MissionCount
       AutopilotVersion;
};

/// The stream, as one MAVLink 2 sender makes it. Enum fields have values that rust-mavlink knows, half of the frames have
/// extensions, everything else is random.
#[must_use]
pub fn stream() -> Corpus {
    let (mut random, mut corpus, mut sender) = (Random::new(1), Corpus::default(), Sender::v2(1, 1));
    let kinds: Vec<&Kind> = KINDS.iter().flat_map(|kind| std::iter::repeat_n(kind, kind.weight)).collect();
    let (mut message, mut buffer) = (Autoquad::DEFAULT, [0; MAX_FRAME]);
    while corpus.frames.len() < FRAMES {
        let Some(kind) = kinds.get(random.below(kinds.len())) else { break };
        message.decode_into(kind.info.id, &payload(kind, &mut random));
        let sequence = sender.sequence();
        let accepted = sender.encode(&message, &mut buffer).is_ok_and(|frame| corpus.push(frame).is_ok());
        if !accepted {
            sender.set_sequence(sequence);
        }
    }
    corpus
}

fn payload(kind: &Kind, random: &mut Random) -> [u8; MAX_PAYLOAD] {
    let mut payload = [0; MAX_PAYLOAD];
    let with_extensions = random.once_in(2);
    for field in kind.fields {
        if field.extension && !with_extensions {
            continue;
        }
        let size = field.kind.size();
        let start = usize::from(field.offset);
        let length = size * usize::from(field.array.unwrap_or(1));
        let Some(bytes) = payload.get_mut(start..start + length) else { continue };
        for element in bytes.chunks_mut(size) {
            let bits = value(field, random).to_le_bytes();
            element.iter_mut().zip(bits).for_each(|(to, from)| *to = from);
        }
    }
    payload
}

/// Random bits; of an enum an entry, of a bitmask a few.
fn value(field: &FieldInfo, random: &mut Random) -> u64 {
    let Some(values) = field.values else { return random.bits() };
    let mut entry = || values.entries.get(random.below(values.entries.len())).map_or(0, |&(value, _)| value);
    if values.bitmask { entry() | entry() } else { entry() }
}

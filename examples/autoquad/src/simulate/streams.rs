//! What the vehicle sends, how often, and how it is asked for that.

use std::collections::BTreeSet;

use mavlink_autoquad::autoquad::{
    Autoquad, CommandAck, CommandLong, DataStream, MavCmd, MavDataStream, MavResult, RequestDataStream,
};
use mavlink_autoquad::wire::{ComponentId, Frame, Message, SystemId};

/// Times of a second that AutoQuad sends motor telemetry at most.
const MAX_RATE_HZ: u16 = 200;

/// What a command calls all datasets.
const ALL_DATASETS: u16 = 3;

/// The datasets of `AQ_TELEMETRY_F` that are simulated: estimate, supervisor, motors.
pub(super) const DATASETS: [u16; 3] = [5, 6, 9];

/// What has been asked for.
#[derive(Clone, Debug)]
pub(super) struct Streams {
    /// Times of a second that motor telemetry is sent; 0 if it is not.
    pub(super) propulsion_hz: u16,
    /// Which datasets of `AQ_TELEMETRY_F` are sent.
    pub(super) datasets: BTreeSet<u16>,
    /// After how many microseconds they are sent again: one interval for all.
    pub(super) dataset_interval_us: u64,
}

impl Streams {
    /// Nothing but what every AutoQuad sends.
    pub(super) fn off() -> Self {
        Self { propulsion_hz: 0, datasets: BTreeSet::new(), dataset_interval_us: 200_000 }
    }

    /// Everything, as if somebody had asked for it.
    pub(super) fn on(propulsion_hz: u16) -> Self {
        Self { propulsion_hz: propulsion_hz.min(MAX_RATE_HZ), datasets: DATASETS.into(), ..Self::off() }
    }

    /// Does what a frame asks for, and gives the answer; `None` if it asks for nothing.
    pub(super) fn receive(&mut self, frame: &Frame<'_>, own: (SystemId, ComponentId)) -> Option<Autoquad> {
        let is_own = |system: u8, component: u8| {
            (system == 0 || own.0 == SystemId::from_u8(system))
                && (component == 0 || own.1 == ComponentId::from_u8(component))
        };
        match frame.message()? {
            Autoquad::RequestDataStream(request) if is_own(request.target_system, request.target_component) => {
                self.request(&request).map(Autoquad::from)
            }
            Autoquad::CommandLong(command) if is_own(command.target_system, command.target_component) => {
                let result = self.command(&command);
                Some(CommandAck { command: command.command, result, ..CommandAck::DEFAULT }.into())
            }
            _ => None,
        }
    }

    /// Motor telemetry is the only stream that can be chosen.
    fn request(&mut self, request: &RequestDataStream) -> Option<DataStream> {
        if request.req_stream_id != MavDataStream::PROPULSION {
            return None;
        }
        let rate = if request.start_stop == 0 { 0 } else { request.req_message_rate.min(MAX_RATE_HZ) };
        self.propulsion_hz = rate;
        Some(DataStream { stream_id: request.req_stream_id, message_rate: rate, on_off: u8::from(rate > 0) })
    }

    fn command(&mut self, command: &CommandLong) -> MavResult {
        if command.command != MavCmd::AQ_TELEMETRY {
            return MavResult::UNSUPPORTED;
        }
        let (on, interval_us, dataset) = (command.param1 != 0.0, command.param2, command.param3 as u16);
        let known: Vec<u16> = match dataset {
            ALL_DATASETS => DATASETS.into(),
            _ => DATASETS.into_iter().filter(|&known| known == dataset).collect(),
        };
        if known.is_empty() {
            return MavResult::DENIED;
        }
        if interval_us >= 1.0 {
            self.dataset_interval_us = interval_us as u64;
        }
        for dataset in known {
            if on {
                self.datasets.insert(dataset);
            } else {
                self.datasets.remove(&dataset);
            }
        }
        MavResult::ACCEPTED
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use mavlink_autoquad::wire::{Dialect, Encode, MAX_FRAME, Sender};

    fn ask(streams: &mut Streams, message: &dyn Encode) -> Option<Autoquad> {
        let mut buffer = [0; MAX_FRAME];
        let bytes = Sender::v1(255, 190).encode(message, &mut buffer).unwrap();
        let frame = Frame::parse(bytes, Autoquad::TABLE).unwrap();
        streams.receive(&frame, (1.into(), 1.into()))
    }

    #[test]
    fn motor_telemetry_starts_and_stops_on_request() {
        let mut streams = Streams::off();
        let start = RequestDataStream {
            req_stream_id: MavDataStream::PROPULSION,
            req_message_rate: 1000,
            start_stop: 1,
            ..RequestDataStream::DEFAULT
        };
        let answer = DataStream { stream_id: MavDataStream::PROPULSION, message_rate: 200, on_off: 1 };
        assert_eq!(ask(&mut streams, &start), Some(answer.into()));
        assert_eq!(streams.propulsion_hz, 200);
        assert_eq!(ask(&mut streams, &RequestDataStream { target_system: 2, start_stop: 0, ..start }), None);
        assert_eq!(ask(&mut streams, &RequestDataStream { req_stream_id: MavDataStream::ALL, ..start }), None);
        assert_eq!(streams.propulsion_hz, 200);
        ask(&mut streams, &RequestDataStream { target_system: 1, target_component: 1, start_stop: 0, ..start });
        assert_eq!(streams.propulsion_hz, 0);
    }

    #[test]
    fn datasets_start_and_stop_by_command() {
        let mut streams = Streams::off();
        let mut command = CommandLong {
            command: MavCmd::AQ_TELEMETRY,
            param1: 1.0,
            param2: 100_000.0,
            param3: 9.0,
            ..CommandLong::DEFAULT
        };
        let result = |answer| match answer {
            Some(Autoquad::CommandAck(ack)) => ack.result,
            other => panic!("{other:?}"),
        };
        assert_eq!(result(ask(&mut streams, &command)), MavResult::ACCEPTED);
        assert_eq!(
            (streams.datasets.iter().copied().collect::<Vec<_>>(), streams.dataset_interval_us),
            (vec![9], 100_000)
        );
        command.param3 = 3.0;
        ask(&mut streams, &command);
        assert_eq!(streams.datasets.len(), DATASETS.len());
        command.param1 = 0.0;
        ask(&mut streams, &command);
        assert!(streams.datasets.is_empty());
        command.param3 = 77.0;
        assert_eq!(result(ask(&mut streams, &command)), MavResult::DENIED);
        command.command = MavCmd::NAV_LAND;
        assert_eq!(result(ask(&mut streams, &command)), MavResult::UNSUPPORTED);
    }
}

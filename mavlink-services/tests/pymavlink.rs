//! Parameters and plans with pymavlink's helpers (mavutil, mavparm, mavwp) at the other end of a UDP link, both ways.
//!
//! Needs Python with the packages of `tests/oracle/requirements.txt`:
//! `PYMAVLINK_PYTHON=venv/bin/python cargo test -p mavlink-services --test pymavlink -- --ignored`
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]

use std::env;
use std::io::ErrorKind;
use std::net::{SocketAddr, UdpSocket};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant as Clock};

use mavlink_services::common::{Common, Heartbeat, MavCmd, MavMissionResult, MavMissionType, MavState, Statustext};
use mavlink_services::mission::{self, Clear, Download, Form, MissionItem, Plan, PlanStore, Plans, SetCurrent, Upload};
use mavlink_services::param::{self, Encoding, List, ListProgress, Name, Param, ParamValue, Read, Which, Write};
use mavlink_services::{Address, Instant, Operation, Output, Service, Update};
use mavlink_wire::{Dialect, Encode, Frame, MAX_FRAME, Message, Sender};

/// A socket, a clock, and pymavlink behind them.
struct Peer {
    process: Child,
    socket: UdpSocket,
    peer: SocketAddr,
    sender: Sender,
    start: Clock,
}

impl Peer {
    /// Starts pymavlink, and waits until it says something.
    fn new(role: &str, encoding: &str, sender: Sender) -> Self {
        let python = env::var("PYMAVLINK_PYTHON").unwrap_or_else(|_| "python3".to_owned());
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        let port = socket.local_addr().unwrap().port().to_string();
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/oracle/services.py");
        let process =
            Command::new(python).args([script, role, &port, encoding]).stdout(Stdio::piped()).spawn().unwrap();
        let (_, peer) = socket.recv_from(&mut [0; MAX_FRAME]).expect("pymavlink starts within 30 s");
        Self { process, socket, peer, sender, start: Clock::now() }
    }

    fn now(&self) -> Instant {
        Instant::ZERO + self.start.elapsed()
    }

    fn send(&mut self, message: &dyn Encode) {
        let mut buffer = [0; MAX_FRAME];
        let bytes = self.sender.encode(message, &mut buffer).unwrap();
        self.socket.send_to(bytes, self.peer).unwrap();
    }

    /// Sends what a machine wants, and tells its events.
    fn serve<S: Service>(&mut self, machine: &mut S, mut tell: impl FnMut(S::Event)) {
        while let Some(output) = machine.poll(self.now()) {
            match output {
                Output::Send(message) => self.send(&message),
                Output::Event(event) => tell(event),
            }
        }
    }

    /// The bytes of the next datagram, if one comes before the deadline.
    fn receive<'b>(&self, deadline: Option<Instant>, buffer: &'b mut [u8; 512]) -> Option<&'b [u8]> {
        let wait = deadline.map_or(Duration::from_millis(100), |deadline| deadline - self.now());
        self.socket.set_read_timeout(Some(wait.max(Duration::from_millis(1)))).unwrap();
        match self.socket.recv_from(buffer) {
            Ok((length, _)) => Some(&buffer[..length]),
            Err(error) if matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut) => None,
            Err(error) => panic!("{error}"),
        }
    }

    /// Runs an operation to its end.
    fn run<O: Operation>(
        &mut self,
        mut operation: O,
        mut told: impl FnMut(O::Progress),
    ) -> Result<O::Outcome, O::Failure> {
        loop {
            let mut end = None;
            self.serve(&mut operation, |event| match event {
                Update::Progress(progress) => told(progress),
                Update::Done(result) => end = Some(result),
            });
            if let Some(end) = end {
                return end;
            }
            let mut buffer = [0; 512];
            if let Some(bytes) = self.receive(operation.deadline(), &mut buffer) {
                operation.handle(&Frame::parse(bytes, Common::TABLE).unwrap(), self.now());
            }
        }
    }
}

impl Drop for Peer {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

fn station() -> Address {
    Address::new(255, 190)
}

fn vehicle() -> Address {
    Address::new(1, 1)
}

fn table(wide: i32) -> Vec<Param> {
    let mut table = vec![
        Param::new("A_UINT8", u8::MAX),
        Param::new("AN_INT8", i8::MIN),
        Param::new("A_UINT16", u16::MAX),
        Param::new("AN_INT16", i16::MIN),
        Param::new("A_UINT32", 16_777_216_u32),
        Param::new("AN_INT32", wide),
        Param::new("A_REAL32", -0.5_f32),
    ];
    table.extend((0..50_u16).map(|number| Param::new(&format!("P{number}"), number)));
    table
}

/// pymavlink is the station: gives what it printed, and the vehicle's parameters and plans afterwards.
fn serve_station(encoding: Encoding, name: &str) -> (Vec<String>, Vec<Param>, PlanStore<Vec<MissionItem>>) {
    let wide = if encoding == Encoding::Bytewise { -123_456_789 } else { -16_777_215 };
    let mut params = param::Component::new(vehicle(), encoding, table(wide));
    let plan = || Plan::new(vec![MissionItem::DEFAULT; 20], vec![MissionItem::DEFAULT; 20]);
    let store = PlanStore { mission: plan(), fence: plan(), rally: plan() };
    let mut plans = mission::Component::new(vehicle(), store);
    let mut peer = Peer::new("station", name, Sender::v2(1, 1));
    peer.send(&Heartbeat { system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT });
    while peer.process.try_wait().unwrap().is_none() {
        peer.serve(&mut params, |_| {});
        peer.serve(&mut plans, |_| {});
        let deadline = mavlink_services::earliest(params.deadline(), plans.deadline());
        let mut buffer = [0; 512];
        if let Some(bytes) = peer.receive(deadline, &mut buffer) {
            let (frame, now) = (Frame::parse(bytes, Common::TABLE).unwrap(), peer.now());
            params.handle(&frame, now);
            plans.handle(&frame, now);
        }
    }
    let said = std::io::read_to_string(peer.process.stdout.take().unwrap()).unwrap();
    assert!(peer.process.wait().unwrap().success(), "{said}");
    (said.lines().map(str::to_owned).collect(), params.parameters().clone(), plans.plans().clone())
}

#[test]
#[ignore = "needs Python with pymavlink"]
fn a_station_of_pymavlink_lists_sets_and_flies_our_vehicle() {
    for (encoding, name, wide) in
        [(Encoding::Bytewise, "bytewise", -123_456_789), (Encoding::Cast, "cast", -16_777_215)]
    {
        let (said, params, plans) = serve_station(encoding, name);
        let value = |param: &Param| f64::try_from(param.value).unwrap();
        let listed: Vec<_> = said.iter().filter_map(|line| line.strip_prefix("param ")).collect();
        assert_eq!(listed.len(), 57);
        for (line, param) in listed.iter().zip(table(wide)) {
            let parts: Vec<_> = line.split(' ').collect();
            let expected = (param.name.to_string(), param.value.kind().0.to_string());
            assert_eq!((parts[0], parts[1]), (&*expected.0, &*expected.1));
            assert_eq!(parts[2].parse(), Ok(value(&param)), "{line}");
        }
        for (name, expected) in
            [("A_UINT8", ParamValue::U8(5)), ("AN_INT32", ParamValue::I32(-77)), ("A_REAL32", ParamValue::F32(0.75))]
        {
            assert_eq!(params.iter().find(|param| param.name == name).unwrap().value, expected);
            let told = said.iter().find_map(|line| line.strip_prefix(&format!("set {name} "))).unwrap();
            assert_eq!(told.parse(), Ok(f64::try_from(expected).unwrap()));
        }
        for (plan, command) in [
            (MavMissionType::MISSION, MavCmd::NAV_WAYPOINT),
            (MavMissionType::FENCE, MavCmd::NAV_FENCE_CIRCLE_INCLUSION),
        ] {
            assert_eq!(plans.count(plan), Ok(12), "{name}");
            assert!(said.contains(&format!("upload 0 {}", plan.0)), "{said:?}");
            for seq in 0..12 {
                let item = plans.item(plan, seq).unwrap();
                let place = (475_000_000 + i32::from(seq) * 156_250, -82_500_000 - i32::from(seq) * 156_250);
                assert_eq!((item.command, item.x, item.y, item.params[0]), (command, place.0, place.1, f32::from(seq)));
                let (x, y) = (f64::from(place.0) / 1e7, f64::from(place.1) / 1e7);
                let line = format!("item {} {seq} {} {x:?} {y:?} {:?}", plan.0, command.0, f64::from(item.z));
                assert!(said.contains(&line), "{name}: {line} in {said:?}");
            }
        }
        assert_eq!(plans.count(MavMissionType::RALLY), Ok(0));
        assert!(said.contains(&"clear 0 2".to_owned()), "{said:?}");
    }
}

#[test]
#[ignore = "needs Python with pymavlink"]
fn our_station_lists_sets_and_flies_a_vehicle_of_pymavlink() {
    for (encoding, name, form) in [(Encoding::Bytewise, "bytewise", Form::Int), (Encoding::Cast, "cast", Form::Float)] {
        let mut peer = Peer::new("vehicle", name, Sender::v2(255, 190));
        let access = param::Access::new(station(), vehicle(), encoding);
        let mut values = [None; 40];
        let list = peer.run(List::new(access, [0; 8], peer.now()), |progress| {
            if let ListProgress::Value(listed) = progress {
                values[usize::from(listed.index.unwrap())] = Some(listed.value.unwrap());
            }
        });
        assert_eq!(list, Ok(40));
        for (number, value) in (0_i32..).zip(values) {
            let kind = u8::try_from([1, 2, 3, 4, 5, 6, 9][number as usize % 7]).unwrap();
            let expected = ParamValue::from(number).to_kind(mavlink_services::common::MavParamType(kind));
            assert_eq!(value, expected.ok());
        }
        for (name, number) in [("P0", 200.0), ("P1", -100.0), ("P5", -70_000.0), ("P6", 0.2)] {
            let name = Name::truncated(name);
            let told = peer.run(Write::new(access, name, number, peer.now()), |_| {}).unwrap();
            assert_eq!(Ok(told.value), ParamValue::from(number).to_kind(told.value.kind()));
            let read = peer.run(Read::new(access, Which::Name(name), peer.now()), |_| {}).unwrap();
            assert_eq!(read.value, told.value);
        }
        assert_eq!(
            peer.run(Write::new(access, Name::truncated("P0"), 256, peer.now()), |_| {}),
            Err(param::Failure::Value(param::ValueError::OutOfRange))
        );
        plans(&mut peer, mission::Access { form, ..mission::Access::new(station(), vehicle()) });
        peer.send(&Statustext::DEFAULT);
        assert!(peer.process.wait().unwrap().success());
    }
}

/// Plans of some lengths go there and back.
fn plans(peer: &mut Peer, access: mission::Access) {
    for (plan, count) in [(MavMissionType::MISSION, 60), (MavMissionType::FENCE, 5), (MavMissionType::RALLY, 1)] {
        let access = access.plan(plan);
        let item =
            |seq: i16| MissionItem::at(MavCmd::NAV_WAYPOINT, 47.5 + f64::from(seq) / 64.0, -8.25, f32::from(seq));
        let items: Vec<_> = (0..count).map(item).collect();
        let end = peer.run(Upload::new(access, &items, peer.now()), |_| {});
        assert_eq!(end.map(|end| end.count), Ok(count.cast_unsigned()));
        let mut fetched = vec![];
        let end = peer.run(Download::new(access, peer.now()), |item| fetched.push(item.item));
        assert_eq!((end.map(|end| end.count), fetched), (Ok(count.cast_unsigned()), items));
    }
    assert_eq!(peer.run(SetCurrent::new(access, 7, peer.now()), |_| {}), Ok(()));
    assert_eq!(peer.run(Clear::new(access, peer.now()), |_| {}), Ok(()));
    let end = peer.run(Download::new(access, peer.now()), |_| {});
    assert_eq!(end.map(|end| end.count), Ok(0));
    let refused = peer.run(Clear::new(access.plan(MavMissionType::RALLY), peer.now()), |_| {});
    assert_eq!(refused, Err(mission::Failure::Refused(MavMissionResult::DENIED)));
}

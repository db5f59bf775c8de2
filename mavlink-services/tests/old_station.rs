//! A component whose values are cast to floats, and plans, before pymavlink as an old station: its helpers mavutil, mavparm and mavwp.
//! Ignored unless asked for: `tests/services/check.sh` in the repository runs it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "a part of tests")]

use std::env;
use std::io::ErrorKind;
use std::net::{SocketAddr, UdpSocket};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant as Clock};

use mavlink_services::common::{Common, Heartbeat, MavCmd, MavMissionType, MavState};
use mavlink_services::mission::{self, MissionItem, Plan, PlanStore, Plans};
use mavlink_services::param::{self, Encoding, Param, ParamValue};
use mavlink_services::{Address, Instant, Output, Service, earliest};
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
    fn new(program: &str) -> Self {
        let python = env::var("PEERS_PYTHON").expect("PEERS_PYTHON is a Python with pymavlink");
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        let port = socket.local_addr().unwrap().port().to_string();
        let script = format!("{}/../tests/services/{program}.py", env!("CARGO_MANIFEST_DIR"));
        let process = Command::new(python).args([&script, &port]).stdout(Stdio::piped()).spawn().unwrap();
        let (_, peer) = socket.recv_from(&mut [0; MAX_FRAME]).expect("pymavlink starts within 30 s");
        Self { process, socket, peer, sender: Sender::v2(1, 1), start: Clock::now() }
    }

    fn now(&self) -> Instant {
        Instant::ZERO + self.start.elapsed()
    }

    fn send(&mut self, message: &dyn Encode) {
        let mut buffer = [0; MAX_FRAME];
        let bytes = self.sender.encode(message, &mut buffer).unwrap();
        self.socket.send_to(bytes, self.peer).unwrap();
    }

    /// Sends what a machine wants.
    fn serve<S: Service>(&mut self, machine: &mut S) {
        while let Some(output) = machine.poll(self.now()) {
            if let Output::Send(message) = output {
                self.send(&message);
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
}

impl Drop for Peer {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

fn table() -> Vec<Param> {
    let mut table = vec![
        Param::new("A_UINT8", u8::MAX),
        Param::new("AN_INT8", i8::MIN),
        Param::new("A_UINT16", u16::MAX),
        Param::new("AN_INT16", i16::MIN),
        Param::new("A_UINT32", 16_777_216_u32),
        Param::new("AN_INT32", -16_777_215),
        Param::new("A_REAL32", -0.5_f32),
    ];
    table.extend((0..50_u16).map(|number| Param::new(&format!("P{number}"), number)));
    table
}

/// What the station printed, and the vehicle's parameters and plans afterwards.
fn serve() -> (Vec<String>, Vec<Param>, PlanStore<Vec<MissionItem>>) {
    let vehicle = Address::new(1, 1);
    let mut params = param::Component::new(vehicle, Encoding::Cast, table());
    let plan = || Plan::new(vec![MissionItem::DEFAULT; 20], vec![MissionItem::DEFAULT; 20]);
    let store = PlanStore { mission: plan(), fence: plan(), rally: plan() };
    let mut plans = mission::Component::new(vehicle, store);
    let mut peer = Peer::new("pymavlink_old_station");
    peer.send(&Heartbeat { system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT });
    while peer.process.try_wait().unwrap().is_none() {
        peer.serve(&mut params);
        peer.serve(&mut plans);
        let mut buffer = [0; 512];
        if let Some(bytes) = peer.receive(earliest(params.deadline(), plans.deadline()), &mut buffer) {
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
#[ignore = "needs pymavlink"]
fn an_old_station_lists_sets_and_moves_plans_in_floats() {
    let (said, params, plans) = serve();
    let listed: Vec<_> = said.iter().filter_map(|line| line.strip_prefix("param ")).collect();
    assert_eq!(listed.len(), 57);
    for (line, param) in listed.iter().zip(table()) {
        let parts: Vec<_> = line.split(' ').collect();
        assert_eq!((parts[0], parts[1]), (&*param.name.to_string(), &*param.value.kind().0.to_string()));
        assert_eq!(parts[2].parse(), Ok(f64::try_from(param.value).unwrap()), "{line}");
    }
    for (name, expected) in
        [("A_UINT8", ParamValue::U8(5)), ("AN_INT32", ParamValue::I32(-77)), ("A_REAL32", ParamValue::F32(0.75))]
    {
        assert_eq!(params.iter().find(|param| param.name == name).unwrap().value, expected);
        let told = said.iter().find_map(|line| line.strip_prefix(&format!("set {name} "))).unwrap();
        assert_eq!(told.parse(), Ok(f64::try_from(expected).unwrap()));
    }
    let (mission, fence) = (MavMissionType::MISSION, MavMissionType::FENCE);
    for (plan, command) in [(mission, MavCmd::NAV_WAYPOINT), (fence, MavCmd::NAV_FENCE_CIRCLE_INCLUSION)] {
        assert_eq!(plans.count(plan), Ok(12));
        assert!(said.contains(&format!("upload 0 {}", plan.0)), "{said:?}");
        for seq in 0..12 {
            let item = plans.item(plan, seq).unwrap();
            let place = (475_000_000 + i32::from(seq) * 156_250, -82_500_000 - i32::from(seq) * 156_250);
            assert_eq!((item.command, item.x, item.y, item.params[0]), (command, place.0, place.1, f32::from(seq)));
            let (x, y) = (f64::from(place.0) / 1e7, f64::from(place.1) / 1e7);
            let line = format!("item {} {seq} {} {x:?} {y:?} {:?}", plan.0, command.0, f64::from(item.z));
            assert!(said.contains(&line), "{line} in {said:?}");
        }
    }
    assert_eq!(plans.count(MavMissionType::RALLY), Ok(0));
    assert!(said.contains(&"clear 0 2".to_owned()), "{said:?}");
}

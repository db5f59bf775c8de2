//! Parameters and a mission over the loopback interface, by the services and written by hand on sockets:
//! `cargo run --release --bin services`.
//!
//! The same messages go over TCP both ways, a write for each: over UDP, a thousand datagrams without a pause would be lost in part, and
//! what is measured would be timeouts.
//!
//! Where the threads run decides more than what they do: to wake a thread on an idle processor takes several times as long as an
//! exchange. So each place is measured by itself, the same for all contenders: both ends on one processor, an end on each of two, and
//! wherever the system puts them.

use std::error::Error;
use std::io::{ErrorKind, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::thread;
use std::time::Duration;

use mavlink_bench::rounds::{Contender, compare};
use mavlink_services::common::{
    Common, Heartbeat, MavCmd, MavFrame, MavParamType, MavResult, MissionAck, MissionCount, MissionItemInt,
    MissionRequestInt, ParamRequestList, ParamValue,
};
use mavlink_services::heartbeat::Beacon;
use mavlink_services::mission::{MissionItem, Plan, PlanStore};
use mavlink_services::param::{self, ComponentOptions, Encoding, Param};
use mavlink_services::vehicle::{Event, Vehicle};
use mavlink_services::{Address, Instant, Output, Service, Station};
use mavlink_wire::link::{Link, Options};
use mavlink_wire::{Chars, Dialect, Encode, Frame, MAX_FRAME, Message, Parser, Sender, Targeted};
use rustix::thread::{CpuSet, sched_getaffinity, sched_setaffinity};

const PARAMETERS: u16 = 1000;
const ITEMS: u16 = 300;

fn main() -> Result<(), Box<dyn Error>> {
    let allowed = sched_getaffinity(None)?;
    let mut processors = (0..CpuSet::MAX_CPU).rev().filter(|&processor| allowed.is_set(processor));
    let first = processors.next().ok_or("some processor")?;
    measure("both ends on one processor", only(first), only(first))?;
    if let Some(second) = processors.next() {
        measure("an end on each of two processors", only(first), only(second))?;
        measure("where the system puts them", allowed, allowed)?;
    }
    Ok(())
}

fn only(processor: usize) -> CpuSet {
    let mut set = CpuSet::new();
    set.set(processor);
    set
}

/// Measures with the stations here and the vehicles there.
fn measure(place: &str, stations: CpuSet, vehicles: CpuSet) -> Result<(), Box<dyn Error>> {
    println!("{place}:");
    sched_setaffinity(None, &stations)?;
    let mut station = services(vehicles, true)?;
    let mut one_by_one = services(vehicles, false)?;
    let listener = TcpListener::bind("127.0.0.1:0")?;
    let mut by_hand = ByHand::new(TcpStream::connect(listener.local_addr()?)?, 255)?;
    let (stream, _) = listener.accept()?;
    thread::spawn(move || {
        sched_setaffinity(None, &vehicles)?;
        ByHand::new(stream, 1)?.serve()
    });
    let items: Vec<_> = (0..ITEMS).map(item).collect();
    compare(
        "1,000 parameters",
        vec![
            Contender::new("services", || station.params(|_, _| {}).map_or(0, |params| params.len())),
            Contender::new("services, a write each", || one_by_one.params(|_, _| {}).map_or(0, |params| params.len())),
            Contender::new("by hand", || by_hand.list().unwrap_or(0)),
        ],
    );
    compare(
        "mission of 300 items",
        vec![
            Contender::new("services", || station.upload(&items).map_or(0, |sent| sent.count.into())),
            Contender::new("by hand", || by_hand.upload(&items).unwrap_or(0)),
        ],
    );
    Ok(())
}

/// A station of the services, whose vehicle runs there. It gathers its messages, or writes each for itself.
fn services(vehicles: CpuSet, gathers: bool) -> Result<Station, Box<dyn Error>> {
    // It ends with its station.
    let options = Options::new(Common::TABLE, Sender::v2(1, 1)).without_reconnecting();
    let vehicle = Link::connect("tcpin:127.0.0.1:0", options)?;
    let address = format!("tcpout:{}", vehicle.local_addr().ok_or("a listener has an address")?);
    thread::spawn(move || {
        sched_setaffinity(None, &vehicles)?;
        serve(vehicle, gathers)
    });
    Ok(Station::connect(&address)?)
}

fn item(seq: u16) -> MissionItem {
    MissionItem::at(MavCmd::NAV_WAYPOINT, 47.0 + f64::from(seq) / 1000.0, 8.0, 30.0)
}

fn name(index: u16) -> Chars<16> {
    Chars::truncated(&format!("PARAM_{index}"))
}

/// The vehicle of the services.
fn serve(mut link: Link, gathers: bool) -> Result<(), Box<dyn Error + Send + Sync>> {
    let table: Vec<_> =
        (0..PARAMETERS).map(|index| Param { name: name(index), value: f32::from(index).into() }).collect();
    let plan = || Plan::new(vec![MissionItem::DEFAULT; ITEMS.into()], vec![MissionItem::DEFAULT; ITEMS.into()]);
    let store = PlanStore { mission: plan(), fence: plan(), rally: plan() };
    let own = Address::new(1, 1);
    let mut vehicle =
        Vehicle::new(own, Beacon::new(&Heartbeat::DEFAULT)?, [], (Encoding::Bytewise, table.clone()), store);
    // As fast as the link takes it.
    vehicle.params =
        param::Component::new(own, Encoding::Bytewise, table).with_options(ComponentOptions { pace: Duration::ZERO });
    let start = std::time::Instant::now();
    loop {
        let now = Instant::ZERO + start.elapsed();
        while let Some(output) = vehicle.poll(now) {
            match output {
                Output::Send(message) if gathers => drop(link.queue(&message)?),
                Output::Send(message) => drop(link.send(&message)?),
                Output::Event(Event::Command(request)) => {
                    vehicle.commands.finish(request.ticket, MavResult::UNSUPPORTED, now);
                }
                Output::Event(_) => {}
            }
        }
        link.flush()?;
        let wait = vehicle.deadline().map_or(Duration::from_secs(1), |deadline| deadline - now);
        if let Some(frame) = link.receive_until(std::time::Instant::now() + wait)? {
            vehicle.handle(&frame, Instant::ZERO + start.elapsed());
        }
    }
}

/// Both ends as one would write them for a measurement: they expect that nothing is lost.
struct ByHand {
    stream: TcpStream,
    parser: Parser<'static>,
    sender: Sender,
}

impl ByHand {
    fn new(stream: TcpStream, system_id: u8) -> std::io::Result<Self> {
        stream.set_nodelay(true)?;
        Ok(Self { stream, parser: Parser::new(Common::TABLE), sender: Sender::v2(system_id, 1) })
    }

    /// Reads, and takes each frame until one ends it.
    fn read(
        &mut self,
        mut take: impl FnMut(&Frame<'_>, &mut dyn FnMut(&dyn Encode) -> std::io::Result<()>) -> std::io::Result<bool>,
    ) -> std::io::Result<()> {
        let Self { stream, parser, sender } = self;
        let (mut chunk, mut out) = ([0; 4096], stream.try_clone()?);
        let mut send = |message: &dyn Encode| send(&mut out, sender, message);
        loop {
            let length = stream.read(&mut chunk)?;
            if length == 0 {
                return Err(ErrorKind::UnexpectedEof.into());
            }
            let mut bytes = chunk.get(..length).unwrap_or_default();
            while let Some(frame) = parser.next(&mut bytes) {
                if take(&frame, &mut send)? {
                    return Ok(());
                }
            }
        }
    }

    /// The vehicle.
    fn serve(mut self) -> std::io::Result<()> {
        let (mut items, mut awaited) = (Vec::new(), 0);
        self.read(|frame, send| {
            if frame.decode::<ParamRequestList>().is_some() {
                for index in 0..PARAMETERS {
                    let (param_value, param_type) = (f32::from(index), MavParamType::REAL32);
                    let (param_id, param_count) = (name(index), PARAMETERS);
                    send(&ParamValue { param_id, param_value, param_type, param_count, param_index: index })?;
                }
            } else if let Some(count) = frame.decode::<MissionCount>() {
                items.clear();
                awaited = count.count;
                send(&MissionRequestInt::DEFAULT.to(255, 1))?;
            } else if let Some(item) = frame.decode::<MissionItemInt>() {
                items.push(item);
                let seq = item.seq + 1;
                if seq == awaited {
                    send(&MissionAck::DEFAULT.to(255, 1))?;
                } else {
                    send(&MissionRequestInt { seq, ..MissionRequestInt::DEFAULT }.to(255, 1))?;
                }
            }
            Ok(false)
        })
    }

    /// Lists the parameters.
    fn list(&mut self) -> std::io::Result<usize> {
        send(&mut self.stream, &mut self.sender, &ParamRequestList::DEFAULT.to(1, 1))?;
        let mut listed = vec![None; PARAMETERS.into()];
        let mut missing = listed.len();
        self.read(|frame, _| {
            if let Some(value) = frame.decode::<ParamValue>()
                && let Some(place) = listed.get_mut(usize::from(value.param_index))
            {
                missing -= usize::from(place.replace((value.param_id, value.param_value)).is_none());
            }
            Ok(missing == 0)
        })?;
        Ok(listed.len())
    }

    /// Sends a mission.
    fn upload(&mut self, items: &[MissionItem]) -> std::io::Result<usize> {
        send(&mut self.stream, &mut self.sender, &MissionCount { count: ITEMS, ..MissionCount::DEFAULT }.to(1, 1))?;
        self.read(|frame, send| {
            if let Some(request) = frame.decode::<MissionRequestInt>() {
                let Some(item) = items.get(usize::from(request.seq)) else { return Ok(true) };
                let MissionItem { command, x, y, z, .. } = *item;
                let frame = MavFrame::GLOBAL_RELATIVE_ALT_INT;
                send(
                    &MissionItemInt { seq: request.seq, frame, command, x, y, z, ..MissionItemInt::DEFAULT }.to(1, 1),
                )?;
            }
            Ok(frame.decode::<MissionAck>().is_some())
        })?;
        Ok(items.len())
    }
}

fn send(stream: &mut TcpStream, sender: &mut Sender, message: &dyn Encode) -> std::io::Result<()> {
    let mut buffer = [0; MAX_FRAME];
    stream.write_all(sender.encode(message, &mut buffer)?)
}

//! Where frames go.

use std::collections::VecDeque;
use std::time::Duration;

use mavlink_wire::{Encode, Frame, Links, MAX_FRAME, MAX_PAYLOAD, MessageInfo, Routes, Sender, Table};
use proptest::prelude::*;

static HEARTBEAT: MessageInfo = MessageInfo::new(0, "HEARTBEAT", 50, 9);
static COMMAND: MessageInfo = MessageInfo::new(76, "COMMAND_LONG", 152, 33).target_system(30).target_component(31);
static REQUEST: MessageInfo = MessageInfo::new(250, "REQUEST", 3, 2).target_system(0);
static RADIO_STATUS: MessageInfo = MessageInfo::new(109, "RADIO_STATUS", 185, 9);
static SETUP_SIGNING: MessageInfo = MessageInfo::new(256, "SETUP_SIGNING", 71, 42).target_system(8).target_component(9);
static UNKNOWN: MessageInfo = MessageInfo::new(300, "UNKNOWN", 1, 9).target_system(0);
static TABLE: Table<'static> = Table::of(&[&HEARTBEAT, &COMMAND, &RADIO_STATUS, &REQUEST, &SETUP_SIGNING]);

/// A message to an addressee.
struct To(&'static MessageInfo, u8, u8);

impl Encode for To {
    fn info(&self) -> &'static MessageInfo {
        self.0
    }

    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]) {
        payload.fill(0);
        for (at, id) in [(self.0.target_system, self.1), (self.0.target_component, self.2)] {
            if let Some(at) = at {
                payload[usize::from(at)] = id;
            }
        }
    }
}

const ALL: To = To(&HEARTBEAT, 0, 0);

/// A frame of this sender, numbered anew each time.
struct Senders([u8; 256]);

impl Senders {
    fn frame(&mut self, (system, component): (u8, u8), message: &To) -> Vec<u8> {
        let mut sender = Sender::v2(system, component);
        let number = &mut self.0[usize::from(system)];
        sender.set_sequence(*number);
        *number = number.wrapping_add(1);
        sender.encode(message, &mut [0; MAX_FRAME]).unwrap().to_vec()
    }
}

/// Routes between four links, over which come frames that are all new.
struct Router(Routes<'static, 8, 16>, Senders);

impl Router {
    fn new() -> Self {
        Self(Routes::new(&TABLE, Links::of(&[0, 1, 2, 3])), Senders([0; 256]))
    }

    fn route(&mut self, from: u8, sender: (u8, u8), message: &To) -> Vec<u8> {
        let frame = self.1.frame(sender, message);
        self.0.route(&Frame::parse(&frame, &TABLE).unwrap(), from, Duration::ZERO).into_iter().collect()
    }
}

#[test]
fn what_is_for_all_goes_everywhere_but_back() {
    let mut router = Router::new();
    assert_eq!(router.route(2, (1, 1), &ALL), [0, 1, 3]);
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 0, 0)), [1, 2, 3]);
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 0, 7)), [1, 2, 3]);
    assert_eq!(router.route(0, (255, 190), &To(&UNKNOWN, 9, 0)), [1, 2, 3], "whom it is for is not known");
}

#[test]
fn what_is_for_a_system_goes_where_it_was_heard() {
    let mut router = Router::new();
    let to = |component| To(&COMMAND, 1, component);
    assert_eq!(router.route(0, (255, 190), &to(1)), [0; 0], "nobody has heard of it");
    router.route(2, (1, 1), &ALL);
    router.route(3, (1, 100), &ALL);
    for component in [0, 1, 100, 7] {
        assert_eq!(router.route(0, (255, 190), &to(component)), [2, 3], "{component}");
    }
    assert_eq!(router.route(2, (1, 1), &to(0)), [3], "never back");
    assert_eq!(router.route(0, (255, 190), &To(&REQUEST, 1, 0)), [2, 3], "without a component");
    assert_eq!(router.route(1, (1, 1), &To(&COMMAND, 255, 190)), [0]);
}

#[test]
fn of_the_own_system_the_component_is_looked_for() {
    let mut router = Router::new();
    router.0 = router.0.with_own_system(1);
    router.route(2, (1, 100), &ALL);
    router.route(3, (1, 154), &ALL);
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 1, 154)), [3]);
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 1, 1)), [0; 0], "that may be the router");
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 1, 0)), [2, 3]);
}

#[test]
fn what_concerns_one_link_or_carries_a_key_goes_nowhere() {
    let mut router = Router::new();
    router.route(2, (1, 1), &ALL);
    assert_eq!(router.route(1, (51, 68), &To(&RADIO_STATUS, 0, 0)), [0; 0]);
    assert_eq!(router.route(0, (255, 190), &To(&SETUP_SIGNING, 1, 1)), [0; 0]);
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 51, 68)), [0; 0], "nor does it teach");
}

#[test]
fn private_links_get_only_what_is_for_somebody_there() {
    let mut router = Router::new();
    router.0 = router.0.with_private_links(Links::of(&[3]));
    assert_eq!(router.route(3, (1, 1), &ALL), [0, 1, 2]);
    assert_eq!(router.route(0, (255, 190), &ALL), [1, 2]);
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 1, 1)), [3]);
}

#[test]
fn links_come_and_go() {
    let mut router = Router::new();
    router.route(2, (1, 1), &ALL);
    router.0.remove_link(2);
    assert_eq!(router.route(0, (255, 190), &ALL), [1, 3]);
    router.0.add_link(2);
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 1, 1)), [0; 0], "somebody else may be there");
    assert_eq!(router.0.links(), Links::of(&[0, 1, 2, 3]));
}

#[test]
fn the_silent_one_is_forgotten_when_there_is_no_room() {
    let mut router = Router::new();
    router.route(3, (1, 1), &ALL);
    for system in 2..=8 {
        router.route(2, (system, 1), &ALL);
    }
    router.route(3, (1, 1), &ALL);
    router.route(2, (9, 1), &ALL);
    let to = |router: &mut Router, system| router.route(3, (1, 1), &To(&COMMAND, system, 0));
    assert_eq!([2, 3, 9].map(|system| to(&mut router, system).len()), [0, 1, 1]);
    assert_eq!(
        Routes::<0, 0>::new(&TABLE, Links::of(&[0, 1])).route(
            &Frame::parse(&Senders([0; 256]).frame((1, 1), &ALL), &TABLE).unwrap(),
            0,
            Duration::ZERO
        ),
        Links::of(&[1])
    );
}

#[test]
fn unverified_frames_and_system_zero_teach_nothing() {
    let mut router = Router::new();
    let frame = router.1.frame((1, 1), &ALL);
    let unverified = Frame::parse(&frame, &Table::of(&[])).unwrap();
    assert_eq!(router.0.route(&unverified, 2, Duration::ZERO), Links::of(&[0, 1, 3]));
    router.route(2, (0, 1), &ALL);
    assert_eq!(router.route(0, (255, 190), &To(&COMMAND, 1, 1)), [0; 0]);
}

#[test]
fn the_same_frame_goes_on_once_in_a_while() {
    let mut router = Router::new();
    let frame = router.1.frame((1, 1), &ALL);
    let frame = Frame::parse(&frame, &TABLE).unwrap();
    let mut at = |milliseconds, from| router.0.route(&frame, from, Duration::from_millis(milliseconds)).len();
    // Over another way, right behind itself; later it is a new one, of a sender that does not count.
    assert_eq!([at(0, 0), at(10, 1), at(499, 0), at(500, 0), at(501, 0), at(1500, 0)], [3, 0, 0, 3, 0, 3]);
    // What it forgets in a crowd, and what it does not.
    let mut router = Router::new();
    let frames: Vec<_> = (0..17).map(|_| router.1.frame((1, 1), &ALL)).collect();
    let mut pass =
        |at: usize| !router.0.route(&Frame::parse(&frames[at], &TABLE).unwrap(), 0, Duration::ZERO).is_empty();
    assert!((0..17).all(&mut pass), "all are new");
    assert!((1..17).all(|at| !pass(at)) && pass(0), "only the first was forgotten");
}

#[test]
fn links_are_a_set_of_numbers() {
    let links = Links::of(&[63, 0, 5, 64, 255]);
    assert_eq!((links.into_iter().collect::<Vec<_>>(), links.len(), links.is_empty()), (vec![0, 5, 63], 3, false));
    assert_eq!(links.into_iter().collect::<Links>(), links);
    assert!(links.contains(63) && !links.contains(64) && !links.without(63).contains(63));
    assert_eq!(
        (links.among(Links::of(&[5, 6])), links.except(Links::of(&[5, 6]))),
        (Links::of(&[5]), Links::of(&[0, 63]))
    );
    assert_eq!((Links::NONE.into_iter().next(), Links::NONE.and(links)), (None, links));
}

/// Routers that are joined by cables. Each also has a device, on link 0, whose system id is the router's number + 1.
struct Network {
    routers: Vec<Routes<'static>>,
    /// Two routers and their links.
    cables: Vec<[(usize, u8); 2]>,
    senders: Senders,
}

impl Network {
    fn new(count: usize, cables: &[(usize, usize)]) -> Self {
        let mut links = vec![1_u8; count];
        let mut end = |router: usize| {
            links[router] += 1;
            (router, links[router] - 1)
        };
        let cables: Vec<_> = cables.iter().map(|&(one, other)| [end(one), end(other)]).collect();
        let routers = links.iter().map(|&links| Routes::new(&TABLE, (0..links).collect())).collect();
        Self { routers, cables, senders: Senders([0; 256]) }
    }

    /// Sends a message from a device; gives how often each device gets it, and how often it goes over a cable.
    fn send(&mut self, from: usize, message: &To) -> (Vec<usize>, usize) {
        let bytes = self.senders.frame((from as u8 + 1, 1), message);
        let frame = Frame::parse(&bytes, &TABLE).unwrap();
        let (mut received, mut carried) = (vec![0; self.routers.len()], 0);
        let mut waiting = VecDeque::from([(from, 0)]);
        while let Some((router, link)) = waiting.pop_front() {
            for to in self.routers[router].route(&frame, link, Duration::ZERO) {
                assert_ne!(to, link);
                if to == 0 {
                    received[router] += 1;
                    continue;
                }
                let ends = self.cables.iter().flat_map(|&[one, other]| [(one, other), (other, one)]);
                waiting.extend(ends.filter(|(here, _)| *here == (router, to)).map(|(_, there)| there));
                carried += 1;
                assert!(carried < 10_000, "a storm");
            }
        }
        (received, carried)
    }

    /// The routers that are joined to this one.
    fn reachable(&self, from: usize) -> Vec<bool> {
        let mut reached = vec![false; self.routers.len()];
        reached[from] = true;
        for _ in 0..self.routers.len() {
            for &[(one, _), (other, _)] in &self.cables {
                let either = reached[one] || reached[other];
                (reached[one], reached[other]) = (either, either);
            }
        }
        reached
    }
}

#[test]
fn a_ring_of_routers_does_not_storm() {
    let mut ring = Network::new(3, &[(0, 1), (1, 2), (2, 0)]);
    // Each router sends it to the other two, but for those that it came from: four times over three cables.
    assert_eq!(ring.send(0, &ALL), (vec![0, 1, 1], 4));
    assert_eq!(ring.send(1, &To(&COMMAND, 1, 1)).0, [1, 0, 0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever the cables: all who are joined get it once, nobody else, and no cable carries it more than both ways.
    #[test]
    fn in_any_network_frames_arrive_once(
        (count, cables) in (2..7_usize).prop_flat_map(|count| (Just(count), proptest::collection::vec((0..count, 0..count), 0..12))),
        from in 0..2_usize,
        to in 0..2_usize,
    ) {
        let cables: Vec<_> = cables.into_iter().filter(|(one, other)| one != other).collect();
        let mut network = Network::new(count, &cables);
        let expected = |reached: Vec<bool>| -> Vec<usize> { reached.iter().map(|reached| usize::from(*reached)).collect() };
        for device in (0..count).chain([from]) {
            let mut everybody_else = expected(network.reachable(device));
            everybody_else[device] = 0;
            let (received, carried) = network.send(device, &ALL);
            prop_assert_eq!(received, everybody_else);
            prop_assert!(carried <= 2 * cables.len());
        }
        // What is for one goes to that one, and to no other device.
        let (received, carried) = network.send(from, &To(&COMMAND, to as u8 + 1, 1));
        let arrives = from != to && network.reachable(from)[to];
        let only: Vec<usize> = (0..count).map(|device| usize::from(arrives && device == to)).collect();
        prop_assert_eq!(received, only);
        prop_assert!(carried <= 2 * cables.len());
    }
}

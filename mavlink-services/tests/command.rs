//! Commands: both ends, over links that are fine and bad, and against peers that do not play by the rules.

mod simulated;

use std::ops::ControlFlow;
use std::time::Duration;

use mavlink_services::command::{Accepted, Component, Event, Failure, Fetch, NoCommand, Options, Progress, Send};
use mavlink_services::common::{
    AutopilotVersion, CommandAck, CommandCancel, CommandInt, CommandLong, Common, Heartbeat, MavCmd, MavResult,
};
use mavlink_services::{Instant, Retry, Service, Update};
use mavlink_wire::{Dialect, Encode, Frame, MAX_FRAME, Message, Sender};
use simulated::{COMPONENT, STATION, Simulation, Weather, component, give, outputs, station};

const ARM: CommandLong = CommandLong { command: MavCmd::COMPONENT_ARM_DISARM, param1: 1.0, ..CommandLong::DEFAULT };
const REPOSITION: CommandInt = CommandInt { command: MavCmd::DO_REPOSITION, x: 473_977_420, ..CommandInt::DEFAULT };

const fn ack(result: MavResult, progress: u8) -> CommandAck {
    CommandAck { command: MavCmd::COMPONENT_ARM_DISARM, result, progress, ..CommandAck::DEFAULT }
}

/// The command, on its way to the component.
#[expect(clippy::unwrap_used, reason = "a part of tests")]
fn sending(command: &dyn Encode) -> Send {
    Send::new(station(), component(), Options::DEFAULT, command, Instant::ZERO).unwrap()
}

/// How one command ends, how often it was carried out, and the bytes that went over the link.
type Run = (Option<Result<Accepted, Failure>>, usize, Vec<(Instant, simulated::End, Vec<u8>)>);

/// Sends one command over a link; the component takes two seconds for it, and reports.
fn run(seed: u64, weather: Weather, command: &dyn Encode) -> Run {
    let mut simulation = Simulation::new(seed, weather);
    let (mut sender, mut receiver) = (sending(command), Component::<4>::new(component()));
    let (mut end, mut executions, mut open) = (None, 0, None);
    for second in 0..60 {
        let _ = simulation.run(
            (&mut sender, &mut |_, event, _| {
                end = event.done().or(end);
                ControlFlow::Continue(())
            }),
            (&mut receiver, &mut |machine, event, now| {
                if let Event::Request(request) = event {
                    executions += 1;
                    open = Some((request.ticket, second));
                    machine.progress(request.ticket, Some(10), now);
                }
            }),
            Duration::from_secs(1),
        );
        if let Some((ticket, since)) = open
            && second >= since + 2
        {
            receiver.finish(ticket, MavResult::ACCEPTED, simulation.now);
            open = None;
        }
    }
    (end, executions, simulation.trace)
}

#[test]
fn a_command_is_carried_out_once_over_a_fine_link() {
    for command in [&ARM as &dyn Encode, &REPOSITION] {
        let (end, executions, trace) = run(1, Weather::FINE, command);
        assert!(matches!(end, Some(Ok(_))), "{end:?}");
        assert_eq!(executions, 1);
        assert!(trace.len() <= 6, "{trace:?}");
    }
}

#[test]
fn a_bad_link_ends_every_command_and_a_long_one_runs_once() {
    let mut accepted = 0;
    for seed in 0..200 {
        let (end, executions, _) = run(seed, Weather::BAD, &ARM);
        assert!(executions <= 1, "seed {seed}: {executions}");
        match end {
            Some(Ok(_)) => {
                assert_eq!(executions, 1, "seed {seed}");
                accepted += 1;
            }
            Some(Err(Failure::Timeout { .. })) => {}
            other => panic!("seed {seed}: {other:?}"),
        }
    }
    assert!(accepted > 195, "{accepted} of 200");
}

#[test]
fn the_same_seed_gives_the_same_run() {
    for seed in [3, 4, 5] {
        assert_eq!(run(seed, Weather::BAD, &ARM), run(seed, Weather::BAD, &ARM));
    }
    assert_ne!(run(3, Weather::BAD, &ARM).2, run(4, Weather::BAD, &ARM).2);
}

#[test]
fn without_an_answer_it_is_sent_six_times_counting() {
    let mut machine = sending(&ARM);
    let mut confirmations = Vec::new();
    let end = loop {
        let now = machine
            .deadline()
            .map_or(Instant::ZERO, |next| if confirmations.is_empty() { Instant::ZERO } else { next });
        let (sent, events) = outputs(&mut machine, now);
        confirmations.extend(sent.iter().map(|sent| sent.decode::<CommandLong>().unwrap().confirmation));
        if let Some(event) = events.first() {
            break (*event, now);
        }
    };
    assert_eq!(confirmations, [0, 1, 2, 3, 4, 5]);
    let timeout = Failure::Timeout { command: MavCmd::COMPONENT_ARM_DISARM, sent: 6, progress: None };
    assert_eq!(end, (Update::Done(Err(timeout)), Instant::from_millis(6000)));
    assert_eq!(timeout.to_string(), "MAV_CMD_COMPONENT_ARM_DISARM was sent 6 times, and the answer never came");
    assert_eq!(machine.deadline(), None);
}

#[test]
fn a_refusal_says_why_and_how_far_it_came() {
    let mut machine = sending(&ARM);
    outputs(&mut machine, Instant::ZERO);
    give(&mut machine, COMPONENT, &ack(MavResult::IN_PROGRESS, 30), Instant::ZERO);
    give(&mut machine, COMPONENT, &CommandAck { result_param2: 7, ..ack(MavResult::FAILED, 0) }, Instant::ZERO);
    let (_, events) = outputs(&mut machine, Instant::ZERO);
    let command = MavCmd::COMPONENT_ARM_DISARM;
    let refused = Failure::Refused { command, result: MavResult::FAILED, reason: 7, progress: Some(30) };
    assert_eq!(events, [Update::Progress(Progress { command, percent: Some(30) }), Update::Done(Err(refused))]);
    assert_eq!(refused.to_string(), "MAV_CMD_COMPONENT_ARM_DISARM was refused: MAV_RESULT_FAILED, reason 7, at 30 %");
}

#[test]
fn answers_of_others_and_to_others_are_none() {
    let mut machine = sending(&ARM);
    // What comes before the command was even sent is no answer to it.
    give(&mut machine, COMPONENT, &ack(MavResult::ACCEPTED, 0), Instant::ZERO);
    outputs(&mut machine, Instant::ZERO);
    give(&mut machine, (2, 1), &ack(MavResult::ACCEPTED, 0), Instant::ZERO);
    give(&mut machine, (1, 2), &ack(MavResult::ACCEPTED, 0), Instant::ZERO);
    give(
        &mut machine,
        COMPONENT,
        &CommandAck { command: MavCmd::NAV_LAND, ..ack(MavResult::ACCEPTED, 0) },
        Instant::ZERO,
    );
    let other = CommandAck { target_system: 254, target_component: 190, ..ack(MavResult::ACCEPTED, 0) };
    give(&mut machine, COMPONENT, &other, Instant::ZERO);
    give(&mut machine, COMPONENT, &Heartbeat::DEFAULT, Instant::ZERO);
    assert!(outputs(&mut machine, Instant::ZERO).1.is_empty());
    give(&mut machine, COMPONENT, &ack(MavResult::ACCEPTED, 0), Instant::ZERO);
    assert!(matches!(outputs(&mut machine, Instant::ZERO).1[..], [Update::Done(Ok(_))]));
    give(&mut machine, COMPONENT, &ack(MavResult::FAILED, 0), Instant::ZERO);
    assert!(outputs(&mut machine, Instant::ZERO).1.is_empty(), "it has ended");

    let none = Send::new(station(), component(), Options::DEFAULT, &Heartbeat::DEFAULT, Instant::ZERO);
    assert_eq!(none.unwrap_err(), NoCommand { message_id: 0 });
}

#[test]
fn endless_progress_comes_to_an_end() {
    let options = Options { limit: Duration::from_secs(20), ..Options::DEFAULT };
    let mut machine = Send::new(station(), component(), options, &ARM, Instant::ZERO).unwrap();
    let (mut now, mut sent) = (Instant::ZERO, 0);
    let end = loop {
        let (out, events) = outputs(&mut machine, now);
        sent += out.len();
        if let Some(Update::Done(end)) = events.last() {
            break *end;
        }
        give(&mut machine, COMPONENT, &ack(MavResult::IN_PROGRESS, 255), now);
        now += Duration::from_millis(100);
    };
    assert_eq!(end, Err(Failure::Endless { command: MavCmd::COMPONENT_ARM_DISARM, progress: None }));
    assert_eq!((sent, now), (1, Instant::from_millis(20_000)));
}

#[test]
fn silence_ends_what_runs_if_it_cannot_say_that_it_is_sent_again() {
    let mut machine = sending(&REPOSITION);
    outputs(&mut machine, Instant::ZERO);
    let running = CommandAck { command: REPOSITION.command, ..ack(MavResult::IN_PROGRESS, 50) };
    give(&mut machine, COMPONENT, &running, Instant::ZERO);
    outputs(&mut machine, Instant::ZERO);
    assert_eq!(machine.deadline(), Some(Instant::from_millis(5000)));
    let (sent, events) = outputs(&mut machine, Instant::from_millis(5000));
    let timeout = Failure::Timeout { command: REPOSITION.command, sent: 1, progress: Some(50) };
    assert_eq!((sent.len(), events), (0, vec![Update::Done(Err(timeout))]));
}

#[test]
fn after_silence_a_long_command_is_sent_again_until_it_is_answered() {
    let mut machine = sending(&ARM);
    outputs(&mut machine, Instant::ZERO);
    give(&mut machine, COMPONENT, &ack(MavResult::IN_PROGRESS, 50), Instant::ZERO);
    outputs(&mut machine, Instant::ZERO);
    assert!(outputs(&mut machine, Instant::from_millis(4999)).0.is_empty());
    for (at, confirmation) in [(5000, 1), (6000, 2)] {
        let (sent, events) = outputs(&mut machine, Instant::from_millis(at));
        assert!(events.is_empty(), "{events:?}");
        let confirmations = sent.iter().map(|sent| sent.decode::<CommandLong>().unwrap().confirmation);
        assert_eq!(confirmations.collect::<Vec<_>>(), [confirmation]);
    }
    let mut answered = machine.clone();
    give(&mut answered, COMPONENT, &ack(MavResult::ACCEPTED, 0), Instant::from_millis(6500));
    let (_, events) = outputs(&mut answered, Instant::from_millis(6500));
    assert!(matches!(events[..], [Update::Done(Ok(_))]), "{events:?}");
    // It still runs: the silence begins again.
    give(&mut machine, COMPONENT, &ack(MavResult::IN_PROGRESS, 60), Instant::from_millis(6500));
    outputs(&mut machine, Instant::from_millis(6500));
    assert_eq!(machine.deadline(), Some(Instant::from_millis(11_500)));
    // Six times in all.
    let mut last = vec![];
    for second in 11..30 {
        last.extend(outputs(&mut machine, Instant::from_millis(second * 1000 + 500)).1);
    }
    let timeout = Failure::Timeout { command: ARM.command, sent: 6, progress: Some(60) };
    assert_eq!(last, [Update::Done(Err(timeout))]);
}

#[test]
fn a_component_answers_the_same_int_again_for_two_seconds() {
    let mut machine = Component::<1>::new(component());
    // Each in a frame of its own: what the link doubles is known by its number.
    let mut sender = Sender::v2(STATION.0, STATION.1);
    let mut give = |machine: &mut Component<1>, x, now| {
        let mut buffer = [0; MAX_FRAME];
        let command = CommandInt { x, target_system: 1, target_component: 1, ..REPOSITION };
        let bytes = sender.encode(&command, &mut buffer).unwrap();
        machine.handle(&Frame::parse(bytes, Common::TABLE).unwrap(), now);
        outputs(machine, now)
    };
    let (_, events) = give(&mut machine, REPOSITION.x, Instant::ZERO);
    let [Event::Request(request)] = events[..] else { panic!("{events:?}") };
    assert!(machine.finish(request.ticket, MavResult::DENIED, Instant::ZERO));
    assert_eq!(outputs(&mut machine, Instant::ZERO).0.len(), 1);
    // Each answer is remembered, not only the first.
    for at in [1900, 3800] {
        let (sent, events) = give(&mut machine, REPOSITION.x, Instant::from_millis(at));
        let results = sent.iter().map(|sent| sent.decode::<CommandAck>().unwrap().result);
        assert!(events.is_empty() && results.eq([MavResult::DENIED]), "{events:?}");
    }
    // Another place, and the same after a while, are new commands.
    for (x, at) in [(1, 4000), (REPOSITION.x, 4001), (REPOSITION.x, 6100)] {
        let (_, events) = give(&mut machine, x, Instant::from_millis(at));
        let [Event::Request(request)] = events[..] else { panic!("{at}: {events:?}") };
        machine.finish(request.ticket, MavResult::ACCEPTED, Instant::from_millis(at));
        outputs(&mut machine, Instant::from_millis(at));
    }
}

#[test]
fn a_running_command_can_be_cancelled() {
    let (mut sender, mut receiver) = (sending(&ARM), Component::<4>::new(component()));
    let mut simulation = Simulation::new(9, Weather::BAD);
    let (mut end, mut cancelled) = (None, false);
    let _ = simulation.run(
        (&mut sender, &mut |machine, event, now| match event {
            Update::Progress(_) => {
                machine.cancel(now);
                ControlFlow::Continue(())
            }
            Update::Done(result) => {
                end = Some(result);
                ControlFlow::Break(())
            }
        }),
        (&mut receiver, &mut |machine, event, now| match event {
            Event::Request(request) => assert!(machine.progress(request.ticket, None, now)),
            Event::Cancel(ticket) => {
                assert!(machine.finish(ticket, MavResult::CANCELLED, now));
                assert!(!machine.finish(ticket, MavResult::ACCEPTED, now), "it has ended");
                cancelled = true;
            }
            _ => unreachable!(),
        }),
        Duration::from_secs(60),
    );
    assert!(cancelled);
    assert!(matches!(end, Some(Err(Failure::Refused { result: MavResult::CANCELLED, .. }))), "{end:?}");
}

#[test]
fn a_component_answers_repeats_and_turns_away_what_it_cannot_hold() {
    let mut machine = Component::<1>::new(component());
    let long =
        |param1, confirmation| CommandLong { target_system: 1, target_component: 1, param1, confirmation, ..ARM };
    give(&mut machine, STATION, &CommandLong { target_system: 2, ..long(1.0, 0) }, Instant::ZERO);
    assert!(outputs(&mut machine, Instant::ZERO).1.is_empty(), "that was for another system");

    give(&mut machine, STATION, &long(1.0, 0), Instant::ZERO);
    let (_, events) = outputs(&mut machine, Instant::ZERO);
    let [Event::Request(request)] = events[..] else { panic!("{events:?}") };
    assert_eq!((request.from, request.command.params()[0]), (station(), 1.0));

    let answers = |machine: &mut Component<1>, now| {
        let (sent, events) = outputs(machine, now);
        assert!(events.is_empty(), "{events:?}");
        sent.iter().map(|sent| sent.decode::<CommandAck>().unwrap().result).collect::<Vec<_>>()
    };
    // The same again, before it was answered.
    give(&mut machine, STATION, &long(1.0, 1), Instant::ZERO);
    assert_eq!(answers(&mut machine, Instant::ZERO), [MavResult::IN_PROGRESS]);
    // With other parameters, and another command from somebody else: there is no room.
    give(&mut machine, STATION, &long(0.0, 0), Instant::ZERO);
    assert_eq!(answers(&mut machine, Instant::ZERO), [MavResult::TEMPORARILY_REJECTED]);
    give(&mut machine, (254, 1), &long(1.0, 0), Instant::ZERO);
    assert_eq!(answers(&mut machine, Instant::ZERO), [MavResult::TEMPORARILY_REJECTED]);

    assert!(machine.finish(request.ticket, MavResult::ACCEPTED, Instant::ZERO));
    assert_eq!(answers(&mut machine, Instant::ZERO), [MavResult::ACCEPTED]);
    give(&mut machine, STATION, &long(1.0, 2), Instant::from_millis(1000));
    assert_eq!(answers(&mut machine, Instant::from_millis(1000)), [MavResult::ACCEPTED], "acknowledged again");
    let cancel = CommandCancel { target_system: 1, target_component: 1, command: ARM.command };
    give(&mut machine, STATION, &cancel, Instant::from_millis(1000));
    assert_eq!(answers(&mut machine, Instant::from_millis(1000)), [MavResult::ACCEPTED], "it is too late");
    give(&mut machine, STATION, &long(1.0, 3), Instant::from_millis(11_900));
    assert_eq!(answers(&mut machine, Instant::from_millis(11_900)), [MavResult::ACCEPTED], "after silence");
    give(&mut machine, STATION, &long(1.0, 4), Instant::from_millis(23_000));
    assert_eq!(outputs(&mut machine, Instant::from_millis(23_000)).1.len(), 1, "that is a new one");
}

#[test]
fn a_message_is_asked_for_until_it_comes() {
    let fetch = || Fetch::<AutopilotVersion>::new(station(), component(), Retry::DEFAULT, 0.0, Instant::ZERO);
    let version = AutopilotVersion { uid: 7, ..AutopilotVersion::DEFAULT };
    let accepted = CommandAck { command: MavCmd::REQUEST_MESSAGE, ..CommandAck::DEFAULT };

    let mut machine = fetch();
    let (sent, _) = outputs(&mut machine, Instant::ZERO);
    assert_eq!(sent[0].decode::<CommandLong>().unwrap().param1, 148.0);
    // It is acknowledged, and lost.
    give(&mut machine, COMPONENT, &accepted, Instant::ZERO);
    give(&mut machine, (9, 1), &version, Instant::ZERO);
    assert!(outputs(&mut machine, Instant::ZERO).1.is_empty());
    let (sent, _) = outputs(&mut machine, Instant::from_millis(1000));
    assert_eq!(sent[0].decode::<CommandLong>().unwrap().confirmation, 1);
    give(&mut machine, COMPONENT, &version, Instant::from_millis(1000));
    assert_eq!(outputs(&mut machine, Instant::from_millis(1000)).1, [Update::Done(Ok(version))]);
    assert_eq!(machine.deadline(), None);

    let mut machine = fetch();
    outputs(&mut machine, Instant::ZERO);
    give(&mut machine, COMPONENT, &CommandAck { result: MavResult::UNSUPPORTED, ..accepted }, Instant::ZERO);
    let (_, events) = outputs(&mut machine, Instant::ZERO);
    assert!(matches!(events[..], [Update::Done(Err(Failure::Refused { result: MavResult::UNSUPPORTED, .. }))]));

    let mut machine = fetch();
    outputs(&mut machine, Instant::ZERO);
    let (now, end) = loop {
        let now = machine.deadline().unwrap();
        if let Some(Update::Done(end)) = outputs(&mut machine, now).1.pop() {
            break (now, end);
        }
    };
    let timeout = Failure::Timeout { command: MavCmd::REQUEST_MESSAGE, sent: 6, progress: None };
    assert_eq!((now, end), (Instant::from_millis(6000), Err(timeout)));
}

//! A component with a heartbeat, commands and ten parameters, until it is told to shut down. Beside it, what each machine takes of
//! the RAM: statics whose sizes `nm` shows.

#![no_std]
#![no_main]

mod clock;
mod panic;
mod ram;
mod uart;

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};
use embedded_io::{Read, Write};
use mavlink_autoquad::wire::{MAX_FRAME, Message, Parser, Sender, Table};
use mavlink_services::common::{
    CommandCancel, CommandInt, CommandLong, Heartbeat, MavCmd, MavResult, MavState, ParamRequestList, ParamRequestRead,
    ParamSet,
};
use mavlink_services::heartbeat::Beacon;
use mavlink_services::param::{self, Encoding, Param, ParamValue};
use mavlink_services::{Address, Outgoing, Service, command};

use clock::Clock;
use uart::Uart;

static RECEIVED: Table<'static> = Table::of(&[
    ParamRequestRead::INFO,
    ParamRequestList::INFO,
    ParamSet::INFO,
    CommandInt::INFO,
    CommandLong::INFO,
    CommandCancel::INFO,
]);
const BEAT: Heartbeat = Heartbeat { system_status: MavState::ACTIVE, ..Heartbeat::DEFAULT };

#[entry]
fn main() -> ! {
    component(Uart::new(), Clock::start());
    debug::exit(EXIT_SUCCESS);
    loop {
        core::hint::spin_loop();
    }
}

fn parameters() -> [Param; 10] {
    let gains = ["RATE_P", "RATE_I", "RATE_D", "TILT_P", "TILT_I", "TILT_D", "YAW_P"];
    let mut gains = gains.iter().map(|name| Param::new(name, 0.5_f32));
    let mut next = || gains.next().unwrap_or(Param::new("", 0.0_f32));
    [
        next(),
        next(),
        next(),
        next(),
        next(),
        next(),
        next(),
        Param::new("MOTORS", 4_u8),
        Param::new("BAUD", 115_200_i32),
        Param::new("OPTIONS", 7_u16),
    ]
}

fn component(mut uart: Uart, mut clock: Clock) {
    let own = Address::new(1, 1);
    let (mut parser, mut sender, mut buffer) = (Parser::new(&RECEIVED), Sender::v2(1, 1), [0; MAX_FRAME]);
    let mut beacon = Beacon::from(BEAT);
    let mut commands = command::Component::<2>::new(own);
    let mut params = param::Component::new(own, Encoding::Bytewise, parameters());
    let (mut armed, mut running) = (false, true);
    while running {
        let now = clock.now();
        let mut byte = [0];
        let taken = if Uart::has_byte() { uart.read(&mut byte).unwrap_or(0) } else { 0 };
        let mut chunk = byte.get(..taken).unwrap_or_default();
        while let Some(frame) = parser.next(&mut chunk) {
            commands.handle(&frame, now);
            params.handle(&frame, now);
        }
        let mut send = |message: &Outgoing| match sender.encode(message, &mut buffer).map(|bytes| uart.write(bytes)) {
            Ok(Ok(_)) => {}
            _ => debug::exit(EXIT_FAILURE),
        };
        while let Some(event) = commands.next_event(now, &mut send) {
            let command::Event::Request(request) = event else { continue };
            let result = match request.command.command() {
                MavCmd::COMPONENT_ARM_DISARM => {
                    armed = request.command.params()[0] == 1.0;
                    MavResult::ACCEPTED
                }
                MavCmd::PREFLIGHT_REBOOT_SHUTDOWN => {
                    running = false;
                    MavResult::ACCEPTED
                }
                _ => MavResult::UNSUPPORTED,
            };
            commands.finish(request.ticket, result, now);
        }
        while let Some(set) = params.next_event(now, &mut send) {
            // Here a firmware would take the new gain.
            let _: ParamValue = set.param.value;
        }
        while let Some(event) = beacon.next_event(now, &mut send) {
            match event {}
        }
    }
    let _ = armed;
}

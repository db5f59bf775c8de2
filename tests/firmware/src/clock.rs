//! The time, by the counter of the processor: it is looked at in every turn of the loop, long before it goes around.

use core::time::Duration;

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use mavlink_services::Instant;

/// The chip's main oscillator in QEMU.
const TICKS_PER_MICROSECOND: u32 = 12;
const LARGEST: u32 = 0x00ff_ffff;

/// Counts up.
pub struct Clock {
    last: u32,
    now: Instant,
}

impl Clock {
    pub fn start() -> Self {
        if let Some(mut peripherals) = Peripherals::take() {
            peripherals.SYST.set_clock_source(SystClkSource::Core);
            peripherals.SYST.set_reload(LARGEST);
            peripherals.SYST.clear_current();
            peripherals.SYST.enable_counter();
        }
        Self { last: LARGEST, now: Instant::ZERO }
    }

    pub fn now(&mut self) -> Instant {
        // The counter goes down.
        let passed = self.last.wrapping_sub(SYST::get_current()) & LARGEST;
        let micros = passed / TICKS_PER_MICROSECOND;
        self.last = self.last.wrapping_sub(micros * TICKS_PER_MICROSECOND) & LARGEST;
        self.now += Duration::from_micros(micros.into());
        self.now
    }
}

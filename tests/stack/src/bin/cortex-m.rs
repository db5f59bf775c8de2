//! On a Cortex-M3, without an operating system.

#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_FAILURE, EXIT_SUCCESS};
use cortex_m_semihosting::hprintln;

#[entry]
fn main() -> ! {
    let mut status = EXIT_SUCCESS;
    mavlink_stack::everywhere(&mut |measured| {
        hprintln!("{:6} of {:6} bytes: {}", measured.bytes, measured.limit, measured.what);
        if measured.is_too_much() {
            status = EXIT_FAILURE;
        }
    });
    debug::exit(status);
    loop {
        core::hint::spin_loop();
    }
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    hprintln!("{}", info);
    debug::exit(EXIT_FAILURE);
    loop {
        core::hint::spin_loop();
    }
}

//! A program that does nothing, for comparison: what others take, they take beyond this.

#![no_std]
#![no_main]

mod panic;

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{self, EXIT_SUCCESS};

#[entry]
fn main() -> ! {
    debug::exit(EXIT_SUCCESS);
    loop {
        core::hint::spin_loop();
    }
}

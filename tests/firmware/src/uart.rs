//! The first UART of an LM3S6965, a PL011, by polling.

use core::convert::Infallible;
use core::future::poll_fn;
use core::ptr::{with_exposed_provenance, with_exposed_provenance_mut};
use core::task::Poll;

use embedded_io::{ErrorType, Read, Write};

/// Data, and flags: LM3S6965 data sheet, "Universal Asynchronous Receivers/Transmitters".
const DATA: usize = 0x4000_c000;
const FLAGS: usize = 0x4000_c018;
const RECEIVE_EMPTY: u32 = 1 << 4;
const TRANSMIT_FULL: u32 = 1 << 5;

/// One end of the link. Reading and writing do not disturb each other.
pub struct Uart(());

impl Uart {
    pub const fn new() -> Self {
        Self(())
    }

    /// Whether a byte has come.
    #[allow(dead_code, reason = "a gateway waits for bytes")]
    pub fn has_byte() -> bool {
        !Self::is(RECEIVE_EMPTY)
    }

    fn is(flag: u32) -> bool {
        // SAFETY: a register of this chip that can be read at any time.
        unsafe { with_exposed_provenance::<u32>(FLAGS).read_volatile() & flag != 0 }
    }
}

impl ErrorType for Uart {
    type Error = Infallible;
}

impl Read for Uart {
    /// Waits for a byte, and takes what has come by then.
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Infallible> {
        let mut read = 0;
        while read == 0 && Self::is(RECEIVE_EMPTY) {}
        for byte in buffer {
            if Self::is(RECEIVE_EMPTY) {
                break;
            }
            // SAFETY: a register of this chip; reading takes a byte out of the queue.
            *byte = unsafe { with_exposed_provenance::<u32>(DATA).read_volatile() } as u8;
            read += 1;
        }
        Ok(read)
    }
}

impl Write for Uart {
    fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        for byte in bytes {
            while Self::is(TRANSMIT_FULL) {}
            // SAFETY: a register of this chip; writing puts a byte into the queue, which has room.
            unsafe { with_exposed_provenance_mut::<u32>(DATA).write_volatile((*byte).into()) };
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

/// As a HAL has it, whose interrupts wake the task; this one asks to be polled again.
impl embedded_io_async::Read for Uart {
    async fn read(&mut self, buffer: &mut [u8]) -> Result<usize, Infallible> {
        poll_fn(|_| if Self::is(RECEIVE_EMPTY) { Poll::Pending } else { Poll::Ready(Read::read(self, buffer)) }).await
    }
}

impl embedded_io_async::Write for Uart {
    async fn write(&mut self, bytes: &[u8]) -> Result<usize, Infallible> {
        let bytes = bytes.get(..1).unwrap_or_default();
        poll_fn(|_| if Self::is(TRANSMIT_FULL) { Poll::Pending } else { Poll::Ready(Write::write(self, bytes)) }).await
    }

    async fn flush(&mut self) -> Result<(), Infallible> {
        Ok(())
    }
}

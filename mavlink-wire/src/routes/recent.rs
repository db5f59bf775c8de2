//! The frames that came lately.

use core::time::Duration;

use crate::Frame;
use crate::header::{CHECKSUM, SIGNATURE};

/// The last `N` frames, and when they came.
#[derive(Clone, Debug)]
pub(super) struct Recent<const N: usize> {
    frames: [(u64, Duration); N],
    /// Frames so far.
    count: usize,
}

impl<const N: usize> Recent<N> {
    pub(super) const EMPTY: Self = Self { frames: [(0, Duration::ZERO); N], count: 0 };

    /// Whether this frame came before, within this window. If not, it is remembered.
    pub(super) fn take(&mut self, frame: &Frame<'_>, now: Duration, window: Duration) -> bool {
        let mark = mark(frame);
        let is_new = |(_, came): &(u64, Duration)| now.saturating_sub(*came) < window;
        if self.frames.iter().take(self.count).any(|known| known.0 == mark && is_new(known)) {
            return true;
        }
        if let Some(oldest) = self.count.checked_rem(N).and_then(|at| self.frames.get_mut(at)) {
            *oldest = (mark, now);
            // Behind the first round, all places are taken, and only the place of the next one counts.
            self.count = if self.count + 1 == 2 * N { N } else { self.count + 1 };
        }
        false
    }
}

/// What tells a frame from others: its sender, its number, its message, and the checksum of all the rest.
fn mark(frame: &Frame<'_>) -> u64 {
    let behind = CHECKSUM + if frame.signature().is_some() { SIGNATURE } else { 0 };
    let bytes = frame.bytes();
    let checksum = bytes.len().checked_sub(behind).and_then(|at| bytes.get(at..)).and_then(<[u8]>::first_chunk);
    let checksum = u16::from_le_bytes(checksum.copied().unwrap_or_default());
    let sender = [frame.system_id().to_u8(), frame.component_id().to_u8(), frame.sequence()];
    sender
        .into_iter()
        .fold(u64::from(checksum) << 24 | u64::from(frame.message_id()), |mark, byte| mark << 8 | u64::from(byte))
}

//! The half that receives.

use std::boxed::Box;
use std::fs::File;
use std::io::Read;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use super::stream::Stream;
use super::udp::Receiving;
use crate::adapters::pause::{in_time, uninterrupted};
use crate::link::file::{Kept, Log, Recording};
use crate::link::line::{Hearing, POLL};
use crate::link::shared::Shared;
use crate::link::{Inbox, LinkError, LinkStatistics, Peer};
use crate::parser::not_told;
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{Frame, Losses, Table};

/// So often somebody who waits looks whether the link was closed.
const SLICE: Duration = Duration::from_millis(200);

/// The half of a [`Link`](super::Link) that receives.
pub struct ReceiveHalf {
    pub(super) shared: Arc<Shared>,
    pub(super) inbox: Inbox<'static>,
    pub(super) carrier: Carrier,
    pub(super) losses: Losses,
}

pub(super) enum Carrier {
    Datagrams(Receiving),
    Line(Hearing<Box<dyn Stream>>),
    Stream(Kept<File>),
    Log(Box<Log<File>>),
}

impl Carrier {
    pub(super) fn of_recording(Recording { file, is_log }: Recording, table: &'static Table<'static>) -> Self {
        if is_log { Self::Log(Box::new(Log::new(file, table))) } else { Self::Stream(Kept::new(file)) }
    }
}

impl ReceiveHalf {
    /// The next frame. Waits without a limit, also while nobody is there.
    ///
    /// # Errors
    ///
    /// [`LinkError::Closed`], [`LinkError::Ended`] at the end of a file, or what the system says.
    pub fn receive(&mut self) -> Result<Frame<'_>, LinkError> {
        match self.deliver(None)? {
            Some((frame, _)) => Ok(frame),
            // Without a deadline, none passes.
            None => Err(LinkError::Closed),
        }
    }

    /// The next frame; `None` if there was none by the deadline. Garbage cannot delay it.
    ///
    /// # Errors
    ///
    /// As of [`receive`](Self::receive).
    pub fn receive_until(&mut self, deadline: Instant) -> Result<Option<Frame<'_>>, LinkError> {
        Ok(self.deliver(Some(deadline))?.map(|(frame, _)| frame))
    }

    /// The next frame, and who sent it; `None` if there was none by the deadline.
    ///
    /// # Errors
    ///
    /// As of [`receive`](Self::receive).
    pub fn receive_from(&mut self, deadline: Instant) -> Result<Option<(Frame<'_>, Peer)>, LinkError> {
        self.deliver(Some(deadline))
    }

    /// What was received and sent so far.
    #[must_use]
    pub fn statistics(&self) -> LinkStatistics {
        let received = match &self.carrier {
            Carrier::Log(log) => log.statistics(),
            _ => self.inbox.statistics(),
        };
        self.shared.counters.with(received, self.inbox.refused)
    }

    /// Lost frames by component, counted by sequence numbers.
    #[must_use]
    pub const fn losses(&self) -> &Losses {
        &self.losses
    }

    /// The verifier of signatures, if there is one. Save its time and its streams.
    #[cfg(feature = "signing")]
    pub fn verifier(&mut self) -> Option<&mut Verifier> {
        self.inbox.verifier.as_mut()
    }

    /// From now on, checks signatures with this verifier; with `None`, trusts every frame. Use it after a new key was sent.
    #[cfg(feature = "signing")]
    pub fn set_verifier(&mut self, verifier: Option<Verifier>) {
        self.inbox.verifier = verifier;
    }

    fn deliver(&mut self, deadline: Option<Instant>) -> Result<Option<(Frame<'_>, Peer)>, LinkError> {
        self.shared.check()?;
        if matches!(self.carrier, Carrier::Log(_)) {
            return self.deliver_logged();
        }
        let mut is_first = true;
        let delivery = loop {
            if let Some(delivery) = self.inbox.find(&mut not_told) {
                break delivery;
            }
            self.shared.check()?;
            let left = deadline.map(|deadline| deadline.saturating_duration_since(Instant::now()));
            // Also who comes too late gets what has come.
            if left == Some(Duration::ZERO) && !is_first {
                return Ok(None);
            }
            is_first = false;
            let limits = [left, self.inbox.patience()];
            self.wait(limits.into_iter().flatten().fold(SLICE, Duration::min))?;
        };
        let Some((frame, peer)) = self.inbox.frame(&delivery) else { return Ok(None) };
        self.losses.count(&frame);
        Ok(Some((frame, peer)))
    }

    fn deliver_logged(&mut self) -> Result<Option<(Frame<'_>, Peer)>, LinkError> {
        let Carrier::Log(log) = &mut self.carrier else { return Ok(None) };
        let frame = log.next().map_err(LinkError::Io)?.ok_or(LinkError::Ended)?;
        self.losses.count(&frame);
        Ok(Some((frame, Peer::NEARBY)))
    }

    /// Waits so long for bytes.
    fn wait(&mut self, limit: Duration) -> Result<(), LinkError> {
        match &mut self.carrier {
            Carrier::Datagrams(socket) => socket.wait(&mut self.inbox, limit),
            Carrier::Line(hearing) => {
                let began = Instant::now();
                match hearing.stream()? {
                    None => thread::sleep(limit.min(POLL)),
                    Some(stream) => {
                        let read = in_time(stream.read_within(self.inbox.space(), limit));
                        hearing.take(&mut self.inbox, read, began.elapsed());
                    }
                }
                Ok(())
            }
            Carrier::Stream(kept) => {
                kept.check()?;
                let length = uninterrupted(|| kept.file.read(self.inbox.space())).map_err(LinkError::Io)?;
                kept.take(&mut self.inbox, length);
                Ok(())
            }
            Carrier::Log(_) => Ok(()),
        }
    }
}

impl core::fmt::Debug for ReceiveHalf {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("ReceiveHalf").field("shared", &self.shared).field("inbox", &self.inbox).finish_non_exhaustive()
    }
}

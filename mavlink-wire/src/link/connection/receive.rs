//! The half that receives.

use std::boxed::Box;
use std::fs::File;
use std::io::Read;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use super::stream::Stream;
use super::udp::Receiving;
use crate::adapters::pause::{is_interrupted, is_not_now, uninterrupted};
use crate::link::file::{Log, Recording};
use crate::link::line::{End, Line};
use crate::link::shared::Shared;
use crate::link::{Inbox, LinkError, LinkStatistics, Peer};
use crate::parser::not_told;
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{Frame, Losses, Table};

/// So often somebody who waits looks whether the link was closed.
const SLICE: Duration = Duration::from_millis(200);

/// So often somebody who waits for a connection looks whether it is there.
const POLL: Duration = Duration::from_millis(20);

/// After so long, a silent client of a listener gives its place to one who waits.
const SILENT: Duration = Duration::from_secs(5);

/// The half of a [`Link`](super::Link) that receives.
pub struct ReceiveHalf {
    pub(super) shared: Arc<Shared>,
    pub(super) inbox: Inbox<'static>,
    pub(super) carrier: Carrier,
    pub(super) losses: Losses,
}

pub(super) enum Carrier {
    Datagrams(Receiving),
    Line { line: Arc<Line<Box<dyn Stream>>>, end: Option<End<Box<dyn Stream>>>, heard: Instant },
    Stream { file: File, ended: bool },
    Log(Box<Log<File>>),
}

impl Carrier {
    pub(super) fn of_recording(Recording { file, is_log }: Recording, table: &'static Table<'static>) -> Self {
        if is_log { Self::Log(Box::new(Log::new(file, table))) } else { Self::Stream { file, ended: false } }
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
            Carrier::Line { line, end, heard } => {
                line.refresh_reader(end)?;
                if end.is_none() {
                    thread::sleep(limit.min(POLL));
                } else {
                    read(line, end, heard, &mut self.inbox, limit);
                }
                Ok(())
            }
            Carrier::Stream { file, ended } => read_file(file, ended, &mut self.inbox),
            Carrier::Log(_) => Ok(()),
        }
    }
}

/// Reads from a connection, or notices that it is lost.
fn read(
    line: &Line<Box<dyn Stream>>,
    end: &mut Option<End<Box<dyn Stream>>>,
    heard: &mut Instant,
    inbox: &mut Inbox<'_>,
    limit: Duration,
) {
    let Some(open) = end else { return };
    let began = Instant::now();
    match open.stream.read_within(inbox.space(), limit) {
        Ok(0) => {
            inbox.end();
            line.lose(end, &"the other side has closed the connection");
        }
        Ok(length) => {
            inbox.fill(length, open.peer, began.elapsed());
            *heard = Instant::now();
        }
        Err(error) if is_interrupted(&error) || is_not_now(&error) => {
            inbox.give_up();
            if heard.elapsed() >= SILENT {
                line.replace_silent();
            }
        }
        Err(error) => {
            inbox.end();
            line.lose(end, &error);
        }
    }
}

/// Reads on in a file. Its end is told once what was before it is handed over.
fn read_file(file: &mut File, ended: &mut bool, inbox: &mut Inbox<'_>) -> Result<(), LinkError> {
    if core::mem::take(ended) {
        return Err(LinkError::Ended);
    }
    match uninterrupted(|| file.read(inbox.space())).map_err(LinkError::Io)? {
        0 => {
            inbox.end();
            *ended = true;
        }
        length => inbox.fill(length, Peer::NEARBY, Duration::ZERO),
    }
    Ok(())
}

impl core::fmt::Debug for ReceiveHalf {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("ReceiveHalf").field("shared", &self.shared).field("inbox", &self.inbox).finish_non_exhaustive()
    }
}

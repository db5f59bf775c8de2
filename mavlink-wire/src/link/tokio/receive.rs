//! The half that receives.

use core::future::{Future, poll_fn};
use std::boxed::Box;
use std::io::{ErrorKind, Read};
use std::sync::Arc;
use std::time::{Duration, Instant};
use std::vec;
use std::vec::Vec;

use ::tokio::fs::File;
use ::tokio::io::{AsyncRead, ReadBuf};
use ::tokio::net::UdpSocket;
use ::tokio::time::{sleep, timeout, timeout_at};

use super::Common;
use super::ends::Opened;
use crate::link::file::{Kept, Log, Recording};
use crate::link::line::{Hearing, POLL, SILENT};
use crate::link::{Inbox, LinkError, LinkStatistics, Peer};
use crate::parser::not_told;
#[cfg(feature = "signing")]
use crate::signing::Verifier;
use crate::{Frame, FrameBuf, Losses, Table};

/// Bytes of a log that are read at once.
const CHUNK: usize = 8192;

/// The half of a [`Link`](super::Link) that receives.
pub struct ReceiveHalf {
    common: Arc<Common>,
    inbox: Inbox<'static>,
    carrier: Carrier,
    losses: Losses,
}

pub(super) enum Carrier {
    Datagrams(Arc<UdpSocket>),
    Line(Hearing<Opened>),
    Stream(Kept<File>),
    Log { file: File, log: Box<Log<Supply>>, last: Option<Box<FrameBuf>> },
}

/// What was read of a log and is not used yet.
pub(super) struct Supply {
    bytes: Vec<u8>,
    start: usize,
    end: usize,
    ended: bool,
}

impl Carrier {
    pub(super) fn of_recording(Recording { file, is_log }: Recording, table: &'static Table<'static>) -> Self {
        let file = File::from_std(file);
        if is_log {
            let supply = Supply { bytes: vec![0; CHUNK], start: 0, end: 0, ended: false };
            Self::Log { file, log: Box::new(Log::new(supply, table)), last: None }
        } else {
            Self::Stream(Kept::new(file))
        }
    }
}

impl ReceiveHalf {
    pub(super) const fn new(common: Arc<Common>, inbox: Inbox<'static>, carrier: Carrier) -> Self {
        Self { common, inbox, carrier, losses: Losses::new() }
    }

    /// The next frame. Waits without a limit, also while nobody is there. Cancel safe.
    ///
    /// # Errors
    ///
    /// [`LinkError::Closed`], [`LinkError::Ended`] at the end of a file, or what the system says.
    pub async fn receive(&mut self) -> Result<Frame<'_>, LinkError> {
        self.deliver().await.map(|(frame, _)| frame)
    }

    /// The next frame; `None` if there was none by the deadline. Garbage cannot delay it.
    ///
    /// # Errors
    ///
    /// As of [`receive`](Self::receive).
    pub async fn receive_until(&mut self, deadline: Instant) -> Result<Option<Frame<'_>>, LinkError> {
        Ok(self.receive_from(deadline).await?.map(|(frame, _)| frame))
    }

    /// The next frame, and who sent it; `None` if there was none by the deadline.
    ///
    /// # Errors
    ///
    /// As of [`receive`](Self::receive).
    pub async fn receive_from(&mut self, deadline: Instant) -> Result<Option<(Frame<'_>, Peer)>, LinkError> {
        match timeout_at(deadline.into(), self.deliver()).await {
            Ok(delivered) => delivered.map(Some),
            Err(_) => Ok(None),
        }
    }

    /// What was received and sent so far.
    #[must_use]
    pub fn statistics(&self) -> LinkStatistics {
        let received = match &self.carrier {
            Carrier::Log { log, .. } => log.statistics(),
            _ => self.inbox.statistics(),
        };
        self.common.shared.counters.with(received, self.inbox.refused)
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

    async fn deliver(&mut self) -> Result<(Frame<'_>, Peer), LinkError> {
        self.common.shared.check()?;
        if matches!(self.carrier, Carrier::Log { .. }) {
            return self.deliver_logged().await;
        }
        let delivery = loop {
            if let Some(delivery) = self.inbox.find(&mut not_told) {
                break delivery;
            }
            self.common.unless_closed(wait(&mut self.carrier, &mut self.inbox)).await??;
        };
        // There is somebody wherever something was found.
        let (frame, peer) = self.inbox.frame(&delivery).ok_or(LinkError::Closed)?;
        self.losses.count(&frame);
        Ok((frame, peer))
    }

    async fn deliver_logged(&mut self) -> Result<(Frame<'_>, Peer), LinkError> {
        let Carrier::Log { file, log, last } = &mut self.carrier else { return Err(LinkError::Ended) };
        let frame = self.common.unless_closed(next_of_log(file, log, last)).await??;
        self.losses.count(&frame);
        Ok((frame, Peer::NEARBY))
    }
}

/// Waits for bytes, or until the rest of a frame has been waited for long enough. May be dropped at any time: what was read is
/// in the inbox, and all else is where it was.
async fn wait(carrier: &mut Carrier, inbox: &mut Inbox<'static>) -> Result<(), LinkError> {
    let began = Instant::now();
    let patience = inbox.patience();
    match carrier {
        Carrier::Datagrams(socket) => {
            let came = within(patience, socket.recv_from(inbox.space())).await;
            inbox.take_datagram(came, began.elapsed()).map_err(LinkError::Io)?;
        }
        Carrier::Line(hearing) => match hearing.stream()? {
            None => sleep(POLL).await,
            Some(stream) => {
                let (limit, buffer) = (patience.unwrap_or(SILENT).min(SILENT), inbox.space());
                let read = within(Some(limit), poll_fn(|context| stream.poll_read(context, buffer))).await;
                hearing.take(inbox, read, began.elapsed());
            }
        },
        Carrier::Stream(kept) => {
            kept.check()?;
            let length = read_file(&mut kept.file, inbox.space()).await.map_err(LinkError::Io)?;
            kept.take(inbox, length);
        }
        Carrier::Log { .. } => {}
    }
    Ok(())
}

/// The next frame of a log.
async fn next_of_log<'f>(
    file: &mut File,
    log: &mut Log<Supply>,
    last: &'f mut Option<Box<FrameBuf>>,
) -> Result<Frame<'f>, LinkError> {
    loop {
        match log.next() {
            Ok(Some(frame)) => {
                let kept = last.insert(Box::new(frame.into()));
                return Ok(kept.as_frame());
            }
            Ok(None) => return Err(LinkError::Ended),
            Err(error) if error.kind() == ErrorKind::WouldBlock => log.input().fill(file).await?,
            Err(error) => return Err(LinkError::Io(error)),
        }
    }
}

impl Supply {
    /// Reads on.
    async fn fill(&mut self, file: &mut File) -> Result<(), LinkError> {
        let length = read_file(file, &mut self.bytes).await.map_err(LinkError::Io)?;
        (self.start, self.end, self.ended) = (0, length, length == 0);
        Ok(())
    }
}

/// Gives what was read; says [`ErrorKind::WouldBlock`] when more has to be.
impl Read for Supply {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        if core::mem::take(&mut self.ended) {
            return Ok(0);
        }
        let mut rest = self.bytes.get(self.start..self.end).unwrap_or_default();
        if rest.is_empty() {
            return Err(ErrorKind::WouldBlock.into());
        }
        let count = rest.read(buffer)?;
        self.start += count;
        Ok(count)
    }
}

async fn read_file(file: &mut File, buffer: &mut [u8]) -> std::io::Result<usize> {
    let mut buffer = ReadBuf::new(buffer);
    poll_fn(|context| core::pin::Pin::new(&mut *file).poll_read(context, &mut buffer)).await?;
    Ok(buffer.filled().len())
}

/// What comes of a future within this time, if there is a limit.
async fn within<T>(limit: Option<Duration>, future: impl Future<Output = T>) -> Option<T> {
    match limit {
        Some(limit) => timeout(limit, future).await.ok(),
        None => Some(future.await),
    }
}

impl core::fmt::Debug for ReceiveHalf {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("ReceiveHalf").field("common", &self.common).field("inbox", &self.inbox).finish_non_exhaustive()
    }
}

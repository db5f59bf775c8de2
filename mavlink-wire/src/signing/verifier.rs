//! Says which frames to trust.

use core::fmt;

use super::{Key, SigningError};
use crate::{ComponentId, Frame, SystemId, Timestamp};

/// How far the first frame of a stream may be behind the local time: one minute.
const LATE: u64 = 6_000_000;
/// How far a frame may be ahead of the clock: one day.
const AHEAD: u64 = 24 * 60 * LATE;

/// Why a frame was accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
pub enum Trust {
    /// A holder of the key made it, and it is new.
    Signed,
    /// Nothing vouches for it, but the rule for such frames lets it pass.
    Allowed,
    /// There is no key: anybody may have made it.
    Unchecked,
}

/// `signed`, `allowed` or `unchecked`.
impl fmt::Display for Trust {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Signed => "signed",
            Self::Allowed => "allowed",
            Self::Unchecked => "unchecked",
        })
    }
}

/// The frames of one component over one of its links, and the timestamp of the last one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub struct Stream {
    /// Which of the sender's links.
    pub link_id: u8,
    /// The sending system.
    pub system_id: SystemId,
    /// The sending component.
    pub component_id: ComponentId,
    /// The timestamp of the last frame that was accepted.
    pub timestamp: Timestamp,
}

impl Stream {
    /// A stream, as it was saved.
    #[must_use]
    pub const fn new(link_id: u8, system_id: SystemId, component_id: ComponentId, timestamp: Timestamp) -> Self {
        Self { link_id, system_id, component_id, timestamp }
    }

    fn is_of(&self, other: &Self) -> bool {
        (self.link_id, self.system_id, self.component_id) == (other.link_id, other.system_id, other.component_id)
    }
}

/// Verifies signatures, and remembers the last timestamp of each stream, at most `STREAMS` of them.
///
/// One for all links of a process: with one each, a frame could be replayed on another link. The order is that of
/// `mavlink_signature_check` in the C library: first the hash, then the timestamp, and only what passes both is
/// remembered, so that a forged frame cannot make genuine ones look old.
///
/// # Clocks
///
/// The local time goes along with what is received, since many devices have no clock. So a holder of the key whose clock is
/// wrong takes it along, and a stream that begins with the right time is then refused as old. Give [`check`](Self::check) the
/// time if you have a clock: a frame that is over a day ahead of it is refused, and whether a stream is too old to begin is
/// judged by the clock alone.
#[derive(Clone, Debug)]
pub struct Verifier<const STREAMS: usize = 16> {
    key: Option<Key>,
    /// The local time: told, restored or received.
    timestamp: Timestamp,
    /// The latest time that was told, or that was certainly past when what was restored was saved.
    told: Timestamp,
    /// Whether somebody with a clock tells the time.
    has_clock: bool,
    streams: [Stream; STREAMS],
    known: usize,
}

impl Verifier {
    /// A verifier of sixteen streams, as many as the C library has. Without a key it accepts every frame, as
    /// [`Trust::Unchecked`].
    ///
    /// For another key, make another verifier: no frame of the old one passes it.
    #[must_use]
    pub const fn new(key: Option<Key>) -> Self {
        Self::with_streams(key)
    }
}

impl<const STREAMS: usize> Verifier<STREAMS> {
    /// A verifier of another number of streams: `Verifier::<40>::with_streams(key)`.
    #[must_use]
    pub const fn with_streams(key: Option<Key>) -> Self {
        let none = Stream::new(0, SystemId::BROADCAST, ComponentId::BROADCAST, Timestamp::ZERO);
        Self {
            key,
            timestamp: Timestamp::ZERO,
            told: Timestamp::ZERO,
            has_clock: false,
            streams: [none; STREAMS],
            known: 0,
        }
    }

    /// Whether to trust a frame, now: [`Timestamp::ZERO`] if there is no clock. Unsigned ones only if they are
    /// `RADIO_STATUS` (message 109).
    ///
    /// The signature covers all of the frame but not what its message is taken for: see [`Frame::is_verified`].
    ///
    /// # Errors
    ///
    /// The frame is to be discarded.
    pub fn check(&mut self, frame: &Frame<'_>, now: Timestamp) -> Result<Trust, SigningError> {
        self.check_with(frame, now, |frame| frame.is_of_radio())
    }

    /// Like [`check`](Self::check), with a rule of yours for frames that no signature vouches for: unsigned ones, and
    /// those with a signature that is wrong or old. They are never remembered, whatever the rule says.
    ///
    /// # Errors
    ///
    /// The frame is to be discarded: what is wrong with the signature, and the rule does not allow the frame.
    pub fn check_with(
        &mut self,
        frame: &Frame<'_>,
        now: Timestamp,
        allow: impl FnOnce(&Frame<'_>) -> bool,
    ) -> Result<Trust, SigningError> {
        self.advance_time(now);
        self.has_clock |= now != Timestamp::ZERO;
        let Some(key) = &self.key else { return Ok(Trust::Unchecked) };
        match verified(key, frame).and_then(|stream| self.accept(stream)) {
            Ok(()) => Ok(Trust::Signed),
            Err(_) if allow(frame) => Ok(Trust::Allowed),
            Err(error) => Err(error),
        }
    }

    /// The local time: the latest that was told, restored, or received from a holder of the key. It never goes back.
    ///
    /// To be saved, and to be told to every [`Signer`](super::Signer::advance_time).
    #[must_use]
    pub const fn timestamp(&self) -> Timestamp {
        self.timestamp
    }

    /// Tells the time; an earlier one changes nothing. [`check`](Self::check) does so itself.
    pub fn advance_time(&mut self, now: Timestamp) {
        self.timestamp = self.timestamp.max(now);
        self.told = self.told.max(now);
    }

    /// By what time a stream is judged: the clock, if there is one, else whatever the local time is.
    const fn reference(&self) -> Timestamp {
        if self.has_clock { self.told } else { self.timestamp }
    }

    /// The streams so far, to be saved.
    #[must_use]
    pub fn streams(&self) -> &[Stream] {
        self.streams.get(..self.known).unwrap_or_default()
    }

    /// Goes on from what was saved. Of a stream that is known already, the later timestamp counts.
    ///
    /// # Errors
    ///
    /// [`SigningError::TooManyStreams`]: those that there is room for were restored.
    pub fn restore(&mut self, timestamp: Timestamp, streams: &[Stream]) -> Result<(), SigningError> {
        self.timestamp = self.timestamp.max(timestamp);
        // What is restored may have been taken ahead of the clock by what was received.
        self.told = self.told.max(Timestamp::new(timestamp.units().saturating_sub(AHEAD)));
        streams.iter().map(|&stream| self.restore_stream(stream)).fold(Ok(()), Result::and)
    }

    fn restore_stream(&mut self, stream: Stream) -> Result<(), SigningError> {
        match self.find(&stream) {
            Some(known) => known.timestamp = known.timestamp.max(stream.timestamp),
            None => self.add(stream)?,
        }
        Ok(())
    }

    /// Makes room: forgets the streams that stopped over a minute ago, and says how many. No frame of theirs can be
    /// replayed, since each is too old to be the first of a stream. [`check`](Self::check) does so itself when it needs room.
    pub fn forget_stale(&mut self) -> usize {
        let (before, local) = (self.known, self.reference());
        let mut kept = 0;
        for at in 0..before {
            if let Some(&stream) = self.streams.get(at)
                && !is_late(stream.timestamp, local)
                && let Some(place) = self.streams.get_mut(kept)
            {
                *place = stream;
                kept += 1;
            }
        }
        self.known = kept;
        before - kept
    }

    /// Judges the timestamp of a frame whose hash is right, and remembers it.
    fn accept(&mut self, stream: Stream) -> Result<(), SigningError> {
        let (timestamp, local) = (stream.timestamp, self.reference());
        if self.has_clock && timestamp.units() > local.units() + AHEAD {
            return Err(SigningError::TooFarAhead { timestamp, local });
        }
        match self.find(&stream) {
            Some(Stream { timestamp: last, .. }) if timestamp <= *last => {
                return Err(SigningError::Replayed { timestamp, last: *last });
            }
            Some(known) => *known = stream,
            None => {
                if self.known == STREAMS {
                    self.forget_stale();
                }
                // Room comes first, as in the C library.
                if self.known < STREAMS && is_late(timestamp, local) {
                    return Err(SigningError::TooOld { timestamp, local });
                }
                self.add(stream)?;
            }
        }
        self.timestamp = self.timestamp.max(timestamp);
        Ok(())
    }

    fn add(&mut self, stream: Stream) -> Result<(), SigningError> {
        let free = self.streams.get_mut(self.known).ok_or(SigningError::TooManyStreams { limit: STREAMS })?;
        *free = stream;
        self.known += 1;
        Ok(())
    }

    fn find(&mut self, stream: &Stream) -> Option<&mut Stream> {
        self.streams.iter_mut().take(self.known).find(|known| known.is_of(stream))
    }
}

/// The stream that a frame belongs to, and its timestamp there, if the hash is right.
fn verified(key: &Key, frame: &Frame<'_>) -> Result<Stream, SigningError> {
    let signature = frame.signature().ok_or(SigningError::Unsigned { message_id: frame.message_id() })?;
    let (link_id, system_id, component_id) = (signature.link_id(), frame.system_id(), frame.component_id());
    if key.made(frame.bytes()) {
        Ok(Stream { link_id, system_id, component_id, timestamp: signature.timestamp() })
    } else {
        Err(SigningError::WrongHash { link_id, system_id, component_id })
    }
}

fn is_late(timestamp: Timestamp, local: Timestamp) -> bool {
    timestamp.units() + LATE < local.units()
}

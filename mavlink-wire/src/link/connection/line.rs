//! A connection or a device that is opened again when it is lost. Both halves of a link have a hand on it.

use std::boxed::Box;
use std::string::{String, ToString};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::stream::{Opener, Stream};
use crate::link::statistics::Counters;
use crate::link::{LinkError, Peer, Peers};

/// How long to wait after the first attempt that failed; then twice as long each time.
const FIRST_WAIT: Duration = Duration::from_millis(100);

/// How long to wait at most.
const LONGEST_WAIT: Duration = Duration::from_secs(5);

/// What has lasted for so long was a connection, and the next attempt is a first one.
const LASTING: Duration = Duration::from_secs(1);

/// What both halves of a link share of a connection.
pub(super) struct Line {
    state: Mutex<State>,
    reconnects: bool,
    peers: Peers,
    counters: Arc<Counters>,
}

struct State {
    opener: Box<dyn Opener>,
    connection: Option<Connection>,
    /// Counts connections, so that each half knows whether its own is still the same.
    generation: u64,
    /// When it was opened or lost.
    since: Instant,
    /// How long to wait before the next attempt, and since when.
    wait: Duration,
    trouble: Option<String>,
}

/// An open connection, and the hands that the halves have not taken yet.
struct Connection {
    reader: Option<Box<dyn Stream>>,
    writer: Option<Box<dyn Stream>>,
    kept: Box<dyn Stream>,
    peer: Peer,
}

/// A half of a connection.
pub(super) struct End {
    pub(super) stream: Box<dyn Stream>,
    pub(super) peer: Peer,
    generation: u64,
}

impl End {
    /// Which of the connections that were made one after the other.
    pub(super) const fn generation(&self) -> u64 {
        self.generation
    }
}

/// Which half.
#[derive(Clone, Copy)]
pub(super) enum Side {
    Reading,
    Writing,
}

impl Line {
    /// A line that is opened now, or as soon as somebody comes.
    pub(super) fn open(
        mut opener: Box<dyn Opener>,
        reconnects: bool,
        peers: Peers,
        counters: Arc<Counters>,
    ) -> Result<Self, LinkError> {
        let first = opener.attempt()?;
        let state = State {
            opener,
            connection: None,
            generation: 0,
            since: Instant::now(),
            wait: Duration::ZERO,
            trouble: None,
        };
        let line = Self { state: Mutex::new(state), reconnects, peers, counters };
        if let Some((stream, peer)) = first {
            line.adopt(&mut line.lock(), stream, peer)?;
        }
        Ok(line)
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Brings a half up to date: it keeps its end, gets that of a new connection, or has none for now. Opens the line if it is
    /// time to.
    pub(super) fn refresh(&self, end: &mut Option<End>, side: Side) -> Result<(), LinkError> {
        let mut state = self.lock();
        if state.connection.is_none() {
            self.reopen(&mut state)?;
        }
        let generation = state.generation;
        let Some(connection) = &mut state.connection else {
            *end = None;
            return Ok(());
        };
        if end.as_ref().is_some_and(|end| end.generation == generation) {
            return Ok(());
        }
        let taken = match side {
            Side::Reading => connection.reader.take(),
            Side::Writing => connection.writer.take(),
        };
        let peer = connection.peer;
        *end = taken.map(|stream| End { stream, peer, generation });
        Ok(())
    }

    /// Tries to open the line, if it is time to.
    fn reopen(&self, state: &mut State) -> Result<(), LinkError> {
        let is_first = state.generation == 0;
        if !self.reconnects && !is_first {
            return Err(LinkError::Closed);
        }
        if state.since.elapsed() < state.wait {
            return Ok(());
        }
        match state.opener.attempt().and_then(|opened| match opened {
            Some((stream, peer)) => self.adopt(state, stream, peer),
            None => Ok(()),
        }) {
            Ok(()) => {}
            Err(error) => {
                state.trouble = Some(error.to_string());
                state.since = Instant::now();
                state.wait = (state.wait * 2).clamp(FIRST_WAIT, LONGEST_WAIT);
            }
        }
        Ok(())
    }

    /// Takes over a new connection.
    fn adopt(&self, state: &mut State, stream: Box<dyn Stream>, peer: Peer) -> Result<(), LinkError> {
        let (reader, writer) = (stream.twin().map_err(LinkError::Io)?, stream.twin().map_err(LinkError::Io)?);
        if let Some(former) =
            state.connection.replace(Connection { reader: Some(reader), writer: Some(writer), kept: stream, peer })
        {
            former.kept.shut();
        }
        state.generation += 1;
        (state.since, state.trouble) = (Instant::now(), None);
        self.peers.name(Some(peer));
        self.counters.count_connection();
        Ok(())
    }

    /// Gives up a connection that has ended or failed.
    pub(super) fn lose(&self, end: &mut Option<End>, why: &dyn ToString) {
        let (mut state, Some(end)) = (self.lock(), end.take()) else { return };
        // The other half may have noticed it before, and there may be a new one.
        if end.generation != state.generation {
            return;
        }
        if let Some(connection) = state.connection.take() {
            connection.kept.shut();
            let lasted = state.since.elapsed() >= LASTING;
            state.wait = if lasted { FIRST_WAIT } else { (state.wait * 2).clamp(FIRST_WAIT, LONGEST_WAIT) };
            (state.since, state.trouble) = (Instant::now(), Some(why.to_string()));
            self.peers.name(None);
        }
    }

    /// Takes another client in place of one that has been silent, if somebody waits at a listener.
    pub(super) fn replace_silent(&self) {
        let mut state = self.lock();
        if state.opener.is_listener()
            && let Ok(Some((stream, peer))) = state.opener.attempt()
        {
            // What does not work is as good as nobody.
            let _ = self.adopt(&mut state, stream, peer);
        }
    }

    /// An error, if the line was lost and is not opened again.
    pub(super) fn check(&self) -> Result<(), LinkError> {
        if self.reconnects || self.is_connected() { Ok(()) } else { Err(LinkError::Closed) }
    }

    pub(super) fn is_connected(&self) -> bool {
        self.lock().connection.is_some()
    }

    /// Why it is not connected.
    pub(super) fn trouble(&self) -> Option<String> {
        self.lock().trouble.clone()
    }

    /// Ends the connection, so that whoever waits for it stops waiting.
    pub(super) fn shut(&self) {
        if let Some(connection) = &self.lock().connection {
            connection.kept.shut();
        }
    }
}

//! A connection or a device that is opened again when it is lost. Both halves of a link have a hand on it.

use std::boxed::Box;
use std::io;
use std::string::{String, ToString};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

use super::ends::{Ends, Opener, Parts, Shut};
use super::shared::Shared;
use super::statistics::Counters;
use super::{Inbox, LinkError, Peer, Peers};
use crate::adapters::pause::is_interrupted;

/// How long to wait after the first attempt that failed; then twice as long each time.
const FIRST_WAIT: Duration = Duration::from_millis(100);

/// How long to wait at most.
const LONGEST_WAIT: Duration = Duration::from_secs(5);

/// What has lasted for so long was a connection, and the next attempt is a first one.
const LASTING: Duration = Duration::from_secs(1);

/// After so long, a silent client of a listener gives its place to one who waits.
pub(super) const SILENT: Duration = Duration::from_secs(5);

/// So often somebody who waits for a connection looks whether it is there.
pub(super) const POLL: Duration = Duration::from_millis(20);

/// What both halves of a link share of a connection.
pub(super) struct Line<E: Ends> {
    state: Mutex<State<E>>,
    reconnects: bool,
    peers: Peers,
    counters: Arc<Counters>,
}

struct State<E: Ends> {
    opener: Box<dyn Opener<E>>,
    connection: Option<Connection<E>>,
    /// Counts connections, so that each half knows whether its own is still the same.
    generation: u64,
    /// When it was opened or lost.
    since: Instant,
    /// How long to wait before the next attempt, and since when.
    wait: Duration,
    trouble: Option<String>,
}

/// An open connection, and the hands that the halves have not taken yet.
struct Connection<E: Ends> {
    reader: Option<E::Reader>,
    writer: Option<E::Writer>,
    kept: Box<dyn Shut>,
    peer: Peer,
}

/// A half of a connection.
pub(super) struct End<S> {
    pub(super) stream: S,
    pub(super) peer: Peer,
    generation: u64,
}

/// The half that reads.
pub(super) struct Hearing<E: Ends> {
    line: Arc<Line<E>>,
    end: Option<End<E::Reader>>,
    /// When something came last.
    heard: Instant,
}

impl<E: Ends> Hearing<E> {
    pub(super) fn new(line: Arc<Line<E>>) -> Self {
        Self { line, end: None, heard: Instant::now() }
    }

    /// What to read from; `None` while there is no connection. Opens the line if it is time to.
    pub(super) fn stream(&mut self) -> Result<Option<&mut E::Reader>, LinkError> {
        self.line.refresh(&mut self.end, |connection| &mut connection.reader)?;
        Ok(self.end.as_mut().map(|end| &mut end.stream))
    }

    /// Takes what was read, if anything in time, after a wait of so long; or notices that the connection is lost.
    pub(super) fn take(&mut self, inbox: &mut Inbox<'_>, read: Option<io::Result<usize>>, waited: Duration) {
        match (read, &self.end) {
            (Some(Ok(0)), _) => self.lose(inbox, &"the other side has closed the connection"),
            (Some(Ok(length)), Some(end)) => {
                inbox.fill(length, end.peer, waited);
                self.heard = Instant::now();
            }
            (Some(Err(error)), _) if !is_interrupted(&error) => self.lose(inbox, &error),
            _ => {
                inbox.give_up();
                if self.heard.elapsed() >= SILENT {
                    self.line.replace_silent();
                }
            }
        }
    }

    fn lose(&mut self, inbox: &mut Inbox<'_>, why: &dyn ToString) {
        inbox.end();
        self.line.lose(&mut self.end, why);
    }
}

impl<E: Ends> Line<E> {
    /// A line that is opened now, or as soon as somebody comes.
    pub(super) fn open(opener: Box<dyn Opener<E>>, reconnects: bool, shared: &Shared) -> Result<Self, LinkError> {
        let state = State {
            opener,
            connection: None,
            generation: 0,
            since: Instant::now(),
            wait: Duration::ZERO,
            trouble: None,
        };
        let (peers, counters) = (shared.peers.clone(), shared.counters.clone());
        let line = Self { state: Mutex::new(state), reconnects, peers, counters };
        line.attempt(&mut line.lock())?;
        Ok(line)
    }

    fn lock(&self) -> MutexGuard<'_, State<E>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Brings the half that writes up to date: it keeps its end, gets that of a new connection, or has none for now. Opens the
    /// line if it is time to. Whether it is another end than before.
    pub(super) fn refresh_writer(&self, end: &mut Option<End<E::Writer>>) -> Result<bool, LinkError> {
        self.refresh(end, |connection| &mut connection.writer)
    }

    fn refresh<S>(
        &self,
        end: &mut Option<End<S>>,
        half: impl FnOnce(&mut Connection<E>) -> &mut Option<S>,
    ) -> Result<bool, LinkError> {
        let mut state = self.lock();
        if state.connection.is_none() {
            self.reopen(&mut state)?;
        }
        let generation = state.generation;
        let Some(connection) = &mut state.connection else { return Ok(end.take().is_some()) };
        let is_same = end.as_ref().is_some_and(|end| end.generation == generation);
        if !is_same {
            let peer = connection.peer;
            *end = half(connection).take().map(|stream| End { stream, peer, generation });
        }
        Ok(!is_same)
    }

    /// Tries to open the line, if it is time to.
    fn reopen(&self, state: &mut State<E>) -> Result<(), LinkError> {
        if !self.reconnects && state.generation > 0 {
            return Err(LinkError::Closed);
        }
        if state.since.elapsed() >= state.wait
            && let Err(error) = self.attempt(state)
        {
            state.trouble = Some(error.to_string());
            state.since = Instant::now();
            state.wait = (state.wait * 2).clamp(FIRST_WAIT, LONGEST_WAIT);
        }
        Ok(())
    }

    /// Goes on with opening, and takes over what is open.
    fn attempt(&self, state: &mut State<E>) -> Result<(), LinkError> {
        let Some((ends, peer)) = state.opener.attempt()? else { return Ok(()) };
        let Parts { reader, writer, kept } = ends.split().map_err(LinkError::Io)?;
        let connection = Connection { reader: Some(reader), writer: Some(writer), kept, peer };
        if let Some(former) = state.connection.replace(connection) {
            former.kept.shut();
        }
        state.generation += 1;
        (state.since, state.trouble) = (Instant::now(), None);
        self.peers.name(Some(peer));
        self.counters.count_connection();
        Ok(())
    }

    /// Gives up a connection that has ended or failed.
    pub(super) fn lose<S>(&self, end: &mut Option<End<S>>, why: &dyn ToString) {
        let (mut state, Some(end)) = (self.lock(), end.take()) else { return };
        // The other half may have noticed it before, and there may be a new one.
        if end.generation != state.generation {
            return;
        }
        if let Some(connection) = state.connection.take() {
            connection.kept.shut();
            state.wait = match state.since.elapsed() {
                _ if state.opener.is_listener() => Duration::ZERO,
                lasted if lasted >= LASTING => FIRST_WAIT,
                _ => (state.wait * 2).clamp(FIRST_WAIT, LONGEST_WAIT),
            };
            (state.since, state.trouble) = (Instant::now(), Some(why.to_string()));
            self.peers.name(None);
        }
    }

    /// Goes on with the first attempt; whether it has succeeded, and why not.
    #[cfg(feature = "tokio")]
    pub(super) fn try_first(&self) -> Result<bool, LinkError> {
        let mut state = self.lock();
        if state.connection.is_none() {
            self.attempt(&mut state)?;
        }
        Ok(state.connection.is_some())
    }

    /// Takes another client in place of one that has been silent, if somebody waits at a listener.
    fn replace_silent(&self) {
        let mut state = self.lock();
        if state.opener.is_listener() {
            // Whoever comes and does not work is as good as nobody.
            let _ = self.attempt(&mut state);
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

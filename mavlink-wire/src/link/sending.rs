//! What the half that sends does, whether it waits by blocking or in a task.

/// The methods of `SendHalf`, with `async await` where it waits in a task.
///
/// `SendHalf` brings `line` (if the link is a connection or device), `with_sender` and `shared`, and also `lock`, `with_outbox`,
/// `carry` and `write_pending`, which know how to wait. `Way` is what carries frames: it brings `carrier`, the frames that are
/// `pending`, and `address`.
macro_rules! sending {
    ($($async:ident $await:ident)?) => {
        impl SendHalf {
            /// Sends a message to the other end: with `udpin` to all peers, to each in its version of MAVLink, with one sequence
            /// number. Returns the number of peers: 0 if nobody is there now, which is no error.
            $(#[doc = concat!(
                "\n\nThis `", stringify!($async), " fn` is cancel safe: the message was not sent, or goes out before the next one."
            )])?
            ///
            /// # Errors
            ///
            /// - [`LinkError::Full`]: the buffer stayed full for the time in [`Options`](crate::link::Options). The message was
            ///   not sent.
            /// - [`LinkError::Encode`]: the version of a peer cannot carry the message; the other peers got it. Or it is a
            ///   `SETUP_SIGNING`, which may reach anybody: name a peer with [`send_to`](Self::send_to).
            /// - [`LinkError::Closed`], or an error of the system.
            pub $($async)? fn send(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError> {
                self.check_key(message)?;
                let mut way = self.ready()$(.$await)??;
                let made = self.with_outbox(&mut way, |outbox, pending| outbox.encode_to_all(message, pending));
                let sent = self.carry(&mut way)$(.$await)?;
                made.map_or_else(|error| Err(error.into()), |()| sent)
            }

            /// As [`send`](Self::send), but a connection or device gets the message only with the next [`flush`](Self::flush) or
            /// send: several messages then take one call of the system. When 64 messages are queued, they are written. UDP sends
            /// each at once.
            ///
            /// # Errors
            ///
            /// As of [`send`](Self::send).
            pub $($async)? fn queue(&self, message: &(impl Encode + ?Sized)) -> Result<usize, LinkError> {
                if self.line.is_none() {
                    return self.send(message)$(.$await)?;
                }
                self.check_key(message)?;
                let mut way = self.current()$(.$await)??;
                if way.pending.is_full() {
                    self.write_pending(&mut way)$(.$await)??;
                }
                if way.pending.is_full() {
                    return self.full();
                }
                let kept = way.pending.len();
                self.with_outbox(&mut way, |outbox, pending| outbox.encode_to_all(message, pending))?;
                Ok(way.address(kept))
            }

            /// Writes what is [queued](Self::queue).
            ///
            /// # Errors
            ///
            /// [`LinkError::Full`]: the buffer stayed full for the time in [`Options`](crate::link::Options). The rest goes out
            /// before the next message. Else as of [`send`](Self::send).
            pub $($async)? fn flush(&self) -> Result<(), LinkError> {
                let mut way = self.current()$(.$await)??;
                self.write_pending(&mut way)$(.$await)??;
                if way.pending.is_empty() { Ok(()) } else { Err(LinkError::Full) }
            }

            /// Sends a message to one peer: one of [`peers`](Self::peers), or any address on UDP.
            ///
            /// # Errors
            ///
            /// As of [`send`](Self::send); and [`LinkError::Unreachable`] if that is not who is at the other end.
            pub $($async)? fn send_to(&self, message: &(impl Encode + ?Sized), peer: Peer) -> Result<(), LinkError> {
                let mut way = self.ready()$(.$await)??;
                self.with_outbox(&mut way, |outbox, pending| outbox.encode_to(message, peer, pending))?;
                self.carry(&mut way)$(.$await)?.and_then(|count| is_sent(count, peer))
            }

            /// Sends a received frame byte for byte, for routers. To give it a sequence number or a signature of this link, call
            /// [`Sender::renumber`] before.
            ///
            /// # Errors
            ///
            /// As of [`send`](Self::send). A frame with a [key](Frame::carries_key) is not forwarded.
            pub $($async)? fn send_frame(&self, frame: &Frame<'_>) -> Result<usize, LinkError> {
                let mut way = self.ready()$(.$await)??;
                self.with_outbox(&mut way, |outbox, pending| outbox.forward_to_all(frame, pending))?;
                self.carry(&mut way)$(.$await)?
            }

            /// Sends a received frame as it came to one peer.
            ///
            /// # Errors
            ///
            /// As of [`send_to`](Self::send_to).
            pub $($async)? fn send_frame_to(&self, frame: &Frame<'_>, peer: Peer) -> Result<(), LinkError> {
                let mut way = self.ready()$(.$await)??;
                Outbox::forward_to(frame, peer, &mut way.pending)?;
                self.carry(&mut way)$(.$await)?.and_then(|count| is_sent(count, peer))
            }

            /// Which system sends.
            #[must_use]
            pub fn system_id(&self) -> SystemId {
                self.with_sender(|sender| sender.system_id())
            }

            /// Which component of it sends.
            #[must_use]
            pub fn component_id(&self) -> ComponentId {
                self.with_sender(|sender| sender.component_id())
            }

            /// The peers now, the one heard last first. With `udpout` and `udpbcast`, those who answered.
            #[must_use]
            pub fn peers(&self) -> Vec<Peer> {
                self.shared().peers.all(Instant::now())
            }

            /// Forgets a peer, and returns whether it was one. If it sends again, it is a peer again.
            pub fn remove_peer(&self, peer: Peer) -> bool {
                self.shared().peers.remove(peer, Instant::now())
            }

            /// Whether there is a connection, or a device. UDP and files need none.
            #[must_use]
            pub fn is_connected(&self) -> bool {
                self.line.as_ref().is_none_or(|line| line.is_connected())
            }

            /// Why there is no connection now.
            #[must_use]
            pub fn trouble(&self) -> Option<String> {
                self.line.as_ref().and_then(|line| line.trouble())
            }

            /// The address on which `udpin` and `tcpin` listen. If you gave port 0, it has the port that the system chose.
            #[must_use]
            pub fn local_addr(&self) -> Option<SocketAddr> {
                self.shared().local
            }

            /// Anybody may be at the other end of some links: no key goes to all.
            fn check_key(&self, message: &(impl Encode + ?Sized)) -> Result<(), LinkError> {
                let is_key = message.info().id == SETUP_SIGNING && self.shared().is_open_to_all;
                if is_key { Err(EncodeError::CarriesKey.into()) } else { Ok(()) }
            }

            /// Gets ready to send: connected if that is possible, and rid of what is left of former frames.
            $($async)? fn ready(&self) -> Result<MutexGuard<'_, Way>, LinkError> {
                let mut way = self.current()$(.$await)??;
                self.write_pending(&mut way)$(.$await)??;
                if way.pending.is_empty() { Ok(way) } else { self.full() }
            }

            /// Connected, if that is possible.
            $($async)? fn current(&self) -> Result<MutexGuard<'_, Way>, LinkError> {
                let mut way = self.lock()$(.$await)??;
                let Way { carrier, pending, .. } = &mut *way;
                if let (Carrier::Line { end }, Some(line)) = (carrier, &self.line)
                    && line.refresh_writer(end)?
                {
                    // The rest of a frame means nothing to somebody else.
                    self.drop_pending(pending);
                }
                Ok(way)
            }

            /// A message finds no room.
            fn full<T>(&self) -> Result<T, LinkError> {
                self.shared().counters.count_unsent(1);
                Err(LinkError::Full)
            }

            fn drop_pending(&self, pending: &mut Pending) {
                self.shared().counters.count_unsent(pending.len());
                pending.clear();
            }
        }
    };
}

pub(super) use sending;

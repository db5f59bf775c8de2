//! What is the same of the traits of `embedded-io` for firmware that waits and for async tasks.

use core::fmt;

use ::embedded_io::{Error, ErrorKind};

use crate::EncodeError;

/// A message was not sent over a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
#[non_exhaustive]
pub enum SendError<E> {
    /// The sender cannot carry the message.
    Encode(EncodeError),
    /// The link has failed.
    Link(E),
    /// The link took no byte, and named no reason.
    NothingTaken,
}

impl<E: fmt::Display> fmt::Display for SendError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Encode(error) => error.fmt(f),
            Self::Link(error) => write!(f, "the link has failed: {error}"),
            Self::NothingTaken => f.write_str("the link takes no more bytes: open it again"),
        }
    }
}

impl<E: core::error::Error> core::error::Error for SendError<E> {}

/// No frame was received over a link.
///
/// There will be no third reason: where a link cannot fail, a `match` has one arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
pub enum ReceiveError<E> {
    /// 64 KiB were read, and no frame was found: nothing is lost, read again.
    NothingYet,
    /// The link has failed, or has timed out.
    Link(E),
}

impl<E: fmt::Display> fmt::Display for ReceiveError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NothingYet => {
                f.write_str("no frame in 64 KiB: read again; if it goes on, compare both sides' baud rates")
            }
            Self::Link(error) => write!(f, "the link has failed: {error}"),
        }
    }
}

impl<E: core::error::Error> core::error::Error for ReceiveError<E> {}

/// Of the link's kind; of kind [`TimedOut`](ErrorKind::TimedOut), which may be tried again, when there is
/// nothing yet.
impl<E: Error> Error for ReceiveError<E> {
    fn kind(&self) -> ErrorKind {
        match self {
            Self::NothingYet => ErrorKind::TimedOut,
            Self::Link(error) => error.kind(),
        }
    }
}

/// Something came in between: call again.
pub(super) fn is_interrupted(error: &impl Error) -> bool {
    error.kind() == ErrorKind::Interrupted
}

/// Reads and writes frames, with `async await` for async tasks.
macro_rules! frames {
    ($($async:ident $await:ident)?) => {
        $crate::adapters::frame_reader::frame_reader!(64);
        $crate::adapters::frame_writer::frame_writer!();

        impl<R: Read, const N: usize> FrameReader<'_, R, N> {
            /// The next frame; `None` at the end of the stream, when what waited for more bytes was searched as well.
            ///
            /// # Errors
            ///
            /// - [`ReceiveError::NothingYet`]: 64 KiB were read, and no frame was found. Nothing is lost: call it again.
            /// - [`ReceiveError::Link`]: what `R` says, except for [`ErrorKind::Interrupted`]. Nothing is lost: read again if
            ///   it was a timeout.
            pub $($async)? fn receive(&mut self) -> Result<Option<Frame<'_>>, ReceiveError<R::Error>> {
                self.receive_reporting_bad_checksums(not_told)$(.$await)?
            }

            /// The next frame, as [`receive`](Self::receive) gives it. `bad_checksum` is told the message of each frame that
            /// [`Statistics::bad_checksums`] counts: if it is often the same one, both sides define it otherwise.
            ///
            /// # Errors
            ///
            /// As [`receive`](Self::receive).
            pub $($async)? fn receive_reporting_bad_checksums(
                &mut self,
                mut bad_checksum: impl FnMut(u32),
            ) -> Result<Option<Frame<'_>>, ReceiveError<R::Error>> {
                let mut read = 0;
                loop {
                    if let Some(found) = self.incoming.find(&mut bad_checksum) {
                        return Ok(Some(self.incoming.frame(&found)));
                    }
                    if self.incoming.take_end() {
                        return Ok(None);
                    }
                    if read >= ENOUGH {
                        return Err(ReceiveError::NothingYet);
                    }
                    match self.inner.read(self.incoming.space())$(.$await)? {
                        Ok(count) => read += self.incoming.fill(count),
                        Err(error) if is_interrupted(&error) => {}
                        Err(error) => return Err(ReceiveError::Link(error)),
                    }
                }
            }
        }

        impl<W: Write> FrameWriter<W> {
            /// Sends a message. It may still lie in a buffer of `W`: see [`flush`](Self::flush). If the link takes only a part
            /// of the frame before a timeout, the rest is kept and goes out before the next one.
            ///
            /// # Errors
            ///
            /// - [`SendError::Encode`]: the sender cannot carry the message.
            /// - [`SendError::Link`] with [`ErrorKind::TimedOut`]: the link has not yet taken the frame before. This one was
            ///   not sent, and has no number: send it again.
            /// - What else `W` says: the link has failed in the middle of a frame. What is left of it is kept.
            pub $($async)? fn send(&mut self, message: &(impl Encode + ?Sized)) -> Result<(), SendError<W::Error>> {
                self.write_pending()$(.$await)??;
                self.outgoing.encode(message).map_err(SendError::Encode)?;
                self.try_write_pending()$(.$await)?
            }

            /// Sends a received frame as it came, to the byte. One that is to have a number, or a signature, of this link is
            /// made by [`Sender::renumber`] before.
            ///
            /// # Errors
            ///
            /// As of [`send`](Self::send); what is not carried is a frame with a [key](Frame::carries_key).
            pub $($async)? fn send_frame(&mut self, frame: &Frame<'_>) -> Result<(), SendError<W::Error>> {
                self.write_pending()$(.$await)??;
                self.outgoing.put_frame(frame).map_err(SendError::Encode)?;
                self.try_write_pending()$(.$await)?
            }

            /// Writes what is left of the last frame, and waits until `W` has sent everything.
            ///
            /// # Errors
            ///
            /// The link has failed, or has not taken everything in its time.
            pub $($async)? fn flush(&mut self) -> Result<(), SendError<W::Error>> {
                self.write_pending()$(.$await)??;
                self.inner.flush()$(.$await)?.map_err(SendError::Link)
            }

            /// Writes what is left of the last frame. A link that takes no more for now is no error: the rest is kept.
            $($async)? fn try_write_pending(&mut self) -> Result<(), SendError<W::Error>> {
                match self.write_pending()$(.$await)? {
                    Err(SendError::Link(error)) if error.kind() == ErrorKind::TimedOut => Ok(()),
                    result => result,
                }
            }

            $($async)? fn write_pending(&mut self) -> Result<(), SendError<W::Error>> {
                while !self.outgoing.pending().is_empty() {
                    match self.inner.write(self.outgoing.pending())$(.$await)? {
                        Ok(0) => return Err(SendError::NothingTaken),
                        Ok(count) => self.outgoing.advance(count),
                        Err(error) if is_interrupted(&error) => {}
                        Err(error) => return Err(SendError::Link(error)),
                    }
                }
                Ok(())
            }
        }
    };
}

pub(super) use frames;

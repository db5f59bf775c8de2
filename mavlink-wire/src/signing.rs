//! Signed frames: who sent them, and that they are new. Feature `signing`.
//!
//! A signature is 48 bits of SHA-256 over a secret key, the frame, the number of the link and the time (MAVLink guide,
//! "Message Signing"). It proves that a holder of the key made the frame, and a receiver that remembers the last time
//! of each stream takes no frame twice. It hides nothing: payloads are readable.
//!
//! # Sending
//!
//! A [`Signer`] per link, given to the link's [`Sender`](crate::Sender). Its timestamp goes up with every frame and
//! with the clock that you tell it, and never back. Save it, and start from the saved one.
//!
//! # Receiving
//!
//! A [`Verifier`] for all links says of each frame how far to [`Trust`] it:
//!
//! ```
//! use mavlink_wire::signing::{Key, SigningError, Trust, Verifier};
//! use mavlink_wire::{Frame, Table, Timestamp};
//!
//! let bytes = [
//!     0xfd, 9, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 6, 8, 0, 4, 3, 0xed, 0x78, // a heartbeat …
//!     3, 0xe8, 3, 0, 0, 0, 0, 0x44, 0x3d, 0xf4, 0x50, 0xd5, 0x92, // … of link 3, time 1000
//! ];
//! let frame = Frame::parse(&bytes, &Table::of(&[]))?;
//! let key = Key::new(core::array::from_fn(|at| at as u8));
//!
//! let (mut verifier, now) = (Verifier::new(Some(key)), Timestamp::new(2000));
//! assert_eq!(verifier.check(&frame, now), Ok(Trust::Signed));
//! let again = SigningError::Replayed { timestamp: Timestamp::new(1000), last: Timestamp::new(1000) };
//! assert_eq!(verifier.check(&frame, now), Err(again));
//! # Ok::<_, mavlink_wire::FrameError>(())
//! ```
//!
//! What the key does not vouch for is refused, but for `RADIO_STATUS`, which telemetry radios put into the stream and
//! cannot sign. [`Verifier::check_with`] takes another rule, say for a cable.
//!
//! # Routers and logs
//!
//! Frames are [forwarded to the byte](crate::Frame::bytes), or [re-signed](crate::FrameBuf::sign) for a link with
//! another key, or numbered and signed as that link's sender does it ([`Sender::renumber`](crate::Sender::renumber)).
//! Logs [take signatures away](crate::FrameBuf::strip_signature), and leave out frames that
//! [carry a key](crate::Frame::carries_key).
//!
//! ```
//! use mavlink_wire::signing::Verifier;
//! use mavlink_wire::{Frame, FrameBuf, Sender, Timestamp};
//!
//! /// What goes out on another link, of what came in.
//! fn route(frame: &Frame<'_>, verifier: &mut Verifier, link: &mut Sender, now: Timestamp) -> Option<FrameBuf> {
//!     verifier.check(frame, now).ok()?;
//!     link.advance_time(verifier.timestamp());
//!     link.renumber(frame).ok()
//! }
//!
//! /// What goes into the log.
//! fn entry(frame: Frame<'_>) -> Option<FrameBuf> {
//!     let mut entry = FrameBuf::from(frame);
//!     entry.strip_signature();
//!     (!frame.carries_key()).then_some(entry)
//! }
//! ```
//!
//! # Giving a key out
//!
//! [`Setup`] is the message `SETUP_SIGNING`: what a ground station sends over a cable, and a vehicle reads.
//!
//! ```
//! use mavlink_wire::signing::{Setup, Signer, Verifier};
//! use mavlink_wire::{Frame, Sender};
//!
//! /// Takes the key of a frame, or stops signing; only for what came over the cable.
//! fn obey(frame: &Frame<'_>, sender: &mut Sender, verifier: &mut Verifier) {
//!     let Some(setup) = Setup::decode(frame).filter(|setup| setup.target_system() == 1) else { return };
//!     match setup.key() {
//!         Some((key, timestamp)) => {
//!             sender.set_signer(Some(Signer::new(key.clone(), 0, timestamp)));
//!             *verifier = Verifier::new(Some(key.clone()));
//!             verifier.advance_time(timestamp);
//!         }
//!         None => {
//!             sender.set_signer(None);
//!             *verifier = Verifier::new(None);
//!         }
//!     }
//! }
//! ```
//!
//! # Keys in memory
//!
//! A [`Key`] is overwritten when it is dropped. So is the stack that a hash took, and what a parser, a reader, a writer or an
//! endpoint holds of a `SETUP_SIGNING`, once the frame is written or the next one asked for. The buffers that you lend are yours
//! to overwrite: the one for [`Sender::encode`](crate::Sender::encode), chunks for a parser, a
//! [`FrameBuf`](crate::FrameBuf).
//!
//! # What to save
//!
//! The key, [`Signer::timestamp`] of each link, [`Verifier::timestamp`] and, against replays of the last minute,
//! [`Verifier::streams`].

mod error;
mod key;
mod setup;
mod signer;
mod verifier;
mod wipe;

pub use error::SigningError;
pub use key::Key;
pub use setup::{ReceivedSetup, Setup};
pub use signer::Signer;
pub use verifier::{Stream, Trust, Verifier};

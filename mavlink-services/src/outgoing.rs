//! Messages on their way out, and messages of other dialects on their way in.

use core::fmt;

use mavlink_wire::{Encode, MAX_PAYLOAD, Message, MessageInfo, Payload};

/// The longest payload that a machine sends; `MISSION_ITEM` has 38 bytes.
const LONGEST: usize = 40;

/// A message for you to send. It implements [`Encode`]: give it to a `Sender` or to a link.
#[derive(Clone, Copy)]
pub struct Outgoing {
    info: &'static MessageInfo,
    payload: [u8; LONGEST],
}

impl Outgoing {
    /// The message, if it is an `M`.
    #[must_use]
    pub fn decode<M: Message>(&self) -> Option<M> {
        if self.is::<M>() { Some(M::decode(&self.payload)) } else { None }
    }

    /// Whether it is an `M`, with the same definition.
    fn is<M: Message>(&self) -> bool {
        self.info.id == M::ID && self.info.crc_extra == M::INFO.crc_extra
    }
}

/// Of messages with up to 40 bytes, which is all that the protocols need; longer ones do not compile.
impl<M: Message> From<M> for Outgoing {
    #[inline]
    fn from(message: M) -> Self {
        const { assert!(size_of::<M::Payload>() <= LONGEST, "the payload is longer than a machine's messages are") }
        let mut payload = [0; LONGEST];
        if let Some(payload) = M::Payload::first_mut(&mut payload) {
            message.store(payload);
        }
        Self { info: M::INFO, payload }
    }
}

impl Encode for Outgoing {
    fn info(&self) -> &'static MessageInfo {
        self.info
    }

    fn write(&self, payload: &mut [u8; MAX_PAYLOAD]) {
        let length = usize::from(self.info.len_v2);
        if let (Some(to), Some(from)) = (payload.get_mut(..length), self.payload.get(..length)) {
            to.copy_from_slice(from);
        }
    }
}

/// The name, and the payload as bytes: field tables would cost flash.
impl fmt::Debug for Outgoing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {:02x?}", self.info.name, self.payload.get(..usize::from(self.info.len_v2)).unwrap_or_default())
    }
}

/// The message of `common` that a message of some dialect is; `None` if it is another one, or is defined differently.
pub(crate) fn convert<M: Message>(message: &(impl Encode + ?Sized)) -> Option<M> {
    let info = message.info();
    if info.id != M::ID || info.crc_extra != M::INFO.crc_extra {
        return None;
    }
    let mut payload = [0; MAX_PAYLOAD];
    message.write(&mut payload);
    payload.get(..usize::from(info.len_v2)).map(M::decode)
}

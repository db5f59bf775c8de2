//! A link on which every frame is signed.

use mavlink_autoquad::wire::signing::{Key, Signer, Trust, Verifier};
use mavlink_autoquad::wire::{Frame, Sender, Timestamp};

/// Both ends of the link.
pub struct Link {
    sender: Sender,
    verifier: Verifier,
}

impl Link {
    pub fn new() -> Self {
        let key = Key::of_passphrase("no std, no alloc, no panic");
        let signer = Signer::new(key.clone(), 0, Timestamp::ZERO);
        Self { sender: Sender::v2(1, 1).signed(signer), verifier: Verifier::new(Some(key)) }
    }

    /// Whether the frame, signed at one end, is believed at the other, and is what it was without its signature.
    pub fn carries(&mut self, frame: &Frame<'_>) -> bool {
        let Ok(mut sent) = self.sender.renumber(frame) else { return false };
        let trust = self.verifier.check(&sent.as_frame(), Timestamp::ZERO);
        if self.verifier.restore(Timestamp::ZERO, &[]).is_err() || self.verifier.forget_stale() > 0 {
            return false;
        }
        sent.set_sequence(frame.sequence());
        sent.strip_signature();
        trust == Ok(Trust::Signed) && sent.bytes() == frame.bytes()
    }
}

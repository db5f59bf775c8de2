//! The secret, and the hash over it.

use core::fmt;

use sha2::{Digest, Sha256};
use subtle::ConstantTimeEq;
use zeroize::{Zeroize, ZeroizeOnDrop};

use super::wipe::wipe_stack;

/// Bytes of the hash that are sent.
pub(crate) const HASH: usize = 6;

/// The secret that the signing sides of a network share: 32 bytes.
///
/// Overwritten with zeros when dropped, compared in constant time, and not shown by `Debug`. What [`Key::new`] was
/// given is a copy of yours to overwrite. So is what a move leaves behind: make a key where it stays.
#[derive(Clone)]
pub struct Key([u8; 32]);

impl Key {
    /// The key with these bytes, which should come from a source of randomness for secrets.
    #[must_use]
    pub const fn new(bytes: [u8; 32]) -> Self {
        Self(bytes)
    }

    /// The key that MAVProxy, Mission Planner and QGroundControl make of a passphrase: its SHA-256.
    ///
    /// One that a person can guess is no secret: whoever records a single frame can try passphrases at leisure.
    #[must_use]
    pub fn of_passphrase(passphrase: &str) -> Self {
        Self(Sha256::digest(passphrase).into())
    }

    /// The secret itself, to be stored where only its owner reads.
    #[must_use]
    pub const fn as_bytes(&self) -> &[u8; 32] {
        &self.0
    }

    /// Whether all bytes are zero, which in `SETUP_SIGNING` means to sign no more.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        *self == Self([0; 32])
    }

    /// The hash of a frame: of everything up to it, link id and timestamp included. Plain SHA-256 behind the key, no
    /// HMAC.
    pub(crate) fn hash(&self, signed: &[u8]) -> [u8; HASH] {
        let hash = self.hash_on_the_stack(signed);
        wipe_stack();
        hash
    }

    /// Not inlined: what it leaves on the stack is then where the next call of the caller overwrites it.
    #[inline(never)]
    fn hash_on_the_stack(&self, signed: &[u8]) -> [u8; HASH] {
        let mut sha = Sha256::new();
        sha.update(self.as_bytes());
        sha.update(signed);
        let [a, b, c, d, e, f, ..] = <[u8; 32]>::from(sha.finalize());
        [a, b, c, d, e, f]
    }

    /// Whether a frame ends with the hash that this key makes; takes the same time for every wrong one.
    pub(crate) fn made(&self, frame: &[u8]) -> bool {
        frame.split_last_chunk::<HASH>().is_some_and(|(signed, hash)| self.hash(signed).ct_eq(hash).into())
    }
}

impl From<[u8; 32]> for Key {
    fn from(bytes: [u8; 32]) -> Self {
        Self::new(bytes)
    }
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self.0.ct_eq(&other.0).into()
    }
}

impl Eq for Key {}

impl fmt::Debug for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Key(secret)")
    }
}

impl Drop for Key {
    fn drop(&mut self) {
        self.0.zeroize();
    }
}

impl ZeroizeOnDrop for Key {}

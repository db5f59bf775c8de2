//! The frames that carry a key, and what becomes of their bytes.

/// Id of `SETUP_SIGNING`.
pub(crate) const SETUP_SIGNING: u32 = 256;

/// Whether keys are wiped: they are where the feature `signing` makes something of them.
pub(crate) const WIPES: bool = cfg!(feature = "signing");

/// Overwrites bytes that held a key, whether somebody reads them afterwards or not.
#[cfg(feature = "signing")]
pub(crate) fn wipe(bytes: &mut [u8]) {
    zeroize::Zeroize::zeroize(bytes);
}

#[cfg(not(feature = "signing"))]
pub(crate) fn wipe(_: &mut [u8]) {}

/// Overwrites a buffer that held a key, but for `start..end` of it, which is still to be read.
pub(crate) fn wipe_around(buffer: &mut [u8], start: usize, end: usize) {
    let end = end.min(buffer.len());
    let (before, behind) = buffer.split_at_mut(end);
    wipe(behind);
    wipe(before.get_mut(..start.min(end)).unwrap_or_default());
}

#[cfg(all(test, feature = "signing"))]
mod tests {
    use super::*;

    #[test]
    fn what_is_still_to_be_read_stays() {
        for (start, end, expected) in
            [(0, 4, [7; 4]), (1, 3, [0, 7, 7, 0]), (4, 4, [0; 4]), (0, 0, [0; 4]), (9, 9, [0; 4])]
        {
            let mut buffer = [7; 4];
            wipe_around(&mut buffer, start, end);
            assert_eq!(buffer, expected, "{start}..{end}");
        }
    }
}

//! Where a byte stands.

/// Bytes that are looked at together: a vector register of most processors holds as many.
const BLOCK: usize = 16;

/// The place of the first of these bytes that is wanted.
///
/// Blocks without one take no branch for each byte, so that the compiler makes vector instructions of them.
#[inline]
pub(crate) fn first(bytes: &[u8], wanted: impl Fn(u8) -> bool) -> Option<usize> {
    let (blocks, _) = bytes.as_chunks::<BLOCK>();
    let without = |block: &&[u8; BLOCK]| !block.iter().fold(false, |found, &byte| found | wanted(byte));
    let from = blocks.iter().take_while(without).count() * BLOCK;
    let at = bytes.get(from..)?.iter().position(|&byte| wanted(byte))?;
    Some(from + at)
}

#[cfg(test)]
mod tests {
    use super::{BLOCK, first};

    #[test]
    fn the_first_is_found_wherever_it_stands() {
        let mut bytes = [0; 4 * BLOCK];
        for one in 0..bytes.len() {
            for another in one..bytes.len() {
                bytes.fill(0);
                bytes[one] = 1;
                bytes[another] = 1;
                for length in 0..=bytes.len() {
                    let expected = (one < length).then_some(one);
                    assert_eq!(first(&bytes[..length], |byte| byte == 1), expected, "{one}, {another} of {length}");
                }
            }
        }
    }
}

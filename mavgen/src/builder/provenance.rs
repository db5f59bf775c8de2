//! What the header of generated files says of the sources.

use crate::source::Sources;

/// How many sources a header names, at most.
const NAMED: usize = 24;

/// The names of the sources, or how many there are, and one number that changes with any of them (FNV-1a, 64 bits).
pub(super) fn provenance(sources: &Sources) -> String {
    let mut digest = 0xcbf2_9ce4_8422_2325_u64;
    let mut names = Vec::new();
    for (id, file) in sources.iter() {
        let name = sources.name(id);
        for byte in name.bytes().chain(file.text().bytes()) {
            digest = (digest ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
        names.push(name);
    }
    let names = if names.len() > NAMED { format!("{} files", names.len()) } else { names.join(", ") };
    format!("{names}; sources {digest:016x}")
}

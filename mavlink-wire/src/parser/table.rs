//! The messages that somebody knows, found by id.

use crate::MessageInfo;

/// Up to here a walk over all beats a search.
const FEW: usize = 8;

/// A set of messages, found by id: a whole dialect's, or the few that a firmware wants.
///
/// A value, not a type: routers, definitions read at run time and two-message firmware use the same parser.
///
/// ```
/// use mavlink_wire::{MessageInfo, Table};
///
/// const fn info(id: u32, name: &'static str, crc_extra: u8, length: u8) -> MessageInfo {
///     MessageInfo::new(id, name, crc_extra, length)
/// }
///
/// // Of a dialect crate's messages: `Table::of(&[Heartbeat::INFO, Attitude::INFO])`.
/// static WANTED: Table = Table::of(&[&info(0, "HEARTBEAT", 50, 9), &info(30, "ATTITUDE", 39, 28)]);
///
/// assert_eq!(WANTED.get(30).map(|info| info.name), Some("ATTITUDE"));
/// assert_eq!((WANTED.get(31), WANTED.len()), (None, 2));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Table<'t> {
    infos: &'t [&'t MessageInfo],
    /// Position + 1 in `infos` of each small id, 0 for none.
    index: &'t [u16],
    /// Where in `infos` those begin that are not in `index`.
    tail: usize,
    /// Whether a search may halve.
    sorted: bool,
}

impl<'t> Table<'t> {
    /// A table of these messages. If they are sorted by id, and none is there twice, a search takes logarithmic time, else
    /// linear: that is found out here, when the table is a constant at compile time.
    #[must_use]
    pub const fn of(infos: &'t [&'t MessageInfo]) -> Self {
        Self { infos, index: &[], tail: 0, sorted: is_sorted(infos) }
    }

    /// A table that finds ids below `index.len()` directly, and others as one [of](Self::of) these messages does; `index` comes
    /// from [`index`] over the same messages.
    #[must_use]
    pub const fn indexed(infos: &'t [&'t MessageInfo], index: &'t [u16]) -> Self {
        let sorted = is_sorted(infos);
        let (mut tail, mut rest) = (0, infos);
        while let ([first, others @ ..], true) = (rest, sorted) {
            if first.id as usize >= index.len() {
                break;
            }
            (tail, rest) = (tail + 1, others);
        }
        Self { infos, index, tail, sorted }
    }

    /// The message with this id; the first one if there are several.
    #[inline]
    #[must_use]
    pub fn get(&self, id: u32) -> Option<&'t MessageInfo> {
        self.find(id).map(|(_, info)| info)
    }

    /// The place of the message with this id among those that were given; the first one if there are several.
    #[inline]
    #[must_use]
    pub fn position(&self, id: u32) -> Option<usize> {
        self.find(id).map(|(position, _)| position)
    }

    #[inline]
    fn find(&self, id: u32) -> Option<(usize, &'t MessageInfo)> {
        match self.index.get(id as usize) {
            Some(&position) => {
                let position = usize::from(position).checked_sub(1)?;
                Some((position, self.infos.get(position)?))
            }
            None => self.search(id),
        }
    }

    fn search(&self, id: u32) -> Option<(usize, &'t MessageInfo)> {
        let (mut start, mut rest) = (self.tail, self.infos.get(self.tail..)?);
        while self.sorted && rest.len() > FEW {
            let (front, back) = rest.split_at_checked(rest.len() / 2)?;
            let is_behind = back.first().is_some_and(|info| info.id <= id);
            (start, rest) = if is_behind { (start + front.len(), back) } else { (start, front) };
        }
        let (place, info) = rest.iter().enumerate().find(|(_, info)| info.id == id)?;
        Some((start + place, info))
    }

    /// The messages in the order they were given.
    #[must_use]
    pub fn iter(&self) -> impl ExactSizeIterator<Item = &'t MessageInfo> + Clone + use<'t> {
        self.infos.iter().copied()
    }

    /// The number of messages.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.infos.len()
    }

    /// Whether there are no messages: everything received is handed over unverified.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.infos.is_empty()
    }
}

const fn is_sorted(infos: &[&MessageInfo]) -> bool {
    let mut rest = infos;
    while let [first, tail @ ..] = rest {
        if let [second, ..] = tail
            && first.id >= second.id
        {
            return false;
        }
        rest = tail;
    }
    true
}

/// Ids from this on are found by a search.
const DIRECT_IDS: u32 = 512;

/// The length of the [`index`] that finds every id below 512.
#[doc(hidden)]
#[must_use]
pub const fn index_length(infos: &[&MessageInfo]) -> usize {
    let (mut length, mut rest) = (0, infos);
    while let [first, tail @ ..] = rest {
        if first.id < DIRECT_IDS && first.id as usize >= length {
            length = first.id as usize + 1;
        }
        rest = tail;
    }
    length
}

/// The index of the ids below `N` for [`Table::indexed`]: position + 1 of the first message with it, or 0 for none.
///
/// Positions over 65,534 are left out.
#[must_use]
pub const fn index<const N: usize>(infos: &[&MessageInfo]) -> [u16; N] {
    let (mut index, mut position, mut rest) = ([0; N], 1_u16, infos);
    while let [first, tail @ ..] = rest {
        if let Some((_, [slot @ 0, ..])) = index.split_at_mut_checked(first.id as usize) {
            *slot = position;
        }
        if position == u16::MAX {
            break;
        }
        (position, rest) = (position + 1, tail);
    }
    index
}

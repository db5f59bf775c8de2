//! Sets of links.

/// Links by their numbers, 0 to 63; a higher number is in no set.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(::defmt::Format))]
pub struct Links(u64);

impl Links {
    /// No link.
    pub const NONE: Self = Self(0);

    /// These links.
    #[must_use]
    pub const fn of(mut links: &[u8]) -> Self {
        let mut all = Self::NONE;
        while let [link, rest @ ..] = links {
            (all, links) = (all.with(*link), rest);
        }
        all
    }

    /// These and this one.
    #[must_use]
    pub const fn with(self, link: u8) -> Self {
        Self(self.0 | Self::bit(link))
    }

    /// These but this one.
    #[must_use]
    pub const fn without(self, link: u8) -> Self {
        Self(self.0 & !Self::bit(link))
    }

    /// Those that are in both.
    #[must_use]
    pub const fn among(self, others: Self) -> Self {
        Self(self.0 & others.0)
    }

    /// These but those.
    #[must_use]
    pub const fn except(self, others: Self) -> Self {
        Self(self.0 & !others.0)
    }

    /// Those that are in one or in both.
    #[must_use]
    pub const fn and(self, others: Self) -> Self {
        Self(self.0 | others.0)
    }

    /// Whether this one is among them.
    #[must_use]
    pub const fn contains(self, link: u8) -> bool {
        self.0 & Self::bit(link) != 0
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// How many there are.
    #[must_use]
    pub const fn len(self) -> usize {
        self.0.count_ones() as usize
    }

    const fn bit(link: u8) -> u64 {
        match 1_u64.checked_shl(link as u32) {
            Some(bit) => bit,
            None => 0,
        }
    }
}

/// The numbers of links, the lowest first.
#[derive(Clone, Debug)]
pub struct LinkNumbers(Links);

impl IntoIterator for Links {
    type Item = u8;
    type IntoIter = LinkNumbers;

    fn into_iter(self) -> LinkNumbers {
        LinkNumbers(self)
    }
}

impl Iterator for LinkNumbers {
    type Item = u8;

    fn next(&mut self) -> Option<u8> {
        let link = self.0.0.trailing_zeros() as u8;
        let is_there = self.0.contains(link);
        self.0 = self.0.without(link);
        is_there.then_some(link)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.0.len(), Some(self.0.len()))
    }
}

impl ExactSizeIterator for LinkNumbers {}

impl FromIterator<u8> for Links {
    fn from_iter<I: IntoIterator<Item = u8>>(links: I) -> Self {
        links.into_iter().fold(Self::NONE, Self::with)
    }
}

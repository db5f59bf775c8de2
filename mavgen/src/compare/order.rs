//! What has moved in a sequence, as little as explains it.

/// The things that stand out of order: all that is not in the longest part whose new positions rise.
///
/// They are given in their old order. At most 255 fields are in a message.
pub(super) fn moved<T, P: Ord>(things: Vec<T>, position: impl Fn(&T) -> P) -> impl Iterator<Item = T> {
    // For each, how long the longest rising part is that ends there, and where it comes from.
    let mut best: Vec<(usize, Option<usize>)> = Vec::with_capacity(things.len());
    for (at, thing) in things.iter().enumerate() {
        let before = things.iter().zip(&best).enumerate().take(at);
        let lower = before.filter(|(_, (other, _))| position(other) < position(thing));
        let longest = lower.map(|(index, (_, (length, _)))| (*length, index)).max_by_key(|(length, _)| *length);
        best.push(longest.map_or((1, None), |(length, index)| (length + 1, Some(index))));
    }
    let mut kept = Vec::new();
    let mut next = best.iter().enumerate().max_by_key(|(_, (length, _))| *length).map(|(at, _)| at);
    while let Some(at) = next {
        kept.push(at);
        next = best.get(at).and_then(|(_, from)| *from);
    }
    things.into_iter().enumerate().filter(move |(at, _)| !kept.contains(at)).map(|(_, thing)| thing)
}

#[cfg(test)]
mod tests {
    /// The places of what has moved to these positions.
    fn moved(positions: &[usize]) -> Vec<usize> {
        super::moved(positions.iter().enumerate().collect(), |(_, position)| **position).map(|(at, _)| at).collect()
    }

    #[test]
    fn as_few_as_explain_it() {
        assert_eq!(moved(&[]), [0_usize; 0]);
        assert_eq!(moved(&[0, 1, 2, 3]), [0_usize; 0]);
        assert_eq!(moved(&[3, 0, 1, 2]), [0], "the first went to the end");
        assert_eq!(moved(&[1, 2, 3, 0]), [3], "the last went to the start");
        assert_eq!(moved(&[0, 2, 1, 3]).len(), 1, "two changed places");
        assert_eq!(moved(&[3, 2, 1, 0]).len(), 3);
    }
}

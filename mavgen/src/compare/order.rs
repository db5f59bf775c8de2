//! What has moved in a sequence, as little as explains it.

/// The places in `positions` of what stands out of order: all that is not in its longest rising part.
///
/// `positions` are the new places of things in their old order. At most 255 fields are in a message.
pub(super) fn moved(positions: &[usize]) -> Vec<usize> {
    // For each place, how long the longest rising part is that ends there, and where it comes from.
    let mut best: Vec<(usize, Option<usize>)> = Vec::with_capacity(positions.len());
    for (at, position) in positions.iter().enumerate() {
        let before = positions.iter().zip(&best).enumerate().take(at).filter(|(_, (other, _))| *other < position);
        let longest = before.map(|(index, (_, (length, _)))| (*length, index)).max_by_key(|(length, _)| *length);
        best.push(longest.map_or((1, None), |(length, index)| (length + 1, Some(index))));
    }
    let mut kept = vec![false; positions.len()];
    let mut next = best.iter().enumerate().max_by_key(|(_, (length, _))| *length).map(|(at, _)| at);
    while let Some(at) = next {
        if let Some(kept) = kept.get_mut(at) {
            *kept = true;
        }
        next = best.get(at).and_then(|(_, from)| *from);
    }
    kept.iter().enumerate().filter(|(_, kept)| !**kept).map(|(at, _)| at).collect()
}

#[cfg(test)]
mod tests {
    use super::moved;

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

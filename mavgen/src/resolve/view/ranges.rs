//! Sets of numbers as ranges: sorted, and apart.

use crate::collect::CollectVec as _;
use crate::order;
use std::ops::RangeInclusive;

/// Joins ranges that overlap or touch.
pub(super) fn joined(mut ranges: Vec<RangeInclusive<u64>>) -> Vec<RangeInclusive<u64>> {
    order::sort_by_key(&mut ranges, |range| (*range.start(), *range.end()));
    let mut joined: Vec<RangeInclusive<u64>> = Vec::new();
    for range in ranges {
        match joined.last_mut() {
            Some(last) if *range.start() <= last.end().saturating_add(1) => {
                *last = *last.start()..=(*last.end()).max(*range.end());
            }
            _ => joined.push(range),
        }
    }
    joined
}

/// What is not in joined ranges, of the numbers from 0 to `most`.
pub(super) fn complement(joined: &[RangeInclusive<u64>], most: u64) -> Vec<RangeInclusive<u64>> {
    let mut rest = Vec::new();
    let mut next = Some(0);
    for range in joined {
        if let Some(start) = next
            && let Some(end) = range.start().checked_sub(1).filter(|&end| end >= start)
        {
            rest.push(start..=end);
        }
        next = range.end().checked_add(1);
    }
    rest.extend(next.filter(|&start| start <= most).map(|start| start..=most));
    rest
}

/// `3`, `5 to 9` and so on, for a message.
pub(super) fn list(ranges: &[RangeInclusive<u64>]) -> String {
    let one = |range: &RangeInclusive<u64>| match (range.start(), range.end()) {
        (start, end) if start == end => start.to_string(),
        (start, end) => format!("{start} to {end}"),
    };
    ranges.iter().map(one).collect_vec().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_joined_and_inverted() {
        let all = joined(vec![30..=255, 3..=9, 5..=7, 10..=10]);
        assert_eq!(all, [3..=10, 30..=255]);
        assert_eq!(complement(&all, 255), [0..=2, 11..=29]);
        assert_eq!(complement(&[], 7), [0..=7]);
        assert_eq!(complement(&[0..=7], 7), []);
        assert_eq!(complement(&joined(vec![0..=u64::MAX, 4..=9]), u64::MAX), []);
        assert_eq!(complement(&[1..=u64::MAX], u64::MAX), [0..=0]);
        assert_eq!(list(&[0..=2, 4..=4]), "0 to 2, 4");
    }
}

//! Sorting, in little code: the standard library's stable sort is large, and whoever sorts a list of a type of his own compiles it
//! anew. A build script compiles all of this crate, so here it is compiled once, for places in a list.

use std::cmp::Ordering;

/// Sorts by a key; equal ones stay in their order.
pub(crate) fn sort_by_key<T, K: Ord>(list: &mut [T], key: impl Fn(&T) -> K) {
    let swaps = swaps(list.len(), &|a, b| match (list.get(a), list.get(b)) {
        (Some(a), Some(b)) => key(a).cmp(&key(b)),
        _ => Ordering::Equal,
    });
    for &(a, b) in &swaps {
        list.swap(a, b);
    }
}

/// Sorts, and leaves one of each.
pub(crate) fn sort_and_dedup<T: Ord + Clone>(list: &mut Vec<T>) {
    sort_by_key(list, T::clone);
    list.dedup();
}

/// The swaps, one after the other, that put a list of this length in order.
fn swaps(length: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<(usize, usize)> {
    // At each place: where the item that belongs there is.
    let mut order: Vec<usize> = (0..length).collect();
    order.sort_by(|&a, &b| compare(a, b));
    let mut swaps = Vec::new();
    for start in 0..length {
        let mut at = start;
        // Round the cycle: each swap puts one item where it belongs, the last one is there then.
        while let Some(from) = order.get_mut(at).map(|from| std::mem::replace(from, at))
            && from != at
            && from != start
        {
            swaps.push((at, from));
            at = from;
        }
    }
    swaps
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn as_the_standard_library_sorts(list: Vec<(u8, u16)>) {
            let mut list: Vec<(u8, u16)> = list.into_iter().map(|(key, rest)| (key % 8, rest)).collect();
            let mut expected = list.clone();
            expected.sort_by_key(|item| item.0);
            sort_by_key(&mut list, |item| item.0);
            prop_assert_eq!(&list, &expected);
            expected.sort();
            expected.dedup();
            sort_and_dedup(&mut list);
            prop_assert_eq!(list, expected);
        }
    }
}

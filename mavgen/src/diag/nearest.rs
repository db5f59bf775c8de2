//! "Did you mean": the candidate that a misspelled name was most likely meant to be.

/// Longer names get no suggestion: no real name is so long, and the search takes the square of the length.
const LONGEST: usize = 80;

/// The candidate that is fewest edits away from `name`, if it is near enough to be worth a suggestion.
///
/// An edit inserts, removes or replaces a character, or swaps two neighbours; letter case does not count. Of equally near
/// candidates the first is taken.
pub fn nearest<'c>(name: &str, candidates: impl IntoIterator<Item = &'c str>) -> Option<&'c str> {
    let mut search = Search { wanted: letters(name), best: None };
    if name.len() <= LONGEST {
        candidates.into_iter().for_each(|candidate| search.offer(candidate));
    }
    search.best.map(|(_, candidate)| candidate)
}

/// A search for the nearest: `nearest` is compiled for each kind of iterator, so what it does is here.
struct Search<'c> {
    wanted: Vec<char>,
    /// The best so far, and its distance.
    best: Option<(usize, &'c str)>,
}

impl<'c> Search<'c> {
    fn offer(&mut self, candidate: &'c str) {
        let (letters, allowed) = (letters(candidate), (self.wanted.len() / 3).clamp(1, 4));
        if self.wanted.len().abs_diff(letters.len()) <= allowed {
            let distance = edits(&self.wanted, &letters);
            if distance <= allowed && self.best.is_none_or(|(before, _)| distance < before) {
                self.best = Some((distance, candidate));
            }
        }
    }
}

fn letters(text: &str) -> Vec<char> {
    text.chars().flat_map(char::to_lowercase).collect()
}

/// The optimal string alignment distance.
fn edits(from: &[char], to: &[char]) -> usize {
    let mut before = vec![0; to.len() + 1];
    let mut above: Vec<usize> = (0..=to.len()).collect();
    for (row, &letter) in from.iter().enumerate() {
        let mut current = vec![row + 1];
        for (column, &other) in to.iter().enumerate() {
            let at = |line: &[usize], index: usize| line.get(index).copied().unwrap_or(usize::MAX);
            let replaced = at(&above, column) + usize::from(letter != other);
            let shifted = at(&above, column + 1).min(at(&current, column)) + 1;
            let neighbours = row.checked_sub(1).zip(column.checked_sub(1));
            let swapped = match neighbours.map(|(up, left)| (from.get(up), to.get(left), left)) {
                Some((Some(&up), Some(&left), index)) if up == other && left == letter => at(&before, index) + 1,
                _ => usize::MAX,
            };
            current.push(replaced.min(shifted).min(swapped));
        }
        before = std::mem::replace(&mut above, current);
    }
    above.last().copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn near_names_are_found_and_far_ones_are_not() {
        let known = ["name", "units", "minValue", "maxValue", "print_format"];
        for (name, expected) in [
            ("unit", Some("units")),
            ("untis", Some("units")),
            ("UNITS", Some("units")),
            ("minvalue", Some("minValue")),
            ("mixValue", Some("minValue")),
            ("printformat", Some("print_format")),
            ("nam", Some("name")),
            ("", None),
            ("x", None),
            ("value", None),
            ("description", None),
        ] {
            assert_eq!(nearest(name, known), expected, "{name}");
        }
    }

    #[test]
    fn edits_count_swaps_once() {
        let distance = |a: &str, b: &str| edits(&a.chars().collect::<Vec<_>>(), &b.chars().collect::<Vec<_>>());
        assert_eq!(distance("ab", "ba"), 1);
        assert_eq!(distance("kitten", "sitting"), 3);
        assert_eq!(distance("", "abc"), 3);
        assert_eq!(distance("abc", ""), 3);
    }
}

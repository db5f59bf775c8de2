//! Lists from iterators, in little code: a build script compiles all of this crate, and the standard library's `collect` is
//! compiled anew for every chain of iterators, with all its ways to guess and grow a length. A loop is a tenth of that.

/// Makes lists of what an iterator gives.
pub(crate) trait CollectVec: Iterator + Sized {
    /// All items.
    fn collect_vec(self) -> Vec<Self::Item> {
        let mut list = Vec::new();
        for item in self {
            list.push(item);
        }
        list
    }

    /// All items, or the first error.
    fn try_collect_vec<T, E>(self) -> Result<Vec<T>, E>
    where
        Self: Iterator<Item = Result<T, E>>,
    {
        let mut list = Vec::new();
        for item in self {
            list.push(item?);
        }
        Ok(list)
    }
}

impl<I: Iterator> CollectVec for I {}

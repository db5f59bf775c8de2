//! Machines that end.

use crate::Service;

/// One operation of a station: a [`Service`] that ends, with or without success.
///
/// It reports its end once. Then [`poll`](Service::poll) returns `None`, and there is no [`deadline`](Service::deadline). To give up
/// earlier, drop it.
pub trait Operation: Service<Event = Update<Self::Progress, Self::Outcome, Self::Failure>> {
    /// What it reports before its end.
    type Progress;

    /// The result if it succeeds.
    type Outcome;

    /// The reason if it fails.
    type Failure;
}

/// Every machine with these events is one.
impl<P, T, F, S: Service<Event = Update<P, T, F>>> Operation for S {
    type Progress = P;
    type Outcome = T;
    type Failure = F;
}

/// The events of an [`Operation`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Update<P, T, F> {
    /// Progress; the operation goes on.
    Progress(P),
    /// It has ended.
    Done(Result<T, F>),
}

impl<P, T, F> Update<P, T, F> {
    /// The end, if this is it.
    #[must_use]
    pub fn done(self) -> Option<Result<T, F>> {
        match self {
            Self::Progress(_) => None,
            Self::Done(result) => Some(result),
        }
    }
}

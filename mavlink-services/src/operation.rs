//! Machines that end.

use crate::Service;

/// What a station asks for, from the question to its end: a [`Service`] that is done one day, with or without success.
///
/// Its end is told once. After it, [`poll`](Service::poll) gives nothing, and there is no [`deadline`](Service::deadline). To give
/// up earlier, drop it.
pub trait Operation: Service<Event = Update<Self::Progress, Self::Outcome, Self::Failure>> {
    /// What is told on the way.
    type Progress;

    /// What it is for.
    type Outcome;

    /// Why it can fail.
    type Failure;
}

/// The events of an [`Operation`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Update<P, T, F> {
    /// It goes on, and this came.
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

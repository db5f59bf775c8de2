//! What is the same of every writer of frames, whatever it writes to.

/// A `FrameWriter`.
macro_rules! frame_writer {
    () => {
        /// Writes frames to `W`, each by one call if the link takes it whole.
        #[derive(Clone, Debug)]
        pub struct FrameWriter<W> {
            inner: W,
            outgoing: Outgoing,
        }

        impl<W> FrameWriter<W> {
            /// A writer of what this sender makes.
            #[must_use]
            pub const fn new(inner: W, sender: Sender) -> Self {
                Self { inner, outgoing: Outgoing::new(sender) }
            }

            /// Whether a part of the last frame is not written yet.
            #[must_use]
            pub fn is_pending(&self) -> bool {
                !self.outgoing.pending().is_empty()
            }

            /// What makes the frames.
            pub fn sender(&mut self) -> &mut Sender {
                &mut self.outgoing.sender
            }

            /// What is written to.
            #[must_use]
            pub const fn get_ref(&self) -> &W {
                &self.inner
            }

            /// What is written to. What else is written to it must not come between the parts of a frame.
            pub fn get_mut(&mut self) -> &mut W {
                &mut self.inner
            }

            /// What was written to. What is left of the last frame is lost.
            pub fn into_inner(self) -> W {
                self.inner
            }
        }
    };
}

pub(super) use frame_writer;

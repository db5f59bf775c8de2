//! What is the same of every reader of frames, whatever it reads from.

/// A `FrameReader` that reads so many bytes at once if nothing else is said.
macro_rules! frame_reader {
    ($size:literal) => {
        #[doc = concat!("Reads frames from `R`, which needs no buffer of its own: up to `N` bytes are read at once, ", $size, " if you do not say.")]
        #[derive(Clone, Debug)]
        pub struct FrameReader<'t, R, const N: usize = $size> {
            inner: R,
            incoming: Incoming<'t, [u8; N]>,
        }

        impl<'t, R> FrameReader<'t, R> {
            #[doc = concat!("A reader of ", $size, " bytes at once that verifies the messages of this table, and hands over others unverified.")]
            #[must_use]
            pub const fn new(inner: R, table: &'t Table<'t>) -> Self {
                Self::with_read_size(inner, table)
            }
        }

        impl<'t, R, const N: usize> FrameReader<'t, R, N> {
            /// A reader of up to `N` bytes at once.
            #[must_use]
            pub const fn with_read_size(inner: R, table: &'t Table<'t>) -> Self {
                Self { inner, incoming: Incoming::new(table) }
            }

            /// What was found so far, and what could not be read.
            #[must_use]
            pub fn statistics(&self) -> Statistics {
                self.incoming.statistics()
            }

            /// The frames that there are without reading more, for a link that pauses: call it until it gives `None`. An
            /// unfinished frame is given up, and what came behind it is searched: see
            /// [`Parser::finish`](crate::Parser::finish).
            pub fn finish(&mut self) -> Option<Frame<'_>> {
                self.finish_reporting_bad_checksums(not_told)
            }

            /// The frames that there are without reading more, as [`finish`](Self::finish) gives them. `bad_checksum` is told
            /// the message of each frame that [`Statistics::bad_checksums`] counts.
            pub fn finish_reporting_bad_checksums(&mut self, mut bad_checksum: impl FnMut(u32)) -> Option<Frame<'_>> {
                let found = self.incoming.finish(&mut bad_checksum)?;
                Some(self.incoming.frame(&found))
            }

            /// What is read from.
            #[must_use]
            pub const fn get_ref(&self) -> &R {
                &self.inner
            }

            /// What is read from. Bytes that are taken out of it are missing here.
            pub fn get_mut(&mut self) -> &mut R {
                &mut self.inner
            }

            /// What was read from. Bytes that were read, and are no frame yet, are lost.
            pub fn into_inner(self) -> R {
                self.inner
            }
        }
    };
}

pub(super) use frame_reader;

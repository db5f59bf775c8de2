//! An enum over topics, as a package of messages has it: what a log is read as that is not about one topic alone.

use super::Topic;
use super::ulog::Binding;

/// An enum over the topics of a package, made by `mavgen`: `Px4`. [`topics!`](crate::topics!) implements it.
pub trait Topics: Copy + 'static {
    /// How the records of a log are read, for each topic that was met.
    #[doc(hidden)]
    type Bindings: 'static;

    /// Nothing is bound.
    #[doc(hidden)]
    const UNBOUND: Self::Bindings;

    /// Binds the topic of this name; `None` if the enum does not have it.
    #[doc(hidden)]
    fn bind<'a>(
        bindings: &mut Self::Bindings,
        topic: &str,
        formats: &dyn Fn(&str) -> Option<&'a str>,
    ) -> Option<Reader<Self>>;

    /// The name of the message, `EscStatus`.
    fn name(&self) -> &'static str;
}

/// How the records of a topic are read as an enum.
#[doc(hidden)]
pub struct Reader<T: Topics> {
    pub(super) topic: &'static str,
    /// Which of the topics of its message it is.
    at: usize,
    read: fn(&T::Bindings, usize, &[u8]) -> Option<T>,
}

/// What came of binding a topic: `None` if the log has no format of it.
#[doc(hidden)]
pub type Bound<M> = Option<Binding<M>>;

impl<T: Topics> Clone for Reader<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Topics> Copy for Reader<T> {}

impl<T: Topics> Reader<T> {
    /// Of a message that is carried by these topics, if this is one of them. `bound` has a place for each.
    ///
    /// A topic without a format is remembered, too: a hostile log may subscribe to it again and again, and every search of the
    /// formats takes time.
    pub fn bind<'a, M: Topic>(
        bound: &mut [Option<Bound<M>>],
        topic: &str,
        formats: &dyn Fn(&str) -> Option<&'a str>,
        read: fn(&T::Bindings, usize, &[u8]) -> Option<T>,
    ) -> Option<Self> {
        let at = M::TOPICS.iter().position(|own| *own == topic)?;
        bound.get_mut(at)?.get_or_insert_with(|| Binding::of(topic, formats));
        Some(Self { topic: M::TOPICS.get(at)?, at, read })
    }

    pub(super) fn read(&self, bindings: &T::Bindings, record: &[u8]) -> Option<T> {
        (self.read)(bindings, self.at, record)
    }
}

/// Completes an enum over topics, whose variants have the names of the types in them: [`Topics`](crate::uorb::Topics), `From` each
/// message, `TryFrom` back (the error is the enum, unchanged), and what the optional features add.
///
/// `topics!(Px4 { EscStatus, VehicleStatus })`
#[macro_export]
macro_rules! topics {
    ($name:ident { $($topic:ident),* $(,)? }) => {
        const _: () = {
            /// The bindings of each topic of each message.
            #[allow(non_snake_case, reason = "fields are named as the variants")]
            pub struct __Bindings {
                $($topic: [::core::option::Option<$crate::generated::Bound<$topic>>; <$topic as $crate::uorb::Topic>::TOPICS.len()],)*
            }

            impl $crate::uorb::Topics for $name {
                type Bindings = __Bindings;

                const UNBOUND: __Bindings = __Bindings {
                    $($topic: [::core::option::Option::None; <$topic as $crate::uorb::Topic>::TOPICS.len()],)*
                };

                fn bind<'a>(
                    bindings: &mut __Bindings,
                    topic: &str,
                    formats: &dyn ::core::ops::Fn(&str) -> ::core::option::Option<&'a str>,
                ) -> ::core::option::Option<$crate::generated::Reader<Self>> {
                    $(
                        let read = |bindings: &__Bindings, at: usize, record: &[u8]| {
                            let binding: &$crate::uorb::ulog::Binding<$topic> = bindings.$topic.get(at)?.as_ref()?.as_ref()?;
                            binding.read(record).map(Self::$topic)
                        };
                        let reader = $crate::generated::Reader::bind(&mut bindings.$topic, topic, formats, read);
                        if reader.is_some() {
                            return reader;
                        }
                    )*
                    ::core::option::Option::None
                }

                fn name(&self) -> &'static str {
                    match self {
                        $(Self::$topic(_) => <$topic as $crate::uorb::Topic>::NAME,)*
                    }
                }
            }
        };

        $(
            impl ::core::convert::From<$topic> for $name {
                #[inline]
                fn from(topic: $topic) -> Self {
                    Self::$topic(topic)
                }
            }

            impl ::core::convert::TryFrom<$name> for $topic {
                type Error = $name;

                #[inline]
                fn try_from(topic: $name) -> ::core::result::Result<Self, $name> {
                    match topic {
                        $name::$topic(topic) => ::core::result::Result::Ok(topic),
                        #[allow(unreachable_patterns, reason = "the enum may have no other")]
                        other => ::core::result::Result::Err(other),
                    }
                }
            }
        )*

        $crate::__serde_topics!($name { $($topic),* });
        $crate::__defmt_topics!($name { $($topic),* });
        $crate::__arbitrary_topics!($name { $($topic),* });
    };
}

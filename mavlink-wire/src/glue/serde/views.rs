//! Messages with their views: what overlays see in the fields, beside the fields.

use serde_core::Serialize;
use serde_core::ser::{Error, SerializeMap, SerializeStruct, Serializer};

use super::dialect::TAG;
use super::field::key;
use super::message::Body;
use crate::message::record::plain_name;
use crate::{Encode, FieldInfo, MAX_PAYLOAD};

/// The key of the views.
const VIEWS: &str = "views";

/// A message, or a dialect's enum, and in human readable formats what overlays see in it.
///
/// The object `views` stands behind the fields; it is empty for a message that has none. By the name of its getter it has each
/// enum that is bound to a field, each view, and a list for the slots; what is there only under a condition is left out where
/// that does not hold. In other formats this is the message by itself. Read it as the message.
///
/// ```
/// # mod acme {
/// #     use mavlink_wire as wire;
/// #     #[derive(Clone, Copy, PartialEq)]
/// #     pub struct Sonar { pub distance: u8 }
/// #     impl wire::Message for Sonar {
/// #         type Payload = [u8; 1];
/// #         const INFO: &'static wire::MessageInfo = &wire::MessageInfo::new(4711, "SONAR", 113, 1);
/// #         const FIELDS: &'static [wire::FieldInfo] = &[wire::FieldInfo::new("distance", wire::Kind::U8, 0)];
/// #         const DEFAULT: Self = Self { distance: 0 };
/// #         fn read(p: &[u8; 1]) -> Self { Self { distance: p[0] } }
/// #         fn store(&self, p: &mut [u8; 1]) { p[0] = self.distance; }
/// #     }
/// #     impl Sonar {
/// #         pub fn near(&self) -> bool { self.distance < 10 }
/// #     }
/// #     wire::message!(Sonar { one near });
/// # }
/// use mavlink_wire::serde::WithViews;
///
/// let sonar = acme::Sonar { distance: 5 };
/// let text = serde_json::to_string(&WithViews(&sonar))?;
/// assert_eq!(text, r#"{"distance":5,"views":{"near":true}}"#);
/// assert_eq!(serde_json::from_str::<acme::Sonar>(&text)?, sonar);
/// # Ok::<(), serde_json::Error>(())
/// ```
///
/// # Errors
///
/// A message that has a field `views` is not written.
#[derive(Clone, Copy, Debug)]
pub struct WithViews<'m, M>(pub &'m M);

/// A message, or a dialect's enum, that [`WithViews`] writes: the macros of this crate implement it.
pub trait HasViews: Encode + Serialize {
    /// The name of a dialect's enum, which also writes the name of the message.
    #[doc(hidden)]
    const DIALECT: Option<&'static str>;

    /// The fields of the message, in the order of the XML.
    #[doc(hidden)]
    fn fields(&self) -> &'static [FieldInfo];

    /// Writes every view; the message has none, unless it says which.
    ///
    /// # Errors
    ///
    /// Those of the serializer.
    #[doc(hidden)]
    fn views<S: SerializeMap>(&self, _views: &mut Views<'_, S>) -> Result<(), S::Error> {
        Ok(())
    }
}

impl<M: HasViews> Serialize for WithViews<'_, M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(message) = self;
        if !serializer.is_human_readable() {
            return message.serialize(serializer);
        }
        let (info, infos) = (message.info(), message.fields());
        if infos.iter().any(|field| key(field) == VIEWS) {
            return Err(S::Error::custom(format_args!("{} has a field `{VIEWS}`: no place for its views", info.name)));
        }
        let mut payload = [0; MAX_PAYLOAD];
        message.write(&mut payload);
        let body = Body { info, fields: infos, payload: &payload };
        let tag = usize::from(M::DIALECT.is_some());
        let mut fields = serializer.serialize_struct(M::DIALECT.unwrap_or(info.name), tag + infos.len() + 1)?;
        if M::DIALECT.is_some() {
            fields.serialize_field(TAG, info.name)?;
        }
        body.serialize_fields(&mut fields)?;
        fields.serialize_field(VIEWS, &Object(*message))?;
        fields.end()
    }
}

/// The views of a message.
struct Object<'m, M>(&'m M);

impl<M: HasViews> Serialize for Object<'_, M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        self.0.views(&mut Views(&mut map))?;
        map.end()
    }
}

/// Takes the views of a message, each by what its getter gives.
#[derive(Debug)]
pub struct Views<'s, S>(&'s mut S);

impl<S: SerializeMap> Views<'_, S> {
    /// Of a getter that always gives something, be it that nothing is known.
    ///
    /// # Errors
    ///
    /// Those of the serializer, as in all of these.
    pub fn one<T: Serialize>(&mut self, name: &'static str, get: impl Fn() -> T) -> Result<(), S::Error> {
        self.0.serialize_entry(plain_name(name), &get())
    }

    /// Of a getter that gives nothing where a condition does not hold.
    pub fn maybe<T: Serialize>(&mut self, name: &'static str, get: impl Fn() -> Option<T>) -> Result<(), S::Error> {
        get().map_or(Ok(()), |view| self.0.serialize_entry(plain_name(name), &view))
    }

    /// Of a getter that gives all slots in use.
    pub fn each<I>(&mut self, name: &'static str, get: impl Fn() -> I) -> Result<(), S::Error>
    where
        I: Iterator<Item: Serialize>,
    {
        self.0.serialize_entry(plain_name(name), &List(get))
    }
}

/// What a getter iterates over.
struct List<F>(F);

impl<I: Iterator<Item: Serialize>, F: Fn() -> I> Serialize for List<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq((self.0)())
    }
}

/// Implements [`HasViews`] for a message with these getters.
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_message_views {
    ($name:ident { $($kind:ident $getter:ident),* }) => {
        impl $crate::generated::serde::HasViews for $name {
            const DIALECT: ::core::option::Option<&'static str> = ::core::option::Option::None;

            fn fields(&self) -> &'static [$crate::FieldInfo] {
                <Self as $crate::Message>::FIELDS
            }

            $crate::__serde_message_views!(@views $($kind $getter),*);
        }
    };
    (@views) => {};
    (@views $($kind:ident $getter:ident),+) => {
        fn views<S: $crate::generated::serde::SerializeMap>(
            &self,
            views: &mut $crate::generated::serde::Views<'_, S>,
        ) -> ::core::result::Result<(), S::Error> {
            $(views.$kind(::core::stringify!($getter), || self.$getter())?;)+
            ::core::result::Result::Ok(())
        }
    };
}

/// Implements [`HasViews`] for a dialect's enum of these messages.
#[doc(hidden)]
#[macro_export]
macro_rules! __serde_dialect_views {
    ($dialect:ident { $($message:ident)* }) => {
        impl $crate::generated::serde::HasViews for $dialect {
            const DIALECT: ::core::option::Option<&'static str> =
                ::core::option::Option::Some(::core::stringify!($dialect));

            fn fields(&self) -> &'static [$crate::FieldInfo] {
                match self {
                    $(Self::$message(_) => <$message as $crate::Message>::FIELDS,)*
                }
            }

            fn views<S: $crate::generated::serde::SerializeMap>(
                &self,
                views: &mut $crate::generated::serde::Views<'_, S>,
            ) -> ::core::result::Result<(), S::Error> {
                match self {
                    $(Self::$message(message) => $crate::generated::serde::HasViews::views(message, views),)*
                }
            }
        }
    };
}

//! Structs of named fields, by hand: what a derive makes, without its compile time.

use core::marker::PhantomData;

/// Implements both traits for a struct, whose fields have these names and types. Fields that it does not have are ignored.
macro_rules! record {
    ($name:ident $(<$generic:ident>)? { $($field:ident: $type:ty),+ $(,)? }) => {
        impl $(<$generic: Serialize>)? Serialize for $name $(<$generic>)? {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                let fields = [$(stringify!($field)),+].len();
                let mut record = serializer.serialize_struct(stringify!($name), fields)?;
                $(record.serialize_field(stringify!($field), &self.$field)?;)+
                record.end()
            }
        }

        impl<'de $(, $generic: Deserialize<'de>)?> Deserialize<'de> for $name $(<$generic>)? {
            fn deserialize<De: Deserializer<'de>>(deserializer: De) -> Result<Self, De::Error> {
                const FIELDS: &[&str] = &[$(stringify!($field)),+];
                deserializer.deserialize_struct(stringify!($name), FIELDS, Record::<Self>::of(FIELDS))
            }
        }

        impl<'de $(, $generic: Deserialize<'de>)?> Visitor<'de> for Record<$name $(<$generic>)?> {
            type Value = $name $(<$generic>)?;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(concat!("struct ", stringify!($name)))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut values: A) -> Result<Self::Value, A::Error> {
                $(let $field: $type = values.next_element()?.ok_or_else(|| A::Error::missing_field(stringify!($field)))?;)+
                Ok($name { $($field),+ })
            }

            fn visit_map<A: MapAccess<'de>>(self, mut values: A) -> Result<Self::Value, A::Error> {
                $(let mut $field: Option<$type> = None;)+
                while let Some(key) = values.next_key_seed(Name(self.fields()))? {
                    $(if key == Some(stringify!($field)) {
                        $field = Some(values.next_value()?);
                        continue;
                    })+
                    values.next_value::<IgnoredAny>()?;
                }
                Ok($name { $($field: $field.ok_or_else(|| A::Error::missing_field(stringify!($field)))?),+ })
            }
        }
    };
}
pub(super) use record;

/// What reads a struct.
pub(super) struct Record<T> {
    fields: &'static [&'static str],
    of: PhantomData<T>,
}

impl<T> Record<T> {
    pub(super) const fn of(fields: &'static [&'static str]) -> Self {
        Self { fields, of: PhantomData }
    }

    pub(super) const fn fields(&self) -> &'static [&'static str] {
        self.fields
    }
}

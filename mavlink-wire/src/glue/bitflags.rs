//! The trait of the crate `bitflags` for flags types (feature `bitflags`), for code that works on any.

/// Implements `bitflags::Flags`.
#[doc(hidden)]
#[macro_export]
macro_rules! __bitflags {
    ($name:ident, $repr:ident, $info:path) => {
        impl $crate::generated::bitflags::Flags for $name {
            const FLAGS: &'static [$crate::generated::bitflags::Flag<Self>] = &{
                let mut flags = [const { $crate::generated::bitflags::Flag::new("", $name(0)) }; $info.entries.len()];
                let mut places: &mut [$crate::generated::bitflags::Flag<Self>] = &mut flags;
                let mut entries = $info.entries;
                while let ([place, more @ ..], [(bits, name), rest @ ..]) = (places, entries) {
                    *place = $crate::generated::bitflags::Flag::new(name, Self(*bits as $repr));
                    (places, entries) = (more, rest);
                }
                flags
            };

            type Bits = $repr;

            fn bits(&self) -> $repr {
                self.0
            }

            fn from_bits_retain(bits: $repr) -> Self {
                Self(bits)
            }
        }
    };
}

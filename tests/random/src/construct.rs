//! What a case can have in it.

macro_rules! constructs {
    ($($(#[$doc:meta])* $name:ident,)*) => {
        /// Something that a dialect or an overlay can say, worth a test of its own.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[non_exhaustive]
        pub enum Construct { $($(#[$doc])* $name,)* }

        impl Construct {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];
        }
    };
}

constructs! {
    // Files.
    /// A dialect that includes another.
    Include,
    /// Two dialects in one tree.
    SeveralRoots,
    /// A message that two roots define alike, or not.
    MessageOfBothRoots,
    /// An enum of one file with entries of another.
    ExtendedEnum,
    // Names.
    /// A message called like something that generated code or its readers rely on.
    OddMessageName,
    /// An enum called so.
    OddEnumName,
    /// A field called so, or by a keyword.
    OddFieldName,
    /// An entry called so.
    OddEntryName,
    /// A view or an item called so.
    OddViewName,
    /// Bits, a key, a binding, an item or an iterator called like a method.
    OddGetterName,
    /// A slot's item called so that its helpers have the name of a field's accessor.
    StoreCollision,
    // Enums.
    /// Values that are combined bit by bit.
    Bitmask,
    /// An enum whose fields are signed.
    SignedEnum,
    /// A field narrower, wider or of another sign than its enum.
    ConvertedEnum,
    /// An enum wider than any field that carries it.
    WideEnum,
    /// An enum that no field carries.
    UnusedEnum,
    /// A deprecated enum.
    DeprecatedEnum,
    /// A deprecated entry.
    DeprecatedEntry,
    /// An entry without a value.
    AutomaticValue,
    /// Commands with their params.
    Command,
    /// A command called like what carries it, or like something else.
    OddCommand,
    /// A command with a place.
    Location,
    /// A label that is no name, or that of another param.
    OddLabel,
    /// `COMMAND_LONG`.
    CommandLong,
    /// `COMMAND_INT`.
    CommandInt,
    /// A command in an overlay.
    NamedParam,
    // Messages.
    /// An array of an enum.
    EnumArray,
    /// A string.
    Text,
    /// Fields that MAVLink 1 does not send.
    Extensions,
    /// `invalid` on a number.
    InvalidNumber,
    /// `invalid` on a float.
    InvalidNan,
    /// `invalid` on an enum.
    InvalidEnum,
    /// `invalid` on an array.
    InvalidArray,
    /// `target_system` and `target_component`.
    Targets,
    /// `uint8_t_mavlink_version`.
    Version,
    /// A deprecated message.
    DeprecatedMessage,
    // Overlays.
    /// `<refine>`.
    Refine,
    /// `<note>`.
    Note,
    /// `<bind>`.
    Bind,
    /// `<bind>` with a condition.
    BindIf,
    /// `<bind>` of a deprecated enum.
    BindDeprecated,
    /// `<bind>` of a bitmask, or of a signed enum.
    BindFlags,
    /// An enum of the overlay.
    OverlayEnum,
    // Views.
    /// A view over scalars.
    ViewOnce,
    /// A view over several words.
    ViewWords,
    /// A view over an array joined.
    ViewJoined,
    /// A view on a condition.
    ViewIf,
    /// A view over slots.
    ViewSlots,
    /// A view of more than 64 bits.
    ViewWide,
    /// A word that carries an enum.
    EnumWord,
    /// A word that is a float.
    FloatWord,
    /// Two views of one message.
    TwoViews,
    /// `partial`.
    Partial,
    /// `count`.
    Count,
    /// A count that carries an enum.
    EnumCount,
    /// `<key>`.
    Key,
    /// A key that carries an enum.
    EnumKey,
    /// A key with a sentinel.
    KeyInvalid,
    /// A key with a unit.
    KeyUnits,
    /// A key that is a float.
    KeyFloat,
    /// A view of values.
    Values,
    /// A view of values on a condition.
    ValuesIf,
    /// A sentinel of a field.
    ViewInvalid,
    /// A sentinel of a field that carries an enum.
    ViewInvalidEnum,
    /// A sentinel of the joined words.
    ViewInvalidWords,
    // Bits.
    /// One bit.
    Flag,
    /// A plain number.
    Number,
    /// A number of more than 64 bits.
    WideNumber,
    /// `signed`.
    Signed,
    /// `units`.
    Units,
    /// Bits that carry an enum.
    EnumBits,
    /// Bits that carry a bitmask.
    FlagsBits,
    /// Bits that carry a deprecated enum.
    DeprecatedBits,
    /// `scale` or `bias`.
    Scale,
    /// A negative scale.
    NegativeScale,
    /// `exact`.
    Exact,
    /// `scale` on signed bits.
    SignedScale,
    /// `repeat`.
    Repeat,
    /// `repeat` of scaled numbers, enums or flags.
    RepeatMeaning,
    /// `stride`.
    Stride,
    // Switches.
    /// A switch on a field.
    SwitchField,
    /// A switch on the element of an array.
    SwitchElement,
    /// A switch on a field that carries an enum.
    SwitchEnum,
    /// A switch on bits.
    SwitchBits,
    /// A switch on bits that carry an enum.
    SwitchEnumBits,
    /// `<default>`.
    Default,
    /// Bits of one name and place in every case.
    SharedByAll,
    /// Bits of one name and place in some cases.
    SharedBySome,
}

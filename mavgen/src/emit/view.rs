//! A view: a small type over packed bits, with getters, setters, a `Debug` with units, and how a message gives it.
//!
//! ```text
//! /// Status of an ESC.
//! #[derive(Clone, Copy, PartialEq, Eq, Hash)]
//! pub struct EscStatus {
//!     bits: u64,
//!     data_version: u8,
//! }
//!
//! impl EscStatus {
//!     /// The view of these bits, …
//!     pub const fn from_bits(bits: u64, data_version: u8) -> Self {
//!         Self { bits, data_version }
//!     }
//!     …
//!     /// Speed. In rpm.
//!     pub const fn rpm(self) -> u16 {
//!         ((self.bits >> 29) & 0x7fff) as u16
//!     }
//! }
//! ```

mod access;
mod bits;
mod debug;
mod member;
mod scaled;
mod slots;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::docs::prose_with;
use crate::emit::token::{ident, repr};
use crate::emit::{Context, doc};
use crate::ir::{Access, Meaning, Member, Message, Presence, Switch, SwitchOn, View};

pub(crate) use access::bindings;

/// The items of a view's file.
pub(crate) fn view(context: &Context<'_>, message: &Message, view: &View) -> TokenStream {
    let imports = imports(context, message, view);
    let declaration = declaration(context, message, view);
    let construction = construction(view);
    let members = view.members.iter().map(|one| member::member(context, view, one));
    let debug = debug::debug(view);
    let access = match &view.access {
        Access::Once { getter } => access::once(context, message, view, &getter.rust()),
        Access::Slots(parts) => slots::slots(context, message, view, parts),
    };
    let name = ident(&view.name.rust);
    quote! {
        #imports
        #declaration
        impl #name {
            #construction
            #(#members)*
        }
        #debug
        #access
    }
}

/// What the overlay says of the view, or where it comes from.
fn summary(view: &View) -> TokenStream {
    let description = prose_with(&view.origin.description, Vec::new());
    let fallback = vec![format!("The [`{}`] in the fields.", view.name.rust)];
    doc::attributes(if view.origin.description.trim().is_empty() { &fallback } else { &description })
}

/// The integer that holds the bits.
fn storage(view: &View) -> Ident {
    ident(match view.width {
        0..=8 => "u8",
        9..=16 => "u16",
        17..=32 => "u32",
        33..=64 => "u64",
        _ => "u128",
    })
}

/// Enums that the file names, its message, and the runtime.
fn imports(context: &Context<'_>, message: &Message, view: &View) -> TokenStream {
    let members = view.members.iter().filter_map(|member| match member.meaning {
        Meaning::Values(id) => Some(id),
        _ => None,
    });
    let fields = access::named_enums(message, view);
    let enums = context.use_enums(members.chain(fields));
    let (message, runtime) = (context.use_message(message), context.use_runtime());
    quote!(#enums #message #runtime)
}

fn declaration(context: &Context<'_>, message: &Message, view: &View) -> TokenStream {
    let docs = doc::attributes(&documentation(context, message, view));
    let (name, storage) = (ident(&view.name.rust), storage(view));
    let switch = switch_field(view).map(|(name, ty)| quote!(#name: #ty,));
    quote! {
        #docs
        #[derive(Clone, Copy, PartialEq, Eq, Hash)]
        pub struct #name { bits: #storage, #switch }
    }
}

/// Name and type of the switch value that the view carries along.
fn switch_field(view: &View) -> Option<(Ident, Ident)> {
    match view.switch.as_ref()? {
        Switch { name, on: SwitchOn::Field(_, int), .. } => Some((ident(&name.rust()), repr(*int))),
        Switch { on: SwitchOn::Bits { .. }, .. } => None,
    }
}

/// `from_bits`, `bits`, and the switch value.
fn construction(view: &View) -> TokenStream {
    let storage = storage(view);
    let (parameter, field, getter) = match switch_field(view) {
        Some((name, ty)) => {
            let docs = doc::attributes(&[format!("The `{name}` that says how the bits are laid out.")]);
            let getter = quote!(#docs pub const fn #name(self) -> #ty { self.#name });
            (quote!(, #name: #ty), quote!(, #name), getter)
        }
        None => (quote!(), quote!(), quote!()),
    };
    quote! {
        /// The view of these bits.
        pub const fn from_bits(bits: #storage #parameter) -> Self {
            Self { bits #field }
        }
        /// The bits, as the message carries them.
        pub const fn bits(self) -> #storage {
            self.bits
        }
        #getter
    }
}

/// The description, where the bits are found, and a table of them.
fn documentation(context: &Context<'_>, message: &Message, view: &View) -> Vec<String> {
    let file = context.dialect.file(view.origin.file).map_or("", |file| file.name.as_str());
    let fields: Vec<String> = access::word_names(message, view).iter().map(|name| format!("`{name}`")).collect();
    let facts = format!(
        "`{}` of `{file}`: {} bits in {} of [`{}`], the least significant first.",
        view.name.text,
        view.width,
        fields.join(", "),
        message.name.rust
    );
    let rows: Vec<_> = view.members.iter().map(|member| row(context, view, member)).collect();
    let table = doc::table(["bits", "name", "meaning", "only if"], &rows);
    doc::join([prose_with(&view.origin.description, Vec::new()), vec![facts], table])
}

/// `|  29..=43 | `rpm` | rpm | |`
fn row(context: &Context<'_>, view: &View, member: &Member) -> [String; 4] {
    let last = member.at + member.width - 1;
    let bits = if member.width == 1 { member.at.to_string() } else { format!("{}..={last}", member.at) };
    let bits =
        member.repeat.map_or(bits.clone(), |repeat| format!("{bits}, {} times, {} apart", repeat.count, repeat.stride));
    let meaning = match &member.meaning {
        Meaning::Flag => "yes or no".to_owned(),
        Meaning::Values(id) => {
            context.dialect.enum_by_id(*id).map(|values| format!("[`{}`]", values.name.rust)).unwrap_or_default()
        }
        Meaning::Number { units } => units.clone().unwrap_or_else(|| "number".to_owned()),
        Meaning::Scaled(scaled) => format!("{scaled} {}", scaled.units.as_deref().unwrap_or_default()),
    };
    [bits, format!("`{}`", member.name), meaning.trim_end().to_owned(), condition(view, member)]
}

/// `data_version` 3..=9, 30..=255
fn condition(view: &View, member: &Member) -> String {
    let (Presence::When(ranges), Some(switch)) = (&member.presence, &view.switch) else { return String::new() };
    let ranges: Vec<String> = ranges.iter().map(bits::range_text).collect();
    format!("`{}` {}", switch.name, ranges.join(", "))
}

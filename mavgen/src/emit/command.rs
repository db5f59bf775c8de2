//! Commands: the parameters of `MAV_CMD` entries, as documentation and as metadata.
//!
//! ```text
//! impl MavCmd {
//!     /// What is known of the command's parameters, by index: those left out are reserved, or have nothing but a description.
//!     pub fn params(self) -> &'static [wire::ParamInfo] {
//!         …
//!     }
//! }
//!
//! static PARAMS: [(u16, &[wire::ParamInfo]); 1] =
//!     [(16, &[wire::ParamInfo::new(1).label("Hold").units("s").min(0.0)])];
//! ```

use proc_macro2::TokenStream;
use quote::quote;

use crate::docs::{line, words, wrap};
use crate::emit::token::{decimal, float, ident, repr};
use crate::emit::{Context, doc};
use crate::ir::{Command, Entry, Enum, Param};
use crate::lower::docs;

/// The metadata of an enum's commands; nothing if it has none.
pub(crate) fn params(context: &Context<'_>, values: &Enum) -> TokenStream {
    // Of several names for one value, which only several dialects together can have, the first speaks.
    let firsts = values.entries.chunk_by(|a, b| a.value == b.value).filter_map(<[Entry]>::first);
    let rows: Vec<TokenStream> = firsts.filter_map(|entry| row(context, entry)).collect();
    if rows.is_empty() {
        return TokenStream::new();
    }
    let (name, int, count) = (ident(&values.name.rust), repr(values.repr), decimal(rows.len() as u64));
    quote! {
        impl #name {
            /// What is known of the command's parameters, by index: those left out are reserved, or have nothing but a description.
            pub fn params(self) -> &'static [wire::ParamInfo] {
                let found = PARAMS.binary_search_by_key(&self.0, |&(command, _)| command);
                found.ok().and_then(|at| PARAMS.get(at)).map_or(&[], |&(_, params)| params)
            }
        }
        static PARAMS: [(#int, &[wire::ParamInfo]); #count] = [#(#rows),*];
    }
}

fn row(context: &Context<'_>, entry: &Entry) -> Option<TokenStream> {
    let infos: Vec<TokenStream> =
        entry.command.as_ref()?.params.iter().filter_map(|param| info(context, param)).collect();
    let value = decimal(entry.value);
    (!infos.is_empty()).then(|| quote!((#value, &[#(#infos),*])))
}

/// `wire::ParamInfo::new(1).label("Hold").units("s").min(0.0)`; nothing where nothing is known.
fn info(context: &Context<'_>, param: &Param) -> Option<TokenStream> {
    let index = decimal(param.index);
    let label = param.label.as_ref().map(|label| quote!(.label(#label)));
    let units = param.units.as_ref().map(|units| quote!(.units(#units)));
    let values = enum_of(context, param).map(|values| {
        let name = &values.name.text;
        quote!(.values(#name))
    });
    let number = |name: &str, value: Option<f64>| {
        let (name, value) = (ident(name), float(value?));
        Some(quote!(.#name(#value)))
    };
    let min = number("min", param.limits.min);
    let max = number("max", param.limits.max);
    let increment = number("increment", param.limits.increment);
    let default = number("default", param.default);
    let reserved = param.reserved.then(|| quote!(.reserved()));
    let facts = quote!(#label #units #values #min #max #increment #default #reserved);
    (!facts.is_empty()).then(|| quote!(wire::ParamInfo::new(#index) #facts))
}

fn enum_of<'a>(context: &Context<'a>, param: &Param) -> Option<&'a Enum> {
    context.dialect.enum_by_id(param.values?)
}

/// The way to the module of the enum that a parameter carries.
fn way(context: &Context<'_>, param: &Param) -> String {
    param.values.map_or_else(String::new, |id| context.way(2, context.enum_home(id)))
}

/// A list of the parameters that mean something, and what the command is for.
pub(crate) fn documentation(context: &Context<'_>, command: &Command) -> Vec<String> {
    let place = match (command.has_location, command.is_destination) {
        (true, true) => Some("Params 5, 6 and 7 are a place to go to."),
        (true, false) => Some("Params 5, 6 and 7 are a place."),
        _ => None,
    };
    let mission = command.mission_only.then_some("Only for missions: not to be sent as a command.");
    let notes = [place, mission].into_iter().flatten().map(str::to_owned).collect();
    let used = command.params.iter().filter(|param| !param.reserved);
    let list = used.filter_map(|param| item(context, param)).flatten().collect();
    doc::join([notes, list])
}

/// `- 1, Hold: time to stay. In s; at least 0.`; nothing where nothing is known.
fn item(context: &Context<'_>, param: &Param) -> Option<Vec<String>> {
    let label = param.label.as_ref().map_or_else(String::new, |label| format!(", {}", line(label)));
    let mut text = words(&param.origin.description);
    if matches!(text.as_slice(), [only] if ["Empty", "Empty.", "Reserved", "Reserved.", "Unused", "Unused."].contains(&only.as_str()))
    {
        text.clear();
    }
    let mut facts = docs::quantity(param.units.as_deref(), None, &param.limits);
    facts.extend(param.default.map(|default| format!("default {default}")));
    if !facts.is_empty() {
        let sentence = docs::capitalised(&format!("{}.", facts.join("; ")));
        text.extend(sentence.split(' ').map(str::to_owned));
    }
    text.extend(
        enum_of(context, param)
            .map(|values| format!("A [`{0}`]({1}enums::{0}).", values.name.rust, way(context, param))),
    );
    if text.is_empty() && label.is_empty() {
        return None;
    }
    let end = if text.is_empty() { "" } else { ":" };
    let mut item: Vec<String> = format!("{}{label}{end}", param.index).split(' ').map(str::to_owned).collect();
    item.append(&mut text);
    let mut lines = wrap(&item, 92).into_iter();
    let first = lines.next().map(|line| format!("- {line}"));
    Some(first.into_iter().chain(lines.map(|line| format!("  {line}"))).collect())
}

//! Enums and flags, the parameters of commands, and the enum over all messages of a dialect.

use super::docs;
use super::items::{Items, NamedEnum};
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::{self, Command, Entry, EnumId, Limits, Param};
use crate::order;
use crate::rust::{
    Constant, DialectEnum, Docs, Enum, Kind, ListItem, Method, Paragraph, ParamInfo, Receiver, Sig, Ty, Variant,
};

impl<'d> Items<'d> {
    /// The items of an enum; `conflicts` are lines about what other dialects have under its name.
    pub(super) fn enum_item(self, id: EnumId, conflicts: Vec<String>) -> Result<Enum<'d>, Internal> {
        let named = self.enum_at(id)?;
        let (one, ty) = (named.model, self.enum_type(id)?);
        let params = self.params(one)?;
        Ok(Enum {
            ident: ty.ident,
            alias: docs::alias(&one.name.text, ty.ident),
            docs: self.enum_docs(one, conflicts)?,
            deprecated: self.deprecation(&one.origin),
            int: ty.int,
            flags: ty.flags,
            constants: named.entries().map(|entry| self.constant_item(entry)).try_collect_vec()?,
            methods: if params.is_empty() { Vec::new() } else { vec![params_method()] },
            params,
            name: &one.name.text,
            entries: entries(named),
        })
    }

    fn enum_docs(self, one: &'d ir::Enum, conflicts: Vec<String>) -> Result<Docs<'d>, Internal> {
        let (file, name) = (self.file_name(one.defined_in)?, &one.name.text);
        let kind = if one.bitmask { "flags in a" } else { "numbers of type" };
        let facts = format!("`{name}` of `{file}`: {kind} `{}`.", one.repr.name());
        let mut paragraphs = docs::description(&one.origin);
        paragraphs.extend([docs::facts(facts, file, name), Paragraph::Lines(conflicts)]);
        Ok(Docs(paragraphs))
    }

    fn constant_item(self, (entry, ident): (&'d Entry, &'d str)) -> Result<Constant<'d>, Internal> {
        let mut paragraphs = docs::description(&entry.origin);
        if entry.origin.description.trim().is_empty() && entry.origin.lifecycle.is_none() {
            paragraphs.push(Paragraph::line(format!("`{}`.", entry.name.text)));
        }
        if let Some(command) = &entry.command {
            paragraphs.extend(self.command_docs(command)?);
        }
        Ok(Constant { ident, docs: Docs(paragraphs), deprecated: self.deprecation(&entry.origin), value: entry.value })
    }

    /// The parameters of an enum's commands, by value.
    fn params(self, one: &'d ir::Enum) -> Result<Vec<(u64, Vec<ParamInfo<'d>>)>, Internal> {
        // Of several names for one value, which only several dialects together can have, the first speaks.
        let firsts = one.entries.chunk_by(|a, b| a.value == b.value).filter_map(<[Entry]>::first);
        let commands = firsts.filter_map(|entry| Some((entry.value, entry.command.as_ref()?)));
        let rows = commands.map(|(value, command)| {
            let params = command.params.iter().filter(|param| is_known(param)).map(|param| {
                let carries = param.enum_.map(|id| Ok(self.enum_at(id)?.model.name.text.as_str())).transpose()?;
                Ok(ParamInfo { param, carries })
            });
            Ok((value, params.try_collect_vec()?))
        });
        let rows = rows.try_collect_vec()?;
        Ok(rows.into_iter().filter(|(_, params)| !params.is_empty()).collect_vec())
    }

    /// What the command is for, and a list of the parameters that mean something.
    fn command_docs(self, command: &'d Command) -> Result<[Paragraph<'d>; 2], Internal> {
        let used = command.params.iter().filter(|param| !param.reserved);
        let list = used.map(|param| self.param_item(param)).try_collect_vec()?;
        Ok([Paragraph::Lines(docs::command_notes(command)), Paragraph::List(list)])
    }

    /// `- 1, Hold: time to stay. In s; at least 0.`
    fn param_item(self, param: &'d Param) -> Result<ListItem<'d>, Internal> {
        let label = super::command::label(param);
        let mut facts = docs::quantity(param.units.as_deref(), None, &param.limits);
        facts.extend(param.default.map(|default| format!("default {default}")));
        let sentences = docs::sentence(&facts).into_iter().collect_vec();
        let link = param.enum_.map(|id| {
            let (name, way) = (self.enum_type(id)?.ident, self.way_to_enum(id)?);
            Ok(format!("A [`{name}`]({way}enums::{name})."))
        });
        let text = docs::meaningful(&param.origin.description);
        Ok(ListItem { head: param.index.to_string(), label, text, sentences, link: link.transpose()? })
    }

    /// The enum over all messages of a dialect.
    pub(super) fn dialect_enum(
        self,
        ident: &'d str,
        name: &str,
        messages: &[usize],
    ) -> Result<DialectEnum<'d>, Internal> {
        let variants = messages.iter().map(|at| {
            let message = self.message_at(*at)?;
            let docs = Docs::line(format!("`{}`, message {}.", message.model.name.text, message.model.id));
            Ok(Variant { ident: message.ty(), docs })
        });
        let docs = Docs::line(format!("Any message of the `{name}` dialect."))
            .then(Paragraph::line("New messages are added without a breaking release; match with a `_` arm."));
        let variants = variants.try_collect_vec()?;
        Ok(DialectEnum { ident, docs, variants, completed_by: "dialect", derives_debug: false })
    }
}

/// The names of the entries by value, with those that other dialects have for the same constant.
fn entries<'d>(named: NamedEnum<'d>) -> Vec<(u64, &'d str)> {
    let own = named.entries().map(|(entry, _)| (entry.value, entry.name.text.as_str()));
    let renamed = named.names.renamed.iter().filter_map(|(text, constant)| {
        let (entry, _) = named.entries().find(|(_, known)| known == constant)?;
        Some((entry.value, text.as_str()))
    });
    let mut entries = own.chain(renamed).collect_vec();
    order::sort_by_key(&mut entries, |(value, _)| *value);
    entries
}

/// Whether there is more than a description.
fn is_known(param: &Param) -> bool {
    let Param { index: _, label, units, enum_, limits, default, reserved, origin: _ } = param;
    let named = label.is_some() || units.is_some() || enum_.is_some();
    named || *limits != Limits::default() || default.is_some() || *reserved
}

fn params_method<'d>() -> Method<'d> {
    let docs = "What is known of the command's parameters, by index: those left out are reserved, or have nothing but a description.";
    let sig = Sig { receiver: Receiver::Value, ..Sig::getter(Ty::Params) };
    Method::new("params", sig, Docs::line(docs), Kind::Params)
}

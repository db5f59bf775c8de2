//! A view of values: `gps()`, `set_gps()` and `with_gps()`, and the record that they take and give.

use super::super::docs;
use super::super::items::Items;
use super::super::named::{NamedMessage, NamedRecord, NamedView};
use super::{Given, summary};
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::rust::{Docs, Kind, Method, Paragraph, Record, RecordType, Sig, Ty};

impl<'d> Items<'d> {
    pub(super) fn record(
        self,
        message: NamedMessage<'d>,
        view: NamedView<'d>,
        named: NamedRecord<'d>,
    ) -> Result<Given<'d>, Internal> {
        let values = named.values().map(|(value, ident)| self.key(message, value, ident));
        let when = view.model.condition.as_ref().map(|condition| self.holds(message, condition)).transpose()?;
        let record = Record { ident: view.ty(), values: values.try_collect_vec()?, when };
        let (ty, getter, condition) = (Ty::Named(view.ty()), named.getter, self.condition(message, view)?);
        let unless = condition.iter().map(|asked| format!("`None` unless {asked}."));
        let method = |ident, sig, docs, kind| Method { ident, sig, docs, inline: true, kind };
        let get = method(
            getter.to_owned(),
            Sig::getter(ty.clone().optional(record.when.is_some())),
            Docs(vec![summary(view), Paragraph::Lines(unless.collect_vec())]),
            Kind::RecordGet(record.clone()),
        );
        let set = method(
            format!("set_{getter}"),
            Sig::setter("value", ty),
            Docs::line(match &condition {
                Some(asked) => format!("Sets the values, and that {asked}."),
                None => "Sets the values.".to_owned(),
            }),
            Kind::RecordSet(record),
        );
        let with = method(
            format!("with_{getter}"),
            set.sig.with(),
            Docs::line(format!("With this [`Self::{getter}()`].")),
            Kind::With { set: set.ident.clone(), indexed: false, fallible: false },
        );
        Ok(Given { record: Some(self.declared_record(message, view, named)?), methods: vec![get, set, with] })
    }

    /// `pub struct AqGps { … }`
    fn declared_record(
        self,
        message: NamedMessage<'d>,
        view: NamedView<'d>,
        named: NamedRecord<'d>,
    ) -> Result<RecordType<'d>, Internal> {
        let fields = named.values().map(|(value, ident)| self.key_field(message, value, ident));
        let (file, name, ty) =
            (self.file_name(view.model.origin.file)?, &view.model.name.text, docs::link(message.ty()));
        let facts = format!("`{name}` of `{file}`: values of {ty}.");
        let docs = Docs(vec![Paragraph::prose(&view.model.origin.description), Paragraph::line(facts)]);
        Ok(RecordType { ident: view.ty(), docs, fields: fields.try_collect_vec()? })
    }

    /// `` `Index` is 4 ``
    pub(in crate::lower) fn condition(
        self,
        message: NamedMessage<'d>,
        view: NamedView<'d>,
    ) -> Result<Option<String>, Internal> {
        let Some(condition) = &view.model.condition else { return Ok(None) };
        let field = &message.field(condition.field)?.model.name.text;
        let enum_ = condition.enum_.map(|id| self.enum_at(id)).transpose()?;
        let entry = enum_.and_then(|one| one.model.entries.iter().find(|entry| entry.value == condition.value));
        let value = entry.map_or_else(|| condition.value.to_string(), |entry| format!("`{}`", entry.name.text));
        Ok(Some(format!("`{field}` is {value}")))
    }
}

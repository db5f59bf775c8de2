//! A view of values: `gps()`, `set_gps()` and `with_gps()`, and the record that they take and give.

use super::super::docs;
use super::super::items::{Items, NamedView};
use super::summary;
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::rust::{Docs, Kind, Method, Paragraph, Record, RecordType, Ty};

impl<'d> Items<'d> {
    pub(super) fn record(self, view: NamedView<'d>) -> Result<Vec<Method<'d>>, Internal> {
        let when = view.model.condition.as_ref().map(|condition| self.holds(view.message, condition)).transpose()?;
        let (record, getter) = (Record { ident: view.ty(), values: self.keys(view)?, when }, view.getter());
        let (condition, optional) = (self.condition(view)?, record.when.is_some());
        let unless = condition.iter().map(|asked| format!("`None` unless {asked}."));
        let get_docs = Docs(vec![summary(view), Paragraph::Lines(unless.collect_vec())]);
        let set_docs = Docs::line(match &condition {
            Some(asked) => format!("Sets the values, and that {asked}."),
            None => "Sets the values.".to_owned(),
        });
        let kinds = [Kind::RecordGet(record.clone()), Kind::RecordSet(record)];
        let [get, set] = Method::pair(getter, Ty::Named(view.ty()), optional, [get_docs, set_docs], kinds);
        let with = set.with(getter, Docs::line(format!("With this [`Self::{getter}()`].")));
        Ok(vec![get, set, with])
    }

    /// `pub struct AqGps { … }`
    pub(super) fn declared_record(self, view: NamedView<'d>) -> Result<RecordType<'d>, Internal> {
        let file = self.file_name(view.model.origin.file)?;
        let facts = format!("`{}` of `{file}`: values of {}.", view.model.name.text, docs::link(view.message.ty()));
        let docs = Docs(vec![Paragraph::prose(&view.model.origin.description), Paragraph::line(facts)]);
        Ok(RecordType { ident: view.ty(), docs, fields: self.key_fields(view)? })
    }

    /// `` `Index` is 4 ``
    pub(in crate::lower) fn condition(self, view: NamedView<'d>) -> Result<Option<String>, Internal> {
        let Some(condition) = &view.model.condition else { return Ok(None) };
        let field = &view.message.field(condition.field)?.model.name.text;
        let enum_ = condition.enum_.map(|id| self.enum_at(id)).transpose()?;
        let entry = enum_.and_then(|one| one.model.entries.iter().find(|entry| entry.value == condition.value));
        let value = entry.map_or_else(|| condition.value.to_string(), |entry| format!("`{}`", entry.name.text));
        Ok(Some(format!("`{field}` is {value}")))
    }
}

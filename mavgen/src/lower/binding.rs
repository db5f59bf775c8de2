//! Enums that overlays bind to fields.

use super::docs;
use super::items::Items;
use super::named::NamedMessage;
use crate::collect::CollectVec as _;
use crate::internal::Internal;
use crate::ir::Binding;
use crate::rust::{Bind, Docs, Kind, Method, Paragraph, Sig, Ty};

impl<'d> Items<'d> {
    /// The getters and setters of what overlays bind to the fields of a message.
    pub(super) fn bindings(self, message: NamedMessage<'d>) -> Result<Vec<Method<'d>>, Internal> {
        let methods = message.bindings().map(|binding| self.binding(message, binding));
        Ok(methods.try_collect_vec()?.into_iter().flatten().collect_vec())
    }

    fn binding(
        self,
        message: NamedMessage<'d>,
        (binding, getter): (&'d Binding, &str),
    ) -> Result<[Method<'d>; 2], Internal> {
        let field = message.field(binding.field)?.ident;
        let bound = self.enum_type(binding.enum_)?;
        let when = binding.condition.as_ref().map(|condition| self.holds(message, condition)).transpose()?;
        let link = format!("[`Self::{field}`](field@Self::{field})");
        let shown = Paragraph::line(format!("{link} as {}.", docs::link(bound.ident)));
        let ty = Ty::Enum(bound);
        let get = Method {
            ident: getter.to_owned(),
            sig: Sig::getter(ty.clone().optional(when.is_some())),
            docs: Docs(vec![Paragraph::prose(binding.description.as_str()), shown]),
            inline: true,
            kind: Kind::BindGet(Bind { field, bound, when }),
        };
        let set = Method {
            ident: format!("set_{getter}"),
            sig: Sig::setter("value", ty),
            docs: Docs::line(format!("Sets {link} from {}.", docs::link(bound.ident))),
            inline: true,
            kind: Kind::BindSet(Bind { field, bound, when: None }),
        };
        Ok([get, set])
    }
}

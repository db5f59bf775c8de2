//! A view over plain fields: `flight_sw()` and `set_flight_sw()`.

use super::super::items::Items;
use super::super::named::{NamedMessage, NamedView};
use super::{Given, summary};
use crate::internal::Internal;
use crate::rust::{Docs, Kind, Method, Sig, Ty};

impl<'d> Items<'d> {
    pub(super) fn once(
        self,
        message: NamedMessage<'d>,
        view: NamedView<'d>,
        getter: &str,
    ) -> Result<Given<'d>, Internal> {
        let source = self.source(message, view)?;
        let ty = Ty::Named(source.view);
        let get = Method {
            ident: getter.to_owned(),
            sig: Sig::getter(ty.clone().optional(!source.when.is_empty())),
            docs: Docs(vec![summary(view)]),
            inline: true,
            kind: Kind::ViewGet(source.clone()),
        };
        let set = Method {
            ident: format!("set_{getter}"),
            sig: Sig::setter("value", ty),
            docs: Docs::line("Sets the bits."),
            inline: true,
            kind: Kind::ViewSet(source),
        };
        Ok(Given { record: None, methods: vec![get, set] })
    }
}

//! A view over plain fields: `flight_sw()` and `set_flight_sw()`.

use super::super::{Internal, Items};
use super::Given;
use crate::ir::{Label, Message, View};
use crate::rust::{Docs, Kind, Method, Sig, Ty};

impl<'d> Items<'d> {
    pub(super) fn once(self, message: &'d Message, view: &'d View, getter: &Label) -> Result<Given<'d>, Internal> {
        let (getter, source) = (self.once_getter(getter), self.source(message, view)?);
        let ty = Ty::Named(source.view);
        let get = Method {
            ident: getter.clone(),
            sig: Sig::getter(ty.clone().optional(!source.when.is_empty())),
            docs: Docs(vec![self.summary(view)]),
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
        Ok(Given { slot: None, methods: vec![get, set] })
    }
}

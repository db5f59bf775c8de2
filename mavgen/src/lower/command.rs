//! A typed command: its fields and its documentation.

use super::docs;
use super::folder::CommandSet;
use super::imports::MODULE;
use super::items::{Items, NamedCommand};
use crate::collect::CollectVec as _;
use crate::docs::line;
use crate::internal::Internal;
use crate::ir::{self, Carrier, Param};
use crate::rust::{Alias, Carriers, Command, CommandField, Docs, EnumType, Paragraph, ParamTy, Ty};

impl<'d> Items<'d> {
    pub(super) fn command(self, command: NamedCommand<'d>) -> Result<Command<'d>, Internal> {
        let NamedCommand { entry, names, .. } = command;
        let fields = command.params().filter_map(|(param, field)| Some((param, field?)));
        let fixed = command.params().filter_map(|(param, field)| match (field, param.default) {
            (None, Some(value)) if value != 0.0 => Some((param.index, value)),
            _ => None,
        });
        Ok(Command {
            ident: &names.ty,
            alias: &entry.name.text,
            docs: self.command_type_docs(command)?,
            deprecated: self.deprecation(&entry.origin),
            id: u16::try_from(entry.value)
                .map_err(|_| Internal::new(format!("no message carries command {}", entry.value)))?,
            fields: fields.map(|(param, ident)| self.command_field(command, param, ident)).try_collect_vec()?,
            fixed: fixed.collect_vec(),
        })
    }

    fn command_field(
        self,
        command: NamedCommand<'d>,
        param: &'d Param,
        ident: &'d str,
    ) -> Result<CommandField<'d>, Internal> {
        let ty = self.param_ty(command.model, param)?;
        let default = match ty {
            ParamTy::Enum(one) => param.default.filter(|default| is_of(*default, one)).unwrap_or(0.0),
            _ => param.default.unwrap_or(if is_coordinate(command.model, param) { f64::NAN } else { 0.0 }),
        };
        Ok(CommandField { ident, index: param.index, ty, default, docs: param_docs(command.model, param, ty) })
    }

    fn param_ty(self, command: &ir::Command, param: &Param) -> Result<ParamTy<'d>, Internal> {
        Ok(match param.enum_ {
            Some(id) => ParamTy::Enum(self.enum_type(id)?),
            None if !matches!(param.index, 5 | 6) => ParamTy::Float,
            None if is_scaled(command, param) => ParamTy::Place,
            None => ParamTy::Number,
        })
    }

    /// The description, what it is, and what it is for.
    fn command_type_docs(self, command: NamedCommand<'d>) -> Result<Docs<'d>, Internal> {
        let NamedCommand { entry, model, .. } = command;
        let file = self.file_name(entry.origin.file)?;
        let facts = format!("`{}`, command {} of `{file}`.", entry.name.text, entry.value);
        let mut paragraphs = docs::description(&entry.origin);
        paragraphs.extend([docs::facts(facts, file, &entry.name.text), Paragraph::Lines(docs::command_notes(model))]);
        Ok(Docs(paragraphs))
    }

    /// Whether naming the messages that carry commands, or a frame, makes the compiler warn.
    pub(super) fn names_deprecated(self, of: &CommandSet) -> Result<bool, Internal> {
        let mut deprecated = false;
        for at in [of.long, of.int].into_iter().flatten() {
            deprecated |= self.is_deprecated(&self.message_at(at)?.model.origin);
        }
        let frame = of.int.map(|at| self.frame(at)).transpose()?;
        Ok(deprecated || matches!(frame, Some(Ty::Enum(one)) if one.deprecated))
    }

    /// The type of the frame of `COMMAND_INT`.
    fn frame(self, at: usize) -> Result<Ty<'d>, Internal> {
        let mut fields = self.message_at(at)?.fields();
        let frame = fields.find(|field| field.model.name.text == Carrier::FRAME);
        Ok(self.element(frame.ok_or_else(|| Internal::new("COMMAND_INT has no frame"))?)?.ty())
    }

    /// The messages that carry commands, and the type of a frame.
    pub(super) fn carriers(self, of: &CommandSet) -> Result<Carriers, Internal> {
        let way = |at: usize| {
            let way = self.way(MODULE, self.message_home(at)?)?;
            Ok::<_, Internal>(format!("{way}messages::{}", self.message_at(at)?.ty()))
        };
        let frame = |at: usize| match self.frame(at)? {
            Ty::Enum(one) => Ok(self.way(MODULE, self.enum_home(one.id)?)? + "enums::" + one.ident),
            Ty::Int(int) => Ok(int.name().to_owned()),
            other => Err(Internal::new(format!("a frame is no {other:?}"))),
        };
        let long = of.long.map(way).transpose()?;
        let int = of.int.map(|at| Ok::<_, Internal>((way(at)?, frame(at)?))).transpose()?;
        Ok(Carriers { long, int })
    }
}

/// The name by which a deprecated command is used.
pub(super) fn alias<'d>(command: &Command<'d>, module: &'d str) -> Option<Alias<'d>> {
    let Command { ident, alias, docs, deprecated, .. } = command;
    Some(Alias { ident, alias: Some(alias), docs: docs.clone(), deprecated: deprecated.clone()?, module })
}

/// Whether a param is a coordinate of a place.
fn is_coordinate(command: &ir::Command, param: &Param) -> bool {
    command.has_location && matches!(param.index, 5..=7) && param.enum_.is_none()
}

/// Whether the integer of a coordinate is scaled as the frame says. One in `degE7` is that integer itself.
fn is_scaled(command: &ir::Command, param: &Param) -> bool {
    is_coordinate(command, param) && param.units.as_deref() != Some("degE7")
}

/// Whether an enum can have a number.
fn is_of(number: f64, one: EnumType<'_>) -> bool {
    let whole = number as i128;
    let bits = one.int.bits() - u8::from(one.int.is_signed());
    let lowest = if one.int.is_signed() { -(1_i128 << bits) } else { 0 };
    whole as f64 == number && (lowest..1_i128 << bits).contains(&whole)
}

/// What stands behind the number of a param: `, Hold`, or nothing if it has no label.
pub(super) fn label(param: &Param) -> String {
    let label = param.label.as_deref().map(line).filter(|label| !label.trim().is_empty());
    label.map_or_else(String::new, |label| format!(", {label}"))
}

/// The description; then which param it is, unit, range, default, and what a coordinate is.
fn param_docs<'d>(command: &ir::Command, param: &'d Param, ty: ParamTy<'_>) -> Docs<'d> {
    let mut facts = docs::quantity(param.units.as_deref(), None, &param.limits);
    if ty == ParamTy::Place && param.units.is_none() {
        facts.push("in degrees, or metres in a local frame".to_owned());
    }
    if is_coordinate(command, param) {
        facts.push("NaN means not known".to_owned());
    }
    facts.extend(param.default.map(|default| match ty {
        ParamTy::Enum(one) if !is_of(default, one) => format!("default 0: {default} is no number of the enum"),
        _ => format!("default {default}"),
    }));
    let mut sentences = vec![format!("Param {}{}.", param.index, label(param))];
    sentences.extend(docs::sentence(&facts));
    Docs(vec![Paragraph::Prose(docs::meaningful(&param.origin.description).into(), sentences)])
}

//! A view: its type, its methods, and how a message gives it.

mod members;
mod record;
mod slots;
mod source;

use super::items::{Items, NamedSlots, NamedView};
use super::{docs, spelling};
use crate::collect::CollectVec as _;
use crate::docs::line;
use crate::internal::Internal;
use crate::ir::{Access, Meaning, Member, Presence, SwitchOn};
use crate::rust::{Cell, Debugged, Docs, Int, Kind, Method, Packed, Paragraph, Param, Receiver, Sig, Ty, View};

impl<'d> Items<'d> {
    pub(super) fn view(self, message: usize, at: usize) -> Result<View<'d>, Internal> {
        let view = self.message_at(message)?.view(at)?;
        let (packed, record, message_methods) = match (&view.model.access, &view.names.slots) {
            (Access::Once { .. }, None) => (Some(self.packed(view)?), None, self.once(view)?),
            (Access::Slots(model), Some(names)) => {
                let slots = NamedSlots { view, model, names };
                let slot = self.declared_slot(slots)?;
                (Some(self.packed(view)?), Some(slot), self.slots(slots)?)
            }
            (Access::Record(_), None) => (None, Some(self.declared_record(view)?), self.record(view)?),
            _ => return Err(Internal::new(format!("{} is named as what it is not", view.ty()))),
        };
        Ok(View { packed, record, message: view.message.ty(), message_methods })
    }

    /// A view over plain fields: `flight_sw()` and `set_flight_sw()`.
    fn once(self, view: NamedView<'d>) -> Result<Vec<Method<'d>>, Internal> {
        let source = self.source(view)?;
        let (ty, optional) = (Ty::Named(source.view), !source.when.is_empty());
        let docs = [Docs(vec![summary(view)]), Docs::line("Sets the bits.")];
        let kinds = [Kind::ViewGet(source.clone()), Kind::ViewSet(source)];
        Ok(Method::pair(view.getter(), ty, optional, docs, kinds).into_iter().collect_vec())
    }

    /// The type over the bits.
    fn packed(self, view: NamedView<'d>) -> Result<Packed<'d>, Internal> {
        let storage = Int::of_bits(view.model.width, false);
        let switch = carried(view)?;
        let mut methods = construction(storage, switch);
        for member in view.members() {
            methods.extend(self.member_methods(view, member)?);
        }
        let (docs, debug) = (self.view_docs(view)?, view.members().map(debugged).collect_vec());
        Ok(Packed { ident: view.ty(), docs, storage, switch, methods, debug })
    }

    /// The description, where the bits are found, and a table of them.
    fn view_docs(self, view: NamedView<'d>) -> Result<Docs<'d>, Internal> {
        let file = self.file_name(view.model.origin.file)?;
        let fields = view.model.words.iter().map(|word| {
            let field = view.message.field(source::word_field(*word))?;
            Ok(format!("`{}`", field.model.name.text))
        });
        let fields = fields.try_collect_vec()?;
        let facts = format!(
            "`{}` of `{file}`: {} bits in {} of {}, the least significant first.",
            view.model.name.text,
            view.model.width,
            fields.join(", "),
            docs::link(view.message.ty())
        );
        let rows = view.members().map(|member| self.row(view, member)).try_collect_vec()?;
        let table = Paragraph::Table(vec!["bits", "name", "meaning", "only if"], rows);
        Ok(Docs(vec![Paragraph::prose(view.model.origin.description.as_str()), Paragraph::line(facts), table]))
    }

    /// `|  29..=43 | `rpm` | rpm | |`
    fn row(self, view: NamedView<'d>, (member, name): (&'d Member, &str)) -> Result<Vec<Cell<'d>>, Internal> {
        let last = member.at + member.width - 1;
        let bits = if member.width == 1 { member.at.to_string() } else { format!("{}..={last}", member.at) };
        let bits = match member.repeat {
            Some(repeat) => format!("{bits}, {} times, {} apart", repeat.count, repeat.stride),
            None => bits,
        };
        let meaning = match &member.meaning {
            Meaning::Flag => "yes or no".to_owned(),
            Meaning::Values(id) => docs::link(self.enum_type(*id)?.ident),
            Meaning::Number { units } => units.as_deref().map_or_else(|| "number".to_owned(), line),
            Meaning::Scaled(scaled) => format!("{scaled} {}", scaled.units.as_deref().map(line).unwrap_or_default()),
        };
        let cells = [bits, format!("`{name}`"), meaning.trim_end().to_owned(), only_if(view, member)];
        Ok(cells.map(Cell::Plain).to_vec())
    }
}

/// The switch value that the view carries along.
fn carried(view: NamedView<'_>) -> Result<Option<(&str, Int)>, Internal> {
    match view.model.switch.as_ref().map(|switch| switch.on) {
        Some(SwitchOn::Field(_, repr)) => Ok(Some((view.switch_getter()?, repr.into()))),
        Some(SwitchOn::Bits { .. }) | None => Ok(None),
    }
}

/// What `Debug` shows of a member.
fn debugged<'d>((member, ident): (&'d Member, &'d str)) -> Debugged<'d> {
    let decimals = match &member.meaning {
        Meaning::Scaled(scaled) => Some(decimals(scaled.divisor)),
        Meaning::Flag | Meaning::Values(_) | Meaning::Number { .. } => None,
    };
    let count = member.repeat.map(|repeat| repeat.count);
    Debugged { ident, units: units(member), decimals, count, optional: member.presence != Presence::Always }
}

/// The unit of what bits hold.
fn units(member: &Member) -> Option<&str> {
    match &member.meaning {
        Meaning::Number { units } => units.as_deref(),
        Meaning::Scaled(scaled) => scaled.units.as_deref(),
        Meaning::Flag | Meaning::Values(_) => None,
    }
}

/// `data_version` 3..=9, 30..=255
fn only_if(view: NamedView<'_>, member: &Member) -> String {
    let (Presence::When(ranges), Some(switch)) = (&member.presence, &view.model.switch) else { return String::new() };
    let ranges = ranges.iter().map(|range| match (range.start(), range.end()) {
        (start, end) if start == end => start.to_string(),
        (start, end) => format!("{start}..={end}"),
    });
    format!("`{}` {}", spelling::label(&switch.name), ranges.collect_vec().join(", "))
}

/// What the overlay says of the view, or where it comes from: of the method that gives it.
fn summary(view: NamedView<'_>) -> Paragraph<'_> {
    if view.model.origin.description.trim().is_empty() {
        return Paragraph::line(format!("The {} in the fields.", docs::link(view.ty())));
    }
    Paragraph::prose(view.model.origin.description.as_str())
}

/// `from_bits`, `bits`, and the switch value.
fn construction<'d>(storage: Int, switch: Option<(&'d str, Int)>) -> Vec<Method<'d>> {
    let mut params = vec![Param { ident: "bits", ty: Ty::Int(storage) }];
    params.extend(switch.map(|(ident, int)| Param { ident, ty: Ty::Int(int) }));
    let from_bits = Sig { receiver: Receiver::None, params, ..Sig::const_getter(Ty::Own) };
    let made = Kind::FromBits { switch: switch.map(|(ident, _)| ident) };
    let bits = Sig::const_getter(Ty::Int(storage));
    let mut methods = vec![
        Method::new("from_bits", from_bits, Docs::line("The view of these bits."), made),
        Method::new("bits", bits, Docs::line("The bits, as the message carries them."), Kind::Bits),
    ];
    methods.extend(switch.map(|(ident, int)| {
        let docs = Docs::line(format!("The `{ident}` that says how the bits are laid out."));
        Method::new(ident, Sig::const_getter(Ty::Int(int)), docs, Kind::SwitchGet(ident))
    }));
    methods
}

/// Digits behind the point that show every value of a fraction, or two where no number of them does.
fn decimals(divisor: i64) -> usize {
    let ends = |digits: &u32| 10_i64.checked_pow(*digits).is_some_and(|power| power % divisor == 0);
    (0..=6).find(ends).map_or(2, |digits| digits as usize)
}

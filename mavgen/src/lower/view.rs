//! A view: its type, its methods, and how a message gives it.

mod members;
mod once;
mod slots;
mod source;

use super::{Internal, Items};
use crate::ir::{Access, Member, Message, Presence, SwitchOn};
use crate::ir::{Meaning, View as Layout};
use crate::rust::{Cell, Debugged, Docs, Int, Kind, Method, Paragraph, Param, Receiver, Sig, Ty, View};

/// What a view gives to its message: methods, and the type of a slot.
struct Given<'d> {
    slot: Option<crate::rust::SlotType<'d>>,
    methods: Vec<Method<'d>>,
}

impl<'d> Items<'d> {
    /// The items of a view.
    pub(crate) fn view(self, message: &'d Message, layout: &'d Layout) -> Result<View<'d>, Internal> {
        let storage = Int::of_bits(layout.width, false);
        let switch = self.carried(layout);
        let mut methods = construction(storage, switch.as_ref());
        for member in &layout.members {
            methods.extend(self.member_methods(layout, member)?);
        }
        let given = match &layout.access {
            Access::Once { getter } => self.once(message, layout, getter)?,
            Access::Slots(slots) => self.slots(message, layout, slots)?,
        };
        Ok(View {
            ident: self.view_type(layout),
            docs: self.view_docs(message, layout)?,
            storage,
            switch,
            methods,
            debug: layout.members.iter().map(|member| self.debugged(member)).collect(),
            slot: given.slot,
            message: self.message_type(message),
            message_methods: given.methods,
        })
    }

    /// The switch value that the view carries along.
    fn carried(self, layout: &'d Layout) -> Option<(String, Int)> {
        let switch = layout.switch.as_ref()?;
        match switch.on {
            SwitchOn::Field(_, repr) => Some((self.switch_getter(switch), repr.into())),
            SwitchOn::Bits { .. } => None,
        }
    }

    /// What `Debug` shows of a member.
    fn debugged(self, member: &'d Member) -> Debugged<'d> {
        let (units, decimals) = match &member.meaning {
            Meaning::Number { units } => (units.as_deref(), None),
            Meaning::Scaled(scaled) => (scaled.units.as_deref(), Some(decimals(scaled.divisor))),
            Meaning::Flag | Meaning::Values(_) => (None, None),
        };
        Debugged {
            ident: self.member_getter(member),
            units,
            decimals,
            count: member.repeat.map(|repeat| repeat.count),
            optional: member.presence != Presence::Always,
        }
    }

    /// The description, where the bits are found, and a table of them.
    fn view_docs(self, message: &'d Message, layout: &'d Layout) -> Result<Docs<'d>, Internal> {
        let file = self.file_name(layout.origin.file)?;
        let fields = self.word_fields(message, layout)?;
        let fields: Vec<String> = fields.iter().map(|field| format!("`{}`", field.name.text)).collect();
        let facts = format!(
            "`{}` of `{file}`: {} bits in {} of [`{}`], the least significant first.",
            layout.name.text,
            layout.width,
            fields.join(", "),
            self.message_type(message)
        );
        let rows = layout.members.iter().map(|member| self.row(layout, member)).collect::<Result<_, _>>()?;
        let table = Paragraph::Table(vec!["bits", "name", "meaning", "only if"], rows);
        Ok(Docs(vec![Paragraph::prose(&layout.origin.description), Paragraph::line(facts), table]))
    }

    /// `|  29..=43 | `rpm` | rpm | |`
    fn row(self, layout: &'d Layout, member: &'d Member) -> Result<Vec<Cell<'d>>, Internal> {
        let last = member.at + member.width - 1;
        let bits = if member.width == 1 { member.at.to_string() } else { format!("{}..={last}", member.at) };
        let bits = match member.repeat {
            Some(repeat) => format!("{bits}, {} times, {} apart", repeat.count, repeat.stride),
            None => bits,
        };
        let meaning = match &member.meaning {
            Meaning::Flag => "yes or no".to_owned(),
            Meaning::Values(id) => format!("[`{}`]", self.enum_type(*id)?.ident),
            Meaning::Number { units } => units.clone().unwrap_or_else(|| "number".to_owned()),
            Meaning::Scaled(scaled) => format!("{scaled} {}", scaled.units.as_deref().unwrap_or_default()),
        };
        let name = format!("`{}`", self.member_getter(member));
        Ok([bits, name, meaning.trim_end().to_owned(), self.only_if(layout, member)].map(Cell::Plain).to_vec())
    }

    /// `data_version` 3..=9, 30..=255
    fn only_if(self, layout: &'d Layout, member: &Member) -> String {
        let (Presence::When(ranges), Some(switch)) = (&member.presence, &layout.switch) else { return String::new() };
        let ranges = ranges.iter().map(|range| match (range.start(), range.end()) {
            (start, end) if start == end => start.to_string(),
            (start, end) => format!("{start}..={end}"),
        });
        format!("`{}` {}", self.switch_getter(switch), ranges.collect::<Vec<_>>().join(", "))
    }

    /// What the overlay says of the view, or where it comes from: of the method that gives it.
    fn summary(self, layout: &'d Layout) -> Paragraph<'d> {
        if layout.origin.description.trim().is_empty() {
            return Paragraph::line(format!("The [`{}`] in the fields.", self.view_type(layout)));
        }
        Paragraph::prose(&layout.origin.description)
    }
}

/// `from_bits`, `bits`, and the switch value.
fn construction<'d>(storage: Int, switch: Option<&(String, Int)>) -> Vec<Method<'d>> {
    let mut params = vec![Param { ident: "bits".to_owned(), ty: Ty::Int(storage) }];
    params.extend(switch.map(|(ident, int)| Param { ident: ident.clone(), ty: Ty::Int(*int) }));
    let method = |ident: &str, sig, docs, kind| Method { ident: ident.to_owned(), sig, docs, inline: false, kind };
    let from_bits = Sig { receiver: Receiver::None, params, ..Sig::const_getter(Ty::Own) };
    let made = Kind::FromBits { switch: switch.map(|(ident, _)| ident.clone()) };
    let mut methods = vec![
        method("from_bits", from_bits, Docs::line("The view of these bits."), made),
        method(
            "bits",
            Sig::const_getter(Ty::Int(storage)),
            Docs::line("The bits, as the message carries them."),
            Kind::Bits,
        ),
    ];
    methods.extend(switch.map(|(ident, int)| {
        let docs = Docs::line(format!("The `{ident}` that says how the bits are laid out."));
        method(ident, Sig::const_getter(Ty::Int(*int)), docs, Kind::SwitchGet(ident.clone()))
    }));
    methods
}

/// Digits behind the point that show every value of a fraction, or two where no number of them does.
fn decimals(divisor: i64) -> usize {
    let ends = |digits: &u32| 10_i64.checked_pow(*digits).is_some_and(|power| power % divisor == 0);
    (0..=6).find(ends).map_or(2, |digits| digits as usize)
}

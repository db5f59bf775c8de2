//! The names that a view gives to methods and fields, and that no two of them are one.

use std::collections::HashMap;

use super::all_bits;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{Access, Meaning, Member, SwitchOn, View};
use crate::names::field_name;
use crate::source::Span;
use crate::syntax::overlay;

/// Methods that every view has, and names that readers and lints take for something else.
const TAKEN: [&str; 9] = ["bits", "from_bits", "clone", "cmp", "default", "hash", "neg", "new", "not"];

/// The field of a slot that holds the view.
const STATUS: &str = "status";

/// What a name is, and where it comes from; the place is missing for what every view has.
struct Claim {
    name: String,
    what: String,
    place: Option<Span>,
}

/// Checks the methods of a view and the fields of its slots.
pub(super) fn check(view: &View, element: &overlay::View, diagnostics: &mut Diagnostics) {
    let reserved = |name: &str, what: &str| Claim { name: name.to_owned(), what: what.to_owned(), place: None };
    let mut methods: Vec<Claim> = TAKEN.iter().map(|name| reserved(name, "a method of every view")).collect();
    if let Some(switch) = view.switch.as_ref().filter(|switch| matches!(switch.on, SwitchOn::Field(..))) {
        let place = element.parts.iter().find_map(|part| match part {
            overlay::Part::Switch(switch) => switch.field.as_ref().map(|field| field.span),
            overlay::Part::Piece(_) => None,
        });
        methods.push(Claim { name: switch.name.rust(), what: "the getter of the switch".to_owned(), place });
    }
    // Bits of one name in two cases are one member: the first of each name that was not spoken for stands for it.
    let mut places: HashMap<String, Vec<Span>> = HashMap::new();
    for bits in all_bits(element) {
        places.entry(field_name(&bits.name.value)).or_default().push(bits.name.span);
    }
    for member in &view.members {
        let mine = view.members.iter().take_while(|other| !std::ptr::eq(*other, member));
        let earlier = mine.filter(|other| other.name == member.name).count();
        let place = places.get(&member.name.rust()).and_then(|spans| spans.get(earlier).or(spans.last())).copied();
        methods.extend(getters_of(member).into_iter().map(|(name, what)| Claim { name, what, place }));
    }
    check_apart(methods, diagnostics);
    if let Access::Slots(slots) = &view.access {
        let mut fields = vec![reserved(STATUS, "the field of every slot that holds the view")];
        for (key, element) in slots.keys.iter().zip(&element.keys) {
            let what = format!("key `{}`", element.name.value);
            fields.push(Claim { name: key.name.rust(), what, place: Some(element.name.span) });
        }
        check_apart(fields, diagnostics);
    }
}

/// The methods of a member, and what each is.
fn getters_of(member: &Member) -> Vec<(String, String)> {
    let name = &member.name.rust();
    let mut names = vec![name.clone()];
    if let Meaning::Scaled(scaled) = &member.meaning {
        names.push(format!("{name}_raw"));
        names.extend(scaled.exact.as_ref().map(|exact| format!("{name}_{}", exact.suffix())));
    }
    let setters = names.iter().take(2).map(|name| format!("set_{name}")).collect::<Vec<_>>();
    let method = |method: String| (method, format!("a method of `{name}`"));
    names.into_iter().chain(setters).map(method).collect()
}

/// Reports the names that are claimed twice; a member of which several are is reported once.
fn check_apart(claims: Vec<Claim>, diagnostics: &mut Diagnostics) {
    let mut taken: HashMap<String, (String, Option<Span>)> = HashMap::new();
    let mut reported = Vec::new();
    for Claim { name, what, place } in claims {
        let Some((other, first)) = taken.get(&name) else {
            taken.insert(name, (what, place));
            continue;
        };
        let Some(span) = place.filter(|span| !reported.contains(span)) else { continue };
        reported.push(span);
        let message = match what == *other {
            true => format!("`{name}` stands twice in the view"),
            false => format!("`{name}` is {what}, and {other} as well"),
        };
        let problem = Diagnostic::new(Code::NameCollision, span, message).help("rename one of them");
        diagnostics.push(match first {
            Some(first) => problem.related(*first, "the other one"),
            None => problem,
        });
    }
}

/// The methods that a view gives to its message.
pub(crate) fn of(view: &View) -> Vec<String> {
    match &view.access {
        Access::Once { getter } => vec![getter.rust(), format!("set_{}", getter.rust())],
        Access::Slots(slots) => {
            let item = field_name(&slots.item.text);
            vec![slots.items.rust(), format!("set_{item}"), format!("push_{item}"), item]
        }
    }
}

//! Documentation: what the XML says, and what only the generator knows.

use std::fmt::Display;

use super::items::Items;
use crate::collect::CollectVec as _;
use crate::docs::line;
use crate::ir::{Command, Invalid, Lifecycle, Limits, Origin, Scope, Sentinel, Successor};
use crate::rust::{Docs, Paragraph};

/// The description, and the stage of life.
pub(crate) fn description(origin: &Origin) -> Vec<Paragraph<'_>> {
    let lifecycle = lifecycle(origin).map(Paragraph::line);
    [Paragraph::prose(origin.description.as_str())].into_iter().chain(lifecycle).collect_vec()
}

/// The stage of life in a sentence: `Superseded since 2015-08, replaced by SET_MESSAGE_INTERVAL. Why.`
fn lifecycle(origin: &Origin) -> Option<String> {
    let (stage, successor) = match origin.lifecycle.as_ref()? {
        Lifecycle::Wip => return Some("**Work in progress**: may still change.".to_owned()),
        Lifecycle::Superseded(successor) => ("Superseded", successor),
        Lifecycle::Deprecated(successor) => ("Deprecated", successor),
    };
    let text = line(&format!("{stage}{successor}. {}", successor.description));
    Some(text.replacen(stage, &format!("**{stage}**"), 1))
}

impl Items<'_> {
    /// `since 2018-04, replaced by X`, if the item is deprecated and the options ask for it.
    ///
    /// The date stands in the note because `since` takes nothing but a version.
    pub(super) fn deprecation(self, origin: &Origin) -> Option<String> {
        match &origin.lifecycle {
            Some(Lifecycle::Deprecated(successor)) if self.deprecated => Some(note(successor)),
            _ => None,
        }
    }
}

fn note(successor: &Successor) -> String {
    // Rustdoc shows the note as markdown, so it is made safe like all other text.
    match line(&successor.to_string()).trim_start_matches(", ") {
        "" => "do not use".to_owned(),
        text => text.to_owned(),
    }
}

/// The XML's name, so that a search for it finds the type; nothing where both are spelled alike.
pub(crate) fn alias<'d>(xml: &'d str, rust: &str) -> Option<&'d str> {
    Some(xml).filter(|xml| *xml != rust)
}

/// `In m/s, from 0 to 100, in steps of 5`: what units and limits say; empty where they say nothing.
pub(crate) fn quantity(units: Option<&str>, multiplier: Option<&str>, limits: &Limits) -> Vec<String> {
    let unit = units.map(|units| match multiplier {
        Some(multiplier) => format!("in {} times {}", line(units), line(multiplier)),
        None => format!("in {}", line(units)),
    });
    let step = limits.increment.map(|step| format!("in steps of {step}"));
    [unit, range(limits.min, limits.max), step].into_iter().flatten().collect_vec()
}

/// `from 0 to 100`
pub(crate) fn range<T: Display>(min: Option<T>, max: Option<T>) -> Option<String> {
    match (min, max) {
        (Some(min), Some(max)) => Some(format!("from {min} to {max}")),
        (Some(min), None) => Some(format!("at least {min}")),
        (None, Some(max)) => Some(format!("at most {max}")),
        (None, None) => None,
    }
}

/// `65535 means not known`: of a scalar, or of an array.
pub(crate) fn not_known(Invalid { scope, sentinel }: Invalid, is_array: bool) -> String {
    let value = match sentinel {
        Sentinel::Integer(value) => value.to_string(),
        Sentinel::Float(value) => value.to_string(),
        Sentinel::NotANumber => "NaN".to_owned(),
    };
    match (is_array, scope) {
        (false, _) => format!("{value} means not known"),
        (true, Scope::Each) => format!("{value} means that an element is not known"),
        (true, Scope::Whole) => format!("{value} in the first element means that none is known"),
        (true, Scope::First) => format!("{value} means that the first element is not known"),
    }
}

/// A sentence of facts: `In m/s; 65535 means not known.`
pub(crate) fn sentence(facts: &[String]) -> Option<String> {
    (!facts.is_empty()).then(|| capitalised(&format!("{}.", facts.join("; "))))
}

/// What an overlay says of bits or of a copied field, or else its name; the unit; and more.
pub(crate) fn of_part<'d>(description: &'d str, name: &str, units: Option<&str>, more: Option<&str>) -> Docs<'d> {
    let name = description.trim().is_empty().then(|| format!("`{name}`."));
    let sentences = [name, units.map(|units| format!("In {}.", line(units))), more.map(str::to_owned)];
    Docs(vec![Paragraph::said(description, sentences.into_iter().flatten().collect_vec())])
}

/// Descriptions of params that say that there is nothing to describe.
const NOTHING: [&str; 6] = ["Empty", "Empty.", "Reserved", "Reserved.", "Unused", "Unused."];

/// The description of a param; empty if it says nothing.
pub(crate) fn meaningful(description: &str) -> &str {
    if NOTHING.contains(&description.trim()) { "" } else { description }
}

/// What a command is for.
pub(crate) fn command_notes(command: &Command) -> Vec<String> {
    let place = match (command.has_location, command.is_destination) {
        (true, true) => Some("Params 5, 6 and 7 are a place to go to."),
        (true, false) => Some("Params 5, 6 and 7 are a place."),
        _ => None,
    };
    let mission = command.mission_only.then_some("Only for missions: not to be sent as a command.");
    [place, mission].into_iter().flatten().map(str::to_owned).collect_vec()
}

/// `in m/s` becomes `In m/s`.
fn capitalised(sentence: &str) -> String {
    let mut chars = sentence.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

/// A link to a type; one that is called like a derive macro has to say what it is.
pub(crate) fn link(rust: &str) -> String {
    let derives = ["Clone", "Copy", "Debug", "Default", "Eq", "Hash", "Ord", "PartialEq", "PartialOrd"];
    if derives.contains(&rust) { format!("[`struct@{rust}`]") } else { format!("[`{rust}`]") }
}

/// The files of upstream that have a page in the public message reference.
const PUBLISHED: &str = "ASLUAV AVSSUAS all ardupilotmega common csAirLink cubepilot development icarous loweheiser marsh \
    minimal paparazzi python_array_test standard stemstudios storm32 test uAvionix ualberta";

/// The facts of an item, and a link to the public reference, where that covers the file.
pub(crate) fn facts<'d>(facts: String, file: &str, name: &str) -> Paragraph<'d> {
    let stem = file.strip_suffix(".xml").filter(|stem| PUBLISHED.split(' ').any(|one| one == *stem));
    let link = |stem| format!("See the [message reference](https://mavlink.io/en/messages/{stem}.html#{name}).");
    Paragraph::Lines([facts].into_iter().chain(stem.map(link)).collect_vec())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::link;
    use crate::Builder;

    const DIALECT: &str = "<mavlink><enums>
<enum name='HASH'><entry value='0' name='HASH_A'/></enum>
</enums><messages><message id='1' name='DEBUG'>
<field type='uint8_t' name='bits'/><field type='uint8_t' name='plain'/><field type='uint8_t' name='other'/>
<field type='int8_t' name='narrow' enum='HASH'/><field type='uint8_t' name='wide' enum='HASH'/>
<field type='uint8_t[2]' name='each'/><field type='float' name='value'/>
</message></messages></mavlink>";

    const OVERLAY: &str = "<mavlink-overlay version='1' for='acme.xml'><message name='DEBUG'>
<bind name='bound' field='plain' enum='HASH'/>
<view name='CLONE' words='bits' item='clone_bits'><bits name='a' at='0' width='8' enum='HASH'/></view>
<view name='COPY' words='each[i]' item='one' items='ones'><bits name='a' at='0' width='8'/></view>
<view name='EQ' item='eq_value'><value name='a' field='value'/></view>
</message></mavlink-overlay>";

    /// rustdoc takes `Debug` for the macro as well, and refuses the link.
    #[test]
    fn no_link_is_that_of_a_derive_macro() {
        let folder = tempfile::tempdir().unwrap();
        let (dialect, overlay) = (folder.path().join("acme.xml"), folder.path().join("acme.overlay.xml"));
        fs::write(&dialect, DIALECT).unwrap();
        fs::write(&overlay, OVERLAY).unwrap();
        let builder = Builder::new(dialect).overlay(overlay);
        let text: String =
            builder.emit(&builder.resolve().unwrap()).unwrap().into_iter().map(|file| file.text).collect();
        for name in ["Clone", "Copy", "Debug", "Eq", "Hash"] {
            assert!(text.contains(&link(name)), "no link to {name}");
            assert!(!text.contains(&format!("[`{name}`]")), "a link to the macro {name}");
        }
    }
}

//! Enums: their constants, tables and texts, held against what pymavlink understands.

use std::fmt::Display;
use std::str::FromStr;

use mavlink_wire::{Enum, EnumInfo, Repr};

use crate::fault::{Check, Findings};

/// The enums of the AutoQuad dialect, as pymavlink resolves them; `vectors/README.md` describes the format.
pub const AUTOQUAD: &str = include_str!("../vectors/enums.txt");

/// An enum as it should be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Expected {
    /// Name in the XML.
    pub name: String,
    /// Whether its values are bits.
    pub bitmask: bool,
    /// Value and name of each entry, by value.
    pub entries: Vec<(u64, String)>,
}

/// Reads the file.
///
/// # Panics
///
/// If it is not written as the format says.
pub fn read(text: &str) -> Vec<Expected> {
    let mut enums: Vec<Expected> = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            ["enum", name, kind @ ("bitmask" | "plain")] => {
                enums.push(Expected { name: name.to_owned(), bitmask: kind == "bitmask", entries: Vec::new() });
            }
            [value, name] => enums.last_mut().unwrap().entries.push((value.parse().unwrap(), name.to_owned())),
            _ => panic!("neither an enum nor an entry: {line}"),
        }
    }
    enums
}

/// An enum type under test, without its type: what the build script makes one of for every enum.
pub struct Constants {
    info: &'static EnumInfo,
    /// Name in the XML, name in Rust, value.
    rows: &'static [(&'static str, &'static str, u64)],
    display: fn(u64) -> String,
    parse: fn(&str) -> Option<u64>,
}

impl Constants {
    /// The constants of an enum type.
    pub const fn of<E: Enum + Display + FromStr>(rows: &'static [(&'static str, &'static str, u64)]) -> Self {
        Self {
            info: E::INFO,
            rows,
            display: |value| E::from_repr(E::Repr::from_bits(value)).to_string(),
            parse: |text| text.parse::<E>().ok().map(|value| value.repr().bits()),
        }
    }

    /// Name in the XML.
    pub fn name(&self) -> &'static str {
        self.info.name
    }

    fn check(&self, expected: &Expected, findings: &mut Findings) {
        let place = expected.name.as_str();
        let entries: Vec<(u64, &str)> = expected.entries.iter().map(|(value, name)| (*value, name.as_str())).collect();
        let constants = self.rows.iter().map(|&(xml, _, value)| (value, xml)).collect();
        findings.equal(Check::Constants, place, constants, entries.clone());
        for (xml, rust, _) in self.rows {
            let kept = xml.to_uppercase().replace('_', "").ends_with(&rust.replace('_', ""));
            findings.equal(Check::Constants, place, (kept, xml, rust), (true, xml, rust));
        }
        let info = (self.info.name, self.info.bitmask, self.info.entries);
        findings.equal(Check::EnumInfo, place, info, (place, expected.bitmask, &entries));
        for (value, name) in entries {
            findings.equal(Check::EnumText, place, (self.parse)(name), Some(value));
            let text = (self.display)(value);
            findings.equal(Check::EnumText, place, (self.parse)(&text), Some(value));
            // Flags print as names of single bits, and none as `0`.
            if value.is_power_of_two() || !expected.bitmask {
                findings.equal(Check::EnumText, place, text.as_str(), name);
            }
        }
    }
}

/// Every check of every enum.
pub fn check(constants: &[Constants], expected: &[Expected]) -> Findings {
    let mut findings = Findings::default();
    let names: Vec<&str> = constants.iter().map(|constants| constants.name()).collect();
    findings.equal(Check::EnumInfo, "enums", names.len(), expected.len());
    for expected in expected {
        let subject = constants.iter().find(|constants| constants.name() == expected.name);
        findings.equal(Check::EnumInfo, &expected.name, subject.is_some(), true);
        if let Some(subject) = subject {
            subject.check(expected, &mut findings);
        }
    }
    findings
}

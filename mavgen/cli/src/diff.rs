//! `mavgen diff`: what changed between two states of a dialect, as text and as JSON.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use mavgen::Failure;
use mavgen::compare::{Change, Group, compare};
use mavgen::source::{Sources, Span};
use serde_json::{Value, json};

use super::input::{Reading, file, resolve, resolve_silently};
use super::report::{self, Report, plural};

/// Says what changed between two states of a dialect: on the wire, in its enums, in the generated Rust.
///
/// A change is breaking if what was built for the old state no longer works with the new one: a frame is refused or misread, a
/// value of an enum means something else, Rust code no longer compiles. New messages, entries and constants break nothing. An extension at
/// the end of a message breaks nothing on the wire, but it is a new field of a struct in Rust, and breaks its literals.
///
/// Units, ranges, sentinels, stages of life and the like are counted, and listed with --all: no program notices a change of
/// them by itself, so look at them. Descriptions are not compared. Warnings are about the new state alone.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Diff {
    /// The old state: a dialect's XML file.
    #[arg(value_parser = file())]
    old: PathBuf,
    /// The new state.
    #[arg(value_parser = file())]
    new: PathBuf,
    /// Only what both ends have to agree on: messages on the wire, and enums.
    #[arg(long, conflicts_with = "api")]
    wire: bool,
    /// Only the generated Rust.
    #[arg(long)]
    api: bool,
    /// List changes of units, ranges and the like, too.
    #[arg(long, conflicts_with_all = ["wire", "api"])]
    all: bool,
    /// As JSON; changes of units, ranges and the like are listed, too.
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    reading: Reading,
    /// An overlay of the old state, instead of those that `--overlay` gives for both; may be given several times.
    #[arg(long, value_name = "FILE", value_parser = file())]
    old_overlay: Vec<PathBuf>,
}

const AFTER_HELP: &str = "\
Examples:
  mavgen diff v1/acme.xml v2/acme.xml
  mavgen diff v1/acme.xml v2/acme.xml --wire  can both talk to each other?
  mavgen diff v1/acme.xml v2/acme.xml --api   is the crate's release breaking?
  mavgen diff v1/acme.xml v2/acme.xml --json | jq '.changes[].text'

Exit status: 0 nothing is broken, 1 something is, 2 the input or the usage is wrong.";

impl Diff {
    pub(super) fn run(&self, report: &Report) -> Result<ExitCode, Failure> {
        let mut before = self.reading.clone();
        if !self.old_overlay.is_empty() {
            before.overlay.clone_from(&self.old_overlay);
        }
        let old = resolve_silently(&before.whole(&self.old).deny_warnings(false))?;
        let new = resolve(&self.reading.whole(&self.new), report)?;
        let mut changes = compare(&old.dialect, &new.dialect, self.reading.definitions.messages.as_deref())?;
        changes.retain(|change| self.asks_for(change.group()));
        let places = Places { old: &old.sources, new: &new.sources };
        report::print(&if self.json { self.as_json(&changes, &places) } else { self.text(&changes, &places) })?;
        let broken = changes.iter().any(|change| change.breaking);
        Ok(if broken { ExitCode::from(1) } else { ExitCode::SUCCESS })
    }

    fn asks_for(&self, group: Group) -> bool {
        match group {
            Group::Wire | Group::Enums => !self.api,
            Group::Api => !self.wire,
            Group::Metadata => !self.wire && !self.api,
        }
    }

    /// The changes by group, what breaks first.
    fn text(&self, changes: &[Change], places: &Places<'_>) -> String {
        let mut text = String::new();
        for group in Group::ALL {
            for breaking in [true, false] {
                let listed = changes.iter().filter(|change| change.group() == group && change.breaking == breaking);
                let listed: Vec<&Change> = listed.collect();
                if listed.is_empty() {
                    continue;
                }
                let hidden = group == Group::Metadata && !self.all;
                let (title, end) = (title(group, breaking), if hidden { " (--all lists them)" } else { ":" });
                text += &format!("{title}, {}{end}\n", plural(listed.len(), "change"));
                for change in listed.into_iter().filter(|_| !hidden) {
                    text += &format!("  {change}\n");
                    text += &format!("    {}\n", places.of(change));
                }
            }
        }
        if text.is_empty() {
            let what = if self.wire {
                " on the wire"
            } else if self.api {
                " in Rust"
            } else {
                ""
            };
            text += &format!("no difference{what}\n");
        }
        text
    }

    /// The changes as JSON: `{"old", "new", "breaking", "changes": [{"group", "kind", "breaking", "item", "text", "from", "to",
    /// "frame", "old", "new"}]}`.
    fn as_json(&self, changes: &[Change], places: &Places<'_>) -> String {
        let list: Vec<Value> = changes.iter().map(|change| change_json(change, places)).collect();
        let value = json!({
            "old": self.old.display().to_string(),
            "new": self.new.display().to_string(),
            "breaking": changes.iter().any(|change| change.breaking),
            "changes": list,
        });
        format!("{value:#}\n")
    }
}

fn title(group: Group, breaking: bool) -> &'static str {
    match (group, breaking) {
        (Group::Wire, true) => "breaks the wire",
        (Group::Wire, false) => "new on the wire, and compatible",
        (Group::Enums, true) => "breaks enums",
        (Group::Enums, false) => "new in enums, and compatible",
        (Group::Api, true) => "breaks Rust code",
        (Group::Api, false) => "new in Rust, and compatible",
        (Group::Metadata, _) => "neither on the wire nor in Rust",
    }
}

fn change_json(change: &Change, places: &Places<'_>) -> Value {
    let pair = |(old, new): (u8, u8)| json!({ "from": old, "to": new });
    let frame = change.frame.map(|frame| {
        json!({ "crc_extra": pair(frame.crc_extra), "len_v1": pair(frame.len_v1), "len_v2": pair(frame.len_v2) })
    });
    json!({
        "group": change.group().name(),
        "kind": change.kind.name(),
        "breaking": change.breaking,
        "item": change.item,
        "text": change.to_string(),
        "from": change.from,
        "to": change.to,
        "frame": frame,
        "old": change.old.and_then(|span| place_json(places.old, span)),
        "new": change.new.and_then(|span| place_json(places.new, span)),
    })
}

fn place_json(sources: &Sources, span: Span) -> Option<Value> {
    let file = sources.get(span.file)?;
    let position = file.position(span.start);
    Some(json!({ "file": file.path().display().to_string(), "line": position.line, "column": position.column }))
}

/// The texts that the places of changes point into.
struct Places<'a> {
    old: &'a Sources,
    new: &'a Sources,
}

impl Places<'_> {
    /// `old.xml:3:5 -> new.xml:4:5`, or the one place there is.
    fn of(&self, change: &Change) -> String {
        let old = change.old.and_then(|span| place(self.old, span));
        let new = change.new.and_then(|span| place(self.new, span));
        match (old, new) {
            (Some(old), Some(new)) => format!("{old} -> {new}"),
            (old, new) => old.or(new).unwrap_or_else(|| "the whole dialect".to_owned()),
        }
    }
}

fn place(sources: &Sources, span: Span) -> Option<String> {
    let file = sources.get(span.file)?;
    let position = file.position(span.start);
    Some(format!("{}:{}:{}", file.path().display(), position.line, position.column))
}

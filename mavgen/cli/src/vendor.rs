//! `mavgen vendor`.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use mavgen::Failure;
use mavgen::vendor::{Copy, Prose, Retained, Vendored, Written, vendor, write};

use super::input::{Definitions, concerning, concerning_failure, file, folder};
use super::report::{Report, plural};

/// Copies a dialect and its includes into one folder.
///
/// Each copy begins with a comment that names the file it was made of and that file's SHA-256. Below that it is the same
/// text, but for includes, which lead to the one folder. Two files of the same name are an error.
///
/// With --no-prose the copies carry the facts alone: names, ids, types, order, values, units, ranges, labels, flags and stages
/// of life. With --prose-from they also carry descriptions and comments, those of the files in another folder or, to take
/// over a new state of the definitions, of the very files that are written anew.
///
/// With --messages the copies have only these messages and what they need; all files stay. A message that decides how wide a
/// needed enum is, or what it is called in Rust, stays as well, and that is said.
///
/// Nothing is written before everything is read, and nothing that a person wrote is lost: files that are no copies are never
/// touched, no file is removed, and a copy that was edited is not written over. In copies of facts, descriptions and comments
/// may be written, and are kept by --prose-from.
#[derive(Args)]
#[command(after_help = "\
Examples:
  mavgen vendor mavlink/message_definitions/v1.0/ardupilotmega.xml --out xml
  mavgen vendor upstream/common.xml --out xml --messages 'HEARTBEAT,PARAM_*'
  mavgen vendor upstream/common.xml --out xml --prose-from xml
  mavgen vendor acme.xml --include-dir upstream --out xml --deny-warnings")]
pub(super) struct Vendor {
    /// The dialect's XML file.
    #[arg(value_parser = file())]
    xml: PathBuf,
    /// The folder for the copies.
    #[arg(long, value_name = "DIR", value_parser = folder())]
    out: PathBuf,
    #[command(flatten)]
    definitions: Definitions,
    /// Leave descriptions and comments behind.
    #[arg(long)]
    no_prose: bool,
    /// Take descriptions and comments from the files of the same names in this folder, each by the name of what it is about.
    #[arg(long, value_name = "DIR", conflicts_with = "no_prose")]
    prose_from: Option<PathBuf>,
    /// With --prose-from: name everything that has no description, not only what is new.
    #[arg(long, requires = "prose_from")]
    all: bool,
}

impl Vendor {
    pub(super) fn run(&self, report: &Report) -> Result<ExitCode, Failure> {
        let prose = match &self.prose_from {
            Some(folder) => Prose::From(folder.clone()),
            None if self.no_prose => Prose::Drop,
            None => Prose::Keep,
        };
        let builder = self.definitions.builder(&self.xml);
        let vendored = vendor(&builder, &prose).map_err(|failure| concerning_failure(&builder, failure))?;
        let warnings = concerning(&builder, &vendored.diagnostics, &vendored.sources);
        report.diagnostics(&warnings, &vendored.sources);
        let Written { written, kept, others } = write(&self.out, &vendored).map_err(Failure::Output)?;
        report.note(&format!("{}: {} written, {kept} kept", self.out.display(), plural(written, "file")));
        for Retained { name, why } in &vendored.retained {
            report.note(&format!("also copied: {name}: {why}"));
        }
        for other in others {
            report.note(&format!("{}: left alone, not a file of this dialect", other.display()));
        }
        if self.prose_from.is_some() {
            self.descriptions(&vendored, report);
        }
        Ok(ExitCode::SUCCESS)
    }

    /// Says what lacks a description, and which ones found no place.
    fn descriptions(&self, Vendored { files, unplaced, left_out, .. }: &Vendored, report: &Report) {
        for lost in unplaced {
            let (file, name, words) = (lost.file.display(), &lost.name, &lost.words);
            report.note(&format!("{file}: no longer in the definitions: {name}: {words}"));
        }
        for Copy { name: file, items, .. } in files {
            for item in items.iter().filter(|item| !item.described && (item.new || self.all)) {
                let new = if item.new { "new, and " } else { "" };
                report.note(&format!("{}: {new}without a description: {}", self.out.join(file).display(), item.name));
            }
        }
        let items = || files.iter().flat_map(|file| &file.items);
        let (all, without) = (items().count(), items().filter(|item| !item.described).count());
        let new = items().filter(|item| !item.described && item.new).count();
        let lost = unplaced.len();
        report.note(&format!(
            "{without} of {all} items have no description, {new} of them new; {lost} descriptions found no place"
        ));
        if !left_out.is_empty() {
            report.note(&format!("{} of what is left out were not copied", plural(left_out.len(), "description")));
        }
    }
}

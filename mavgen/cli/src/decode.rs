//! `mavgen decode`: what is in a recording or a stream, by any definitions, without compiling anything.

mod choice;
mod columns;
mod csv;
mod folder;
mod hex;
mod json;
#[cfg(feature = "parquet")]
mod parquet;
mod received;
mod source;
mod stream;
mod text;

use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use mavgen::Failure;
use mavgen::decode::{Tables, contents};
use mavgen::ir::Dialect;

use super::input::{Reading, folder, resolve};
use super::report::{Report, plural};
use choice::Choice;
use columns::Columns;
use folder::Folder;
use received::Received;
use source::Layout;

/// Prints the messages of a recording or a stream: times, senders, fields with units and names of enums, packed bits.
///
/// What a sender does not know is `unknown`, null in JSON, empty in CSV. A message that the definitions do not have, or have
/// otherwise, is shown as hexadecimal digits and unverified. What is no frame is skipped, and counted at the end.
///
/// A parameter is shown with what it can be by its type: read byte for byte from the float that carries it, as PX4 sends it,
/// and as a number cast to a float, as ArduPilot does.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub(super) struct Decode {
    /// The dialect's XML file.
    xml: PathBuf,
    #[command(flatten)]
    reading: Reading,
    /// What to decode; standard input if it is `-` or not given.
    file: Option<PathBuf>,
    /// What it holds.
    #[arg(long = "input", value_enum, default_value_t = Layout::Auto, value_name = "LAYOUT")]
    layout: Layout,
    /// What to print.
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// A folder for a table of each message: for CSV instead of one table on standard output, for Parquet always.
    #[arg(long, value_name = "DIR", value_parser = folder())]
    out: Option<PathBuf>,
    #[command(flatten)]
    choice: Choice,
}

const AFTER_HELP: &str = "\
Examples:
  mavgen decode xml/acme.xml --overlay xml/overlay/acme.xml flight.tlog
  mavgen decode xml/acme.xml flight.tlog --fields roll,pitch
  mavgen decode xml/acme.xml flight.tlog --format csv --out tables
  mavgen decode xml/acme.xml flight.tlog --format csv --message ATTITUDE
  mavgen decode xml/acme.xml flight.tlog --format parquet --out tables/flight
  mavgen decode xml/acme.xml flight.tlog --format json | jq .message.type
  echo fe0900010100000000000608000403 9043 |
    mavgen decode xml/acme.xml --format json";

/// What is printed.
#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// A line for each message, and one for each view and slot of packed bits.
    Text,
    /// An object on a line of its own for each message.
    Json,
    /// A table: of the one message that `--messages` names, or with `--out` of each.
    Csv,
    /// Typed tables in a folder, for DuckDB, Polars, Spark and their like; needs the feature `parquet` of mavgen-cli.
    Parquet,
}

impl Decode {
    pub(super) fn run(&self, report: &Report) -> Result<ExitCode, Failure> {
        if source::is_recording(&self.xml) {
            return Err(Failure::Usage(self.without_dialect()));
        }
        let resolved = resolve(&self.reading.whole(&self.xml), report)?;
        let asked = self.reading.definitions.messages.as_ref();
        let wanted = asked.map(|names| resolved.message_ids(names)).transpose()?;
        let mut printer = self.printer(&resolved.dialect, wanted)?;
        let file = self.file.as_deref().filter(|file| *file != Path::new("-"));
        let name = file.map_or_else(|| "standard input".to_owned(), |file| file.display().to_string());
        let refused = |error: io::Error| Failure::Usage(format!("{name}: {error}"));
        let mut stream = source::open(file, self.layout, printer.tables.table()).map_err(refused)?;
        let mut out = io::stdout().lock();
        let mut print = |text: String| match out.write_all(text.as_bytes()) {
            Ok(()) => Ok(true),
            // A reader that has seen enough, like `head`, is no error.
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
            Err(error) => Err(Failure::Usage(format!("standard output: {error}"))),
        };
        if !print(printer.head())? {
            return Ok(ExitCode::SUCCESS);
        }
        loop {
            match stream.next() {
                Ok(Some(received)) if print(printer.lines(&received)?)? => {}
                Ok(Some(_)) => return Ok(ExitCode::SUCCESS),
                Ok(None) => break,
                // Much of it was no frame; there may be more.
                Err(error) if error.kind() == ErrorKind::WouldBlock => {}
                Err(error) => return Err(refused(error)),
            }
        }
        stream.tally().lines(printer.tables.table()).iter().for_each(|line| report.note(line));
        let tables = match printer.style {
            Style::Folder(folder) => Some(folder.finish()?),
            Style::Text | Style::Json | Style::Csv(_) => None,
        };
        if let (Some(tables), Some(out)) = (tables, &self.out) {
            report.note(&format!("{}: {} written", out.display(), plural(tables, "table")));
        }
        Ok(ExitCode::SUCCESS)
    }

    fn printer<'p>(&'p self, dialect: &'p Dialect, wanted: Option<Vec<u32>>) -> Result<Printer<'p>, Failure> {
        let columns: Vec<(String, Columns)> = dialect
            .messages
            .iter()
            .filter(|message| wanted.as_ref().is_none_or(|wanted| wanted.contains(&message.id)))
            .map(|message| (message.name.text.clone(), Columns::of(message)))
            .collect();
        let (fields, views): (Vec<_>, Vec<_>) = columns.iter().map(|(_, columns)| columns.names()).unzip();
        self.choice.check(&fields.concat(), &views.concat())?;
        let chosen = columns.into_iter().map(|(name, columns)| (name, columns.chosen(&self.choice)));
        let chosen: Vec<_> = chosen.filter(|(_, columns)| !columns.is_empty()).collect();
        let style = match (self.format, &self.out) {
            (Format::Text | Format::Json, Some(_)) => {
                return Err(Failure::Usage("--out is for tables: give --format csv or parquet, too".to_owned()));
            }
            (Format::Text, None) => Style::Text,
            (Format::Json, None) => Style::Json,
            (Format::Csv, None) => Style::Csv(only(chosen)?),
            (Format::Csv, Some(out)) => Style::Folder(Box::new(Folder::<csv::Csv>::new(out, chosen))),
            (Format::Parquet, None) => {
                return Err(Failure::Usage("Parquet is written to files: give --out a folder for them".to_owned()));
            }
            #[cfg(feature = "parquet")]
            (Format::Parquet, Some(out)) => Style::Folder(Box::new(Folder::<parquet::Parquet>::new(out, chosen))),
            #[cfg(not(feature = "parquet"))]
            (Format::Parquet, Some(_)) => {
                return Err(Failure::Usage(
                    "this mavgen is built without the feature `parquet` of mavgen-cli: install it with --features parquet".to_owned(),
                ));
            }
        };
        Ok(Printer { dialect, tables: Tables::leak(dialect), wanted, choice: &self.choice, style })
    }

    /// What is said where a recording is named in the place of the dialect.
    fn without_dialect(&self) -> String {
        let recording = self.xml.display();
        let dialect = self.file.as_ref().map_or("xml/common.xml".into(), |file| file.display().to_string());
        format!("`{recording}` is not a dialect's XML file, which is named first: mavgen decode {dialect} {recording}")
    }
}

/// Makes text of frames.
struct Printer<'p> {
    dialect: &'p Dialect,
    tables: Tables,
    wanted: Option<Vec<u32>>,
    choice: &'p Choice,
    style: Style,
}

/// What the text looks like.
enum Style {
    Text,
    Json,
    Csv(Columns),
    /// Tables in files, and no text.
    Folder(Box<dyn folder::Tables>),
}

impl Printer<'_> {
    /// What comes before all frames.
    fn head(&self) -> String {
        match &self.style {
            Style::Csv(columns) => columns.head(),
            _ => String::new(),
        }
    }

    /// The lines of a frame; none if nobody asked for it.
    fn lines(&mut self, received: &Received<'_>) -> Result<String, Failure> {
        let frame = &received.frame;
        if self.wanted.as_ref().is_some_and(|wanted| !frame.is_verified() || !wanted.contains(&frame.message_id())) {
            return Ok(String::new());
        }
        let Some(reflected) = self.tables.reflect(frame) else {
            return Ok(match &self.style {
                _ if self.choice.is_of_fields() => String::new(),
                Style::Text => text::unverified(received),
                Style::Json => json::unverified(received),
                _ => String::new(),
            });
        };
        let (name, contents) = (reflected.info().name, contents(self.dialect, &self.tables, &reflected));
        let Some(contents) = self.choice.of(contents) else { return Ok(String::new()) };
        Ok(match &mut self.style {
            Style::Text => text::message(received, name, &contents),
            Style::Json => json::message(received, name, &contents),
            Style::Csv(columns) => columns.row(received, &contents),
            Style::Folder(folder) => {
                folder.add(name, received, &contents)?;
                String::new()
            }
        })
    }
}

/// The columns of the one message that was asked for, or that there is.
fn only(mut chosen: Vec<(String, Columns)>) -> Result<Columns, Failure> {
    match (chosen.pop(), chosen.len()) {
        (Some((_, columns)), 0) => Ok(columns),
        (last, others) => {
            let count = others + usize::from(last.is_some());
            Err(Failure::Usage(format!(
                "a table has the columns of one message, not of {count}: name it with --messages, or give --out a folder for \
                 a table of each"
            )))
        }
    }
}

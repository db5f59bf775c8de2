//! `mavgen decode`: what is in a recording or a stream, by any definitions, without compiling anything.

mod csv;
mod hex;
mod json;
mod received;
mod source;
mod stream;
mod text;

use std::io::{self, ErrorKind, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Args, ValueEnum};
use mavgen::decode::{Tables, contents};
use mavgen::ir::Dialect;
use mavgen::{Failure, Resolved};

use super::input::{Reading, resolve};
use super::report::Report;
use csv::Columns;
use received::Received;
use source::Layout;

/// Prints the messages of a recording or a stream: times, senders, fields with units and names of enums, packed bits.
///
/// What a sender does not know is `unknown`, null in JSON, empty in CSV. A message that the definitions do not have, or have
/// otherwise, is shown as hexadecimal digits and unverified. What is no frame is skipped, and counted at the end.
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
}

const AFTER_HELP: &str = "\
Examples:
  mavgen decode xml/acme.xml --overlay xml/overlay/acme.xml flight.tlog
  mavgen decode xml/acme.xml flight.tlog --format csv --messages ATTITUDE > attitude.csv
  echo 'fe 09 00 01 01 00 00 00 00 00 06 08 00 04 03 90 43' | mavgen decode xml/acme.xml --format json";

/// What is printed.
#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// A line for each message, and one for each view and slot of packed bits.
    Text,
    /// An object on a line of its own for each message.
    Json,
    /// A table of one message, which `--messages` names.
    Csv,
}

impl Decode {
    pub(super) fn run(&self, report: &Report) -> Result<ExitCode, Failure> {
        if source::is_recording(&self.xml) {
            return Err(Failure::Usage(self.without_dialect()));
        }
        let Resolved { dialect, .. } = resolve(&self.reading.whole(&self.xml), report)?;
        let wanted = self.wanted()?;
        let printer = Printer::new(self.format, &dialect, wanted)?;
        let name = self.file.as_ref().map_or_else(|| "standard input".to_owned(), |file| file.display().to_string());
        let refused = |error: io::Error| Failure::Usage(format!("{name}: {error}"));
        let mut stream = source::open(self.file.as_deref(), self.layout, printer.tables.table()).map_err(refused)?;
        let mut out = io::stdout().lock();
        let mut print = |text: String| match out.write_all(text.as_bytes()) {
            Ok(()) => Ok(true),
            // A reader that has seen enough, like `head`, is no error.
            Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(false),
            Err(error) => Err(Failure::Usage(format!("standard output: {error}"))),
        };
        let mut listens = print(printer.head())?;
        while listens && let Some(received) = stream.next().map_err(refused)? {
            listens = print(printer.lines(&received))?;
        }
        stream.tally().lines(printer.tables.table()).iter().for_each(|line| report.note(line));
        Ok(ExitCode::SUCCESS)
    }

    /// What is said where a recording is named in the place of the dialect.
    fn without_dialect(&self) -> String {
        let recording = self.xml.display();
        let dialect = self.file.as_ref().map_or("xml/common.xml".into(), |file| file.display().to_string());
        format!("`{recording}` is not a dialect's XML file, which is named first: mavgen decode {dialect} {recording}")
    }

    /// The ids of the messages that were asked for; `None` for all.
    fn wanted(&self) -> Result<Option<Vec<u32>>, Failure> {
        if self.reading.definitions.messages.is_none() {
            return Ok(None);
        }
        let chosen = self.reading.builder(&self.xml).resolve()?.dialect;
        Ok(Some(chosen.messages.iter().map(|message| message.id).collect()))
    }
}

/// Makes text of frames.
struct Printer<'d> {
    dialect: &'d Dialect,
    tables: Tables,
    wanted: Option<Vec<u32>>,
    style: Style,
}

/// What the text looks like.
enum Style {
    Text,
    Json,
    Csv(Columns),
}

impl<'d> Printer<'d> {
    fn new(format: Format, dialect: &'d Dialect, wanted: Option<Vec<u32>>) -> Result<Self, Failure> {
        let style = match format {
            Format::Text => Style::Text,
            Format::Json => Style::Json,
            Format::Csv => Style::Csv(columns(dialect, wanted.as_deref())?),
        };
        Ok(Self { dialect, tables: Tables::leak(dialect), wanted, style })
    }

    /// What comes before all frames.
    fn head(&self) -> String {
        match &self.style {
            Style::Text | Style::Json => String::new(),
            Style::Csv(columns) => columns.head(),
        }
    }

    /// The lines of a frame; none if nobody asked for it.
    fn lines(&self, received: &Received<'_>) -> String {
        let frame = &received.frame;
        if self.wanted.as_ref().is_some_and(|wanted| !frame.is_verified() || !wanted.contains(&frame.message_id())) {
            return String::new();
        }
        let Some(reflected) = self.tables.reflect(frame) else {
            return match &self.style {
                Style::Text => text::unverified(received),
                Style::Json => json::unverified(received),
                Style::Csv(_) => String::new(),
            };
        };
        let contents = contents(self.dialect, &self.tables, &reflected);
        match &self.style {
            Style::Text => text::message(received, &reflected, &contents),
            Style::Json => json::message(received, &reflected, &contents),
            Style::Csv(columns) => columns.row(received, &contents),
        }
    }
}

/// The columns of the one message that was asked for, or that there is.
fn columns(dialect: &Dialect, wanted: Option<&[u32]>) -> Result<Columns, Failure> {
    let is_wanted = |id| wanted.is_none_or(|wanted| wanted.contains(&id));
    let mut messages = dialect.messages.iter().filter(|message| is_wanted(message.id));
    match (messages.next(), messages.count()) {
        (Some(message), 0) => Ok(Columns::of(message)),
        (first, others) => {
            let count = others + usize::from(first.is_some());
            let text = format!("a table has the columns of one message, not of {count}: name it with --messages");
            Err(Failure::Usage(text))
        }
    }
}

//! The arguments that commands share: what to read, and where to write.

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PathBufValueParser, TypedValueParser};
use mavgen::diag::{Diagnostic, Diagnostics, Severity};
use mavgen::source::Sources;
use mavgen::{Builder, Commands, Failure, Resolved, Topics};

use super::report::Report;

/// A file of definitions: no single stream, as it names others beside it.
pub(super) fn file() -> impl TypedValueParser<Value = PathBuf> {
    named("definitions are read from a file, not from standard input, because they name others that lie beside it")
}

/// A folder for files.
pub(super) fn folder() -> impl TypedValueParser<Value = PathBuf> {
    named("files are written into a folder, not to standard output")
}

/// A path that is not `-`.
fn named(why: &'static str) -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(move |path| match path == Path::new("-") {
        true => Err(format!("{why}; `./-` is one of that name")),
        false => Ok(path),
    })
}

/// The definitions.
#[derive(Args)]
pub(super) struct Input {
    /// The dialect's XML file; several are the dialects of one tree, with a module for each. Or a folder of PX4's `.msg` files,
    /// or some files of one folder: uORB messages.
    #[arg(required = true, value_parser = file())]
    pub(super) xml: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) reading: Reading,
    /// An older definition of the uORB messages: what it is called, and its folder of `.msg` files; may be given several times,
    /// newest first.
    #[arg(long, value_name = "NAME=DIR")]
    pub(super) older: Vec<String>,
    /// What the dialect or the uORB messages are called together, if not as their file or folder; of several dialects, what
    /// their tree is called.
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// What the newest definition of the uORB messages is called, if not as its folder: the constant of each message.
    #[arg(long, value_name = "NAME")]
    pub(super) definition: Option<String>,
}

/// How definitions are read, and what overlays add to them.
#[derive(Args, Clone)]
pub(super) struct Reading {
    #[command(flatten)]
    pub(super) definitions: Definitions,
    /// A file that says what the XML cannot, like the meaning of packed bits; may be given several times.
    #[arg(long, value_name = "FILE", value_parser = file())]
    pub(super) overlay: Vec<PathBuf>,
}

/// How definitions are read: what every command has.
#[derive(Args, Clone)]
pub(super) struct Definitions {
    /// Where to look for includes that do not lie beside the file that names them; may be given several times.
    #[arg(long, value_name = "DIR")]
    include_dir: Vec<PathBuf>,
    /// Only these messages and what they need: names separated by commas; in a pattern, a star stands for any characters. A
    /// name that means no message is an error.
    #[arg(long, visible_alias = "message", value_name = "NAME,PREFIX_*", value_delimiter = ',')]
    pub(super) messages: Option<Vec<String>>,
    /// Warnings are errors: those about the files that are named here, not about files that they include, nor about a vendored
    /// copy.
    #[arg(long)]
    pub(super) deny_warnings: bool,
    /// Leave out the warnings of this code, as M313: neither told nor denied; several are separated by commas.
    #[arg(long, value_name = "CODE", value_delimiter = ',')]
    allow: Vec<String>,
}

/// The definitions, and a folder for what becomes of them.
#[derive(Args)]
pub(super) struct Output {
    #[command(flatten)]
    pub(super) input: Input,
    /// The folder for the sources.
    #[arg(long, value_name = "DIR", value_parser = folder())]
    pub(super) out: PathBuf,
    /// When each entry of MAV_CMD has a type: always, never, or feature=NAME, which is only with the cargo feature NAME of
    /// the crate that has the sources. Its Cargo.toml has to declare it: `NAME = []`.
    #[arg(long, value_name = "WHEN", default_value = "always", value_parser = commands)]
    commands: Commands,
}

/// When commands have types.
fn commands(when: &str) -> Result<Commands, String> {
    match (when, when.strip_prefix("feature=")) {
        ("always", _) => Ok(Commands::Always),
        ("never", _) => Ok(Commands::Never),
        (_, Some(name)) => Ok(Commands::Feature(name.to_owned())),
        _ => Err("it is always, never, or feature=NAME".to_owned()),
    }
}

impl Input {
    pub(super) fn builder(&self) -> Result<Builder, Failure> {
        let builder = if self.is_uorb() { self.topics()? } else { self.dialects()? };
        Ok(self.name.iter().fold(builder, |builder, name| builder.name(name)))
    }

    fn dialects(&self) -> Result<Builder, Failure> {
        self.check_dialect()?;
        let (first, others) = self.xml.split_first().map_or((Path::new(""), &[][..]), |(xml, rest)| (xml, rest));
        Ok(others.iter().fold(self.reading.builder(first), |builder, xml| builder.root(xml)))
    }
}

impl Reading {
    pub(super) fn builder(&self, xml: &Path) -> Builder {
        self.overlaid(self.definitions.builder(xml))
    }

    /// The builder of all messages.
    pub(super) fn whole(&self, xml: &Path) -> Builder {
        self.overlaid(self.definitions.whole(xml))
    }

    fn overlaid(&self, builder: Builder) -> Builder {
        self.overlay.iter().fold(builder, |builder, file| builder.overlay(file))
    }
}

impl Definitions {
    pub(super) fn builder(&self, xml: &Path) -> Builder {
        self.messages.iter().fold(self.whole(xml), |builder, names| builder.messages(names))
    }

    fn whole(&self, xml: &Path) -> Builder {
        let builder = Builder::new(xml).deny_warnings(self.deny_warnings);
        let builder = self.include_dir.iter().fold(builder, |builder, folder| builder.include_dir(folder));
        self.allow.iter().fold(builder, |builder, code| builder.allow(code))
    }
}

/// Reads and resolves, and shows what concerns the user.
///
/// Warnings about somebody else's files and notes are for `mavgen lint`: they would be in the way of everything else.
pub(super) fn resolve(builder: &Builder, report: &Report) -> Result<Resolved, Failure> {
    let resolved = resolve_silently(builder)?;
    report.diagnostics(&concerning(builder, &resolved.diagnostics, &resolved.sources), &resolved.sources);
    Ok(resolved)
}

/// As [`resolve`], uORB messages.
pub(super) fn resolve_topics(builder: &Builder, report: &Report) -> Result<Topics, Failure> {
    let topics = builder.topics().map_err(|failure| concerning_failure(builder, failure))?;
    report.diagnostics(&concerning(builder, &topics.diagnostics, &topics.sources), &topics.sources);
    Ok(topics)
}

/// Reads and resolves what the user will not mend: its warnings are not shown.
pub(super) fn resolve_silently(builder: &Builder) -> Result<Resolved, Failure> {
    builder.resolve().map_err(|failure| concerning_failure(builder, failure))
}

/// A failure without what does not concern the user.
pub(super) fn concerning_failure(builder: &Builder, failure: Failure) -> Failure {
    match failure {
        Failure::Definitions(mut problems) => {
            problems.diagnostics = concerning(builder, &problems.diagnostics, &problems.sources);
            Failure::Definitions(problems)
        }
        other => other,
    }
}

/// All errors, and the warnings about what the user wrote.
pub(super) fn concerning(builder: &Builder, diagnostics: &Diagnostics, sources: &Sources) -> Diagnostics {
    let concerns = |diagnostic: &&Diagnostic| match diagnostic.severity() {
        Severity::Error => true,
        Severity::Warning => builder.concerns(diagnostic, sources),
        Severity::Note => false,
    };
    let mut list = Diagnostics::default();
    list.extend(diagnostics.iter().filter(concerns).cloned());
    list
}

impl Output {
    pub(super) fn builder(&self) -> Result<Builder, Failure> {
        Ok(self.input.builder()?.out_dir(&self.out).commands(self.commands.clone()).formatted(true))
    }
}

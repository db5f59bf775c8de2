//! The library's front door: from a path to a resolved dialect, to files, to a build script.

mod failure;
mod provenance;
#[cfg(feature = "uorb")]
mod topics;
mod warnings;

use std::path::{Path, PathBuf};

use crate::collect::CollectVec as _;
use crate::emit::{GeneratedFile, emit, is_path};
use crate::format::Layout;
use crate::internal::Internal;
use crate::lower::{Commands, Options, is_feature, tree, tree_of_several};
use crate::output::{Differences, Report, check, write};
use crate::problems::Problems;
use crate::read::load_all;
use crate::resolved::Resolved;
use crate::roots::{self, Named};
use crate::select::Selection;
use crate::source::Sources;

pub use failure::Failure;
use provenance::provenance;
#[cfg(feature = "uorb")]
pub use topics::Topics;

/// Generates Rust from a dialect.
///
/// ```no_run
/// // build.rs
/// mavgen::Builder::new("xml/acme.xml").build_script();
/// ```
///
/// ```no_run
/// // Sources in a repository, and the test that holds them current.
/// let builder = mavgen::Builder::new("xml/acme.xml").out_dir("src/acme");
/// builder.generate().unwrap();
/// let differences = builder.check().unwrap();
/// assert!(differences.is_empty(), "{differences}");
/// ```
#[derive(Clone, Debug)]
pub struct Builder {
    pub(crate) roots: Vec<PathBuf>,
    name: Option<String>,
    pub(crate) include_dirs: Vec<PathBuf>,
    pub(crate) overlays: Vec<PathBuf>,
    messages: Option<Vec<String>>,
    #[cfg(feature = "uorb")]
    older: Vec<(String, PathBuf)>,
    #[cfg(feature = "uorb")]
    definition: Option<String>,
    pub(crate) out_dir: Option<PathBuf>,
    runtime: String,
    layout: Layout,
    deprecated: bool,
    commands: Commands,
    pub(crate) deny_warnings: bool,
    allowed: Vec<String>,
    lint: bool,
}

impl Builder {
    /// A builder for the dialect in this file; or, with the feature `uorb`, for the uORB messages in this folder of `.msg`
    /// files, or in this one and what it nests.
    pub fn new(xml: impl Into<PathBuf>) -> Self {
        Self {
            roots: vec![xml.into()],
            name: None,
            include_dirs: Vec::new(),
            overlays: Vec::new(),
            messages: None,
            #[cfg(feature = "uorb")]
            older: Vec::new(),
            #[cfg(feature = "uorb")]
            definition: None,
            out_dir: None,
            runtime: "::mavlink_wire".to_owned(),
            layout: Layout::default(),
            deprecated: true,
            commands: Commands::Always,
            deny_warnings: false,
            allowed: Vec::new(),
            lint: false,
        }
    }

    /// Adds another dialect to the same tree: each has its own module, its own type over all messages and its own table.
    ///
    /// Messages of one definition are one type, and enums of one name, width and kind are one type with the constants of
    /// all, so that code over them works for every dialect. What differs under one name is a type in each module: a message
    /// with another field, an enum in which an entry has another value (M800).
    ///
    /// ```no_run
    /// // `mavlink_wire::include_dialect!("dialects")` gives the modules dialects::acme and dialects::ardupilotmega.
    /// mavgen::Builder::new("xml/acme.xml").root("xml/ardupilotmega.xml").build_script();
    /// ```
    #[must_use]
    pub fn root(mut self, xml: impl Into<PathBuf>) -> Self {
        self.roots.push(xml.into());
        self
    }

    /// Names the dialect; without this it is called after its file. `acme` gives the module `acme` and the type `Acme`.
    ///
    /// With several dialects it names the module around theirs, which otherwise is `dialects`.
    #[must_use]
    pub fn name(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }

    /// Adds a folder where includes are looked for that do not lie beside the file that names them.
    #[must_use]
    pub fn include_dir(mut self, folder: impl Into<PathBuf>) -> Self {
        self.include_dirs.push(folder.into());
        self
    }

    /// Adds an overlay: a file that says what the dialect's XML cannot, like the meaning of packed bits. It changes nothing
    /// on the wire. With several dialects it applies to those that include the file that it is for.
    #[must_use]
    pub fn overlay(mut self, path: impl Into<PathBuf>) -> Self {
        self.overlays.push(path.into());
        self
    }

    /// Keeps only these messages, and what they need: their views, and the enums that their fields and those of their
    /// commands name. What is kept is what it is in the whole dialect, to the byte.
    ///
    /// A name is that of the XML, `HEARTBEAT`; in a pattern, `PARAM_*`, a star stands for any characters. One that means no
    /// message is a [`Failure::Usage`]. Calls add up.
    ///
    /// ```no_run
    /// // build.rs of firmware that sends two messages and understands the parameter protocol
    /// mavgen::Builder::new("xml/common.xml").messages(["HEARTBEAT", "STATUSTEXT", "PARAM_*"]).build_script();
    /// ```
    #[must_use]
    pub fn messages<N: Into<String>>(mut self, names: impl IntoIterator<Item = N>) -> Self {
        self.messages.get_or_insert_default().extend(names.into_iter().map(Into::into));
        self
    }

    /// Where [`Builder::generate`] writes. In a build script that need not be said: there it is a folder in `OUT_DIR`.
    #[must_use]
    pub fn out_dir(mut self, folder: impl Into<PathBuf>) -> Self {
        self.out_dir = Some(folder.into());
        self
    }

    /// The path by which generated code finds the runtime; without this `::mavlink_wire`.
    #[must_use]
    pub fn runtime_path(mut self, path: impl Into<String>) -> Self {
        self.runtime = path.into();
        self
    }

    /// Whether `<deprecated>` becomes `#[deprecated]` (the default), or is only said in the documentation.
    #[must_use]
    pub fn deprecated(mut self, attribute: bool) -> Self {
        self.deprecated = attribute;
        self
    }

    /// Whether each entry of `MAV_CMD` becomes a type in the module `commands`, if the dialect has a message that carries
    /// commands, `COMMAND_LONG` or `COMMAND_INT`: always (without this), never, or with a cargo feature of the crate that has the
    /// sources. Those of `common.xml` add an eighth to the time in which the sources compile.
    ///
    /// ```no_run
    /// // build.rs of a crate with `commands = []` among the features of its Cargo.toml
    /// mavgen::Builder::new("xml/acme.xml").commands(mavgen::Commands::Feature("commands".into())).build_script();
    /// ```
    ///
    /// The files are the same with the feature and without it, so that sources in a repository serve both; the compiler leaves
    /// the module out. A name that cargo does not take is a [`Failure::Usage`].
    #[must_use]
    pub fn commands(mut self, types: Commands) -> Self {
        self.commands = types;
        self
    }

    /// Whether a formatter lays the sources out, as `mavgen generate` does, for people who commit and review them. Without
    /// this, a statement is a line and a field is a line, however long: that takes a third of the time, and no dependency.
    ///
    /// The sources are the same otherwise. [`Builder::check`] has to be told what [`Builder::generate`] was told.
    #[cfg(feature = "format")]
    #[must_use]
    pub fn formatted(mut self, formatted: bool) -> Self {
        self.layout = if formatted { Layout::Formatted } else { Layout::Lines };
        self
    }

    /// Reads, resolves and selects; writes nothing.
    ///
    /// # Errors
    /// [`Failure::Definitions`] with every problem, [`Failure::Denied`] if [`Builder::deny_warnings`] was asked for and there
    /// are some, [`Failure::Usage`] if [`Builder::messages`] or [`Builder::allow`] names what there is not, if a dialect is
    /// given twice, or if several are given a name that is none for a module.
    pub fn resolve(&self) -> Result<Resolved, Failure> {
        if self.is_uorb() {
            let root = self.roots.first().map_or(String::new(), |root| root.display().to_string());
            let needed = if cfg!(feature = "uorb") {
                "a dialect's XML file is needed"
            } else {
                "turn on mavgen's feature `uorb`"
            };
            return Err(Failure::Usage(format!("`{root}` has uORB messages: {needed}")));
        }
        let (selection, tree) = (self.selection()?, self.name.as_deref().unwrap_or(roots::TREE));
        if let Some(conflict) = roots::conflict(&self.roots, tree) {
            return Err(Failure::Usage(conflict));
        }
        let (mut sources, mut diagnostics) = (Sources::default(), self.diagnostics()?);
        let mut all = load_all(&self.roots, &self.include_dirs, &self.overlays, &mut sources, &mut diagnostics);
        if let ([only], Some(name)) = (all.as_mut_slice(), &self.name) {
            only.name.clone_from(name);
        }
        let mut dialects = roots::resolve_all(&all, tree, &sources, &mut diagnostics);
        if let Some(selection) = selection.filter(|_| !dialects.is_empty()) {
            selection.check(&dialects.iter().map(|named| &named.dialect).collect_vec()).map_err(Failure::Usage)?;
            dialects.iter_mut().for_each(|named| named.select(&selection));
        }
        let union = roots::link_all(&dialects, &all, tree, &mut diagnostics)?;
        let watched = roots::watched(all);
        let Problems { diagnostics, sources, watched } = self.judged(Problems { diagnostics, sources, watched })?;
        let mut dialects = dialects.into_iter();
        let Some(Named { dialect, names }) = dialects.next() else {
            return Err(Internal::new("a dialect without errors is not resolved").into());
        };
        let others = dialects.map(|named| named.dialect).collect_vec();
        Ok(Resolved { dialect, others, names, union, diagnostics, sources, watched })
    }

    /// Generates into memory.
    ///
    /// # Errors
    /// As [`Builder::resolve`]; [`Failure::Usage`] if the runtime path is not a path, or the feature of
    /// [`Builder::commands`] has no name that cargo takes.
    pub fn files(&self) -> Result<Vec<GeneratedFile>, Failure> {
        #[cfg(feature = "uorb")]
        if self.is_uorb() {
            return self.emit_topics(&self.topics()?);
        }
        self.emit(&self.resolve()?)
    }

    /// Generates into the output folder: see [`Builder::out_dir`].
    ///
    /// # Errors
    /// As [`Builder::files`]; [`Failure::Output`] if something cannot be written, [`Failure::Usage`] if no folder is set.
    pub fn generate(&self) -> Result<Report, Failure> {
        write(self.folder()?, &self.files()?).map_err(Failure::Output)
    }

    /// Writes what was resolved into the output folder; [`Builder::generate`] in two steps.
    ///
    /// # Errors
    /// As [`Builder::generate`].
    pub fn write(&self, resolved: &Resolved) -> Result<Report, Failure> {
        write(self.folder()?, &self.emit(resolved)?).map_err(Failure::Output)
    }

    /// Compares the output folder with what would be generated; writes nothing.
    ///
    /// # Errors
    /// As [`Builder::generate`].
    pub fn check(&self) -> Result<Differences, Failure> {
        let files = self.files()?;
        check(self.folder()?, &files).map_err(Failure::Output)
    }

    /// Generates what was resolved into memory; [`Builder::files`] in two steps.
    ///
    /// # Errors
    /// [`Failure::Usage`] as [`Builder::files`], [`Failure::Model`] if somebody changed a model so that it is not legal any
    /// more.
    pub fn emit(&self, resolved: &Resolved) -> Result<Vec<GeneratedFile>, Failure> {
        let options = self.options(&resolved.sources)?;
        let valid = resolved.dialect.validate().map_err(Failure::Model)?;
        for other in &resolved.others {
            other.validate().map_err(Failure::Model)?;
        }
        let files = match &resolved.union {
            Some(union) => tree_of_several(union, &options)?,
            None => tree(valid, &resolved.names, &options)?,
        };
        Ok(emit(&files, self.layout)?)
    }

    /// What a tree that is made of these sources has to know of this builder.
    fn options(&self, sources: &Sources) -> Result<Options, Failure> {
        self.check_options()?;
        let mut sources = provenance(sources);
        if let Some(selection) = self.selection()? {
            sources.push_str(&format!("\n// only {selection}, and what they need"));
        }
        let (runtime, deprecated, commands) = (self.runtime.clone(), self.deprecated, self.commands.clone());
        Ok(Options { runtime, deprecated, commands, sources })
    }

    /// Whether it is for uORB messages, because it was given a folder or a `.msg` file; what else it is given is a dialect, and a
    /// folder that is called `.xml` is a mistake.
    pub fn is_uorb(&self) -> bool {
        let has = |path: &Path, extension| path.extension().is_some_and(|found| found == extension);
        self.roots.iter().any(|path| has(path, "msg") || path.is_dir() && !has(path, "xml"))
    }

    /// Refuses what would stand in the sources and be no Rust.
    fn check_options(&self) -> Result<(), Failure> {
        if !is_path(&self.runtime) {
            return Err(Failure::Usage(format!("`{}` is not a path to a crate or module", self.runtime)));
        }
        match self.commands.feature().filter(|name| !is_feature(name)) {
            None => Ok(()),
            Some(name) => Err(Failure::Usage(format!(
                "`{}` cannot be a cargo feature: a name begins with a letter, a digit or `_`, and goes on with these, `-`, `+` and `.`",
                name.escape_debug()
            ))),
        }
    }

    pub(crate) fn selection(&self) -> Result<Option<Selection>, Failure> {
        let names = self.messages.as_ref().map(|names| Selection::new(names.iter().map(String::as_str)));
        names.transpose().map_err(Failure::Usage)
    }

    fn folder(&self) -> Result<&Path, Failure> {
        self.out_dir.as_deref().ok_or_else(|| Failure::Usage("no output folder: call Builder::out_dir first".into()))
    }
}

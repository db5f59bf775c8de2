//! Which warnings a builder tells, and which of them fail.

use std::path::{Path, PathBuf, absolute};

use super::{Builder, Failure, Problems};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, Severity};
use crate::provenance;
use crate::source::{SourceFile, Sources};

impl Builder {
    /// Whether what concerns those who maintain the definitions for other tools is told as well (off by default): that
    /// pymavlink refuses what mavgen takes.
    #[must_use]
    pub fn lint(mut self, lint: bool) -> Self {
        self.lint = lint;
        self
    }

    /// Whether warnings fail, as [`Failure::Denied`] (off by default).
    ///
    /// Only those that [`Builder::concerns`] says are about what the user of this builder wrote: nobody can mend an upstream
    /// file that a dialect includes.
    #[must_use]
    pub fn deny_warnings(mut self, deny: bool) -> Self {
        self.deny_warnings = deny;
        self
    }

    /// Leaves out the warnings and notes of this code, as `M313`: they are neither told nor denied. Calls add up.
    ///
    /// A code that does not exist, and one of an error, is a [`Failure::Usage`].
    ///
    /// ```no_run
    /// // build.rs
    /// mavgen::Builder::new("xml/acme.xml").deny_warnings(true).allow("M313").build_script();
    /// ```
    #[must_use]
    pub fn allow(mut self, code: impl Into<String>) -> Self {
        self.allowed.push(code.into());
        self
    }

    /// Whether a diagnostic is about what the user of this builder wrote: a dialect's own file, one of the overlays, or no file at all.
    ///
    /// Of uORB messages, those are the files of the newest definition that were read.
    ///
    /// A file that one of those includes is somebody else's. So is a dialect's own file if it begins with the comment of a
    /// vendored copy, or lies in a folder of [`Builder::include_dir`].
    pub fn concerns(&self, diagnostic: &Diagnostic, sources: &Sources) -> bool {
        let Some(file) = diagnostic.span.and_then(|span| sources.get(span.file)) else { return true };
        let is_among = |paths: &[PathBuf], path: &Path| paths.iter().any(|named| named == path);
        let folders = || file.path().ancestors().skip(1);
        let is_message = file.path().extension().is_some_and(|extension| extension == "msg");
        let is_own =
            is_among(&self.roots, file.path()) || is_message && folders().any(|folder| is_among(&self.roots, folder));
        is_among(&self.overlays, file.path()) || is_own && !self.is_upstream(file)
    }

    fn is_upstream(&self, file: &SourceFile) -> bool {
        let folder = |path: &Path| path.canonicalize().or_else(|_| absolute(path)).ok();
        // A path without a folder has the empty one for its parent.
        let beside = file.path().parent().map(|parent| Path::new(".").join(parent));
        let is_beside = |dir: &PathBuf| folder(dir).is_some() && folder(dir) == beside.as_deref().and_then(folder);
        provenance::split(file.text()).is_some() || self.include_dirs.iter().any(is_beside)
    }

    /// Nothing found yet, and later only what this builder tells.
    pub(crate) fn diagnostics(&self) -> Result<Diagnostics, Failure> {
        let allowed = |text: &String| match text.parse::<Code>() {
            Ok(code) if code.severity() == Severity::Error => {
                Err(Failure::Usage(format!("{code} is an error, and only warnings can be allowed: {}", code.title())))
            }
            Ok(code) => Ok(code),
            Err(error) => Err(Failure::Usage(error.to_string())),
        };
        let diagnostics = Diagnostics::leaving_out(self.allowed.iter().map(allowed).try_collect_vec()?);
        Ok(if self.lint { diagnostics.for_lint() } else { diagnostics })
    }

    /// Fails if there are errors, or warnings that are not let pass, with them.
    pub(crate) fn judged(&self, found: Problems) -> Result<Problems, Failure> {
        if found.diagnostics.has_errors() {
            return Err(Failure::Definitions(found.into()));
        }
        let is_denied = |diagnostic: &&Diagnostic| {
            self.deny_warnings
                && diagnostic.severity() == Severity::Warning
                && self.concerns(diagnostic, &found.sources)
        };
        let mut denied = Diagnostics::default();
        denied.extend(found.diagnostics.iter().filter(is_denied).cloned());
        if denied.is_empty() {
            Ok(found)
        } else {
            Err(Failure::Denied(Problems { diagnostics: denied, ..found }.into()))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    /// Something to warn about in each.
    const OWN: &str = "<mavlink colour='red'><include>base.xml</include></mavlink>";
    const BASE: &str = "<mavlink colour='red'/>";
    const VENDORED: &str = "<?xml version='1.0'?>\n<!-- Vendored by mavgen 1, by hand. -->\n";

    /// The files of the warnings that concern the user of a builder.
    fn concerned(builder: &Builder) -> Vec<String> {
        let resolved = builder.resolve().unwrap();
        let own = resolved.diagnostics.iter().filter(|problem| builder.concerns(problem, &resolved.sources));
        own.map(|problem| resolved.sources.get(problem.span.unwrap().file).unwrap().name()).collect()
    }

    #[test]
    fn what_somebody_else_wrote_does_not_concern_the_user() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::write(path("own.xml"), OWN).unwrap();
        fs::write(path("base.xml"), BASE).unwrap();
        fs::write(path("copy.xml"), format!("{VENDORED}{OWN}")).unwrap();
        fs::write(path("o.xml"), "<mavlink-overlay version='1' for='copy.xml' colour='red'/>").unwrap();
        fs::create_dir(path("xml")).unwrap();
        fs::write(path("xml/top.xml"), OWN.replace("base", "own")).unwrap();

        assert_eq!(concerned(&Builder::new(path("own.xml"))), ["own.xml"]);
        assert_eq!(concerned(&Builder::new(path("base.xml"))), ["base.xml"]);
        assert!(concerned(&Builder::new(path("copy.xml"))).is_empty());
        assert_eq!(concerned(&Builder::new(path("copy.xml")).overlay(path("o.xml"))), ["o.xml"]);
        assert_eq!(concerned(&Builder::new(path("copy.xml")).root(path("base.xml"))), ["base.xml"]);
        let included = |builder: Builder| builder.include_dir(path("xml/.."));
        assert_eq!(concerned(&included(Builder::new(path("xml/top.xml")))), ["top.xml"]);
        assert_eq!(concerned(&included(Builder::new(path("xml/top.xml")).root(path("base.xml")))), ["top.xml"]);
    }

    #[test]
    fn a_folder_of_includes_can_be_the_one_of_the_process() {
        let builder = Builder::new("own.xml").include_dir(".");
        let mut sources = Sources::default();
        let id = sources.add("own.xml", OWN);
        assert!(builder.is_upstream(sources.get(id).unwrap()));
        assert!(!Builder::new("own.xml").include_dir("xml").is_upstream(sources.get(id).unwrap()));
    }

    #[test]
    fn what_is_allowed_is_neither_told_nor_denied() {
        let folder = tempfile::tempdir().unwrap();
        let own = folder.path().join("own.xml");
        fs::write(&own, BASE).unwrap();
        let builder = Builder::new(&own).deny_warnings(true);
        assert!(matches!(builder.resolve(), Err(Failure::Denied(_))));
        for spelling in ["M102", "m102", "102"] {
            let resolved = builder.clone().allow(spelling).resolve().unwrap();
            assert!(resolved.diagnostics.is_empty(), "{spelling}");
        }
        assert!(matches!(builder.clone().allow("M103").resolve(), Err(Failure::Usage(_))), "it is an error");
        assert!(matches!(builder.clone().allow("M101").resolve(), Err(Failure::Denied(_))), "it is another code");
        for (code, said) in [
            ("M304", "M304 is an error, and only warnings can be allowed: A field type does not exist."),
            ("M3O4", "there is no diagnostic `M3O4`; did you mean `M304`?"),
            ("", "there is no diagnostic ``; `mavgen explain` lists all"),
        ] {
            assert_eq!(builder.clone().allow(code).resolve().unwrap_err().to_string(), said);
        }
        // Beside an error, too.
        fs::write(&own, "<mavlink colour='red'><messages><message id='1'/></messages></mavlink>").unwrap();
        let refused = builder.allow("M102").resolve().unwrap_err().to_string();
        assert!(refused.contains("M103") && !refused.contains("M102"), "{refused}");
    }
}

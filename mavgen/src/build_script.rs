//! The build script: generates into `OUT_DIR` and tells cargo what it needs to know.

mod place;

use std::path::{PathBuf, absolute};

use crate::builder::{Builder, Failure};
use crate::collect::CollectVec as _;
use crate::diag::{Diagnostic, Severity, Style, render};
use crate::emit::GeneratedFile;
use crate::ir::Dialect;
use crate::lower::MARK;
use crate::lower::link::Union;
use crate::lower::spelling::dialect_module_name;
use crate::output::{write, write_file};
use crate::problems::Problems;
use crate::resolved::Resolved;

use place::{Claim, Place};

impl Builder {
    /// The whole of a `build.rs`: generates into `OUT_DIR` and tells cargo what it needs to know.
    ///
    /// The crate takes the result in with `mavlink_wire::include_dialect!("acme")`, or with the name that
    /// [`Builder::name`] gives; several dialects are `dialects` unless they are given one. Problems are printed as cargo's own
    /// errors and warnings, with file, line and column; errors make cargo fail the build after this returns. Warnings about
    /// somebody else's files are not printed (see [`Builder::concerns`]): they are for those who maintain them.
    ///
    /// A build script can have several builders, each with a name of its own.
    pub fn build_script(&self) {
        for line in self.cargo_directives(&Place::of_process()) {
            println!("{line}");
        }
    }

    fn cargo_directives(&self, place: &Place<'_>) -> Vec<String> {
        #[cfg(feature = "uorb")]
        if self.is_uorb() {
            return self.directives_of(self.topics(), place);
        }
        self.directives_of(self.resolve(), place)
    }

    /// Writes what was resolved, and says what became of it.
    fn directives_of<M: Made>(&self, made: Result<M, Failure>, place: &Place<'_>) -> Vec<String> {
        let (found, failure) = match made {
            Ok(made) => {
                let failure = self.write_out_dir(&made, place).err();
                (made.found(), failure)
            }
            Err(Failure::Definitions(problems) | Failure::Denied(problems)) => (*problems, None),
            Err(failure) => (Problems::default(), Some(failure)),
        };
        // Cargo follows the sources of the build script by itself, wherever they are.
        let watched = found.watched.iter().map(|path| place.for_cargo(path));
        let watched = watched.map(|path| format!("cargo::rerun-if-changed={}", path.display()));
        let failure = failure.map(|failure| format!("cargo::error={failure}"));
        watched.chain(self.for_cargo(&found)).chain(failure).collect_vec()
    }

    /// Writes the tree and the one-line file that `include_dialect!` names.
    fn write_out_dir(&self, made: &impl Made, place: &Place<'_>) -> Result<(), Failure> {
        let out = place
            .out_dir
            .as_deref()
            .ok_or_else(|| Failure::Usage("OUT_DIR is not set: this is no build script".into()))?;
        let module = dialect_module_name(made.name());
        let (tree, path) = match &self.out_dir {
            // Relative paths are relative to the folder of the crate here, and to `OUT_DIR` in the file there.
            Some(folder) => (folder.clone(), absolute(folder).unwrap_or_else(|_| folder.clone()).join("mod.rs")),
            None => (out.join(&module), PathBuf::from(format!("{module}/mod.rs"))),
        };
        let root = self.roots.first().cloned().unwrap_or_default();
        place.builders.claim(Claim { root, module: module.clone(), tree: tree.clone() }).map_err(Failure::Usage)?;
        write(&tree, &made.emit(self)?).map_err(Failure::Output)?;
        let (path, docs) = (path.to_string_lossy(), made.docs());
        let entry_point = format!("{MARK}; do not edit.\n\n/// {docs}\n#[path = {path:?}]\npub mod {module};\n");
        write_file(&out.join(format!("{module}.rs")), &entry_point).map_err(Failure::Output)?;
        Ok(())
    }

    /// Errors, and warnings about what the user wrote, one directive a line; warnings that are denied are errors.
    fn for_cargo(&self, Problems { diagnostics, sources, .. }: &Problems) -> Vec<String> {
        let warning = if self.deny_warnings { "error" } else { "warning" };
        let kind = |diagnostic: &Diagnostic| match diagnostic.severity() {
            Severity::Error => Some("error"),
            Severity::Warning if self.concerns(diagnostic, sources) => Some(warning),
            Severity::Warning | Severity::Note => None,
        };
        let kinds = diagnostics.iter().filter_map(|diagnostic| Some((kind(diagnostic)?, diagnostic)));
        let directives = |(kind, diagnostic): (&str, &Diagnostic)| -> Vec<String> {
            let drawn = render(diagnostic, sources, Style::Plain);
            drawn.lines().map(|line| format!("cargo::{kind}={line}")).collect_vec()
        };
        kinds.flat_map(directives).collect_vec()
    }
}

/// What files are made of: dialects, or uORB messages.
trait Made {
    /// Warnings and notes, what they are about, and what was read.
    fn found(self) -> Problems;

    /// What the module is named after.
    fn name(&self) -> &str;

    /// What stands over the module.
    fn docs(&self) -> String;

    fn emit(&self, builder: &Builder) -> Result<Vec<GeneratedFile>, Failure>;
}

impl Made for Resolved {
    fn found(self) -> Problems {
        Problems { diagnostics: self.diagnostics, sources: self.sources, watched: self.watched }
    }

    fn name(&self) -> &str {
        self.union.as_ref().map_or(&self.dialect.name, |union| &union.all.name)
    }

    fn docs(&self) -> String {
        match &self.union {
            Some(union) => of_several(union),
            None => of_one(&self.dialect, &self.names.dialect),
        }
    }

    fn emit(&self, builder: &Builder) -> Result<Vec<GeneratedFile>, Failure> {
        builder.emit(self)
    }
}

#[cfg(feature = "uorb")]
impl Made for crate::Topics {
    fn found(self) -> Problems {
        Problems { diagnostics: self.diagnostics, sources: self.sources, watched: self.watched }
    }

    fn name(&self) -> &str {
        &self.union.name
    }

    fn docs(&self) -> String {
        crate::lower::topic::about(&self.union)
    }

    fn emit(&self, builder: &Builder) -> Result<Vec<GeneratedFile>, Failure> {
        builder.emit_topics(self)
    }
}

/// What stands over the module of a dialect.
fn of_one(dialect: &Dialect, type_name: &str) -> String {
    if dialect.messages.is_empty() {
        return format!("The `{}` dialect.", dialect.name);
    }
    let (name, module) = (&dialect.name, dialect_module_name(&dialect.name));
    format!("The `{name}` dialect: its messages, its enums, and [`{module}::{type_name}`] over all messages.")
}

/// What stands over the module of several dialects.
fn of_several(union: &Union) -> String {
    let names = union.roots.iter().map(|root| format!("`{}`", root.name)).collect_vec();
    format!("The dialects {}, each in its module, and what they share.", names.join(", "))
}

#[cfg(test)]
mod tests;

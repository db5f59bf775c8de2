//! uORB messages as the input of a command: a folder of `.msg` files, or some of them.

use std::path::{Path, PathBuf};

use mavgen::Failure;
use mavgen::diag::{Code, Diagnostics, Severity, UnknownCode};
use mavgen::source::Sources;
use mavgen::uorb;
use mavgen::uorb::model::Package;

use super::input::Input;
use super::report::Report;

/// Definitions of uORB messages, newest first, with all that is wrong with them.
pub(super) struct Topics {
    pub(super) definitions: Vec<Definition>,
    pub(super) sources: Sources,
    pub(super) diagnostics: Diagnostics,
}

/// What messages were at one time.
pub(super) struct Definition {
    /// As `--older` calls it; that of the newest is how its folder is called.
    pub(super) name: String,
    pub(super) package: Package,
}

/// Which messages are meant: those of `names` in a folder, or of a file.
struct Wanted {
    path: PathBuf,
    names: Vec<String>,
}

/// Whether a path is that of uORB messages.
pub(super) fn is_uorb(path: &Path) -> bool {
    path.is_dir() || is_message(path)
}

fn is_message(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "msg")
}

impl Input {
    /// The uORB messages that are asked for, read; `None` if a dialect is. Mistakes in them are no failure.
    pub(super) fn topics(&self) -> Result<Option<Topics>, Failure> {
        if !self.xml.iter().any(|path| is_uorb(path)) {
            return match self.older.is_empty() {
                true => Ok(None),
                false => Err(Failure::Usage("`--older` is for folders of `.msg` files".to_owned())),
            };
        }
        let wanted = Wanted::of(&self.xml, self.reading.definitions.messages.as_deref())?;
        let older = self.older.iter().map(|text| older(text)).collect::<Result<Vec<_>, _>>()?;
        self.read(&wanted, &older).map(Some)
    }

    fn read(&self, wanted: &Wanted, older: &[(&str, PathBuf)]) -> Result<Topics, Failure> {
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let paths: Vec<&Path> =
            std::iter::once(&wanted.path).chain(older.iter().map(|(_, path)| path)).map(PathBuf::as_path).collect();
        let names = uorb::selected(&wanted.path, &wanted.names).map_err(Failure::Usage)?;
        let overlays = uorb::overlays(&self.reading.overlay, &paths, &mut sources, &mut diagnostics);
        let mut definitions: Vec<Definition> = Vec::new();
        let newest = folder_name(&wanted.path);
        for (path, name) in paths.iter().zip(std::iter::once(&*newest).chain(older.iter().map(|(name, _)| *name))) {
            let is_wanted = |message: &str| names.iter().any(|name| name == message);
            let package = uorb::load(path, &overlays, is_wanted, &mut sources, &mut diagnostics);
            definitions.push(Definition { name: name.to_owned(), package });
        }
        let diagnostics = self.without_allowed(diagnostics)?;
        Ok(Topics { definitions, sources, diagnostics })
    }

    fn without_allowed(&self, diagnostics: Diagnostics) -> Result<Diagnostics, Failure> {
        let allowed = self.reading.definitions.allow.iter().map(|code| code.parse());
        let allowed: Vec<Code> =
            allowed.collect::<Result<_, _>>().map_err(|error: UnknownCode| Failure::Usage(error.to_string()))?;
        let mut list = Diagnostics::default();
        let is_told = |code: Code| code.severity() == Severity::Error || !allowed.contains(&code);
        list.extend(diagnostics.iter().filter(|one| is_told(one.code)).cloned());
        Ok(list)
    }
}

impl Topics {
    /// Shows what is wrong; whether nothing is that keeps a command from going on.
    pub(super) fn is_fine(&self, deny_warnings: bool, report: &Report) -> bool {
        report.diagnostics(&self.diagnostics, &self.sources);
        let denied = deny_warnings && !self.diagnostics.is_empty() && !self.diagnostics.has_errors();
        if denied {
            report.denied();
        }
        !self.diagnostics.has_errors() && !denied
    }
}

impl Wanted {
    /// One folder, or files of one folder.
    fn of(paths: &[PathBuf], names: Option<&[String]>) -> Result<Self, Failure> {
        let names = names.unwrap_or_default().to_vec();
        if let [path] = paths {
            return Ok(Self { path: path.clone(), names });
        }
        let usage = |text: &str| Failure::Usage(text.to_owned());
        if !paths.iter().all(|path| is_message(path)) {
            return Err(usage("give dialects, or one folder of `.msg` files, or files of one folder"));
        }
        let folder = paths.first().and_then(|path| path.parent()).unwrap_or(Path::new(""));
        if paths.iter().any(|path| path.parent() != Some(folder)) {
            return Err(usage("the `.msg` files stand in several folders; `--older NAME=DIR` adds older definitions"));
        }
        if !names.is_empty() {
            return Err(usage("give the folder, and `--messages` says which of its messages"));
        }
        let stems = paths.iter().filter_map(|path| path.file_stem()?.to_str()).map(str::to_owned).collect();
        let path = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        Ok(Self { path: path.to_owned(), names: stems })
    }
}

/// Takes `NAME=DIR` apart.
fn older(text: &str) -> Result<(&str, PathBuf), Failure> {
    let split = text.split_once('=').filter(|(name, folder)| !name.is_empty() && !folder.is_empty());
    let (name, folder) =
        split.ok_or_else(|| Failure::Usage(format!("`--older {text}` is not of the form NAME=DIR")))?;
    Ok((name, folder.into()))
}

/// The last part of the path of the folder.
fn folder_name(path: &Path) -> String {
    let folder = if is_message(path) && !path.is_dir() { path.parent().unwrap_or(Path::new("")) } else { path };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let whole = std::path::absolute(folder).unwrap_or_else(|_| folder.to_owned());
    whole.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn older_definitions_have_names() {
        assert_eq!(older("v1_14=old/msg=x").unwrap(), ("v1_14", PathBuf::from("old/msg=x")));
        for text in ["", "v1_14", "=old", "v1_14="] {
            assert!(older(text).is_err(), "{text}");
        }
    }

    #[test]
    fn files_of_one_folder() {
        let of = |paths: &[&str]| Wanted::of(&paths.iter().map(PathBuf::from).collect::<Vec<_>>(), None);
        let wanted = of(&["msg/A.msg", "msg/B.msg"]).unwrap();
        assert_eq!((wanted.path, wanted.names), ("msg".into(), vec!["A".to_owned(), "B".to_owned()]));
        assert_eq!(of(&["A.msg", "B.msg"]).unwrap().path, PathBuf::from("."));
        assert!(of(&["msg/A.msg", "old/A.msg"]).is_err());
        assert!(of(&["msg/A.msg", "acme.xml"]).is_err());
    }

    #[test]
    fn folders_have_names() {
        assert_eq!(folder_name(Path::new("px4/main")), "main");
        assert_eq!(folder_name(Path::new("px4/main/A.msg")), "main");
        assert!(!folder_name(Path::new("A.msg")).is_empty());
    }
}

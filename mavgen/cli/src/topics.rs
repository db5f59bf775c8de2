//! uORB messages as the input of a command: a folder of `.msg` files, or some of them.

use std::path::{Path, PathBuf};

use mavgen::{Builder, Failure};

use super::input::Input;

impl Input {
    /// Whether uORB messages are asked for, and not a dialect.
    pub(super) fn is_uorb(&self) -> bool {
        self.xml.iter().any(|path| Builder::new(path).is_uorb())
    }

    /// The builder of uORB messages.
    pub(super) fn topics(&self) -> Result<Builder, Failure> {
        let (path, names) = wanted(&self.xml, self.reading.definitions.messages.as_deref())?;
        let mut builder = self.reading.whole(&path);
        if !names.is_empty() {
            builder = builder.messages(names);
        }
        for text in &self.older {
            let (name, folder) = older(text)?;
            builder = builder.older(name, folder);
        }
        Ok(match &self.definition {
            Some(name) => builder.definition(name),
            None => builder,
        })
    }

    /// Refuses what only uORB messages have.
    pub(super) fn check_dialect(&self) -> Result<(), Failure> {
        match (self.older.first(), &self.definition) {
            (None, None) => Ok(()),
            (Some(_), _) => Err(Failure::Usage("`--older` is for folders of `.msg` files".to_owned())),
            (None, Some(_)) => Err(Failure::Usage("`--definition` is for folders of `.msg` files".to_owned())),
        }
    }
}

fn is_message(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension == "msg")
}

/// One folder with the names of messages, or a file; of several files of one folder, that and their names.
fn wanted(paths: &[PathBuf], names: Option<&[String]>) -> Result<(PathBuf, Vec<String>), Failure> {
    let names = names.unwrap_or_default().to_vec();
    if let [path] = paths {
        return Ok((path.clone(), names));
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
    let stem = |path: &PathBuf| {
        let stem = path.file_stem().and_then(|stem| stem.to_str()).map(str::to_owned);
        stem.ok_or_else(|| usage(&format!("`{}` is not named after a message", path.display())))
    };
    let stems = paths.iter().map(stem).collect::<Result<_, _>>()?;
    let path = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    Ok((path.to_owned(), stems))
}

/// Takes `NAME=DIR` apart.
fn older(text: &str) -> Result<(&str, &str), Failure> {
    let split = text.split_once('=').filter(|(name, folder)| !name.is_empty() && !folder.is_empty());
    split.ok_or_else(|| Failure::Usage(format!("`--older {text}` is not of the form NAME=DIR")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn older_definitions_have_names() {
        assert_eq!(older("v1_14=old/msg=x").unwrap(), ("v1_14", "old/msg=x"));
        for text in ["", "v1_14", "=old", "v1_14="] {
            assert!(older(text).is_err(), "{text}");
        }
    }

    #[test]
    fn files_of_one_folder() {
        let of = |paths: &[&str]| wanted(&paths.iter().map(PathBuf::from).collect::<Vec<_>>(), None);
        let expected = (PathBuf::from("msg"), vec!["A".to_owned(), "B".to_owned()]);
        assert_eq!(of(&["msg/A.msg", "msg/B.msg"]).unwrap(), expected);
        assert_eq!(of(&["A.msg", "B.msg"]).unwrap().0, PathBuf::from("."));
        assert!(of(&["msg/A.msg", "old/A.msg"]).is_err());
        assert!(of(&["msg/A.msg", "acme.xml"]).is_err());
    }
}

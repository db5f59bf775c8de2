//! Where an include may lie.

use std::path::{Component, Path, PathBuf};

use crate::collect::CollectVec as _;
use crate::diag::nearest;
use crate::order;

/// The places where a file looks for `include`: beside itself, then in the folders given.
pub(super) fn places(from: &Path, include: &str, include_dirs: &[PathBuf]) -> Vec<PathBuf> {
    let beside = from.parent().unwrap_or(Path::new(""));
    let mut places: Vec<PathBuf> = Vec::new();
    for folder in std::iter::once(beside).chain(include_dirs.iter().map(PathBuf::as_path)) {
        let place = plain(&folder.join(include));
        if !places.contains(&place) {
            places.push(place);
        }
    }
    places
}

/// The path by which files are told apart.
pub(crate) fn absolute(path: &Path) -> PathBuf {
    plain(&std::path::absolute(path).unwrap_or_else(|_| path.to_owned()))
}

/// A path without `.` and, where a folder stands before it, `..`.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for component in path.components() {
        match (component, plain.components().next_back()) {
            (Component::ParentDir, Some(Component::Normal(_))) => {
                plain.pop();
            }
            (Component::ParentDir, Some(Component::RootDir)) => {}
            _ => plain.push(component),
        }
    }
    plain
}

/// The name of a file that lies in one of the folders and is spelled nearly like the one that was looked for there.
pub(super) fn similar(places: &[PathBuf]) -> Option<String> {
    places.iter().find_map(|place| {
        let wanted = place.file_name()?.to_string_lossy();
        let folder = place.parent().filter(|folder| !folder.as_os_str().is_empty());
        let entries = std::fs::read_dir(folder.unwrap_or(Path::new("."))).ok()?;
        let mut names = entries
            .filter_map(|entry| Some(entry.ok()?.file_name().to_string_lossy().into_owned()))
            .filter(|name| name.ends_with(".xml"))
            .collect_vec();
        order::sort_and_dedup(&mut names);
        if names.iter().any(|name| *name == wanted) {
            // It is there, and something else is wrong with it.
            return None;
        }
        let with_extension = format!("{wanted}.xml");
        if names.contains(&with_extension) {
            return Some(with_extension);
        }
        nearest(&wanted, names.iter().map(String::as_str)).map(str::to_owned)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_paths() {
        for (path, expected) in [
            ("xml/common.xml", "xml/common.xml"),
            ("xml/sub/../common.xml", "xml/common.xml"),
            ("xml/./common.xml", "xml/common.xml"),
            ("./common.xml", "./common.xml"),
            ("../../common.xml", "../../common.xml"),
            ("a/../../common.xml", "../common.xml"),
            ("/a/../../common.xml", "/common.xml"),
        ] {
            assert_eq!(plain(Path::new(path)), Path::new(expected), "{path}");
        }
    }

    #[test]
    fn places_in_order_and_once() {
        let folders = [PathBuf::from("inc"), PathBuf::from("xml")];
        let found = places(Path::new("xml/top.xml"), "a.xml", &folders);
        assert_eq!(found, [Path::new("xml/a.xml"), Path::new("inc/a.xml")]);
        let found = places(Path::new("xml/top.xml"), "/a.xml", &folders);
        assert_eq!(found, [Path::new("/a.xml")]);
    }
}

//! What of a message is printed: fields and views by name.

use clap::Args;
use mavgen::Failure;
use mavgen::decode::{Contents, Entry, Node};
use mavgen::diag::nearest;

/// The options that choose.
#[derive(Args, Default)]
pub(super) struct Choice {
    /// Only these fields and values of views: names separated by commas, `roll`, or what CSV calls a column, without its
    /// indices: `escs.status.rpm`; a star stands for any characters. Messages without them are not printed.
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    fields: Vec<String>,
    /// Only these views, by the names that are printed: `escs`.
    #[arg(long, value_name = "NAME", value_delimiter = ',', conflicts_with = "no_view")]
    views: Vec<String>,
    /// Without these views; `*` for none at all.
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    no_view: Vec<String>,
}

impl Choice {
    /// Fails if a name means nothing among `paths`, those of all fields, and those of all values of views.
    pub(super) fn check(&self, fields: &[String], views: &[String]) -> Result<(), Failure> {
        let named = |paths: &[String]| -> Vec<String> { paths.iter().flat_map(|path| ancestors(path)).collect() };
        let tops: Vec<String> = views.iter().filter_map(|path| Some(path.split('.').next()?.to_owned())).collect();
        let all = named(&[fields, views].concat());
        means_something(&self.fields, &all, "field or value of a view")?;
        means_something(&self.views, &tops, "view")?;
        // Where there are no views, none at all is what there is.
        if tops.is_empty() && self.no_view == ["*"] { Ok(()) } else { means_something(&self.no_view, &tops, "view") }
    }

    /// Whether only some fields are printed, and of other messages nothing.
    pub(super) fn is_of_fields(&self) -> bool {
        !self.fields.is_empty()
    }

    /// Whether a value is printed, by the path to it; `is_view` says that it is of a view.
    pub(super) fn keeps(&self, path: &str, is_view: bool) -> bool {
        let top = path.split('.').next().unwrap_or(path);
        let is_chosen = !is_view
            || !self.no_view.iter().any(|name| matches(name, top))
                && (self.views.is_empty() || self.views.iter().any(|name| matches(name, top)));
        is_chosen && (self.fields.is_empty() || self.names(path))
    }

    /// What is printed of a message; `None` if that is nothing although something was asked for.
    pub(super) fn of(&self, contents: Contents) -> Option<Contents> {
        let Contents { fields, views } = contents;
        let kept = |entries: Vec<Entry>, is_view: bool| -> Vec<Entry> {
            entries.into_iter().filter_map(|entry| self.entry(entry, "", is_view)).collect()
        };
        let kept = Contents { fields: kept(fields, false), views: kept(views, true) };
        let is_empty = kept.fields.is_empty() && kept.views.is_empty();
        if is_empty && !self.fields.is_empty() { None } else { Some(kept) }
    }

    fn entry(&self, entry: Entry, above: &str, is_view: bool) -> Option<Entry> {
        let Entry { name, units, node } = entry;
        let path = if above.is_empty() { name.clone() } else { format!("{above}.{name}") };
        Some(Entry { node: self.node(node, &path, is_view)?, name, units })
    }

    fn node(&self, node: Node, path: &str, is_view: bool) -> Option<Node> {
        if self.keeps(path, is_view) {
            return Some(node);
        }
        match node {
            Node::Record(entries) => {
                let kept = entries.into_iter().filter_map(|entry| self.entry(entry, path, is_view));
                Some(kept.collect()).filter(|kept: &Vec<Entry>| !kept.is_empty()).map(Node::Record)
            }
            // All elements are of one kind, and keep the same.
            Node::List(nodes) => {
                let nodes = nodes.into_iter().map(|node| self.node(node, path, is_view));
                nodes.collect::<Option<Vec<Node>>>().filter(|nodes| !nodes.is_empty()).map(Node::List)
            }
            // A record of which nothing is known.
            Node::Unknown if is_view && self.may_name_below(path) => Some(Node::Unknown),
            _ => None,
        }
    }

    /// Whether `--fields` names a path, or something that it is a part of.
    fn names(&self, path: &str) -> bool {
        ancestors(path).any(|path| self.fields.iter().any(|name| matches(name, &path)))
    }

    /// Whether `--fields` may name a part of what has this path.
    fn may_name_below(&self, path: &str) -> bool {
        self.fields.iter().any(|name| {
            let mut ancestors = name.match_indices('.').filter_map(|(at, _)| name.get(..at));
            name.contains('*') || ancestors.any(|above| above == path)
        })
    }
}

/// A path and all that it is a part of.
fn ancestors(path: &str) -> impl Iterator<Item = String> {
    let dots: Vec<usize> = path.match_indices('.').map(|(at, _)| at).chain([path.len()]).collect();
    dots.into_iter().filter_map(move |end| Some(path.get(..end)?.to_owned())).collect::<Vec<_>>().into_iter()
}

fn means_something(names: &[String], known: &[String], what: &str) -> Result<(), Failure> {
    let Some(unknown) = names.iter().find(|name| !known.iter().any(|known| matches(name, known))) else {
        return Ok(());
    };
    let near = nearest(unknown, known.iter().map(String::as_str));
    let near = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
    Err(Failure::Usage(format!("no {what} of these messages is called `{unknown}`{near}")))
}

/// Whether a name is meant by a pattern, in which a star stands for any characters.
fn matches(pattern: &str, name: &str) -> bool {
    let mut pieces = pattern.split('*');
    let Some(mut rest) = pieces.next().and_then(|first| name.strip_prefix(first)) else { return false };
    let mut pieces: Vec<&str> = pieces.collect();
    let Some(last) = pieces.pop() else { return rest.is_empty() };
    for piece in pieces {
        let Some((_, behind)) = rest.split_once(piece) else { return false };
        rest = behind;
    }
    rest.ends_with(last)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_star_stands_for_any_characters() {
        for (pattern, name) in [("roll", "roll"), ("*", ""), ("r*", "roll"), ("*.rpm", "a.b.rpm"), ("a*b*c", "aXbbYc")]
        {
            assert!(matches(pattern, name), "{pattern} {name}");
        }
        for (pattern, name) in [("roll", "rollspeed"), ("", "x"), ("r*x", "roll"), ("a*b*c", "acb"), ("ab*ba", "aba")] {
            assert!(!matches(pattern, name), "{pattern} {name}");
        }
    }

    #[test]
    fn a_path_is_meant_by_what_it_is_a_part_of() {
        let choice = |fields: &str| Choice { fields: vec![fields.to_owned()], ..Choice::default() };
        for fields in ["escs", "escs.status", "escs.status.rpm", "*.rpm", "e*"] {
            assert!(choice(fields).keeps("escs.status.rpm", true), "{fields}");
        }
        for fields in ["esc", "status", "escs.status.rp", "rpm"] {
            assert!(!choice(fields).keeps("escs.status.rpm", true), "{fields}");
        }
    }

    #[test]
    fn views_are_chosen_by_their_first_name() {
        let views = Choice { views: vec!["escs".into()], ..Choice::default() };
        let no_view = Choice { no_view: vec!["legacy_*".into()], ..Choice::default() };
        for (path, is_view, by_views, by_no_view) in [
            ("escs.status", true, true, true),
            ("legacy_escs.id", true, false, false),
            ("legacy_field", false, true, true),
        ] {
            assert_eq!((views.keeps(path, is_view), no_view.keeps(path, is_view)), (by_views, by_no_view), "{path}");
        }
    }

    #[test]
    fn a_name_that_means_nothing_is_an_error() {
        let (fields, views) = (["roll".to_owned()], ["escs.status.rpm".to_owned()]);
        let check = |choice: Choice| choice.check(&fields, &views).map_err(|failure| failure.to_string());
        let named = |name: &str| vec![name.to_owned()];
        for name in ["roll", "*", "escs", "escs.status", "*rpm"] {
            assert!(check(Choice { fields: named(name), ..Choice::default() }).is_ok(), "{name}");
        }
        let said = "no field or value of a view of these messages is called `rol`; did you mean `roll`?";
        assert_eq!(check(Choice { fields: named("rol"), ..Choice::default() }), Err(said.to_owned()));
        let said = "no view of these messages is called `roll`";
        assert_eq!(check(Choice { views: named("roll"), ..Choice::default() }), Err(said.to_owned()));
        assert!(check(Choice { no_view: named("escs"), ..Choice::default() }).is_ok());
        assert!(check(Choice { no_view: named("esc"), ..Choice::default() }).is_err());
        assert!(Choice { no_view: named("*"), ..Choice::default() }.check(&fields, &[]).is_ok());
    }
}

//! Empty lines between items, which neither layout has by itself.

/// Separates items by empty lines, in modules and in `impl` blocks; one-line constants, imports and modules stay together.
pub(super) fn blank_lines(text: &str) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let mut spaced = String::with_capacity(text.len() + lines.len());
    space_items(&lines, 0, &mut spaced);
    spaced
}

/// Writes the items that `lines` hold at one indentation.
fn space_items(lines: &[&str], indent: usize, out: &mut String) {
    let mut previous = None;
    for item in items(lines, indent) {
        let group = group_of(item, indent);
        if previous.is_some_and(|previous| previous != group || group == Group::Alone) {
            out.push('\n');
        }
        previous = Some(group);
        write_item(item, indent, out);
    }
}

/// Writes one item; the body of an `impl` is items again.
fn write_item(item: &[&str], indent: usize, out: &mut String) {
    let opens = |line: &&str| starts_at(line, indent) && line.trim_start().starts_with("impl") && line.ends_with('{');
    match (item.iter().position(opens), item.split_last()) {
        (Some(open), Some((close, rest))) if open + 1 < item.len() => {
            push_lines(rest.get(..=open).unwrap_or_default(), out);
            space_items(rest.get(open + 1..).unwrap_or_default(), indent + 4, out);
            push_lines(&[close], out);
        }
        _ => push_lines(item, out),
    }
}

fn push_lines(lines: &[&str], out: &mut String) {
    for line in lines {
        out.push_str(line);
        out.push('\n');
    }
}

/// Cuts lines into items: each ends at its own indentation with `;` or `}`, or further in with `;` where the next one begins.
fn items<'l, 't>(lines: &'l [&'t str], indent: usize) -> impl Iterator<Item = &'l [&'t str]> {
    let mut rest = lines;
    std::iter::from_fn(move || {
        let ends = |at: usize, line: &str| {
            let begins_next = |next: &&str| starts_at(next, indent) && !next.trim_start().starts_with(['}', ')', ']']);
            let is_own = starts_at(line, indent) && line.ends_with([';', '}']);
            let is_before_next = line.ends_with(';') && rest.get(at + 1).is_some_and(begins_next);
            !is_attribute(line) && (is_own || is_before_next)
        };
        let last = rest.iter().enumerate().position(|(at, line)| ends(at, line)).unwrap_or(rest.len().checked_sub(1)?);
        let (item, others) = rest.split_at_checked(last + 1)?;
        rest = others;
        Some(item)
    })
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    /// An inner doc comment or attribute of the file.
    Inner,
    /// `use`.
    Import,
    /// `pub use`.
    Export,
    /// `mod name;`.
    Module,
    /// A constant on one line.
    Constant,
    /// Anything else, and whatever takes several lines.
    Alone,
}

fn group_of(item: &[&str], indent: usize) -> Group {
    let mut code = item.iter().filter(|line| !is_attribute(line));
    let (Some(first), only) = (code.next(), code.next().is_none()) else { return Group::Inner };
    let first = first.get(indent..).unwrap_or_default();
    if first.starts_with("use ") {
        Group::Import
    } else if first.starts_with("pub use ") {
        Group::Export
    } else if first.starts_with("mod ") || first.starts_with("pub mod ") {
        Group::Module
    } else if only && (first.starts_with("const ") || first.starts_with("pub const ")) && first.ends_with(';') {
        Group::Constant
    } else {
        Group::Alone
    }
}

fn starts_at(line: &str, indent: usize) -> bool {
    line.len() > indent && line.bytes().position(|byte| byte != b' ') == Some(indent)
}

fn is_attribute(line: &str) -> bool {
    let code = line.trim_start();
    code.starts_with("//") || code.starts_with("#[") || code.starts_with("#!")
}

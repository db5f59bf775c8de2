//! Formatting: from tokens to the text of a file.
//!
//! prettyplease lays out the code and puts no empty line between items; [`blank_lines`] does.
//!
//! rustfmt would break some lines elsewhere (it fills 100 columns, prettyplease 89), and orders modules otherwise. A build script
//! cannot count on it: it may not be installed, it takes ten times as long, and its layout changes with the toolchain, where
//! the same definitions have to give the same bytes.

use proc_macro2::TokenStream;

use crate::internal::Internal;

/// The text of a file made of these items.
///
/// # Errors
/// If they are no items, which is a mistake of the emitters.
pub(crate) fn format(items: TokenStream) -> Result<String, Internal> {
    let file = syn::parse2(items).map_err(|error| Internal::new(format!("generated code is no Rust: {error}")))?;
    Ok(blank_lines(&prettyplease::unparse(&file)))
}

/// Separates items by empty lines, in modules and in `impl` blocks; one-line constants, imports and modules stay together.
fn blank_lines(text: &str) -> String {
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

#[cfg(test)]
mod tests {
    use quote::quote;

    use super::*;

    #[test]
    fn items_are_separated() {
        let text = format(quote! {
            use super::A;
            use super::B;
            /// A type.
            pub struct C(pub u8);
            impl C {
                /// One.
                pub const ONE: Self = Self(1);
                /// Two;
                /// or so.
                pub const TWO: Self = Self(2);
                /// Long.
                pub const LONG: Self = Self::of_a_name_that_takes_a_line(111_111_111).and(222_222_222).and(333_333_333);
                /// Get.
                pub fn get(self) -> u8 { self.0 }
            }
            mod x;
            mod y;
        });
        let constants = "    /// One.\n    pub const ONE: Self = Self(1);\n    /// Two;\n    /// or so.\n    pub const TWO: Self = Self(2);\n";
        let long = "    /// Long.\n    pub const LONG: Self = Self::of_a_name_that_takes_a_line(111_111_111)\n        .and(222_222_222)\n        \
                    .and(333_333_333);\n";
        let get = "    /// Get.\n    pub fn get(self) -> u8 {\n        self.0\n    }\n";
        let expected = format!(
            "use super::A;\nuse super::B;\n\n/// A type.\npub struct C(pub u8);\n\nimpl C {{\n{constants}\n{long}\n{get}}}\n\nmod x;\nmod y;\n"
        );
        assert_eq!(text.unwrap(), expected);
    }
}

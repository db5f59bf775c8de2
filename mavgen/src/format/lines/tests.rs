//! Plain lines of code that is written, and of tokens in any order.

use proc_macro2::{Spacing, TokenTree};
use proptest::prelude::*;

use super::*;
use crate::tokens::quote;

fn check(items: &TokenStream, expected: &str) {
    assert_eq!(lines(items), expected);
}

#[test]
fn items() {
    check(
        &quote! {
            #![doc = " A file."]
            use ::mavlink_wire as wire;
            use super::{a::B, c::*};
            /// A type with `"quotes"`.
            ///
            #[doc = " A \\ and \"quotes\"."]
            #[doc = "/ this"]
            #[doc = "two\nlines"]
            #[doc(alias = "T")]
            #[derive(Clone, Copy)]
            pub struct T<'a, const N: usize> { #[doc = " One."] pub a: &'a [u8; N], pub(super) b: Option<Result<(), E>>, r#type: wire::Chars<4>, }
            pub struct Empty;
            impl<'a> wire::Targeted for T<'a, 3> {}
            wire::message!(T { each a, maybe b });
        },
        r#"#![doc = " A file."]
use ::mavlink_wire as wire;
use super::{a::B, c::*};
/// A type with `"quotes"`.
///
#[doc = " A \\ and \"quotes\"."]
#[doc = "/ this"]
#[doc = "two\nlines"]
#[doc(alias = "T")]
#[derive(Clone, Copy)]
pub struct T<'a, const N: usize> {
    /// One.
    pub a: &'a [u8; N],
    pub(super) b: Option<Result<(), E>>,
    r#type: wire::Chars<4>,
}
pub struct Empty;
impl<'a> wire::Targeted for T<'a, 3> {}
wire::message!(T {
    each a,
    maybe b
});
"#,
    );
}

#[test]
fn statements() {
    check(
        &quote! {
            #[inline(always)]
            fn get<T: ?Sized>(&self, p: &mut [u8; 4]) -> <T as U>::X {
                let Some((a, _)) = p.split_first_chunk::<4>() else { return Self::UNKNOWN };
                if a < b && !c { -1 } else if a >= 0x1f { &*x } else { 2.0 }
                for (one, p) in self.x.iter_mut().skip(1).zip(wire::elements::<35>(p, 16, 40)) { *one = E { a: get(p, 0), ..E::NEW }; }
                *self = match ((self.bits >> 29) & 0x7fff) as u16 { 3..=9 | 30 => Some(|v: u8, w| v + w), raw @ 0 => { x()?; } _ => None, }.map(|| 1);
                static INFO: [(u8, &str); 2] = [(1, "A"), (-2, "B")];
                return self.0 .1.max(1.max(2)) as i8;
            }
        },
        r#"#[inline(always)]
fn get<T: ?Sized>(&self, p: &mut [u8; 4]) -> <T as U>::X {
    let Some((a, _)) = p.split_first_chunk::<4>() else {
        return Self::UNKNOWN
    };
    if a < b && !c {
        -1
    } else if a >= 0x1f {
        &*x
    } else {
        2.0
    }
    for (one, p) in self.x.iter_mut().skip(1).zip(wire::elements::<35>(p, 16, 40)) {
        *one = E {
            a: get(p, 0),
            ..E::NEW
        };
    }
    *self = match ((self.bits >> 29) & 0x7fff) as u16 {
        3..=9 | 30 => Some(|v: u8, w| v + w),
        raw @ 0 => {
            x()?;
        }
        _ => None,
    }.map(|| 1);
    static INFO: [(u8, &str); 2] = [
        (1, "A"),
        (-2, "B")
    ];
    return self.0 .1.max(1.max(2)) as i8;
}
"#,
    );
}

/// Tokens as a lexer sees them: operators whole, wherever the spaces are. What begins with `>` is taken apart, because that may
/// close generics.
fn flat(stream: proc_macro2::TokenStream, out: &mut Vec<String>) {
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Group(group) => {
                out.push(format!("{:?}", group.delimiter()));
                flat(group.stream(), out);
                out.push("end".to_owned());
            }
            TokenTree::Punct(punct) => {
                let (mut text, mut spacing) = (punct.to_string(), punct.spacing());
                while spacing == Spacing::Joint
                    && let Some(TokenTree::Punct(next)) = trees.peek()
                    && OPERATORS.contains(&&*format!("{text}{next}"))
                {
                    text.push(next.as_char());
                    spacing = next.spacing();
                    trees.next();
                }
                match text.trim_start_matches(['>', '=']).is_empty() {
                    true => out.extend(text.chars().map(String::from)),
                    false => out.push(text),
                }
            }
            other => out.push(other.to_string()),
        }
    }
}

const OPERATORS: [&str; 25] = [
    "::", "->", "=>", "..", "..=", "...", "==", "!=", "<=", ">=", "&&", "||", "<<", ">>", "<<=", ">>=", "+=", "-=",
    "*=", "/=", "%=", "^=", "&=", "|=", "<-",
];

fn flattened(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    flat(text.parse().unwrap(), &mut out);
    out
}

fn token() -> impl Strategy<Value = Vec<&'static str>> {
    let words = vec![
        "a", "b", "r", "e5", "in", "fn", "impl", "as", "else", "self", "Self", "T", "doc", "x", "r#type", "'a", "_",
    ];
    let literals = vec![
        "1",
        "1.0",
        "2.",
        "1e3",
        "0x1f",
        "1u8",
        "'x'",
        "b'x'",
        "\"s\"",
        "r#\"s\"#",
        "\" a\\\"\"",
        "\"/\"",
        "-1",
        "b\"x\"",
    ];
    let signs =
        vec!["~", "!", "@", "#", "$", "%", "^", "&", "*", "-", "=", "+", "|", ";", ":", ",", "<", ".", ">", "/", "?"];
    let one =
        prop::sample::select([words, literals, signs, OPERATORS[..24].to_vec()].concat()).prop_map(|token| vec![token]);
    let docs = vec![
        vec!["///"],
        vec!["/// a \" \\"],
        vec!["#", "[", "doc", "=", "\" a\"", "]"],
        vec!["#", "!", "[", "a", "]"],
    ];
    prop_oneof![20 => one, 1 => prop::sample::select(docs)]
}

fn tokens() -> impl Strategy<Value = Vec<&'static str>> {
    token().prop_recursive(4, 60, 8, |inner| {
        let delimiters = vec![("(", ")"), ("[", "]"), ("{", "}")];
        let content = prop::collection::vec(inner, 0..8).prop_map(|parts| parts.concat());
        (prop::sample::select(delimiters), content)
            .prop_map(|((start, end), content)| [&[start], &*content, &[end]].concat())
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(1000), ..ProptestConfig::default() })]

    #[test]
    fn the_text_reads_back_as_the_same_tokens(parts in prop::collection::vec(tokens(), 0..10)) {
        let tokens = parts.concat();
        let text = lines(&TokenStream::of_tokens(&tokens));
        let again = text.parse::<proc_macro2::TokenStream>();
        prop_assert!(again.is_ok(), "{text}");
        prop_assert_eq!(flattened(&tokens.join("\n")), flattened(&text), "{}", text);
    }
}

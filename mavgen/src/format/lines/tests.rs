//! Plain lines of code that is written, and of tokens in any order.

use proc_macro2::Span;
use proptest::prelude::*;
use quote::quote;

use super::*;

fn check(items: TokenStream, expected: &str) {
    assert_eq!(lines(items), expected);
}

#[test]
fn items() {
    check(
        quote! {
            //! A file.
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
        r#"//! A file.
use ::mavlink_wire as wire;
use super::{a::B, c::*};
/// A type with `"quotes"`.
///
/// A \ and "quotes".
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
        quote! {
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
fn flat(stream: TokenStream, out: &mut Vec<String>) {
    let mut trees = trees(stream);
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
                    && let Some(TokenTree::Punct(next)) = trees.as_slice().first()
                    && is_operator(&format!("{text}{next}"))
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
            TokenTree::Literal(literal) => match literal.to_string().strip_prefix('-') {
                Some(magnitude) => out.extend(["-".to_owned(), magnitude.to_owned()]),
                None => out.push(literal.to_string()),
            },
            TokenTree::Ident(word) => out.push(word.to_string()),
        }
    }
}

fn flattened(stream: TokenStream) -> Vec<String> {
    let mut out = Vec::new();
    flat(stream, &mut out);
    out
}

fn word() -> impl Strategy<Value = Vec<TokenTree>> {
    let words = ["a", "b", "r", "e5", "in", "fn", "impl", "as", "else", "self", "Self", "T", "doc", "x"];
    let raw = Ident::new_raw("type", Span::call_site());
    let words: Vec<Ident> = words.iter().map(|word| Ident::new(word, Span::call_site())).chain([raw]).collect();
    prop::sample::select(words).prop_map(|word| vec![word.into()])
}

fn literal() -> impl Strategy<Value = Vec<TokenTree>> {
    let texts = [
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
        "\"a\\nb\"",
        "-1",
    ];
    prop::sample::select(texts.map(|text| text.parse::<Literal>().unwrap()).to_vec()).prop_map(|text| vec![text.into()])
}

fn sign(sign: char, spacing: Spacing) -> TokenTree {
    Punct::new(sign, spacing).into()
}

fn punct() -> impl Strategy<Value = Vec<TokenTree>> {
    let signs: Vec<char> = "~!@#$%^&*-=+|;:,<.>/?".chars().collect();
    let spacing = prop_oneof![Just(Spacing::Alone), Just(Spacing::Joint)];
    (prop::sample::select(signs), spacing).prop_map(|(char, spacing)| vec![sign(char, spacing)])
}

fn operator() -> impl Strategy<Value = Vec<TokenTree>> {
    let texts = ["::", "->", "=>", "..", "..=", "&&", "||", "<<", ">>", "<=", "==", "'a", "<", ">", "|", "."];
    prop::sample::select(texts.to_vec()).prop_map(|text| text.parse::<TokenStream>().unwrap().into_iter().collect())
}

fn documentation() -> impl Strategy<Value = Vec<TokenTree>> {
    let texts = ["", " a", "/", " \"\\", "a\nb", "\u{feff}"].map(Literal::string).to_vec();
    prop::sample::select(texts).prop_map(|text| quote!(#[doc = #text]).into_iter().collect())
}

fn tokens() -> impl Strategy<Value = Vec<TokenTree>> {
    let one = prop_oneof![3 => word(), 3 => literal(), 4 => punct(), 4 => operator(), 1 => documentation()];
    one.prop_recursive(4, 60, 8, |inner| {
        let delimiters = vec![Delimiter::Brace, Delimiter::Parenthesis, Delimiter::Bracket];
        (prop::sample::select(delimiters), prop::collection::vec(inner, 0..8))
            .prop_map(|(delimiter, parts)| vec![Group::new(delimiter, parts.into_iter().flatten().collect()).into()])
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: ProptestConfig::default().cases.max(1000), ..ProptestConfig::default() })]

    #[test]
    fn the_text_reads_back_as_the_same_tokens(parts in prop::collection::vec(tokens(), 0..10)) {
        let stream: TokenStream = parts.into_iter().flatten().collect();
        let text = lines(stream.clone());
        let again = text.parse::<TokenStream>();
        prop_assert!(again.is_ok(), "{text}");
        prop_assert_eq!(flattened(stream), flattened(again.unwrap()), "{}", text);
    }
}

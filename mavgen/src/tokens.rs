//! Generated code as tokens, which are text from the start.
//!
//! What `quote` and `proc-macro2` are for macros, in little: a build script compiles this crate and runs it unoptimised, and
//! tokens that are never taken apart need no tree. Each is text that ends with a line break; no token has one inside.

use std::fmt::{self, Display, Write};

/// Generated code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct TokenStream(String);

/// An identifier, which `r#` begins if it is a keyword.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Ident(String);

/// A number without a suffix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Literal(String);

/// What stands in code for `#name` in [`quote!`]. A text stands as a literal.
pub(crate) trait ToTokens {
    /// Adds it.
    fn to_tokens(&self, tokens: &mut TokenStream);

    /// It alone.
    fn to_token_stream(&self) -> TokenStream {
        let mut tokens = TokenStream::default();
        self.to_tokens(&mut tokens);
        tokens
    }
}

impl TokenStream {
    /// Nothing yet.
    pub(crate) fn new() -> Self {
        Self(String::with_capacity(120))
    }

    #[cfg(feature = "uorb")]
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds tokens, each with its line break.
    pub(crate) fn push(&mut self, tokens: &'static str) {
        self.0.push_str(tokens);
    }

    /// Adds a line of documentation, `///` or `//!`. A line break in it would end it.
    pub(crate) fn push_doc(&mut self, sign: &'static str, line: &str) {
        self.0.push_str(sign);
        if !line.is_empty() {
            self.0.push(' ');
        }
        self.0.extend(line.split(['\n', '\r']));
        self.0.push('\n');
    }

    /// A path: `::mavlink_wire`, `super::enums::MavState`.
    pub(crate) fn of_path(path: &str) -> Self {
        Self(path.replace("::", "\n::\n").trim_start_matches('\n').to_owned() + "\n")
    }

    #[cfg(test)]
    pub(crate) fn of_tokens(tokens: &[&str]) -> Self {
        Self(tokens.iter().map(|token| format!("{token}\n")).collect())
    }

    /// Every token.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &str> {
        let mut rest = self.0.as_str();
        // Tokens are short: to look at each byte is faster than what looks at many.
        std::iter::from_fn(move || {
            let (token, behind) = rest.split_at_checked(rest.bytes().position(|byte| byte == b'\n')?)?;
            rest = behind.get(1..)?;
            Some(token)
        })
    }

    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// Without the parentheses around all of it.
    pub(crate) fn without_parentheses(self) -> Self {
        let Some(inner) = self.0.strip_prefix("(\n").and_then(|inner| inner.strip_suffix(")\n")) else { return self };
        let mut open = 0_usize;
        for token in inner.lines() {
            match token {
                "(" => open += 1,
                ")" if open == 0 => return self,
                ")" => open -= 1,
                _ => {}
            }
        }
        Self(inner.to_owned())
    }

    fn push_token(&mut self, token: impl Display) {
        // Writing into a String cannot fail.
        let _ = writeln!(self.0, "{token}");
    }
}

/// Separated by spaces.
impl Display for TokenStream {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.trim_end_matches('\n').replace('\n', " ").as_str())
    }
}

impl FromIterator<TokenStream> for TokenStream {
    fn from_iter<I: IntoIterator<Item = Self>>(parts: I) -> Self {
        let mut tokens = Self::default();
        parts.into_iter().for_each(|part| tokens.0.push_str(&part.0));
        tokens
    }
}

impl Extend<TokenStream> for TokenStream {
    fn extend<I: IntoIterator<Item = Self>>(&mut self, parts: I) {
        parts.into_iter().for_each(|part| self.0.push_str(&part.0));
    }
}

impl Ident {
    /// This word, which has to be an identifier.
    pub(crate) fn new(word: &str) -> Self {
        Self(word.to_owned())
    }

    /// A keyword as an identifier.
    pub(crate) fn new_raw(word: &str) -> Self {
        Self(format!("r#{word}"))
    }
}

impl Literal {
    /// A number as it is written.
    pub(crate) fn of(number: impl Display) -> Self {
        Self(number.to_string())
    }
}

impl ToTokens for TokenStream {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.0.push_str(&self.0);
    }
}

impl ToTokens for Ident {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.push_token(&self.0);
    }
}

impl ToTokens for Literal {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.push_token(&self.0);
    }
}

impl ToTokens for str {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.push_token(format_args!("{self:?}"));
    }
}

impl ToTokens for String {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.as_str().to_tokens(tokens);
    }
}

impl<T: ToTokens> ToTokens for Option<T> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        if let Some(one) = self {
            one.to_tokens(tokens);
        }
    }
}

impl<T: ToTokens + ?Sized> ToTokens for &T {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        (**self).to_tokens(tokens);
    }
}

/// Code with what `#name` stands for. `#(#names),*` has all that an iterator gives, with a separator or without.
macro_rules! quote {
    ($($template:tt)*) => {{
        #[allow(unused_mut, reason = "a template may be empty")]
        let mut tokens = $crate::tokens::TokenStream::new();
        $crate::tokens::push!(tokens [] $($template)*);
        tokens
    }};
}
pub(crate) use quote;

/// Adds a template to tokens. What stands in brackets was read and is not added yet: what comes in a row is added at once.
macro_rules! push {
    ($to:ident []) => {};
    ($to:ident [$(($($token:tt)*))+]) => {
        $to.push(::core::concat!($($($token)*, "\n"),+));
    };
    ($to:ident [$($before:tt)*] #($($one:tt)*)* $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*]);
        $crate::tokens::repeat!($to () ($($one)*) $($one)*);
        $crate::tokens::push!($to [] $($behind)*);
    };
    ($to:ident [$($before:tt)*] #($($one:tt)*) $separator:tt * $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*]);
        $crate::tokens::repeat!($to ($separator) ($($one)*) $($one)*);
        $crate::tokens::push!($to [] $($behind)*);
    };
    ($to:ident [$($before:tt)*] #$name:ident $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*]);
        $crate::tokens::ToTokens::to_tokens(&$name, &mut $to);
        $crate::tokens::push!($to [] $($behind)*);
    };
    ($to:ident [$($before:tt)*] { $($inner:tt)* } $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)* ("{")] $($inner)*);
        $crate::tokens::push!($to [("}")] $($behind)*);
    };
    ($to:ident [$($before:tt)*] ($($inner:tt)*) $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)* ("(")] $($inner)*);
        $crate::tokens::push!($to [(")")] $($behind)*);
    };
    ($to:ident [$($before:tt)*] [$($inner:tt)*] $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)* ("[")] $($inner)*);
        $crate::tokens::push!($to [("]")] $($behind)*);
    };
    ($to:ident [$($before:tt)*] $token:tt $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)* (::core::stringify!($token))] $($behind)*);
    };
}
pub(crate) use push;

/// Adds a template for each item of the first name in it.
macro_rules! repeat {
    ($to:ident ($($separator:tt)?) ($($one:tt)*) #$name:ident $($behind:tt)*) => {
        let start = $to.len();
        for $name in $name {
            if start < $to.len() {
                $crate::tokens::push!($to [] $($separator)?);
            }
            $crate::tokens::push!($to [] $($one)*);
        }
    };
    ($to:ident ($($separator:tt)?) ($($one:tt)*) $before:tt $($behind:tt)*) => {
        $crate::tokens::repeat!($to ($($separator)?) ($($one)*) $($behind)*);
    };
}
pub(crate) use repeat;

#[cfg(test)]
mod tests {
    use super::*;

    fn check(tokens: &TokenStream, expected: &str) {
        assert_eq!(tokens.to_string(), expected);
    }

    /// Fills one template by both macros, and compares what a lexer reads.
    macro_rules! same_as_quote {
        ([$($name:ident = $texts:expr),*] $($template:tt)*) => {{
            let ours = {
                $(let $name = $texts.map(Ident::new);)*
                quote!($($template)*)
            };
            let theirs = {
                $(let $name = $texts.map(|text| ::quote::format_ident!("{text}"));)*
                ::quote::quote!($($template)*)
            };
            let read: proc_macro2::TokenStream = ours.to_string().parse().unwrap();
            assert_eq!(read.to_string(), theirs.to_string());
        }};
    }

    #[test]
    fn templates_say_what_those_of_quote_say() {
        same_as_quote!([]);
        same_as_quote!([name = Some("Tank"), none = None::<&str>] pub struct #name<'a> #none { pub level: &'a [u8; 4] });
        same_as_quote!([fields = ["a", "b"]] Self { #(#fields: get(p, 0)?),* });
        same_as_quote!([fields = ["a", "b"], types = ["A", "B"]] #(pub #fields,)* impl #(#types)|* {});
        same_as_quote!([none = [""; 0]] wire::topic!(Tank { #(#none),* }, x..=y, -1 << 2, b"n", '\n', r#type));
        same_as_quote!([name = Some("x")] match #name { 0 => { #name } _ => (#name[1], ::wire::f::<{ 8 }>(), *p != !q && a || b) });
    }

    #[test]
    fn templates() {
        let (name, number, none) = (Ident::new("T"), Literal::of(3), None::<Ident>);
        let (fields, texts) = (["a", "b"].map(Ident::new), ["x\"", "\n"]);
        check(&quote!(), "");
        check(
            &quote!(impl<'a> #name #none { const N: [u8; #number] = *b"N"; }),
            "impl < 'a > T { const N : [ u8 ; 3 ] = * b\"N\" ; }",
        );
        let again = fields.clone();
        check(&quote!(Self { #(self.#fields),* } #(, #again)*), "Self { self . a , self . b } , a , b");
        check(&quote!(#(#texts)&&*), "\"x\\\"\" && \"\\n\"");
    }

    #[test]
    fn outer_parentheses_go() {
        check(&quote!((a & (b))).without_parentheses(), "a & ( b )");
        check(&quote!((a) & (b)).without_parentheses(), "( a ) & ( b )");
        check(&quote!(a).without_parentheses(), "a");
    }

    #[test]
    fn paths_are_words() {
        check(&TokenStream::of_path("::a::b"), ":: a :: b");
        check(&TokenStream::of_path("a"), "a");
    }
}

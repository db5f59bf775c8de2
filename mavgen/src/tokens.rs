//! Generated code as tokens, which are text from the start.
//!
//! What `quote` and `proc-macro2` are for macros, in little: a build script compiles this crate and runs it unoptimised, and
//! tokens that are never taken apart need no tree. Each is text that ends with a line break; no token has one inside.

use std::fmt::{self, Display, Write};

/// Generated code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct TokenStream(String);

/// What stands in code for `#name` in [`quote!`]. A text stands as a literal, and a number without a suffix.
pub(crate) trait ToTokens {
    /// Adds it.
    fn to_tokens(&self, tokens: &mut TokenStream);
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

    /// Adds one token.
    pub(crate) fn push_token(&mut self, token: &dyn Display) {
        // Writing into a String cannot fail.
        let _ = writeln!(self.0, "{token}");
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

    /// One token, as it is written.
    pub(crate) fn of(token: impl Display) -> Self {
        let mut tokens = Self::default();
        tokens.push_token(&token);
        tokens
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
}

/// Separated by spaces.
impl Display for TokenStream {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0.trim_end_matches('\n').replace('\n', " ").as_str())
    }
}

impl ToTokens for TokenStream {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.0.push_str(&self.0);
    }
}

impl ToTokens for str {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        tokens.push_token(&format_args!("{self:?}"));
    }
}

impl ToTokens for String {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.as_str().to_tokens(tokens);
    }
}

/// Numbers that are not negative, which would be two tokens.
macro_rules! number {
    ($($number:ty)*) => {$(
        impl ToTokens for $number {
            fn to_tokens(&self, tokens: &mut TokenStream) {
                tokens.push_token(self);
            }
        }
    )*};
}
number!(u8 u16 u32 u64 u128);

impl<T: ToTokens> ToTokens for Option<T> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        if let Some(one) = self {
            one.to_tokens(tokens);
        }
    }
}

impl<T: ToTokens> ToTokens for Box<T> {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        (**self).to_tokens(tokens);
    }
}

impl<T: ToTokens + ?Sized> ToTokens for &T {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        (**self).to_tokens(tokens);
    }
}

/// Code, written as it will be but for what begins with `#`:
///
/// - `#name`, `#{name.value()}`: what a value stands for.
/// - `#(#names),*`: each that a list gives, with a separator or without.
/// - `#(for one in list => pub #{ident(one)};)*`: the same with a pattern, and with anything in it.
/// - `#(if condition => pub)`, `#(if let Some(units) = units => .units(#units))`: nothing if it does not hold.
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
    ($to:ident [$($before:tt)*] #{$value:expr} $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*]);
        $crate::tokens::ToTokens::to_tokens(&$value, &mut $to);
        $crate::tokens::push!($to [] $($behind)*);
    };
    ($to:ident [$($before:tt)*] #(if let $pattern:pat = $value:expr => $($then:tt)*) $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*]);
        if let $pattern = $value {
            $crate::tokens::push!($to [] $($then)*);
        }
        $crate::tokens::push!($to [] $($behind)*);
    };
    ($to:ident [$($before:tt)*] #(if $condition:expr => $($then:tt)*) $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*]);
        if $condition {
            $crate::tokens::push!($to [] $($then)*);
        }
        $crate::tokens::push!($to [] $($behind)*);
    };
    ($to:ident [$($before:tt)*] #($($each:tt)*)* $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*]);
        $crate::tokens::repeat!($to () $($each)*);
        $crate::tokens::push!($to [] $($behind)*);
    };
    ($to:ident [$($before:tt)*] #($($each:tt)*) $separator:tt * $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*]);
        $crate::tokens::repeat!($to ($separator) $($each)*);
        $crate::tokens::push!($to [] $($behind)*);
    };
    ($to:ident [$($before:tt)*] #$name:ident $($behind:tt)*) => {
        $crate::tokens::push!($to [$($before)*] #{$name} $($behind)*);
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

/// Adds a template for each item: of the list that it names, or else of the first name in it.
macro_rules! repeat {
    ($to:ident () for $one:pat in $list:expr => $($each:tt)*) => {
        for $one in $list {
            $crate::tokens::push!($to [] $($each)*);
        }
    };
    ($to:ident ($separator:tt) for $one:pat in $list:expr => $($each:tt)*) => {
        let start = $to.len();
        for $one in $list {
            if start < $to.len() {
                $crate::tokens::push!($to [] $separator);
            }
            $crate::tokens::push!($to [] $($each)*);
        }
    };
    ($to:ident ($($separator:tt)?) $($each:tt)*) => {
        $crate::tokens::repeat!(@ $to ($($separator)?) ($($each)*) $($each)*);
    };
    (@ $to:ident ($($separator:tt)?) ($($each:tt)*) #$name:ident $($behind:tt)*) => {
        $crate::tokens::repeat!($to ($($separator)?) for $name in $name => $($each)*);
    };
    (@ $to:ident ($($separator:tt)?) ($($each:tt)*) $before:tt $($behind:tt)*) => {
        $crate::tokens::repeat!(@ $to ($($separator)?) ($($each)*) $($behind)*);
    };
}
pub(crate) use repeat;

#[cfg(test)]
mod tests {
    use super::*;

    fn word(text: &str) -> TokenStream {
        TokenStream::of(text)
    }

    fn check(tokens: &TokenStream, expected: &str) {
        assert_eq!(tokens.to_string(), expected);
    }

    /// Fills one template by both macros, and compares what a lexer reads.
    macro_rules! same_as_quote {
        ([$($name:ident = $texts:expr),*] $($template:tt)*) => {{
            let ours = {
                $(let $name = $texts.map(word);)*
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
        let (name, number, none) = (word("T"), 3_u8, None::<TokenStream>);
        let (fields, texts) = (["a", "b"].map(word), ["x\"", "\n"]);
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
    fn templates_have_conditions_and_loops() {
        let (names, none) = (["a", "b"], None::<u8>);
        check(
            &quote!(f(#(for (at, name) in names.iter().enumerate() => #{word(name)}: #{at as u64}),*)),
            "f ( a : 0 , b : 1 )",
        );
        check(&quote!(#(for name in names => mod #{word(name)};)* end), "mod a ; mod b ; end");
        check(&quote!(x #(if names.len() > 1 => { y }) #(if names.is_empty() => z)), "x { y }");
        check(
            &quote!(x #(if let Some(one) = Some(1_u8) => .f(#one)) #(if let Some(one) = none => .g(#one)) y),
            "x . f ( 1 ) y",
        );
    }

    #[test]
    fn paths_are_words() {
        check(&TokenStream::of_path("::a::b"), ":: a :: b");
        check(&TokenStream::of_path("a"), "a");
    }
}

//! The surfaces of both states, without what is the same in both: that is most of a dialect, and reading it back is most of the work.

use std::collections::{BTreeMap, HashSet};
use std::iter;

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use super::renamed::Renamed;
use super::state::State;
use super::surface::{Surface, plain, surface};
use crate::emit::content;
use crate::emit::threads::in_order;
use crate::internal::Internal;
use crate::ir::EnumId;
use crate::lower::Items;

/// What users see of the types of both states, but for those of messages and enums whose code is the same in both.
pub(super) fn surfaces(old: &State, new: &State, names: &Renamed<'_>) -> Result<(Surface, Surface), Internal> {
    let renamed = names.changed();
    let (mut before, mut after) = (Surface::new(), Surface::new());
    for pair in in_order(&pairs(old, new), |pair| of_pair(pair, &renamed)) {
        let (old, new) = pair?;
        before.extend(old);
        after.extend(new);
    }
    Ok((before, after))
}

/// What declares types: an enum; a message, which has views.
#[derive(Clone, Copy)]
enum Declared<'a> {
    Enum(&'a State, EnumId),
    Message(&'a State, usize),
}

/// What both states call the same in Rust, and what only one of them has.
type Pair<'a> = [Option<Declared<'a>>; 2];

fn pairs<'a>(old: &'a State, new: &'a State) -> Vec<Pair<'a>> {
    let mut pairs: BTreeMap<&str, Pair<'a>> = BTreeMap::new();
    for (side, state) in [old, new].into_iter().enumerate() {
        let enums = state.names.enums.iter().enumerate();
        let enums = enums.map(|(at, names)| (&names.ty, Declared::Enum(state, EnumId(at))));
        let messages = state.names.messages.iter().enumerate();
        let messages = messages.map(|(at, names)| (&names.ty, Declared::Message(state, at)));
        for (name, declared) in enums.chain(messages) {
            if let Some(place) = pairs.entry(name).or_default().get_mut(side) {
                *place = Some(declared);
            }
        }
    }
    pairs.into_values().collect()
}

/// Nothing if the code is the same, and means the same: it does not if it names what is called differently now.
fn of_pair(pair: &Pair<'_>, renamed: &HashSet<&str>) -> Result<(Surface, Surface), Internal> {
    let [old, new] = pair.map(|declared| declared.map(Declared::code).transpose());
    let (old, new) = (old?, new?);
    if let (Some(old), Some(new)) = (&old, &new)
        && is_same(old, new)
        && (renamed.is_empty() || !names_any(old, renamed))
    {
        return Ok((Surface::new(), Surface::new()));
    }
    Ok((old.map(surface).unwrap_or_default(), new.map(surface).unwrap_or_default()))
}

impl<'a> Declared<'a> {
    fn code(self) -> Result<TokenStream, Internal> {
        let items = |state: &'a State| Items::of(&state.dialect, &state.names, true);
        let contents = match self {
            Self::Enum(state, id) => vec![items(state).enum_content(id)?],
            Self::Message(state, at) => items(state).message_contents(at)?,
        };
        contents.iter().map(content).collect()
    }
}

/// Whether code is the same but for its documentation.
fn is_same(old: &TokenStream, new: &TokenStream) -> bool {
    let (mut old, mut new) = (undocumented(old), undocumented(new));
    loop {
        match (old.next(), new.next()) {
            (None, None) => return true,
            (Some(one), Some(other)) if is_same_token(&one, &other) => {}
            _ => return false,
        }
    }
}

fn is_same_token(one: &TokenTree, other: &TokenTree) -> bool {
    match (one, other) {
        (TokenTree::Group(one), TokenTree::Group(other)) => {
            one.delimiter() == other.delimiter() && is_same(&one.stream(), &other.stream())
        }
        (TokenTree::Ident(one), TokenTree::Ident(other)) => one == other,
        (TokenTree::Punct(one), TokenTree::Punct(other)) => one.as_char() == other.as_char(),
        (TokenTree::Literal(one), TokenTree::Literal(other)) => one.to_string() == other.to_string(),
        _ => false,
    }
}

/// Whether one of these names stands in the code.
fn names_any(code: &TokenStream, names: &HashSet<&str>) -> bool {
    undocumented(code).any(|token| match token {
        TokenTree::Group(group) => names_any(&group.stream(), names),
        TokenTree::Ident(ident) => names.contains(plain(&ident).as_str()),
        _ => false,
    })
}

/// The tokens without documentation, which is not compared: it also has the names of files.
fn undocumented(code: &TokenStream) -> impl Iterator<Item = TokenTree> {
    let mut tokens = code.clone().into_iter().peekable();
    iter::from_fn(move || {
        let mut token = tokens.next()?;
        while matches!(&token, TokenTree::Punct(hash) if hash.as_char() == '#') && tokens.next_if(is_doc).is_some() {
            token = tokens.next()?;
        }
        Some(token)
    })
}

/// `[doc = "…"]`
fn is_doc(token: &TokenTree) -> bool {
    let TokenTree::Group(group) = token else { return false };
    let first = group.stream().into_iter().next();
    group.delimiter() == Delimiter::Bracket && matches!(first, Some(TokenTree::Ident(ident)) if ident == "doc")
}

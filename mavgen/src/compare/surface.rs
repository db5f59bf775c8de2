//! The generated Rust as its users see it: public types and their public members.
//!
//! It is read from the generated items themselves, so that whatever the generator makes public is compared.

use std::collections::BTreeMap;

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{Attribute, Expr, Fields, ImplItem, Item, ItemImpl, Type, Visibility};

/// Public types by name.
pub(super) type Surface = BTreeMap<String, Shape>;

/// What users see of a type.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Shape {
    /// What kind of type: `enum over u8`; empty for a message.
    pub(super) signature: String,
    pub(super) deprecated: bool,
    /// Whether it is built of its public fields, all of them.
    pub(super) exhaustive: bool,
    pub(super) members: BTreeMap<Name, Member>,
}

/// What a member is called.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Name {
    /// A field.
    Field(String),
    /// A constant.
    Constant(String),
    /// A method or function.
    Method(String),
    /// An implementation of a trait.
    Trait(String),
}

/// What users see of a field, constant, method or implementation.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Member {
    /// The type, or the parameters and what they give.
    pub(super) signature: String,
    pub(super) deprecated: bool,
    /// Of a field: its number in `DEFAULT`.
    pub(super) default: Option<String>,
}

/// The public types that some generated items declare.
pub(super) fn surface(items: TokenStream) -> Surface {
    let mut surface = Surface::new();
    // The emitters write whole items, so there is nothing that cannot be read.
    let items = syn::parse2(items).map_or_else(|_| Vec::new(), |file: syn::File| file.items);
    items.into_iter().for_each(|item| add(&mut surface, item));
    surface.retain(|_, shape| shape != &Shape::default());
    surface
}

fn add(surface: &mut Surface, item: Item) {
    match item {
        Item::Struct(item) if is_public(&item.vis) => {
            let shape = surface.entry(plain(&item.ident)).or_default();
            shape.deprecated |= is_deprecated(&item.attrs);
            let exhaustive =
                matches!(&item.fields, Fields::Named(fields) if fields.named.iter().all(|field| is_public(&field.vis)));
            shape.exhaustive = exhaustive;
            shape.signature = if exhaustive { "a struct" } else { "a type" }.to_owned();
            for field in item.fields.into_iter().filter(|field| is_public(&field.vis)) {
                let Some(name) = field.ident.as_ref().map(plain) else { continue };
                let member = shape.members.entry(Name::Field(name)).or_default();
                member.signature = readable(field.ty);
                member.deprecated = is_deprecated(&field.attrs);
            }
        }
        // The name of a deprecated message; the struct does not say that it is.
        Item::Type(item) if is_public(&item.vis) => {
            surface.entry(plain(&item.ident)).or_default().deprecated = is_deprecated(&item.attrs);
        }
        Item::Impl(item) => add_impl(surface, item),
        Item::Macro(item) => {
            let words: Vec<String> = item.mac.tokens.into_iter().filter_map(word).collect();
            let kind = item.mac.path.segments.last().map(|segment| plain(&segment.ident)).unwrap_or_default();
            if let ([name, int, ..], Some(kind)) = (words.as_slice(), enum_kind(&kind)) {
                surface.entry(name.clone()).or_default().signature = format!("{kind} of {int}");
            }
        }
        _ => {}
    }
}

/// What the runtime's macro of this name makes of a newtype.
fn enum_kind(name: &str) -> Option<&'static str> {
    match name {
        "open_enum" => Some("an enum"),
        "flags" => Some("flags"),
        _ => None,
    }
}

fn word(token: TokenTree) -> Option<String> {
    match token {
        TokenTree::Ident(ident) => Some(plain(&ident)),
        _ => None,
    }
}

fn add_impl(surface: &mut Surface, item: ItemImpl) {
    let Type::Path(path) = item.self_ty.as_ref() else { return };
    let Some(name) = path.path.segments.last().map(|segment| plain(&segment.ident)) else { return };
    let shape = surface.entry(name).or_default();
    if let Some((of, _)) = item.trait_ {
        shape.members.entry(Name::Trait(readable(of))).or_default();
        item.items.into_iter().for_each(|item| add_default(shape, item));
        return;
    }
    for item in item.items {
        let (name, member) = match item {
            ImplItem::Const(item) if is_public(&item.vis) => {
                let member =
                    Member { signature: readable(item.ty), deprecated: is_deprecated(&item.attrs), default: None };
                (Name::Constant(plain(&item.ident)), member)
            }
            ImplItem::Fn(item) if is_public(&item.vis) => {
                let name = plain(&item.sig.ident);
                let signature = readable(&item.sig);
                // What stands before the parameters is the name, but for `const`, which is a promise like others.
                let signature = signature.replacen(&format!("fn {}", item.sig.ident), "fn", 1);
                (Name::Method(name), Member { signature, deprecated: is_deprecated(&item.attrs), default: None })
            }
            _ => continue,
        };
        shape.members.insert(name, member);
    }
}

/// Notes which numbers `DEFAULT` has; all other values hang on the types of the fields alone.
fn add_default(shape: &mut Shape, item: ImplItem) {
    let ImplItem::Const(item) = item else { return };
    let Expr::Struct(value) = item.expr else { return };
    for field in value.fields {
        let syn::Member::Named(name) = &field.member else { continue };
        if let Expr::Lit(number) = field.expr {
            shape.members.entry(Name::Field(plain(name))).or_default().default = Some(readable(number));
        }
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn is_deprecated(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| attribute.path().is_ident("deprecated"))
}

/// An identifier, without the mark of a raw one.
pub(super) fn plain(ident: &proc_macro2::Ident) -> String {
    let text = ident.to_string();
    text.strip_prefix("r#").unwrap_or(&text).to_owned()
}

/// Tokens with no more blanks than a person would write.
fn readable(tokens: impl ToTokens) -> String {
    let mut text = tokens.to_token_stream().to_string();
    for (wide, narrow) in [
        (" :: ", "::"),
        (" < ", "<"),
        (" >", ">"),
        ("& ", "&"),
        (" ;", ";"),
        (" ,", ","),
        (" :", ":"),
        (" (", "("),
        ("( ", "("),
        (" )", ")"),
    ] {
        text = text.replace(wide, narrow);
    }
    text
}

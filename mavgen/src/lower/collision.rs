//! What is said of names that collide: every sentence of the kind stands here.

use super::namespace::{Claim, Collision, Namespace, Scope, What};
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::Name;
use crate::source::Span;

/// Reports collisions.
pub(super) fn report<'a>(found: impl IntoIterator<Item = Collision<'a>>, diagnostics: &mut Diagnostics) {
    found.into_iter().for_each(|collision| diagnostics.extend(diagnostic(&collision)));
}

/// Whether a name was free; if not, the collision is reported.
pub(super) fn is_free(found: Option<Collision<'_>>, diagnostics: &mut Diagnostics) -> bool {
    let is_free = found.is_none();
    report(found, diagnostics);
    is_free
}

/// Reports which of these have the name of something else in their scope.
pub(super) fn apart<'a>(
    scope: Scope,
    claims: impl Iterator<Item = Claim<'a>>,
    names: &[String],
    diagnostics: &mut Diagnostics,
) {
    let claims = claims.zip(names).map(|(claim, name)| (name.clone(), claim));
    report(Namespace::of(scope).claim_by_age(claims.collect_vec()), diagnostics);
}

/// The diagnostic about a collision; none if it is no mistake, or is reported as another.
///
/// Definitions that are spelled alike are duplicates, and a text that is no name has none: `resolve` reports both. A field
/// without accessors because every message has their names is not its author's mistake.
fn diagnostic(collision: &Collision<'_>) -> Option<Diagnostic> {
    let Collision { scope, name, first, second } = collision;
    let is_named_freely = |what| matches!(what, What::Reserved(_) | What::Param | What::Root);
    let is_name = |claim: &Claim<'_>| is_named_freely(claim.what) || Name::fault(claim.text).is_none();
    if !is_name(first) || !is_name(second) {
        return None;
    }
    let alike = first.text == second.text;
    match scope {
        Scope::Types | Scope::Fields | Scope::Constants if alike && second.what != What::View => None,
        Scope::Types | Scope::Fields | Scope::Constants => Some(both(name, first, second)),
        Scope::Commands => Some(command_lost(name, first, second)),
        Scope::Params => Some(label_taken(name, first, second)),
        Scope::Methods if second.what == What::Accessors => accessors_lost(name, first, second),
        Scope::Methods | Scope::ViewMethods | Scope::SlotFields | Scope::RecordFields => {
            Some(twice(name, first, second))
        }
        Scope::Modules => Some(one_module(name, first, second)),
    }
}

/// Definitions of different spellings, one name.
fn both(name: &str, first: &Claim<'_>, second: &Claim<'_>) -> Diagnostic {
    let message = if first.text == second.text {
        format!("there is a type `{name}` already")
    } else {
        let kind = if first.what == second.what { plural(first.what) } else { "types" };
        format!("{kind} `{}` and `{}` are both `{name}` in Rust", first.text, second.text)
    };
    beside(problem(Code::NameCollision, second, message).help("rename one of them"), first, "the other one")
}

fn plural(what: What) -> &'static str {
    match what {
        What::Message => "messages",
        What::Field => "fields",
        What::Entry => "entries",
        _ => "types",
    }
}

/// Methods, or fields of a slot or record, of one name.
fn twice(name: &str, first: &Claim<'_>, second: &Claim<'_>) -> Diagnostic {
    let (what, other) = (role(second), role(first));
    let message = match what == other {
        true => format!("`{name}` stands twice in the view"),
        false => format!("`{name}` is {what}, and {other} as well"),
    };
    beside(problem(Code::NameCollision, second, message).help("rename one of them"), first, "the other one")
}

/// What has a name, in words.
fn role(claim: &Claim<'_>) -> String {
    let text = claim.text;
    match claim.what {
        What::Reserved(what) => what.to_owned(),
        What::Accessors | What::Field => format!("a method of field `{text}`"),
        What::Binding => format!("a method of binding `{text}`"),
        What::View => format!("a method of view `{text}`"),
        What::Switch => "the getter of the switch".to_owned(),
        What::Key => format!("key `{text}`"),
        What::Value => format!("value `{text}`"),
        What::Member | What::Message | What::Enum | What::Entry | What::Param | What::Root => {
            format!("a method of `{text}`")
        }
    }
}

/// Of two fields whose accessors share a name, the first in the XML has them: a definition that is valid elsewhere is not
/// refused.
fn accessors_lost(name: &str, first: &Claim<'_>, second: &Claim<'_>) -> Option<Diagnostic> {
    let message = format!("field `{}` has no getter and setter: `{name}` is there already", second.text);
    Some(problem(Code::AccessorLost, second, message).related(first.span?, format!("this field has `{name}`")))
}

/// Two commands that would be one type: a definition that is valid elsewhere is not refused.
fn command_lost(name: &str, first: &Claim<'_>, second: &Claim<'_>) -> Diagnostic {
    let message = format!("command `{}` has no type: `commands::{name}` is `{}`", second.text, first.text);
    let problem = problem(Code::CommandLost, second, message).help("send it as a plain `COMMAND_LONG`, or rename it");
    beside(problem, first, "this command has it")
}

/// Two params of one label.
fn label_taken(name: &str, first: &Claim<'_>, second: &Claim<'_>) -> Diagnostic {
    let message = format!("label `{}` is that of another param, which is `{name}` in Rust", second.text);
    let help = "this one is named after its number; give it another label";
    beside(problem(Code::ParamLabel, second, message).help(help), first, "the other one")
}

/// A label that makes no name.
pub(super) fn no_label(label: &str, span: Span) -> Diagnostic {
    let message = format!("label `{label}` has no letter that a name can have");
    Diagnostic::new(Code::ParamLabel, span, message)
        .help("the param is named after its number; use letters and digits of ASCII")
}

/// Two dialects that would be one module.
fn one_module(name: &str, first: &Claim<'_>, second: &Claim<'_>) -> Diagnostic {
    let message = format!("`{}` and `{}` would both be the module `{name}`", first.text, second.text);
    problem(Code::RootModule, second, message).help("rename one of the files")
}

/// The dialect's own type, which is named after its file, and what has that name.
pub(super) fn of_dialect(dialect: &str, name: &str, first: &Claim<'_>) -> Diagnostic {
    let message = format!("the dialect `{dialect}` and `{}` are both `{name}` in Rust", first.text);
    problem(Code::NameCollision, first, message).help("rename the file, or give the dialect another name")
}

/// A file can be called anything, also what makes no name for a dialect.
pub(super) fn no_name(dialect: &str) -> Diagnostic {
    let message = format!("`{dialect}` makes no Rust name for a dialect");
    Diagnostic::without_place(Code::BadName, message).help("name the file, or the dialect, with letters and digits")
}

fn problem(code: Code, claim: &Claim<'_>, message: String) -> Diagnostic {
    match claim.span {
        Some(span) => Diagnostic::new(code, span, message),
        None => Diagnostic::without_place(code, message),
    }
}

/// Shows what has the name, if that stands somewhere.
fn beside(problem: Diagnostic, first: &Claim<'_>, label: &str) -> Diagnostic {
    match first.span {
        Some(span) => problem.related(span, label),
        None => problem,
    }
}

//! `<refine>`: what the definitions leave unsaid about an enum.

use std::collections::HashMap;

use super::super::boolean;
use super::super::enums::{Enums, Merged};
use super::super::spelling;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::EnumId;
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::overlay::Refinement;
use crate::syntax::{Stage, Text};

/// Where an attribute of an enum was refined first.
type Seen<'a> = HashMap<(&'a str, &'static str), Span>;

/// Applies the refinements of all overlays.
pub(in crate::resolve) fn apply<'a>(loaded: &'a Loaded, enums: &mut Enums<'a>, diagnostics: &mut Diagnostics) {
    let mut seen = Seen::new();
    for refinement in loaded.overlays.iter().flat_map(|overlay| &overlay.refinements) {
        if refinement.bitmask.is_none() && refinement.deprecated.is_none() {
            let message = format!("nothing is said of enum `{}`", refinement.enum_.value);
            let problem = Diagnostic::new(Code::Refinement, refinement.span, message);
            diagnostics.push(problem.help("add `bitmask=\"true\"` or `deprecated=\"false\"`"));
        }
        let Some(EnumId(index)) = find(refinement, enums, diagnostics) else { continue };
        let Some(merged) = enums.list.get_mut(index) else { continue };
        if let Some(text) = &refinement.bitmask {
            check_first(refinement, text, "bitmask", &mut seen, diagnostics);
            refine_bitmask(merged, text, diagnostics);
        }
        if let Some(text) = &refinement.deprecated {
            check_first(refinement, text, "deprecated", &mut seen, diagnostics);
            refine_deprecated(merged, text, diagnostics);
        }
    }
}

fn find(refinement: &Refinement, enums: &Enums<'_>, diagnostics: &mut Diagnostics) -> Option<EnumId> {
    spelling::overlay_enum(&refinement.enum_, enums, diagnostics)
}

fn check_first<'a>(
    refinement: &'a Refinement,
    text: &Text,
    attribute: &'static str,
    seen: &mut Seen<'a>,
    diagnostics: &mut Diagnostics,
) {
    let name = &refinement.enum_.value;
    if let Some(first) = seen.insert((name, attribute), text.span) {
        let message = format!("`{attribute}` of enum `{name}` is refined twice");
        let problem = Diagnostic::new(Code::Refinement, text.span, message).related(first, "the first time");
        diagnostics.push(problem.help("leave one of them out"));
    }
}

fn refine_bitmask(merged: &mut Merged<'_>, text: &Text, diagnostics: &mut Diagnostics) {
    let Some(bitmask) = boolean::of_overlay(text, diagnostics) else { return };
    if merged.blocks.iter().all(|block| block.bitmask == bitmask) {
        diagnostics.push(needless(merged, text, if bitmask { "a bitmask already" } else { "no bitmask" }));
    }
    merged.refined.bitmask = Some(bitmask);
}

fn refine_deprecated(merged: &mut Merged<'_>, text: &Text, diagnostics: &mut Diagnostics) {
    let Some(deprecated) = boolean::of_overlay(text, diagnostics) else { return };
    if deprecated {
        let message = format!("an overlay cannot deprecate enum `{}`", merged.name.value);
        let problem = Diagnostic::new(Code::Refinement, text.span, message);
        diagnostics.push(problem.help("only `deprecated=\"false\"` is understood"));
        return;
    }
    let stages = merged.blocks.iter().filter_map(|block| block.syntax.lifecycle.as_ref());
    if !stages.into_iter().any(|lifecycle| lifecycle.stage == Stage::Deprecated) {
        diagnostics.push(needless(merged, text, "not deprecated"));
    }
    merged.refined.in_use = true;
}

fn needless(merged: &Merged<'_>, text: &Text, what: &str) -> Diagnostic {
    let message = format!("enum `{}` is {what}", merged.name.value);
    let problem = Diagnostic::new(Code::NeedlessRefinement, text.span, message).label("not needed");
    problem.related(merged.name.span, "the definition").help("leave it out")
}

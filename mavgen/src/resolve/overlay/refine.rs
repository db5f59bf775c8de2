//! `<refine>`: what the definitions leave unsaid about an enum.

use std::collections::HashMap;

use super::super::boolean;
use super::super::enums::{Enums, Merged};
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::EnumId;
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::{Stage, Text};

/// What takes the value of an attribute in.
type Refine = fn(&mut Merged<'_>, &Text, bool, &mut Diagnostics);

/// Applies the refinements of all overlays.
pub(in crate::resolve) fn apply<'a>(loaded: &'a Loaded, enums: &mut Enums<'a>, diagnostics: &mut Diagnostics) {
    // Where an attribute of an enum was refined first.
    let mut seen: HashMap<(&str, &str), Span> = HashMap::new();
    for refinement in loaded.overlays.iter().flat_map(|overlay| &overlay.refinements) {
        let name = &refinement.enum_;
        if refinement.bitmask.is_none() && refinement.deprecated.is_none() {
            let message = format!("nothing is said of enum `{}`", name.value);
            let problem = Diagnostic::new(Code::Refinement, refinement.span, message);
            diagnostics.push(problem.help("add `bitmask=\"true\"` or `deprecated=\"false\"`"));
        }
        let Some(EnumId(index)) = enums.find(name, diagnostics) else { continue };
        let Some(merged) = enums.list.get_mut(index) else { continue };
        let attributes: [(_, _, Refine); 2] = [
            (&refinement.bitmask, "bitmask", refine_bitmask),
            (&refinement.deprecated, "deprecated", refine_deprecated),
        ];
        for (text, attribute, refine) in attributes {
            let Some(said) = text else { continue };
            if let Some(first) = seen.insert((&name.value, attribute), said.span) {
                let message = format!("`{attribute}` of enum `{}` is refined twice", name.value);
                let problem = Diagnostic::new(Code::Refinement, said.span, message).related(first, "the first time");
                diagnostics.push(problem.help("leave one of them out"));
            }
            if let Some(value) = boolean::of_overlay(text, diagnostics) {
                refine(merged, said, value, diagnostics);
            }
        }
    }
}

fn refine_bitmask(merged: &mut Merged<'_>, text: &Text, bitmask: bool, diagnostics: &mut Diagnostics) {
    if merged.blocks.iter().all(|block| block.bitmask == bitmask) {
        diagnostics.push(needless(merged, text, if bitmask { "a bitmask already" } else { "no bitmask" }));
    }
    merged.refined_bitmask = Some(bitmask);
}

fn refine_deprecated(merged: &mut Merged<'_>, text: &Text, deprecated: bool, diagnostics: &mut Diagnostics) {
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
    merged.in_use = true;
}

fn needless(merged: &Merged<'_>, text: &Text, what: &str) -> Diagnostic {
    let message = format!("enum `{}` is {what}", merged.name.value);
    let problem = Diagnostic::new(Code::NeedlessRefinement, text.span, message).label("not needed");
    problem.related(merged.name.span, "the definition").help("leave it out")
}

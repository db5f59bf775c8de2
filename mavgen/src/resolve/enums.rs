//! The enums of all files, merged by name as pymavlink's `merge_enums` does it.

mod block;

use std::cmp::Reverse;
use std::collections::HashMap;

use super::lost::Poisoned;
use super::suggest;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::ir::{EnumId, FileIndex};
use crate::order;
use crate::read::Loaded;
use crate::source::Span;
use crate::syntax::Text;

use block::Block;
pub(super) use block::ValuedEntry;

/// More definitions of one enum than any dialect has: every one can move every automatic value before it.
const MOST_DEFINITIONS: usize = 256;

/// An enum, merged from one or more definitions.
pub(super) struct Merged<'a> {
    /// The name, at the first definition.
    pub(super) name: &'a Text,
    /// The file of the first definition.
    pub(super) file: FileIndex,
    /// The start tag of the first definition.
    pub(super) span: Span,
    /// The definitions in merge order; their entries have moved to [`Merged::entries`].
    pub(super) blocks: Vec<Block<'a>>,
    /// The entries by value.
    pub(super) entries: Vec<ValuedEntry<'a>>,
    /// Whether its values are combined bit by bit, if an overlay says so.
    pub(super) refined_bitmask: Option<bool>,
    /// Whether an overlay says that it is in use, although deprecated.
    pub(super) in_use: bool,
    /// Smallest and largest value of the first definition; as in pymavlink, later ones do not count.
    range: Option<(u128, u128)>,
}

/// All enums, in the order of their first definitions; those of overlays come last.
pub(super) struct Enums<'a> {
    pub(super) list: Vec<Merged<'a>>,
    /// Whether no definition was lost before: only then is a name without an enum worth a word.
    pub(super) complete: bool,
    by_name: HashMap<&'a str, EnumId>,
}

impl<'a> Enums<'a> {
    /// Merges the enums of all files.
    pub(super) fn merge(loaded: &'a Loaded, poisoned: &Poisoned, diagnostics: &mut Diagnostics) -> Self {
        let mut enums = Self { list: Vec::new(), complete: !poisoned.any(), by_name: HashMap::new() };
        for (index, file) in loaded.files.iter().enumerate() {
            for element in &file.enums {
                let block = Block::read(FileIndex(index), element, poisoned, diagnostics);
                enums.add(block, diagnostics);
            }
        }
        for (file, overlay) in loaded.numbered_overlays() {
            for element in &overlay.enums {
                // It has to be new: what includes the dialect elsewhere may not know the overlay.
                match enums.id(&element.name.value).and_then(|id| enums.get(id)) {
                    Some(first) => diagnostics.push(redefined(&element.name, first)),
                    None => enums.add(Block::read(file, element, poisoned, diagnostics), diagnostics),
                }
            }
        }
        for merged in &mut enums.list {
            check(merged, diagnostics);
            order::sort_by_key(&mut merged.entries, |entry| entry.value);
        }
        enums
    }

    fn add(&mut self, block: Block<'a>, diagnostics: &mut Diagnostics) {
        let name = block.syntax.name.value.as_str();
        let Some(merged) = self.by_name.get(name).and_then(|id| self.list.get_mut(id.0)) else {
            self.by_name.insert(name, EnumId(self.list.len()));
            self.list.push(Merged::new(block));
            return;
        };
        let mut before = merged.blocks.iter().filter(|first| first.file == block.file);
        if let (Some(first), None) = (before.next(), before.next()) {
            diagnostics.push(twice(&block, first));
        }
        if merged.blocks.len() == MOST_DEFINITIONS {
            diagnostics.push(too_many(&block));
        }
        merged.add(block);
    }

    /// The enum that an overlay names; one that there is not is reported.
    pub(super) fn find(&self, name: &Text, diagnostics: &mut Diagnostics) -> Option<EnumId> {
        let id = self.id(&name.value);
        if id.is_none() {
            self.report_unknown(name, Code::OverlayEnum, "", diagnostics);
        }
        id
    }

    /// Reports the name of an enum that there is not, unless it may have been lost; `of` is what it belongs to.
    pub(super) fn report_unknown(&self, name: &Text, code: Code, of: &str, diagnostics: &mut Diagnostics) {
        if self.complete {
            let message = format!("enum `{}`{of} does not exist", name.value);
            let problem = Diagnostic::new(code, name.span, message).label("no such enum");
            suggest::report(problem, &name.value, &mut self.names(), diagnostics);
        }
    }

    /// The enum of that name.
    pub(super) fn id(&self, name: &str) -> Option<EnumId> {
        self.by_name.get(name).copied()
    }

    pub(super) fn get(&self, id: EnumId) -> Option<&Merged<'a>> {
        self.list.get(id.0)
    }

    /// Whether every entry of every enum is there, and has its value.
    pub(super) fn is_exact(&self) -> bool {
        self.complete && self.list.iter().all(Merged::is_exact)
    }

    /// The names, in the order of the enums.
    pub(super) fn names(&self) -> impl Iterator<Item = &'a str> {
        self.list.iter().map(|merged| merged.name.value.as_str())
    }
}

impl<'a> Merged<'a> {
    fn new(mut block: Block<'a>) -> Self {
        let range = block.start().map(|start| (start, block.highest));
        let entries = std::mem::take(&mut block.entries);
        let (name, file, span) = (&block.syntax.name, block.file, block.syntax.span);
        Self { name, file, span, blocks: vec![block], entries, refined_bitmask: None, in_use: false, range }
    }

    /// Takes in a later definition.
    ///
    /// Automatic values of earlier files make way for it, but only where its values overlap those of the very first
    /// definition: pymavlink never updates that range. Automatic values of the later file never move.
    fn add(&mut self, mut block: Block<'a>) {
        if let (Some((first, last)), Some(start)) = (self.range, block.start())
            && self.blocks.len() < MOST_DEFINITIONS
            && first <= block.highest
            && last >= start
        {
            for entry in self.entries.iter_mut().filter(|entry| entry.auto) {
                if entry.value <= block.highest {
                    entry.value = block.highest + 1;
                    block.highest = entry.value;
                }
            }
        }
        self.entries.append(&mut block.entries);
        self.blocks.push(block);
    }

    /// The name at the definition in the oldest file, and that file.
    pub(super) fn oldest(&self, loaded: &Loaded) -> (FileIndex, &'a Text) {
        let named = self.blocks.iter().map(|block| (block.file, &block.syntax.name));
        named.min_by_key(|(file, _)| loaded.age(*file)).unwrap_or((self.file, self.name))
    }

    /// Whether the values are combined bit by bit: as an overlay says, or else the defining file.
    pub(super) fn bitmask(&self, defining_file: FileIndex) -> bool {
        self.refined_bitmask.unwrap_or_else(|| self.declared_bitmask(defining_file))
    }

    /// What the first definition in the file that owns the enum says.
    pub(super) fn declared_bitmask(&self, defining_file: FileIndex) -> bool {
        self.defining_block(defining_file).is_some_and(|block| block.bitmask)
    }

    /// The name at the first definition in `defining_file`.
    pub(super) fn defining_span(&self, defining_file: FileIndex) -> Span {
        self.defining_block(defining_file).map_or(self.name.span, |block| block.syntax.name.span)
    }

    fn defining_block(&self, defining_file: FileIndex) -> Option<&Block<'a>> {
        self.blocks.iter().find(|block| block.file == defining_file)
    }

    /// The names of the entries, by value.
    pub(super) fn entry_names(&self) -> impl Iterator<Item = &'a str> {
        self.entries.iter().map(|entry| entry.syntax.name.value.as_str())
    }

    /// The largest value, of those that are not refused for being beyond 64 bits; zero if there is none.
    pub(super) fn largest(&self) -> u64 {
        self.entries.iter().rev().find_map(|entry| u64::try_from(entry.value).ok()).unwrap_or_default()
    }

    /// Whether every entry is there, and has its value.
    fn is_exact(&self) -> bool {
        self.blocks.iter().all(|block| block.exact)
    }
}

/// Reports automatic values, and names and values that stand twice. The entries are still in merge order; of two in different
/// files the second is that of the file that includes the other, because its author is who can mend it.
fn check(merged: &Merged<'_>, diagnostics: &mut Diagnostics) {
    let exact = merged.is_exact();
    let mut names = HashMap::new();
    let mut values = HashMap::new();
    let mut entries = merged.entries.iter().collect_vec();
    order::sort_by_key(&mut entries, |entry| Reverse(entry.file));
    for entry in entries {
        let same_name = names.insert(entry.syntax.name.value.as_str(), entry);
        // A value that was guessed beside one that could not be read says nothing.
        let known = exact || !entry.auto;
        let same_value = if known { values.insert(entry.value, entry) } else { None };
        match (same_name, same_value) {
            (Some(first), _) => diagnostics.push(duplicate_name(merged, entry, first)),
            (None, Some(first)) => diagnostics.push(duplicate_value(entry, first)),
            (None, None) if known && entry.auto => automatic(entry, diagnostics),
            (None, None) => {}
        }
    }
}

fn too_many(block: &Block<'_>) -> Diagnostic {
    let name = &block.syntax.name;
    let message = format!("enum `{}` has more than {MOST_DEFINITIONS} definitions", name.value);
    Diagnostic::new(Code::TooLarge, name.span, message)
}

fn twice(block: &Block<'_>, first: &Block<'_>) -> Diagnostic {
    let name = &block.syntax.name;
    let message = format!("enum `{}` is defined twice in this file", name.value);
    let problem = Diagnostic::new(Code::EnumTwice, name.span, message).label("its entries are added to the first");
    problem.related(first.syntax.name.span, "the first one").help("put all entries into one `<enum>`")
}

fn redefined(name: &Text, first: &Merged<'_>) -> Diagnostic {
    let message = format!("enum `{}` is defined already", name.value);
    let problem = Diagnostic::new(Code::RedefinedEnum, name.span, message);
    let problem = problem.related(first.name.span, "the definition");
    problem.help("an overlay can define new enums; of others it can say more with `<refine>` and `<note>`")
}

fn duplicate_name(merged: &Merged<'_>, entry: &ValuedEntry<'_>, first: &ValuedEntry<'_>) -> Diagnostic {
    let name = &entry.syntax.name;
    let message = format!("entry `{}` stands twice in enum `{}`", name.value, merged.name.value);
    let problem = Diagnostic::new(Code::DuplicateEntry, name.span, message).label("second entry of this name");
    problem.related(first.syntax.name.span, "first entry of this name")
}

fn duplicate_value(entry: &ValuedEntry<'_>, first: &ValuedEntry<'_>) -> Diagnostic {
    let (name, value) = (&entry.syntax.name.value, entry.value);
    let message = format!("`{name}` has the value {value}, which `{}` has already", first.syntax.name.value);
    let place = |entry: &ValuedEntry<'_>| entry.syntax.value.as_ref().map_or(entry.syntax.name.span, |text| text.span);
    let label = |entry: &ValuedEntry<'_>| if entry.auto { "given automatically" } else { "" };
    let problem = Diagnostic::new(Code::DuplicateValue, place(entry), message).label(label(entry));
    let problem = problem.related(place(first), format!("{value} is first used here"));
    if entry.auto || first.auto { problem.help("write both values out") } else { problem }
}

/// Says which value an entry was given (pymavlink prints a note), or that there was none left.
fn automatic(entry: &ValuedEntry<'_>, diagnostics: &mut Diagnostics) {
    let (name, value) = (&entry.syntax.name, entry.value);
    diagnostics.push(if u64::try_from(value).is_ok() {
        let message = format!("`{}` has no value and is given {value}", name.value);
        let problem = Diagnostic::new(Code::AutomaticValue, name.span, message);
        problem.help(format!("write `value=\"{value}\"`: a new entry elsewhere can move an automatic value"))
    } else {
        let message = format!("`{}` would be given {value}, which is above 2^64 - 1", name.value);
        Diagnostic::new(Code::BadValue, name.span, message).help("write a value out")
    });
}

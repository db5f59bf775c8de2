//! A part of a dialect: the messages of a selection, what they need, and what makes all that what it is in the whole.
//!
//! [`Builder::messages`](crate::Builder::messages) cuts a model, in which everything is decided. The files of a part are resolved
//! anew, and there what decides could be missing:
//!
//! - the integer of an enum is that of the widest field of its defining file, and which file that is can hang on whose
//!   fields carry it: a message with such a field stays, if its enum would become another one without it;
//! - a sentinel can be an entry of any enum (`invalid="MAV_LANDED_STATE_UNDEFINED"`): that enum stays;
//! - an enum that is named where it has no say, like that of a `float`, has to exist all the same: it stays;
//! - an enum, or the dialect, that is called like a message or enum is named otherwise in Rust: that one stays.
//!
//! So no type is another one in a part, and code for the part works with the whole. What stays for these reasons is said. All
//! definitions of an enum stay or go together, so that entries, values and the prefix of their names are those of the whole.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::builder::Failure;
use crate::diag::Diagnostics;
use crate::ir::{Dialect, Enum, Kept, Message};
use crate::lower::spelling;
use crate::problems::Problems;
use crate::read::{Loaded, read};
use crate::roots::{Named, resolve};
use crate::select::Selection;
use crate::source::Sources;
use crate::syntax;

/// Something that nobody asked for, and that is in the copies so that nothing else changes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Retained {
    /// What it is: `message GIMBAL_MANAGER_SET_ATTITUDE`.
    pub name: String,
    /// Why it is there: what would be different without it.
    pub why: String,
}

/// The messages and enums that stay.
#[derive(Debug)]
pub(super) struct Part {
    messages: BTreeSet<String>,
    enums: BTreeSet<String>,
    /// What of that stays for another reason than that it was asked for, or is needed by that.
    pub(super) retained: Vec<Retained>,
}

impl Part {
    /// The part of the dialect `whole` that is selected, of the files `loaded`.
    ///
    /// # Errors
    /// [`Failure::Usage`] if a name means no message.
    pub(super) fn of(
        selection: &Selection,
        whole: &Named,
        loaded: &Loaded,
        sources: &Sources,
    ) -> Result<Self, Failure> {
        let dialect = &whole.dialect;
        selection.check(&[dialect]).map_err(Failure::Usage)?;
        let selected = dialect.messages.iter().filter(|message| selection.has(&message.name.text));
        let messages = selected.map(|message| message.name.text.clone()).collect();
        let mut part = Self { messages, enums: BTreeSet::new(), retained: Vec::new() };
        loop {
            let before = part.retained.len();
            let model = part.model(whole);
            part.enums.extend(model.dialect.enums.iter().map(|enum_| enum_.name.text.clone()));
            part.keep_named(dialect, loaded);
            part.keep_names(whole, &model);
            if part.retained.len() == before {
                part.keep_owners(dialect, &model.dialect, loaded, sources)?;
            }
            if part.retained.len() == before {
                return Ok(part);
            }
        }
    }

    pub(super) fn has_message(&self, message: &syntax::Message) -> bool {
        self.messages.contains(&message.name.value)
    }

    pub(super) fn has_enum(&self, enum_: &syntax::Enum) -> bool {
        self.enums.contains(&enum_.name.value)
    }

    /// The model as it should be: cut out of that of the whole.
    fn model(&self, whole: &Named) -> Named {
        let wants_enum = |enum_: &Enum| self.enums.contains(&enum_.name.text);
        let mut model = whole.clone();
        model.cut(&Kept::of(&whole.dialect, |message| self.messages.contains(&message.name.text), wants_enum));
        model
    }

    /// Keeps the enums that the XML names, of which the model need not know.
    fn keep_named(&mut self, whole: &Dialect, loaded: &Loaded) {
        let messages = loaded.files.iter().flat_map(|file| &file.messages);
        let messages: Vec<_> = messages.filter(|message| self.has_message(message)).collect();
        for (message, field) in messages.iter().flat_map(|one| one.fields.iter().map(move |field| (one, field))) {
            let place = || format!("{}.{}", message.name.value, field.name.value);
            if let Some(name) = &field.enum_ {
                self.keep_enum_named(&name.value, whole, || format!("`{}` names it", place()));
            }
            if let Some(invalid) = &field.invalid {
                let name = invalid.value.trim_matches(['[', ']', ':', ',', ' ']);
                let named = |enum_: &&Enum| enum_.entries.iter().any(|entry| entry.name.text == name);
                for enum_ in whole.enums.iter().filter(named) {
                    self.keep_enum(enum_, format!("`invalid` of `{}` is an entry of it", place()));
                }
            }
        }
        let enums = loaded.files.iter().flat_map(|file| &file.enums);
        let entries: Vec<_> = enums.filter(|enum_| self.has_enum(enum_)).flat_map(|enum_| &enum_.entries).collect();
        for (entry, param) in entries.iter().flat_map(|one| one.params.iter().map(move |param| (one, param))) {
            if let Some(name) = &param.enum_ {
                self.keep_enum_named(&name.value, whole, || format!("a param of `{}` names it", entry.name.value));
            }
        }
    }

    fn keep_enum_named(&mut self, name: &str, whole: &Dialect, why: impl Fn() -> String) {
        whole.enums.iter().filter(|one| one.name.text == name).for_each(|one| self.keep_enum(one, why()));
    }

    /// Keeps what enums and the dialect are not called after.
    fn keep_names(&mut self, whole: &Named, model: &Named) {
        for (enum_, names) in model.dialect.enums.iter().zip(&model.names.enums) {
            let rust = spelling::type_name(&enum_.name.text);
            let why = || format!("without it, enum `{}` would have another name in Rust", enum_.name.text);
            if rust != names.ty {
                self.keep_called(&rust, whole, why);
            }
        }
        let rust = spelling::type_name(&whole.dialect.name);
        if rust != whole.names.dialect {
            self.keep_called(&rust, whole, || "without it, the dialect's type would have another name in Rust".into());
        }
    }

    /// Keeps the messages and enums that have a name in Rust.
    fn keep_called(&mut self, rust: &str, whole: &Named, why: impl Fn() -> String) {
        let Named { dialect, names } = whole;
        let messages = dialect.messages.iter().zip(&names.messages).filter(|(_, names)| names.ty == rust);
        messages.for_each(|(message, _)| self.keep_message(message, why()));
        let enums = dialect.enums.iter().zip(&names.enums).filter(|(_, names)| names.ty == rust);
        enums.for_each(|(enum_, _)| self.keep_enum(enum_, why()));
    }

    /// Keeps a message that decides on the integer or the defining file of an enum, for each that would have others.
    fn keep_owners(
        &mut self,
        whole: &Dialect,
        model: &Dialect,
        loaded: &Loaded,
        sources: &Sources,
    ) -> Result<(), Failure> {
        let mut diagnostics = Diagnostics::default();
        let Some(anew) = resolve(&self.cut(loaded, sources), sources, &mut diagnostics) else {
            let (sources, watched) = (sources.clone(), loaded.watched.clone());
            return Err(Failure::Definitions(Box::new(Problems { diagnostics, sources, watched })));
        };
        for (enum_, anew) in model.enums.iter().zip(&anew.dialect.enums) {
            if (enum_.repr, enum_.defined_in) != (anew.repr, anew.defined_in)
                && let Some(message) = decider(whole, enum_)
            {
                let name = &enum_.name.text;
                self.keep_message(message, format!("without it, enum `{name}` would be another integer in Rust"));
            }
        }
        Ok(())
    }

    /// The files with nothing but the part; which messages see the version does not matter to enums.
    fn cut(&self, loaded: &Loaded, sources: &Sources) -> Loaded {
        let mut loaded = loaded.clone();
        for file in &mut loaded.files {
            let mut cut = read(file.id, sources, &mut Diagnostics::default());
            cut.messages.retain(|message| self.has_message(message));
            cut.enums.retain(|enum_| self.has_enum(enum_));
            *file = Arc::new(cut);
        }
        loaded
    }

    fn keep_message(&mut self, message: &Message, why: String) {
        let name = &message.name.text;
        if self.messages.insert(name.clone()) {
            self.retained.push(Retained { name: format!("message {name}"), why });
        }
    }

    fn keep_enum(&mut self, enum_: &Enum, why: String) {
        let name = &enum_.name.text;
        if self.enums.insert(name.clone()) {
            self.retained.push(Retained { name: format!("enum {name}"), why });
        }
    }
}

/// The first message that decides on the integer of an enum: with the widest field that carries it, in its defining file.
fn decider<'d>(whole: &'d Dialect, enum_: &Enum) -> Option<&'d Message> {
    let carries = |message: &&Message| -> Option<(usize, bool)> {
        let carried = |id| whole.enum_by_id(id).is_some_and(|found| found.name.text == enum_.name.text);
        let fields = message.fields.iter().filter(|field| field.values.is_some_and(|values| carried(values.id())));
        let integers = fields.filter_map(|field| field.ty.scalar.repr());
        integers.map(|integer| (integer.size(), !integer.is_signed())).max()
    };
    let own = whole.messages.iter().rev().filter(|message| message.origin.file == enum_.defined_in);
    own.filter(|message| carries(message).is_some()).max_by_key(carries)
}

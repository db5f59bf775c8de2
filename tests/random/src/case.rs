//! A case: the files of one or two dialects and their overlays.

use std::collections::BTreeSet;

use crate::Construct;
use crate::chance::Chance;
use crate::commands;
use crate::enums::{self, Enum};
use crate::messages::{self, Message};
use crate::names::Scope;
use crate::overlay;

/// Dialects and overlays of one seed, as texts.
#[derive(Clone, Debug)]
pub struct Case {
    /// The seed.
    pub seed: u64,
    /// The files by name.
    pub files: Vec<(String, String)>,
    /// The names of the files that are dialects of their own.
    pub roots: Vec<String>,
    /// The names of the files that are overlays.
    pub overlays: Vec<String>,
    /// What came up.
    pub constructs: BTreeSet<Construct>,
}

/// A file of definitions in the making.
struct File {
    name: String,
    include: Option<String>,
    enums: Vec<String>,
    messages: Vec<String>,
}

impl File {
    fn new(name: &str, include: Option<&str>) -> Self {
        Self { name: name.to_owned(), include: include.map(str::to_owned), enums: Vec::new(), messages: Vec::new() }
    }

    fn text(&self) -> String {
        let include = self.include.as_ref().map(|name| format!("<include>{name}</include>\n")).unwrap_or_default();
        let (enums, messages) = (self.enums.concat(), self.messages.concat());
        format!(
            "<mavlink>\n{include}<version>3</version>\n<enums>\n{enums}</enums>\n<messages>\n{messages}</messages>\n</mavlink>\n"
        )
    }
}

/// Everything so far.
struct World {
    chance: Chance,
    types: Scope,
    files: Vec<File>,
    enums: Vec<Enum>,
    messages: Vec<Message>,
}

/// The case of a seed.
pub fn case(seed: u64) -> Case {
    let mut chance = Chance::new(seed);
    let included = chance.maybe(2, Construct::Include);
    let include = included.then_some("base.xml");
    let mut files: Vec<File> = include.map(|name| File::new(name, None)).into_iter().collect();
    files.push(File::new("main.xml", include));
    let mut world = World { chance, types: Scope::default(), files, enums: Vec::new(), messages: Vec::new() };
    for file in 0..world.files.len() {
        world.fill(file);
    }
    let mut roots = vec!["main.xml".to_owned()];
    if world.chance.maybe(6, Construct::SeveralRoots) {
        roots.push("main_two.xml".to_owned());
        world.add_relative();
    }
    world.finish(seed, roots)
}

impl World {
    /// The enums of a file and of those before it.
    fn visible(&self, file: usize) -> Vec<usize> {
        (0..self.enums.len()).filter(|at| self.enums.get(*at).is_some_and(|one| one.file <= file)).collect()
    }

    /// Makes the enums and messages of a file.
    fn fill(&mut self, file: usize) {
        let chance = &mut self.chance;
        for _ in 0..chance.between(1, 4) {
            let name = self.types.upper(chance, Construct::OddEnumName);
            let (made, text) = enums::make(chance, name, file);
            self.enums.push(made);
            self.files[file].enums.push(text);
        }
        if chance.one_in(4) && self.types.take("MAV_CMD") {
            let of = self.enums.first().map(|one| one.name.as_str());
            let (mut made, text) = commands::make(chance, file, of);
            let carriers = commands::carriers(chance, &mut self.types);
            made.uses.extend(carriers.iter().map(|_| (file, made.scalar)));
            self.enums.push(made);
            self.files[file].enums.push(text);
            self.files[file].messages.extend(carriers);
        }
        if file > 0 {
            self.extend(file);
        }
        let visible = self.visible(file);
        for nth in 0..self.chance.between(1, 4) {
            let chance = &mut self.chance;
            let name = self.types.upper(chance, Construct::OddMessageName);
            let id = 100 * file as u32 + nth as u32 + if chance.one_in(4) { 60_000 } else { 1 };
            let (made, text) = messages::make(chance, name, (id, file), &mut self.enums, &visible);
            self.messages.push(made);
            self.files[file].messages.push(text);
        }
        if self.enums.iter().any(|one| one.uses.is_empty()) {
            self.chance.say(Construct::UnusedEnum);
        }
    }

    /// Adds entries to an enum of an earlier file.
    fn extend(&mut self, file: usize) {
        let earlier: Vec<usize> = self.visible(file - 1);
        let Some(at) = self.chance.pick(&earlier).copied().filter(|_| self.chance.maybe(2, Construct::ExtendedEnum))
        else {
            return;
        };
        let one = &mut self.enums[at];
        let entries = enums::add(&mut self.chance, one, 3);
        let mask = if one.bitmask { " bitmask=\"true\"" } else { "" };
        if !entries.is_empty() {
            self.files[file].enums.push(format!("<enum name=\"{}\"{mask}>{entries}</enum>\n", one.name));
        }
    }

    /// A second dialect, of what the first has: left out, as it is, or changed.
    fn add_relative(&mut self) {
        let (chance, Some(first)) = (&mut self.chance, self.files.last()) else { return };
        let mut second = File::new("main_two.xml", first.include.as_deref());
        for text in &first.enums {
            second.enums.push(match chance.below(4) {
                0 => text.replace("</enum>", "<entry value=\"97\" name=\"ADDED_BY_TWO\"/></enum>"),
                1 => text.replace("value=\"1\"", "value=\"96\""),
                _ => text.clone(),
            });
        }
        for text in &first.messages {
            chance.say(Construct::MessageOfBothRoots);
            second.messages.extend(match chance.below(4) {
                0 => None,
                1 => Some(text.replace("</message>", "<field type=\"uint8_t\" name=\"added_by_two\"/></message>")),
                _ => Some(text.clone()),
            });
        }
        self.files.push(second);
    }

    fn finish(mut self, seed: u64, roots: Vec<String>) -> Case {
        let mut files: Vec<(String, String)> = Vec::new();
        let mut overlays = Vec::new();
        let made: Vec<usize> = (0..self.files.len()).filter(|file| self.files[*file].name != "main_two.xml").collect();
        for file in made {
            if self.chance.one_in(5) {
                continue;
            }
            let of_file = |message: &&Message| message.file == file;
            let messages: Vec<&Message> = self.messages.iter().filter(of_file).collect();
            let mut visible = self.visible(file);
            let base = self.files[file].name.clone();
            let overlaid = self.files.len() + overlays.len();
            let (enums, types) = (&mut self.enums, &mut self.types);
            let text = overlay::make(&mut self.chance, (&base, overlaid), (&messages, enums), (&mut visible, types));
            let commands = self.enums.iter().find(|one| one.name == "MAV_CMD" && one.file == file);
            let said = commands.map(|of| commands::overlay(&mut self.chance, of)).unwrap_or_default();
            let text = text.replace("</mavlink-overlay>", &format!("{said}</mavlink-overlay>"));
            let name = base.replace(".xml", ".overlay.xml");
            overlays.push(name.clone());
            files.push((name, text));
        }
        files.extend(self.files.iter().map(|file| (file.name.clone(), file.text())));
        Case { seed, files, roots, overlays, constructs: self.chance.said }
    }
}

//! Dialects with one mistake each, beside one without any: what a generator with a bug would write, and what a wrong
//! definition would.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use mavgen::{Builder, GeneratedFile};

use crate::definition::Definition;
use crate::{subjects, write};

/// What all mutants are made of.
const XML: [&str; 2] = ["standard.xml", "minimal.xml"];

/// A dialect with a mistake.
struct Mutant {
    /// A module name.
    name: &'static str,
    /// The file in which something is replaced: a definition, or a generated one.
    file: &'static str,
    /// What stands there, once, and what shall stand there.
    edits: &'static [(&'static str, &'static str)],
}

const HEARTBEAT: &str = "messages/heartbeat.rs";
const VERSION: &str = "messages/autopilot_version.rs";

const MUTANTS: [Mutant; 16] = [
    Mutant { name: "control", file: HEARTBEAT, edits: &[] },
    // Mistakes of a definition.
    Mutant { name: "field_name", file: "minimal.xml", edits: &[("name=\"custom_mode\"", "name=\"customMode\"")] },
    Mutant {
        name: "field_order",
        file: "minimal.xml",
        edits: &[("\"autopilot\"", "\"?\""), ("\"system_status\"", "\"autopilot\""), ("\"?\"", "\"system_status\"")],
    },
    Mutant {
        name: "entry_value",
        file: "minimal.xml",
        edits: &[("value=\"4\" name=\"MAV_STATE_A", "value=\"94\" name=\"MAV_STATE_A")],
    },
    Mutant { name: "no_extension", file: "standard.xml", edits: &[("<extensions/>", "")] },
    // Mistakes of a generator.
    Mutant { name: "crc_extra", file: HEARTBEAT, edits: &[("\"HEARTBEAT\", 50,", "\"HEARTBEAT\", 51,")] },
    Mutant { name: "id", file: HEARTBEAT, edits: &[("(0, \"HEARTBEAT\"", "(1, \"HEARTBEAT\"")] },
    Mutant { name: "len_v1", file: VERSION, edits: &[(".len_v1(60)", ".len_v1(61)")] },
    Mutant {
        name: "len_v2",
        file: VERSION,
        edits: &[
            ("type Payload = [u8; 78]", "type Payload = [u8; 77]"),
            (", 78).len_v1", ", 77).len_v1"),
            ("read(p: &[u8; 78])", "read(p: &[u8; 77])"),
            ("p: &mut [u8; 78])", "p: &mut [u8; 77])"),
        ],
    },
    Mutant {
        name: "decode_offset",
        file: HEARTBEAT,
        edits: &[("system_status: MavState(get(p, 7))", "system_status: MavState(get(p, 6))")],
    },
    Mutant {
        name: "encode_offset",
        file: HEARTBEAT,
        edits: &[("put(p, 7, self.system_status.0)", "put(p, 6, self.system_status.0)")],
    },
    // A wrong offset in everything that knows one: no round trip notices it.
    Mutant {
        name: "offset",
        file: HEARTBEAT,
        edits: &[
            ("autopilot: MavAutopilot(get(p, 5))", "autopilot: MavAutopilot(get(p, 6))"),
            ("from_bits_retain(get(p, 6))", "from_bits_retain(get(p, 5))"),
            ("put(p, 5, self.autopilot.0)", "put(p, 6, self.autopilot.0)"),
            ("put(p, 6, self.base_mode.bits())", "put(p, 5, self.base_mode.bits())"),
            ("\"autopilot\", wire::Kind::U8, 5", "\"autopilot\", wire::Kind::U8, 6"),
            ("\"base_mode\", wire::Kind::U8, 6", "\"base_mode\", wire::Kind::U8, 5"),
        ],
    },
    Mutant {
        name: "field_info",
        file: HEARTBEAT,
        edits: &[("\"custom_mode\", wire::Kind::U32", "\"custom_mode\", wire::Kind::I32")],
    },
    Mutant {
        name: "constant",
        file: "enums/mav_state.rs",
        edits: &[("ACTIVE: Self = Self(4)", "ACTIVE: Self = Self(5)")],
    },
    Mutant {
        name: "entry_name",
        file: "enums/mav_state.rs",
        edits: &[("\"MAV_STATE_ACTIVE\"", "\"MAV_STATE_ACTIV\"")],
    },
    Mutant {
        name: "bit",
        file: "enums/mav_mode_flag.rs",
        edits: &[("SAFETY_ARMED: Self = Self(1 << 7)", "SAFETY_ARMED: Self = Self(1 << 6)")],
    },
];

/// Writes `OUT_DIR/mutants.rs` and what it names.
pub(crate) fn generate(out: &Path, definitions: &[Definition]) {
    let mut root = String::new();
    let mut list = String::new();
    for mutant in &MUTANTS {
        let name = mutant.name;
        mutant.generate(&out.join("mutants").join(name), definitions);
        writeln!(root, "#[path = \"mutants/{name}/generated/mod.rs\"]\nmod {name};").unwrap();
        writeln!(root, "#[path = \"mutants/{name}/subjects.rs\"]\nmod {name}_subjects;").unwrap();
        writeln!(list, "Mutant::of(\"{name}\", &{name}_subjects::SUBJECTS, &{name}_subjects::CONSTANTS),").unwrap();
    }
    writeln!(root, "fn mutants() -> Vec<Mutant> {{\nvec![\n{list}]\n}}").unwrap();
    write(&out.join("mutants.rs"), &root);
}

impl Mutant {
    fn generate(&self, folder: &Path, definitions: &[Definition]) {
        for file in XML {
            let text = fs::read_to_string(Path::new("../xml").join(file)).unwrap();
            write(&folder.join(file), &self.edited(file, text));
        }
        let builder = Builder::new(folder.join(XML[0]));
        let resolved = builder.resolve().unwrap_or_else(|failure| panic!("{}: {failure}", self.name));
        let files = builder.emit(&resolved).unwrap();
        for GeneratedFile { path, text } in &files {
            write(&folder.join("generated").join(path), &self.edited(path, text.clone()));
        }
        let of_dialect = |definition: &&Definition| {
            resolved.dialect.messages.iter().any(|message| message.name.text == definition.name)
        };
        let definitions: Vec<Definition> = definitions.iter().filter(of_dialect).cloned().collect();
        let module = format!("super::{}", self.name);
        let subjects = subjects::subjects(&module, &resolved.dialect, &files, &definitions);
        write(&folder.join("subjects.rs"), &subjects.replace("crate::", "mavlink_conformance::"));
    }

    /// A file with the mistake, if it is the one that has it.
    fn edited(&self, file: &str, mut text: String) -> String {
        for (from, to) in self.edits.iter().filter(|_| file == self.file) {
            let count = text.matches(from).count();
            assert_eq!(count, 1, "mutant {}: `{from}` stands {count} times in {file}", self.name);
            text = text.replace(from, to);
        }
        text
    }
}

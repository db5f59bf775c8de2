//! Records of logs are C structs: their fields are where a C compiler puts them. Without `cc` the test says so and passes, but
//! not where `CI` is `true`.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use mavgen::uorb::model::{Message, Package};
use mavgen::uorb::{Scalar, log_format, topic_name};
use mavlink_conformance::random::Random;

use super::{DEFINITIONS, folder, package};

/// How many folders of random messages.
const FOLDERS: u64 = 40;

/// The struct of a message, in the order and with the padding of its log format, and what has to be true of it.
fn c_of(prefix: &str, message: &Message, package: &Package) -> String {
    let name = format!("{prefix}_{}", topic_name(&message.name));
    let mut text = format!("struct {name} {{\n");
    for member in log_format(message, package).split_terminator(';') {
        let (ty, member) = member.split_once(' ').unwrap();
        let (ty, array) = ty.split_once('[').map_or((ty, String::new()), |(ty, array)| (ty, format!("[{array}")));
        let is_nested = package.messages.iter().any(|message| topic_name(&message.name) == ty);
        let ty = if is_nested { format!("struct {prefix}_{ty}") } else { ty.to_owned() };
        writeln!(text, "  {ty} {member}{array};").unwrap();
    }
    text += "};\n";
    writeln!(text, "_Static_assert(sizeof(struct {name}) == {}, \"{name}\");", message.struct_len).unwrap();
    for field in &message.fields {
        let (field, at) = (&field.name, field.struct_offset);
        writeln!(text, "_Static_assert(offsetof(struct {name}, {field}) == {at}, \"{name}.{field}\");").unwrap();
    }
    text
}

fn c_of_package(prefix: &str, package: &Package) -> String {
    package.messages.iter().map(|message| c_of(prefix, message, package)).collect()
}

/// Messages of any fields, each of which may nest those before it.
fn random_messages(random: &mut Random, folder: &Path) {
    let below = |random: &mut Random, most: usize| random.number() as usize % most;
    for message in 0..4 {
        let mut text = "uint64 timestamp\n".to_owned();
        for field in 0..=below(random, 9) {
            let choice = below(random, Scalar::ALL.len() + message);
            let ty = Scalar::ALL.get(choice).map(|scalar| scalar.name().to_owned());
            let ty = ty.unwrap_or_else(|| format!("M{}", choice - Scalar::ALL.len()));
            let array = if below(random, 3) == 0 { format!("[{}]", 1 + below(random, 5)) } else { String::new() };
            writeln!(text, "{ty}{array} f{field}").unwrap();
        }
        fs::write(folder.join(format!("M{message}.msg")), text).unwrap();
    }
}

#[test]
fn fields_are_where_a_c_compiler_has_them() {
    let mut text = "#include <stdbool.h>\n#include <stddef.h>\n#include <stdint.h>\n".to_owned();
    for definition in DEFINITIONS {
        text += &c_of_package(definition, &package(&folder(definition)));
    }
    let mut random = Random::new(8);
    for number in 0..FOLDERS {
        let folder = tempfile::tempdir().unwrap();
        random_messages(&mut random, folder.path());
        text += &c_of_package(&format!("random_{number}"), &package(folder.path()));
    }
    // Those of PX4 that lie beside the project, where they do.
    if let Ok(all) = std::env::var("PX4_MESSAGES") {
        text += &c_of_package("all", &package(Path::new(&all)));
    }
    assert!(text.matches("offsetof").count() > 500);
    let source = Path::new(env!("CARGO_TARGET_TMPDIR")).join("px4.c");
    fs::write(&source, text).unwrap();
    let Ok(compiled) = Command::new("cc").args(["-std=c11", "-fsyntax-only"]).arg(&source).status() else {
        assert_ne!(std::env::var("CI").as_deref(), Ok("true"), "`cc` has to be there");
        return println!("skipped: there is no `cc`");
    };
    assert!(compiled.success(), "the C compiler has other places");
}

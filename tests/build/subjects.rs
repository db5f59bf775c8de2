//! The code that names every field and every constant.
//!
//! The fields come from the vectors, not from the generator: a struct whose fields are others does not compile, because
//! literals and patterns are written in full.

use std::fmt::Write;

use heck::{ToSnakeCase, ToUpperCamelCase};
use mavgen::GeneratedFile;
use mavgen::ir::{Dialect, Enum, Repr};

use crate::definition::{Definition, Field};

/// `SUBJECTS` and `CONSTANTS` of the dialect in `module`.
pub(crate) fn subjects(module: &str, dialect: &Dialect, files: &[GeneratedFile], definitions: &[Definition]) -> String {
    let mut code = format!("use {module} as d;\nuse crate::subject::{{Golden, Subject}};\n");
    code.push_str("use crate::constants::Constants;\nuse crate::values::{Reader, Writer};\n");
    for definition in definitions {
        code.push_str(&golden(definition));
    }
    let rows: String =
        definitions.iter().map(|definition| format!("Subject::of::<d::{}>(),\n", type_name(definition))).collect();
    let (type_name, count) = (dialect.name.to_upper_camel_case(), definitions.len());
    writeln!(code, "/// The messages, by id.\npub static SUBJECTS: [Subject<d::{type_name}>; {count}] = [\n{rows}];")
        .unwrap();
    let rows: String = dialect.enums.iter().map(|values| constants(values, files)).collect();
    let count = dialect.enums.len();
    writeln!(code, "/// The enums.\npub static CONSTANTS: [Constants; {count}] = [\n{rows}];").unwrap();
    code
}

/// `impl Golden for d::Heartbeat { … }`
fn golden(definition: &Definition) -> String {
    let (mut read, mut write, mut names) = (String::new(), String::new(), String::new());
    for field in &definition.fields {
        let (name, method) = (field_name(field), method(field));
        writeln!(read, "{name}: v.{method}(),").unwrap();
        writeln!(write, "v.{method}({name});").unwrap();
        write!(names, "{name}, ").unwrap();
    }
    let name = type_name(definition);
    format!(
        "impl Golden for d::{name} {{\n\
         fn build(v: &mut Reader<'_>) -> Self {{ Self {{\n{read}}} }}\n\
         fn take_apart(&self, v: &mut Writer) {{ let Self {{ {names}}} = *self;\n{write}}}\n\
         }}\n"
    )
}

/// `one::<u16, _>`, `array::<u16, _, 4>`, `text::<16>`
fn method(field: &Field) -> String {
    let ty = field.rust_type();
    match (field.ty.as_str(), field.array) {
        (_, None) => format!("one::<{ty}, _>"),
        ("char", Some(n)) => format!("text::<{n}>"),
        (_, Some(n)) => format!("array::<{ty}, _, {n}>"),
    }
}

fn type_name(definition: &Definition) -> String {
    definition.name.to_upper_camel_case()
}

/// In snake case; a keyword is written raw.
fn field_name(field: &Field) -> String {
    let name = field.name.to_snake_case();
    if syn::parse_str::<syn::Ident>(&name).is_ok() { name } else { format!("r#{name}") }
}

/// `Constants::of::<d::MavState>(&[("MAV_STATE_ACTIVE", "ACTIVE", d::MavState::ACTIVE.0 as u64), …]),`
///
/// What a constant is called stands in the generated file, where the constants are by value as the entries are.
fn constants(values: &Enum, files: &[GeneratedFile]) -> String {
    let path = format!("enums/{}.rs", values.name.text.to_snake_case());
    let text = &files.iter().find(|file| file.path == path).unwrap_or_else(|| panic!("no {path}")).text;
    let name = text.split("pub struct ").nth(1).unwrap().split('(').next().unwrap();
    let constants: Vec<&str> = text.split("pub const ").skip(1).map(|rest| rest.split(':').next().unwrap()).collect();
    assert_eq!(constants.len(), values.entries.len(), "{path}");
    let number = if values.bitmask { "bits()" } else { "0" };
    let cast = if values.repr == Repr::U64 { "" } else { " as u64" };
    let mut code = format!("Constants::of::<d::{name}>(&[\n");
    for (entry, rust) in values.entries.iter().zip(constants) {
        let xml = &entry.name.text;
        writeln!(code, "(\"{xml}\", \"{rust}\", d::{name}::{rust}.{number}{cast}),").unwrap();
    }
    code + "]),\n"
}

//! Writes the code that names every field of every message and every constant of every enum, and the dialects that only
//! tests have: mutants and the hostile one.

#[path = "../src/definition.rs"]
#[allow(unreachable_pub, reason = "the library exports it")]
mod definition;
mod mutants;
mod subjects;

use std::env;
use std::fs;
use std::path::{Path, PathBuf};

use definition::Definition;
use mavgen::Builder;

fn main() {
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap());
    for input in ["build", "src/definition.rs", "vectors/autoquad.txt", "hostile", "packed", "roots", "typed", "../xml"]
    {
        println!("cargo::rerun-if-changed={input}");
    }
    let text = fs::read_to_string("vectors/autoquad.txt").unwrap();
    let definitions: Vec<Definition> = text.lines().filter_map(Definition::read).collect();

    let builder = Builder::new("../xml/autoquad.xml").overlay("../xml/overlay/autoquad.xml");
    let autoquad = builder.resolve().unwrap_or_else(|failure| panic!("{failure}"));
    let files = builder.emit(&autoquad).unwrap_or_else(|failure| panic!("{failure}"));
    let module = "::mavlink_autoquad::autoquad";
    write(&out.join("autoquad_subjects.rs"), &subjects::subjects(module, &autoquad.dialect, &files, &definitions));
    mutants::generate(&out, &definitions);
    generate_others(&out);
}

/// What `Builder::build_script` does, without printing the warnings that the definitions deserve.
fn generate_others(out: &Path) {
    let packed = Builder::new("packed/packed.xml").overlay("packed/packed.overlay.xml");
    let five = ["HEARTBEAT", "COMMAND_ACK", "AQ_ESC_TELEMETRY", "GPS_RAW_*", "RADIO_STATUS"];
    let selected = Builder::new("../xml/autoquad.xml").overlay("../xml/overlay/autoquad.xml").messages(five);
    let overlays = ["heron", "base", "osprey"].map(|name| format!("roots/{name}.overlay.xml"));
    let roots = Builder::new("roots/heron.xml").root("roots/osprey.xml");
    let others = [
        ("hostile", Builder::new("hostile/hostile.xml").overlay("hostile/hostile.overlay.xml")),
        ("names", Builder::new("hostile/names.xml")),
        ("packed", packed),
        ("selected", selected.name("selected")),
        ("typed", Builder::new("typed/typed.xml").overlay("typed/typed.overlay.xml")),
        ("roots", overlays.iter().fold(roots, Builder::overlay)),
    ];
    for (name, builder) in others {
        builder.out_dir(out.join(name)).generate().unwrap_or_else(|failure| panic!("{failure}"));
        let root = format!("/// What became of it.\n#[path = \"{name}/mod.rs\"]\npub mod {name};\n");
        write(&out.join(format!("{name}.rs")), &root);
    }
}

fn write(path: &Path, text: &str) {
    if fs::read_to_string(path).is_ok_and(|present| present == text) {
        return;
    }
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

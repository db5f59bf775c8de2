//! Generates the dialect, unless the committed sources are asked for.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "generate")]
    generate();
}

#[cfg(feature = "generate")]
fn generate() {
    println!("cargo::rerun-if-env-changed=MAVLINK_AUTOQUAD_XML");
    let fork = std::env::var_os("MAVLINK_AUTOQUAD_XML");
    let xml = fork.map_or("xml/autoquad.xml".into(), std::path::PathBuf::from);
    mavgen::Builder::new(xml).name("autoquad").build_script();
}

//! Generates the dialect, unless the committed sources are asked for.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(without_esc)");
    #[cfg(feature = "generate")]
    generate();
    #[cfg(all(feature = "generate", feature = "px4"))]
    generate_px4();
}

/// A fork's definitions may lack what our overlay describes, so it applies only to our own.
#[cfg(feature = "generate")]
fn generate() {
    let variable = |name: &str| {
        println!("cargo::rerun-if-env-changed={name}");
        std::env::var_os(name)
    };
    let (fork, overlay) = (variable("MAVLINK_AUTOQUAD_XML"), variable("MAVLINK_AUTOQUAD_OVERLAY"));
    let overlay = match (&fork, overlay) {
        (None, None) => Some("xml/overlay/autoquad.xml".into()),
        (_, named) => named,
    };
    let builder = mavgen::Builder::new(fork.unwrap_or("xml/autoquad.xml".into())).name("autoquad");
    // As in the committed sources: the compiler leaves them out, and the same files serve crates with the feature and without.
    let builder = builder.commands(mavgen::Commands::Feature("commands".into()));
    let builder = match overlay {
        Some(path) => builder.overlay(path),
        None => {
            println!("cargo::rustc-cfg=without_esc");
            builder
        }
    };
    builder.build_script();
}

/// PX4's messages about motor controllers, as they are and as they were.
#[cfg(all(feature = "generate", feature = "px4"))]
fn generate_px4() {
    let newest = mavgen::Builder::new("msg/main").name("px4_msgs").overlay("msg/esc.overlay.xml");
    newest.older("v2026_02", "msg/v2026_02").older("v1_14", "msg/v1_14").build_script();
}

//! Generating all of PX4's messages beside roslibrust_codegen: `cargo run --release --features topics --bin topics ROUNDS FOLDER`.
//!
//! The folder is `msg` of PX4's message repository, which is no part of this one.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};

use mavlink_bench::rounds::{Contender, compare};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(2).map(PathBuf::from).ok_or("which folder of .msg files?")?;
    let package = package(&folder)?;
    let files = ours(&folder, false);
    println!("mavgen: {files} files; roslibrust_codegen: {} bytes", theirs(&package, true));
    compare(
        "generate all topics",
        vec![
            Contender::new("mavgen", || usize::from(ours(&folder, false) > 0)),
            Contender::new("mavgen, formatted", || usize::from(ours(&folder, true) > 0)),
            Contender::new("roslibrust, formatted", || usize::from(theirs(&package, true) > 0)),
            Contender::new("roslibrust", || usize::from(theirs(&package, false) > 0)),
        ],
    );
    fs::remove_dir_all(&package)?;
    Ok(())
}

/// The messages as a package of ROS 2.
fn package(folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let package = std::env::temp_dir().join(format!("mavlink-bench-topics-{}", std::process::id()));
    fs::create_dir_all(package.join("msg"))?;
    let manifest = "<package format=\"3\"><name>px4_msgs</name><version>1.0.0</version><description>-</description>\
                    <buildtool_depend>ament_cmake</buildtool_depend><export><build_type>ament_cmake</build_type></export></package>";
    fs::write(package.join("package.xml"), manifest)?;
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if let (Some(name), true) = (path.file_name(), path.extension().is_some_and(|extension| extension == "msg")) {
            fs::copy(&path, package.join("msg").join(name))?;
        }
    }
    Ok(package)
}

/// In memory: how many files.
fn ours(folder: &Path, formatted: bool) -> usize {
    mavgen::Builder::new(folder).formatted(formatted).files().map_or(0, |files| files.len())
}

/// In memory: how many bytes. Formatted as by the build script of its documentation.
fn theirs(package: &Path, formatted: bool) -> usize {
    let generated =
        roslibrust_codegen::find_and_generate_ros_messages_without_ros_package_path(vec![package.to_owned()]);
    let Ok((tokens, _)) = generated else { return 0 };
    match formatted {
        true => syn::parse2(tokens).map_or(0, |file| prettyplease::unparse(&file).len()),
        false => tokens.to_string().len(),
    }
}

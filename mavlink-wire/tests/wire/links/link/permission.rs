//! What a user may not open. Root may open everything: then another user tries it, in a process of its own.

use std::fs::{self, File, Permissions};
use std::io::{ErrorKind, Write};
use std::net::UdpSocket;
use std::os::unix::fs::PermissionsExt;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::Command;

use super::*;

/// Tells the other user's process which file it may not read.
const FORBIDDEN: &str = "MAVLINK_WIRE_FORBIDDEN";

/// `nobody`, on most systems; a user without rights anywhere.
const NOBODY: u32 = 65_534;

fn no_permission(address: &str) {
    let error = Link::connect(address, station()).unwrap_err();
    assert!(matches!(error, LinkError::NoPermission { .. }), "{address}: {error:?}");
    assert!(error.to_string().contains("join the group that owns it"), "{error}");
    assert_eq!(std::io::Error::from(error).kind(), ErrorKind::PermissionDenied);
}

fn try_all(forbidden: &Path) {
    let path = forbidden.display();
    no_permission(&format!("file:{path}"));
    #[cfg(feature = "serial")]
    no_permission(&format!("serial:{path}:57600"));
    // Some systems leave these ports to everybody.
    if UdpSocket::bind("127.0.0.1:1").is_err_and(|error| error.kind() == ErrorKind::PermissionDenied) {
        no_permission("udpin:127.0.0.1:1");
        no_permission("tcpin:127.0.0.1:1");
    }
}

#[test]
fn what_a_user_may_not_open_is_told() {
    if let Some(forbidden) = std::env::var_os(FORBIDDEN) {
        return try_all(Path::new(&forbidden));
    }
    let folder = tempfile::tempdir().unwrap();
    let forbidden = folder.path().join("flight.tlog");
    fs::write(&forbidden, []).unwrap();
    fs::set_permissions(&forbidden, Permissions::from_mode(0o000)).unwrap();
    if File::open(&forbidden).is_err() {
        return try_all(&forbidden);
    }
    fs::set_permissions(folder.path(), Permissions::from_mode(0o755)).unwrap();
    let test = "links::link::permission::what_a_user_may_not_open_is_told";
    let mut child = Command::new(std::env::current_exe().unwrap());
    child.args([test, "--exact", "--nocapture"]).env(FORBIDDEN, &forbidden).current_dir("/").uid(NOBODY).gid(NOBODY);
    match child.output() {
        Ok(output) => {
            let said = String::from_utf8_lossy(&output.stdout);
            assert!(output.status.success() && said.contains("1 passed"), "{said}");
        }
        Err(error) => {
            writeln!(std::io::stderr(), "skipped: no process of user {NOBODY} can be started here: {error}").unwrap();
        }
    }
}

/// A broadcast needs a socket that may broadcast: `udpbcast`. Nobody else may, root included.
#[cfg(target_os = "linux")]
#[test]
fn a_broadcast_that_is_not_called_one_is_refused() {
    let refused = Link::connect("udpout:127.255.255.255:9", station()).unwrap().send(&message(0)).unwrap_err();
    assert!(matches!(refused, LinkError::NoPermission { .. }), "{refused:?}");
    assert!(refused.to_string().ends_with("to broadcast, use `udpbcast`"));
    let link = Link::connect("udpbcast:127.255.255.255:9", station()).unwrap();
    assert!(matches!(link.send(&message(0)), Ok(1)));
}

//! Says in words what the tests before it have shown: cargo runs the packages in the order of their names and stops at the first
//! that fails, so this is the last program of `cargo test --tests`, and runs only if all of them passed.

fn main() {
    if std::env::args().skip(1).any(|argument| argument != "--quiet") {
        return; // not all tests were asked for
    }
    println!(
        "
What passes, if all packages are tested, shows:
- Each message of the AutoQuad dialect reads the frames that pymavlink made, and writes the same bytes: MAVLink 1, 2 and signed.
- Any payload decodes, and comes back as it was. Values, flags and messages without a name survive.
- Each ESC32 field lies where a C compiler puts it. PX4's EscStatus is read and written as rosbags and pyulog do it.
- Each kind of mistake in a definition is told with its place. No damaged file or stream causes a panic.
- What mavgen accepts compiles without a warning: tried with random dialects and overlays.
- Links go on when a peer dies, and protocols end, with a fifth of the frames lost.

pymavlink, rust-mavlink, MAVSDK, Cortex-M3 and the rest: `.ci/run`. All proofs: docs/proof.md."
    );
}

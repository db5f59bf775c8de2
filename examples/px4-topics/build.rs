//! Generates the topics when the crate is built, and again when one of their files changes.

fn main() {
    let px4 = mavgen::Builder::new("msg").overlay("msg.overlay.xml").name("px4");
    px4.messages(["VehicleStatus", "Cpuload"]).build_script(); // of PX4's own folder: these and what they nest
}

//! Step 3. Generates the dialect when the crate is built, and again when one of its files changes.

fn main() {
    let farm = mavgen::Builder::new("xml/farm.xml").overlay("xml/overlay/farm.xml");
    farm.messages(["HEARTBEAT", "SPRAYER"]).build_script(); // without `messages`, all 240 that common.xml has
}

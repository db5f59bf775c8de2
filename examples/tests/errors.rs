//! What the programs say when something is wrong: a sentence, and exit status 1.

use std::process::Command;

#[test]
fn errors_are_sentences() {
    let (decode, udp) = (env!("CARGO_BIN_EXE_decode"), env!("CARGO_BIN_EXE_udp"));
    let (router, station) = (env!("CARGO_BIN_EXE_router"), env!("CARGO_BIN_EXE_station"));
    let vehicle = env!("CARGO_BIN_EXE_vehicle");
    for (program, arguments, said) in [
        (decode, &["none.tlog"][..], "decode: none.tlog: "),
        (udp, &["nowhere"], "udp: `nowhere` is no address of a link: "),
        (station, &["nowhere"], "station: `nowhere` is no address of a link: "),
        (vehicle, &["nowhere"], "vehicle: `nowhere` is no address of a link: "),
        (router, &["udpin:127.0.0.1:0"], "router: usage: "),
        (router, &["udpin:127.0.0.1:0", "file:none.tlog"], "router: there is no file none.tlog: "),
    ] {
        let output = Command::new(program).args(arguments).output().unwrap();
        let text = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), output.stdout.len(), text.lines().count()), (Some(1), 0, 1), "{text}");
        assert!(text.starts_with(said) && !text.contains("Os {"), "{text}");
    }
}

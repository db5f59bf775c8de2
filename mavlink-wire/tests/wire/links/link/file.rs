//! Files: streams that were kept, and logs.

use mavlink_wire::tlog;

use super::*;

fn open(name: &str, bytes: &[u8]) -> (tempfile::TempDir, Link) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    let link = Link::connect(&format!("file:{}", path.display()), station()).unwrap();
    (folder, link)
}

fn all(link: &mut Link) -> Vec<(u8, Option<Small>)> {
    let mut frames = vec![];
    loop {
        match link.receive() {
            Ok(frame) => frames.push(read(&frame)),
            Err(error) => {
                assert!(matches!(error, LinkError::Ended), "{error}");
                return frames;
            }
        }
    }
}

fn log(numbers: core::ops::Range<u32>) -> Vec<u8> {
    let (bytes, mut log, mut buffer) = (stream(Sender::v2(1, 1), numbers), vec![], [0; tlog::MAX_ENTRY]);
    let (mut input, mut time) = (&bytes[..], 1_700_000_000_000_000);
    while let Ok(frame) = mavlink_wire::Frame::parse(input, Small::TABLE) {
        // Bytes of the time that look like the start of a frame.
        time += 0xFDFE;
        log.extend_from_slice(tlog::encode(time, &frame, &mut buffer).unwrap());
        input = &input[frame.bytes().len()..];
    }
    log
}

#[test]
fn a_stream_and_a_log_give_their_frames_and_end() {
    let stream = [b"noise".to_vec(), stream(Sender::v2(1, 1), 0..9), vec![0xFD, 9, 0]].concat();
    for (name, bytes, skipped) in [
        ("kept", &stream, 8),
        ("named.tlog", &log(0..9), 0),
        ("a_log_by_another_name", &log(0..9), 0),
        ("damaged.TLOG", &[vec![1, 2, 3], log(0..9)].concat(), 3),
        ("empty", &vec![], 0),
    ] {
        let (_folder, mut link) = open(name, bytes);
        let expected = if bytes.is_empty() { vec![] } else { sent(0..9) };
        assert_eq!(all(&mut link), expected, "{name}");
        let found = link.statistics().received;
        assert_eq!((found.frames, found.skipped_bytes), (expected.len() as u64, skipped), "{name}");
        assert_eq!(link.losses().total().lost, 0);
        assert!(matches!(link.receive_until(soon()), Err(LinkError::Ended)), "{name}: it stays at the end");
        assert_eq!(link.send(&message(0)).unwrap(), 0, "{name}: nobody reads it there");
    }
}

#[test]
fn a_file_that_grows_is_read_on() {
    use std::io::Write;
    let (folder, mut link) = open("kept", &stream(Sender::v2(1, 1), 0..2));
    assert_eq!(all(&mut link).len(), 2);
    let mut file = std::fs::OpenOptions::new().append(true).open(folder.path().join("kept")).unwrap();
    file.write_all(&stream(Sender::v2(1, 1), 2..3)).unwrap();
    assert_eq!(all(&mut link).len(), 1);
}

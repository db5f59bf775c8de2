//! The reader of sequences of signed frames; `vectors/README.md` describes the format.

/// Frames of common messages, and what the C library and pymavlink think of them.
pub const SIGNING: &str = include_str!("../vectors/signing.txt");

/// Frames that reach one receiver, one after the other.
#[derive(Clone, Debug)]
pub struct Sequence {
    /// Its name in the file.
    pub name: String,
    /// The receiver's time at the start.
    pub time: u64,
    /// The frames.
    pub arrivals: Vec<Arrival>,
}

/// A frame that arrives, and what the receivers think of it.
#[derive(Clone, Debug)]
pub struct Arrival {
    /// What the C library says.
    pub verdict: String,
    /// The C library's time afterwards.
    pub time: u64,
    /// Whether pymavlink accepts it.
    pub accepted_by_pymavlink: bool,
    /// The frame.
    pub bytes: Vec<u8>,
}

impl Arrival {
    /// Whether the C library accepts it.
    pub fn is_accepted(&self) -> bool {
        matches!(&*self.verdict, "signed" | "allowed")
    }
}

/// Reads the file.
///
/// # Panics
///
/// If it is not written as the format says.
pub fn read(text: &str) -> Vec<Sequence> {
    let mut sequences: Vec<Sequence> = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let words: Vec<&str> = line.split(' ').collect();
        match words[..] {
            ["sequence", name, time] => {
                sequences.push(Sequence { name: name.to_owned(), time: number(time), arrivals: Vec::new() });
            }
            ["frame", verdict, time, accepted @ ("yes" | "no"), digits] => {
                sequences.last_mut().unwrap().arrivals.push(Arrival {
                    verdict: verdict.to_owned(),
                    time: number(time),
                    accepted_by_pymavlink: accepted == "yes",
                    bytes: bytes(digits),
                });
            }
            _ => panic!("neither a sequence nor a frame: {line}"),
        }
    }
    sequences
}

fn number(digits: &str) -> u64 {
    u64::from_str_radix(digits, 16).unwrap()
}

fn bytes(digits: &str) -> Vec<u8> {
    let (pairs, []) = digits.as_bytes().as_chunks::<2>() else { panic!("half a byte: {digits}") };
    pairs.iter().map(|pair| number(str::from_utf8(pair).unwrap()) as u8).collect()
}

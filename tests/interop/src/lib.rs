//! What the tests share: the golden frames of `tests/vectors`.

/// The golden frames without a signature, MAVLink 1 and 2.
///
/// # Panics
///
/// If the file is not written as its format says.
pub fn golden_frames() -> Vec<Vec<u8>> {
    let lines = include_str!("../../vectors/autoquad.txt").lines();
    let frames = lines.filter_map(|line| line.strip_prefix("v1 ").or(line.strip_prefix("v2 ")));
    frames.map(|runs| runs.split([' ', ',']).flat_map(expand).collect()).collect()
}

/// `0102`, or `00*5`.
fn expand(run: &str) -> Vec<u8> {
    let (digits, count) = run.split_once('*').unwrap_or((run, "1"));
    let byte = |at: usize| u8::from_str_radix(&digits[at..at + 2], 16).unwrap();
    let bytes: Vec<u8> = (0..digits.len()).step_by(2).map(byte).collect();
    bytes.repeat(count.parse().unwrap())
}

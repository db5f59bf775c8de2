//! The bits are those of a C compiler's bit-fields: packed, as the firmware declares them since 2014-12-09, and unpacked, as
//! before. Without `cc` the test says so and passes, but not where `CI` is `true`.

use std::fs;
use std::path::Path;
use std::process::Command;

use mavlink_autoquad::autoquad::{AqEscTelemetry, Esc32Status, Esc32StatusUnpacked};
use mavlink_autoquad::wire::Message;
use mavlink_conformance::random::Random;

const WORDS: usize = 200_000;

/// Reads words from one file, and writes what the bit-fields of each say to another: 13 numbers of 32 bits.
const PROGRAM: &str = r"
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#define FIELDS unsigned int state : 3; unsigned int vin : 12; unsigned int amps : 14; unsigned int rpm : 15; \
               unsigned int duty : 8; unsigned int errors : 9; unsigned int reason : 3;
struct packed { FIELDS } __attribute__((packed));
struct unpacked { FIELDS };
int main(int count, char **paths) {
    if (count != 3 || sizeof(struct packed) != 8) return 2;
    FILE *words = fopen(paths[1], `rb`), *values = fopen(paths[2], `wb`);
    if (!words || !values) return 3;
    uint8_t word[8];
    while (fread(word, 8, 1, words) == 1) {
        struct packed p;
        struct unpacked u;
        memset(&u, 0, sizeof u);
        memcpy(&p, word, 8);
        memcpy(&u, word, 8);
        uint32_t v[13] = { p.state, p.vin, p.amps, p.rpm, p.duty, p.errors, p.reason,
                           u.state, u.vin, u.amps, u.rpm, u.duty, u.errors };
        if (fwrite(v, sizeof v, 1, values) != 1) return 4;
    }
    return fclose(values);
}
";

/// Random words, and those with one bit.
fn words() -> Vec<u64> {
    let mut random = Random::new(152);
    (0..64).map(|bit| 1 << bit).chain(std::iter::repeat_with(|| random.number())).take(WORDS).collect()
}

/// What the C compiler makes of the words; `None` without a compiler.
fn by_c(words: &[u64]) -> Option<Vec<[u32; 13]>> {
    let [source, program, input, output] =
        ["esc.c", "esc", "esc.words", "esc.values"].map(|name| Path::new(env!("CARGO_TARGET_TMPDIR")).join(name));
    fs::write(&source, PROGRAM.replace('`', "\"")).unwrap();
    fs::write(&input, words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>()).unwrap();
    let compiled = Command::new("cc").args(["-std=c99", "-o"]).args([&program, &source]).status().ok()?;
    assert!(compiled.success(), "the C program is wrong");
    assert!(Command::new(&program).args([&input, &output]).status().unwrap().success());
    let bytes = fs::read(output).unwrap();
    let number = |bytes: &[u8]| u32::from_ne_bytes(bytes.try_into().unwrap());
    Some(bytes.chunks(52).map(|one| std::array::from_fn(|index| number(&one[4 * index..4 * index + 4]))).collect())
}

fn packed(status: Esc32Status) -> [u32; 7] {
    let last = status.errors().or(status.temperature_raw()).unwrap();
    let reason = status.disarm_v2().map(u8::from).or(status.disarm_v3().map(u8::from)).unwrap();
    let [state, duty, reason] = [status.state().0, status.duty_raw(), reason].map(u32::from);
    let [voltage, current, rpm, last] = [status.voltage_raw(), status.current_raw(), status.rpm(), last].map(u32::from);
    [state, voltage, current, rpm, duty, last, reason]
}

fn unpacked(status: Esc32StatusUnpacked) -> [u32; 6] {
    let [voltage, current, rpm, errors] =
        [status.voltage_raw(), status.current_raw(), status.rpm(), status.errors()].map(u32::from);
    [u32::from(status.state().0), voltage, current, rpm, u32::from(status.duty_raw()), errors]
}

#[test]
fn bits_are_where_a_c_compiler_has_them() {
    let words = words();
    let Some(values) = by_c(&words) else {
        assert_ne!(std::env::var("CI").as_deref(), Ok("true"), "`cc` has to be there");
        return println!("skipped: there is no `cc`");
    };
    assert_eq!(values.len(), WORDS);
    for (&word, value) in words.iter().zip(&values) {
        let mut telemetry = AqEscTelemetry {
            seq: 1,
            num_motors: 2,
            num_in_seq: 2,
            data_version: [21, 30, 0, 0],
            ..AqEscTelemetry::DEFAULT
        };
        telemetry.data0 = [word as u32; 4];
        telemetry.data1 = [(word >> 32) as u32; 4];
        for esc in telemetry.escs() {
            assert_eq!(packed(esc.status.unwrap()), value[..7], "{word:#018x}");
        }
        for esc in telemetry.legacy_escs() {
            assert_eq!(unpacked(esc.status.unwrap()), value[7..], "{word:#018x}");
        }
    }
}

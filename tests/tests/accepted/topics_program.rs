//! Reads bodies of each definition and writes them again; and values that others wrote, as CDR and as records of a log.

use std::io::{Read, stdin};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use mavlink_wire::uorb::ulog::Binding;
use mavlink_wire::uorb::{CdrError, Definition, Topic};

/// SplitMix64.
fn random(seed: &mut u64) -> u64 {
    *seed = seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mixed = (*seed ^ (*seed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    mixed ^ (mixed >> 31)
}

fn written<T: Topic>(topic: &T, definition: &Definition) -> Vec<u8> {
    let mut buffer = vec![0; definition.cdr_len as usize + 4];
    topic.to_cdr(definition, &mut buffer).unwrap().to_vec()
}

/// Reads a record by the format of the definition that it was written by.
fn logged<T: Topic>(topic: &T, definition: &Definition) -> T {
    let mut record = vec![0; definition.record_len as usize];
    topic.store_record(&mut record).unwrap();
    let formats = |name: &str| definition.formats.iter().find_map(|one| one.strip_prefix(name)?.strip_prefix(':'));
    Binding::<T>::of(T::TOPICS[0], formats).unwrap().read(&record).unwrap()
}

fn bytes(digits: &str) -> Vec<u8> {
    let pairs = digits.as_bytes().chunks(2);
    pairs.map(|pair| u8::from_str_radix(std::str::from_utf8(pair).unwrap(), 16).unwrap()).collect()
}

/// How many values of others were looked at.
static VALUES: AtomicUsize = AtomicUsize::new(0);

/// The fields are by name in a record, and by place in CDR: what one says the other has to.
fn check_vectors<T: Topic>(vectors: &str) {
    let begins = format!("message {} ", T::NAME);
    let lines = vectors.lines().skip_while(|line| !line.starts_with(&begins)).skip(1);
    let definition = &T::DEFINITIONS[0];
    for line in lines.take_while(|line| !line.starts_with("message ")).filter_map(|line| line.strip_prefix("value ")) {
        let [_, cdr, record] = line.split(' ').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let (cdr, record) = (bytes(cdr), bytes(record));
        let topic = T::from_cdr_as(definition, &cdr).unwrap();
        assert_eq!(written(&topic, definition), cdr, "{}", T::NAME);
        let mut stored = vec![0; definition.record_len as usize];
        topic.store_record(&mut stored).unwrap();
        assert_eq!(stored, record, "record of {}", T::NAME);
        assert_eq!(written(&logged(&topic, definition), definition), cdr, "log of {}", T::NAME);
        VALUES.fetch_add(1, Relaxed);
    }
}

fn check<T: Topic>(vectors: &str) {
    check_vectors::<T>(vectors);
    let mut seed = 1;
    for (age, definition) in T::DEFINITIONS.iter().enumerate() {
        let length = definition.cdr_len as usize;
        let body = |bytes: Vec<u8>| [vec![0, 1, 0, 0], bytes].concat();
        let ones = T::from_cdr_as(definition, &body(vec![1; length])).unwrap();
        let is_data = written(&ones, definition);
        let mut read = 0;
        // Bytes of which none makes a NaN, which another type may not keep.
        for limit in [2, 2, 2, 127, 127, 127] {
            let bytes = body((0..length).map(|_| (random(&mut seed) % limit) as u8).collect());
            let topic = match T::from_cdr_as(definition, &bytes) {
                Err(CdrError::Bool { .. }) if limit > 2 => continue,
                topic => topic.unwrap(),
            };
            read += 1;
            let data = bytes.iter().zip(&is_data).enumerate();
            let data: Vec<u8> = data.map(|(at, (byte, data))| if at < 4 { *byte } else { byte * data }).collect();
            assert_eq!(written(&topic, definition), data, "{} of {}", definition.name, T::NAME);
            if age == 0 {
                assert_eq!(written(&logged(&topic, definition), definition), data, "log of {}", T::NAME);
            }
        }
        assert!(read >= 3);
    }
}

fn main() {
    let mut vectors = String::new();
    stdin().read_to_string(&mut vectors).unwrap();
// CHECKS
    println!("{} values", VALUES.load(Relaxed));
}

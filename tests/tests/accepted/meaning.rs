//! What the generated accessors say of random payloads is what `mavgen::decode` says by the model, and setters write back
//! what getters read.
//!
//! Both sides tell a payload as lines of text: here by the model, in the program by its accessors.

use std::fmt::Write;

use mavgen::decode::{Bits, Content, KeyValue, Reading, Tables, Value, bindings, views};
use mavgen::ir::{Access, Dialect, EnumId, Message, Values};
use mavlink_conformance::payload::{Canonical, Fill};
use mavlink_conformance::random::Random;
use mavlink_wire::reflect::Number;

use crate::package::Package;
use crate::program::{self, Sources};
use crate::sample::{Accepted, Sample};

/// So many dialects are compiled and run.
const DIALECTS: usize = 20;

/// Payloads for each message.
const PAYLOADS: usize = 12;

/// At least so many things are told of each dialect.
const LINES: usize = 200;

/// What a payload says, one thing a line.
struct Teller<'d> {
    tables: &'d Tables,
    text: String,
}

/// Some payloads of every message: full ones, small numbers (enums and switches know those), and ones that end early.
fn payloads(dialect: &Dialect, seed: u64) -> Vec<(u32, Vec<u8>)> {
    let mut random = Random::new(seed);
    let mut all = Vec::new();
    for message in &dialect.messages {
        for nth in 0..PAYLOADS {
            let fill = Fill::ALL[nth % Fill::ALL.len()];
            let length =
                if nth < PAYLOADS / 2 { message.len_v2.into() } else { 1 + random.below(message.len_v2.into()) };
            let mut payload = fill.payload(length, &mut random);
            if nth % 2 == 0 {
                payload.iter_mut().for_each(|byte| *byte &= 0x87);
            }
            all.push((message.id, payload));
        }
    }
    all
}

/// The lines of a payload.
fn told(message: &Message, tables: &Tables, payload: &[u8]) -> String {
    let mut teller = Teller { tables, text: String::new() };
    let info = tables.table().get(message.id).unwrap();
    teller.say("sent", &hex(&Canonical::of(payload, info).v2));
    for (binding, value) in bindings(message, payload) {
        let told = value.map_or("-".to_owned(), |value| teller.entry(binding.enum_, value));
        teller.say(&binding.name.shown(), &told);
    }
    views(message, payload).for_each(|reading| teller.view(message, &reading));
    teller.text
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        write!(text, "{byte:02x}").unwrap();
        text
    })
}

impl Teller<'_> {
    fn say(&mut self, name: &str, value: &str) {
        writeln!(self.text, "{name} {value}").unwrap();
    }

    /// What `Display` of the enum prints.
    fn entry(&self, id: EnumId, value: u64) -> String {
        let (values, number) = (self.tables.values(id).unwrap(), self.tables.number(id, value).unwrap());
        match number {
            Number::U64(value) => values.display(value).to_string(),
            Number::I64(value) => values.entry_name(value as u64).map_or_else(|| value.to_string(), str::to_owned),
            Number::F32(_) | Number::F64(_) => unreachable!("an enum is no float"),
        }
    }

    fn view(&mut self, message: &Message, reading: &Reading<'_>) {
        match (&reading.view.access, &reading.content) {
            (Access::Once { getter }, Content::Once(bits)) => self.bits(&getter.shown(), bits.as_ref()),
            (Access::Slots(parts), Content::Slots(slots)) => {
                for slot in slots {
                    slot.keys.iter().for_each(|key| self.key(message, key));
                    self.bits(&parts.items.shown(), slot.status.as_ref());
                }
            }
            (Access::Record(parts), Content::Record(values)) => {
                self.say(&parts.getter.shown(), if values.is_some() { "is" } else { "-" });
                values.iter().flatten().for_each(|value| self.key(message, value));
            }
            _ => unreachable!("a view and its content"),
        }
    }

    fn key(&mut self, message: &Message, key: &KeyValue<'_>) {
        let name = key.key.name.shown();
        let told = match (key.number, message.fields[key.key.place.field.0].values) {
            _ if key.is_invalid() => "-".to_owned(),
            (Number::U64(value), Some(Values::Typed(id))) => self.entry(id, value),
            (Number::I64(value), Some(Values::Typed(id))) => self.entry(id, value as u64),
            (Number::U64(value), _) => value.to_string(),
            (Number::I64(value), _) => value.to_string(),
            (Number::F32(value), _) => format!("{value:?}"),
            (Number::F64(value), _) => format!("{value:?}"),
        };
        self.say(&name, &told);
    }

    fn bits(&mut self, name: &str, bits: Option<&Bits<'_>>) {
        self.say(name, if bits.is_some() { "is" } else { "-" });
        let Some(bits) = bits else { return };
        for member in &bits.view().members {
            let count = member.repeat.map_or(1, |repeat| repeat.count);
            for index in 0..count {
                let told = bits.value(member, index).map_or("-".to_owned(), |value| match value {
                    Value::Flag(flag) => flag.to_string(),
                    Value::Entry(id, value) => self.entry(id, value),
                    Value::Unsigned(value) => value.to_string(),
                    Value::Signed(value) => value.to_string(),
                    Value::Scaled(ratio) => format!("{:?}", ratio.to_f64() as f32),
                });
                self.say(&member.name.shown(), &told);
            }
        }
    }
}

/// A dialect of one root, which mavgen accepts.
fn accepted(sample: &Sample) -> Option<(u64, &Accepted)> {
    let accepted = sample.accepted().filter(|accepted| accepted.resolved.others.is_empty())?;
    Some((sample.case.seed, accepted))
}

/// The program of all these dialects.
fn program(package: &Package, samples: &[Sample]) -> String {
    let mut text = String::from("#![allow(warnings)]\n");
    samples.iter().for_each(|sample| package.add(sample, &mut text));
    let sources = samples.iter().filter_map(accepted).map(|(seed, accepted)| {
        let sources = Sources { module: format!("seed_{seed}"), files: &accepted.files };
        (seed, sources, accepted.resolved.dialect.messages.as_slice())
    });
    text + &program::tell(sources) + program::HEAD
}

#[test]
fn accessors_say_what_the_interpreter_says() {
    let samples = crate::seeds().map(|seed| Sample::of(random_dialects::case(seed)));
    let samples: Vec<Sample> = samples.filter(|sample| accepted(sample).is_some()).take(DIALECTS).collect();
    let package = Package::new("meaning");
    package.write("src/main.rs", &program(&package, &samples));
    let (mut input, mut expected) = (String::new(), String::new());
    for (seed, accepted) in samples.iter().filter_map(accepted) {
        let (dialect, tables) = (&accepted.resolved.dialect, Tables::leak(&accepted.resolved.dialect));
        for (id, payload) in payloads(dialect, seed) {
            let message = dialect.messages.iter().find(|message| message.id == id).unwrap();
            let line = format!("{seed} {id} {}\n", hex(&payload));
            expected += &(line.clone() + &told(message, &tables, &payload));
            input += &line;
        }
    }
    let said = package.cargo(&["run", "--quiet"], &input).unwrap_or_else(|said| panic!("{said}"));
    assert!(expected.lines().count() > LINES * samples.len(), "{}", expected.lines().count());
    if let Some(at) = said.lines().zip(expected.lines()).position(|(said, expected)| said != expected) {
        let before: Vec<&str> = expected.lines().take(at + 1).collect();
        let payload = before.iter().rposition(|line| line.split(' ').count() == 3).unwrap_or_default();
        panic!("{}\nbut the accessor: {:?}", before[payload..].join("\n"), said.lines().nth(at));
    }
    assert_eq!(said.lines().count(), expected.lines().count());
}

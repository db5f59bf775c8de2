//! `EscStatus` of three definitions, as generated code would have it.

use mavlink_wire::uorb::{Field, Kind, Place, Topic};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EscReport {
    pub timestamp: u64,
    pub esc_rpm: i32,
    pub esc_voltage: f32,
    pub motor_temperature: i16,
    pub failures: u16,
    pub actuator_function: u8,
    pub esc_power: i8,
    pub esc_address: u8,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EscStatus {
    pub timestamp: u64,
    pub counter: u16,
    pub esc_online_flags: u16,
    pub esc: [EscReport; 12],
}

impl Topic for EscReport {
    const NAME: &'static str = "EscReport";
    const TOPICS: &'static [&'static str] = &["esc_report"];
    const FIELDS: &'static [Field] = &[
        Field::new("timestamp", Kind::U64),
        Field::new("esc_rpm", Kind::I32),
        Field::new("esc_voltage", Kind::F32),
        Field::new("motor_temperature", Kind::I16),
        Field::new("failures", Kind::U16),
        Field::new("actuator_function", Kind::U8),
        Field::new("esc_power", Kind::I8),
        Field::new("esc_address", Kind::U8),
    ];
    const UNKNOWN: Self = Self {
        timestamp: 0,
        esc_rpm: 0,
        esc_voltage: f32::NAN,
        motor_temperature: 0,
        failures: 0,
        actuator_function: 0,
        esc_power: 0,
        esc_address: 0,
    };
    type Places = [Place; 8];
    const ABSENT: Self::Places = [Place::ABSENT; 8];

    fn read(places: &[Place], record: &[u8]) -> Self {
        let Some([timestamp, rpm, voltage, temperature, failures, function, power, address]) = places.first_chunk()
        else {
            return Self::UNKNOWN;
        };
        Self {
            timestamp: timestamp.get(record).unwrap_or(0),
            esc_rpm: rpm.get(record).unwrap_or(0),
            esc_voltage: voltage.get(record).unwrap_or(f32::NAN),
            motor_temperature: temperature.get(record).unwrap_or(0),
            failures: failures.get(record).unwrap_or(0),
            actuator_function: function.get(record).unwrap_or(0),
            esc_power: power.get(record).unwrap_or(0),
            esc_address: address.get(record).unwrap_or(0),
        }
    }
}

impl Topic for EscStatus {
    const NAME: &'static str = "EscStatus";
    const TOPICS: &'static [&'static str] = &["esc_status"];
    const FIELDS: &'static [Field] = &[
        Field::new("timestamp", Kind::U64),
        Field::new("counter", Kind::U16),
        Field::new("esc_online_flags", Kind::U16),
        Field::nested("esc", "EscReport", EscReport::FIELDS).array(12),
    ];
    const UNKNOWN: Self = Self { timestamp: 0, counter: 0, esc_online_flags: 0, esc: [EscReport::UNKNOWN; 12] };
    type Places = [Place; 12];
    const ABSENT: Self::Places = [Place::ABSENT; 12];

    fn read(places: &[Place], record: &[u8]) -> Self {
        let Some(([timestamp, counter, online, esc], reports)) = places.split_first_chunk() else {
            return Self::UNKNOWN;
        };
        let mut status = Self {
            timestamp: timestamp.get(record).unwrap_or(0),
            counter: counter.get(record).unwrap_or(0),
            esc_online_flags: online.get(record).unwrap_or(0),
            ..Self::UNKNOWN
        };
        for (i, report) in (0..).zip(&mut status.esc) {
            let Some(nested) = esc.nested(record, i) else { break };
            *report = EscReport::read(reports, nested);
        }
        status
    }
}

//! `EscStatus` of two definitions, as generated code would have it.

use mavlink_wire::generated::{get, put};
use mavlink_wire::uorb::cdr::CdrError;
use mavlink_wire::uorb::{Definition, Topic, TopicByLength};

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EscReport {
    pub(crate) timestamp: u64,
    pub(crate) esc_errorcount: u32,
    pub(crate) esc_rpm: i32,
    pub(crate) esc_voltage: f32,
    pub(crate) esc_current: f32,
    pub(crate) esc_temperature: f32,
    pub(crate) motor_temperature: i16,
    pub(crate) esc_state: u8,
    pub(crate) actuator_function: u8,
    pub(crate) failures: u16,
    pub(crate) esc_power: i8,
    pub(crate) esc_address: u8,
    pub(crate) esc_cmdcount: u8,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct EscStatus {
    pub(crate) timestamp: u64,
    pub(crate) counter: u16,
    pub(crate) esc_count: u8,
    pub(crate) esc_connectiontype: u8,
    pub(crate) esc_online_flags: u16,
    pub(crate) esc_armed_flags: u16,
    pub(crate) esc: [EscReport; 12],
}

impl EscReport {
    pub(crate) const UNKNOWN: Self = Self {
        timestamp: 0,
        esc_errorcount: 0,
        esc_rpm: 0,
        esc_voltage: f32::NAN,
        esc_current: f32::NAN,
        esc_temperature: f32::NAN,
        motor_temperature: 0,
        esc_state: 0,
        actuator_function: 0,
        failures: 0,
        esc_power: 0,
        esc_address: 0,
        esc_cmdcount: 0,
    };
}

/// As a package would have it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "as generated")]
pub(crate) enum Any {
    EscReport(EscReport),
    EscStatus(EscStatus),
}

mavlink_wire::topics!(Any { EscReport, EscStatus });

mavlink_wire::topic!(EscReport {
    timestamp,
    esc_errorcount,
    esc_rpm,
    esc_voltage,
    esc_current,
    esc_temperature,
    motor_temperature,
    esc_state,
    actuator_function,
    failures,
    esc_power,
    esc_address,
    esc_cmdcount
});

/// Nested only: nothing is read or written of it alone.
impl Topic for EscReport {
    const NAME: &'static str = "EscReport";
    const TOPICS: &'static [&'static str] = &["esc_report"];
    const DEFINITIONS: &'static [Definition] = &[];

    fn store_record(&self, _: &mut [u8]) -> Result<(), CdrError> {
        Err(CdrError::Definition)
    }

    fn read_cdr(_: usize, _: &[u8]) -> Result<Self, CdrError> {
        Err(CdrError::Definition)
    }

    fn store_cdr(&self, _: usize, _: &mut [u8]) -> Result<(), CdrError> {
        Err(CdrError::Definition)
    }
}

mavlink_wire::topic!(EscStatus {
    timestamp,
    counter,
    esc_count,
    esc_connectiontype,
    esc_online_flags,
    esc_armed_flags,
    esc
});

impl EscStatus {
    pub(crate) const UNKNOWN: Self = Self {
        timestamp: 0,
        counter: 0,
        esc_count: 0,
        esc_connectiontype: 0,
        esc_online_flags: 0,
        esc_armed_flags: 0,
        esc: [EscReport::UNKNOWN; 12],
    };
    pub(crate) const MAIN: Definition = Definition::new("EscStatus", "main")
        .hashes(0x4d8f_7be2, "RIHS01_85dc04703b64002f2a39e5909078ae7b7301da32ef14a04329f4ca9e40e635a2")
        .lengths(491, 496)
        .formats(&[
            "esc_status:uint64_t timestamp;uint16_t counter;uint16_t esc_online_flags;uint16_t esc_armed_flags;uint8_t esc_count;uint8_t esc_connectiontype;esc_report[12] esc;",
            "esc_report:uint64_t timestamp;uint32_t esc_errorcount;int32_t esc_rpm;float esc_voltage;float esc_current;float esc_temperature;int16_t motor_temperature;uint16_t failures;uint8_t esc_state;uint8_t actuator_function;int8_t esc_power;uint8_t[5] _padding0;",
        ]);
    pub(crate) const V1_14: Definition = Definition::new("EscStatus", "v1_14")
        .hashes(0xabbd_16f2, "RIHS01_54a755e6c653baa5d7bb3ac111ec66819e45a281bb09c1abc90bff3bc5cca0d3")
        .lengths(331, 336)
        .formats(&[
            "esc_status:uint64_t timestamp;uint16_t counter;uint8_t esc_count;uint8_t esc_connectiontype;uint8_t esc_online_flags;uint8_t esc_armed_flags;uint8_t[2] _padding0;esc_report[8] esc;",
            "esc_report:uint64_t timestamp;uint32_t esc_errorcount;int32_t esc_rpm;float esc_voltage;float esc_current;float esc_temperature;uint16_t failures;uint8_t esc_address;uint8_t esc_cmdcount;uint8_t esc_state;uint8_t actuator_function;int8_t esc_power;uint8_t[5] _padding0;",
        ]);
}

impl TopicByLength for EscStatus {}

impl Topic for EscStatus {
    const NAME: &'static str = "EscStatus";
    const TOPICS: &'static [&'static str] = &["esc_status"];
    const DEFINITIONS: &'static [Definition] = &[Self::MAIN, Self::V1_14];

    fn store_record(&self, p: &mut [u8]) -> Result<(), CdrError> {
        put(p, 0, self.timestamp);
        put(p, 8, self.counter);
        put(p, 10, self.esc_online_flags);
        put(p, 12, self.esc_armed_flags);
        put(p, 14, self.esc_count);
        put(p, 15, self.esc_connectiontype);
        for (at, report) in (16..).step_by(40).zip(&self.esc) {
            put(p, at, report.timestamp);
            put(p, at + 8, report.esc_errorcount);
            put(p, at + 12, report.esc_rpm);
            put(p, at + 16, report.esc_voltage);
            put(p, at + 20, report.esc_current);
            put(p, at + 24, report.esc_temperature);
            put(p, at + 28, report.motor_temperature);
            put(p, at + 30, report.failures);
            put(p, at + 32, report.esc_state);
            put(p, at + 33, report.actuator_function);
            put(p, at + 34, report.esc_power);
        }
        Ok(())
    }

    fn read_cdr(definition: usize, p: &[u8]) -> Result<Self, CdrError> {
        let mut status = Self::UNKNOWN;
        match definition {
            0 => {
                status.timestamp = get(p, 0);
                status.counter = get(p, 8);
                status.esc_count = get(p, 10);
                status.esc_connectiontype = get(p, 11);
                status.esc_online_flags = get(p, 12);
                status.esc_armed_flags = get(p, 14);
                for (at, report) in (16..).step_by(40).zip(&mut status.esc[..12]) {
                    *report = EscReport {
                        timestamp: get(p, at),
                        esc_errorcount: get(p, at + 8),
                        esc_rpm: get(p, at + 12),
                        esc_voltage: get(p, at + 16),
                        esc_current: get(p, at + 20),
                        esc_temperature: get(p, at + 24),
                        motor_temperature: get(p, at + 28),
                        esc_state: get(p, at + 30),
                        actuator_function: get(p, at + 31),
                        failures: get(p, at + 32),
                        esc_power: get(p, at + 34),
                        ..EscReport::UNKNOWN
                    };
                }
            }
            1 => {
                status.timestamp = get(p, 0);
                status.counter = get(p, 8);
                status.esc_count = get(p, 10);
                status.esc_connectiontype = get(p, 11);
                status.esc_online_flags = get::<u8>(p, 12).into();
                status.esc_armed_flags = get::<u8>(p, 13).into();
                for (at, report) in (16..).step_by(40).zip(&mut status.esc[..8]) {
                    *report = EscReport {
                        timestamp: get(p, at),
                        esc_errorcount: get(p, at + 8),
                        esc_rpm: get(p, at + 12),
                        esc_voltage: get(p, at + 16),
                        esc_current: get(p, at + 20),
                        esc_temperature: get(p, at + 24),
                        esc_address: get(p, at + 28),
                        esc_cmdcount: get(p, at + 29),
                        esc_state: get(p, at + 30),
                        actuator_function: get(p, at + 31),
                        failures: get(p, at + 32),
                        esc_power: get(p, at + 34),
                        ..EscReport::UNKNOWN
                    };
                }
            }
            _ => return Err(CdrError::Definition),
        }
        Ok(status)
    }

    fn store_cdr(&self, definition: usize, p: &mut [u8]) -> Result<(), CdrError> {
        match definition {
            0 => {
                put(p, 0, self.timestamp);
                put(p, 8, self.counter);
                put(p, 10, self.esc_count);
                put(p, 11, self.esc_connectiontype);
                put(p, 12, self.esc_online_flags);
                put(p, 14, self.esc_armed_flags);
                for (at, report) in (16..).step_by(40).zip(&self.esc[..12]) {
                    put(p, at, report.timestamp);
                    put(p, at + 8, report.esc_errorcount);
                    put(p, at + 12, report.esc_rpm);
                    put(p, at + 16, report.esc_voltage);
                    put(p, at + 20, report.esc_current);
                    put(p, at + 24, report.esc_temperature);
                    put(p, at + 28, report.motor_temperature);
                    put(p, at + 30, report.esc_state);
                    put(p, at + 31, report.actuator_function);
                    put(p, at + 32, report.failures);
                    put(p, at + 34, report.esc_power);
                }
            }
            1 => {
                put(p, 0, self.timestamp);
                put(p, 8, self.counter);
                put(p, 10, self.esc_count);
                put(p, 11, self.esc_connectiontype);
                put(
                    p,
                    12,
                    u8::try_from(self.esc_online_flags)
                        .map_err(|_| CdrError::DoesNotFit { field: "esc_online_flags" })?,
                );
                put(
                    p,
                    13,
                    u8::try_from(self.esc_armed_flags)
                        .map_err(|_| CdrError::DoesNotFit { field: "esc_armed_flags" })?,
                );
                for (at, report) in (16..).step_by(40).zip(&self.esc[..8]) {
                    put(p, at, report.timestamp);
                    put(p, at + 8, report.esc_errorcount);
                    put(p, at + 12, report.esc_rpm);
                    put(p, at + 16, report.esc_voltage);
                    put(p, at + 20, report.esc_current);
                    put(p, at + 24, report.esc_temperature);
                    put(p, at + 28, report.esc_address);
                    put(p, at + 29, report.esc_cmdcount);
                    put(p, at + 30, report.esc_state);
                    put(p, at + 31, report.actuator_function);
                    put(p, at + 32, report.failures);
                    put(p, at + 34, report.esc_power);
                }
            }
            _ => return Err(CdrError::Definition),
        }
        Ok(())
    }
}

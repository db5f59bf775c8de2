//! What one controller did over time, in as many bins as a picture can show.

use crate::quantity::{Quantity, Values};

/// Bins that are kept at most: when a flight is longer, two become one.
const MAX_BINS: usize = 800;

/// Microseconds of a bin at first.
const FIRST_WIDTH_US: u64 = 100_000;

/// Microseconds without a report over which no line is drawn.
const GAP_US: u64 = 3_000_000;

/// The lowest and the highest value of a bin, in the order in which they came.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Range {
    low: f32,
    high: f32,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Bin {
    ranges: [Option<Range>; 4],
    /// The controller was silent for a part of it.
    silent: bool,
}

/// The course of one controller's values.
#[derive(Clone, Debug)]
pub(super) struct Trace {
    width_us: u64,
    bins: Vec<Bin>,
}

impl Trace {
    pub(super) const fn new() -> Self {
        Self { width_us: FIRST_WIDTH_US, bins: Vec::new() }
    }

    /// Adds a report at a time since the start; `None` is that of a silent controller.
    pub(super) fn add(&mut self, time_us: u64, report: Option<Values>) {
        while time_us / self.width_us >= MAX_BINS as u64 {
            self.halve();
        }
        let index = (time_us / self.width_us) as usize;
        if index >= self.bins.len() {
            self.bins.resize(index + 1, Bin::default());
        }
        let Some(bin) = self.bins.get_mut(index) else { return };
        match report {
            None => bin.silent = true,
            Some(values) => {
                let point = Bin {
                    ranges: values.map(|value| value.map(|value| Range { low: value, high: value })),
                    silent: false,
                };
                *bin = joined(*bin, point);
            }
        }
    }

    /// Lines of points, in seconds since the start: broken where the controller was silent.
    pub(super) fn lines(&self, quantity: Quantity) -> Vec<Vec<(f64, f64)>> {
        let mut lines: Vec<Vec<(f64, f64)>> = Vec::new();
        let (mut last, mut broken) = (None::<u64>, true);
        for (index, bin) in (0_u64..).zip(&self.bins) {
            let Some(range) = bin.ranges.get(quantity as usize).copied().flatten() else {
                broken |= bin.silent;
                continue;
            };
            let start_us = index * self.width_us;
            if broken || last.is_none_or(|last| start_us - last > GAP_US.max(2 * self.width_us)) {
                lines.push(Vec::new());
            }
            let second = (start_us + self.width_us / 2) as f64 / 1e6;
            if let Some(line) = lines.last_mut() {
                extend(line, second, range);
            }
            (last, broken) = (Some(start_us), bin.silent);
        }
        lines
    }

    fn halve(&mut self) {
        self.width_us *= 2;
        let pairs = self.bins.chunks(2);
        self.bins = pairs.map(|pair| pair.iter().copied().fold(Bin::default(), joined)).collect();
    }
}

/// Continues a line by a bin: at the end of its range that is nearer, then at the other.
fn extend(line: &mut Vec<(f64, f64)>, second: f64, range: Range) {
    let (low, high) = (f64::from(range.low), f64::from(range.high));
    let falls = line.last().is_some_and(|&(_, before)| before > (low + high) / 2.0);
    let (near, far) = if falls { (high, low) } else { (low, high) };
    line.push((second, near));
    if low < high {
        line.push((second, far));
    }
}

fn joined(one: Bin, other: Bin) -> Bin {
    let mut ranges = one.ranges;
    for (range, other) in ranges.iter_mut().zip(other.ranges) {
        *range = match (*range, other) {
            (Some(one), Some(other)) => Some(Range { low: one.low.min(other.low), high: one.high.max(other.high) }),
            (one, other) => one.or(other),
        };
    }
    Bin { ranges, silent: one.silent || other.silent }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn speed(rpm: f32) -> Option<Values> {
        Some([Some(rpm), None, None, None])
    }

    #[test]
    fn a_line_breaks_where_a_controller_is_silent() {
        let mut trace = Trace::new();
        for tenth in 0..100 {
            trace.add(tenth * 100_000, if (40..60).contains(&tenth) { None } else { speed(tenth as f32) });
        }
        let lines = trace.lines(Quantity::Speed);
        assert_eq!(lines.iter().map(Vec::len).collect::<Vec<_>>(), [40, 40]);
        assert_eq!((lines[0][0], lines[1][0]), ((0.05, 0.0), (6.05, 60.0)));
        assert!(trace.lines(Quantity::Current).is_empty());
    }

    #[test]
    fn a_long_flight_keeps_its_extremes_in_few_bins() {
        let mut trace = Trace::new();
        for tenth in 0..360_000_u64 {
            trace.add(tenth * 100_000, speed(if tenth == 123_456 { 9999.0 } else { 5000.0 }));
        }
        let lines = trace.lines(Quantity::Speed);
        assert!(trace.bins.len() <= MAX_BINS && lines.len() == 1, "{}", lines.len());
        assert!(lines[0].iter().any(|&(second, rpm)| rpm == 9999.0 && (second - 12_345.6).abs() < 60.0));
    }

    #[test]
    fn telemetry_once_a_second_is_one_line() {
        let mut trace = Trace::new();
        (0..60).for_each(|second| trace.add(second * 1_000_000, speed(1.0)));
        assert_eq!(trace.lines(Quantity::Speed).len(), 1);
    }
}

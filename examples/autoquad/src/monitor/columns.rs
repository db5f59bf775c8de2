//! The table of controllers: which columns fit, and what stands in them.

use std::collections::VecDeque;

use ratatui::style::Style;
use ratatui::text::{Line, Span};

use super::fleet::{Shown, Totals, Vehicle, age_text};
use super::limits::{Level, Limits};
use super::paint::Paint;
use crate::quantity::{Quantity, Values};
use crate::telemetry::power_w;

/// Characters of a trend, from low to high.
const STEPS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];

/// The widest trend.
const MAX_TREND: usize = 60;

/// The least that a trend needs.
const MIN_TREND: usize = 8;

/// One column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Column {
    Port,
    /// The first letter of the state.
    Letter,
    State,
    Volts,
    Amperes,
    Watts,
    Rpm,
    Duty,
    /// A temperature, or a count of errors: each firmware has one of them.
    Third,
    Age,
    Trend,
}

impl Column {
    /// As they stand.
    const ALL: [Self; 11] = [
        Self::Port,
        Self::Letter,
        Self::State,
        Self::Volts,
        Self::Amperes,
        Self::Watts,
        Self::Rpm,
        Self::Duty,
        Self::Third,
        Self::Age,
        Self::Trend,
    ];

    /// From the one that is needed most; the letter and the state stand for each other.
    const BY_NEED: [Self; 9] = [
        Self::Port,
        Self::Rpm,
        Self::Amperes,
        Self::Volts,
        Self::Third,
        Self::Age,
        Self::Watts,
        Self::Duty,
        Self::Trend,
    ];

    const fn width(self) -> usize {
        match self {
            Self::Letter => 1,
            Self::Port => 3,
            Self::Rpm => 5,
            Self::Duty => 4,
            Self::Volts | Self::Amperes => 6,
            Self::Watts | Self::Age => 7,
            Self::State | Self::Trend => 8,
            Self::Third => 10,
        }
    }

    fn head(self, trend: Quantity) -> String {
        match self {
            Self::Port => "ESC",
            Self::Letter => "S",
            Self::State => "state",
            Self::Volts => "V",
            Self::Amperes => "A",
            Self::Watts => "W",
            Self::Rpm => "rpm",
            Self::Duty => "%",
            Self::Third => "°C/errors",
            Self::Age => "age",
            Self::Trend => trend.label(),
        }
        .to_owned()
    }
}

/// What the trends show: from the lowest to the highest value of all controllers.
pub(super) struct Trend {
    pub(super) quantity: Quantity,
    pub(super) low: f32,
    pub(super) high: f32,
}

/// What the rows of a vehicle have in common.
pub(super) struct Scene<'s> {
    pub(super) vehicle: &'s Vehicle,
    pub(super) limits: &'s Limits,
    pub(super) trend: Trend,
    pub(super) paint: Paint,
}

/// The columns that fit, and what is left for the trend.
pub(super) struct Columns {
    shown: Vec<Column>,
    trend: usize,
}

impl Columns {
    /// As many as fit into so many characters, the needed ones first.
    pub(super) fn fitting(width: usize) -> Self {
        let mut shown = vec![Column::Port, Column::Letter];
        let taken = |shown: &[Column]| shown.iter().map(|column| column.width() + 1).sum::<usize>() - 1;
        for column in Column::BY_NEED.into_iter().skip(1) {
            if taken(&shown) + 1 + column.width() <= width {
                shown.push(column);
            }
            // The whole state, once the values are there.
            if column == Column::Volts && taken(&shown) + Column::State.width() - 1 <= width {
                shown.retain(|&column| column != Column::Letter);
                shown.push(Column::State);
            }
        }
        let spare = width.saturating_sub(taken(&shown));
        let trend = (MIN_TREND + spare).min(MAX_TREND);
        shown.sort_by_key(|&column| column as u8);
        debug_assert!(shown.iter().all(|column| Column::ALL.contains(column)));
        Self { shown, trend }
    }

    /// The names and units.
    pub(super) fn head(&self, trend: Quantity, paint: Paint) -> Line<'static> {
        let cells = self.shown.iter().map(|&column| self.cell(column, &column.head(trend)));
        Line::styled(cells.collect::<Vec<_>>().join(" "), paint.heading())
    }

    /// One controller.
    pub(super) fn row(&self, shown: &Shown, scene: &Scene<'_>) -> Line<'static> {
        let mut spans = Vec::new();
        for &column in &self.shown {
            if !spans.is_empty() {
                spans.push(Span::raw(" "));
            }
            let text = match column {
                Column::Trend => {
                    let points = scene.vehicle.trends.get(&shown.port);
                    points.map_or_else(String::new, |points| spark(points, &scene.trend, self.trend))
                }
                _ => value(column, shown),
            };
            spans.push(Span::styled(self.cell(column, &text), style(column, shown, scene)));
        }
        Line::from(spans)
    }

    /// Sums and means.
    pub(super) fn totals(&self, totals: &Totals, paint: Paint) -> Line<'static> {
        let cells = self.shown.iter().map(|&column| {
            let text = match column {
                Column::Port => "all".to_owned(),
                Column::State => format!("{}/{} on", totals.online, totals.motors),
                Column::Volts => format!("{:.2}", totals.mean_v),
                Column::Amperes => format!("{:.2}", totals.current_a),
                Column::Watts => format!("{:.1}", totals.power_w),
                _ => String::new(),
            };
            self.cell(column, &text)
        });
        Line::styled(cells.collect::<Vec<_>>().join(" "), paint.heading())
    }

    /// Text in the width of its column: numbers to the right, names to the left.
    fn cell(&self, column: Column, text: &str) -> String {
        match column {
            Column::Letter | Column::State => format!("{text:<width$}", width = column.width()),
            Column::Trend => format!("{text:<width$.width$}", width = self.trend),
            _ => format!("{text:>width$}", width = column.width()),
        }
    }
}

fn value(column: Column, shown: &Shown) -> String {
    let letter = shown.state.get(..1).unwrap_or_default().to_owned();
    match (column, shown.status) {
        (Column::Port, _) => shown.port.to_string(),
        (Column::Letter, _) => letter,
        (Column::State, _) => shown.state.clone(),
        (Column::Age, _) => shown.age_ms.map(age_text).unwrap_or_default(),
        (_, None) => "-".to_owned(),
        (Column::Volts, Some(status)) => format!("{:.2}", status.voltage()),
        (Column::Amperes, Some(status)) => format!("{:.2}", status.current()),
        (Column::Watts, Some(status)) => format!("{:.1}", power_w(status)),
        (Column::Rpm, Some(status)) => status.rpm().to_string(),
        (Column::Duty, Some(status)) => format!("{:.0}", status.duty()),
        (Column::Third, Some(status)) => match (status.temperature(), status.errors()) {
            (Some(degrees), _) => format!("{degrees:.1} °C"),
            (None, Some(errors)) => format!("{errors} err"),
            (None, None) => String::new(),
        },
        (Column::Trend, Some(_)) => String::new(),
    }
}

fn style(column: Column, shown: &Shown, scene: &Scene<'_>) -> Style {
    let (vehicle, limits, paint) = (scene.vehicle, scene.limits, scene.paint);
    let Some(status) = shown.status else {
        return if matches!(column, Column::State | Column::Letter) {
            paint.level(Level::Fault)
        } else {
            paint.faint()
        };
    };
    match column {
        Column::Volts => paint.level(vehicle.level(Quantity::Voltage, status, limits)),
        Column::Amperes => paint.level(vehicle.level(Quantity::Current, status, limits)),
        Column::Third => paint.level(vehicle.level(Quantity::Temperature, status, limits)),
        Column::State | Column::Letter if shown.trouble.is_some() => paint.level(Level::Fault),
        Column::State | Column::Letter => paint.state(&shown.state),
        Column::Trend => paint.trend(),
        _ => Style::default(),
    }
}

/// The last points of a trend as a row of bars.
fn spark(points: &VecDeque<Values>, trend: &Trend, width: usize) -> String {
    let range = (trend.high - trend.low).max(f32::MIN_POSITIVE);
    let bar = |values: &Values| match trend.quantity.of(values) {
        None => ' ',
        Some(value) => {
            let step = ((value - trend.low) / range * (STEPS.len() - 1) as f32).round() as usize;
            STEPS.get(step).copied().unwrap_or('█')
        }
    };
    points.iter().skip(points.len().saturating_sub(width)).map(bar).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heads(width: usize) -> Vec<Column> {
        Columns::fitting(width).shown
    }

    #[test]
    fn columns_go_as_the_terminal_gets_narrow() {
        assert_eq!(heads(20), [Column::Port, Column::Letter, Column::Amperes, Column::Rpm]);
        assert!(heads(40).contains(&Column::State) && heads(40).contains(&Column::Volts));
        assert!(heads(80).contains(&Column::Duty) && heads(80).contains(&Column::Trend));
        for width in 16..200 {
            let line = Columns::fitting(width).head(Quantity::Speed, Paint::plain());
            assert!(line.width() <= width, "{} of {width} columns: {line}", line.width());
        }
    }

    #[test]
    fn a_trend_shows_its_last_points_and_leaves_gaps() {
        let point = |value| [value, None, None, None];
        let points = [Some(1.0), Some(0.0), None, Some(4.0), Some(8.0)].map(point).into();
        let trend = |quantity| Trend { quantity, low: 0.0, high: 8.0 };
        assert_eq!(spark(&points, &trend(Quantity::Speed), 4), "▁ ▅█");
        assert_eq!(spark(&points, &trend(Quantity::Current), 4), "    ");
    }
}

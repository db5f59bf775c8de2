//! The picture: a panel for each quantity, a line for each controller, marks where something happened.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::drawing::DrawingAreaErrorKind;
use plotters::prelude::{
    BLACK, Cartesian2d, ChartBuilder, ChartContext, Color, DrawingArea, DrawingBackend, IntoFont, IntoTextStyle,
    LineSeries, PathElement, RGBColor, Text, TextStyle, WHITE,
};

use super::flight::{Event, Flight};
use crate::quantity::Quantity;
use crate::time;

/// Colours that sixteen lines can be told apart by.
const COLOURS: [RGBColor; 16] = [
    RGBColor(31, 119, 180),
    RGBColor(255, 127, 14),
    RGBColor(44, 160, 44),
    RGBColor(214, 39, 40),
    RGBColor(148, 103, 189),
    RGBColor(140, 86, 75),
    RGBColor(227, 119, 194),
    RGBColor(127, 127, 127),
    RGBColor(160, 160, 20),
    RGBColor(23, 190, 207),
    RGBColor(10, 50, 120),
    RGBColor(120, 0, 60),
    RGBColor(0, 90, 50),
    RGBColor(255, 170, 170),
    RGBColor(90, 220, 90),
    RGBColor(0, 0, 0),
];

/// Events that are written out at most; the others are counted.
const MAX_LABELS: usize = 6;

/// In pixels.
const LEGEND_WIDTH: u32 = 110;
const LINE_HEIGHT: u32 = 22;
const AXIS_WIDTH: u32 = 76;
const MARGIN: u32 = 24;

/// Up to how many lines are drawn thick.
const FEW: usize = 6;

type Area<DB> = DrawingArea<DB, Shift>;
type Result<T, DB> = std::result::Result<T, DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;
type Chart<'a, DB> = ChartContext<'a, DB, Cartesian2d<Clock, RangedCoordf64>>;

/// Draws a flight.
pub(super) fn draw<DB: DrawingBackend>(root: &Area<DB>, flight: &Flight) -> Result<(), DB> {
    root.fill(&WHITE)?;
    let labels = flight.events.len().min(MAX_LABELS + 1) as u32;
    let (head, body) = root.split_vertically(2 * LINE_HEIGHT + labels * LINE_HEIGHT);
    let width = root.dim_in_pixel().0;
    let (panels, legend) = body.split_horizontally(width.saturating_sub(LEGEND_WIDTH));
    draw_head(&head, flight)?;
    draw_legend(&legend, flight)?;
    let shown: Vec<Quantity> = Quantity::ALL.into_iter().filter(|&quantity| is_measured(flight, quantity)).collect();
    let areas = panels.split_evenly((shown.len().max(1), 1));
    for (index, (area, &quantity)) in areas.iter().zip(&shown).enumerate() {
        draw_panel(area, flight, quantity, index + 1 == shown.len())?;
    }
    root.present()
}

fn is_measured(flight: &Flight, quantity: Quantity) -> bool {
    flight.motors.values().any(|trace| !trace.lines(quantity).is_empty())
}

fn colour(port: u8) -> RGBColor {
    let index = usize::from(port.wrapping_sub(1)) % COLOURS.len();
    COLOURS.get(index).copied().unwrap_or(BLACK)
}

fn style<'t>(size: u32) -> TextStyle<'t> {
    ("sans-serif", size).into_font().into_text_style(&(1, 1))
}

/// The title, and what happened.
fn draw_head<DB: DrawingBackend>(area: &Area<DB>, flight: &Flight) -> Result<(), DB> {
    let motors = flight.motors.len();
    let start =
        flight.start_us.and_then(time::iso).map(|iso| format!(", {}", iso.get(..19).unwrap_or(&iso).replace('T', " ")));
    let title = format!(
        "AutoQuad {}: {motors} motor controller{}{}{}",
        flight.system,
        if motors == 1 { "" } else { "s" },
        start.as_deref().unwrap_or_default(),
        if start.is_some() { " UTC" } else { "" },
    );
    let left = (MARGIN + AXIS_WIDTH) as i32;
    area.draw(&Text::new(title, (left, 10), style(22)))?;
    for (row, event) in (0_i32..).zip(flight.events.iter().take(MAX_LABELS)) {
        let text = format!("{}  ESC {}: {}", time::clock(event.time_us), event.port, event.what);
        area.draw(&Text::new(text, (left, 42 + row * LINE_HEIGHT as i32), style(16).color(&colour(event.port))))?;
    }
    if let Some(more) = flight.events.len().checked_sub(MAX_LABELS).filter(|&more| more > 0) {
        let row = MAX_LABELS as i32;
        area.draw(&Text::new(format!("and {more} more"), (left, 42 + row * LINE_HEIGHT as i32), style(16)))?;
    }
    Ok(())
}

fn draw_legend<DB: DrawingBackend>(area: &Area<DB>, flight: &Flight) -> Result<(), DB> {
    for (row, &port) in (0_i32..).zip(flight.motors.keys()) {
        let y = 20 + row * LINE_HEIGHT as i32;
        area.draw(&PathElement::new([(10, y), (34, y)], colour(port).stroke_width(3)))?;
        area.draw(&Text::new(format!("ESC {port}"), (42, y - 8), style(16)))?;
    }
    Ok(())
}

fn draw_panel<DB: DrawingBackend>(
    area: &Area<DB>,
    flight: &Flight,
    quantity: Quantity,
    is_last: bool,
) -> Result<(), DB> {
    let (low, high) = limits(flight, quantity);
    let end = (flight.end_us as f64 / 1e6).max(1.0);
    let mut chart = ChartBuilder::on(area)
        .margin_top(8)
        .margin_right(8)
        .margin_left(MARGIN)
        .y_label_area_size(AXIS_WIDTH)
        .x_label_area_size(if is_last { 44 } else { 6 })
        .build_cartesian_2d(Clock { end }, low..high)?;
    let mut mesh = chart.configure_mesh();
    mesh.y_desc(quantity.label()).y_labels(6).label_style(style(15)).axis_desc_style(style(16));
    let number = |value: &f64| quantity.number(*value);
    mesh.y_label_formatter(&number);
    mesh.light_line_style(WHITE.mix(0.0)).bold_line_style(BLACK.mix(0.12));
    if is_last {
        mesh.x_desc("time since the start (min:s)").draw()?;
    } else {
        mesh.x_label_formatter(&|_| String::new()).draw()?;
    }
    for event in &flight.events {
        mark(&mut chart, event, low, high)?;
    }
    draw_lines(&mut chart, flight, quantity)
}

/// A line for each controller. What something happened to lies on top.
fn draw_lines<DB: DrawingBackend>(chart: &mut Chart<'_, DB>, flight: &Flight, quantity: Quantity) -> Result<(), DB> {
    let width = if flight.motors.len() <= FEW { 2 } else { 1 };
    let is_special = |port: u8| flight.events.iter().any(|event| event.port == port);
    for special in [false, true] {
        for (&port, trace) in flight.motors.iter().filter(|&(&port, _)| is_special(port) == special) {
            let stroke = colour(port).stroke_width(if special { 2 } else { width });
            for line in trace.lines(quantity) {
                chart.draw_series(LineSeries::new(line, stroke))?;
            }
        }
    }
    Ok(())
}

/// The axis of time, in seconds.
struct Clock {
    end: f64,
}

impl Ranged for Clock {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (left, right): (i32, i32)) -> i32 {
        left + (value / self.end * f64::from(right - left)).round() as i32
    }

    /// At whole steps of a clock, up to thirteen.
    fn key_points<H: KeyPointHint>(&self, _hint: H) -> Vec<f64> {
        const STEPS: [u32; 14] = [1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200];
        const DAY: f64 = 86_400.0;
        let step = STEPS.into_iter().map(f64::from).find(|step| self.end / step <= 12.0);
        let step = step.unwrap_or_else(|| (self.end / 12.0 / DAY).ceil() * DAY);
        (0..=12).map(|number| f64::from(number) * step).filter(|&tick| tick <= self.end).collect()
    }

    fn range(&self) -> Range<f64> {
        0.0..self.end
    }
}

impl ValueFormatter<f64> for Clock {
    fn format(second: &f64) -> String {
        time::clock((second.max(0.0) * 1e6) as u64)
    }
}

/// A vertical line where something happened.
fn mark<DB: DrawingBackend>(chart: &mut Chart<'_, DB>, event: &Event, low: f64, high: f64) -> Result<(), DB> {
    let second = event.time_us as f64 / 1e6;
    let line = PathElement::new(vec![(second, low), (second, high)], colour(event.port).mix(0.6).stroke_width(2));
    chart.draw_series([line]).map(drop)
}

/// The ends of the vertical axis, with some room.
fn limits(flight: &Flight, quantity: Quantity) -> (f64, f64) {
    let values = flight.motors.values().flat_map(|trace| trace.lines(quantity)).flatten().map(|(_, value)| value);
    let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
    // Speed and current begin at zero; the others do not have to.
    let low = if matches!(quantity, Quantity::Speed | Quantity::Current) { 0.0 } else { low };
    let room = ((high - low) * 0.06).max(0.1);
    (if low == 0.0 { 0.0 } else { low - room }, high + room)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_have_numbers_at_whole_steps_of_a_clock() {
        for (end, step) in
            [(10.0, 1.0), (120.0, 10.0), (121.0, 15.0), (7200.0, 600.0), (86_400.0, 7200.0), (1e6, 86_400.0)]
        {
            let ticks = Clock { end }.key_points(13);
            assert_eq!((ticks.first(), ticks.get(1)), (Some(&0.0), Some(&step)), "{end} s");
            assert!(ticks.len() <= 13 && ticks.last().is_some_and(|&last| end - last < step), "{end} s: {ticks:?}");
        }
    }
}

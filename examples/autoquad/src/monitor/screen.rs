//! The screen: a pure function of what was heard.

use mavlink_autoquad::wire::SystemId;
use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;

use super::columns::{Columns, Scene, Trend};
use super::fleet::{Fleet, Shown, Vehicle, age_text};
use super::limits::{Level, Limits};
use super::paint::Paint;
use crate::quantity::Quantity;
use crate::time;

/// The smallest screen that shows something.
const MIN_SIZE: (u16, u16) = (16, 4);

/// Microseconds without a message after which the screen says so.
const QUIET_US: u64 = 2_000_000;

/// Texts of vehicles, and troubles of controllers, that are shown at most.
const MAX_NOTES: usize = 4;

/// Where the frames come from.
pub(super) enum Origin<'o> {
    /// A link, and why it is not connected now.
    Link { address: &'o str, trouble: Option<String> },
    /// A recording: µs since its start, µs of the whole, times its speed.
    Log { name: &'o str, progress: (u64, u64), speed: f64, paused: bool },
}

/// All that a screen shows.
pub(super) struct View<'v> {
    pub(super) fleet: &'v Fleet,
    pub(super) origin: Origin<'v>,
    pub(super) now_us: u64,
    /// Which of the vehicles is shown.
    pub(super) selected: usize,
    pub(super) trend: Quantity,
    pub(super) limits: Limits,
    pub(super) paint: Paint,
}

/// Draws a screen.
pub(super) fn draw(frame: &mut Frame<'_>, view: &View<'_>) {
    let area = frame.area();
    if area.width < MIN_SIZE.0 || area.height < MIN_SIZE.1 {
        let (width, height) = MIN_SIZE;
        frame.render_widget(Paragraph::new(format!("too small: {width}x{height} is the least")), area);
        return;
    }
    let foot = view.foot(area.width.into());
    let foot_height = (foot.len() as u16).min(area.height / 4);
    let body = Rect { height: area.height - foot_height, ..area };
    frame.render_widget(Paragraph::new(view.body(area.width.into(), body.height.into())), body);
    let foot_area = Rect { y: body.height, height: foot_height, ..area };
    let hidden = foot.len() - usize::from(foot_height);
    frame.render_widget(Paragraph::new(foot.into_iter().skip(hidden).collect::<Vec<_>>()), foot_area);
}

impl View<'_> {
    /// From the top to the notes; what there is no room for is left out, the controllers last.
    fn body(&self, width: usize, height: usize) -> Vec<Line<'static>> {
        let vehicles: Vec<(&SystemId, &Vehicle)> = self.fleet.vehicles.iter().collect();
        let Some(&(id, vehicle)) = vehicles.get(self.selected % vehicles.len().max(1)) else {
            return vec![self.link(), Line::raw("waiting for an AutoQuad")];
        };
        let shown = vehicle.shown(self.now_us, &self.limits);
        let columns = Columns::fitting(width);
        let notes = self.notes(&shown);
        let of = if vehicles.len() > 1 { format!(" of {}", vehicles.len()) } else { String::new() };
        let summary = Line::raw(format!("vehicle {id}{of}  {}", vehicle.summary(self.now_us)));
        let mut table = self.table(&columns, vehicle, &shown);
        // The controllers come first, then the notes, the head, and air.
        let room = height.saturating_sub(table.len() + 2);
        let notes_height = notes.len().min(room);
        let airy = room > notes_height + 1;
        let mut lines = Vec::new();
        match height.saturating_sub(table.len()) {
            0 => table = self.cut(table, shown.len(), height),
            1 => lines.push(self.link()),
            _ => lines.extend([self.link(), summary]),
        }
        lines.extend(airy.then(|| Line::raw("")));
        lines.append(&mut table);
        lines.extend(airy.then(|| Line::raw("")));
        lines.extend(notes.into_iter().take(notes_height));
        lines
    }

    /// As much of the table as there is room for.
    fn cut(&self, mut table: Vec<Line<'static>>, controllers: usize, height: usize) -> Vec<Line<'static>> {
        if table.len() > height {
            // A line is the head, and one says how many there are more.
            let hidden = (controllers + 2).saturating_sub(height);
            table.truncate(height.saturating_sub(1));
            table.push(Line::styled(format!("{hidden} more"), self.paint.faint()));
        }
        table
    }

    fn table(&self, columns: &Columns, vehicle: &Vehicle, shown: &[Shown]) -> Vec<Line<'static>> {
        if shown.is_empty() {
            return vec![Line::raw("no motor telemetry yet")];
        }
        let points = vehicle.trends.values().flatten().filter_map(|values| self.trend.of(values));
        let ends = points.fold((f32::MAX, f32::MIN), |(low, high), value| (low.min(value), high.max(value)));
        let trend = Trend { quantity: self.trend, low: ends.0, high: ends.1 };
        let mut lines = vec![columns.head(self.trend, self.paint)];
        let scene = Scene { vehicle, limits: &self.limits, trend, paint: self.paint };
        lines.extend(shown.iter().map(|shown| columns.row(shown, &scene)));
        lines.push(columns.totals(&vehicle.totals(shown), self.paint));
        lines
    }

    /// What is wrong, then what the vehicles say.
    fn notes(&self, shown: &[Shown]) -> Vec<Line<'static>> {
        let troubles = shown.iter().filter_map(|shown| Some((shown.port, shown.trouble.as_ref()?)));
        let troubles =
            troubles.map(|(port, what)| Line::styled(format!("ESC {port}: {what}"), self.paint.level(Level::Fault)));
        let texts = self.fleet.texts.iter().map(|text| Line::styled(format!("vehicle {text}"), self.paint.faint()));
        troubles.take(MAX_NOTES).chain(texts.take(MAX_NOTES)).collect()
    }

    /// Where it comes from, and how well.
    fn link(&self) -> Line<'static> {
        let (name, trouble) = match &self.origin {
            Origin::Link { address, trouble } => (*address, trouble.clone()),
            Origin::Log { name, .. } => (*name, None),
        };
        let mut spans = vec![Span::styled(name.to_owned(), self.paint.heading()), Span::raw("  ")];
        let quiet_us = self.fleet.heard_us.map(|then| self.now_us.saturating_sub(then));
        match (trouble, quiet_us) {
            (Some(trouble), _) => spans.push(Span::styled(trouble, self.paint.level(Level::Fault))),
            (None, None) => spans.push(Span::raw("no data yet")),
            (None, Some(quiet_us)) if quiet_us > QUIET_US => {
                let text = format!("no data for {}", age_text(quiet_us / 1000));
                spans.push(Span::styled(text, self.paint.level(Level::Fault)));
            }
            (None, Some(_)) => {
                let (messages, bytes) = self.fleet.rate(self.now_us);
                let lost = self.fleet.lost_percent();
                spans.push(Span::raw(format!("{messages:.0} msg/s  {:.1} kB/s  {lost:.1} % lost", bytes / 1000.0)));
            }
        }
        Line::from(spans)
    }

    /// Where the playback is, and the keys.
    fn foot(&self, width: usize) -> Vec<Line<'static>> {
        let keys = match &self.origin {
            Origin::Link { .. } => "q quit  t trend  tab vehicle",
            Origin::Log { .. } => "q quit  space pause  \u{2190} \u{2192} seek  - + speed  t trend  tab vehicle",
        };
        let keys = Line::styled(keys, self.paint.faint());
        match self.origin {
            Origin::Link { .. } => vec![keys],
            Origin::Log { progress, speed, paused, .. } => vec![bar(progress, speed, paused, width), keys],
        }
    }
}

/// `▶ 1x  00:12 ━━━━━─────── 02:00`
fn bar((at_us, whole_us): (u64, u64), speed: f64, paused: bool, width: usize) -> Line<'static> {
    let sign = match (paused, at_us >= whole_us) {
        (_, true) => "end",
        (true, false) => "paused",
        (false, false) => "play",
    };
    let (front, back) = (format!("{sign} {speed}x  {} ", time::clock(at_us)), format!(" {}", time::clock(whole_us)));
    let room = width.saturating_sub(front.chars().count() + back.chars().count());
    let done = (room as u64 * at_us.min(whole_us) / whole_us.max(1)) as usize;
    Line::raw(format!("{front}{}{}{back}", "━".repeat(done), "─".repeat(room - done)))
}

#[cfg(test)]
mod tests {
    use ratatui::Terminal;
    use ratatui::backend::TestBackend;

    use super::*;
    use crate::recording::Recording;
    use crate::simulate::flight;
    use crate::telemetry::Firmware;

    const START_US: u64 = 1_462_017_600_000_000;

    /// What is heard of a flight of a minute up to a second of it.
    fn heard(motors: u8, second: u64) -> Fleet {
        let folder = tempfile::tempdir().unwrap();
        let log = folder.path().join("flight.tlog");
        flight(&log, motors, 60, START_US);
        let (mut fleet, mut recording) = (Fleet::new(Firmware::default()), Recording::open(&log).unwrap());
        while let Some(entry) = recording.read().unwrap() {
            let time_us = entry.time_us.unwrap();
            if time_us <= START_US + second * 1_000_000 {
                fleet.receive(time_us, &entry.frame);
            }
        }
        fleet
    }

    fn screen(fleet: &Fleet, second: u64, (width, height): (u16, u16)) -> String {
        let view = View {
            fleet,
            origin: Origin::Log {
                name: "flight.tlog",
                progress: (second * 1_000_000, 60_000_000),
                speed: 1.0,
                paused: true,
            },
            now_us: START_US + second * 1_000_000,
            selected: 0,
            trend: Quantity::Speed,
            limits: Limits::default(),
            paint: Paint::plain(),
        };
        let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
        terminal.draw(|frame| draw(frame, &view)).unwrap();
        let cells = terminal.backend().buffer().content().chunks(width.into());
        cells.map(|row| row.iter().map(|cell| cell.symbol()).collect::<String>().trim_end().to_owned() + "\n").collect()
    }

    #[test]
    fn a_screen_has_all_motors_totals_and_what_is_wrong() {
        let screen = screen(&heard(8, 46), 46, (100, 24));
        for port in 1..=8 {
            assert!(screen.contains(&format!("\n  {port} ")), "{screen}");
        }
        for text in [
            "flight.tlog",
            "msg/s",
            "0.0 % lost",
            "armed  MISSION",
            "/8 on",
            "SILENT",
            "disarmed, ",
            "silent for 4.0 s",
            "00:46",
        ] {
            assert!(screen.contains(text), "{text}: {screen}");
        }
    }

    #[test]
    fn a_small_screen_keeps_the_motors() {
        let fleet = heard(16, 20);
        for (width, height) in [(20, 4), (20, 24), (40, 10), (300, 80)] {
            let screen = screen(&fleet, 20, (width, height));
            assert!(screen.contains("ESC ") && screen.contains("  1 "), "{width}x{height}: {screen}");
        }
        assert!(screen(&fleet, 20, (20, 7)).contains("12 more"), "{}", screen(&fleet, 20, (20, 7)));
        assert!(screen(&fleet, 20, (10, 3)).contains("too small"));
    }

    #[test]
    fn silence_is_said() {
        let fleet = heard(4, 20);
        assert!(screen(&fleet, 25, (80, 24)).contains("no data for 5.0 s"));
        let nothing = Fleet::new(Firmware::default());
        let screen = screen(&nothing, 0, (80, 24));
        assert!(screen.contains("no data yet") && screen.contains("waiting for an AutoQuad"), "{screen}");
    }
}

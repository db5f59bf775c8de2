//! Colours, or what stands for them where there are none.

use ratatui::style::{Color, Modifier, Style};

use super::limits::Level;

/// How things are emphasised.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paint {
    colours: bool,
}

impl Paint {
    /// As the user wants it: without colours if `NO_COLOR` is set.
    pub(super) fn of_environment() -> Self {
        Self { colours: std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty()) }
    }

    /// Without colours.
    #[cfg(test)]
    pub(super) const fn plain() -> Self {
        Self { colours: false }
    }

    pub(super) fn level(self, level: Level) -> Style {
        match level {
            Level::Good => Style::default(),
            Level::Warning => self.colour(Color::Yellow),
            Level::Fault => self.colour(Color::Red).add_modifier(Modifier::BOLD),
        }
    }

    pub(super) fn state(self, state: &str) -> Style {
        match state {
            "RUNNING" => self.colour(Color::Green),
            "STARTING" => self.colour(Color::Cyan),
            _ => Style::default(),
        }
    }

    pub(super) fn heading(self) -> Style {
        Style::default().add_modifier(Modifier::BOLD)
    }

    pub(super) fn faint(self) -> Style {
        self.colour(Color::DarkGray)
    }

    pub(super) fn trend(self) -> Style {
        self.colour(Color::Blue)
    }

    fn colour(self, colour: Color) -> Style {
        if self.colours { Style::default().fg(colour) } else { Style::default() }
    }
}

//! A bar on standard error while something long is read.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// Bytes from which on a bar is shown.
const LONG: u64 = 8 << 20;

/// A bar; hidden for short work, and where nobody sees it.
pub(crate) fn bar(bytes: u64) -> ProgressBar {
    if bytes < LONG {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{wide_bar} {bytes} of {total_bytes}, {eta} to go");
    let bar = ProgressBar::new(bytes).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

//! Ctrl-C, and what else asks the program to end, as something that loops can look at.

use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::failure::Failure;

static CAUGHT: AtomicBool = AtomicBool::new(false);
static CATCHING: Once = Once::new();

/// Catches Ctrl-C, a hang-up and a polite end from now on. A second Ctrl-C ends the program at once.
pub(crate) fn catch() -> Result<(), Failure> {
    let mut result = Ok(());
    CATCHING.call_once(|| {
        result = ctrlc::set_handler(|| {
            if CAUGHT.swap(true, Ordering::Relaxed) {
                std::process::exit(130);
            }
        });
    });
    result.map_err(|error| Failure::with("Ctrl-C", error))
}

/// Whether the program was asked to end.
pub(crate) fn was_caught() -> bool {
    CAUGHT.load(Ordering::Relaxed)
}

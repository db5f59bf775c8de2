//! Ctrl-C, and what else asks the program to end, as something that loops can look at.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, Once};
use std::thread;
use std::time::Duration;

use crate::failure::Failure;

static CAUGHT: AtomicBool = AtomicBool::new(false);
static ON_SCREEN: AtomicBool = AtomicBool::new(false);
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);
static CATCHING: Once = Once::new();

/// Longer than from one picture to the next.
const GRACE: Duration = Duration::from_secs(1);

/// Catches Ctrl-C, a hang-up and a polite end from now on. A second Ctrl-C ends the program at once.
pub(crate) fn catch() -> Result<(), Failure> {
    let mut result = Ok(());
    CATCHING.call_once(|| {
        result = ctrlc::set_handler(|| {
            if let Ok(Some(path)) = UNFINISHED.lock().map(|mut path| path.take()) {
                // If it cannot be removed, there is nobody to tell.
                let _ = fs::remove_file(path);
                std::process::exit(130);
            }
            if CAUGHT.swap(true, Ordering::Relaxed) {
                std::process::exit(130);
            }
            if ON_SCREEN.load(Ordering::Relaxed) {
                thread::sleep(GRACE);
                std::process::exit(129);
            }
        });
    });
    result.map_err(|error| Failure::with("Ctrl-C", error))
}

/// The same where the screen is read. crossterm 0.29 reads for ever from a terminal that is gone, and gives nothing back: what has
/// not ended soon is ended.
pub(crate) fn catch_on_screen() -> Result<(), Failure> {
    ON_SCREEN.store(true, Ordering::Relaxed);
    catch()
}

/// Removes a file that is not whole where the program is asked to end, and ends it.
pub(crate) fn catch_removing(path: &Path) -> Result<(), Failure> {
    if let Ok(mut unfinished) = UNFINISHED.lock() {
        *unfinished = Some(path.to_owned());
    }
    catch()
}

/// Whether the program was asked to end.
pub(crate) fn was_caught() -> bool {
    CAUGHT.load(Ordering::Relaxed)
}

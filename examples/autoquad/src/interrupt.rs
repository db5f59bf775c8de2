//! Ctrl-C, and what else asks the program to end, as something that loops can look at.

use std::fs;
#[cfg(unix)]
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, Once, PoisonError};
use std::thread;
use std::time::Duration;

use crate::failure::Failure;

static CAUGHT: AtomicBool = AtomicBool::new(false);
static ON_SCREEN: AtomicBool = AtomicBool::new(false);
static UNFINISHED: Mutex<Option<PathBuf>> = Mutex::new(None);
static CATCHING: Once = Once::new();

/// Longer than from one picture to the next.
const GRACE: Duration = Duration::from_secs(1);

/// Catches Ctrl-C, a hang-up and a polite end from now on. A second one ends the program at once.
pub(crate) fn catch() -> Result<(), Failure> {
    let mut result = Ok(());
    CATCHING.call_once(|| result = on_signal(caught));
    result.map_err(|error| Failure::with("Ctrl-C", error))
}

/// What happens at a signal, beside the work.
fn caught(signal: i32) {
    let end = || std::process::exit(128 + signal);
    if let Ok(Some(path)) = UNFINISHED.lock().map(|mut path| path.take()) {
        // If it cannot be removed, there is nobody to tell.
        let _ = fs::remove_file(path);
        end();
    }
    if CAUGHT.swap(true, Ordering::Relaxed) {
        end();
    }
    if ON_SCREEN.load(Ordering::Relaxed) {
        thread::sleep(GRACE);
        end();
    }
}

/// Calls this in a thread of its own. Who started the program with `nohup` wants it to go on after a hang-up.
#[cfg(unix)]
fn on_signal(caught: fn(i32)) -> io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    let mut signals = Signals::new([SIGINT, SIGTERM])?;
    if !ignored().contains(&SIGHUP) {
        signals.add_signal(SIGHUP)?;
    }
    thread::spawn(move || signals.forever().for_each(caught));
    Ok(())
}

/// The signals that the program was told to ignore when it was started, where the system says it.
#[cfg(unix)]
fn ignored() -> Vec<i32> {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| u64::from_str_radix(line.strip_prefix("SigIgn:")?.trim(), 16).ok());
    (1..=64).filter(|signal| mask.unwrap_or_default() >> (signal - 1) & 1 == 1).collect()
}

#[cfg(not(unix))]
fn on_signal(caught: fn(i32)) -> Result<(), ctrlc::Error> {
    /// What Ctrl-C is on Unix.
    const SIGINT: i32 = 2;
    ctrlc::set_handler(move || caught(SIGINT))
}

/// The same where the screen is read. crossterm 0.29 reads for ever from a terminal that is gone, and gives nothing back: what has
/// not ended soon is ended.
pub(crate) fn catch_on_screen() -> Result<(), Failure> {
    ON_SCREEN.store(true, Ordering::Relaxed);
    catch()
}

/// Makes a file that is not whole yet. Where the program is asked to end, it is removed, and the program ends.
pub(crate) fn catch_removing<T>(
    make: impl FnOnce() -> Result<T, Failure>,
    path: impl FnOnce(&T) -> &Path,
) -> Result<T, Failure> {
    // A signal waits until the name of the file is known.
    let mut unfinished = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
    catch()?;
    let made = make()?;
    *unfinished = Some(path(&made).to_owned());
    Ok(made)
}

/// Whether the program was asked to end.
pub(crate) fn was_caught() -> bool {
    CAUGHT.load(Ordering::Relaxed)
}

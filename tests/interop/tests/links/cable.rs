//! Two pseudo terminals, joined as by a cable.

use std::io::{ErrorKind, Read, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::Duration;

use serialport::{SerialPort, TTYPort};

/// Carries bytes until it is dropped, whether somebody is at its ends or not.
pub(super) struct Cable {
    ends: [String; 2],
    done: Arc<AtomicBool>,
    carriers: Vec<JoinHandle<()>>,
}

impl Cable {
    pub(super) fn new() -> Self {
        let pairs = [(); 2].map(|()| TTYPort::pair().unwrap());
        let ends = pairs.each_ref().map(|(_, end)| end.name().unwrap());
        let [one, other] = pairs.map(|(inner, _)| inner);
        let twins = [one.try_clone_native().unwrap(), other.try_clone_native().unwrap()];
        let done = Arc::new(AtomicBool::new(false));
        let [to_one, to_other] = twins;
        let carriers = [(one, to_other), (other, to_one)].map(|(from, to)| {
            let done = done.clone();
            thread::spawn(move || carry(from, to, &done))
        });
        Self { ends, done, carriers: carriers.into() }
    }

    pub(super) fn ends(&self) -> [String; 2] {
        self.ends.clone()
    }
}

fn carry(mut from: TTYPort, mut to: TTYPort, done: &AtomicBool) {
    from.set_timeout(Duration::from_millis(20)).unwrap();
    let mut buffer = [0; 4096];
    while !done.load(Ordering::Relaxed) {
        match from.read(&mut buffer) {
            // What nobody is there to take is lost.
            Ok(count) => drop(to.write_all(&buffer[..count])),
            Err(error) if error.kind() == ErrorKind::TimedOut => {}
            Err(_) => thread::sleep(Duration::from_millis(20)),
        }
    }
}

impl Drop for Cable {
    fn drop(&mut self) {
        self.done.store(true, Ordering::Relaxed);
        for carrier in self.carriers.drain(..) {
            carrier.join().unwrap();
        }
    }
}

//! Contenders take turns, so that whatever else the machine does hits all of them.

use std::time::Instant;

use rustix::time::{ClockId, clock_gettime};

/// Rounds that count, if the command line does not say another number.
const ROUNDS: usize = 30;

/// One of the programs that are compared: a name, and the work, which says how many frames it found or made.
pub struct Contender<'a> {
    name: &'static str,
    work: Box<dyn FnMut() -> usize + 'a>,
}

impl<'a> Contender<'a> {
    /// A contender.
    pub fn new(name: &'static str, work: impl FnMut() -> usize + 'a) -> Self {
        Self { name, work: Box::new(work) }
    }
}

/// Lets the contenders take turns and prints a line for each: units of work, the shortest time for one, and the ratio to
/// the last contender, which is the peer: the median of the ratios within each round, with p10 to p90, the ratio of
/// the shortest times, and the ratio of the processor time that all rounds took, in all threads. The first round is not counted.
pub fn compare(title: &str, mut contenders: Vec<Contender<'_>>) {
    let mut nanoseconds: Vec<Vec<f64>> = vec![Vec::new(); contenders.len()];
    let mut processor = vec![0.0; contenders.len()];
    let mut found = vec![0; contenders.len()];
    let rounds = std::env::args().nth(1).and_then(|rounds| rounds.parse().ok()).unwrap_or(ROUNDS);
    for round in 0..=rounds {
        let results = nanoseconds.iter_mut().zip(&mut processor).zip(&mut found);
        for (contender, ((times, processor), found)) in contenders.iter_mut().zip(results) {
            let (start, used) = (Instant::now(), processor_time());
            *found = (contender.work)();
            let (elapsed, used) = (start.elapsed().as_nanos() as f64, processor_time() - used);
            if round > 0 {
                times.push(elapsed / (*found).max(1) as f64);
                *processor += used;
            }
        }
    }
    let peer = nanoseconds.last().cloned().unwrap_or_default();
    let peers = processor.last().copied().unwrap_or(f64::NAN);
    for (((contender, times), found), used) in contenders.iter().zip(&nanoseconds).zip(&found).zip(&processor) {
        let ratios: Vec<f64> = times.iter().zip(&peer).map(|(ours, theirs)| ours / theirs).collect();
        let [low, middle, high] = spread(ratios);
        let (time, best) = (best(times), best(times) / best(&peer));
        println!(
            "{title:<20} {:<24} {found:>6} {time:>12.1} ns  ratio {middle:.3} ({low:.3} to {high:.3}), best {best:.3}, \
             processor {:.3}",
            contender.name,
            used / peers
        );
    }
}

/// What all threads of this process have used of the processors, in nanoseconds.
fn processor_time() -> f64 {
    let used = clock_gettime(ClockId::ProcessCPUTime);
    used.tv_sec as f64 * 1e9 + used.tv_nsec as f64
}

/// The shortest time: that of the round in which the machine did the least besides.
fn best(times: &[f64]) -> f64 {
    times.iter().copied().fold(f64::INFINITY, f64::min)
}

/// p10, median and p90.
fn spread(mut values: Vec<f64>) -> [f64; 3] {
    values.sort_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    [last / 10, last / 2, last - last / 10].map(|at| values.get(at).copied().unwrap_or(f64::NAN))
}

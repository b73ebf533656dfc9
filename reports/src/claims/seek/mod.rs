//! The search for the worst input of a claim: hill climbing with restarts on all processors (memo H, last paragraph).
//!
//! A climb starts at a drawn input or at a kept one, changes it by units in the last place and by structure
//! ([`change`]), and takes what is no better. It ends when nothing has become worse for a while. What is worst in the end is
//! made as small as it can be without losing a tenth ([`shrink`]).

mod change;
mod shrink;

use super::finding::{Measured, Worst};
use super::input::Input;
use super::kept;
use super::sup::Sup;
use crate::cases::rng::Rng;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Changes in a row that make nothing worse, after which a climb ends: for numbers, and for pairs of regions.
const PATIENCE: [usize; 2] = [300, 60];

/// Inputs that are kept of a claim.
const KEPT: usize = 4;

/// How long to search, and how.
#[derive(Clone, Copy, Debug)]
pub struct Search {
    /// The seed of all random numbers.
    pub seed: u64,
    /// The time after which climbs end.
    pub time: Duration,
    /// Climbs at a time.
    pub threads: usize,
}

/// What a search did and found.
#[derive(Clone, Debug, Default)]
pub struct Sought {
    /// Inputs that were measured.
    pub measured: u64,
    /// Climbs that were begun.
    pub climbs: u64,
    /// Inputs that crashed the engine or the reference; they are no values, but worth a look.
    pub crashed: Vec<Input>,
    /// The worst inputs, worst first.
    pub worst: Vec<Worst>,
}

/// A search that runs.
struct Hunt<'a> {
    id: &'a str,
    sup: &'a Sup,
    search: Search,
    stop: &'a AtomicBool,
    start: Instant,
    measured: AtomicU64,
    climbs: AtomicU64,
    crashed: Mutex<Vec<Input>>,
    worst: Mutex<Vec<Worst>>,
}

/// Searches for the worst inputs of a claim; hands every new worst one to `each` at once.
pub fn seek(id: &str, sup: &Sup, search: Search, stop: &AtomicBool, each: impl Fn(&Worst) + Sync) -> Sought {
    let hunt = Hunt {
        id,
        sup,
        search,
        stop,
        start: Instant::now(),
        measured: AtomicU64::new(0),
        climbs: AtomicU64::new(0),
        crashed: Mutex::default(),
        worst: Mutex::default(),
    };
    for known in kept::read(sup.kept) {
        if let Some(measured) = hunt.measure(&known.input) {
            hunt.offer(Worst::new(known.input, &measured), &each);
        }
    }
    std::thread::scope(|scope| {
        for _ in 0..search.threads.max(1) {
            scope.spawn(|| hunt.work(&each));
        }
    });
    hunt.finish()
}

/// Whether one value is worse than another.
fn is_worse(one: (f64, f64), other: (f64, f64)) -> bool {
    one.0 > other.0 || (one.0 == other.0 && one.1 > other.1)
}

impl Hunt<'_> {
    fn is_over(&self) -> bool {
        self.stop.load(Ordering::Relaxed) || self.start.elapsed() >= self.search.time
    }

    /// Climbs until time is up. Every climb has its own random numbers, whichever thread it runs on.
    fn work(&self, each: &(impl Fn(&Worst) + Sync)) {
        while !self.is_over() {
            let climb = self.climbs.fetch_add(1, Ordering::Relaxed);
            let mut rng = Rng::new(self.search.seed, &format!("attack {} {climb}", self.id));
            let known = self.known(&mut rng);
            let start = known.unwrap_or_else(|| (self.sup.draw)(&mut rng, climb as usize));
            if let Some(worst) = self.climb(start, &mut rng) {
                self.offer(worst, each);
            }
        }
    }

    /// One of the worst inputs so far, for every third climb.
    fn known(&self, rng: &mut Rng) -> Option<Input> {
        let worst = self.worst.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        (rng.below(3) == 0 && !worst.is_empty()).then(|| rng.pick(&worst).input.clone())
    }

    fn climb(&self, start: Input, rng: &mut Rng) -> Option<Worst> {
        let patience = PATIENCE[usize::from(start.as_pair().is_some())];
        let measured = self.measure(&start)?;
        let mut best = Worst::new(start, &measured);
        let mut idle = 0;
        while idle < patience && !self.is_over() {
            idle += 1;
            let input = change::changed(&best.input, rng);
            let Some(measured) = input.as_ref().and_then(|input| self.measure(input)) else { continue };
            if is_worse((measured.lo, measured.hi), (best.lo, best.hi)) {
                idle = 0;
            }
            // What is as bad is taken as well, so that a climb can cross a plain.
            if !is_worse((best.lo, best.hi), (measured.lo, measured.hi)) {
                best = Worst::new(input?, &measured);
            }
        }
        Some(best)
    }

    /// The quantity; a panic is remembered.
    fn measure(&self, input: &Input) -> Option<Measured> {
        self.measured.fetch_add(1, Ordering::Relaxed);
        catch_unwind(AssertUnwindSafe(|| (self.sup.measure)(input))).unwrap_or_else(|_| {
            let mut crashed = self.crashed.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            crashed.push(input.clone());
            None
        })
    }

    /// Keeps an input if it is among the worst.
    fn offer(&self, found: Worst, each: &(impl Fn(&Worst) + Sync)) {
        let mut worst = self.worst.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        let place = worst.partition_point(|known| !is_worse((found.lo, found.hi), (known.lo, known.hi)));
        // Of inputs that come to the same one is enough.
        if place < KEPT && worst.iter().all(|known| (known.lo, known.hi) != (found.lo, found.hi)) {
            worst.insert(place, found);
            worst.truncate(KEPT);
            if place == 0 {
                each(&worst[0]);
            }
        }
    }

    /// The worst inputs, made smaller.
    fn finish(self) -> Sought {
        let worst = self.worst.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
        let mut worst: Vec<Worst> = worst.into_iter().map(|found| shrink::shrunk(found, self.sup)).collect();
        worst.sort_by(|p, q| q.lo.total_cmp(&p.lo).then(q.hi.total_cmp(&p.hi)));
        Sought {
            measured: self.measured.into_inner(),
            climbs: self.climbs.into_inner(),
            crashed: self.crashed.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner),
            worst,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::control::Control;
    use super::super::sup::Rule;
    use super::*;

    /// A hill whose top is at (3, -2).
    fn hill(input: &Input) -> Option<Measured> {
        let [x, y]: [f64; 2] = input.as_numbers("p")?.try_into().ok()?;
        Some(Measured::exactly(-(x - 3.0).powi(2) - (y + 2.0).powi(2)))
    }

    fn search(measure: fn(&Input) -> Option<Measured>) -> Sought {
        let draw = |rng: &mut Rng, _: usize| Input::numbers("p", [rng.between(0.1, 9.0), -rng.between(0.1, 9.0)]);
        let control = Control::Itself;
        let sup =
            Sup { quantity: "q", unit: "1", rule: Rule::AtMost(0.0), draws: [1, 1], draw, measure, kept: "", control };
        let search = Search { seed: 1, time: Duration::from_millis(300), threads: 2 };
        seek("X", &sup, search, &AtomicBool::new(false), |_| ())
    }

    #[test]
    fn the_top_is_found() {
        let found = search(hill);
        assert!(found.worst[0].lo > -1e-2 && found.climbs > 1, "{found:?}");
        assert!(found.worst.windows(2).all(|w| w[0].lo >= w[1].lo));
    }

    #[test]
    fn a_crash_is_kept_and_ends_nothing() {
        std::panic::set_hook(Box::new(|_| ()));
        let found = search(|input| if input.as_numbers("p")?[0] > 5.0 { panic!("far") } else { hill(input) });
        let _ = std::panic::take_hook();
        assert!(!found.crashed.is_empty() && !found.worst.is_empty());
    }
}

//! The search for worst inputs: draw, climb, compare with a bound, and keep the worst found as a file.
//!
//! `worst/NAME.csv` holds the worst inputs known, one a line: the error in eps = 2^-53, then the input. Every run
//! measures them again; one that has become worse fails. With `ARCSUM_KEEP_WORST` set, a run rewrites the files with
//! what it found.

use arcsum_reports::cases::rng::Rng;
use arcsum_reports::claims::formulas::formula::Formula;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

/// How many lines a file keeps.
const KEPT: usize = 4;

/// The search about a formula.
pub struct Search(pub Formula);

/// An input and its error in eps.
#[derive(Clone, Debug)]
pub struct Worst {
    /// The error.
    pub error: f64,
    /// The input.
    pub input: Vec<f64>,
}

impl Search {
    /// Measures the kept inputs, then searches with `draws` random inputs and climbs from the worst. Prints a row of
    /// the accuracy table.
    ///
    /// # Panics
    /// If an error exceeds the bound or a kept input has become worse.
    pub fn check(&self, draws: usize) {
        let kept = self.kept();
        let known = kept.first().map_or(0.0, |w| w.error);
        let kept = self.again(kept);
        let found = self.search(draws, &kept);
        println!(
            "{:28} worst {:12.4} eps, known {:10.4}, bound {:8.3}",
            self.0.name, found[0].error, known, self.0.bound
        );
        assert!(found[0].error <= self.0.bound, "{}: {:?} exceeds {} eps", self.0.name, found[0], self.0.bound);
        if std::env::var_os("ARCSUM_KEEP_WORST").is_some() {
            self.keep(&found);
        }
    }

    /// Measures kept inputs again.
    ///
    /// # Panics
    /// If one has become worse.
    #[must_use]
    pub fn again(&self, mut kept: Vec<Worst>) -> Vec<Worst> {
        for old in &mut kept {
            let now = (self.0.error)(&old.input).unwrap_or(f64::INFINITY);
            assert!(now <= old.error * (1.0 + 1e-9), "{}: kept input {old:?} rose to {now} eps", self.0.name);
            old.error = now;
        }
        kept
    }

    /// The worst inputs of a search, worst first, without a verdict: for formulas that are known to fail.
    #[must_use]
    pub fn search(&self, draws: usize, start: &[Worst]) -> Vec<Worst> {
        let mut random = Rng::new(7, self.0.name);
        let mut worst: Vec<Worst> = start.to_vec();
        for _ in 0..draws {
            let input = (self.0.draw)(&mut random);
            self.offer(&mut worst, input);
        }
        for one in &mut worst {
            *one = self.climb(&mut random, one.clone(), draws / (2 * KEPT));
        }
        worst.sort_by(|x, y| y.error.total_cmp(&x.error));
        assert!(!worst.is_empty(), "{}: no input was measured", self.0.name);
        worst
    }

    fn offer(&self, worst: &mut Vec<Worst>, input: Vec<f64>) {
        let Some(error) = (self.0.error)(&input) else { return };
        let place = worst.partition_point(|w| w.error >= error);
        if place < KEPT {
            worst.insert(place, Worst { error, input });
            worst.truncate(KEPT);
        }
    }

    /// Changes single numbers by a few last places or a small factor as long as the error grows.
    fn climb(&self, random: &mut Rng, mut best: Worst, steps: usize) -> Worst {
        for _ in 0..steps {
            let mut input = best.input.clone();
            let i = random.below(input.len());
            input[i] = match random.below(3) {
                0 => random.jitter(input[i], 3),
                1 => random.jitter(input[i], 1000),
                _ => input[i] * (1.0 + random.between(-1.0, 1.0) * random.decade(-14.0, -1.0)),
            };
            if let Some(error) = (self.0.error)(&input).filter(|&e| e > best.error) {
                best = Worst { error, input };
            }
        }
        best
    }

    fn path(&self) -> PathBuf {
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("worst").join(format!("{}.csv", self.0.name))
    }

    fn kept(&self) -> Vec<Worst> {
        let Ok(text) = fs::read_to_string(self.path()) else { return Vec::new() };
        let number = |s: &str| s.trim().parse::<f64>().unwrap_or_else(|e| panic!("{}: {s}: {e}", self.0.name));
        let line = |l: &str| {
            let numbers: Vec<f64> = l.split(',').map(number).collect();
            Worst { error: numbers[0], input: numbers[1..].to_vec() }
        };
        text.lines().filter(|l| !l.starts_with('#')).map(line).collect()
    }

    fn keep(&self, found: &[Worst]) {
        let mut text = format!("# {}: error in eps = 2^-53, then the input\n", self.0.name);
        for worst in found {
            let _ = write!(text, "{:e}", worst.error);
            for x in &worst.input {
                let _ = write!(text, ",{x:e}");
            }
            text.push('\n');
        }
        fs::create_dir_all(self.path().parent().expect("a file has a folder")).expect("worst/ can be made");
        fs::write(self.path(), text).expect("worst/ can be written");
    }
}

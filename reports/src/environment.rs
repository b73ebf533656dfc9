//! `environment.json`: what a run was made with and on. Beside every `results.csv`; times mean nothing without it.

use crate::run::plan::Plan;
use serde::Serialize;
use std::collections::BTreeMap;

/// Where and with what a run was made. Unknown facts are empty.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Environment {
    /// Version of this program.
    pub version: String,
    /// Commit it was built from.
    pub commit: String,
    /// Compiler.
    pub rustc: String,
    /// Target triple.
    pub target: String,
    /// `debug` or `release`.
    pub profile: String,
    /// Compiler flags.
    pub rustflags: String,
    /// Operating system, by name and kernel.
    pub os: String,
    /// Processor.
    pub cpu: String,
    /// Processors the program may use.
    pub processors: usize,
    /// Workers at a time.
    pub threads: usize,
    /// Seed of the built-in cases.
    pub seed: u64,
    /// Seconds for an engine, and for the reference, on a case.
    pub time_limit_s: f64,
    /// Engines and their versions.
    pub engines: BTreeMap<String, String>,
    /// Rows of the run, and a hash over cases and engines.
    pub run: String,
    /// The command line.
    pub command: Vec<String>,
}

impl Environment {
    /// The environment of a run of this plan, here and now.
    #[must_use]
    pub fn of(plan: &Plan, threads: usize, seed: u64, time_limit_s: f64) -> Self {
        Self {
            version: env!("CARGO_PKG_VERSION").into(),
            commit: env!("ARCSUM_COMMIT").into(),
            rustc: env!("ARCSUM_RUSTC").into(),
            target: env!("ARCSUM_TARGET").into(),
            profile: env!("ARCSUM_PROFILE").into(),
            rustflags: env!("ARCSUM_RUSTFLAGS").into(),
            os: operating_system(),
            cpu: processor(),
            processors: processors(),
            threads,
            seed,
            time_limit_s,
            engines: plan.engines.iter().map(|e| (e.name.clone(), e.version.clone())).collect(),
            run: plan.fingerprint(),
            command: std::env::args().skip(1).collect(),
        }
    }
}

/// The number of processors this program may use.
#[must_use]
pub fn processors() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

fn operating_system() -> String {
    let name = field("/etc/os-release", "PRETTY_NAME", '=').unwrap_or_else(|| std::env::consts::OS.into());
    let kernel = std::fs::read_to_string("/proc/sys/kernel/osrelease").unwrap_or_default();
    format!("{} {}", name.trim_matches('"'), kernel.trim()).trim().to_owned()
}

fn processor() -> String {
    field("/proc/cpuinfo", "model name", ':').unwrap_or_else(|| std::env::consts::ARCH.into())
}

/// The value of the first line `key separator value` of a file.
fn field(file: &str, key: &str, separator: char) -> Option<String> {
    let text = std::fs::read_to_string(file).ok()?;
    let mut lines = text.lines().filter_map(|line| line.split_once(separator));
    lines.find(|(k, _)| k.trim() == key).map(|(_, value)| value.trim().to_owned())
}

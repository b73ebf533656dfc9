//! A million mutated region files through the reader and the validator: each ends in an error or a region, and every kind
//! of error is reached.

use arcsum_fuzz::region_json;
use arcsum_reports::cases::rng::Rng;
use std::collections::BTreeMap;
use std::panic::catch_unwind;
use std::thread;

const FILES: usize = 1_000_000;

/// Tokens that mutations put in the place of numbers.
const NUMBERS: [&str; 20] = [
    "0",
    "-0",
    "1",
    "-1",
    "0.5",
    "2",
    "3.5",
    "1e999",
    "-1e999",
    "NaN",
    "1e308",
    "1e305",
    "-1e300",
    "1e-300",
    "5e-324",
    "null",
    "\"1\"",
    "0.1e",
    "123456789012345678901234567890",
    "1e-17",
];

/// Tokens that mutations insert anywhere.
const PIECES: [&str; 16] = [
    "{",
    "}",
    "[",
    "]",
    ",",
    ":",
    "\"x\": ",
    "\"y\": 1",
    "\"bulge\": 1, ",
    "\"radius\": 1, ",
    "\"loops\": [[]], ",
    "[], ",
    "\"unbounded\": true, ",
    "{\"x\": 0, \"y\": 0}, ",
    "\\u0000",
    "\u{feff}",
];

fn seeds() -> Vec<Vec<u8>> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../fuzz/corpus/region_json");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = files.filter(|path| path.extension().is_some_and(|e| e == "json")).collect();
    // Directories list in any order; the mutations must not depend on it.
    files.sort();
    files.iter().map(|path| std::fs::read(path).unwrap()).collect()
}

/// The ranges of the numbers of a text.
fn numbers(text: &[u8]) -> Vec<std::ops::Range<usize>> {
    let is_part = |b: u8| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+');
    let mut ranges = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let length = text[at..].iter().take_while(|&&b| is_part(b)).count();
        if length > 0 {
            ranges.push(at..at + length);
        }
        at += length + 1;
    }
    ranges
}

/// The ranges between two equal brackets: vertices, or whole loops.
fn items(text: &[u8], open: u8, close: u8) -> Vec<std::ops::Range<usize>> {
    let starts = (0..text.len()).filter(|&i| text[i] == open);
    starts.filter_map(|i| Some(i..i + text[i..].iter().position(|&b| b == close)? + 1)).collect()
}

/// Changes the text in one place.
fn mutate(text: &mut Vec<u8>, seeds: &[Vec<u8>], random: &mut Rng) {
    let at = random.below(text.len() + 1);
    match random.below(12) {
        0..=3 => replace(text, numbers, random.pick(&NUMBERS).as_bytes(), random),
        4 => {
            let other = numbers(text).get(random.below(8)).map(|range| text[range.clone()].to_vec());
            replace(text, numbers, &other.unwrap_or_default(), random);
        }
        5 => replace(text, |t| items(t, b'{', b'}'), b"", random),
        6 => {
            let vertices = items(text, b'{', b'}');
            let vertex = vertices.last().map(|range| text[range.clone()].to_vec()).unwrap_or_default();
            replace(text, |t| items(t, b'{', b'}'), &vertex, random);
        }
        7 => replace(text, |t| items(t, b'[', b']'), b"[]", random),
        8 => drop(text.splice(at..at, random.pick(&PIECES).bytes())),
        9 if at < text.len() => text[at] ^= 1 << random.below(8),
        10 => text.truncate(at),
        _ => {
            let other = random.pick(seeds);
            let from = random.below(other.len());
            text.truncate(at);
            text.extend_from_slice(&other[from..]);
        }
    }
}

/// Puts other bytes in the place of one of the ranges.
fn replace(text: &mut Vec<u8>, ranges: impl Fn(&[u8]) -> Vec<std::ops::Range<usize>>, by: &[u8], random: &mut Rng) {
    let ranges = ranges(text);
    if !ranges.is_empty() {
        let range = random.pick(&ranges).clone();
        text.splice(range, by.iter().copied());
    }
}

/// Runs every `stride`th file from `first` and counts the outcomes. Each file has its own seed, so that the files are the
/// same for any number of threads.
fn run(first: usize, stride: usize, seeds: &[Vec<u8>]) -> BTreeMap<&'static str, usize> {
    let mut counts = BTreeMap::new();
    for file in (first..FILES).step_by(stride) {
        let mut random = Rng::new(file as u64, "tests");
        let mut text = random.pick(seeds).clone();
        for _ in 0..1 + random.below(3) {
            mutate(&mut text, seeds, &mut random);
        }
        let outcome = catch_unwind(|| region_json(&text));
        let outcome = outcome.unwrap_or_else(|_| panic!("file {file}: {}", String::from_utf8_lossy(&text)));
        *counts.entry(outcome).or_default() += 1;
    }
    counts
}

#[test]
fn a_million_mutated_files_end_in_an_error_or_a_region() {
    let seeds = seeds();
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads)
            .map(|first| {
                scope.spawn({
                    let seeds = &seeds;
                    move || run(first, threads, seeds)
                })
            })
            .collect();
        for worker in workers {
            for (outcome, count) in worker.join().unwrap() {
                *counts.entry(outcome).or_default() += count;
            }
        }
    });
    println!("{counts:#?}");
    let expected = [
        "valid",
        "not text",
        "syntax",
        "content",
        "not finite",
        "open loop",
        "zero-length segment",
        "chord longer than the diameter",
        "self-intersection",
        "wrong orientation",
        "overlapping loops",
        "empty",
        "too large",
    ];
    for outcome in expected {
        assert!(counts.contains_key(outcome), "no mutation led to: {outcome}");
    }
    assert_eq!(counts.values().sum::<usize>(), FILES);
}

//! CGAL's exact answers against both references.

use crate::common::{Loops, child};
use crate::draw::pair;
use crate::verdict::{Verdict, verdict};
use arcsum_cgal::method::Method;
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, TestRunner};
use std::collections::BTreeMap;

fn drawn(count: usize) -> Vec<(Loops, Loops)> {
    let mut runner = TestRunner::new(Config::default());
    let strategy = pair();
    (0..count).map(|_| strategy.new_tree(&mut runner).expect("few rejects").current()).collect()
}

#[test]
#[ignore = "minutes"]
fn count() {
    let mut child = child();
    let mut tally: BTreeMap<String, usize> = BTreeMap::new();
    let count = std::env::var("CASES").ok().and_then(|c| c.parse().ok()).unwrap_or(300);
    let mut shown: BTreeMap<String, (usize, String)> = BTreeMap::new();
    for (a, b) in drawn(count) {
        let holes = a.len() > 1 || b.len() > 1;
        for method in Method::all().filter(|m| !holes || m.strategy().takes_holes()) {
            let v = verdict(&mut child, method, &a, &b);
            let key = format!("{method} {v}");
            *tally.entry(key.clone()).or_default() += 1;
            if v != Verdict::Agrees {
                let size = a.iter().chain(&b).map(Vec::len).sum();
                let text = format!("{a:?} {b:?}").replace("Point ", "");
                let slot = shown.entry(key).or_insert((usize::MAX, String::new()));
                if size < slot.0 {
                    *slot = (size, text)
                }
            }
        }
    }
    for (key, n) in tally {
        println!("{n:6} {key}");
    }
    for (key, (n, text)) in shown {
        println!("{key} {n} {text}");
    }
}

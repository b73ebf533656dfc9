//! CGAL's exact answers against both references on random polygons with holes: 500 cases, `PROPTEST_CASES=2560` for ten
//! times as many. Every
//! disagreement is proved to be CGAL's error, and fails but for the method that is known to err.

use crate::common::{Loops, child, exact_methods};
use crate::draw::pair;
use crate::verdict::{Verdict, compared, region, verdict};
use arcsum_cgal::error::CgalError;
use arcsum_cgal::method::{Method, Strategy};
use arcsum_cgal::question::Question;
use arcsum_cgal::sum::Sum;
use arcsum_oracle::region::ExactRegion;
use proptest::strategy::{Strategy as _, ValueTree};
use proptest::test_runner::{Config, TestRunner};
use rug::Rational;
use std::collections::BTreeMap;

/// What became of the cases of a method.
#[derive(Debug, Default)]
struct Tally {
    agrees: usize,
    /// Of these, sums with holes.
    holes: usize,
    refused: usize,
    none: BTreeMap<String, usize>,
    wrong: usize,
}

/// The cases, 500 a 256 that are asked for.
fn drawn() -> impl Iterator<Item = (Loops, Loops)> {
    let config = Config::default();
    let count = 500 * config.cases.div_ceil(256);
    let mut runner = TestRunner::new(config);
    let strategy = pair();
    (0..count).map(move |_| strategy.new_tree(&mut runner).expect("few rejects").current())
}

/// The full convolution of CGAL 5.5.1 dies now and then where directions coincide, and so does its optimal partition.
fn may_die(method: Method) -> bool {
    [Strategy::Full, Strategy::Optimal].contains(&method.strategy())
}

/// CGAL's optimal partition goes wrong where vertices of different edges are collinear (CGAL issue 2575 is open).
fn may_be_wrong(method: Method) -> bool {
    method.strategy() == Strategy::Optimal
}

#[test]
fn exact_answers_agree_with_both_references() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let mut child = child();
    let mut tallies: BTreeMap<String, Tally> = BTreeMap::new();
    for (a, b) in drawn() {
        let holes = a.len() > 1 || b.len() > 1;
        for method in exact_methods(holes) {
            let tally = tallies.entry(method.to_string()).or_default();
            match verdict(&mut child, method, &a, &b) {
                Verdict::Agrees { holes } => {
                    tally.agrees += 1;
                    tally.holes += usize::from(holes > 0);
                }
                // A hole that touches the inside of an edge.
                Verdict::None(CgalError::Refused(_)) if holes => tally.refused += 1,
                Verdict::None(error) if may_die(method) => {
                    *tally.none.entry(error.to_string()).or_default() += 1;
                }
                Verdict::Wrong { .. } if may_be_wrong(method) => tally.wrong += 1,
                Verdict::Wrong { .. } => panic!("{method} is wrong on {a:?} + {b:?}"),
                Verdict::None(error) => panic!("{method}: {error} on {a:?} + {b:?}"),
            }
        }
    }
    for (method, tally) in &tallies {
        let Tally { agrees, holes, refused, none, wrong } = tally;
        println!("{method}: {agrees} agree, {holes} with holes; {refused} refused; {none:?}; {wrong} wrong");
        let asked = agrees + wrong + none.values().sum::<usize>();
        assert!(10 * agrees > 8 * asked && 40 * holes > *agrees, "{method}: {tally:?}");
    }
}

/// The comparison sees a hole that was lost, one that was invented, and says who is right.
#[test]
fn planted_errors_are_found() {
    let rings = |text: &str| -> Loops { Sum::read(&format!("ok 0;{text}")).expect("loops").loops };
    let frame = rings("0 0 9 0 9 9 0 9;3 3 3 7 7 7 7 3;");
    let part = rings("0 0 1 0 0 1;");
    let [a, b] = [&frame, &part].map(region);
    let truth: ExactRegion<Rational> = crate::common::references(&a, &b);
    assert_eq!(compared(&truth, &a, &b), Verdict::Agrees { holes: 1 });
    let mut loops = truth.loops().to_vec();
    loops.retain(|ring| ring.len() != 5);
    let planted = |extra: &str| region(&loops.iter().cloned().chain(rings(extra)).collect());
    assert_eq!(compared(&planted(""), &a, &b), Verdict::Wrong { belongs: false });
    let bitten = truth.loops().iter().cloned().chain(rings("1 1 1 2 2 1;")).collect();
    assert_eq!(compared(&region(&bitten), &a, &b), Verdict::Wrong { belongs: true });
}

//! Exact offsets against the certified reference, on random polygons with holes, and each vertex against its two carriers.

use crate::common::{Loops, Ring, child, loops, rectangle, reversed, square};
use crate::draw::{cells, walk};
use arcsum_cgal::curved;
use arcsum_cgal::error::CgalError;
use arcsum_cgal::offset::{Answer, Carrier, Offset};
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::error::Budget;
use arcsum_oracle::measure::Bracket;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use rug::Rational;
use std::path::Path;

/// The certified distance of a region to the sum of loops of small integers and a disc about the origin, in units of 16.
fn distance(of: &PlainRegion, region: &Loops, radius: f64) -> Bracket {
    let polygon = ExactRegion::from_rings(region.clone(), false, |w| w[0] != 0).expect("small integers").to_plain();
    let half = |x| Corner { x, y: 0.0, bend: Bend::Bulge(1.0) };
    let disc = PlainRegion { loops: vec![vec![half(-radius), half(radius)]], unbounded: false };
    let reference = Reference::new(&polygon, &disc, 16.0, Budget::default()).expect("small regions");
    reference.measure(of).expect("a region").expect("nothing undecided")
}

/// A square with a rectangular hole.
fn framed() -> impl Strategy<Value = Loops> {
    (1i64..8, 1i64..8, 9i64..19, 9i64..19)
        .prop_map(|(x0, y0, x1, y1)| loops(&[square(20), reversed(&rectangle(x0, y0, x1, y1))]))
}

fn drawn(count: usize) -> impl Iterator<Item = (Loops, i64)> {
    let mut runner = TestRunner::new(ProptestConfig::default());
    let strategy = (prop_oneof![walk(3..9), cells(4), framed()], prop_oneof![1i64..5, 1i64..20]);
    (0..count).map(move |_| strategy.new_tree(&mut runner).expect("few rejects").current())
}

/// The vertices are rounded once, to doubles below 64, and bulges too.
const ROUNDED: f64 = 1.0 / (1u64 << 49) as f64;

#[test]
fn exact_offsets_are_the_certified_sums() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let (mut child, mut asked, mut holes) = (child(), 0, 0);
    for (region, eighths) in drawn(60) {
        let question = Offset { region, radius: Rational::from((eighths, 8)) };
        let answer = match child.ask(&question) {
            Ok(answer) => answer,
            // Holes that touch an edge.
            Err(CgalError::Refused(_)) if question.region.len() > 1 => continue,
            Err(error) => panic!("{error} on {question:?}"),
        };
        let found = distance(&answer.to_plain(), &question.region, eighths as f64 / 8.0);
        assert!(found.hi < ROUNDED, "{found:?} {question:?}");
        assert!(question.carriers(&answer).is_ok(), "{question:?}");
        asked += 1;
        holes += usize::from(answer.loops.len() > 1);
    }
    assert!(asked > 40 && holes > 5, "{asked} {holes}");
    // Where CORE's own diagnostics would be: the child works in the folder of this process.
    assert!(!Path::new("Core_Diagnostics").exists(), "CORE has written a file");
}

fn frame(radius: i64) -> Offset {
    let rings: [Ring; 2] = [square(20), reversed(&rectangle(5, 5, 15, 15))];
    Offset { region: loops(&rings), radius: Rational::from(radius) }
}

/// The offset of a frame is known: four corners are rounded, the hole keeps its own.
#[test]
fn the_carriers_of_a_frame_are_known() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let question = frame(2);
    let answer = child().ask(&question).expect("a valid region");
    let carriers: Vec<Carrier> = question.carriers(&answer).expect("its own").concat();
    let circles = carriers.iter().filter(|c| matches!(c, Carrier::Circle(_))).count();
    let line = |numbers: [i64; 4]| Carrier::Line(numbers.map(Rational::from));
    // 20 to the right of x = 20, of length 20; the hole's left edge looks to the right, too.
    assert!(carriers.contains(&line([20, 0, 400, 1600])) && carriers.contains(&line([10, 0, 50, 400])));
    assert_eq!((answer.loops.len(), circles, carriers.len() - circles), (2, 4, 8));
    let gone = child().ask(&frame(5)).expect("a valid region");
    assert_eq!(gone.loops.len(), 1);
}

/// A vertex or a circle that is moved is found out, by its carriers and by the reference.
#[test]
fn planted_errors_are_found() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let question = frame(2);
    let right = child().ask(&question).expect("a valid region");
    let moved = |change: fn(&mut Answer)| {
        let mut wrong = right.clone();
        change(&mut wrong);
        wrong
    };
    let by = || Rational::from(1) >> 40;
    for wrong in [
        moved(|a| a.loops[0][1].tail[0].value += Rational::from(1) >> 40),
        moved(|a| a.loops[1][0].tail[1].value -= Rational::from(1) >> 40),
    ] {
        assert!(question.carriers(&wrong).is_err());
        assert!(distance(&wrong.to_plain(), &question.region, 2.0).lo > 1e-16);
    }
    let mut wrong = right.clone();
    let circle = wrong.loops[0].iter_mut().find_map(|piece| piece.circle.as_mut()).expect("an arc");
    circle.squared_radius += by();
    assert!(question.carriers(&wrong).is_err());
    let mut filled = right;
    filled.loops.pop();
    assert!(distance(&filled.to_plain(), &question.region, 2.0).lo > 0.1);
}

/// The approximate offset keeps its word, and the exact one is nearer.
#[test]
fn approximate_offsets_are_within_their_error() {
    if !arcsum_cgal::built_in() {
        return;
    }
    let mut child = child();
    for (region, eighths) in drawn(20) {
        for error in [1e-3, 1e-7] {
            let radius = Rational::from((eighths, 8));
            let question = curved::Offset { region: region.clone(), radius, error };
            let Ok(answer) = child.ask(&question) else { continue };
            let found = distance(&answer.to_plain(), &region, eighths as f64 / 8.0);
            assert!(found.hi <= error / 16.0 + ROUNDED, "{found:?} {question:?}");
        }
    }
}

//! Set operations of the engine on regions with arcs against CGAL's, which are exact for arcs given by bulges.
//!
//! Membership is judged at points that lie farther from the boundaries of both operands than the backward error that is
//! allowed: there every result that is right within it agrees. What three parties say must be the same: the engine's result,
//! CGAL's, and the certified membership in the operands. Areas may differ by what lies that near to the boundaries.

use arcsum::boolean::{Operation, combine};
use arcsum::region::{Node, Region};
use arcsum_cgal::curved::{Combine, Curved};
use arcsum_cgal::question::Question;
use arcsum_oracle::boolean;
use arcsum_oracle::certified::curve::Curve;
use arcsum_oracle::certified::inside::Winding;
use arcsum_oracle::certified::nearest::{FINE, Nearest};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::plain::PlainRegion;
use arcsum_reports::bridge::plain;
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, holed, simple};
use proptest::prelude::*;
use std::sync::Arc;

const OPERATIONS: [(Operation, boolean::Operation); 4] = [
    (Operation::Union, boolean::Operation::Union),
    (Operation::Intersection, boolean::Operation::Intersection),
    (Operation::Difference, boolean::Operation::Difference),
    (Operation::SymmetricDifference, boolean::Operation::SymmetricDifference),
];

/// The backward error that is allowed: the 45 bits at which the reports begin to ask why, for operands in a box of side 4.
const BOUND: f64 = 4.0 / (1u64 << 45) as f64;

/// A region prepared for membership.
struct Judge {
    winding: Winding,
    curves: Vec<Arc<Curve>>,
}

impl Judge {
    fn new(region: &PlainRegion) -> Self {
        let shape = Shape::new(region).expect("finite");
        Self { winding: Winding::new(&shape), curves: shape.sides().map(|side| Arc::clone(&side.curve)).collect() }
    }

    fn contains(&self, t: [f64; 2]) -> Option<bool> {
        self.winding.inside(|p| Vector::new(t[0], t[1], p), Precision::FINEST)
    }

    /// Whether the point is certainly farther from the boundary than the bound.
    fn is_off(&self, t: [f64; 2]) -> bool {
        let nearest = Nearest::new(&self.curves).expect("doubles");
        nearest.distance(&Spot::exact(t[0], t[1]).at(FINE)).is_none_or(|(distance, _)| distance.lo() > BOUND)
    }
}

fn operand() -> impl Strategy<Value = Region> {
    let region = prop_oneof![
        simple(8, 0.4, Lattice::Fine),
        holed(8, 0.3, Lattice::Fine),
        simple(8, 0.4, Lattice::Integers(6)),
        holed(6, 0.0, Lattice::Fine),
    ];
    (region, -0.5..0.5, -0.5..0.5).prop_map(|(region, x, y)| {
        let moved = |n: &Node| Node { x: n.x + x, y: n.y + y, ..*n };
        Region { loops: region.loops.iter().map(|l| l.iter().map(moved).collect()).collect(), ..region.clone() }
    })
}

/// Points to judge at: some of the box, and for each middle of a result's edge two beside it at a distance of 2^-k.
fn places(result: &PlainRegion, free: &[(f64, f64)], steps: &[i32]) -> Vec<[f64; 2]> {
    let mut places: Vec<[f64; 2]> = free.iter().map(|&(x, y)| [x, y]).collect();
    let shape = Shape::new(result).expect("finite");
    for (side, k) in shape.sides().zip(steps.iter().cycle()) {
        let piece = side.curve.rough();
        let [x, y] = [(piece.from.x.mid() + piece.to.x.mid()) / 2.0, (piece.from.y.mid() + piece.to.y.mid()) / 2.0];
        let chord = piece.chord();
        let (dx, dy) = (chord.x.mid(), chord.y.mid());
        let step = libm::ldexp(1.0, -k) / libm::hypot(dx, dy).max(f64::MIN_POSITIVE);
        places.extend([[x - step * dy, y + step * dx], [x + step * dy, y - step * dx]]);
    }
    places
}

/// How many points were judged; a disagreement fails.
fn judge(
    same: boolean::Operation,
    operands: &[Judge; 2],
    [ours, theirs]: [&PlainRegion; 2],
    places: &[[f64; 2]],
) -> Result<usize, TestCaseError> {
    let [engine, cgal] = [ours, theirs].map(Judge::new);
    let mut judged = 0;
    for &t in places.iter().filter(|t| operands.iter().all(|o| o.is_off(**t))) {
        let [a, b] = operands.each_ref().map(|o| o.contains(t));
        let (Some(a), Some(b)) = (a, b) else { continue };
        let truth = Some(same.holds(a, b));
        prop_assert_eq!(cgal.contains(t), truth, "CGAL's {:?} at {:?}", same, t);
        prop_assert_eq!(engine.contains(t), truth, "the engine's {:?} at {:?}", same, t);
        judged += 1;
    }
    Ok(judged)
}

/// What the area may be off by: a strip on both sides of both boundaries, and a disc at each corner.
fn area_bound(a: &Region, b: &Region) -> f64 {
    // Boundaries of up to 8 segments a loop and 4 loops, each at most a diameter of 4 times pi/2 long.
    let segments = (a.segments() + b.segments()) as f64;
    2.0 * BOUND * segments * 4.0 * 1.6 + segments * BOUND * BOUND * 4.0
}

fn ask(same: boolean::Operation, a: &Region, b: &Region) -> Curved {
    Combine::new(same, &plain(a), &plain(b)).and_then(|question| question.ask()).expect("valid operands")
}

proptest! {
    #![proptest_config(cases(100))]

    /// Each pair by four operations: 400 cases.
    #[test]
    fn set_operations_on_arcs_are_those_of_cgal(
        a in operand(), b in operand(),
        free in prop::collection::vec((-1.6..1.6, -1.6..1.6), 30),
        steps in prop::collection::vec(3..40i32, 7),
    ) {
        if !arcsum_cgal::built_in() {
            return Ok(());
        }
        let operands = [Judge::new(&plain(&a)), Judge::new(&plain(&b))];
        for (operation, same) in OPERATIONS {
            let (ours, theirs) = (combine(operation, &a, &b).expect("finite"), ask(same, &a, &b));
            let rounded = theirs.to_plain();
            let places = places(&rounded, &free, &steps);
            let judged = judge(same, &operands, [&plain(&ours), &rounded], &places)?;
            prop_assert!(2 * judged > places.len(), "{judged} of {}", places.len());
            let off = (ours.area() - theirs.area()).abs();
            prop_assert!(off <= area_bound(&a, &b), "{operation:?}: the area is off by {off}");
        }
    }

    /// The judge sees a result that is another operation's, and one that lacks its greatest loop.
    #[test]
    fn planted_errors_are_seen(
        a in simple(8, 0.4, Lattice::Fine), b in simple(8, 0.4, Lattice::Fine),
        free in prop::collection::vec((-1.6..1.6, -1.6..1.6), 30),
    ) {
        if !arcsum_cgal::built_in() {
            return Ok(());
        }
        let operands = [Judge::new(&plain(&a)), Judge::new(&plain(&b))];
        // Both contain the origin, and neither is the other one.
        let (union, theirs) = (combine(Operation::Union, &a, &b).expect("finite"), ask(boolean::Operation::Union, &a, &b));
        let places = places(&theirs.to_plain(), &[free, vec![(0.0, 0.0)]].concat(), &[30]);
        let seen = |wrong: &Region| judge(boolean::Operation::Union, &operands, [&plain(wrong), &theirs.to_plain()], &places);
        prop_assert!(seen(&union).is_ok());
        prop_assert!(seen(&combine(Operation::Intersection, &a, &b).expect("finite")).is_err());
        prop_assert!(seen(&Region::default()).is_err());
        let lacks = combine(Operation::Difference, &a, &b).expect("finite");
        prop_assert!((theirs.area() - lacks.area()).abs() > area_bound(&a, &b));
    }
}

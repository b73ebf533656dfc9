//! Set operations of the engine against the exact oracle on polygons.
//!
//! The judge is the backward error ([`arcsum_oracle::backward`]): the result is the operation on regions that differ from
//! the operands only within that distance of their boundaries. The distance between the regions is no fair judge of all
//! results, because it is as bad as the question: an overlap narrower than a rounding may come out as nothing, and where
//! edges are nearly parallel the tip of an intersection is rightly far off. On small integers no question is bad, so there
//! the distance is bounded, too, and the result is valid and has the exact number of loops; if all edges are parallel to
//! the axes it is the exact result itself.

use arcsum::arrangement::cross::EPS;
use arcsum::boolean::{Operation, combine};
use arcsum::frame::Frame;
use arcsum::region::{Node, Region};
use arcsum::validate::validate;
use arcsum_oracle::measure::{Bracket, between};
use arcsum_oracle::region::ExactRegion;
use arcsum_oracle::{backward, boolean};
use arcsum_reports::bridge::plain;
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, bars, cells, holed, nudged_copies, nudged_integers, simple, turned_copies};
use glam::DVec2;
use proptest::prelude::*;
use rug::Rational;
use std::f64::consts::{PI, SQRT_2};

type Exact = ExactRegion<Rational>;

/// The engine's operations and the oracle's.
const OPERATIONS: [(Operation, boolean::Operation); 4] = [
    (Operation::Union, boolean::Operation::Union),
    (Operation::Intersection, boolean::Operation::Intersection),
    (Operation::Difference, boolean::Operation::Difference),
    (Operation::SymmetricDifference, boolean::Operation::SymmetricDifference),
];

fn exact(region: &Region) -> Exact {
    Exact::from_plain(&plain(region)).expect("polygonal and finite")
}

fn lines(loops: &[&[(f64, f64)]]) -> Region {
    let nodes = |l: &&[(f64, f64)]| l.iter().map(|&(x, y)| Node::line(x, y)).collect();
    Region { loops: loops.iter().map(nodes).collect(), ..Region::default() }
}

fn moved(region: &Region, x: f64, y: f64) -> Region {
    let nodes = |l: &Vec<Node>| l.iter().map(|n| Node { x: n.x + x, y: n.y + y, ..*n }).collect();
    Region { loops: region.loops.iter().map(nodes).collect(), ..region.clone() }
}

fn polygons(lattice: Lattice) -> impl Strategy<Value = Region> {
    prop_oneof![simple(10, 0.0, lattice), holed(10, 0.0, lattice)]
}

/// The region or its complement.
fn sided(region: impl Strategy<Value = Region>) -> impl Strategy<Value = Region> {
    (region, any::<bool>()).prop_map(|(region, turn)| if turn { region.complement() } else { region })
}

/// Two operands as the oracle reads them, their unit box, and the backward error that is allowed.
struct Judge {
    operands: [Exact; 2],
    unit: f64,
    /// In units of the box: a crossing is within 4.7 eps of both curves (memo C1), ends closer than 4 eps count as touching,
    /// and ends are exact. If the way back to input units moves the box, it rounds both coordinates by at most eps times
    /// the greatest of all.
    bound: f64,
}

impl Judge {
    fn new(a: &Region, b: &Region) -> Self {
        let frame = Frame::shared(&[a, b]);
        let unit = libm::ldexp(1.0, frame.exp);
        let nodes = [a, b].into_iter().flat_map(|r| r.loops.iter().flatten());
        let far = nodes.map(|n| n.x.abs().max(n.y.abs())).fold(0.0, f64::max) / unit;
        let rounding = if frame.shift == DVec2::ZERO { 0.0 } else { SQRT_2 * far };
        Self { operands: [exact(a), exact(b)], unit, bound: (4.7 + 4.0 + rounding) * EPS }
    }

    fn truth(&self, operation: boolean::Operation) -> Exact {
        boolean::combine(operation, &self.operands[0], &self.operands[1]).expect("finite")
    }

    fn error(&self, operation: boolean::Operation, result: &Exact) -> Bracket {
        backward::error(operation, &self.operands[0], &self.operands[1], result, self.unit).expect("finite")
    }

    /// What the area may be off by if the backward error is within the bound d: all that lies within d of a boundary, up to
    /// 2 d times its length and pi d^2 for each of its loops.
    fn area_bound(&self) -> f64 {
        let d = self.bound * self.unit;
        self.operands.iter().map(|r| 2.0 * d * r.perimeter().hi() + PI * d * d * r.loops().len() as f64).sum()
    }
}

/// All four results are within the bounds.
fn check(a: &Region, b: &Region) -> Result<(), TestCaseError> {
    let judge = Judge::new(a, b);
    for (operation, same) in OPERATIONS {
        let result = exact(&combine(operation, a, b).expect("finite"));
        let bracket = judge.error(same, &result);
        prop_assert!(bracket.hi <= judge.bound, "{operation:?}: {bracket:?} above {}", judge.bound);
        let off = (result.area() - judge.truth(same).area()).to_f64().abs();
        prop_assert!(off <= judge.area_bound(), "{operation:?}: the area is off by {off}");
    }
    Ok(())
}

/// On integers up to n the results are also valid, of as many loops as they should be, and in their place: edges that cross
/// are no closer to parallel than 1 over the product of their lengths, which is at most 8 n^2, and a point within d of both
/// lines is within twice that product times d of their crossing.
fn check_integers(a: &Region, b: &Region, n: i32) -> Result<(), TestCaseError> {
    check(a, b)?;
    let judge = Judge::new(a, b);
    for (operation, same) in OPERATIONS {
        let (result, truth) = (combine(operation, a, b).expect("finite"), judge.truth(same));
        prop_assert!(result.loops.is_empty() || validate(&result) == Ok(()), "{operation:?}: {:?}", validate(&result));
        prop_assert_eq!(result.loops.len(), truth.loops().len(), "{:?}", operation);
        let bracket = between(&exact(&result), &truth, judge.unit).expect("finite");
        prop_assert!(bracket.hi <= f64::from(16 * n * n) * judge.bound, "{operation:?}: {bracket:?}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(120))]

    #[test]
    fn general_position(a in sided(polygons(Lattice::Fine)), b in sided(polygons(Lattice::Fine))) {
        check(&a, &b)?;
    }

    #[test]
    fn integers(a in sided(polygons(Lattice::Integers(4))), b in sided(polygons(Lattice::Integers(4)))) {
        check_integers(&a, &b, 4)?;
    }

    #[test]
    fn coarse_grids_full_of_coincidences(
        a in sided(polygons(Lattice::Integers(2))), b in sided(polygons(Lattice::Integers(2)))
    ) {
        check_integers(&a, &b, 2)?;
    }

    #[test]
    fn half_cells(a in sided(cells(4, true)), b in sided(cells(4, true))) {
        check_integers(&a, &b, 4)?;
    }

    /// Where a horizontal edge crosses a vertical one nothing is rounded.
    #[test]
    fn cells_are_combined_exactly(a in sided(cells(5, false)), b in sided(cells(5, false))) {
        let judge = Judge::new(&a, &b);
        for (operation, same) in OPERATIONS {
            let (result, truth) = (combine(operation, &a, &b).expect("finite"), judge.truth(same));
            prop_assert_eq!(result.loops.len(), truth.loops().len(), "{:?}", operation);
            prop_assert_eq!(exact(&result), truth, "{:?}", operation);
        }
    }

    #[test]
    fn copies_a_few_roundings_off((a, b) in nudged_copies(polygons(Lattice::Fine))) {
        check(&a, &b)?;
    }

    #[test]
    fn integers_and_copies_a_few_roundings_off((a, b) in nudged_copies(polygons(Lattice::Integers(3)))) {
        check(&a, &b)?;
    }

    #[test]
    fn nearly_integers(a in nudged_integers(10, 3), b in nudged_integers(10, 3)) {
        check(&a, &b)?;
    }

    #[test]
    fn nearly_parallel_edges((a, b) in turned_copies(polygons(Lattice::Fine)), turn: bool) {
        check(&a, &if turn { b.complement() } else { b })?;
    }

    #[test]
    fn nearly_vertical_edges(a in bars(), b in bars()) {
        check(&a, &b)?;
    }

    #[test]
    fn far_from_the_origin(
        a in sided(polygons(Lattice::Fine)), b in polygons(Lattice::Fine), k in 0..40_i32, x in -1.0..1.0, y in -1.0..1.0
    ) {
        let far = |region| moved(region, x * 2_f64.powi(k), y * 2_f64.powi(k));
        let (a, b) = (far(&a), far(&b));
        prop_assume!(validate(&a).is_ok() && validate(&b).is_ok());
        check(&a, &b)?;
    }

    /// Planted: an intersection of all cells that anything winds around. What lies in one operand alone is wrong then, and if
    /// its area is more than the bound allows, so is the backward error.
    #[test]
    fn a_union_is_no_intersection(a in polygons(Lattice::Fine), b in polygons(Lattice::Fine)) {
        let judge = Judge::new(&a, &b);
        prop_assert!(judge.truth(boolean::Operation::SymmetricDifference).area().to_f64() > 2.0 * judge.area_bound());
        let wrong = exact(&combine(Operation::Union, &a, &b).expect("valid"));
        prop_assert!(judge.error(boolean::Operation::Intersection, &wrong).lo > judge.bound);
    }

    /// Planted: one loop is lost.
    #[test]
    fn lost_loops_are_missed(
        a in sided(polygons(Lattice::Integers(4))), b in polygons(Lattice::Integers(4)),
        (operation, same) in prop::sample::select(&OPERATIONS), index: prop::sample::Index
    ) {
        let mut result = combine(operation, &a, &b).expect("valid");
        prop_assume!(!result.loops.is_empty());
        result.loops.remove(index.index(result.loops.len()));
        let judge = Judge::new(&a, &b);
        prop_assert!(judge.error(same, &exact(&result)).lo > judge.bound);
    }
}

// Slivers are dear to judge.
proptest! {
    #![proptest_config(cases(30))]

    /// Results may have slivers whose loops cross or lie on the wrong side by a rounding.
    #[test]
    fn results_serve_as_operands(
        (a, b) in prop_oneof![nudged_copies(polygons(Lattice::Fine)), turned_copies(polygons(Lattice::Fine))],
        c in polygons(Lattice::Fine), (operation, _) in prop::sample::select(&OPERATIONS)
    ) {
        let result = combine(operation, &a, &b).expect("valid");
        check(&result, &c)?;
        check(&a, &result)?;
    }
}

/// Planted: a vertex that is off by little more than the bound.
#[test]
fn the_judge_sees_errors_as_small_as_the_bound() {
    let a = lines(&[&[(0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)]]);
    let b = moved(&a, 0.25, 0.25);
    let judge = Judge::new(&a, &b);
    for (operation, same) in OPERATIONS {
        let mut result = combine(operation, &a, &b).expect("valid");
        assert_eq!(judge.error(same, &exact(&result)).hi, 0.0);
        let corner = result.loops[0].iter_mut().find(|n| n.x == 0.5 && n.y == 0.5 || n.x == 0.0 && n.y == 0.0);
        let corner = corner.expect("a corner of the first square");
        (corner.x, corner.y) = (corner.x + 10.0 * EPS, corner.y + 10.0 * EPS);
        assert!(judge.error(same, &exact(&result)).lo > judge.bound, "{operation:?}");
    }
}

/// Planted: the wrong answer far away.
#[test]
fn the_judge_sees_what_is_wrong_far_away() {
    let a = lines(&[&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]]);
    let judge = Judge::new(&a, &a.complement());
    let union = combine(Operation::Union, &a, &a.complement()).expect("valid");
    assert_eq!(union, Region::plane());
    let wrong = exact(&Region { unbounded: false, ..union });
    assert_eq!(judge.error(boolean::Operation::Union, &wrong).lo, f64::INFINITY);
}

/// Once refused, because such loops turn 0 times and such holes lie in nothing.
#[test]
fn operands_may_have_loops_that_cross_or_lie_outside() {
    let b = lines(&[&[(1.0, 0.5), (3.0, 0.5), (3.0, 1.5), (1.0, 1.5)]]);
    for d in [50, 30, 4].map(|k| 2_f64.powi(-k)) {
        let twisted = lines(&[&[(0.0, 0.0), (2.0, 0.0), (2.0, 1.0 + d), (2.0 + d, 1.0), (2.0 - d, 1.0), (2.0, 2.0)]]);
        let outside =
            lines(&[&[(0.0, 0.0), (2.0, 0.0), (2.0, 2.0)], &[(2.0 + d, 1.0), (2.0 + d, 1.25), (2.0 + 2.0 * d, 1.0)]]);
        for a in [twisted, outside] {
            check(&a, &b).expect("within the bounds");
            check(&b.complement(), &a).expect("within the bounds");
        }
    }
}

/// The pinch at (0, -1) lies on an edge that ends at thirds. Once that edge was drawn through it in one piece, and so across
/// the other loop.
#[test]
fn loops_that_touch_keep_the_vertex_they_touch_at() {
    let a = lines(&[&[(1.0, 0.0), (-1.0, 0.0), (1.0, -2.0)]]);
    let lack = lines(&[&[
        (2.0, 0.0),
        (1.0, 1.0),
        (-1.0, 1.0),
        (-1.0, 0.0),
        (-2.0, -1.0),
        (0.0, 0.0),
        (0.0, -1.0),
        (1.0, -1.0),
    ]]);
    check_integers(&a, &lack.complement(), 2).expect("within the bounds");
}

/// A triangle that touches the rest of the union at its three corners. Once an edge through one of them, between two edges
/// that end there, was swapped out of their way at a vertex of its own, and the triangle came out as a gap between holes.
#[test]
fn an_edge_between_edges_that_end_on_it_meets_them_in_one_vertex() {
    let a = lines(&[
        &[(2.0, 1.0), (3.0, 1.0), (3.0, 2.0), (2.0, 2.0)],
        &[(2.0, 4.0), (3.0, 3.0), (3.0, 4.0)],
        &[(3.0, 2.0), (4.0, 2.0), (3.0, 3.0)],
    ]);
    let lack = lines(&[&[(2.0, 2.0), (3.0, 2.0), (3.0, 1.0), (4.0, 1.0), (4.0, 3.0), (2.0, 3.0)]]);
    let union = combine(Operation::Union, &a, &lack.complement()).expect("valid");
    assert_eq!(union.loops.len(), 2);
    assert_eq!(validate(&union), Ok(()));
    check_integers(&a, &lack.complement(), 4).expect("within the bounds");
}

/// Left sides that rise and fall within three units in the last place of x, so that one crosses the other where it likes. Once
/// the crossing with the edge that follows was put at the far end of that edge's box.
#[test]
fn crossings_of_steep_edges_are_in_their_place() {
    let a = lines(&[&[
        (0.11764705882352941, -1.4809684843062674),
        (0.17647058823529413, -1.4809684843062674),
        (0.17647058823529413, 1.3668511791148275),
        (0.11764705882352937, 1.3668511791148277),
    ]]);
    let b = lines(&[&[
        (0.1176470588235294, -0.1),
        (0.17647058823529413, -0.19728475085999608),
        (0.17647058823529418, 0.6742523580193857),
        (0.11764705882352938, 0.3281320373003323),
    ]]);
    check(&a, &b).expect("within the bounds");
}

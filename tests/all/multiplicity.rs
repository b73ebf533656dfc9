//! Multiplicities (memo E7): across every edge of the arrangement of a monotonic convolution the winding number changes by the
//! signed count of the pieces on the edge. Counted from the pieces themselves, in exact integer geometry.

use arcsum::arrangement::Arrangement;
use arcsum::arrangement::graph::Edge;
use arcsum::convolution::{monotonic, ordered};
use arcsum::frame::Frame;
use arcsum::piece::{Piece, Pieces};
use arcsum::region::{Node, Region};
use arcsum::robustness::Robustness;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, cells, simple};
use glam::DVec2;
use proptest::prelude::*;

fn arranged(a: &Region, b: &Region) -> (Pieces, Arrangement) {
    let frames = Frame::pair(a, b);
    let (x, y) = (Smooth::new(a, &frames.0).expect("valid"), Smooth::new(b, &frames.1).expect("valid"));
    let (pieces, order) = monotonic(&x, &y, Rounding::Correct).expect("bounded");
    let arrangement = ordered::arrange(&pieces, &order, Robustness::ALL);
    (pieces, arrangement)
}

/// Twice the area of a triangle: exact, as the coordinates are small integers over a power of two.
fn area(p: DVec2, q: DVec2, r: DVec2) -> f64 {
    (q - p).perp_dot(r - p)
}

/// The place along the x axis, along the y axis for verticals.
fn along(p: DVec2, vertical: bool) -> f64 {
    if vertical { p.y } else { p.x }
}

/// What a piece adds to the winding number across the middle of a part of a line: 1 if it is there and runs to the right, or
/// upwards, -1 if it is there and runs the other way.
fn weight(pieces: &Pieces, piece: &Piece, line: [DVec2; 2], middle: f64) -> i32 {
    let [tail, head] = [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
    let whole = piece.whole.map(|v| pieces.points[v as usize]);
    let vertical = line[0].x == line[1].x;
    // Where a piece was cut its ends are rounded; the whole is on the line or not.
    if whole.iter().any(|p| area(line[0], line[1], *p) != 0.0) {
        return 0;
    }
    let (from, to) = (along(tail, vertical), along(head, vertical));
    i32::from(from < middle && middle < to) - i32::from(to < middle && middle < from)
}

/// An edge on its line: the line, the ends along it and the change of the winding number.
struct Step {
    line: [DVec2; 2],
    ends: [f64; 2],
    change: i32,
}

fn steps(arrangement: &Arrangement) -> Vec<Step> {
    let graph = &arrangement.graph;
    let step = |edge: &Edge| {
        let curve = &graph.curves[edge.curve as usize];
        let ends = [edge.from, edge.to].map(|v| along(graph.points[v as usize], curve.is_vertical()));
        let [below, above] = [edge.below, edge.above].map(|face| graph.windings[face as usize][0]);
        Step { line: [curve.left, curve.right], ends, change: above - below }
    };
    graph.edges.iter().map(step).collect()
}

/// The edges at whose middles the change of the winding number differs from the count of pieces, and those that were checked.
/// Edges that coincide count together: where the convolution order puts two beside each other, a cell of no width stays
/// between them.
fn wrong(pieces: &Pieces, arrangement: &Arrangement) -> (usize, usize) {
    let (all, mut wrong, mut checked) = (steps(arrangement), 0, 0);
    for Step { line, ends: [from, to], .. } in &all {
        // A rounding wide: which pieces pass is not for doubles to tell.
        if to - from < 1e-12 {
            continue;
        }
        let middle = 0.5 * (from + to);
        let here = |step: &&Step| {
            let on_line = step.line.iter().all(|p| area(line[0], line[1], *p) == 0.0);
            on_line && step.ends[0] < middle && middle < step.ends[1]
        };
        let change: i32 = all.iter().filter(here).map(|step| step.change).sum();
        let expected: i32 = pieces.pieces.iter().map(|piece| weight(pieces, piece, *line, middle)).sum();
        wrong += usize::from(change != expected);
        checked += 1;
    }
    (wrong, checked)
}

fn assert_counted(a: &Region, b: &Region) -> Result<(), TestCaseError> {
    let (pieces, arrangement) = arranged(a, b);
    let (wrong, checked) = wrong(&pieces, &arrangement);
    prop_assert!(wrong == 0 && checked > 0, "{wrong} of {checked} edges");
    Ok(())
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn integers(a in simple(9, 0.0, Lattice::Integers(4)), b in simple(9, 0.0, Lattice::Integers(4))) {
        assert_counted(&a, &b)?;
    }

    #[test]
    fn equal_copies(a in simple(9, 0.0, Lattice::Integers(4))) {
        assert_counted(&a, &a)?;
    }

    #[test]
    fn orthogonal_cells(a in cells(4, false), b in prop_oneof![cells(2, false), cells(3, false)]) {
        assert_counted(&a, &b)?;
    }
}

fn polygon(corners: &[(f64, f64)]) -> Region {
    Region { loops: vec![corners.iter().map(|&(x, y)| Node::line(x, y)).collect()], ..Region::default() }
}

/// An octagon, nearly regular, with corners in integers, and a square.
#[test]
fn regular_polygons_against_themselves() {
    let octagon =
        [(7.0, 3.0), (3.0, 7.0), (-3.0, 7.0), (-7.0, 3.0), (-7.0, -3.0), (-3.0, -7.0), (3.0, -7.0), (7.0, -3.0)];
    for region in [polygon(&octagon), polygon(&[(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)])] {
        assert!(assert_counted(&region, &region).is_ok());
    }
}

/// The check fails if one piece is counted twice.
#[test]
fn a_doubled_piece_is_noticed() {
    let (mut pieces, arrangement) = arranged(
        &polygon(&[(0.0, 0.0), (4.0, 0.0), (1.0, 1.0), (0.0, 3.0)]),
        &polygon(&[(0.0, 0.0), (2.0, 1.0), (0.0, 1.0)]),
    );
    assert_eq!(wrong(&pieces, &arrangement).0, 0);
    for i in 0..pieces.pieces.len() {
        pieces.pieces.push(pieces.pieces[i]);
        assert!(wrong(&pieces, &arrangement).0 > 0, "piece {i}");
        pieces.pieces.pop();
    }
}

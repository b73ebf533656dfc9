//! Why `integers_bubble` and `comb` of the open witnesses have a falsely free cell inside: the sweep merges pieces that coincide
//! and goes on with what the convolution order knows of one of them (MS 7.1). A module that knows of each what is known of all
//! that have its ends leaves no such cell.

use arcsum::arrangement::cross::{CrossingModule, Crossings};
use arcsum::arrangement::curve::Curve;
use arcsum::arrangement::known::Known;
use arcsum::arrangement::{Arrangement, arrange_with, module};
use arcsum::convolution::monotonic;
use arcsum::convolution::ordered::Ordered;
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::{Curve as Bend, Node, Region};
use arcsum::robustness::Robustness;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_reports::run::witness::Witness;
use glam::DVec2;
use std::path::Path;

/// A module that knows of a piece what is known of those with its ends, too.
struct Twins<M> {
    module: M,
    /// For each piece all that coincide with it, itself among them.
    twins: Vec<Vec<u32>>,
}

impl<M> Twins<M> {
    fn all(&self, curve: &Curve) -> impl Iterator<Item = Curve> {
        self.twins[curve.piece as usize].iter().map(|piece| {
            let mut twin = *curve;
            twin.piece = *piece;
            twin
        })
    }

    fn pairs(&self, f: &Curve, g: &Curve) -> impl Iterator<Item = [Curve; 2]> {
        self.all(f).flat_map(|f| self.all(g).map(move |g| [f, g]))
    }
}

impl<M: CrossingModule> CrossingModule for Twins<M> {
    fn cross(&self, f: &Curve, g: &Curve) -> Crossings {
        self.module.cross(f, g)
    }

    fn above(&self, p: DVec2, curve: &Curve) -> f64 {
        self.module.above(p, curve)
    }

    fn tolerance(&self) -> f64 {
        self.module.tolerance()
    }

    fn known(&self, f: &Curve, g: &Curve, x: f64) -> Known {
        self.pairs(f, g).fold(Known::NOTHING, |known, [f, g]| known.and(self.module.known(&f, &g, x)))
    }

    fn agrees(&self, below: bool, f: &Curve, g: &Curve) -> bool {
        self.pairs(f, g).all(|[f, g]| self.module.agrees(below, &f, &g))
    }

    fn placed(&self, f: &Curve, g: &Curve, x: f64) -> Option<bool> {
        self.pairs(f, g).find_map(|[f, g]| self.module.placed(&f, &g, x))
    }

    fn related(&self, piece: u32, x: f64, found: &mut Vec<u32>) {
        self.twins[piece as usize].iter().for_each(|twin| self.module.related(*twin, x, found));
        let twins: Vec<u32> = found.iter().flat_map(|piece| &self.twins[*piece as usize]).copied().collect();
        found.extend(twins);
    }
}

/// For each piece those between the same points.
fn twins(pieces: &Pieces) -> Vec<Vec<u32>> {
    let ends = |piece: usize| {
        let piece = &pieces.pieces[piece];
        ([piece.tail, piece.head].map(|v| pieces.points[v as usize]), piece.delta)
    };
    let all = 0..pieces.pieces.len();
    all.clone().map(|i| all.clone().filter(|j| ends(*j) == ends(i)).map(|j| j as u32).collect()).collect()
}

/// The trapezoids of free cells inside the sum.
fn free_inside(arrangement: &Arrangement) -> usize {
    let is_free = |face: u32| face != 0 && arrangement.graph.windings[face as usize][0] == 0;
    arrangement.trapezoids.iter().filter(|trapezoid| is_free(trapezoid.face)).count()
}

/// The free trapezoids inside, with the order of one of each merged pieces, and with that of all.
fn bubbles(a: &Region, b: &Region) -> [usize; 2] {
    let frames = Frame::pair(a, b);
    let [a, b] = [(a, &frames.0), (b, &frames.1)].map(|(region, frame)| Smooth::new(region, frame).expect("valid"));
    let (pieces, order) = monotonic(&a, &b, Rounding::Correct).expect("bounded");
    let one = Ordered { module: module(&pieces), order: &order, robustness: Robustness::ALL };
    let all = Twins { module: one, twins: twins(&pieces) };
    [free_inside(&arrange_with(&pieces, &one)), free_inside(&arrange_with(&pieces, &all))]
}

/// `integers_bubble` made small: a triangle with an arc, and the same with a corner one unit in the last place off.
#[test]
fn a_triangle_and_nearly_itself_have_a_bubble() {
    let triangle = |x: f64| Region {
        loops: vec![vec![
            Node { x: 0.0, y: 2.0, curve: Bend::Bulge(0.66) },
            Node { x, y: 0.0, curve: Bend::Line },
            Node { x: -4.0, y: -3.0, curve: Bend::Line },
        ]],
        ..Region::default()
    };
    assert_eq!(bubbles(&triangle(-3.0), &triangle((-3.0_f64).next_down())), [1, 0]);
}

#[test]
fn the_order_of_all_merged_pieces_leaves_no_bubble() {
    for name in ["integers_bubble", "comb"] {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("witnesses/open").join(name).with_extension("json");
        let case = Witness::read(&file).expect("a witness").case;
        assert_eq!(bubbles(&case.a, &case.b), [1, 0], "{name}");
    }
}

//! Pieces that coincide are merged by the sweep, which goes on with what the convolution order knows of all of them (MS 7.1). Two
//! witnesses had a falsely free cell inside as long as it knew of one only: planted again, that brings the cells back.

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

/// A module that knows of some pieces only.
struct Forgetful<M> {
    module: M,
    known: Vec<bool>,
}

impl<M> Forgetful<M> {
    fn knows(&self, f: &Curve, g: &Curve) -> bool {
        self.known[f.piece as usize] && self.known[g.piece as usize]
    }
}

impl<M: CrossingModule> CrossingModule for Forgetful<M> {
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
        if self.knows(f, g) { self.module.known(f, g, x) } else { Known::NOTHING }
    }

    fn agrees(&self, below: bool, f: &Curve, g: &Curve) -> bool {
        !self.knows(f, g) || self.module.agrees(below, f, g)
    }

    fn placed(&self, f: &Curve, g: &Curve, x: f64) -> Option<bool> {
        if self.knows(f, g) { self.module.placed(f, g, x) } else { None }
    }

    fn related(&self, piece: u32, x: f64, found: &mut Vec<u32>) {
        if self.known[piece as usize] {
            self.module.related(piece, x, found);
            found.retain(|piece| self.known[*piece as usize]);
        }
    }
}

/// For each piece whether it is the first, and whether it is the last, of those between the same points.
fn ends_of_bundles(pieces: &Pieces) -> [Vec<bool>; 2] {
    let ends = |piece: usize| {
        let piece = &pieces.pieces[piece];
        ([piece.tail, piece.head].map(|v| pieces.points[v as usize]), piece.delta)
    };
    let all = || 0..pieces.pieces.len();
    let first = all().map(|i| !all().take(i).any(|j| ends(j) == ends(i))).collect();
    let last = all().map(|i| !all().skip(i + 1).any(|j| ends(j) == ends(i))).collect();
    [first, last]
}

/// The trapezoids of free cells inside the sum.
fn free_inside(arrangement: &Arrangement) -> usize {
    let is_free = |face: u32| face != 0 && arrangement.graph.windings[face as usize][0] == 0;
    arrangement.trapezoids.iter().filter(|trapezoid| is_free(trapezoid.face)).count()
}

/// The free trapezoids inside: with the order of all merged pieces, and with that of the first, or of the last, of them.
fn bubbles(a: &Region, b: &Region) -> [usize; 3] {
    let frames = Frame::pair(a, b);
    let [a, b] = [(a, &frames.0), (b, &frames.1)].map(|(region, frame)| Smooth::new(region, frame).expect("valid"));
    let (pieces, order) = monotonic(&a, &b, Rounding::Correct).expect("bounded");
    let module = Ordered { module: module(&pieces), order: &order, robustness: Robustness::ALL };
    let [first, last] =
        ends_of_bundles(&pieces).map(|known| free_inside(&arrange_with(&pieces, &Forgetful { module, known })));
    [free_inside(&arrange_with(&pieces, &module)), first, last]
}

fn check(a: &Region, b: &Region, name: &str) {
    let [with_all, first, last] = bubbles(a, b);
    assert_eq!((with_all, first.max(last)), (0, 1), "{name}");
}

/// `integers_bubble` made small: a triangle with an arc, and the same with a corner one unit in the last place off.
#[test]
fn a_triangle_and_nearly_itself_have_no_bubble() {
    let triangle = |x: f64| Region {
        loops: vec![vec![
            Node { x: 0.0, y: 2.0, curve: Bend::Bulge(0.66) },
            Node { x, y: 0.0, curve: Bend::Line },
            Node { x: -4.0, y: -3.0, curve: Bend::Line },
        ]],
        ..Region::default()
    };
    check(&triangle(-3.0), &triangle((-3.0_f64).next_down()), "triangle");
}

#[test]
fn what_is_known_of_merged_pieces_leaves_no_bubble() {
    for name in ["integers_bubble", "comb_merged"] {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("witnesses/mended").join(name).with_extension("json");
        let case = Witness::read(&file).expect("a witness").case;
        check(&case.a, &case.b, name);
    }
}

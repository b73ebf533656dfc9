//! The monotonic convolution against its definition (MS 5; memo E5): winding numbers counted from chains and turning points
//! in exact arithmetic.

use arcsum::convolution::{kinetic, monotonic};
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::Region;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_tests::cases;
use arcsum_tests::chains::{Point, winding};
use arcsum_tests::monotone::Monotone;
use arcsum_tests::random::Random;
use arcsum_tests::shapes::{Lattice, cells, holed, simple};
use glam::DVec2;
use proptest::prelude::*;
use rug::Rational;

/// Probes this close to a piece, in unit-box lengths, are not asked about: pieces end at rounded points.
const NEAR: f64 = 1e-9;

/// Probes a pair.
const PROBES: usize = 10;

/// Two polygons and both their convolutions.
struct Convolved {
    frames: (Frame, Frame),
    definition: Monotone,
    kinetic: Pieces,
    monotonic: Pieces,
}

impl Convolved {
    fn new(a: &Region, b: &Region) -> Self {
        let frames = Frame::pair(a, b);
        let (x, y) = (Smooth::new(a, &frames.0).expect("valid"), Smooth::new(b, &frames.1).expect("valid"));
        let kinetic = kinetic(&x, &y, Rounding::Correct).expect("bounded");
        let (monotonic, _) = monotonic(&x, &y, Rounding::Correct).expect("bounded");
        Self { frames, definition: Monotone::new(a, b), kinetic, monotonic }
    }

    /// Points in the unit box of the sum, half of them near ends of pieces.
    fn probes(&self, seed: u64) -> Vec<DVec2> {
        let mut random = Random::new(seed);
        let points = &self.monotonic.points;
        let probe = |k: usize| {
            let place = *random.pick(points);
            let scale = if k % 2 == 0 { 0.5 } else { 0.01 };
            place + scale * DVec2::new(random.unit() - 0.5, random.unit() - 0.5)
        };
        (0..PROBES)
            .map(probe)
            .filter(|p| [&self.kinetic, &self.monotonic].iter().all(|c| distance(c, *p) > NEAR))
            .collect()
    }

    /// The same point in input units.
    fn input(&self, p: DVec2) -> Point {
        let side = Rational::from_f64(libm::scalbn(1.0, self.frames.0.exp)).expect("finite");
        let exact = |x: f64| Rational::from_f64(x).expect("finite");
        let (a, b) = (self.frames.0.shift, self.frames.1.shift);
        [exact(p.x) * &side + exact(a.x) + exact(b.x), exact(p.y) * &side + exact(a.y) + exact(b.y)]
    }
}

/// The distance of a point from the nearest piece.
fn distance(pieces: &Pieces, p: DVec2) -> f64 {
    let to = |piece: &arcsum::piece::Piece| {
        let [from, to] = [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
        let (way, out) = (to - from, p - from);
        let along = if way == DVec2::ZERO { 0.0 } else { (out.dot(way) / way.length_squared()).clamp(0.0, 1.0) };
        (out - along * way).length()
    };
    pieces.pieces.iter().map(to).fold(f64::INFINITY, f64::min)
}

/// The winding number of a point in pieces that are lines.
fn around(pieces: &Pieces, p: DVec2) -> i32 {
    assert!(pieces.pieces.iter().all(|piece| piece.delta == 0.0), "polygons");
    let exact = |p: &DVec2| [p.x, p.y].map(|x| Rational::from_f64(x).expect("finite"));
    let level: Vec<[Point; 2]> = pieces
        .pieces
        .iter()
        .map(|piece| [piece.tail, piece.head].map(|v| pieces.points[v as usize]))
        .filter(|[from, to]| (from.y > p.y) != (to.y > p.y))
        .map(|ends| ends.each_ref().map(exact))
        .collect();
    winding(level.iter().map(|[from, to]| [from, to]), &exact(&p)) + pieces.base[0]
}

/// Checks the facts of memo E5 at some points.
fn as_defined(a: &Region, b: &Region, seed: u64) -> Result<(), TestCaseError> {
    let convolved = Convolved::new(a, b);
    for p in convolved.probes(seed) {
        let counts = convolved.definition.counts(&convolved.input(p));
        let (m, kinetic) = (counts.winding(), around(&convolved.kinetic, p));
        prop_assert_eq!(around(&convolved.monotonic, p), m, "{:?} at {:?}", counts, p);
        prop_assert!(m >= 0 && m <= kinetic && (m == 0) == (kinetic == 0), "{m} and {kinetic} at {p:?}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn small_integers(a in simple(9, 0.0, Lattice::Integers(3)), b in simple(9, 0.0, Lattice::Integers(3)), seed: u64) {
        as_defined(&a, &b, seed)?;
    }

    #[test]
    fn general_position(a in simple(10, 0.0, Lattice::Fine), b in simple(10, 0.0, Lattice::Fine), seed: u64) {
        as_defined(&a, &b, seed)?;
    }

    /// The holes that the fill rule leaves, and those it fills.
    #[test]
    fn holes(
        a in holed(9, 0.0, Lattice::Integers(24)),
        b in prop_oneof![simple(5, 0.0, Lattice::Integers(4)), holed(6, 0.0, Lattice::Integers(12))],
        seed: u64,
    ) {
        as_defined(&a, &b, seed)?;
    }

    /// Verticals inside of chains and at their ends, chains that are verticals, several parts, pinches.
    #[test]
    fn grid_cells(a in cells(4, false), b in prop_oneof![cells(2, false), cells(3, false), cells(2, true)], seed: u64) {
        as_defined(&a, &b, seed)?;
    }
}

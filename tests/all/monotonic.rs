//! The monotonic convolution against its definition (MS 5; memo E5): winding numbers counted from chains and turning points
//! in exact arithmetic.

use arcsum::arrangement::arrange;
use arcsum::convolution::order::{Kind, Order};
use arcsum::convolution::{kinetic, monotonic};
use arcsum::frame::Frame;
use arcsum::piece::{Piece, Pieces};
use arcsum::region::Region;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_oracle::monotone::Monotone;
use arcsum_reports::bridge::plain;
use arcsum_reports::cases::rng::Rng;
use arcsum_reports::lines::{around, distance, in_input_units};
use arcsum_tests::cases;
use arcsum_tests::shapes::{Lattice, cells, holed, simple};
use glam::DVec2;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;
use std::collections::BTreeMap;

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
    order: Order,
}

impl Convolved {
    fn new(a: &Region, b: &Region) -> Self {
        let frames = Frame::pair(a, b);
        let (x, y) = (Smooth::new(a, &frames.0).expect("valid"), Smooth::new(b, &frames.1).expect("valid"));
        let kinetic = kinetic(&x, &y, Rounding::Correct).expect("bounded");
        let (monotonic, order) = monotonic(&x, &y, Rounding::Correct).expect("bounded");
        Self { frames, definition: Monotone::new(&plain(a), &plain(b)), kinetic, monotonic, order }
    }

    /// Points in the unit box of the sum, half of them near ends of pieces.
    fn probes(&self, seed: u64) -> Vec<DVec2> {
        let mut random = Rng::new(seed, "tests");
        let points = &self.monotonic.points;
        let probe = |k: usize| {
            let place = *random.pick(points);
            let scale = if k.is_multiple_of(2) { 0.5 } else { 0.01 };
            place + scale * DVec2::new(random.unit() - 0.5, random.unit() - 0.5)
        };
        (0..PROBES)
            .map(probe)
            .filter(|p| [&self.kinetic, &self.monotonic].iter().all(|c| distance(c, *p) > NEAR))
            .collect()
    }

    /// Whether a piece is part of a boundary moved by a turning point.
    fn is_moved(&self, piece: usize) -> bool {
        let crust = |kind: Kind| matches!(kind, Kind::LowerCrust | Kind::UpperCrust);
        self.order.roles(piece as u32).iter().any(|(_, kind)| !crust(*kind))
    }
}

/// Checks the facts of memo E5 at some points.
fn as_defined(a: &Region, b: &Region, seed: u64) -> Result<(), TestCaseError> {
    holds(&Convolved::new(a, b), seed)
}

fn holds(convolved: &Convolved, seed: u64) -> Result<(), TestCaseError> {
    for p in convolved.probes(seed) {
        let counts = convolved.definition.counts(&in_input_units(&convolved.frames, p));
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

/// Pairs of polygons with concave turning points, the same in every run.
fn pairs() -> impl Iterator<Item = Convolved> {
    let strategy = (simple(12, 0.0, Lattice::Integers(20)), simple(12, 0.0, Lattice::Integers(15)));
    let mut runner = TestRunner::deterministic();
    let pair = move || strategy.new_tree(&mut runner).expect("simple polygons").current();
    let convolved = std::iter::repeat_with(pair).map(|(a, b)| Convolved::new(&a, &b));
    convolved.filter(|convolved| (0..convolved.monotonic.pieces.len()).any(|i| convolved.is_moved(i)))
}

/// The check above fails if moved boundaries run forwards, as MS 5.1 prints them.
#[test]
fn moved_boundaries_run_backwards() {
    for mut convolved in pairs().take(40) {
        assert!(holds(&convolved, 1).is_ok());
        let moved: Vec<usize> = (0..convolved.monotonic.pieces.len()).filter(|i| convolved.is_moved(*i)).collect();
        for i in moved {
            let piece = &mut convolved.monotonic.pieces[i];
            (piece.tail, piece.head) = (piece.head, piece.tail);
        }
        assert!((0..30).any(|seed| holds(&convolved, seed).is_err()));
    }
}

/// Where a crust runs along a moved boundary, both are left out by what they are sums of. Left in, the two are apart by the
/// rounding of the ends of the stretch, and in some sums there are cells between them.
#[test]
fn what_cancels_must_be_left_out() {
    let cells = |pieces: &Pieces| arrange(pieces).graph.windings.len();
    let mut more = 0;
    let cut = pairs().filter_map(|convolved| Some((with_what_cancels(&convolved)?, convolved.monotonic)));
    for (kept, left_out) in cut.take(40) {
        more += usize::from(cells(&kept) > cells(&left_out));
    }
    assert!(more > 0);
}

/// The convolution with moved segments whole, and with the stretches of crusts on those that were cut, if there are any.
fn with_what_cancels(convolved: &Convolved) -> Option<Pieces> {
    let mut kept = Pieces { pieces: Vec::new(), ..convolved.monotonic.clone() };
    let mut cut: BTreeMap<[u32; 2], Vec<Piece>> = BTreeMap::new();
    for (i, piece) in convolved.monotonic.pieces.iter().enumerate() {
        if convolved.is_moved(i) && piece.whole != [piece.tail, piece.head] {
            cut.entry(piece.whole).or_default().push(*piece);
        } else {
            kept.pieces.push(*piece);
        }
    }
    let cut_any = !cut.is_empty();
    for (whole, parts) in cut {
        let line = |tail, head| Piece { tail, head, whole: [tail, head], ..parts[0] };
        let stops = parts.iter().flat_map(|part| [part.tail, part.head]);
        let stops: Vec<u32> = [whole[0]].into_iter().chain(stops).chain([whole[1]]).collect();
        kept.pieces.push(line(whole[0], whole[1]));
        let gaps = stops.chunks(2).filter(|gap| gap[0] != gap[1]);
        kept.pieces.extend(gaps.map(|gap| Piece {
            a: parts[0].a.opposite(),
            b: parts[0].b.opposite(),
            ..line(gap[1], gap[0])
        }));
    }
    cut_any.then_some(kept)
}

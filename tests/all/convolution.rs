//! The kinetic convolution: closed, the same by sweep and by walk, and its winding numbers count what they should.

use arcsum::angle::Ang;
use arcsum::convolution::{kinetic, monotonic};
use arcsum::frame::Frame;
use arcsum::piece::{Pieces, Source};
use arcsum::region::Region;
use arcsum::smooth::{Kind, Seg, Smooth};
use arcsum::sum3::Rounding;
use arcsum_reports::winding::disturb;
use arcsum_tests::cases;
use arcsum_tests::fiber::{self, Shared};
use arcsum_tests::shapes::{Lattice, any_region, simple};
use proptest::prelude::*;
use std::collections::HashMap;

fn smooth_pair(a: &Region, b: &Region) -> (Smooth, Smooth) {
    let frames = Frame::pair(a, b);
    (Smooth::new(a, &frames.0).expect("valid"), Smooth::new(b, &frames.1).expect("valid"))
}

fn assert_closed(pieces: &Pieces) -> Result<(), TestCaseError> {
    let mut balance: HashMap<u32, i32> = HashMap::new();
    for piece in &pieces.pieces {
        *balance.entry(piece.tail).or_default() -= 1;
        *balance.entry(piece.head).or_default() += 1;
    }
    prop_assert!(balance.values().all(|b| *b == 0));
    Ok(())
}

/// What identifies a sum segment whichever way it was found: source, and the normals at its ends in order of traversal.
fn keys(pieces: &Pieces) -> Vec<String> {
    let mut keys: Vec<String> =
        pieces.pieces.iter().map(|p| format!("{:?} {:?} {:?} {}", p.source, p.a, p.b, p.delta > 0.0)).collect();
    keys.sort_unstable();
    keys
}

/// The key the sweep should give a shared interval, from the orientation table of memo B1.
fn key(shared: &Shared, a: &[Seg], b: &[Seg], edges: [u32; 2]) -> String {
    let (x, y) = (&a[shared.a], &b[shared.b]);
    let place = |s: &Seg, edges: u32| if s.kind == Kind::Turn { edges + s.tail } else { s.edge };
    let source = Source { first: place(x, edges[0]), second: place(y, edges[1]) };
    let flip = |angle: Ang, same: bool| if same { angle } else { angle.opposite() };
    if x.kind == Kind::Line || y.kind == Kind::Line {
        let other = if x.kind == Kind::Line { y } else { x };
        let normal = flip(shared.low, other.delta > 0.0);
        return format!("{source:?} {normal:?} {normal:?} false");
    }
    let convex = [x.delta > 0.0, y.delta > 0.0];
    let radius = x.r + y.r;
    let (from, to) = if convex[0] == convex[1] { (shared.low, shared.high) } else { (shared.high, shared.low) };
    // Forward: the two cases in which the stored radius is the sum of the radii.
    let forward = (convex[0] == convex[1]) == (radius > 0.0);
    format!("{source:?} {:?} {:?} {}", flip(from, forward), flip(to, forward), convex[0] == convex[1])
}

fn edges(region: &Smooth) -> u32 {
    region.loops.iter().flat_map(|l| &l.segs).map(|s| s.edge + 1).max().unwrap_or(0)
}

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn every_vertex_has_as_many_in_as_out(a in any_region(), b in any_region()) {
        let (a, b) = smooth_pair(&a, &b);
        assert_closed(&kinetic(&a, &b, Rounding::Correct).expect("bounded"))?;
    }

    #[test]
    fn the_monotonic_one_is_closed_as_well(a in any_region(), b in any_region()) {
        let (a, b) = smooth_pair(&a, &b);
        assert_closed(&monotonic(&a, &b, Rounding::Correct).expect("bounded").0)?;
    }

    /// Angles that are wrong by up to 1e-3, but shared by neighbours, must still close the convolution.
    #[test]
    fn wrong_angles_close_as_well(a in any_region(), b in any_region(), noise in prop::collection::vec(-1e-3..1e-3, 97)) {
        let (mut a, b) = smooth_pair(&a, &b);
        for smooth_loop in &mut a.loops {
            disturb(&mut smooth_loop.segs, &noise);
        }
        assert_closed(&kinetic(&a, &b, Rounding::Correct).expect("bounded"))?;
    }

    #[test]
    fn sweep_and_walk_give_the_same_segments(
        a in prop_oneof![simple(9, 0.4, Lattice::Fine), simple(9, 0.0, Lattice::Integers(3))],
        b in prop_oneof![simple(9, 0.4, Lattice::Fine), simple(9, 0.0, Lattice::Integers(3))],
    ) {
        let (a, b) = smooth_pair(&a, &b);
        let swept = kinetic(&a, &b, Rounding::Correct).expect("bounded");
        let (x, y) = (&a.loops[0].segs, &b.loops[0].segs);
        let (walked, closed) = fiber::convolution(x, y);
        prop_assert!(closed);
        let mut expected: Vec<String> = walked.iter().map(|s| key(s, x, y, [edges(&a), edges(&b)])).collect();
        expected.sort_unstable();
        prop_assert_eq!(keys(&swept), expected);
    }
}

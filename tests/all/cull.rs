//! Culling: what is left has the winding numbers of the whole, or is deep inside; and the sum is as right as without.

use arcsum::arrangement::arrange;
use arcsum::arrangement::cross::EPS;
use arcsum::cull::cull;
use arcsum::part::Parts;
use arcsum::piece::Pieces;
use arcsum::region::{Curve, Node, Region};
use arcsum::sum::{Convolution, Options, Sum, sum};
use arcsum::validate::validate;
use arcsum_oracle::measure::hausdorff;
use arcsum_oracle::polygon;
use arcsum_reports::bridge::{plain, unit};
use arcsum_reports::cases::Case;
use arcsum_reports::cases::family::Family;
use arcsum_tests::winding::{before_and_after, convolutions};

/// A winding number that is only found inside of what was culled.
const INSIDE: i32 = 1 << 19;

/// Pairs whose convolutions cross themselves so often that they are culled.
fn tangled(seed: u64) -> Vec<Case> {
    let sizes = [("star", 20), ("radial", 90), ("twoopt", 100)];
    let cases = |(name, size)| Family::named(name).expect("a family").cases_of_size(size, seed);
    sizes.into_iter().flat_map(cases).collect()
}

/// How many of some random points have another winding number in what is left, if that is not deep inside where the
/// convolution is positive, and how many are not deep inside.
fn wrong(whole: &Pieces, left: &Pieces, seed: u64) -> (usize, usize) {
    let found = before_and_after(whole, left, seed);
    let is_wrong = |[before, after]: &&[i32; 2]| if *after > INSIDE { *before <= 0 } else { before != after };
    let outside = found.iter().filter(|[_, after]| *after <= INSIDE);
    (found.iter().filter(is_wrong).count(), outside.count())
}

/// A pair with slightly bent edges, outwards and inwards by turns.
fn bent(case: Case) -> Case {
    let node = |(i, node): (usize, &Node)| Node { curve: Curve::Bulge(if i % 2 == 0 { 0.02 } else { -0.02 }), ..*node };
    let region = |region: &Region| {
        let loops = region.loops.iter().map(|corners| corners.iter().enumerate().map(node).collect()).collect();
        let bent = Region { loops, ..region.clone() };
        validate(&bent).expect("valid");
        bent
    };
    Case { a: region(&case.a), b: region(&case.b), ..case }
}

/// Lines, and circle segments of both kinds.
#[test]
fn winding_numbers_stay_outside_of_what_was_culled() {
    let stars = Family::named("star").expect("a family").cases_of_size(25, 1);
    for case in (1..4).flat_map(tangled).chain(stars.into_iter().map(bent)) {
        for whole in convolutions(&case) {
            let Parts { pieces, origins } = cull(&whole).expect("worth it");
            assert_eq!(pieces.pieces.len(), origins.len());
            let (wrong, outside) = wrong(&whole, &pieces, 1);
            assert!(wrong == 0 && outside > 0, "{}: {wrong} wrong, {outside} outside", case.name);
            assert_eq!(arrange(&pieces).graph.winding_conflicts, 0, "{}", case.name);
        }
    }
}

/// A rim that is missing, or has another weight, shows.
#[test]
fn a_wrong_rim_is_noticed() {
    let case = &tangled(1)[0];
    let [whole, _] = convolutions(case);
    let Parts { pieces, origins } = cull(&whole).expect("worth it");
    let (missing, heavier) = (&mut pieces.clone(), &mut pieces.clone());
    let rim = origins.iter().position(Option::is_none).expect("a rim");
    missing.pieces.remove(rim);
    heavier.pieces[rim].weight += 1;
    for spoiled in [missing, heavier] {
        assert!(arrange(spoiled).graph.winding_conflicts > 0);
    }
    // Without all rims the winding numbers are wrong as well.
    let mut open = pieces;
    open.pieces.truncate(origins.iter().flatten().count());
    assert!(wrong(&whole, &open, 1).0 > 0);
}

fn summed(a: &Region, b: &Region, convolution: Convolution, culling: bool) -> Sum {
    sum(a, b, &Options { convolution, culling, ..Options::default() }).expect("valid")
}

/// A star in a plane and in a star-shaped hole: as near the exact sum as without culling, from far fewer vertices.
#[test]
fn sums_stay_right() {
    for seed in 1..3 {
        let case = &tangled(seed)[0];
        let container = case.a.loops.iter().map(|corners| container(corners)).collect();
        let complement = Region { loops: container, unbounded: true, ..Region::default() };
        for a in [&case.a, &complement] {
            let exact = polygon::sum(&plain(a), &plain(&case.b)).expect("within budget");
            for convolution in [Convolution::Kinetic, Convolution::Monotonic] {
                let [whole, culled] = [false, true].map(|culling| summed(a, &case.b, convolution, culling));
                let bracket = hausdorff(&plain(&culled.region), &exact, unit(a, &case.b)).expect("measurable");
                assert!(bracket.hi <= 20.0 * EPS, "{bracket:?}");
                let vertices = [&whole, &culled].map(|sum| sum.arrangement.audit.vertices);
                assert!(vertices[1] < vertices[0] && culled.region.unbounded == a.unbounded, "{vertices:?}");
            }
        }
    }
}

/// A loop run backwards and of twice the size.
fn container(corners: &[Node]) -> Vec<Node> {
    corners.iter().rev().map(|node| Node { x: 2.0 * node.x, y: 2.0 * node.y, ..*node }).collect()
}

/// Few pieces, or a convolution that hardly crosses itself, are left alone.
#[test]
fn what_gains_nothing_is_left_alone() {
    for (name, size) in [("arcs", 20), ("star", 4)] {
        for case in Family::named(name).expect("a family").cases_of_size(size, 1) {
            assert!(convolutions(&case).iter().all(|whole| cull(whole).is_none()), "{}", case.name);
        }
    }
}

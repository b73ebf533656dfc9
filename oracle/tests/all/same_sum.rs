//! The same sum computed in two ways: their distance is nothing but what clusters hide.

use std::sync::Arc;

use crate::common::pairs::{exact_pair, mapped, mirrored, pair, rounded, special};
use arcsum_oracle::certified::curve::Curve;
use arcsum_oracle::certified::hausdorff::{Outline, between};
use arcsum_oracle::certified::meet::LIMIT;
use arcsum_oracle::certified::piece::{Circle, Piece};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::certified::strips::Span;
use arcsum_oracle::certified::vector::Vector;
use arcsum_oracle::convolve;
use arcsum_oracle::error::Budget;
use arcsum_oracle::interval::Interval;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::float::Round;
use rug::{Float, Rational};

/// No more than this lies between two ways to compute a sum: a search ends at 2^-60, and clusters hide less than that.
const SAME: f64 = 1.0 / (1u64 << 59) as f64;

fn reference(a: &PlainRegion, b: &PlainRegion) -> Reference {
    let reference = Reference::new(a, b, 1.0, Budget::NONE).expect("closed");
    assert_eq!(reference.undecided(), 0);
    reference
}

/// Checks that two outlines bound the same region.
fn same(one: &Outline, other: &Outline) -> Result<(), TestCaseError> {
    for (first, second) in [(one, other), (other, one)] {
        let bracket = between(first, second).expect("closed").expect("decided").bracket;
        prop_assert!(bracket.lo == 0.0 && bracket.hi < SAME, "{bracket:?}");
    }
    Ok(())
}

/// An outline scaled and moved.
fn image(outline: &Outline, scale: f64, by: (f64, f64)) -> Outline {
    let point = move |v: &Vector| Vector { x: &v.x * scale + by.0, y: &v.y * scale + by.1 };
    let piece = move |piece: &Piece| {
        let circle = piece.circle.as_ref();
        let circle = circle.map(|c| Circle { centre: point(&c.centre), radius: &c.radius * scale, left: c.left });
        Piece { from: point(&piece.from), to: point(&piece.to), circle }
    };
    let span = |span: &Span| {
        let curve = Arc::clone(&span.curve);
        Span { curve: Arc::new(Curve::new(move |p| piece(curve.at(p)))), ends: span.ends.each_ref().map(point) }
    };
    Outline { pieces: outline.pieces.iter().map(span).collect(), unbounded: outline.unbounded }
}

/// The boundary of an exact polygon.
fn polygon(region: &ExactRegion<Rational>) -> Outline {
    let real = |x: &Rational, precision: Precision| {
        let round = |way| Float::with_val_round(precision.bits(), x, way).0;
        let ends = [round(Round::Down), round(Round::Up)];
        if precision == Precision::DOUBLE {
            return Real::Double(Interval::new(ends[0].to_f64(), ends[1].to_f64()));
        }
        Real::Long(Box::new(ends))
    };
    let mut pieces = Vec::new();
    for ring in region.loops() {
        for (k, from) in ring.iter().enumerate() {
            let ends = [from, &ring[(k + 1) % ring.len()]].map(|p| (p.x.clone(), p.y.clone()));
            let point = move |(x, y): &(Rational, Rational), p| Vector { x: real(x, p), y: real(y, p) };
            let boxes = ends.each_ref().map(|end| point(end, LIMIT));
            let curve = Curve::new(move |p| Piece { from: point(&ends[0], p), to: point(&ends[1], p), circle: None });
            pieces.push(Span { curve: Arc::new(curve), ends: boxes });
        }
    }
    Outline { pieces, unbounded: region.unbounded() }
}

/// The region with radii in place of bulges, which are doubles on a grid.
fn by_radius(region: &PlainRegion) -> PlainRegion {
    let mut region = region.clone();
    for ring in &mut region.loops {
        for k in 0..ring.len() {
            let next = ring[(k + 1) % ring.len()];
            if let Bend::Bulge(bulge) = ring[k].bend
                && bulge != 0.0
            {
                let chord = (next.x - ring[k].x).hypot(next.y - ring[k].y);
                ring[k].bend = Bend::Radius(chord * (1.0 + bulge * bulge) / (4.0 * bulge));
            }
        }
    }
    region
}

/// Random and degenerate pairs of every kind.
fn any_pair() -> impl Strategy<Value = (PlainRegion, PlainRegion)> {
    prop_oneof![pair(), (special(), special()), (special(), rounded()), special().prop_map(|a| (a.clone(), a))]
}

proptest! {
    #![proptest_config(crate::common::cases(40))]

    #[test]
    fn the_order_of_operands((a, b) in any_pair()) {
        same(reference(&a, &b).sum(), reference(&b, &a).sum())?;
    }

    #[test]
    fn operands_moved_and_scaled(
        (a, b) in prop_oneof![exact_pair(), (special(), special()), (special(), rounded())],
        x in -4i32..=4, y in -4i32..=4, k in -3i32..=1
    ) {
        let (x, y, scale) = (f64::from(x) / 4.0, f64::from(y) / 4.0, f64::from(k).exp2());
        let there = |by: (f64, f64)| move |u: f64, v: f64| (scale * u + by.0, scale * v + by.1);
        let moved = reference(&mapped(&a, there((x, y))), &mapped(&b, there((0.0, 0.0))));
        same(moved.sum(), &image(reference(&a, &b).sum(), scale, (x, y)))?;
    }

    #[test]
    fn radius_and_bulge((a, b) in (rounded(), rounded())) {
        let whole = reference(&a, &b);
        same(whole.sum(), reference(&by_radius(&a), &b).sum())?;
        same(whole.sum(), reference(&by_radius(&a), &by_radius(&b)).sum())?;
    }

    #[test]
    fn polygons_as_rationals_and_as_intervals(
        a in prop_oneof![crate::common::cells(3), crate::common::radial(3..9)], b in prop_oneof![crate::common::cells(2), crate::common::radial(3..7)]
    ) {
        let [first, second] = [&a, &b].map(crate::common::exact::<Rational>);
        let exact = convolve::sum(&first, &second, Budget::NONE).expect("no budget");
        same(reference(&a, &b).sum(), &polygon(&exact))?;
    }
}

/// Two sums that differ by 2^-50 are told apart.
#[test]
fn a_small_difference_is_seen() {
    let disc = |r: f64| PlainRegion { loops: vec![crate::common::disc(0.0, 0.0, r)], unbounded: false };
    let (a, b) = (disc(0.5), disc(0.25));
    let c = disc(0.25 + 2f64.powi(-50));
    assert!(same(reference(&a, &b).sum(), reference(&a, &c).sum()).is_err());
}

/// An upright side bent by two units in the last place of a bulge, of which most is within far less than a unit of its
/// leftmost abscissa, alone and with a level one.
#[test]
fn a_flat_arc_hides_nothing() -> Result<(), TestCaseError> {
    let bulgy = |corners: &[(f64, f64, f64)]| {
        let corner = |&(x, y, bulge): &(f64, f64, f64)| Corner { x, y, bend: Bend::Bulge(bulge) };
        PlainRegion { loops: vec![corners.iter().map(corner).collect()], unbounded: false }
    };
    let block = |upright: f64, level: f64| {
        let right = [(2.0, -1.0, 0.0), (2.0, 1.0, level), (1.0, 1.0, 0.125), (1.0, 2.0, 0.0), (0.0, 2.0, upright)];
        bulgy(&[&[(0.0, -1.0, -0.125), (1.0, -1.0, 0.0)], &right[..]].concat())
    };
    let flat = f64::from(-51).exp2();
    for level in [0.0, -flat] {
        let (a, b) = (block(-flat, level), mirrored(&block(0.0, 0.0)));
        same(reference(&a, &b).sum(), reference(&b, &a).sum())?;
    }
    Ok(())
}

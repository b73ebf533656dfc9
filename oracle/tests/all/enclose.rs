//! Enclosures of regions with circle segments, against points, areas and distances known in closed form.

use crate::common::{bulged, cells, complement, disc, enclosed, exact, plain};
use arcsum_oracle::enclose::enclose;
use arcsum_oracle::error::{Budget, OracleError};
use arcsum_oracle::locate::{Location, Locator};
use arcsum_oracle::measure::reach;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::point::{Place, Point};
use arcsum_oracle::probe;
use arcsum_oracle::region::ExactRegion;
use proptest::prelude::*;
use rug::Rational;
use std::f64::consts::PI;

fn region(loops: Vec<Vec<Corner>>) -> PlainRegion {
    PlainRegion { loops, unbounded: false }
}

fn corner(x: f64, y: f64, bend: Bend) -> Corner {
    Corner { x, y, bend }
}

fn is_subset(a: &ExactRegion<Rational>, b: &ExactRegion<Rational>) -> bool {
    reach(a, b, 0.0).expect("finite").0.hi() == 0.0
}

fn place(x: f64, y: f64) -> Place<Rational> {
    Place::from(Point::from_f64(x, y).expect("finite"))
}

proptest! {
    #![proptest_config(crate::common::cases(60))]

    #[test]
    fn finer_enclosures_lie_between_coarser_ones(a in bulged()) {
        let (coarse, fine) = (enclosed(&a, 2), enclosed(&a, 12));
        prop_assert!(is_subset(&fine.inner, &fine.outer));
        // Chords of a finer flattening need not contain those of a coarser one, but never leave the outer region.
        prop_assert!(is_subset(&coarse.inner, &fine.outer) && is_subset(&fine.inner, &coarse.outer));
        prop_assert!(fine.area().hi() - fine.area().lo() < coarse.area().hi() - coarse.area().lo());
    }

    #[test]
    fn points_of_a_sector_are_on_the_right_side(
        bulge in -0.9..0.9f64, pieces in 2usize..9, angles in prop::collection::vec(0.0..2.0 * PI, 8)
    ) {
        // A square of side 2 with one side bent; its circle in closed form.
        let mut bent = plain(&[&[(-1.0, -2.0), (1.0, -2.0), (1.0, 0.0), (-1.0, 0.0)]]);
        bent.loops[0][0].bend = Bend::Bulge(bulge);
        let found = enclosed(&bent, pieces);
        let (inner, outer) = (Locator::new(&found.inner).expect("finite"), Locator::new(&found.outer).expect("finite"));
        let (radius, centre) = ((1.0 + bulge * bulge) / (4.0 * bulge) * 2.0, -2.0 + (1.0 - bulge * bulge) / (4.0 * bulge) * 2.0);
        for angle in angles {
            for (size, inside) in [(1.0 - 1e-9, bulge > 0.0), (1.0 + 1e-9, bulge < 0.0)] {
                let (x, y) = (radius * size * angle.sin(), centre + radius * size * angle.cos());
                if x.abs() > 0.99 || (y > -2.0) == (bulge > 0.0) || y > -0.01 {
                    continue;
                }
                let (within, without) = (inner.locate(&place(x, y)), outer.locate(&place(x, y)));
                prop_assert!(inside || within == Location::Outside);
                prop_assert!(!inside || without != Location::Outside);
            }
        }
    }

    #[test]
    fn a_polygon_is_its_own_enclosure(a in cells(3), outside in any::<bool>()) {
        let a = if outside { complement(&a) } else { a };
        let found = enclosed(&a, 3);
        prop_assert_eq!(&found.inner, &exact(&a));
        prop_assert_eq!(found.inner, found.outer);
    }

    #[test]
    fn areas_of_sums_of_discs_are_enclosed(r in 0.25..2.0f64, s in 0.25..2.0f64, pieces in 2usize..12) {
        let sum = enclosed(&region(vec![disc(0.5, 1.0, r)]), pieces)
            .sum(&enclosed(&region(vec![disc(0.0, 0.0, s)]), pieces), Budget::NONE)
            .expect("no budget");
        let area = PI * (r + s) * (r + s);
        prop_assert!(sum.area().lo() < area && area < sum.area().hi());
        let relative = (sum.area().hi() - sum.area().lo()) / area;
        // Chords lose and tangents gain about (2/3 + 1/3) of the squared half step each.
        prop_assert!(relative < 1.2 * (PI / 2.0 / pieces as f64).powi(2) , "{relative}");
    }

    #[test]
    fn radii_and_bulges_of_one_arc_agree(bulge in 0.05..0.95f64, left in any::<bool>()) {
        let chord = 2.0;
        let radius = chord * (1.0 + bulge * bulge) / (4.0 * bulge);
        let (radius, bulge) = if left { (radius, bulge) } else { (-radius, -bulge) };
        let with = |bend| region(vec![vec![corner(0.0, 0.0, bend), corner(chord, 0.0, Bend::Line), corner(1.0, 5.0, Bend::Line)]]);
        let (by_radius, by_bulge) = (enclosed(&with(Bend::Radius(radius)), 4), enclosed(&with(Bend::Bulge(bulge)), 4));
        // The radius is rounded, so the two arcs are apart by that.
        for (part, whole) in [(&by_radius, &by_bulge), (&by_bulge, &by_radius)] {
            prop_assert!(reach(&part.outer, &whole.outer, 0.0).expect("finite").0.hi() < 1e-14);
            prop_assert!(reach(&part.inner, &whole.inner, 0.0).expect("finite").0.hi() < 1e-14);
        }
    }

    #[test]
    fn planted_errors_of_discs_are_bracketed(k in 1i32..=8, x in -1.0..1.0f64, grown in any::<bool>()) {
        // A disc of radius 1 + 1 measured against one moved by delta, or of a radius larger by delta.
        let delta = 2f64.powi(-k);
        let one = region(vec![disc(x, 0.0, 1.0)]);
        let sum = enclosed(&one, 48).sum(&enclosed(&one, 48), Budget::NONE).expect("no budget");
        let wrong = if grown { disc(2.0 * x, 0.0, 2.0 + delta) } else { disc(2.0 * x, delta, 2.0) };
        let found = probe::bracket(&enclosed(&region(vec![wrong]), 48), &sum, 1.0).expect("finite");
        // The rounding of the disc's ends is below 1e-15, the gaps of the enclosures below 2 (1-cos(pi/96)) each.
        let gap = 4.0 * (1.0 - (PI / 96.0).cos());
        prop_assert!(found.lo <= delta + 1e-15 && delta - 1e-15 <= found.hi, "{found:?}");
        prop_assert!(found.lo >= delta - 2.0 * gap && found.hi <= 1.04 * (delta + 2.0 * gap), "{found:?}");
    }
}

#[test]
fn a_region_thinner_than_its_flattening_has_no_inner_polygon() {
    // A ring so thin that the chords of the outer circle cross the tangents of the hole everywhere.
    let ring = region(vec![disc(0.0, 0.0, 1.0), disc(0.0, 0.0, -(1.0 - 1e-6))]);
    let found = enclosed(&ring, 2);
    assert!(found.inner.area() < Rational::from((1, 1000)));
    assert!(found.outer.area() > Rational::from((1, 10)));
    let fine = enclosed(&ring, 4000);
    assert_eq!(fine.inner.holes(), 1);
}

#[test]
fn a_nearly_full_circle_is_enclosed() {
    for bulge in [10.0, 1000.0, 1e6] {
        let drop = region(vec![vec![corner(0.0, 0.0, Bend::Bulge(bulge)), corner(1.0, 0.0, Bend::Line)]]);
        let radius = (1.0 + bulge * bulge) / (4.0 * bulge);
        let found = enclosed(&drop, 16);
        let area = PI * radius * radius;
        assert!(found.area().lo() < area && area < found.area().hi(), "bulge {bulge}");
        assert!(found.area().lo() > 0.5 * area && found.area().hi() < 2.0 * area, "bulge {bulge}");
    }
}

#[test]
fn impossible_arcs_are_refused() {
    for bend in [Bend::Radius(0.4), Bend::Radius(0.0), Bend::Radius(f64::NAN), Bend::Bulge(f64::INFINITY)] {
        let shape =
            region(vec![vec![corner(0.0, 0.0, bend), corner(1.0, 0.0, Bend::Line), corner(0.0, 1.0, Bend::Line)]]);
        let error = enclose::<Rational>(&shape, 4).expect_err("no such arc");
        assert!(matches!(error, OracleError::BadNumber { ring: 0, vertex: 0, .. }));
    }
}

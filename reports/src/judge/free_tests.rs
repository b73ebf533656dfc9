//! Planted falsely free points: holes dug at a known depth, cells that should not be there, and regions for which the
//! measures have a closed form.

use super::*;
use crate::bridge::plain;
use crate::cases::shape::{disc, polygon, rectangle, region};
use crate::engine::Engine;
use crate::engine::own::Own;
use arcsum::region::{Node, Region};
use arcsum::sum::Convolution;
use arcsum_oracle::certified::depth::Summed;
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::error::Budget;

/// What the tests find about an answer to the sum of two discs of radius 1 and 1/2, in a unit box of side 2.
fn found(answer: &Answer, mu: f64) -> Findings {
    let reference = Reference::new(&plain(&disc(1.0)), &plain(&disc(0.5)), 2.0, Budget::default()).unwrap();
    test(&Depths::new(reference.summed()).unwrap(), answer, mu, 2.0, 4).unwrap()
}

/// The same for the sum of a rectangle of width 4 and height 2 and a unit square, polygons in a unit box of side 4.
fn found_polygonal(answer: &Answer, mu: f64) -> Findings {
    let [a, b] = [[4.0, 2.0], [1.0, 1.0]].map(|corner| plain(&polygon(&rectangle([0.0, 0.0], corner))));
    let exact = arcsum_oracle::polygon::sum(&a, &b).unwrap();
    let summed = Summed::of_polygons([&a, &b], &exact, 4.0).unwrap();
    test(&Depths::new(&summed).unwrap(), answer, mu, 4.0, 8).unwrap()
}

fn shown(free: bool, inside: &[[f64; 2]]) -> Answer {
    let cell = Cell { free, inside: inside.to_vec(), corners: Vec::new() };
    let cells = Cells { origin: [[0.25, 0.0], [0.0, -0.25]], cells: vec![cell], left_out: 0 };
    Answer { region: disc(1.5), cells: Some(cells), ..Answer::default() }
}

/// An answer of that region alone.
fn only(region: Region) -> Answer {
    Answer { region, ..Answer::default() }
}

/// The region with a rectangular hole.
fn dug(outer: Region, from: [f64; 2], to: [f64; 2]) -> Region {
    let hole = rectangle(from, to).iter().rev().map(|&[x, y]| Node::line(x, y)).collect();
    region([outer.loops, vec![hole]].concat())
}

/// Whether a bracket holds the truth and is no wider than 1/32 of it.
fn holds(bracket: Greatest, truth: f64) -> bool {
    let (Some(lo), Some(hi)) = (bracket.lo, bracket.hi) else { return false };
    let slack = 1e-15;
    lo <= truth + slack && truth - slack <= hi && hi <= 1.032 * lo + slack
}

#[test]
fn a_right_answer_has_nothing_falsely_free() {
    let answer = Own::new(Convolution::Kinetic).sum(&disc(1.0), &disc(0.5)).unwrap();
    let mu = libm::scalbn(1.0, -50);
    let findings = found(&answer, mu);
    assert_eq!((findings.falsely_free, findings.bubbles, findings.cracks), (0, Some(0), Some(0)), "{findings:?}");
    assert!(findings.rho.hi.is_some_and(|rho| rho < mu) && findings.trap.is_some_and(|trap| trap < libm::sqrt(mu)));
    assert_eq!((findings.tested, findings.open), (4, 0), "{findings:?}");
    assert_eq!(findings.falsely_blocked, Some(0), "{findings:?}");
}

#[test]
fn a_planted_bubble_is_found_and_measured() {
    // The point (0.6, 0) of the unit box, where the discs of radius 1/2 and 1/4 overlap by 3/20.
    let findings = found(&shown(true, &[[0.35, 0.25]]), 1e-15);
    assert_eq!((findings.bubbles, findings.cracks, findings.falsely_free), (Some(1), Some(0), 1));
    assert!(holds(findings.rho, 0.075) && holds(findings.pd, 0.15), "{findings:?}");
    // A lens is higher than any disc in it.
    assert!(findings.trap > findings.rho.lo, "{findings:?}");
}

#[test]
fn a_planted_crack_is_one_and_an_innocent_point_is_none() {
    let (deep, free) = ([0.35, 0.25], [0.7, 0.25]);
    let crack = found(&shown(true, &[deep, free]), 1e-15);
    assert_eq!((crack.bubbles, crack.cracks, crack.falsely_free), (Some(0), Some(1), 1));
    let innocent = found(&shown(true, &[deep, free]), 0.2);
    assert_eq!((innocent.bubbles, innocent.cracks, innocent.falsely_free), (Some(0), Some(0), 0));
    assert!(innocent.innocent >= 1 && holds(innocent.rho, 0.075), "{innocent:?}");
    // Between rho = 0.075 and pd = 0.15 these tests do not tell.
    let between = found(&shown(true, &[deep, free]), 0.1);
    assert_eq!((between.falsely_free, between.innocent, between.open, between.cracks), (0, 0, 1, Some(1)));
}

#[test]
fn a_free_point_of_a_blocked_cell_is_falsely_blocked() {
    let findings = found(&shown(false, &[[0.35, 0.25], [0.7, 0.25]]), 1e-15);
    assert_eq!((findings.falsely_blocked, findings.falsely_free), (Some(1), 0));
}

#[test]
fn a_hole_in_a_disc_is_as_deep_as_it_was_dug() {
    for reach in [0.2, 0.1, 1e-3] {
        let findings = found(&only(dug(disc(1.5), [-reach, -reach], [reach, reach])), 0.01);
        assert_eq!((findings.falsely_free, findings.bubbles), (8, None), "{findings:?}");
        // The middles of its sides are nearest to the origin; the small disc is inside the large one there.
        assert!(holds(findings.pd, 0.5 * (1.5 - reach)) && holds(findings.rho, 0.25), "{findings:?}");
    }
    let whole = found(&only(disc(1.5)), 0.01);
    assert!(whole.falsely_free == 0 && whole.pd.hi.is_some_and(|pd| pd < 1e-15), "{whole:?}");
}

#[test]
fn a_hole_in_a_polygon_is_as_deep_as_it_was_dug() {
    let sum = || polygon(&rectangle([0.0, 0.0], [5.0, 3.0]));
    for depth in [0.5, 0.125, libm::scalbn(1.0, -20), libm::scalbn(1.0, -45)] {
        // A slit along the lower side: where it is deepest, the square reaches by twice the depth into the rectangle.
        let findings = found_polygonal(&only(dug(sum(), [2.0, depth], [3.0, 2.0 * depth])), 1e-17);
        assert!(holds(findings.pd, 0.25 * 2.0 * depth), "{depth:e} {findings:?}");
        assert!(holds(findings.rho, 0.125 * (2.0 * depth).min(1.0)), "{depth:e} {findings:?}");
        assert!(findings.trap.is_some_and(|trap| (trap - 0.25 * (2.0 * depth).min(1.0)).abs() < 1e-15), "{findings:?}");
        assert_eq!((findings.falsely_free, findings.open, findings.innocent), (8, 0, 0), "{findings:?}");
    }
    let whole = found_polygonal(&only(sum()), 0.0);
    assert_eq!((whole.tested, whole.falsely_free, whole.open), (8, 0, 0), "{whole:?}");
}

#[test]
fn the_sum_of_other_regions_does_not_pass() {
    // A hole that belongs there: the check of a hole fails if the regions are taken for others.
    let ring = dug(polygon(&rectangle([0.0, 0.0], [4.0, 3.0])), [1.0, 0.5], [3.0, 2.5]);
    let square = polygon(&rectangle([0.0, 0.0], [1.0, 1.0]));
    let answer = Own::new(Convolution::Kinetic).sum(&ring, &square).unwrap();
    let findings = |a: &Region| {
        let [a, b] = [a, &square].map(plain);
        let exact = arcsum_oracle::polygon::sum(&a, &b).unwrap();
        let summed = Summed::of_polygons([&a, &b], &exact, 4.0).unwrap();
        test(&Depths::new(&summed).unwrap(), &answer, 1e-15, 4.0, 12).unwrap()
    };
    let right = findings(&ring);
    assert_eq!(
        (right.falsely_free, right.bubbles, right.cracks, right.falsely_blocked),
        (0, Some(0), Some(0), Some(0))
    );
    let filled = findings(&polygon(&rectangle([0.0, 0.0], [4.0, 3.0])));
    assert!(filled.falsely_free > 0 && filled.bubbles == Some(1), "{filled:?}");
    assert!(filled.rho.lo.is_some_and(|rho| rho > 0.1), "{filled:?}");
}

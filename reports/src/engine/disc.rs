//! Discs among regions: what an engine that only offsets can add.

use arcsum::arc::{Arc, radius_of_bulge};
use arcsum::region::{Curve, Node, Region};
use glam::DVec2;

/// How far centre and radius of its arcs may differ, in radii: a circle of three arcs or more has rounded corners, and what
/// rounding does to an arc of sweep s moves its centre by eps/s. This allows for sweeps down to a degree or two. What is
/// within counts as a disc, and the difference as the engine's error.
const SLACK: f64 = 1.0 / (1_u64 << 44) as f64;

/// A disc, in the units of the region it was found in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Its centre.
    pub centre: DVec2,
    /// Its radius, positive.
    pub radius: f64,
}

impl Disc {
    /// The disc that a region is: one loop of counter-clockwise arcs of one circle. None if it is something else.
    #[must_use]
    pub fn of(region: &Region) -> Option<Self> {
        let [nodes] = &region.loops[..] else { return None };
        if region.unbounded || nodes.len() < 2 {
            return None;
        }
        let circles = (0..nodes.len()).map(|i| circle(&nodes[i], &nodes[(i + 1) % nodes.len()]));
        let circles = circles.collect::<Option<Vec<Self>>>()?;
        let first = circles[0];
        let same = |other: &Self| {
            let slack = SLACK * first.radius;
            (other.radius - first.radius).abs() <= slack && other.centre.distance(first.centre) <= slack
        };
        circles.iter().all(same).then_some(first)
    }
}

/// The circle of a counter-clockwise arc.
fn circle(from: &Node, to: &Node) -> Option<Disc> {
    let (tail, head) = (DVec2::new(from.x, from.y), DVec2::new(to.x, to.y));
    let bulge = bulge(tail, head, from.curve).filter(|bulge| *bulge > 0.0)?;
    let radius = radius_of_bulge(tail, head, bulge).ok()?;
    let chord = head - tail;
    let centre = tail + 0.5 * chord + (1.0 - bulge * bulge) / (4.0 * bulge) * chord.perp();
    (radius.is_finite() && centre.is_finite()).then_some(Disc { centre, radius })
}

/// The bulge of a curve between two points; none for an arc that cannot be.
#[must_use]
pub fn bulge(tail: DVec2, head: DVec2, curve: Curve) -> Option<f64> {
    match curve {
        Curve::Line => Some(0.0),
        Curve::Bulge(bulge) => Some(bulge),
        Curve::Radius(r) => Arc::with_radius(tail, head, r).ok().map(|arc| libm::tan(arc.delta() / 2.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{disc, polar, polygon, rectangle, region};
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    fn moved(mut region: Region, by: [f64; 2]) -> Region {
        region.loops.iter_mut().flatten().for_each(|node| (node.x, node.y) = (node.x + by[0], node.y + by[1]));
        region
    }

    proptest! {
        #[test]
        fn a_circle_cut_anywhere_is_a_disc(radius in 0.1_f64..9.0, turns in prop::collection::vec(0.05_f64..1.0, 2..9), by_radius: bool) {
            let scale = TAU / turns.iter().sum::<f64>();
            prop_assume!(!by_radius || turns.iter().all(|turn| turn * scale < 3.0));
            let mut angle = 0.0;
            let nodes = turns.iter().map(|turn| {
                let [x, y] = polar(radius, angle);
                angle += turn * scale;
                let curve = if by_radius { Curve::Radius(radius) } else { Curve::Bulge(libm::tan(turn * scale / 4.0)) };
                Node { x, y, curve }
            });
            let found = Disc::of(&region(vec![nodes.collect()]));
            prop_assert!(found.is_some_and(|found| (found.radius - radius).abs() < 1e-13 && found.centre.length() < 1e-13), "{found:?}");
        }
    }

    #[test]
    fn a_disc_is_found_where_it_is() {
        let found = Disc::of(&moved(disc(2.0), [3.0, -1.0])).unwrap();
        assert_eq!(found, Disc { centre: DVec2::new(3.0, -1.0), radius: 2.0 });
    }

    #[test]
    fn others_are_none() {
        let [a, b] = [[-1.0, 0.0], [1.0, 0.0]].map(|[x, y]| Node { x, y, curve: Curve::Bulge(0.9) });
        let lens = region(vec![vec![a, b]]);
        let mut grown = disc(1.0);
        grown.loops[0][0].curve = Curve::Bulge(1.0 + 1e-12);
        let two = region([disc(1.0), moved(disc(1.0), [3.0, 0.0])].map(|r| r.loops[0].clone()).to_vec());
        for other in [
            &lens,
            &grown,
            &two,
            &disc(1.0).complement(),
            &polygon(&rectangle([0.0, 0.0], [1.0, 1.0])),
            &Region::plane(),
        ] {
            assert_eq!(Disc::of(other), None, "{other:?}");
        }
    }
}

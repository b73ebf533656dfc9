//! An edge to be drawn: a line or a circle segment by its ends and its bulge, tan(sweep/4), however the file gave it.

use arcsum::region::{Curve, Node, Region};

/// A point, or a vector, in whatever unit its edge is in.
pub type Point = [f64; 2];

/// A directed line (bulge 0) or circle segment, counter-clockwise where the bulge is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// Where it begins.
    pub tail: Point,
    /// Where it ends.
    pub head: Point,
    /// tan(sweep/4).
    pub bulge: f64,
}

impl Edge {
    /// The edge from one vertex of a loop to the next.
    pub fn between(tail: &Node, head: &Node) -> Self {
        let (p, q) = ([tail.x, tail.y], [head.x, head.y]);
        Self { tail: p, head: q, bulge: bulge(tail.curve, distance(p, q)) }
    }

    /// A segment of a convolution as its record has it.
    pub fn from_numbers([x0, y0, x1, y1, bulge]: [f64; 5]) -> Self {
        Self { tail: [x0, y0], head: [x1, y1], bulge }
    }

    /// The distance of its ends.
    pub fn chord(&self) -> f64 {
        distance(self.tail, self.head)
    }

    /// The height of the bow over the chord.
    pub fn sagitta(&self) -> f64 {
        self.bulge.abs() * self.chord() / 2.0
    }

    /// The radius of the circle; infinite for a line.
    pub fn radius(&self) -> f64 {
        let b = self.bulge.abs();
        self.chord() / 4.0 * (1.0 / b + b)
    }

    /// The two halves of equal length.
    pub fn halves(&self) -> [Self; 2] {
        let [dx, dy] = [self.head[0] - self.tail[0], self.head[1] - self.tail[1]];
        // A counter-clockwise arc bows to the right of its direction, (dy, -dx).
        let out = self.bulge / 2.0;
        let middle = [self.tail[0] + dx / 2.0 + out * dy, self.tail[1] + dy / 2.0 - out * dx];
        // tan(x/2) = tan x / (1 + sec x); hypot does not overflow where the square of a huge bulge would.
        let bulge = self.bulge / (1.0 + self.bulge.hypot(1.0));
        [Self { tail: self.tail, head: middle, bulge }, Self { tail: middle, head: self.head, bulge }]
    }

    /// Points along the edge, both ends included: two for a line, seventeen for an arc.
    pub fn samples(&self) -> Vec<Point> {
        let halvings = if self.bulge == 0.0 { 0 } else { 4 };
        let mut parts = vec![*self];
        for _ in 0..halvings {
            parts = parts.iter().flat_map(Self::halves).collect();
        }
        std::iter::once(self.tail).chain(parts.iter().map(|e| e.head)).collect()
    }
}

/// The edges of a loop, closing edge included.
pub fn of_loop(nodes: &[Node]) -> impl Iterator<Item = Edge> + '_ {
    (0..nodes.len()).map(|i| Edge::between(&nodes[i], &nodes[(i + 1) % nodes.len()]))
}

/// The edges of a region.
pub fn of_region(region: &Region) -> impl Iterator<Item = Edge> + '_ {
    region.loops.iter().flat_map(|nodes| of_loop(nodes))
}

/// The bulge of a curve over a chord. A radius is that of the minor arc, as the papers have it; one shorter than half
/// the chord is drawn as a half circle.
fn bulge(curve: Curve, chord: f64) -> f64 {
    match curve {
        Curve::Line => 0.0,
        Curve::Bulge(bulge) => bulge,
        Curve::Radius(radius) => {
            let sine = (chord / 2.0 / radius.abs()).min(1.0);
            (sine / (1.0 + (1.0 - sine * sine).sqrt())).copysign(radius)
        }
    }
}

fn distance(p: Point, q: Point) -> f64 {
    (q[0] - p[0]).hypot(q[1] - p[1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn node(x: f64, y: f64, curve: Curve) -> Node {
        Node { x, y, curve }
    }

    #[test]
    fn radius_and_bulge_agree() {
        let head = Node::line(1.0, 1.0);
        let by_radius = Edge::between(&node(1.0, 0.0, Curve::Radius(-0.5)), &head);
        assert_eq!(by_radius.bulge, -1.0);
        let quarter = Edge::between(&node(1.0, 0.0, Curve::Radius(1.0)), &Node::line(0.0, 1.0));
        assert!((quarter.bulge - (std::f64::consts::PI / 8.0).tan()).abs() < 1e-15);
        assert!((quarter.radius() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn half_circle_to_the_right() {
        let [first, second] = Edge { tail: [0.0, 0.0], head: [2.0, 0.0], bulge: 1.0 }.halves();
        assert_eq!(first.head, [1.0, -1.0]);
        assert_eq!(second.tail, first.head);
    }

    #[test]
    fn huge_bulge_halves_to_half_circles() {
        let [first, _] = Edge { tail: [0.0, 0.0], head: [1e-300, 0.0], bulge: 1e300 }.halves();
        assert_eq!(first.bulge, 1.0);
        assert_eq!(first.head, [5e-301, -0.5]);
    }

    proptest! {
        /// All samples lie on the circle through the ends whose centre the bulge fixes.
        #[test]
        fn samples_lie_on_one_circle(
            x in -10.0..10.0_f64, y in -10.0..10.0_f64, bulge in prop_oneof![-50.0..-0.01, 0.01..50.0_f64],
        ) {
            let edge = Edge { tail: [0.0, 0.0], head: [x, y], bulge };
            prop_assume!(edge.chord() > 0.1);
            // Centre: on the left of the chord at (1 - b^2) / (4 b) chords from its middle.
            let off = (1.0 - bulge * bulge) / (4.0 * bulge);
            let centre = [x / 2.0 - off * y, y / 2.0 + off * x];
            let radius = edge.radius();
            for p in edge.samples() {
                prop_assert!((distance(p, centre) - radius).abs() < 1e-9 * (1.0 + radius));
            }
        }
    }
}

//! Shortcuts: chords that may stand for stretches of a boundary where it is run backwards (ours; beside MS 5.2, memo E3).
//!
//! T segments only take away from the winding number O - F - T, and only where a concave turning point of one region lies in
//! the other, which is blocked. So T may be the boundary of any part of the moved region: the winding number stays 0
//! exactly where the regions do not meet, and positive elsewhere. A chord that leaves out what lies between it and the
//! boundary, all of it inside the region, serves as well as the boundary itself, and crosses less. T segments bound no
//! part of the sum, so accuracy does not depend on them.
//!
//! [`Shortcuts`] knows, for each vertex of each chain, to which of the next [`REACH`] vertices a chord runs inside the region,
//! away from the boundary between its ends.

use crate::chain::{Chain, Chains};
use crate::smooth::{Kind, Seg, Smooth};
use glam::DVec2;

/// How many vertices further a chord may end.
pub const REACH: usize = 64;

/// How far, vertically, in the unit box, a chord stays away from the boundary between its ends: many roundings, so that what is
/// left out lies inside the region wherever rounding puts the ends.
const CLEARANCE: f64 = 1e-9;

/// The chords of all chains of a region.
#[derive(Clone, Debug, Default)]
pub struct Shortcuts {
    /// For each chain and each of its vertices from left to right, whether a chord runs to the vertex that many further.
    chords: Vec<Vec<u64>>,
}

impl Shortcuts {
    /// The chords of the chains of a region.
    #[must_use]
    pub fn new(region: &Smooth, chains: &Chains) -> Self {
        let sides: Vec<Side> = chains.chains.iter().map(|chain| Side::new(region, chain)).collect();
        let chords = (0..sides.len()).map(|index| sides[index].chords(&sides, index)).collect();
        Self { chords }
    }

    /// The furthest vertex of a chain, no further than `to`, to which a chord runs from the vertex `from`, both counted from
    /// the left; the next one if there is none.
    #[must_use]
    pub fn furthest(&self, chain: usize, from: usize, to: usize) -> usize {
        let within = u64::MAX >> (REACH - (to - from).min(REACH));
        let reached = self.chords[chain][from] & within;
        from + reached.checked_ilog2().map_or(1, |bit| bit as usize + 1)
    }
}

/// A chain from left to right, upside down if it is a lower one: the region lies below it.
struct Side {
    upper: bool,
    vertices: Vec<DVec2>,
    /// For each edge that is an arc where the tangents at its ends meet: it lies in the triangle with its ends.
    controls: Vec<Option<DVec2>>,
}

/// An edge of a side.
#[derive(Clone, Copy)]
struct Edge {
    left: DVec2,
    right: DVec2,
    control: Option<DVec2>,
}

impl Side {
    fn new(region: &Smooth, chain: &Chain) -> Self {
        let segs = chain.links.iter().map(|link| &link.seg).filter(|seg| seg.kind != Kind::Turn);
        let edge = |seg: &Seg| {
            let [tail, head] = [seg.tail, seg.head].map(|v| region.points[v as usize]);
            let half = 0.5 * (head - tail);
            let control = tail + half - half.perp() * libm::tan(seg.delta);
            let control = (seg.kind == Kind::Arc).then_some(control);
            let edge = Edge { left: tail, right: head, control };
            if chain.upper { Edge { left: head, right: tail, ..edge } } else { edge.upside_down() }
        };
        let mut edges: Vec<Edge> = segs.map(edge).collect();
        if chain.upper {
            edges.reverse();
        }
        let ends = edges.last().map(|edge| edge.right);
        Self {
            upper: chain.upper,
            vertices: edges.iter().map(|edge| edge.left).chain(ends).collect(),
            controls: edges.iter().map(|edge| edge.control).collect(),
        }
    }

    fn edge(&self, index: usize) -> Edge {
        Edge { left: self.vertices[index], right: self.vertices[index + 1], control: self.controls[index] }
    }

    /// For each vertex the vertices to which chords run, of all sides this one.
    fn chords(&self, sides: &[Self], own: usize) -> Vec<u64> {
        let others = || sides.iter().enumerate().filter(|(index, _)| *index != own).map(|(_, side)| side);
        let floor = |index: usize| {
            let mut points = Vec::new();
            others().for_each(|side| side.floor(self.edge(index), self.upper, &mut points));
            points.sort_unstable_by(|p, q| p.x.total_cmp(&q.x));
            points
        };
        let floors: Vec<Vec<DVec2>> = (0..self.controls.len()).map(floor).collect();
        (0..self.vertices.len()).map(|from| self.chords_from(from, &floors)).collect()
    }

    /// Where a chord from a vertex may go so as to pass below the edges of the side and above what is below them.
    fn chords_from(&self, from: usize, floors: &[Vec<DVec2>]) -> u64 {
        let mut cone = Cone { apex: self.vertices[from], least: f64::NEG_INFINITY, most: f64::INFINITY };
        let mut chords = 0;
        let last = (self.vertices.len() - 1).min(from + REACH);
        for to in from + 1..=last {
            let (edge, end) = (self.edge(to - 1), self.vertices[to]);
            cone.pass_below(edge.left);
            edge.control.into_iter().for_each(|control| cone.pass_below(control));
            // What lies right below the end of a chord does not stop it there, only further ones.
            let floor = &floors[to - 1];
            let (before, beside) = floor.split_at(floor.partition_point(|point| point.x < end.x));
            before.iter().for_each(|point| cone.pass_above(*point));
            if cone.least >= cone.most {
                break;
            }
            if to > from + 1 && cone.contains(end) {
                chords |= 1 << (to - from - 1);
            }
            beside.iter().for_each(|point| cone.pass_above(*point));
        }
        chords
    }

    /// Adds the points of this side that a chord must stay above where it passes an edge of another side, given which way up that
    /// one is. What is above the edge is left out.
    fn floor(&self, edge: Edge, upper: bool, points: &mut Vec<DVec2>) {
        let (from, to) = (edge.left.x, edge.right.x);
        let first = self.vertices.partition_point(|v| v.x < from).max(1) - 1;
        let near = (first..self.controls.len()).take_while(|index| self.vertices[*index].x <= to);
        for own in near.map(|index| self.edge(index)) {
            let own = if upper == self.upper { own } else { own.upside_down() };
            let common = [own.left.x.max(from), own.right.x.min(to)];
            let is_vertical = own.left.x == own.right.x;
            let overlap = if is_vertical { common[0] <= common[1] } else { common[0] < common[1] };
            if from < to && overlap && !own.is_above(edge, 0.5 * (common[0] + common[1])) {
                own.upper_points(common, points);
            }
        }
    }
}

impl Edge {
    fn upside_down(self) -> Self {
        let turned = |p: DVec2| DVec2::new(p.x, -p.y);
        Self { left: turned(self.left), right: turned(self.right), control: self.control.map(turned) }
    }

    /// The ordinate at an abscissa of the chord, and of the two tangents.
    fn bounds(self, x: f64) -> [f64; 2] {
        let between = |p: DVec2, q: DVec2| {
            let way = q.x - p.x;
            match x {
                _ if way == 0.0 => p.y.max(q.y),
                x if x <= p.x => p.y,
                x if x >= q.x => q.y,
                x => p.y + (q.y - p.y) * ((x - p.x) / way),
            }
        };
        let chord = between(self.left, self.right);
        let tangent = match self.control {
            None => chord,
            Some(control) if x < control.x => between(self.left, control),
            Some(control) => between(control, self.right),
        };
        [chord, tangent]
    }

    /// Whether this is for certain above another edge that it does not cross, given a common abscissa.
    fn is_above(self, other: Self, x: f64) -> bool {
        let [own, other] = [self.bounds(x), other.bounds(x)];
        let lowest = if self.left.x == self.right.x { self.left.y.min(self.right.y) } else { own[0].min(own[1]) };
        lowest > other[0].max(other[1]) + CLEARANCE
    }

    /// The points between two abscissas that what is above all of them has this edge below it.
    fn upper_points(self, [from, to]: [f64; 2], points: &mut Vec<DVec2>) {
        let at = |x: f64| {
            let [chord, tangent] = self.bounds(x);
            DVec2::new(x, chord.max(tangent))
        };
        points.extend([at(from), at(to)]);
        points.extend(self.control.filter(|control| from < control.x && control.x < to));
    }
}

/// The directions in which a chord may leave a vertex to the right.
struct Cone {
    apex: DVec2,
    least: f64,
    most: f64,
}

impl Cone {
    fn slope(&self, p: DVec2, clearance: f64) -> f64 {
        (p.y + clearance - self.apex.y) / (p.x - self.apex.x)
    }

    fn pass_below(&mut self, p: DVec2) {
        if p.x > self.apex.x {
            self.most = self.most.min(self.slope(p, -CLEARANCE));
        } else if p.y < self.apex.y {
            self.most = f64::NEG_INFINITY;
        }
    }

    fn pass_above(&mut self, p: DVec2) {
        if p.x > self.apex.x {
            self.least = self.least.max(self.slope(p, CLEARANCE));
        } else if p.y > self.apex.y {
            self.least = f64::INFINITY;
        }
    }

    fn contains(&self, p: DVec2) -> bool {
        p.x > self.apex.x && (self.least..=self.most).contains(&self.slope(p, 0.0))
    }
}

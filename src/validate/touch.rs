//! Touches: points where two parts of a boundary come together. Tells which of them are crossings, and whether touching
//! loops cut the interior (memo A8).
//!
//! At a touch four arms leave: back and forward along either part. The parts cross if the arms alternate around the
//! point. Between lines the far ends of the arms decide that exactly. Where an arm is curved, points on the arms at
//! shrinking distances do, and a crossing counts only if at one of them the arms alternate with clear gaps.

use super::Invalid;
use super::boundary::Boundary;
use super::nesting::Nesting;
use crate::exact::orientation;
use glam::DVec2;
use std::cmp::Ordering::{Equal, Greater, Less};
use std::collections::{HashMap, HashSet};

/// Arms are examined no closer than this many tolerances.
const CLOSEST: f64 = 16.0;

/// Arms that are apart by this many tolerances are apart clearly.
const CLEAR: f64 = 4.0;

/// A place on the boundary: a part and the share of its length from the tail.
#[derive(Clone, Copy, Debug)]
pub struct Spot {
    /// Index of the part.
    pub part: usize,
    /// 0 at the tail, 1 at the head.
    pub share: f64,
}

/// A point where two parts come together.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    /// The point, on the grid.
    pub at: DVec2,
    /// Where it is on either part.
    pub spots: [Spot; 2],
    /// Whether the parts share the point exactly, and not only within the tolerance.
    pub exact: bool,
}

impl Touch {
    /// The loops of the two parts.
    pub fn loops(&self, boundary: &Boundary) -> [usize; 2] {
        self.spots.map(|spot| boundary.loop_of(spot.part))
    }

    /// Whether the parts pass through each other here: exact between lines, else only if clearly so.
    pub fn crosses(&self, boundary: &Boundary) -> bool {
        let alternate = |[back, forward, other_back, other_forward]: [DVec2; 4]| {
            let left = |arm| in_cone(self.at, forward, back, arm);
            left(other_back) != left(other_forward)
        };
        self.arms(boundary).any(alternate)
    }

    /// Whether the second part, or the first if `swapped`, leaves the touch to the left of the other.
    pub fn leaves_left(&self, boundary: &Boundary, swapped: bool) -> bool {
        let arms = self.arms(boundary).last().unwrap_or([self.at; 4]);
        let [back, forward, leaving] = if swapped { [arms[2], arms[3], arms[1]] } else { [arms[0], arms[1], arms[3]] };
        in_cone(self.at, forward, back, leaving)
    }

    /// Points on the four arms, back and forward on the first part and on the second, in which the arms are clearly apart;
    /// from far to near.
    fn arms(&self, boundary: &Boundary) -> impl Iterator<Item = [DVec2; 4]> {
        let [a, b] = self.spots.map(|spot| arms_of(boundary, spot));
        let arms = [a[0], a[1], b[0], b[1]];
        let tolerance = boundary.tolerance;
        let straight = arms.iter().all(|arm| boundary.parts[arm.part].is_line());
        let shortest = arms.iter().map(|arm| arm.length).fold(f64::INFINITY, f64::min);
        let radii = std::iter::successors(Some(shortest / 2.0), |r| Some(r / 2.0));
        let near = radii.take_while(move |&r| r > CLOSEST * tolerance).take(if straight { 0 } else { usize::MAX });
        let samples = near.map(move |r| arms.map(|arm| arm.point(boundary, r))).filter(move |points| {
            let apart = |p: DVec2, q: DVec2| p.distance(q) > CLEAR * tolerance;
            points[..2].iter().all(|&p| points[2..].iter().all(|&q| apart(p, q)))
        });
        let ends = straight.then(|| arms.map(|arm| arm.end(boundary)));
        ends.into_iter().chain(samples)
    }
}

/// One way to leave a spot.
#[derive(Clone, Copy)]
struct Arm {
    part: usize,
    from: f64,
    forward: bool,
    length: f64,
}

impl Arm {
    fn new(boundary: &Boundary, part: usize, from: f64, forward: bool) -> Self {
        let share = if forward { 1.0 - from } else { from };
        Self { part, from, forward, length: share * boundary.parts[part].length }
    }

    fn point(self, boundary: &Boundary, distance: f64) -> DVec2 {
        let part = &boundary.parts[self.part];
        let step = distance / part.length;
        part.point(if self.forward { self.from + step } else { self.from - step })
    }

    fn end(self, boundary: &Boundary) -> DVec2 {
        let part = &boundary.parts[self.part];
        if self.forward { part.head } else { part.tail }
    }
}

/// The arms back and forward. A spot at an end of its part continues on the neighbour.
fn arms_of(boundary: &Boundary, spot: Spot) -> [Arm; 2] {
    let back = match spot.share {
        0.0 => Arm::new(boundary, boundary.previous(spot.part), 1.0, false),
        share => Arm::new(boundary, spot.part, share, false),
    };
    let forward = match spot.share {
        1.0 => Arm::new(boundary, boundary.next(spot.part), 0.0, true),
        share => Arm::new(boundary, spot.part, share, true),
    };
    [back, forward]
}

/// Whether a point lies strictly inside the cone swept counter-clockwise around the apex from one point to another.
fn in_cone(apex: DVec2, from: DVec2, to: DVec2, point: DVec2) -> bool {
    let side = |p, q| orientation(apex, p, q);
    match side(from, to) {
        Greater => side(from, point) == Greater && side(point, to) == Greater,
        Less => side(to, point) == Less || side(point, from) == Less,
        Equal => side(from, point) == Greater,
    }
}

/// Checks that the touches leave the interior of each part of the region connected: in the graph of its loops and their
/// touching points no cycle may close.
pub fn check(boundary: &Boundary, touches: &[Touch], nesting: &Nesting<'_>) -> Result<(), Invalid> {
    let mut groups = Groups::new(boundary.loops.len());
    let (mut points, mut seen) = (HashMap::new(), HashSet::new());
    for touch in touches.iter().filter(|t| t.exact) {
        let loops = touch.loops(boundary);
        let parts = loops.map(|l| nesting.component(l));
        if parts[0] != parts[1] {
            continue;
        }
        // Several parts of a region may touch in one point; each has its own.
        let key = (parts[0], touch.at.x.to_bits(), touch.at.y.to_bits());
        let point = *points.entry(key).or_insert_with(|| groups.add());
        for loop_index in loops {
            if seen.insert((loop_index, point)) && !groups.join(loop_index, point) {
                let at = boundary.grid.unscale_point(touch.at);
                return Err(Invalid::CutInterior { loop_index, x: at.x, y: at.y });
            }
        }
    }
    Ok(())
}

/// Disjoint groups of loops and points.
struct Groups {
    parent: Vec<usize>,
}

impl Groups {
    fn new(count: usize) -> Self {
        Self { parent: (0..count).collect() }
    }

    fn add(&mut self) -> usize {
        self.parent.push(self.parent.len());
        self.parent.len() - 1
    }

    fn root(&mut self, mut member: usize) -> usize {
        while self.parent[member] != member {
            self.parent[member] = self.parent[self.parent[member]];
            member = self.parent[member];
        }
        member
    }

    /// Joins two groups; `false` if they are one already.
    fn join(&mut self, one: usize, other: usize) -> bool {
        let (one, other) = (self.root(one), self.root(other));
        self.parent[one] = other;
        one != other
    }
}

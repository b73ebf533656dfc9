//! A convex plate with two arcs, two lines, a round hole and a lens-shaped one, and the errors that can be planted in it.
//!
//! Every error stays far from the others, so that the greatest of several is the distance.

use super::truth::{Reaches, Truth, beyond, discs, distance, float, lack, length, one, step, surplus};
use crate::common::disc;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use proptest::prelude::*;
use rug::Float;

type Point = (f64, f64);

/// A plate about the unit square: arcs from its first corner to the second and from the last to the first.
#[derive(Clone, Debug)]
pub struct Plate {
    corners: [Point; 4],
    /// Of the lower arc, up to 0.4, and of the left one.
    bulges: [f64; 2],
    /// Left and right end and ordinate of the round hole.
    round: (f64, f64, f64),
    /// The ends of the lens.
    lens: [Point; 2],
    /// The bulge of both its sides.
    thickness: f64,
}

/// An error in a plate. Sizes are powers of two.
#[derive(Clone, Debug)]
pub enum Error {
    /// The third corner moves in a direction, as multiples of 1/8 of the two edges' outward normals.
    Corner { size: f64, normals: [i32; 2] },
    /// The lower arc turns inside out.
    Flip,
    /// The bulge of the lower arc changes.
    Bend { change: f64 },
    /// The round hole is lost.
    LoseRound,
    /// The lens is lost.
    LoseLens,
    /// The ends of the round hole move to the right and both up.
    MoveRound { ends: [f64; 2], up: f64 },
    /// A new round hole, with its radius.
    Bubble { radius: f64, at: Point },
    /// A new hole with parallel sides and this width.
    Slot { width: f64, at: Point, length: f64 },
    /// A disc cut loose by a ring of this width.
    Ring { width: f64, at: Point },
    /// A notch of this width in the upper right edge, which is as deep as this part of the edge.
    Slit { width: f64, depth: f64 },
    /// A disc beyond the left arc: its radius, its distance to the arc and the part of the chord it is beside.
    Island { radius: f64, gap: f64, along: f64 },
}

/// Random plates.
pub fn plates() -> impl Strategy<Value = Plate> {
    let near = |x: f64, y: f64| (x - 0.05..x + 0.05, y - 0.05..y + 0.05);
    let corners = (near(0.0, 0.0), near(1.0, 0.0), near(1.0, 1.0), near(0.0, 1.0));
    let round = (0.2..0.25f64, 0.3..0.4f64, 0.5..0.6f64);
    let lens = ((0.53..0.57f64, 0.53..0.57f64), (0.73..0.77f64, 0.58..0.62f64));
    let bulges = [0.02..0.4f64, 0.02..0.15];
    (corners, any::<bool>(), bulges, round, lens, 0.01..1.0f64).prop_map(
        |(corners, upright, bulges, round, lens, thickness)| {
            let (p, q, mut r, s) = corners;
            if upright {
                r.0 = q.0;
            }
            Plate { corners: [p, q, r, s], bulges, round, lens: [lens.0, lens.1], thickness }
        },
    )
}

/// Random errors, by where they are, from 2^-10 to 2^-50.
pub mod errors {
    use super::*;

    fn size() -> impl Strategy<Value = f64> {
        (10i32..=50).prop_map(|k| 2f64.powi(-k))
    }

    /// A place for something new among the holes.
    fn place() -> impl Strategy<Value = Point> {
        (0.3..0.6f64, 0.8..0.86f64)
    }

    pub fn vertex() -> impl Strategy<Value = Error> {
        let normals =
            ([0i32..=8, 0..=8], any::<bool>()).prop_map(|(n, outward)| n.map(|i| if outward { i } else { -i }));
        (size(), normals).prop_map(|(size, normals)| Error::Corner { size, normals })
    }

    pub fn arc() -> impl Strategy<Value = Error> {
        prop_oneof![1 => Just(Error::Flip), 3 => (size(), -8i32..8).prop_map(|(size, i)| Error::Bend { change: size * f64::from(i) })]
    }

    pub fn hole() -> impl Strategy<Value = Error> {
        let moved = (size(), [-4i32..5, -4..5, -4..5]).prop_map(|(size, [a, b, c])| {
            let [a, b, up] = [a, b, c].map(|i| f64::from(i) * size);
            Error::MoveRound { ends: [a, b], up }
        });
        prop_oneof![1 => Just(Error::LoseRound), 1 => Just(Error::LoseLens), 4 => moved]
    }

    pub fn bubble() -> impl Strategy<Value = Error> {
        prop_oneof![
            (size(), place()).prop_map(|(radius, at)| Error::Bubble { radius, at }),
            (size(), place(), 0.01..0.1f64).prop_map(|(width, at, length)| Error::Slot { width, at, length }),
            (size(), place()).prop_map(|(width, at)| Error::Ring { width, at }),
            (size(), 0.05..0.1f64).prop_map(|(width, depth)| Error::Slit { width, depth }),
            (size(), -1.5..4.0f64, 0.3..0.7f64).prop_map(|(radius, gap, along)| Error::Island {
                radius,
                gap: radius * gap,
                along
            }),
        ]
    }
}

/// A region while it is changed, and how far it is from what it was.
struct Changed {
    region: PlainRegion,
    /// Indices of loops to be left out.
    lost: Vec<usize>,
    truth: Truth,
}

impl Plate {
    /// The plate without errors: the outline, the round hole, the lens.
    pub fn region(&self) -> PlainRegion {
        let bends = [Bend::Bulge(self.bulges[0]), Bend::Line, Bend::Line, Bend::Bulge(self.bulges[1])];
        let outline = self.corners.iter().zip(bends).map(|(&(x, y), bend)| Corner { x, y, bend }).collect();
        let lens = self.lens.map(|(x, y)| Corner { x, y, bend: Bend::Bulge(-self.thickness) }).to_vec();
        PlainRegion { loops: vec![outline, hole(self.round), lens], unbounded: false }
    }

    /// The plate with these errors; `None` if one of them is not what it should be, or two are not apart.
    pub fn with(&self, errors: &[Error]) -> Option<(PlainRegion, Truth)> {
        let on_edge = |error: &&Error| matches!(error, Error::Corner { .. } | Error::Slit { .. });
        if errors.iter().filter(on_edge).count() > 1 {
            return None;
        }
        let mut changed = Changed { region: self.region(), lost: Vec::new(), truth: Truth::none() };
        for error in errors {
            let reaches = self.plant(error, &mut changed)?;
            changed.truth = changed.truth.and(reaches);
        }
        changed.lost.iter().for_each(|&index| drop(changed.region.loops.remove(index)));
        Some((changed.region, changed.truth))
    }

    /// Plants an error and answers how far its surplus and its lack reach.
    fn plant(&self, error: &Error, changed: &mut Changed) -> Option<Reaches> {
        let loops = &mut changed.region.loops;
        let chord = distance(self.corners[0], self.corners[1]);
        match *error {
            Error::Corner { size, normals } => self.move_corner(size, normals, &mut loops[0]),
            Error::Flip => {
                loops[0][0].bend = Bend::Bulge(-self.bulges[0]);
                // Twice the sagitta, as long as the sweep is at most a right angle.
                Some(lack(chord * self.bulges[0]))
            }
            Error::Bend { change } => {
                let bulge = self.bulges[0] + change;
                loops[0][0].bend = Bend::Bulge(bulge);
                let exact = float(bulge) - self.bulges[0];
                Some(one(chord * exact.abs() / 2, change > 0.0))
            }
            Error::LoseRound | Error::LoseLens => Some(self.lose(error, changed)),
            Error::MoveRound { ends, up } => self.move_round(ends, up, &mut loops[1]),
            Error::Bubble { radius, at: (x, y) } => {
                let (left, right) = (x - radius, x + radius);
                loops.push(hole((left, right, y)));
                Some(lack((float(right) - left) / 2))
            }
            Error::Slot { width, at: (x, y), length } => {
                loops.push(ring([(x, y), (x, y + width), (x + length, y + width), (x + length, y)]));
                Some(lack((float(y + width) - y) / 2))
            }
            Error::Ring { width, at: (x, y) } => {
                const RADIUS: f64 = 0.0625;
                // A coordinate of few bits makes both circles concentric.
                let x = (x * 256.0).round() / 256.0;
                loops.push(hole((x - RADIUS, x + RADIUS, y)));
                loops.push(disc(x, y, RADIUS - width));
                Some(lack(float(width) / 2))
            }
            Error::Slit { width, depth } => self.slit(width, depth, &mut loops[0]),
            Error::Island { radius, gap, along } => self.island(radius, gap, along, loops),
        }
    }

    fn lose(&self, error: &Error, changed: &mut Changed) -> Reaches {
        if matches!(error, Error::LoseRound) {
            changed.lost.push(1);
            return surplus((float(self.round.1) - self.round.0) / 2);
        }
        changed.lost.push(2);
        surplus(distance(self.lens[0], self.lens[1]) * self.thickness / 2)
    }

    /// Outward the new corner is nearest to the old one if it is in its cone of normals, inward the other way round.
    fn move_corner(&self, size: f64, [a, b]: [i32; 2], outline: &mut [Corner]) -> Option<Reaches> {
        let [_, before, corner, after] = self.corners;
        let outward = |(x, y): Point, (z, w): Point| (w - y, x - z);
        let (m, n) = (outward(before, corner), outward(corner, after));
        let factors = [a, b].map(|i| f64::from(i) / 8.0 * size);
        let moved = (corner.0 + factors[0] * m.0 + factors[1] * n.0, corner.1 + factors[0] * m.1 + factors[1] * n.1);
        let grows = a >= 0 && b >= 0;
        let (kept, apex) = if grows { (corner, moved) } else { (moved, corner) };
        let way = step(kept, apex);
        let normal = [before, after].iter().all(|&end| {
            let edge = step(end, kept);
            dot(&edge, &way) >= 0
        });
        let [right, left] = [step(before, kept), step(kept, after)].map(|edge| cross(&edge, &way));
        if !normal || right > 0 || left > 0 || moved == corner {
            return None;
        }
        (outline[2].x, outline[2].y) = moved;
        Some(one(length(way), grows))
    }

    fn move_round(&self, [a, b]: [f64; 2], up: f64, hole: &mut [Corner]) -> Option<Reaches> {
        let (left, right, y) = self.round;
        let new = (left + a, right + b, y + up);
        for corner in hole.iter_mut() {
            corner.x = if corner.x == left { new.0 } else { new.1 };
            corner.y = new.2;
        }
        Some(discs(self.round, new))
    }

    /// A notch from the middle of the right edge, its walls parallel to one another: the third corner stays where it is.
    fn slit(&self, width: f64, depth: f64, outline: &mut Vec<Corner>) -> Option<Reaches> {
        let [_, from, to, _] = self.corners;
        // An upright edge: the mouth of the slit is on it exactly.
        if from.0 != to.0 {
            return None;
        }
        let y = 0.5 * (from.1 + to.1);
        let corner = |x: f64, y: f64| Corner { x, y, bend: Bend::Line };
        let notch =
            [corner(to.0, y), corner(to.0 - depth, y), corner(to.0 - depth, y + width), corner(to.0, y + width)];
        outline.splice(2..2, notch);
        Some(lack((float(y + width) - y) / 2))
    }

    fn island(&self, radius: f64, gap: f64, along: f64, loops: &mut Vec<Vec<Corner>>) -> Option<Reaches> {
        let (ends, bulge) = ([self.corners[3], self.corners[0]], self.bulges[1]);
        let [from, to] = ends;
        let chord = (to.0 - from.0, to.1 - from.1);
        let factor = (1.0 - bulge * bulge) / (4.0 * bulge);
        let centre = (0.5 * (from.0 + to.0) - chord.1 * factor, 0.5 * (from.1 + to.1) + chord.0 * factor);
        let foot = (from.0 + along * chord.0 - centre.0, from.1 + along * chord.1 - centre.1);
        let arm = (from.0 - centre.0).hypot(from.1 - centre.1) + gap + radius;
        let scale = arm / foot.0.hypot(foot.1);
        let (x, y) = (centre.0 + foot.0 * scale, centre.1 + foot.1 * scale);
        let disc = (x - radius, x + radius, y);
        let reach = beyond(disc, ends, bulge);
        if reach <= 0 || disc.0 == disc.1 {
            return None;
        }
        loops.push(round(disc));
        Some(surplus(reach))
    }
}

fn dot(a: &(Float, Float), b: &(Float, Float)) -> Float {
    a.0.clone() * &b.0 + a.1.clone() * &b.1
}

fn cross(a: &(Float, Float), b: &(Float, Float)) -> Float {
    a.0.clone() * &b.1 - a.1.clone() * &b.0
}

/// The disc over a diameter.
fn round((left, right, y): (f64, f64, f64)) -> Vec<Corner> {
    [left, right].map(|x| Corner { x, y, bend: Bend::Bulge(1.0) }).to_vec()
}

/// A round hole over a diameter.
fn hole((left, right, y): (f64, f64, f64)) -> Vec<Corner> {
    [left, right].map(|x| Corner { x, y, bend: Bend::Bulge(-1.0) }).to_vec()
}

/// A loop of lines.
fn ring(points: [Point; 4]) -> Vec<Corner> {
    points.map(|(x, y)| Corner { x, y, bend: Bend::Line }).to_vec()
}

//! The engine's kinetic convolution of a pair, piece by piece with its parents, and the points where to look at it.

use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::winding::winding;
use arcsum::convolution::kinetic;
use arcsum::frame::Frame;
use arcsum::piece::{Piece, Pieces};
use arcsum::smooth::{Kind, Seg, Smooth};
use arcsum::sum3::Rounding;
use arcsum_oracle::certified::characteristic::Characteristic;
use arcsum_oracle::certified::shape::Shape;
use arcsum_oracle::certified::spot::Spot;
use glam::DVec2;

/// A pair with its kinetic convolution.
pub(super) struct Convolved {
    frames: (Frame, Frame),
    smooth: [Smooth; 2],
    pub(super) pieces: Pieces,
}

/// A summand of a piece: convex (1) or concave (-1), and its signed radius: 0 for turns. A line is neither.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Parent {
    pub(super) sign: i32,
    pub(super) radius: f64,
}

impl Convolved {
    /// Convolves a pair of regions of one loop each.
    pub(super) fn new(case: &Case) -> Option<Self> {
        let single = [&case.a, &case.b].iter().all(|region| region.loops.len() == 1 && !region.unbounded);
        let frames = Frame::pair(&case.a, &case.b);
        let (a, b) = (Smooth::new(&case.a, &frames.0).ok()?, Smooth::new(&case.b, &frames.1).ok()?);
        let pieces = kinetic(&a, &b, Rounding::Correct).filter(|_| single)?;
        Some(Self { frames, smooth: [a, b], pieces })
    }

    /// The summands of a piece.
    pub(super) fn parents(&self, piece: &Piece) -> [Parent; 2] {
        let source = [piece.source.first, piece.source.second];
        [0, 1].map(|operand| {
            let segs: Vec<&Seg> = self.smooth[operand].loops.iter().flat_map(|l| &l.segs).collect();
            let edges = segs.iter().map(|seg| seg.edge + 1).max().unwrap_or(0);
            let is_parent = |seg: &&&Seg| match source[operand].checked_sub(edges) {
                Some(vertex) => seg.kind == Kind::Turn && seg.tail == vertex,
                None => seg.kind != Kind::Turn && seg.edge == source[operand],
            };
            segs.iter().find(is_parent).map_or(Parent { sign: 0, radius: 0.0 }, |seg| {
                let sign = if seg.delta == 0.0 { 0 } else { seg.delta.signum() as i32 };
                Parent { sign, radius: seg.r }
            })
        })
    }

    /// Points on both sides of the middles of some pieces: for arcs, between arc and chord and beyond both.
    pub(super) fn beside(&self, count: usize) -> Vec<DVec2> {
        let mut rng = Rng::new(0, "beside");
        let mut points = Vec::new();
        for _ in 0..count.min(self.pieces.pieces.len()) {
            let piece = &self.pieces.pieces[rng.below(self.pieces.pieces.len())];
            let [tail, head] = [piece.tail, piece.head].map(|v| self.pieces.points[v as usize]);
            let (middle, chord) = (0.5 * (tail + head), head - tail);
            // The arc is on the right of its chord if it turns left.
            let reach = if piece.delta == 0.0 { 1e-3 } else { 0.5 * libm::tan(0.5 * piece.delta) };
            points.extend([-1.5, -0.5, 0.5, 1.5].map(|side| middle - side * reach * chord.perp()));
        }
        points
    }

    /// Points in units of the frame, from input units.
    pub(super) fn framed(&self, [x, y]: [f64; 2]) -> DVec2 {
        let p = DVec2::new(x, y) - self.frames.0.shift - self.frames.1.shift;
        DVec2::new(self.frames.0.length_to_unit(p.x), self.frames.0.length_to_unit(p.y))
    }

    /// In input units, from units of the frame.
    pub(super) fn in_input(&self, p: DVec2) -> [f64; 2] {
        self.frames.0.sum_to_input(&self.frames.1, p).into()
    }

    /// The greatest difference between winding number and certified Euler characteristic over the points, and where; none if
    /// no point could be compared.
    pub(super) fn off(&self, case: &Case, points: impl IntoIterator<Item = DVec2>) -> Option<(i32, Option<[f64; 2]>)> {
        let shape = |region| Shape::new(&crate::bridge::plain(region)).ok();
        let characteristic = Characteristic::new(&shape(&case.a)?, &shape(&case.b)?)?;
        let mut worst: Option<(i32, Option<[f64; 2]>)> = None;
        for p in points {
            let t = self.in_input(p);
            let Some(winding) = winding(&self.pieces, p) else { continue };
            let Some(count) = characteristic.at(&Spot::exact(t[0], t[1])) else { continue };
            let off = (winding - count).abs();
            if worst.is_none_or(|(known, _)| off > known) {
                worst = Some((off, (off > 0).then_some(t)));
            }
        }
        worst
    }
}

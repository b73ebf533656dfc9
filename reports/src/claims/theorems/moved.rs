//! M24: the error of T segments, boundaries moved by concave turning points (MS 6.1; memo E3).
//!
//! As printed it is vertical. Their ends are rounded sums of two vertices, so vertically they are off by half a unit in
//! the last place of the abscissa times their slope; corrected, it is their ends that are right to one unit.

use super::super::control::Control;
use super::super::draw::{self, input};
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::EPS;
use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::cases::shape::polygon;
use crate::cases::{combs, fork};
use crate::kept;
use arcsum::convolution::monotonic;
use arcsum::convolution::order::Kind;
use arcsum::frame::Frame;
use arcsum::piece::Piece;
use arcsum::smooth::{Kind as SegKind, Seg, Smooth};
use arcsum::sum3::Rounding;
use glam::DVec2;
use libm::scalbn;
use rug::Float;

/// Bits that hold sums of two doubles of the unit box, and quotients finely.
const PRECISION: u32 = 2200;

pub(super) fn claims() -> [Claim; 2] {
    let printed = Claim {
        id: "M24 printed",
        place: "MS 6.1",
        says: "The vertical error of T segments is O(eps).",
        erratum: "It is half a unit in the last place of the abscissa times the slope; their ends are right to O(eps).",
        test: Test::Sup(Sup {
            quantity: "vertical error of T segments, over the steepness",
            unit: "eps",
            rule: Rule::Flat,
            draws: [2_000, 200_000],
            draw: draw_steep,
            measure: |input| greatest(input, |moved, size| moved.vertical(size)),
            kept: kept!("M24_printed"),
            control: Control::Itself,
        }),
    };
    let corrected = Claim {
        id: "M24 corrected",
        place: "MS 6.1",
        says: "The ends of T segments are right to a unit in the last place.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "error of the coordinates of ends of T segments",
            unit: "ulp",
            rule: Rule::AtMost(1.0),
            draws: [1_000, 100_000],
            draw,
            measure: |input| greatest(input, |moved, _| Some(moved.ends(0.0))),
            kept: kept!("M24_corrected"),
            control: Control::Measure {
                plants: "ends shifted by 1e-12",
                measure: |input| greatest(input, |moved, _| Some(moved.ends(1e-12))),
            },
        }),
    };
    [printed, corrected]
}

/// A T segment: its computed ends, those of the segment that was moved, and by which vertex.
struct Moved {
    computed: [DVec2; 2],
    own: [DVec2; 2],
    by: DVec2,
}

/// The greatest of a measure of the T segments of a pair; the size is the greatest steepness met, if it is set.
fn greatest(input: &Input, measure: fn(&Moved, &mut f64) -> Option<f64>) -> Option<Measured> {
    let mut size = 0.0;
    let found = moved(input.as_pair()?)?;
    let greatest = found.iter().filter_map(|moved| measure(moved, &mut size)).reduce(f64::max)?;
    Some(Measured { size, ..Measured::exactly(greatest) })
}

/// The T segments of a pair.
fn moved(case: &Case) -> Option<Vec<Moved>> {
    let frames = Frame::pair(&case.a, &case.b);
    let regions = [Smooth::new(&case.a, &frames.0).ok()?, Smooth::new(&case.b, &frames.1).ok()?];
    let (pieces, order) = monotonic(&regions[0], &regions[1], Rounding::Correct)?;
    let edges = regions.each_ref().map(|r| r.loops.iter().flat_map(|l| &l.segs).map(|s| s.edge + 1).max().unwrap_or(0));
    let crust = |kind: Kind| matches!(kind, Kind::LowerCrust | Kind::UpperCrust);
    let is_moved = |i: usize| order.roles(i as u32).iter().any(|(_, kind)| !crust(*kind));
    let found = pieces.pieces.iter().enumerate().filter(|(i, _)| is_moved(*i)).filter_map(|(_, piece)| {
        let computed = piece.whole.map(|v| pieces.points[v as usize]);
        let of_a = piece.source.first < edges[0];
        let (segment, vertex) = if of_a { (0, piece.source.second) } else { (1, piece.source.first) };
        let (edge, region) = (if of_a { piece.source.first } else { piece.source.second }, &regions[segment]);
        let by = regions[1 - segment].points[(vertex - edges[1 - segment]) as usize];
        let segs = region.loops.iter().flat_map(|l| &l.segs).filter(|seg| is_whole(piece, seg, edge));
        let own = segs.map(|seg| [seg.head, seg.tail].map(|v| region.points[v as usize]));
        // Arcs of one circle segment can be of one size: that one is meant which is there.
        let all = own.map(|own| Moved { computed, own, by });
        all.min_by(|m, n| m.away().total_cmp(&n.away()))
    });
    Some(found.collect())
}

/// Whether a piece, run backwards, is a part of this segment of an edge. Parts of no width have other normals.
fn is_whole(piece: &Piece, seg: &Seg, edge: u32) -> bool {
    let same_line = seg.kind == SegKind::Line && piece.a == seg.b.opposite();
    let same_arc = seg.kind == SegKind::Arc && piece.delta == -seg.delta && piece.r == -seg.r;
    seg.edge == edge && (same_line || same_arc)
}

impl Moved {
    /// About how far the computed tail is from the exact one.
    fn away(&self) -> f64 {
        (self.own[0] + self.by - self.computed[0]).abs().max_element()
    }

    /// The greatest error of a coordinate of an end, shifted, in units of its last place.
    fn ends(&self, shift: f64) -> f64 {
        let error = |end: usize, k: usize| {
            let exact = Float::with_val(PRECISION, self.own[end][k]) + self.by[k];
            let computed = self.computed[end][k] + shift;
            let unit = computed.abs().next_up() - computed.abs();
            ((exact - computed) / unit).abs().to_f64()
        };
        [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(end, k)| error(end, k)).into_iter().fold(0.0, f64::max)
    }

    /// The greatest vertical distance in eps of an end of a line, which is not vertical, from the exact one; the
    /// steepness is noted if it is the greatest.
    fn vertical(&self, steepness: &mut f64) -> Option<f64> {
        let exact = |end: usize, k: usize| Float::with_val(PRECISION, self.own[end][k]) + self.by[k];
        let way = [0, 1].map(|k| exact(1, k) - exact(0, k));
        if way[0].is_zero() {
            return None;
        }
        let slope = Float::with_val(PRECISION, &way[1] / &way[0]);
        *steepness = steepness.max(scalbn(0.5, libm::frexp(slope.to_f64().abs()).1));
        let off = |end: usize| {
            let along = -(exact(end, 0) - self.computed[end].x) * &slope;
            (along + exact(end, 1) - self.computed[end].y).abs().to_f64()
        };
        Some(off(0).max(off(1)) / EPS)
    }
}

fn draw(rng: &mut Rng, number: usize) -> Input {
    match number % 10 {
        0 => {
            let (a, b) = fork::fork(1 + rng.below(3) as u32);
            input("fork", a, b)
        }
        1 => {
            let (a, b) = combs::combs(2 + rng.below(4) as u32);
            input("combs", a, b)
        }
        _ => draw::pair(rng, number),
    }
}

/// A block with a notch from the left, whose bottom is a concave turning point, and one with a nearly vertical side.
fn draw_steep(rng: &mut Rng, number: usize) -> Input {
    let lean = scalbn(rng.between(1.0, 2.0), -6 - (number % 25) as i32);
    let (x, y) = (rng.between(0.2, 0.6), rng.between(0.4, 0.6));
    let notched = polygon(&[[0.0, 0.0], [0.9, 0.0], [0.9, 1.0], [0.0, 1.0], [x, y]]);
    let (left, width) = (rng.unit() / 7.0, rng.between(0.3, 0.5));
    let leaning = polygon(&[[left, 0.0], [left + width, 0.0], [left + width, 1.0], [left + lean, 1.0]]);
    input("notch", notched, leaning)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_notch_moves_the_other_boundary() {
        let pair = draw_steep(&mut Rng::new(1, "notch"), 3);
        let found = moved(pair.as_pair().unwrap()).unwrap();
        assert!(!found.is_empty() && found.iter().all(|moved| moved.ends(0.0) <= 0.5 && moved.ends(1e-12) > 1e3));
    }
}

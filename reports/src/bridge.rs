//! Regions crossing the line to the oracle as plain numbers, and the unit box (section 3 of the design).

use arcsum::angle::Ang;
use arcsum::convolution::{Stop, kinetic_stops};
use arcsum::frame::Frame;
use arcsum::region::{Curve, Node, Region};
use arcsum::robustness::Robustness;
use arcsum::smooth::{Kind, Seg, Smooth, SmoothError};
use arcsum_oracle::certified::realize::{self, StoredPiece, StoredRegion};
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};

/// The region as the oracle takes it.
#[must_use]
pub fn plain(region: &Region) -> PlainRegion {
    let bend = |curve| match curve {
        Curve::Line => Bend::Line,
        Curve::Radius(r) => Bend::Radius(r),
        Curve::Bulge(b) => Bend::Bulge(b),
    };
    let corner = |n: &Node| Corner { x: n.x, y: n.y, bend: bend(n.curve) };
    PlainRegion {
        loops: region.loops.iter().map(|l| l.iter().map(corner).collect()).collect(),
        unbounded: region.unbounded,
    }
}

/// The region as the engine takes it.
#[must_use]
pub fn region(plain: &PlainRegion) -> Region {
    let curve = |bend| match bend {
        Bend::Line => Curve::Line,
        Bend::Radius(r) => Curve::Radius(r),
        Bend::Bulge(b) => Curve::Bulge(b),
    };
    let node = |c: &Corner| Node { x: c.x, y: c.y, curve: curve(c.bend) };
    let loops = plain.loops.iter().map(|l| l.iter().map(node).collect()).collect();
    Region { loops, unbounded: plain.unbounded, ..Region::default() }
}

/// The side of the unit box in input units: the power of two that brings the larger side of the larger bounding box of
/// the operands into (1/2, 1].
#[must_use]
pub fn unit(a: &Region, b: &Region) -> f64 {
    libm::scalbn(1.0, Frame::pair(a, b).0.exp)
}

/// Both operands of a sum as the engine stores them, with the places at which their kinetic convolution ends sum
/// segments: what the realizations of MS 4.2 are made of.
///
/// # Errors
/// [`SmoothError`] if the engine cannot take an operand.
pub fn stored(a: &Region, b: &Region) -> Result<[StoredRegion; 2], SmoothError> {
    stored_by(a, b, Robustness::ALL)
}

/// The same with these robustness steps only.
///
/// # Errors
/// As [`stored`].
pub fn stored_by(a: &Region, b: &Region, robustness: Robustness) -> Result<[StoredRegion; 2], SmoothError> {
    let frames = Frame::pair(a, b);
    let (smooth_a, smooth_b) = (Smooth::by(a, &frames.0, robustness)?, Smooth::by(b, &frames.1, robustness)?);
    let [stops_a, stops_b] = kinetic_stops(&smooth_a, &smooth_b);
    let region = |smooth: &Smooth, stops: &[Stop], frame: &Frame, unbounded| StoredRegion {
        loops: (0..smooth.loops.len()).map(|index| stored_loop(smooth, index, stops)).collect(),
        unbounded,
        shift: (frame.length_to_unit(frame.shift.x), frame.length_to_unit(frame.shift.y)),
    };
    Ok([region(&smooth_a, &stops_a, &frames.0, a.unbounded), region(&smooth_b, &stops_b, &frames.1, b.unbounded)])
}

fn stored_loop(smooth: &Smooth, index: usize, stops: &[Stop]) -> Vec<StoredPiece> {
    let segs = &smooth.loops[index].segs;
    let first_edge = segs.iter().map(|seg| seg.edge).min().unwrap_or(0);
    let piece = |(i, seg): (usize, &Seg)| {
        let point = |v: u32| smooth.points[v as usize].into();
        let here = stops.iter().skip(stops.partition_point(|s| (s.of_loop, s.seg) < (index, i)));
        let here = here.take_while(|s| (s.of_loop, s.seg) == (index, i));
        StoredPiece {
            tail: point(seg.tail),
            head: point(seg.head),
            start: angle(seg.a),
            end: angle(seg.b),
            radius: seg.r,
            edge: (seg.edge - first_edge) as usize,
            stops: here.map(|stop| stored_stop(smooth, seg, stop.angle)).collect(),
        }
    };
    segs.iter().enumerate().filter(|(_, seg)| seg.kind != Kind::Turn).map(piece).collect()
}

fn stored_stop(smooth: &Smooth, seg: &Seg, theta: Ang) -> realize::Stop {
    let (end, way) = smooth.arc(seg).offset(theta);
    realize::Stop { angle: angle(theta), end: end.into(), way: way.into() }
}

fn angle(ang: Ang) -> realize::Angle {
    realize::Angle { quarter: ang.axis(), offset: ang.offset() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{polygon, rectangle};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_unit_is_a_power_of_two_that_fits(side in 1e-200_f64..1e200) {
            let square = polygon(&rectangle([0.0, 0.0], [side, side / 3.0]));
            let unit = unit(&square, &polygon(&rectangle([0.0, 0.0], [side / 2.0, side])));
            prop_assert!(side / unit > 0.5 && side / unit <= 1.0);
            prop_assert_eq!(libm::frexp(unit).0, 0.5);
        }
    }
}

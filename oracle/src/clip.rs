//! Cuts a convex piece in two, upright or level, so that both parts are smaller and their coordinates stay short.

use std::cmp::Ordering;

use crate::number::Number;
use crate::point::{Place, Point};
use crate::trapezoid::Convex;

/// Two convex pieces that make up one, cut across the longer side of the box around it, near a point or in the middle.
#[must_use]
pub fn halves<Q: Number>(piece: &Convex<Q>, near: Option<&Point<Q>>) -> [Convex<Q>; 2] {
    let [wide, high] = [Axis::X, Axis::Y].map(|axis| Slab::around(piece, axis));
    let slab = if wide.length >= high.length { wide } else { high };
    let level = slab.level(near);
    [Ordering::Less, Ordering::Greater].map(|side| part(piece, slab.axis, &level, side))
}

/// A coordinate axis.
#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
}

impl Axis {
    fn of<Q>(self, point: &Point<Q>) -> &Q {
        match self {
            Self::X => &point.x,
            Self::Y => &point.y,
        }
    }
}

/// The range of one coordinate.
struct Slab<'p, Q> {
    axis: Axis,
    ends: [&'p Q; 2],
    length: f64,
}

impl<'p, Q: Number> Slab<'p, Q> {
    fn around(piece: &'p Convex<Q>, axis: Axis) -> Self {
        let first = axis.of(&piece[0].exact);
        let ends =
            piece.iter().map(|corner| axis.of(&corner.exact)).fold([first, first], |[a, b], x| [a.min(x), b.max(x)]);
        Self { axis, ends, length: ends[1].minus(ends[0]).enclosure().mid() }
    }

    /// A short number well inside the range, near the coordinate of a point or the middle.
    fn level(&self, near: Option<&Point<Q>>) -> Q {
        let [start, end] = self.ends;
        let portion = near.map_or(0.5, |p| self.axis.of(p).minus(start).enclosure().mid() / self.length);
        let base = Q::from_f64(start.nearest());
        let offset = base.as_ref().map(|base| start.minus(base).enclosure().mid());
        let level = offset.and_then(|offset| Q::from_f64(offset + portion.clamp(0.125, 0.875) * self.length));
        let level = base.zip(level).map(|(base, level)| base.plus(&level));
        // The range of a piece smaller than the roundings here may lie elsewhere.
        level.filter(|level| start < level && level < end).unwrap_or_else(|| start.plus(end).over(&Q::from_i64(2)))
    }
}

/// What of a convex piece lies on one side of an upright or level line, the line included.
fn part<Q: Number>(piece: &Convex<Q>, axis: Axis, level: &Q, side: Ordering) -> Convex<Q> {
    let sides: Vec<Ordering> = piece.iter().map(|corner| axis.of(&corner.exact).cmp(level)).collect();
    let mut part = Vec::with_capacity(piece.len() + 1);
    for (i, from) in piece.iter().enumerate() {
        let j = (i + 1) % piece.len();
        if sides[i] != side.reverse() {
            part.push(from.clone());
        }
        if sides[i] == sides[j].reverse() && sides[i] != Ordering::Equal {
            part.push(Place::from(crossing(&from.exact, &piece[j].exact, axis, level)));
        }
    }
    part
}

/// The point of a segment on an upright or level line.
fn crossing<Q: Number>(a: &Point<Q>, b: &Point<Q>, axis: Axis, level: &Q) -> Point<Q> {
    let t = level.minus(axis.of(a)).over(&axis.of(b).minus(axis.of(a)));
    a.toward(b, &t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::point::area_exact;
    use proptest::prelude::*;
    use rug::Rational;

    fn area(piece: &Convex<Rational>) -> Rational {
        let corner = |i: usize| &piece[i].exact;
        (2..piece.len()).map(|i| area_exact(corner(0), corner(i - 1), corner(i))).sum()
    }

    fn triangle(corners: [f64; 6]) -> Option<Convex<Rational>> {
        let mut piece: Convex<Rational> =
            corners.chunks(2).filter_map(|c| Point::from_f64(c[0], c[1])).map(Place::from).collect();
        let sign = area(&piece).cmp0();
        if sign == Ordering::Less {
            piece.reverse();
        }
        (sign != Ordering::Equal).then_some(piece)
    }

    proptest! {
        /// However often a piece is cut, the parts have its area, and each is shorter than what was cut.
        #[test]
        fn halves_make_up_the_whole(corners in prop::array::uniform6(-1.0..1.0f64), turns in 0u32..1024, unit in 0..60i32) {
            let small = |c: f64| if unit % 2 == 0 { c } else { 0.7 + c * 2f64.powi(-unit) };
            let Some(whole) = triangle(corners.map(small)) else { return Ok(()) };
            let mut piece = whole;
            for turn in 0..10 {
                let parts = halves(&piece, (turn % 3 == 0).then(|| &piece[0].exact));
                prop_assert_eq!(parts.iter().map(area).sum::<Rational>(), area(&piece));
                prop_assert!(parts.iter().all(|part| area(part).cmp0() == Ordering::Greater));
                piece = parts[(turns >> turn & 1) as usize].clone();
            }
        }
    }
}

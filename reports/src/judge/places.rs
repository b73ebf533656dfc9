//! The places at which an answer is tested (memo F): the vertices of the result and the middles of its segments, and the
//! points of its cells, all in the unit box.

use crate::engine::cells::{Cell, Cells};
use arcsum::region::{Curve, Region};
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::spot::Spot;
use arcsum_oracle::certified::vector::Vector;

/// Vertices and middles of the result that are tested; of more, every so many.
const MOST: usize = 1_000;

/// What the roundings of a middle or of a corner make of its coordinates, relative to the largest one or to 1: fewer than
/// eight of half a last place each.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A place to test.
#[derive(Clone, Debug)]
pub(crate) struct Place {
    pub(crate) spot: Spot,
    /// How far it may be from the point it stands for.
    pub(crate) off: f64,
}

/// The places of a cell.
pub(crate) struct OfCell {
    pub(crate) inside: Vec<Place>,
    pub(crate) corners: Vec<Place>,
}

/// The test points of a cell as exact places.
pub(crate) fn of_cell(cells: &Cells, cell: &Cell) -> OfCell {
    let spot = |point: [f64; 2]| {
        let parts = [point, cells.origin[0], cells.origin[1]];
        Spot::new(move |precision: Precision| {
            let [p, q, r] = parts.map(|[x, y]| Vector::new(x, y, precision));
            &(&p + &q) + &r
        })
    };
    let corner = |p: &[f64; 2]| Place { spot: spot(*p), off: ROUNDING * size(*p) };
    OfCell {
        inside: cell.inside.iter().map(|p| Place { spot: spot(*p), off: 0.0 }).collect(),
        corners: cell.corners.iter().map(corner).collect(),
    }
}

/// The vertices and the middles of the segments of a result in input units, and how many of them are left out.
pub(crate) fn of_result(region: &Region, unit: f64) -> (Vec<Place>, u64) {
    let points = points(region);
    // An odd stride takes vertices and middles in turn.
    let stride = points.len().div_ceil(MOST).max(1) | 1;
    let place = |(i, [x, y]): (usize, [f64; 2])| {
        let [x, y] = [x / unit, y / unit];
        Place { spot: Spot::exact(x, y), off: if i % 2 == 0 { 0.0 } else { ROUNDING * size([x, y]) } }
    };
    let all = points.len();
    let kept: Vec<Place> = points.into_iter().enumerate().step_by(stride).map(place).collect();
    let left_out = (all - kept.len()) as u64;
    (kept, left_out)
}

/// The largest coordinate, at least 1.
fn size([x, y]: [f64; 2]) -> f64 {
    x.abs().max(y.abs()).max(1.0)
}

/// The vertices of a result and the middles of its segments in turn.
fn points(region: &Region) -> Vec<[f64; 2]> {
    let mut points = Vec::with_capacity(2 * region.segments());
    for nodes in &region.loops {
        for (i, node) in nodes.iter().enumerate() {
            let next = &nodes[(i + 1) % nodes.len()];
            let chord = [next.x - node.x, next.y - node.y];
            let bulge = match node.curve {
                Curve::Line => 0.0,
                Curve::Bulge(bulge) => bulge,
                Curve::Radius(radius) => {
                    libm::tan(0.5 * libm::asin((0.5 * libm::hypot(chord[0], chord[1]) / radius).clamp(-1.0, 1.0)))
                }
            };
            points.push([node.x, node.y]);
            points.push([node.x + 0.5 * (chord[0] + bulge * chord[1]), node.y + 0.5 * (chord[1] - bulge * chord[0])]);
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{disc, polygon, rectangle};

    #[test]
    fn middles_of_arcs_are_on_them() {
        for [x, y] in points(&disc(1.5)) {
            assert!((libm::hypot(x, y) - 1.5).abs() < 1e-15);
        }
        let square = points(&polygon(&rectangle([0.0, 0.0], [2.0, 2.0])));
        assert_eq!(square[1], [1.0, 0.0]);
        assert_eq!(square.len(), 8);
    }

    #[test]
    fn of_many_places_some_are_left_out() {
        let corner = |i: usize| [i as f64, libm::pow(i as f64, 2.0)];
        let many = polygon(&(0..MOST).map(corner).collect::<Vec<_>>());
        let (kept, left_out) = of_result(&many, 1.0);
        assert!(kept.len() <= MOST && (kept.len() as u64 + left_out) as usize == 2 * MOST);
        assert!(kept.iter().any(|place| place.off == 0.0) && kept.iter().any(|place| place.off > 0.0));
    }
}

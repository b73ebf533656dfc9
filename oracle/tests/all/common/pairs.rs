//! Pairs of regions with arcs: random ones, and regions full of equal radii, tangent joints and coincident arcs.

use super::disc;
use super::outline::is_simple;
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use proptest::prelude::*;

/// A bounded region of these loops.
pub fn region(loops: Vec<Vec<Corner>>) -> PlainRegion {
    PlainRegion { loops, unbounded: false }
}

/// The region with its vertices mapped by a map that keeps orientations and angles.
pub fn mapped(region: &PlainRegion, map: impl Fn(f64, f64) -> (f64, f64)) -> PlainRegion {
    let corner = |c: &Corner| {
        let (x, y) = map(c.x, c.y);
        Corner { x, y, bend: c.bend }
    };
    let loops = region.loops.iter().map(|ring| ring.iter().map(corner).collect()).collect();
    PlainRegion { loops, unbounded: region.unbounded }
}

/// Turned by half a turn about the origin.
pub fn mirrored(region: &PlainRegion) -> PlainRegion {
    mapped(region, |x, y| (-x, -y))
}

/// A ring of random arcs around the origin that does not cross itself.
pub fn bulgy() -> impl Strategy<Value = PlainRegion> {
    let corners = prop::collection::vec((0.4..1.0f64, -0.5..0.5f64), 3..8);
    let ring = corners.prop_map(|corners| {
        let n = corners.len() as f64;
        let corner = |(k, (r, bulge)): (usize, (f64, f64))| {
            let (sin, cos) = ((k as f64 + 0.3 * r) / n * std::f64::consts::TAU).sin_cos();
            let [x, y] = [r * cos, r * sin].map(|c| (c * 1e9).round() / (1u64 << 30) as f64);
            Corner { x, y, bend: Bend::Bulge(bulge) }
        };
        region(vec![corners.into_iter().enumerate().map(corner).collect()])
    });
    ring.prop_filter("crosses itself", is_simple)
}

/// Columns of integer height up and down, the edges straight or of one bulge to either side: equal radii, equal arcs,
/// convex arcs that fit concave ones, and flat edges on one line, everywhere.
pub fn rounded() -> impl Strategy<Value = PlainRegion> {
    let columns = prop::collection::vec((1i32..3, 1i32..3), 1..4);
    (columns, prop::collection::vec(-1i32..=1, 16)).prop_map(|(columns, bends)| {
        let below = columns.iter().enumerate().flat_map(|(i, &(down, _))| [(i as i32, -down), (i as i32 + 1, -down)]);
        let above = columns.iter().enumerate().rev().flat_map(|(i, &(_, up))| [(i as i32 + 1, up), (i as i32, up)]);
        let mut points: Vec<(i32, i32)> = below.chain(above).collect();
        points.dedup();
        let corner = |(k, (x, y)): (usize, (i32, i32))| {
            let bend = Bend::Bulge(0.125 * f64::from(bends[k % bends.len()]));
            Corner { x: f64::from(x), y: f64::from(y), bend }
        };
        region(vec![points.into_iter().enumerate().map(corner).collect()])
    })
}

/// The region with every number moved by a few units in the last place.
pub fn shaken(region: &PlainRegion, shakes: &[i8]) -> PlainRegion {
    let mut shakes = shakes.iter().cycle().map(|&k| f64::from(k) * f64::from(-51).exp2());
    let mut shake = |number: f64| number + shakes.next().expect("endless");
    let mut region = region.clone();
    for corner in region.loops.iter_mut().flatten() {
        (corner.x, corner.y) = (shake(corner.x), shake(corner.y));
        if let Bend::Bulge(bulge) = corner.bend {
            corner.bend = Bend::Bulge(shake(bulge));
        }
    }
    region
}

/// Two regions: random ones, degenerate ones, or one and itself turned by half a turn.
pub fn exact_pair() -> impl Strategy<Value = (PlainRegion, PlainRegion)> {
    prop_oneof![
        (bulgy(), bulgy()),
        (bulgy(), rounded()),
        (rounded(), rounded()),
        rounded().prop_map(|a| (a.clone(), mirrored(&a))),
        bulgy().prop_map(|a| (a.clone(), mirrored(&a))),
    ]
}

/// The same, or a degenerate one and nearly itself turned by half a turn.
pub fn pair() -> impl Strategy<Value = (PlainRegion, PlainRegion)> {
    let shakes = prop::collection::vec(-2i8..=2, 30);
    prop_oneof![
        4 => exact_pair(),
        1 => (rounded(), shakes).prop_map(|(a, shakes)| (shaken(&a, &shakes), mirrored(&a))),
    ]
}

/// Full circles, stadiums with tangent joints, a region with three cusps, a half disc and a notch it fits, on one grid.
pub fn special() -> impl Strategy<Value = PlainRegion> {
    let sizes = (1i32..5, 1i32..5, -2i32..3, 0i32..4);
    (0..6u8, sizes).prop_map(|(kind, (i, j, shift, turns))| {
        let (length, r) = (0.25 * f64::from(i), 0.125 * f64::from(j));
        let corner = |x: f64, y: f64, bulge: f64| Corner {
            x,
            y,
            bend: if bulge == 0.0 { Bend::Line } else { Bend::Bulge(bulge) },
        };
        let loops = match kind {
            0 => vec![disc(0.0, 0.0, r)],
            1 => vec![disc(0.0, 0.0, 2.0 * r), disc(0.0, 0.0, -r)],
            2 => vec![vec![corner(0.0, -r, 0.0), corner(length, -r, 1.0), corner(length, r, 0.0), corner(0.0, r, 1.0)]],
            3 => vec![vec![corner(1.0, 0.0, 1.0), corner(-1.0, 0.0, -1.0), corner(-0.25, 0.0, -1.0)]],
            4 => vec![vec![corner(-r, 0.0, 0.0), corner(r, 0.0, 1.0)]],
            _ => vec![vec![
                corner(-1.0, 0.0, 0.0),
                corner(-1.0, -1.0, 0.0),
                corner(1.0, -1.0, 0.0),
                corner(1.0, 0.0, 0.0),
                corner(r, 0.0, -1.0),
                corner(-r, 0.0, 0.0),
            ]],
        };
        let turn = |x: f64, y: f64| (0..turns).fold((x + 0.125 * f64::from(shift), y), |(x, y), _| (-y, x));
        mapped(&region(loops), turn)
    })
}

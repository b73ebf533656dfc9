//! Pairs of regions to measure on, drawn at random.

use super::input::Input;
use crate::attack::pairs;
use crate::cases::Case;
use crate::cases::orthogonal::{self, Corners, Style};
use crate::cases::radial::noise;
use crate::cases::rng::Rng;
use crate::cases::shape::{Point, polygon};
use arcsum::region::Region;

/// A pair under the name of its kind.
#[must_use]
pub fn input(kind: &str, a: Region, b: Region) -> Input {
    Input::pair(Case { name: kind.into(), family: kind.into(), a, b, seed: None, golden: None })
}

/// A small pair of any kind, often nearly degenerate, with arcs or without.
#[must_use]
pub fn pair(rng: &mut Rng, _: usize) -> Input {
    let (kind, a, b) = pairs::pair(rng);
    input(kind, a, b)
}

/// The same, but polygons only.
#[must_use]
pub fn polygons(rng: &mut Rng, _: usize) -> Input {
    loop {
        let (kind, a, b) = pairs::pair(rng);
        if a.is_polygonal() && b.is_polygonal() {
            return input(kind, a, b);
        }
    }
}

/// A star-shaped polygon with corners in small integers; not always valid.
pub fn integers(rng: &mut Rng) -> Region {
    let size = 2.0 + rng.below(4) as f64;
    let corners = noise(3 + rng.below(7) as u32, rng);
    let mut points: Vec<Point> = corners.iter().map(|p| p.map(|c| (size * c).round())).collect();
    points.dedup();
    polygon(&points)
}

/// Unit cells on a grid of this side, holes among them if wanted.
pub fn cells(side: i32, holes: bool, rng: &mut Rng) -> Region {
    orthogonal::cells(style(side, holes, rng), rng)
}

/// The same with rounded corners.
pub fn rounded_cells(side: i32, rng: &mut Rng) -> Region {
    orthogonal::cells(Style { corners: Corners::Rounded, ..style(side, false, rng) }, rng)
}

fn style(side: i32, holes: bool, rng: &mut Rng) -> Style {
    let cells = 2 + rng.below((side * side - 2) as usize);
    let corners = if rng.below(3) == 0 { Corners::Chamfered } else { Corners::Sharp };
    Style { side, cells, holes, collinear: rng.below(3) == 0, corners }
}

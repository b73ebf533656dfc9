//! M19: the boundary of the sum of what lies below two upper chains is the upper envelope of the convexly compatible sums
//! of their segments (MS 5.1; memo E2). Exact, on polygons.
//!
//! The envelope is taken by the definition from the sums of lines of one smoothed chain and convex vertices of the
//! other; the boundary is that of the exact sum by decomposition, which knows no convolution. Lower chains are mirrored.

use super::super::control::Control;
use super::super::draw::{self, input};
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use crate::bridge::plain;
use crate::cases::orthogonal::{Corners, Style, cells};
use crate::cases::rng::Rng;
use crate::kept;
use arcsum_oracle::chains::{Chain, Point, chains, extreme, rings};
use arcsum_oracle::decompose;
use arcsum_oracle::error::Budget;
use arcsum_oracle::point::Point as Exact;
use arcsum_oracle::region::ExactRegion;
use rug::Rational;
use std::cmp::Ordering;

/// Where between two neighbouring abscissas of vertices both are compared. Both are lines there if they agree.
const PARTS: [(u32, u32); 3] = [(1, 64), (1, 2), (63, 64)];

/// The most vertices of a chain.
const MOST: usize = 24;

pub(super) fn claims() -> [Claim; 1] {
    [Claim {
        id: "M19",
        place: "MS 5.1",
        says: "The boundary of the sum of what lies below two upper chains is the upper envelope of their convexly \
               compatible sums; likewise for lower chains.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "vertical distance of boundary and envelope",
            unit: "input units",
            rule: Rule::AtMost(0.0),
            draws: [150, 15_000],
            draw,
            measure: |input| greatest(input, true),
            kept: kept!("M19"),
            control: Control::Measure {
                plants: "chains without turns to the vertical at their ends",
                measure: |input| greatest(input, false),
            },
        }),
    }]
}

/// The greatest distance over all pairs of chains of one kind, smoothed at their ends or not; infinite where the envelope
/// has a gap.
fn greatest(input: &Input, smoothed: bool) -> Option<Measured> {
    let case = input.as_pair()?;
    let [of_a, of_b] = [&case.a, &case.b].map(|region| uppers(&rings(&plain(region))));
    let mut greatest: Option<f64> = None;
    for (p, upper) in &of_a {
        for (q, _) in of_b.iter().filter(|(_, other)| other == upper) {
            greatest = Some(distance(p, q, smoothed)?.max(greatest.unwrap_or(0.0)));
        }
    }
    greatest.map(Measured::exactly)
}

/// All chains from right to left with what they bound below them, lower chains turned by half a turn, and of which kind
/// they are. Chains that end in a vertical upwards are left out: a line sticks out of what lies below these, and the
/// exact sum is that of the regular parts.
fn uppers(rings: &[Vec<Point>]) -> Vec<(Vec<Point>, bool)> {
    let upright = |chain: Chain| {
        let turned = |p: &Point| [Rational::from(-&p[0]), Rational::from(-&p[1])];
        let path = if chain.upper { chain.path } else { chain.path.iter().map(turned).collect() };
        (path, chain.upper)
    };
    let regular = |(path, _): &(Vec<Point>, bool)| {
        let (last, before) = (&path[path.len() - 1], &path[path.len() - 2]);
        path.len() <= MOST && (last[0] != before[0] || last[1] < before[1])
    };
    rings.iter().flat_map(|ring| chains(ring)).map(upright).filter(regular).collect()
}

/// The greatest vertical distance of the envelope of two upper chains and the boundary of the sum of what lies below them.
fn distance(p: &[Point], q: &[Point], smoothed: bool) -> Option<f64> {
    let boundary = boundary(p, q)?;
    let sums = sums(p, q, smoothed);
    let mut abscissas: Vec<&Rational> = boundary.iter().chain(sums.iter().flatten()).map(|point| &point[0]).collect();
    abscissas.sort();
    abscissas.dedup();
    let (left, right) = (&p[p.len() - 1][0], &p[0][0]);
    let range = [Rational::from(left + &q[q.len() - 1][0]), Rational::from(right + &q[0][0])];
    let mut greatest = Rational::new();
    for pair in abscissas.windows(2).filter(|pair| *pair[0] >= range[0] && *pair[1] <= range[1]) {
        for part in PARTS {
            let x = Rational::from(pair[1] - pair[0]) * Rational::from(part) + pair[0];
            let envelope = sums.iter().filter_map(|sum| extreme(sum, &x, true)).max();
            let (Some(y), Some(z)) = (extreme(&boundary, &x, true), envelope) else { return Some(f64::INFINITY) };
            greatest = greatest.max((y - z).abs());
        }
    }
    Some(greatest.to_f64())
}

/// The boundary of the sum of what lies below two upper chains, both cut off far below.
fn boundary(p: &[Point], q: &[Point]) -> Option<Vec<Point>> {
    let sum = decompose::sum(&below(p)?, &below(q)?, Budget::default()).ok()?;
    let mut ring: Vec<Point> = sum.loops().first()?.iter().map(|v| [v.x.clone(), v.y.clone()]).collect();
    ring.push(ring[0].clone());
    Some(ring)
}

/// What lies below a path from right to left. The floor is so deep that no sum with it comes up to the chains.
fn below(path: &[Point]) -> Option<ExactRegion<Rational>> {
    let height = path.iter().map(|p| Rational::from(p[1].abs_ref())).max()?;
    let floor = -(height * 4u32 + 1u32);
    let foot = |p: &Point| Exact { x: p[0].clone(), y: floor.clone() };
    let mut ring: Vec<Exact<Rational>> = path.iter().map(|p| Exact { x: p[0].clone(), y: p[1].clone() }).collect();
    ring.extend([foot(path.last()?), foot(path.first()?)]);
    ExactRegion::from_rings(vec![ring], false, |w| w[0] != 0).ok()
}

/// The sums of the lines of either chain, but for verticals, and the vertices of the other that turn left past their
/// direction.
fn sums(p: &[Point], q: &[Point], smoothed: bool) -> Vec<[Point; 2]> {
    let mut sums = Vec::new();
    for (lines, vertices) in [(p, q), (q, p)] {
        for line in lines.windows(2).filter(|line| line[0][0] != line[1][0]) {
            let way = minus(&line[1], &line[0]);
            for i in 0..vertices.len() {
                if turns_past(vertices, i, &way, smoothed) {
                    sums.push([plus(&line[0], &vertices[i]), plus(&line[1], &vertices[i])]);
                }
            }
        }
    }
    sums
}

/// Whether a path turns left past a direction at a vertex. A smoothed one comes from below and leaves downwards.
fn turns_past(path: &[Point], i: usize, way: &Point, smoothed: bool) -> bool {
    let vertical = |y: i32| [Rational::new(), Rational::from(y)];
    let before = if i > 0 { Some(minus(&path[i], &path[i - 1])) } else { smoothed.then(|| vertical(1)) };
    let after = if i + 1 < path.len() { Some(minus(&path[i + 1], &path[i])) } else { smoothed.then(|| vertical(-1)) };
    let (Some(before), Some(after)) = (before, after) else { return false };
    // All of a chain runs to the left or vertically, so signs of cross products tell the order of directions.
    turn(&before, way) != Ordering::Less && turn(way, &after) != Ordering::Less
}

fn turn(u: &Point, v: &Point) -> Ordering {
    (Rational::from(&u[0] * &v[1]) - Rational::from(&u[1] * &v[0])).cmp0()
}

fn plus(p: &Point, q: &Point) -> Point {
    [0, 1].map(|k| Rational::from(&p[k] + &q[k]))
}

fn minus(p: &Point, q: &Point) -> Point {
    [0, 1].map(|k| Rational::from(&p[k] - &q[k]))
}

/// Staircases with verticals inside and at the ends of chains, and polygons of any kind.
fn draw(rng: &mut Rng, number: usize) -> Input {
    if !number.is_multiple_of(3) {
        return draw::polygons(rng, number);
    }
    let mut staircase = || {
        let corners = if rng.below(2) == 0 { Corners::Sharp } else { Corners::Chamfered };
        let style = Style { side: 4, cells: 3 + rng.below(6), holes: rng.below(2) == 0, collinear: false, corners };
        cells(style, rng)
    };
    input("cells", staircase(), staircase())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(points: &[(i32, i32)]) -> Vec<Point> {
        points.iter().map(|&(x, y)| [x, y].map(Rational::from)).collect()
    }

    #[test]
    fn roofs_add_up() {
        // The sum of a roof and a level chain is the roof with a level part.
        let (roof, level) = (path(&[(2, 0), (1, 1), (0, 0)]), path(&[(3, 0), (0, 0)]));
        assert_eq!(distance(&roof, &level, true), Some(0.0));
        assert_eq!(distance(&roof, &level, false), Some(f64::INFINITY));
        let tops: Vec<Point> = sums(&roof, &level, true).concat();
        assert!(tops.contains(&path(&[(4, 1)])[0]) && tops.contains(&path(&[(1, 1)])[0]));
    }
}

//! M23: Theorem 3, the distance of a crust and that of the realizations (MS 6.1).
//!
//! Measured on polygons with one upper chain each, the crust of which is the boundary of the sum of what lies below
//! them. The engine's is taken from its monotonic convolution; the exact one is the boundary of the exact sum of what
//! lies below the realized chains, cut off far below. Both distances are taken between these.

use super::super::control::Control;
use super::super::draw::input;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::EPS;
use crate::bridge::stored;
use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::cases::shape::{Point as Corner, polygon};
use crate::kept;
use arcsum::convolution::monotonic;
use arcsum::convolution::order::Kind;
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::Region;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::realize::{StoredRegion, Up, realize_along};
use arcsum_oracle::chains::{Point, chains, extreme};
use arcsum_oracle::convolve;
use arcsum_oracle::error::Budget;
use arcsum_oracle::measure::between;
use arcsum_oracle::point::Point as Exact;
use arcsum_oracle::region::ExactRegion;
use libm::scalbn;
use rug::Rational;
use std::collections::BTreeMap;

/// Where what lies below a chain is cut off; all regions are above.
const FLOOR: i32 = -4;

/// Far finer than the distances.
const FINE: Precision = Precision::LADDER[2];

pub(super) fn claims() -> [Claim; 2] {
    let printed = Claim {
        id: "M23 printed",
        place: "MS 6.1",
        says: "Theorem 3: the vertical distance of the crust and that of the realizations is O(n eps).",
        erratum: "Ends of sum segments have rounded abscissas, so on steep chains only the Hausdorff distance is small.",
        test: Test::Sup(Sup {
            quantity: "vertical distance / (n eps), over the steepness",
            unit: "1",
            rule: Rule::Flat,
            draws: [100, 10_000],
            draw: draw_steep,
            measure: vertical,
            kept: kept!("M23_printed"),
            control: Control::Itself,
        }),
    };
    let corrected = Claim {
        id: "M23 corrected",
        place: "MS 6.1",
        says: "The Hausdorff distance of the crust and that of the realizations is O(n eps), here for polygons.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "Hausdorff distance / (n eps), over n",
            unit: "1",
            rule: Rule::Flat,
            draws: [60, 6_000],
            draw,
            measure: |input| apart(input, |_| 0.0),
            kept: kept!("M23_corrected"),
            control: Control::Measure {
                plants: "the crust lifted by n^2 eps",
                measure: |input| apart(input, |n| (n * n) as f64 * EPS),
            },
        }),
    };
    [printed, corrected]
}

/// A crust of the engine, lifted, and the region below the exact one.
struct Crusts {
    float: Vec<Point>,
    exact: ExactRegion<Rational>,
}

impl Crusts {
    fn new(case: &Case, lift: f64) -> Option<Self> {
        let [a, b] = stored(&case.a, &case.b).ok()?.map(|region| upper(&region));
        let exact = convolve::sum(&below(&a?, FLOOR)?, &below(&b?, FLOOR)?, Budget::default()).ok()?;
        let frames = Frame::pair(&case.a, &case.b);
        let [a, b] = [Smooth::new(&case.a, &frames.0).ok()?, Smooth::new(&case.b, &frames.1).ok()?];
        let (pieces, order) = monotonic(&a, &b, Rounding::Correct)?;
        let is_crust = |i: &usize| order.roles(*i as u32).iter().any(|(_, kind)| *kind == Kind::UpperCrust);
        let crust: Vec<usize> = (0..pieces.pieces.len()).filter(is_crust).collect();
        Some(Self { float: path(&pieces, &crust, lift)?, exact })
    }

    /// The boundary of the exact region.
    fn boundary(&self) -> Option<Vec<Point>> {
        let mut ring: Vec<Point> = self.exact.loops().first()?.iter().map(|p| [p.x.clone(), p.y.clone()]).collect();
        ring.push(ring[0].clone());
        Some(ring)
    }
}

/// The realized upper chain of a region that has one, in the unit box.
fn upper(region: &StoredRegion) -> Option<Vec<Point>> {
    let region = StoredRegion { shift: (0.0, 0.0), ..region.clone() };
    let shape = realize_along(&region, Up::VERTICAL).ok()?.shape;
    let exact = |x: &Real| x.floats(FINE)[0].to_rational();
    let corner = |piece: &arcsum_oracle::certified::piece::Piece| Some([exact(&piece.from.x)?, exact(&piece.from.y)?]);
    let ring: Option<Vec<Point>> = shape.loops.first()?.iter().map(|side| corner(side.curve.at(FINE))).collect();
    let mut ring = ring?;
    ring.dedup();
    let mut uppers = chains(&ring).into_iter().filter(|chain| chain.upper);
    let chain = uppers.next().filter(|_| shape.loops.len() == 1)?;
    uppers.next().is_none().then_some(chain.path)
}

/// What lies below a path from right to left, down to a floor.
fn below(path: &[Point], floor: i32) -> Option<ExactRegion<Rational>> {
    let corner = |[x, y]: &Point| Exact { x: x.clone(), y: y.clone() };
    let foot = |[x, _]: &Point| Exact { x: x.clone(), y: Rational::from(floor) };
    let mut ring: Vec<Exact<Rational>> = path.iter().map(corner).collect();
    ring.extend([foot(path.last()?), foot(path.first()?)]);
    ExactRegion::from_rings(vec![ring], false, |w| w[0] != 0).ok()
}

/// The points along some pieces that follow each other.
fn path(pieces: &Pieces, crust: &[usize], lift: f64) -> Option<Vec<Point>> {
    let ends: BTreeMap<u32, u32> = crust.iter().map(|&i| (pieces.pieces[i].tail, pieces.pieces[i].head)).collect();
    let heads: Vec<u32> = ends.values().copied().collect();
    let mut at = *ends.keys().find(|tail| !heads.contains(tail))?;
    let exact = |x: f64| Rational::from_f64(x);
    let point =
        |v: u32| Some([exact(pieces.points[v as usize].x)?, exact(pieces.points[v as usize].y)? + exact(lift)?]);
    let mut path = vec![point(at)?];
    while let Some(&next) = ends.get(&at).filter(|_| path.len() <= ends.len()) {
        path.push(point(next)?);
        at = next;
    }
    path.dedup();
    (path.len() <= ends.len() + 1).then_some(path)
}

/// The vertical distance over n eps; the size is the steepness of the steepest line. Between the abscissas of all
/// vertices both crusts are lines, so the distance is greatest at one of these.
fn vertical(input: &Input) -> Option<Measured> {
    let case = input.as_pair()?;
    let crusts = Crusts::new(case, 0.0)?;
    let boundary = crusts.boundary()?;
    let mut greatest = Rational::new();
    for [x, _] in crusts.float.iter().chain(&boundary) {
        if let (Some(y), Some(z)) = (extreme(&crusts.float, x, true), extreme(&boundary, x, true)) {
            greatest = greatest.max((y - z).abs());
        }
    }
    let ratio = greatest.to_f64() / (case.segments() as f64 * EPS);
    Some(Measured { size: steepness(&case.a), ..Measured::exactly(ratio) })
}

/// The greatest power of two below the steepness of the lines that are not vertical.
fn steepness(region: &Region) -> f64 {
    let nodes = &region.loops[0];
    let slope = |i: usize| {
        let (p, q) = (nodes[i], nodes[(i + 1) % nodes.len()]);
        if p.x == q.x { 0.0 } else { ((q.y - p.y) / (q.x - p.x)).abs() }
    };
    scalbn(0.5, libm::frexp((0..nodes.len()).map(slope).fold(0.0, f64::max)).1)
}

/// The Hausdorff distance of what lies below both crusts, the float one lifted, over n eps.
fn apart(input: &Input, lift: fn(usize) -> f64) -> Option<Measured> {
    let case = input.as_pair()?;
    let n = case.segments();
    let crusts = Crusts::new(case, lift(n))?;
    let found = between(&below(&crusts.float, 2 * FLOOR)?, &crusts.exact, 1.0).ok()?;
    let unit = n as f64 * EPS;
    Some(Measured::between((found.lo / unit).next_down(), (found.hi / unit).next_up()).of_size(n))
}

/// Abscissas at random from 0 to 1, and heights at random above and below. If the step is below 1, a line above rises
/// or falls by a third or more over so much.
fn hills(n: usize, step: f64, rng: &mut Rng) -> Region {
    let columns = (n / 2).max(2);
    let row = |rng: &mut Rng, lo: f64| -> Vec<Corner> {
        let place = |k: usize| (k as f64 + 0.8 * rng.unit()) / columns as f64;
        let xs: Vec<f64> = (1..columns - 1).map(place).collect();
        let ends = [0.0].into_iter().chain(xs).chain([1.0]);
        ends.map(|x| [x, rng.between(lo, lo + 0.3)]).collect()
    };
    let (bottom, mut top) = (row(rng, 0.0), row(rng, 0.4));
    if step < 1.0 {
        // High on one side of the step, low on the other.
        let at = 1 + rng.below(top.len() - 2);
        let high = rng.below(2) == 0;
        for (i, corner) in top.iter_mut().enumerate() {
            corner[1] += if (i <= at) == high { 0.0 } else { 0.3 };
        }
        let foot = [top[at][0] + step, if high { 0.75 } else { 0.35 }];
        top.insert(at + 1, foot);
    }
    top.reverse();
    polygon(&[bottom, top].concat())
}

fn draw(rng: &mut Rng, number: usize) -> Input {
    let n = 8 << (number % 4);
    let step = if rng.below(2) == 0 { 1.0 } else { scalbn(rng.between(1.0, 2.0), -10 - rng.below(30) as i32) };
    input("hills", hills(n, step, rng), hills(8, 1.0, rng))
}

fn draw_steep(rng: &mut Rng, number: usize) -> Input {
    let step = scalbn(rng.between(1.0, 2.0), -6 - (number % 25) as i32);
    input("steep hills", hills(12, step, rng), hills(8, 1.0, rng))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lift_shows_in_both_distances() {
        let pair = draw(&mut Rng::new(2, "hills"), 0);
        let n = pair.size() as f64;
        let [right, wrong] = [|_| 0.0, |_| 1e-12].map(|lift| apart(&pair, lift).unwrap());
        assert!(right.hi < 4.0 && wrong.lo * n * EPS > 1e-14 && wrong.hi * n * EPS < 1.1e-12, "{right:?} {wrong:?}");
    }

    #[test]
    fn squares_have_exact_crusts() {
        let square = || polygon(&[[0.0, 0.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]]);
        let pair = input("squares", square(), square());
        assert!(vertical(&pair).unwrap().hi < 1e-9 && apart(&pair, |_| 0.0).unwrap().hi < 1e-2);
    }
}

//! M23: Theorem 3, the distance of a crust and that of the realizations (MS 6.1).
//!
//! Measured on regions with one upper chain each, the crust of which is the upper boundary of what lies below the sum. For
//! polygons the engine's is taken from its monotonic convolution; the exact one is the boundary of the exact sum of what
//! lies below the realized chains, cut off far below. With circle segments the regions have level bottoms: then the engine's
//! crusts of both kinds bound the sum, and the certified reference is that of the realizations.

use super::super::control::Control;
use super::super::draw::input;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::hills::{domes, hills};
use super::{BUDGET, EPS};
use crate::bridge::stored;
use crate::cases::Case;
use crate::cases::rng::Rng;
use crate::kept;
use arcsum::convolution::monotonic;
use arcsum::convolution::order::{Kind, Order};
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::Region;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_oracle::certified::piece::Piece;
use arcsum_oracle::certified::precision::Precision;
use arcsum_oracle::certified::real::Real;
use arcsum_oracle::certified::realize::{StoredRegion, Up, realize, realize_along};
use arcsum_oracle::certified::reference::Reference;
use arcsum_oracle::chains::{Point, chains, extreme};
use arcsum_oracle::convolve;
use arcsum_oracle::error::Budget;
use arcsum_oracle::measure::{Bracket, between};
use arcsum_oracle::plain::{Bend, Corner, PlainRegion};
use arcsum_oracle::point::Point as Exact;
use arcsum_oracle::region::ExactRegion;
use libm::scalbn;
use rug::Rational;
use std::collections::{BTreeMap, BTreeSet};

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
        says: "The Hausdorff distance of the crust and that of the realizations is O(n eps).",
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
        let (pieces, order) = convolved(case)?;
        let is_crust = |i: &usize| order.roles(*i as u32).iter().any(|(_, kind)| *kind == Kind::UpperCrust);
        let crust: Vec<usize> = (0..pieces.pieces.len()).filter(is_crust).collect();
        let crust = in_line(&pieces, &crust)?;
        let [first, last] = [crust.first()?, crust.last()?].map(|&i| &pieces.pieces[i]);
        let corners = crust.iter().map(|&i| pieces.pieces[i].tail).chain([last.head]);
        let exact_point = |v: u32| {
            let p = pieces.points[v as usize];
            Some([Rational::from_f64(p.x)?, Rational::from_f64(p.y)? + Rational::from_f64(lift)?])
        };
        let mut float: Vec<Point> = corners.map(exact_point).collect::<Option<_>>()?;
        float.dedup();
        (first.tail != last.head).then_some(Self { float, exact })
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
    let corner = |piece: &Piece| Some([exact(&piece.from.x)?, exact(&piece.from.y)?]);
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

/// Some pieces, each ending where the next begins; they need not be closed. None if they are no such path.
fn in_line(pieces: &Pieces, some: &[usize]) -> Option<Vec<usize>> {
    let leaving: BTreeMap<u32, usize> = some.iter().map(|&i| (pieces.pieces[i].tail, i)).collect();
    let heads: BTreeSet<u32> = some.iter().map(|&i| pieces.pieces[i].head).collect();
    let open = leaving.iter().find(|(tail, _)| !heads.contains(tail));
    let mut next = open.or(leaving.iter().next()).map(|(_, &i)| i);
    let mut line = Vec::new();
    while let Some(i) = next.filter(|_| line.len() < some.len()) {
        line.push(i);
        next = leaving.get(&pieces.pieces[i].head).copied();
    }
    (line.len() == some.len()).then_some(line)
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
    let found = if case.is_polygonal() { below_both(case, lift(n)) } else { within_both(case, lift(n)) }?;
    let unit = n as f64 * EPS;
    Some(Measured::between((found.lo / unit).next_down(), (found.hi / unit).next_up()).of_size(n))
}

/// The distance of what lies below both crusts of polygons.
fn below_both(case: &Case, lift: f64) -> Option<Bracket> {
    let crusts = Crusts::new(case, lift)?;
    between(&below(&crusts.float, 2 * FLOOR)?, &crusts.exact, 1.0).ok()
}

/// The distance of what is within the crusts of regions with one chain of either kind, where that is their sum: above level
/// bottoms.
fn within_both(case: &Case, lift: f64) -> Option<Bracket> {
    let [a, b] =
        stored(&case.a, &case.b).ok()?.map(|region| realize(&StoredRegion { shift: (0.0, 0.0), ..region }).ok());
    let reference = Reference::of_shapes(&a?.shape, &b?.shape, 1.0, BUDGET).ok()?;
    reference.measure(&within(case, lift)?).ok()?
}

/// What the engine's crusts enclose, in the unit box; none if the convolution has other pieces.
fn within(case: &Case, lift: f64) -> Option<PlainRegion> {
    let (pieces, order) = convolved(case)?;
    let is_crust =
        |i: usize| order.roles(i as u32).iter().all(|(_, kind)| matches!(kind, Kind::UpperCrust | Kind::LowerCrust));
    let all: Vec<usize> = (0..pieces.pieces.len()).collect();
    let ring = in_line(&pieces, &all).filter(|ring| ring.iter().all(|&i| is_crust(i)))?;
    let corner = |&i: &usize| {
        let piece = &pieces.pieces[i];
        let p = pieces.points[piece.tail as usize];
        Corner { x: p.x, y: p.y + lift, bend: if piece.delta == 0.0 { Bend::Line } else { Bend::Radius(piece.r) } }
    };
    Some(PlainRegion { loops: vec![ring.iter().map(corner).collect()], unbounded: false })
}

/// The monotonic convolution in the unit box.
fn convolved(case: &Case) -> Option<(Pieces, Order)> {
    let frames = Frame::pair(&case.a, &case.b);
    let [a, b] = [Smooth::new(&case.a, &frames.0).ok()?, Smooth::new(&case.b, &frames.1).ok()?];
    monotonic(&a, &b, Rounding::Correct)
}

fn draw(rng: &mut Rng, number: usize) -> Input {
    let n = 8 << (number % 4);
    if number % 8 >= 4 {
        let radius = rng.between(0.2, 1.0);
        // Circle segments of opposite radii all but cancel: their sums run backwards but for parts (Fig. 11).
        return input("domes", domes(n / 2, radius, rng), domes(4, -radius, rng));
    }
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
    use crate::cases::shape::polygon;
    use arcsum::convolution::kinetic;
    use arcsum::validate::validate;

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

    /// Domes of radii that cancel: all are measured, and there are sums of tiny radii.
    #[test]
    fn domes_are_measured_and_a_lift_shows() {
        let mut cancelled = 0;
        for number in [4, 5, 12, 13] {
            let pair = draw(&mut Rng::new(1, &format!("domes {number}")), number);
            let [right, wrong] = [|_| 0.0, |_| 1e-12].map(|lift| apart(&pair, lift).unwrap());
            let unit = right.size * EPS;
            assert!(right.hi < 1.0 && wrong.lo * unit > 0.99e-12 && wrong.hi * unit < 1.1e-12, "{right:?} {wrong:?}");
            let case = pair.as_pair().unwrap();
            assert!([&case.a, &case.b].map(validate).iter().all(Result::is_ok));
            let frames = Frame::pair(&case.a, &case.b);
            let [a, b] = [(&case.a, &frames.0), (&case.b, &frames.1)].map(|(r, frame)| Smooth::new(r, frame).unwrap());
            let sums = kinetic(&a, &b, Rounding::Correct).unwrap().pieces;
            cancelled += sums.iter().filter(|piece| piece.r != 0.0 && piece.r.abs() < 1e-6).count();
        }
        assert!(cancelled > 0);
    }
}

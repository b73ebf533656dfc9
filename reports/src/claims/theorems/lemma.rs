//! M15: Lemma 1, the distance of matched points of the sum of realizations and of the float convolution (MS 4.3).
//!
//! A sum segment is the sum of two boundary pieces. Its ends are off the exact sums of stored points by rounding, which
//! is measured on the engine's convolution, and these are off the realizations by as much as these have moved
//! (certified). On an arc the difference of matched points is an arc itself and exceeds that at the ends by its
//! sagitta at most ([`arcsum_oracle::certified::realize::moved`]).

use super::super::control::Control;
use super::super::draw::input;
use super::super::finding::Measured;
use super::super::input::Input;
use super::super::sup::{Rule, Sup};
use super::super::{Claim, Test};
use super::{EPS, families};
use crate::bridge::stored;
use crate::cases::Case;
use crate::cases::radial::{Bending, bulging, noise};
use crate::cases::rng::Rng;
use crate::cases::shape::polygon;
use crate::kept;
use arcsum::convolution::kinetic;
use arcsum::frame::Frame;
use arcsum::smooth::Smooth;
use arcsum::sum3::Rounding;
use arcsum_oracle::certified::realize::{StoredRegion, realize};
use glam::DVec2;
use rug::Float;

/// Bits that hold the differences of few doubles of the unit box.
const PRECISION: u32 = 400;

/// Twice the sagitta over the chord of a quarter of a circle, rounded up.
const SAGITTA: f64 = 0.4143;

/// A sum of stored points is looked for this near in abscissa.
const NEAR: f64 = 1e-9;

pub(super) fn claims() -> [Claim; 1] {
    [Claim {
        id: "M15",
        place: "MS 4.3",
        says: "Lemma 1: the convolution of the realizations is O(n eps) close to the float convolution.",
        erratum: "",
        test: Test::Sup(Sup {
            quantity: "distance of matched points, at most, / (n eps), over n",
            unit: "1",
            rule: Rule::Flat,
            draws: [families::ALL * 6, families::ALL * 8 * 12],
            draw,
            measure: |input| measure(input, |_| 0.0),
            kept: kept!("M15"),
            control: Control::Measure {
                plants: "ends of sum segments shifted by n^2 eps",
                measure: |input| measure(input, |n| (n * n) as f64 * EPS),
            },
        }),
    }]
}

/// The distance over n eps, with the ends of sum segments shifted.
fn measure(input: &Input, shift: fn(usize) -> f64) -> Option<Measured> {
    let case = input.as_pair()?;
    let n = case.segments();
    let regions = stored(&case.a, &case.b).ok()?;
    let moved: f64 =
        regions.iter().map(|region| realize(region).ok().map(|r| r.moved.greatest())).sum::<Option<f64>>()?;
    let rounded = rounding(case, &regions, shift(n))?;
    let ends = moved + rounded;
    Some(Measured::exactly((1.0 + SAGITTA) * ends / (n as f64 * EPS)).of_size(n))
}

/// The greatest distance of an end of a float sum segment, shifted, to the nearest exact sum of stored points.
fn rounding(case: &Case, regions: &[StoredRegion; 2], shift: f64) -> Option<f64> {
    let frames = Frame::pair(&case.a, &case.b);
    let [a, b] = [Smooth::new(&case.a, &frames.0).ok()?, Smooth::new(&case.b, &frames.1).ok()?];
    let ends = kinetic(&a, &b, Rounding::Correct)?.points;
    let exact = Sums::new(regions);
    let distances = ends.iter().map(|end| exact.distance(*end + DVec2::new(shift, 0.0)));
    Some(distances.fold(0.0, f64::max))
}

/// Exact sums of a stored point of one region and a vertex of the other, by their rounded abscissas.
struct Sums {
    sums: Vec<[DVec2; 3]>,
}

impl Sums {
    fn new(regions: &[StoredRegion; 2]) -> Self {
        let point = |p: (f64, f64)| DVec2::new(p.0, p.1);
        let pieces = |region: &StoredRegion| region.loops.concat();
        let vertices = |region: &StoredRegion| pieces(region).iter().map(|p| [point(p.tail), DVec2::ZERO]).collect();
        let stops = |region: &StoredRegion| {
            let all = pieces(region).into_iter().flat_map(|piece| piece.stops);
            all.map(|stop| [point(stop.end), point(stop.way)]).collect::<Vec<_>>()
        };
        let [p, q]: [Vec<[DVec2; 2]>; 2] = regions.each_ref().map(vertices);
        let mut sums = Vec::new();
        for (places, others) in [(&p, &q), (&stops(&regions[0]), &q), (&stops(&regions[1]), &p)] {
            sums.extend(places.iter().flat_map(|[end, way]| others.iter().map(move |other| [*end, *way, other[0]])));
        }
        sums.sort_by(|s, t| abscissa(s).total_cmp(&abscissa(t)));
        Self { sums }
    }

    fn distance(&self, end: DVec2) -> f64 {
        let first = self.sums.partition_point(|sum| abscissa(sum) < end.x - NEAR);
        let near = self.sums[first..].iter().take_while(|sum| abscissa(sum) <= end.x + NEAR);
        near.map(|sum| apart(sum, end)).fold(f64::INFINITY, f64::min)
    }
}

fn abscissa([end, way, other]: &[DVec2; 3]) -> f64 {
    end.x + way.x + other.x
}

/// The distance of a sum of three points and a point.
fn apart([end, way, other]: &[DVec2; 3], point: DVec2) -> f64 {
    let difference = |k: usize| Float::with_val(PRECISION, end[k]) + way[k] + other[k] - point[k];
    difference(0).hypot(&difference(1)).to_f64()
}

fn draw(rng: &mut Rng, number: usize) -> Input {
    let most = if number < families::ALL * 6 { 256 } else { 1024 };
    let (kind, a) = families::region(number, families::ALL, most, rng);
    let b = if rng.below(2) == 0 { polygon(&noise(5, rng)) } else { bulging(4, Bending::AtRandom, rng) };
    input(kind, a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shift_shows() {
        let pair = draw(&mut Rng::new(1, "lemma"), 1);
        let [right, wrong] = [|_| 0.0, |_| 1e-12].map(|shift| measure(&pair, shift).unwrap().hi);
        let n = pair.size() as f64;
        assert!(right < 4.0 && (wrong - right) * n * EPS > 0.9e-12, "{right} {wrong}");
    }
}

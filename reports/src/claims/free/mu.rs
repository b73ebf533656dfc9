//! The mu of MS 4.3: the size of the perturbation that the arrangement is right for, plus the errors of both realizations
//! (memo C4, F, I5), in unit-box lengths. It is measured for each input, never fitted.
//!
//! - The realizations are those of [`realize`], and their errors certified: the greatest distance of matched points.
//! - The perturbation is measured in doubles: how far curves that the sweep has in the wrong order are beyond each other, half
//!   of it for each, at the ends and in the middle of every slab; and how far vertices are from their curves. Distances count,
//!   not heights: curves may be steep. [`DOUBLES`] is added for what doubles do not see.
//! - MS count the rounding of the ends of sum segments among the realization's errors; half a last place each way is added.

use crate::bridge::stored;
use crate::cases::Case;
use crate::claims::order::swept::status;
use crate::judge::separation;
use arcsum::arrangement::Arrangement;
use arcsum::arrangement::curve::Curve;
use arcsum::sum::{Options, sum};
use arcsum_oracle::certified::realize::realize;
use glam::DVec2;

/// What doubles err by when they measure how far a point is from a curve: the sums reach 2, and evaluation errs by under 4 eps
/// (memo C1).
const DOUBLES: f64 = 4.0 * f64::EPSILON;

/// Half a last place of numbers up to 2, in either coordinate.
const ENDS: f64 = 0.75 * f64::EPSILON;

/// The error bound of a sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::claims) struct Mu {
    /// The perturbation of the arrangement.
    pub(in crate::claims) arrangement: f64,
    /// The errors of both realizations and of the ends of sum segments.
    pub(in crate::claims) realization: f64,
}

impl Mu {
    /// Of the monotonic sum of a case; none if there is no sum or no realization.
    pub(in crate::claims) fn of(case: &Case) -> Option<Self> {
        Self::by(case, &Options::default())
    }

    /// Of the sum with these options.
    pub(in crate::claims) fn by(case: &Case, options: &Options) -> Option<Self> {
        let sum = sum(&case.a, &case.b, options).ok()?;
        let [a, b] = stored(&case.a, &case.b).ok()?.map(|region| realize(&region).ok());
        let realization = a?.moved.greatest() + b?.moved.greatest() + ENDS;
        Some(Self { arrangement: perturbation(&sum.arrangement) + DOUBLES, realization })
    }

    /// The sum of both.
    pub(in crate::claims) fn whole(self) -> f64 {
        self.arrangement + self.realization
    }

    /// Whether the operands of a case are 2 mu separated for certain.
    pub(in crate::claims) fn separates(self, case: &Case) -> bool {
        let least = separation::measure(case).ok().and_then(|found| found.lo);
        least.is_some_and(|least| least >= 2.0 * self.whole())
    }
}

/// How far curves have to be moved for the order of the sweep and the vertices to be right.
fn perturbation(arrangement: &Arrangement) -> f64 {
    let graph = &arrangement.graph;
    let off = |curve: &Curve, p: DVec2| {
        if curve.is_vertical() { (p.x - curve.left.x).abs() } else { curve.side(p).abs() }
    };
    let at_vertex = graph.edges.iter().flat_map(|edge| {
        let curve = &graph.curves[edge.curve as usize];
        [edge.from, edge.to].map(|vertex| off(curve, graph.points[vertex as usize]))
    });
    let mut events: Vec<f64> = arrangement.trapezoids.iter().flat_map(|t| [t.from, t.to]).collect();
    events.sort_by(f64::total_cmp);
    events.dedup();
    let in_slab = events.windows(2).map(|slab| {
        let middle = slab[0].midpoint(slab[1]);
        let curves: Vec<&Curve> =
            status(&arrangement.trapezoids, middle).iter().map(|curve| &graph.curves[*curve as usize]).collect();
        let at = [slab[0], middle, slab[1]].map(|x| inversion(&curves, x));
        0.5 * at[0].max(at[1]).max(at[2])
    });
    at_vertex.chain(in_slab).fold(0.0, f64::max)
}

/// How far the lower one of two curves is beyond the upper one at an abscissa, at most.
fn inversion(curves: &[&Curve], x: f64) -> f64 {
    let pairs = (0..curves.len()).flat_map(|i| (i + 1..curves.len()).map(move |j| (curves[i], curves[j])));
    let beyond = pairs.map(|(lower, upper)| {
        let [low, high] = [lower, upper].map(|curve| DVec2::new(x, curve.y_at(x)));
        // Whichever is nearer: where one of them is steep, that is the way to the steep one.
        if low.y <= high.y { 0.0 } else { upper.side(low).abs().min(lower.side(high).abs()) }
    });
    beyond.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{disc, polygon, rectangle};

    fn case(a: arcsum::region::Region, b: arcsum::region::Region) -> Case {
        Case { name: "c".into(), family: "f".into(), a, b, seed: None, golden: None }
    }

    #[test]
    fn mu_is_a_few_roundings() {
        let of_discs = Mu::of(&case(disc(1.0), disc(0.3))).unwrap();
        assert!((1e-16..1e-14).contains(&of_discs.whole()), "{of_discs:?}");
        let square = polygon(&rectangle([0.0, 0.0], [1.0, 1.0]));
        let of_squares = Mu::of(&case(square.clone(), square.clone())).unwrap();
        assert_eq!(of_squares.arrangement, DOUBLES);
        assert!(of_squares.separates(&case(square.clone(), square)));
    }
}

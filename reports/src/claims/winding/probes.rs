//! Points to count winding numbers at: near vertices of the convolution, where cells are small, and anywhere in its box.

use super::super::input::Input;
use crate::cases::Case;
use crate::cases::rng::Rng;
use arcsum_oracle::point::Point;
use arcsum_oracle::region::ExactRegion;
use rug::Rational;

/// A pair of polygons as the oracle reads them, of which one is bounded.
pub(super) fn exact(input: &Input) -> Option<[ExactRegion<Rational>; 2]> {
    let case = input.as_pair().filter(|case| case.is_polygonal())?;
    let read = |region| ExactRegion::from_plain(&crate::bridge::plain(region)).ok();
    let (a, b) = (read(&case.a)?, read(&case.b)?);
    let is_known = a.is_empty() || b.is_empty() || (a.unbounded() && b.unbounded());
    (!is_known).then_some([a, b])
}

/// So many points for a pair, always the same.
pub(super) fn points(case: &Case, count: usize) -> Vec<[f64; 2]> {
    let mut rng = Rng::new(0, "probes");
    let vertices = |region: &arcsum::region::Region| -> Vec<[f64; 2]> {
        region.loops.iter().flatten().map(|node| [node.x, node.y]).collect()
    };
    let (a, b) = (vertices(&case.a), vertices(&case.b));
    let [low, high] = [f64::min, f64::max].map(|f| {
        [0, 1].map(|i| {
            let end = |points: &[[f64; 2]]| points.iter().map(|p| p[i]).reduce(f).unwrap_or_default();
            end(&a) + end(&b)
        })
    });
    let size = (high[0] - low[0]).max(high[1] - low[1]);
    let point = |k: usize| {
        if k.is_multiple_of(3) || a.is_empty() || b.is_empty() {
            return [0, 1].map(|i| rng.between(low[i], high[i]));
        }
        let (p, q) = (a[rng.below(a.len())], b[rng.below(b.len())]);
        let reach = size * [0.2, 0.02, 1e-4][rng.below(3)];
        [0, 1].map(|i| p[i] + q[i] + reach * rng.between(-1.0, 1.0))
    };
    (0..count).map(point).collect()
}

/// The exact point.
pub(super) fn rational([x, y]: [f64; 2]) -> Option<Point<Rational>> {
    Point::from_f64(x, y)
}

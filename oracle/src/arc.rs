//! Circle segments with rational circles: exact points on them and exact tangents, hence polylines that are certainly
//! inside or certainly outside.
//!
//! A segment of bulge b = tan(sweep/4) from p to q has the rational centre m + k n, where m is the middle of the chord,
//! n the chord turned left by a right angle and k = (1-b²)/(4b), and the rational apex m - (b/2) n. Turned from the apex
//! by the angle with half-angle tangent τ, its points are rational for rational τ, p at τ = -b and q at τ = b. A segment
//! of signed radius has no rational bulge in general, but two neighbouring doubles enclose it, and segments over one
//! chord are nested by their bulge.

use crate::number::Number;
use crate::plain::Bend;
use crate::point::Point;

/// The bulges between which the bulge of a bend lies, the same for a line and for a bulge.
///
/// # Errors
/// The reason why the bend is none: not finite, a radius of 0 or a chord longer than the diameter.
pub fn bulges<Q: Number>(bend: Bend, from: &Point<Q>, to: &Point<Q>) -> Result<[Q; 2], &'static str> {
    match bend {
        Bend::Line => Ok([Q::from_i64(0), Q::from_i64(0)]),
        Bend::Bulge(bulge) => {
            let bulge = Q::from_f64(bulge).ok_or("the bulge is not finite")?;
            Ok([bulge.clone(), bulge])
        }
        Bend::Radius(radius) => {
            let chord = to.minus(from);
            let square = chord.dot(&chord);
            let size = Q::from_f64(radius.abs()).ok_or("the radius is not finite")?;
            let [low, high] = bulges_of_radius(&size, &square)?;
            let zero = Q::from_i64(0);
            Ok(if radius > 0.0 { [low, high] } else { [zero.minus(&high), zero.minus(&low)] })
        }
    }
}

/// Doubles around the bulge b in (0, 1] of the minor arc of this radius over a chord of this squared length L²: from
/// L/(2r) = 2b/(1+b²), which grows with b.
fn bulges_of_radius<Q: Number>(radius: &Q, square: &Q) -> Result<[Q; 2], &'static str> {
    let four = Q::from_i64(4);
    let diameter = radius.times(radius).times(&four);
    if radius.sign().is_eq() {
        return Err("the radius is 0");
    }
    if diameter < *square {
        return Err("the chord is longer than the diameter");
    }
    let sine = square.over(&diameter).enclosure().sqrt().mid().min(1.0);
    let guess = sine / (1.0 + (1.0 - sine * sine).sqrt());
    // 2b/(1+b²) <= L/(2r), squared.
    let not_above = |b: f64| {
        let b = Q::from_f64(b)?;
        let left = b.times(&b).times(&diameter).times(&four);
        let right = b.times(&b).plus(&Q::from_i64(1));
        Some(left <= right.times(&right).times(square))
    };
    let unusable = "the radius is too large for the chord";
    let mut low = guess.min(1.0);
    let mut step = f64::EPSILON;
    while !not_above(low).ok_or(unusable)? {
        low = (guess * (1.0 - step)).min(1.0);
        step *= 2.0;
    }
    let mut high = low;
    let mut step = f64::EPSILON;
    while high < 1.0 && not_above(high).ok_or(unusable)? {
        high = (low * (1.0 + step)).min(1.0);
        step *= 2.0;
    }
    Ok([low, high].map(|b| Q::from_f64(b).expect("between 0 and 1")))
}

/// A circle segment of rational bulge that is not 0.
pub struct Arc<'a, Q> {
    from: &'a Point<Q>,
    centre: Point<Q>,
    /// From the centre to the apex.
    spoke: Point<Q>,
    bulge: Q,
}

impl<'a, Q: Number> Arc<'a, Q> {
    /// The segment of this bulge between two points; `None` for a bulge of 0.
    #[must_use]
    pub fn new(from: &'a Point<Q>, to: &'a Point<Q>, bulge: Q) -> Option<Self> {
        if bulge.sign().is_eq() {
            return None;
        }
        let chord = to.minus(from);
        let normal = Point { x: Q::from_i64(0).minus(&chord.y), y: chord.x.clone() };
        let half = Q::from_i64(1).over(&Q::from_i64(2));
        let middle = from.toward(to, &half);
        let rise = Q::from_i64(1).minus(&bulge.times(&bulge)).over(&bulge.times(&Q::from_i64(4)));
        let centre = middle.plus(&normal.times(&rise));
        let apex = middle.minus(&normal.times(&bulge.times(&half)));
        Some(Self { from, spoke: apex.minus(&centre), centre, bulge })
    }

    /// A polyline of about `pieces` chords, at least two: points exactly on the segment, without its end.
    #[must_use]
    pub fn chords(&self, pieces: usize) -> Vec<Point<Q>> {
        let parameters = self.parameters(pieces);
        let points = parameters[1..parameters.len() - 1].iter().map(|t| self.turned(t, t));
        std::iter::once(self.from.clone()).chain(points).collect()
    }

    /// A polyline of tangents that touch the segment at its ends and at the points of [`Self::chords`], without its end.
    #[must_use]
    pub fn tangents(&self, pieces: usize) -> Vec<Point<Q>> {
        let parameters = self.parameters(pieces);
        let points = parameters.windows(2).map(|pair| self.turned(&pair[0], &pair[1]));
        std::iter::once(self.from.clone()).chain(points).collect()
    }

    /// Where the tangents at τ and σ meet: the spoke turned and stretched to
    /// ((1-τσ) spoke + (τ+σ) spoke turned left) / (1+τσ). For τ = σ the point of the circle.
    fn turned(&self, tau: &Q, sigma: &Q) -> Point<Q> {
        let one = Q::from_i64(1);
        let product = tau.times(sigma);
        let left = Point { x: Q::from_i64(0).minus(&self.spoke.y), y: self.spoke.x.clone() };
        let vector = self.spoke.times(&one.minus(&product)).plus(&left.times(&tau.plus(sigma)));
        self.centre.plus(&vector.times(&one.over(&one.plus(&product))))
    }

    /// Half-angle tangents from -b to b at nearly equal angles. The ones inside are short, which keeps the coordinates
    /// short; that they run strictly from end to end and that neighbours are less than half a turn apart is all that
    /// matters, and so there are at least two pieces.
    fn parameters(&self, pieces: usize) -> Vec<Q> {
        let pieces = pieces.max(2);
        let quarter = self.bulge.nearest().atan();
        let inner = (1..pieces).map(|i| short((quarter * (2.0 * i as f64 / pieces as f64 - 1.0)).tan()));
        let mut parameters = vec![Q::from_i64(0).minus(&self.bulge)];
        let runs_on = |from: &Q, to: &Q| to.minus(from).sign() == self.bulge.sign();
        for next in inner.filter_map(Q::from_f64) {
            if runs_on(&parameters[parameters.len() - 1], &next) && runs_on(&next, &self.bulge) {
                parameters.push(next);
            }
        }
        parameters.push(self.bulge.clone());
        parameters
    }
}

/// A double with ten leading bits of this one.
fn short(x: f64) -> f64 {
    let unit = (x.abs().log2().floor() - 10.0).exp2();
    if x == 0.0 { 0.0 } else { (x / unit).round() * unit }
}

#[cfg(test)]
mod tests {
    use super::{Arc, bulges};
    use crate::number::Number;
    use crate::plain::Bend;
    use crate::point::Point;
    use proptest::prelude::*;
    use rug::Rational;

    fn point(x: f64, y: f64) -> Point<Rational> {
        Point::from_f64(x, y).expect("finite")
    }

    proptest! {
        #[test]
        fn chords_end_on_the_circle_and_tangents_touch_it(
            x in -2.0..2.0f64, y in -2.0..2.0f64, bulge in -6.0..6.0f64, pieces in 2usize..20
        ) {
            prop_assume!(bulge != 0.0 && (x != 0.0 || y != 0.0));
            let (from, to) = (point(0.0, 0.0), point(x, y));
            let exact = <Rational as Number>::from_f64(bulge).expect("finite");
            let arc = Arc::new(&from, &to, exact).expect("a bulge that is not 0");
            let power = |p: &Point<Rational>| p.minus(&arc.centre).dot(&p.minus(&arc.centre));
            let square = power(&from);
            prop_assert_eq!(&power(&to), &square);
            prop_assert!(arc.chords(pieces).iter().all(|p| power(p) == square));
            let mut path = arc.tangents(pieces);
            path.push(to.clone());
            for side in path.windows(2) {
                let step = side[1].minus(&side[0]);
                let arm = arc.centre.minus(&side[0]).cross(&step);
                prop_assert_eq!(arm.times(&arm), square.times(&step.dot(&step)));
            }
            // Both paths turn one way only, by less than a full turn.
            path = arc.chords(pieces);
            path.push(to.clone());
            for side in path.windows(3) {
                let turn = side[1].minus(&side[0]).cross(&side[2].minus(&side[1]));
                prop_assert_eq!(turn.sign(), arc.bulge.sign());
            }
        }

        #[test]
        fn the_bulge_of_a_radius_is_enclosed(x in 0.01..2.0f64, y in -2.0..2.0f64, longer in 0.0..3.0f64, left in any::<bool>()) {
            let (from, to) = (point(0.0, 0.0), point(x, y));
            let size = 0.5 * x.hypot(y) * (1.0 + longer) + 1e-15;
            let radius = if left { size } else { -size };
            let [low, high] = bulges(Bend::Radius(radius), &from, &to).expect("long enough");
            prop_assert!(low <= high && high.minus(&low) <= Rational::from((1, 1u64 << 20)));
            let square = |b: &Rational| {
                // The squared radius of the circle segment of bulge b.
                let arc = Arc::new(&from, &to, b.clone()).expect("not 0");
                arc.spoke.dot(&arc.spoke)
            };
            let exact = <Rational as Number>::from_f64(size).expect("finite").square();
            let (small, large) = if left { (low, high) } else { (-high, -low) };
            // A smaller bulge has a larger radius.
            prop_assert!(square(&small) >= exact && (square(&large) <= exact || large == 1));
        }
    }

    #[test]
    fn a_half_circle_of_given_radius_is_exact_from_above() {
        let [low, high] = bulges(Bend::Radius(1.0), &point(-1.0, 0.0), &point(1.0, 0.0)).expect("a half circle");
        assert_eq!((low, high), (Rational::from(1), Rational::from(1)));
        assert!(bulges(Bend::Radius(0.99), &point(-1.0, 0.0), &point(1.0, 0.0)).is_err());
    }
}

//! Fits of a curve by chords and by tangent-continuous pairs of arcs (biarcs), and what no fit by arcs can do.

use super::curves::Curve;
use glam::DVec2;

/// Places of a span at which a distance is computed.
const OF_CHORD: usize = 16;
const OF_BIARC: usize = 1024;
/// How finely the longest span is sought.
const STEPS: usize = 40;
/// What the roundings of a distance of about 1 come to, with room.
const ROUNDINGS: f64 = 1e-12;

/// The number of chords of a greedy fit that the curve is nowhere farther from than the tolerance.
pub(super) fn chords(curve: &Curve, tolerance: f64) -> usize {
    spans(|from, to| deviation_of_chord(curve, from, to) <= tolerance)
}

/// The number of arcs, two a span, likewise.
pub(super) fn arcs(curve: &Curve, tolerance: f64) -> usize {
    2 * spans(|from, to| deviation_of_biarc(curve, from, to) <= tolerance)
}

/// No fit has fewer arcs: so many disjoint spans cannot be followed by a single arc or line within the tolerance, so every
/// one of them has a joint inside. To follow is to pass points near those of the span in their order.
///
/// Let four points of a span be outside, inside, outside, inside a circle by more than the tolerance, or the
/// other way round. An arc that passes within the tolerance of them, in their order, passes outside, inside, outside and inside
/// of the circle, so it crosses it three times. Different circles cross at most twice.
pub(super) fn least_arcs(curve: &Curve, tolerance: f64) -> usize {
    let mut from = 0.0;
    let mut count = 0;
    // The shortest span that has such points, and then the next one.
    while let Some(to) = first(from, |to| alternation(curve, from, to) > tolerance + ROUNDINGS) {
        count += 1;
        from = to;
    }
    count
}

/// The number of spans from 0 to 1 if each is as long as it may be.
fn spans(fits: impl Fn(f64, f64) -> bool) -> usize {
    let (mut from, mut count) = (0.0, 0);
    while from < 1.0 {
        let to = if fits(from, 1.0) { 1.0 } else { first(from, |to| !fits(from, to)).unwrap_or(1.0) };
        // What `first` finds no longer fits, but does so less than a billionth before.
        from = if to < 1.0 { back(from, to, &fits) } else { 1.0 };
        count += 1;
    }
    count
}

/// The last place before `to` that fits, down from where it is known not to.
fn back(from: f64, to: f64, fits: &impl Fn(f64, f64) -> bool) -> f64 {
    let mut length = to - from;
    while !fits(from, from + length) {
        length *= 1.0 - 1e-6;
    }
    from + length
}

/// About the first place after `from` where something holds: it holds there. Sought by doubling and halving.
fn first(from: f64, holds: impl Fn(f64) -> bool) -> Option<f64> {
    let mut length = 1e-6;
    while !holds(from + length) {
        if from + length >= 1.0 {
            return None;
        }
        length = (1.25 * length).min(1.0 - from);
    }
    let (mut no, mut yes) = (length / 1.25, length);
    for _ in 0..STEPS {
        let middle = 0.5 * (no + yes);
        if holds(from + middle) { yes = middle } else { no = middle }
    }
    Some(from + yes)
}

/// An upper bound of the distance of a span from its chord's line: the greatest at some places, and what a function with a bounded
/// second derivative can exceed that by in between.
fn deviation_of_chord(curve: &Curve, from: f64, to: f64) -> f64 {
    let [p, q] = [from, to].map(|t| (curve.at)(t)[0]);
    let normal = (q - p).perp().normalize_or_zero();
    let step = (to - from) / OF_CHORD as f64;
    let places = (1..OF_CHORD).map(|i| (curve.at)(from + i as f64 * step)[0]);
    places.map(|r| (r - p).dot(normal).abs()).fold(0.0, f64::max) + step * step * curve.bend / 8.0
}

/// A circle, or a line if it is none: what an arc with this tangent at a point through another point lies on.
enum Carrier {
    Circle { centre: DVec2, radius: f64 },
    Line { point: DVec2, normal: DVec2 },
}

impl Carrier {
    fn through(point: DVec2, tangent: DVec2, other: DVec2) -> Self {
        let normal = tangent.normalize().perp();
        let way = other - point;
        let height = way.dot(normal);
        if height.abs() < 1e-9 * way.length_squared() {
            return Self::Line { point, normal };
        }
        let radius = way.length_squared() / (2.0 * height);
        Self::Circle { centre: point + radius * normal, radius: radius.abs() }
    }

    fn distance(&self, p: DVec2) -> f64 {
        match self {
            Self::Circle { centre, radius } => ((p - centre).length() - radius).abs(),
            Self::Line { point, normal } => (p - point).dot(*normal).abs(),
        }
    }

    /// A bound of the second derivative of the distance along a curve near it.
    fn bend(&self, curve: &Curve) -> f64 {
        match self {
            Self::Circle { radius, .. } => curve.bend + 2.0 * curve.speed * curve.speed / radius,
            Self::Line { .. } => curve.bend,
        }
    }
}

/// An upper bound of the distance of a span from the biarc with its ends and tangents there whose control legs are equally
/// long; infinite if there is none.
fn deviation_of_biarc(curve: &Curve, from: f64, to: f64) -> f64 {
    let [[p, u], [q, v]] = [from, to].map(curve.at);
    let (u, v, way) = (u.normalize(), v.normalize(), q - p);
    // Legs d with |way - d (u + v)| = 2 d.
    let (a, b, c) = (2.0 * (1.0 - u.dot(v)), way.dot(u + v), way.length_squared());
    if u.dot(v) < 0.5 || b <= 0.0 {
        return f64::INFINITY;
    }
    let leg = c / (b + (b * b + a * c).sqrt());
    let (first, second) = (p + leg * u, q - leg * v);
    let (joint, tangent) = (0.5 * (first + second), second - first);
    let carriers = [Carrier::through(p, u, joint), Carrier::through(q, v, joint)];
    let step = (to - from) / OF_BIARC as f64;
    let distance = |i: usize| {
        let place = (curve.at)(from + i as f64 * step)[0];
        carriers[usize::from((place - joint).dot(tangent) > 0.0)].distance(place)
    };
    let bend = carriers.iter().map(|carrier| carrier.bend(curve)).fold(0.0, f64::max);
    (0..=OF_BIARC).map(distance).fold(0.0, f64::max) + step * step * bend / 8.0
}

/// By how much four points of a span alternate about a circle: 0 if they do not. The circle is concentric with the one
/// through the first and third and the one through the second and fourth, halfway between them.
fn alternation(curve: &Curve, from: f64, to: f64) -> f64 {
    // The extrema of the third Chebyshev polynomial.
    let [p, q, r, s] = [0.0, 0.25, 0.75, 1.0].map(|part| (curve.at)(from + part * (to - from))[0]);
    let (u, v) = (r - p, s - q);
    let (m, n) = (0.5 * u.dot(p + r), 0.5 * v.dot(q + s));
    let cross = u.perp_dot(v);
    if cross == 0.0 {
        return 0.0;
    }
    let centre = DVec2::new(m * v.y - n * u.y, n * u.x - m * v.x) / cross;
    let distances = [p, q, r, s].map(|point| (point - centre).length());
    let radius = 0.25 * distances.iter().sum::<f64>();
    let [a, b, c, d] = distances.map(|distance| distance - radius);
    let alternates = a * b < 0.0 && b * c < 0.0 && c * d < 0.0;
    // A centre far away leaves few digits: then nothing is claimed.
    if !alternates || radius > 1e3 { 0.0 } else { [a, b, c, d].map(f64::abs).into_iter().fold(f64::INFINITY, f64::min) }
}

#[cfg(test)]
mod tests {
    use super::super::curves::{CIRCLE, CURVES};
    use super::*;

    #[test]
    fn a_circle_takes_few_arcs_and_the_chords_of_the_books() {
        assert!(arcs(&CIRCLE, 1e-6) <= 16 && least_arcs(&CIRCLE, 1e-6) == 0);
        // A chord over an angle of 2x misses by 1 - cos x.
        for tolerance in [1e-3, 1e-5] {
            let expected = std::f64::consts::PI / libm::acos(1.0 - tolerance);
            let found = chords(&CIRCLE, tolerance) as f64;
            assert!(expected <= found && found <= 1.01 * expected + 1.0, "{found} {expected}");
        }
    }

    #[test]
    fn no_fit_has_fewer_arcs_than_it_can() {
        for curve in CURVES {
            for tolerance in [1e-2, 1e-3, 1e-4] {
                let (least, fitted) = (least_arcs(&curve, tolerance), arcs(&curve, tolerance));
                assert!(least <= fitted && fitted <= 12 * least.max(1), "{} {least} {fitted}", curve.name);
            }
        }
    }
}

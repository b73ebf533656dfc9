//! Smooth closed curves of about the size of the unit box, to be fitted.

use glam::DVec2;
use libm::{cos, sin};
use std::f64::consts::TAU;

/// A closed curve over the parameters 0 to 1.
#[derive(Clone, Copy)]
pub(super) struct Curve {
    /// What it is.
    pub(super) name: &'static str,
    /// The point and the derivative at a parameter.
    pub(super) at: fn(f64) -> [DVec2; 2],
    /// No first derivative is longer than this.
    pub(super) speed: f64,
    /// No second derivative is longer than this.
    pub(super) bend: f64,
}

/// Curves as models have them: no part of any is a circle.
pub(super) const CURVES: [Curve; 4] = [
    Curve { name: "ellipse 1 : 0.6", at: |t| ellipse(0.6, t), speed: TAU, bend: TAU * TAU },
    Curve { name: "ellipse 1 : 0.25", at: |t| ellipse(0.25, t), speed: TAU, bend: TAU * TAU },
    // Radius 1, its first and its second derivative are at most 1.1, 0.3 and 0.9.
    Curve { name: "wave", at: wave, speed: TAU * 1.4, bend: TAU * TAU * 2.6 },
    Curve { name: "cubic spline", at: spline, speed: 8.0, bend: 8.0 * 8.0 * 2.0 },
];

/// A circle.
#[cfg(test)]
pub(super) const CIRCLE: Curve = Curve { name: "circle", at: |t| ellipse(1.0, t), speed: TAU, bend: TAU * TAU };

fn ellipse(ratio: f64, t: f64) -> [DVec2; 2] {
    let (s, c) = (sin(TAU * t), cos(TAU * t));
    [DVec2::new(c, ratio * s), TAU * DVec2::new(-s, ratio * c)]
}

fn wave(t: f64) -> [DVec2; 2] {
    let angle = TAU * t;
    let (radius, change) = (1.0 + 0.1 * cos(3.0 * angle), -0.3 * sin(3.0 * angle));
    let out = DVec2::new(cos(angle), sin(angle));
    [radius * out, TAU * (change * out + radius * out.perp())]
}

/// The control points of the spline: steps between them are at most 1 long, second differences at most 2.
const CONTROLS: [[f64; 2]; 8] =
    [[1.0, 0.0], [0.9, 0.5], [0.2, 0.8], [-0.6, 0.6], [-0.8, 0.0], [-0.5, -0.4], [0.1, -0.3], [0.7, -0.6]];

/// A uniform cubic spline.
fn spline(t: f64) -> [DVec2; 2] {
    let n = CONTROLS.len();
    let place = t.rem_euclid(1.0) * n as f64;
    let span = (place.floor() as usize).min(n - 1);
    let u = place - span as f64;
    let point = |i: usize| DVec2::from(CONTROLS[(span + i) % n]);
    let v = 1.0 - u;
    let weights = [v * v * v, 3.0 * u * u * u - 6.0 * u * u + 4.0, 3.0 * v * v * v - 6.0 * v * v + 4.0, u * u * u];
    let slopes = [-v * v, u * (3.0 * u - 4.0), v * (4.0 - 3.0 * v), u * u];
    let sum = |of: [f64; 4]| (0..4).map(|i| of[i] * point(i)).fold(DVec2::ZERO, |sum, p| sum + p);
    [sum(weights) / 6.0, n as f64 * sum(slopes) / 2.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_what_points_do_and_within_their_bounds() {
        for curve in CURVES.into_iter().chain([CIRCLE]) {
            for i in 0..1000 {
                let (t, h) = (f64::from(i) / 1000.0, 1e-4);
                let [[before, _], [here, slope], [after, _]] = [t - h, t, t + h].map(curve.at);
                assert!(((after - before) / (2.0 * h) - slope).length() < 1e-4, "{} {t}", curve.name);
                assert!(slope.length() <= curve.speed + 1e-9, "{} {t}", curve.name);
                assert!(
                    ((after - here) - (here - before)).length() / (h * h) <= curve.bend + 1e-3,
                    "{} {t}",
                    curve.name
                );
            }
        }
    }
}

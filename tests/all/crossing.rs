//! The contract of the crossing module, against MPFR (memo C1): wherever it says that f runs below g, no point of f lies
//! above g by more than a few eps. The worst excess in eps is printed.

use arcsum::angle::Ang;
use arcsum::arrangement::cross::{CrossingModule, Crossings, EPS, FloatModule};
use arcsum::arrangement::curve::Curve;
use arcsum::piece::{Piece, Source};
use arcsum_tests::cases;
use glam::DVec2;
use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use rug::{Assign, Float};
use std::f64::consts::FRAC_PI_2;

const PRECISION: u32 = 300;

fn big(x: f64) -> Float {
    Float::with_val(PRECISION, x)
}

/// The exact circle or line through the ends of a curve, with the half sweep taken literally.
struct Exact {
    left: [Float; 2],
    right: [Float; 2],
    delta: Float,
}

impl Exact {
    fn new(c: &Curve) -> Self {
        let point = |p: DVec2| [big(p.x), big(p.y)];
        Self { left: point(c.left), right: point(c.right), delta: big(c.delta) }
    }

    /// The point that divides the sweep at this fraction: tail + sin(u)/sin(delta) Rot(-v) chord (memo A5).
    fn point(&self, fraction: f64) -> [Float; 2] {
        let chord: [Float; 2] = [0, 1].map(|i| Float::with_val(PRECISION, &self.right[i] - &self.left[i]));
        let (scale, angle) = if self.delta.is_zero() {
            (big(fraction), big(0.0))
        } else {
            let u = Float::with_val(PRECISION, &self.delta * fraction);
            let v = Float::with_val(PRECISION, &self.delta - &u);
            (u.sin() / Float::with_val(PRECISION, self.delta.sin_ref()), -v)
        };
        let (s, c) = angle.sin_cos(big(0.0));
        let x = Float::with_val(PRECISION, &chord[0] * &c) - Float::with_val(PRECISION, &chord[1] * &s);
        let y = Float::with_val(PRECISION, &chord[0] * &s) + Float::with_val(PRECISION, &chord[1] * &c);
        [x * &scale + &self.left[0], y * &scale + &self.left[1]]
    }

    /// Signed distance of a point above the curve, extended to its whole line or circle.
    fn above(&self, p: &[Float; 2]) -> f64 {
        let (cx, cy) = (
            Float::with_val(PRECISION, &self.right[0] - &self.left[0]),
            Float::with_val(PRECISION, &self.right[1] - &self.left[1]),
        );
        let length = Float::with_val(PRECISION, cx.hypot_ref(&cy));
        let u = [0, 1].map(|i| Float::with_val(PRECISION, &p[i] - &self.left[i]));
        if self.delta.is_zero() {
            let cross = Float::with_val(PRECISION, &cx * &u[1]) - Float::with_val(PRECISION, &cy * &u[0]);
            return (cross / length).to_f64();
        }
        // Centre: the chord's middle plus L/2 cot(delta) to the left.
        let half_cot = Float::with_val(PRECISION, 0.5) / Float::with_val(PRECISION, self.delta.tan_ref());
        let ox = Float::with_val(PRECISION, &cx / 2) - Float::with_val(PRECISION, &cy * &half_cot);
        let oy = Float::with_val(PRECISION, &cy / 2) + Float::with_val(PRECISION, &cx * &half_cot);
        let radius = length / (Float::with_val(PRECISION, self.delta.sin_ref()) * 2_u32);
        let away = Float::with_val(PRECISION, &u[0] - &ox).hypot(&Float::with_val(PRECISION, &u[1] - &oy));
        let mut out = Float::new(PRECISION);
        // Above a curve that bends upwards is towards its centre.
        if radius.is_sign_positive() {
            out.assign(&radius - &away)
        } else {
            out.assign(&away + &radius)
        }
        out.to_f64()
    }
}

/// A curve with these ends whose normals, from left to right, go from `a` through twice `delta`.
pub fn curve(index: u32, ends: [(u32, DVec2); 2], delta: f64) -> Option<Curve> {
    let gamma = Ang::of_line(ends[0].1, ends[1].1)?;
    let (a, b) = (gamma.plus(-delta), gamma.plus(delta));
    let source = Source::default();
    let piece = Piece { tail: 0, head: 0, a, b, whole: [0; 2], delta, r: 0.0, source, operand: 0, weight: 1 };
    Curve::new(index, &piece, ends[0], ends[1], [ends[0].1, ends[1].1])
}

/// Largest amount, in eps, by which points of f contradict the module's order.
fn excess(f: &Curve, g: &Curve, answer: &Crossings) -> f64 {
    let (exact_f, exact_g) = (Exact::new(f), Exact::new(g));
    let mut worst = 0.0_f64;
    let crossing_fractions = answer.points().iter().map(|p| (p.at - f.left).length() / f.chord().length());
    let near = |c: f64| [-1e-3, -1e-7, -1e-12, 0.0, 1e-12, 1e-7, 1e-3].map(|d| c + d);
    let spread = (0..=20).map(|i| f64::from(i) / 20.0);
    for fraction in spread.chain(crossing_fractions.flat_map(near)).filter(|t| (0.0..=1.0).contains(t)) {
        let p = exact_f.point(fraction);
        let q = DVec2::new(p[0].to_f64(), p[1].to_f64());
        let inside = q.x > g.left.x && q.x < g.right.x;
        if !inside || g.is_vertical() {
            continue;
        }
        let passed = answer.points().iter().filter(|c| c.compare(&q.into()).is_le()).count();
        let below = answer.below ^ (passed % 2 == 1);
        let above = exact_g.above(&p);
        // Outside the box of a monotone arc its circle says nothing.
        let (low, high) = g.y_range();
        let above = if q.y > high {
            above.abs()
        } else if q.y < low {
            -above.abs()
        } else {
            above
        };
        worst = worst.max(if below { above } else { -above } / EPS);
    }
    worst
}

fn monotone(c: &Curve) -> bool {
    let chord = c.chord();
    let direction = chord.y.atan2(chord.x);
    let quadrant = |d: f64| (if chord.y >= 0.0 { d } else { -d }) >= 0.0 && d.abs() <= FRAC_PI_2;
    quadrant(direction - c.delta) && quadrant(direction + c.delta)
}

fn point() -> impl Strategy<Value = DVec2> {
    (-1.0..1.0, -1.0..1.0).prop_map(|(x, y)| DVec2::new(x, y))
}

/// Half sweeps of all sizes, 0 included.
fn half_sweep() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        (-0.7..0.7),
        (any::<bool>(), -16.0..-0.5).prop_map(|(s, e): (bool, f64)| if s { 10_f64.powf(e) } else { -(10_f64.powf(e)) }),
    ]
}

/// Pairs: in general position; the second starting or ending on the first or its end, or bundled with it within 1e-15 to
/// 1e-6, so that crossings are badly conditioned.
fn pair() -> impl Strategy<Value = (Curve, Curve)> {
    let free = (point(), point(), point(), point(), half_sweep(), half_sweep());
    (free, 0..6, -16.0..-5.0, 0.0..1.0).prop_filter_map("not monotone", |((p, q, r, s, d, e), kind, exponent, t)| {
        let near = |x: DVec2, y: DVec2| x + (y - x) * 10_f64.powf(exponent);
        let f = curve(0, [(0, p), (1, q)], d)?;
        let x = f.left.x + t * (f.right.x - f.left.x);
        let on_f = DVec2::new(x, f.y_at(x));
        let (ends, e) = match kind {
            0 => ([(2, r), (3, s)], e),
            1 => ([(f.first, f.left), (3, r)], e),
            2 => ([(2, r), (f.last, f.right)], e),
            3 => ([(2, on_f), (3, r)], e),
            4 => ([(2, near(f.left, r)), (3, near(f.right, s))], f.delta),
            _ => ([(2, near(f.left, r)), (3, near(f.right, s))], f.delta + e * 10_f64.powf(exponent)),
        };
        let g = curve(1, ends, e)?;
        let overlap = f.left.x.max(g.left.x) < f.right.x.min(g.right.x);
        (overlap && monotone(&f) && monotone(&g)).then_some((f, g))
    })
}

/// The module's tolerance is 4 eps of a box of side 2; its point tests, at both ends and between crossings, err by a few
/// eps more.
const BOUND: f64 = 24.0;

#[test]
fn order_is_right_to_a_few_eps() {
    let worst = std::cell::Cell::new(0.0_f64);
    let result = TestRunner::new(cases(8000)).run(&pair(), |(f, g)| {
        let answer = FloatModule::new(2.0).cross(&f, &g);
        for (f, g, answer) in [(&f, &g, answer), (&g, &f, answer.exchanged())] {
            let e = excess(f, g, &answer);
            worst.set(worst.get().max(e));
            prop_assert!(e <= BOUND, "{e} eps, {answer:?}");
        }
        Ok(())
    });
    println!("worst order error {:.2} eps", worst.get());
    if let Err(e) = result {
        panic!("{e}");
    }
}

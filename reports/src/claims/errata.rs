//! The errata of the papers (memo A9), each with a witness: numbers that a reader can check by hand or in a few lines of any
//! language, or the claim whose experiment shows it.

use super::formulas::angle::{ANGLES, REALIZED_IN_RADIANS};
use super::formulas::three_terms::two_dekkers;
use arcsum::sum3::Rounding;
use libm::{atan, atan2, cos, log, pow, sin, tan};
use std::f64::consts::FRAC_PI_2;

/// A wrong or silent place of a paper.
#[derive(Clone, Copy)]
pub struct Erratum {
    /// The paper and section.
    pub place: &'static str,
    /// What it prints.
    pub printed: &'static str,
    /// What is right.
    pub right: &'static str,
    /// What shows it.
    pub proof: Proof,
}

/// What shows an erratum.
#[derive(Clone, Copy)]
pub enum Proof {
    /// Numbers: the words say of what, the function computes by the print, as corrected, and in truth by another way.
    Numbers(&'static str, fn() -> [f64; 3]),
    /// The experiment on this claim.
    Claim(&'static str),
    /// A remark about the text, which numbers cannot show.
    Words(&'static str),
}

/// Sums of the times of Table 1 of MS in milliseconds: two- and three-part packings of the nine parts, by the kinetic and by the
/// monotonic algorithm.
const TIMES: [[f64; 4]; 9] = [
    [67.0, 40.0, 131.0, 129.0],
    [662.0, 341.0, 616.0, 479.0],
    [9185.0, 5037.0, 5686.0, 3726.0],
    [67.0, 39.0, 98.0, 78.0],
    [140.0, 53.0, 163.0, 112.0],
    [315.0, 93.0, 219.0, 102.0],
    [82.0, 54.0, 126.0, 93.0],
    [32.0, 25.0, 42.0, 35.0],
    [2024.0, 872.0, 2059.0, 1299.0],
];

/// The share of these that robustness takes, T_f of Table 1, in the same order.
const ROBUSTNESS: [[f64; 4]; 9] = [
    [1.0, 2.0, 0.0, 2.0],
    [10.0, 6.0, 6.0, 9.0],
    [164.0, 74.0, 116.0, 53.0],
    [1.0, 0.0, 1.0, 1.0],
    [2.0, 1.0, 2.0, 2.0],
    [4.0, 2.0, 2.0, 1.0],
    [1.0, 1.0, 1.0, 1.0],
    [0.0, 1.0, 0.0, 1.0],
    [32.0, 18.0, 31.0, 21.0],
];

/// All errata, in the order of the papers.
pub const ERRATA: [Erratum; 26] = [
    Erratum {
        place: "MS 1",
        printed: "Arcs make models quadratically smaller, 100 to 1000 times at 4 to 6 digits.",
        right: "Smooth arc splines err by O(h^3): as many arcs as lines to the power 2/3, 5 to 10 times fewer.",
        proof: Proof::Claim("M2"),
    },
    Erratum {
        place: "MS 3",
        printed: "The winding number of a cell counts the components of A ∩ (-B + u).",
        right: "It is the Euler characteristic, components less holes.",
        proof: Proof::Claim("M3 printed"),
    },
    Erratum {
        place: "MS 3",
        printed: "radius(a + b) = radius(a) + radius(b).",
        right: "Negated where the sum runs backwards, as that of two concave arcs does.",
        proof: Proof::Numbers(
            "signed radius of the sum of two concave quarter circles of radius -1, normals from 0 to 90 degrees",
            backward_radius,
        ),
    },
    Erratum {
        place: "MS 3, Fig. 2b",
        printed: "head(e) = h1 + t2 < h1 + t2 = tail(e).",
        right: "head(e) = t1 + h2 < h1 + t2 = tail(e).",
        proof: Proof::Numbers(
            "tail less head for t1 = 1, h1 = 0, t2 = 3, h2 = 0, against |t2 - h2| - |t1 - h1|",
            || {
                let [t1, h1, t2, h2]: [f64; 4] = [1.0, 0.0, 3.0, 0.0];
                let (tail, printed_head, head) = (h1 + t2, h1 + t2, t1 + h2);
                [tail - printed_head, tail - head, (t2 - h2).abs() - (t1 - h1).abs()]
            },
        ),
    },
    Erratum {
        place: "MS 4",
        printed: "Negative winding numbers are impossible in exact arithmetic.",
        right: "With holes that should have been filled they are possible.",
        proof: Proof::Words(
            "A square with two holes and a larger square over it: the overlap is one component with two holes, 1 - 2 = -1.",
        ),
    },
    Erratum {
        place: "MS 4.1, 4.2",
        printed: "gamma = arctan((h_y - t_y)/(t_x - h_x)).",
        right: "The arc tangent of the inverse fraction, atan2(t_x - h_x, h_y - t_y).",
        proof: Proof::Numbers(
            "normal angle of the line from (0, 0) to (1, 2) in radians, a quarter turn right of (1, 2)",
            || [atan(2.0 / -1.0), atan2(-1.0, 2.0), atan2(2.0, 1.0) - FRAC_PI_2],
        ),
    },
    Erratum {
        place: "MS 4.1",
        printed: "The second form of d_x, without theta - alpha.",
        right: "It holds for theta = gamma only.",
        proof: Proof::Numbers("d_x at 30 degrees on the quarter of the unit circle from (1, 0) to (0, 1)", second_form),
    },
    Erratum {
        place: "MS 4.1",
        printed: "The condition number is about y g(y)/g'(y).",
        right: "y g'(y)/g(y).",
        proof: Proof::Numbers("relative change of y^2 at y = 3 by that of y", || {
            let h = 1e-7;
            [3.0 * 9.0 / 6.0, 3.0 * 6.0 / 9.0, ((3.0 * (1.0 + h)) * (3.0 * (1.0 + h)) - 9.0) / 9.0 / h]
        }),
    },
    Erratum {
        place: "MS 4.1",
        printed: "The only possible bad values are h_y - t_y and t_x - h_x.",
        right: "The arc sine near 1 is one too: delta as an arc tangent with an exact radicand.",
        proof: Proof::Claim("M9 printed"),
    },
    Erratum {
        place: "MS 4.1",
        printed: "Two applications of Dekker's method give the rounded exact sum.",
        right: "Rounding to odd does.",
        proof: Proof::Numbers("1 + 2^-53 + 2^-110, less 1, in units of 2^-52", || {
            let terms = [1.0, pow(2.0, -53.0), pow(2.0, -110.0)];
            let above = |sum: f64| (sum - 1.0) * pow(2.0, 52.0);
            // The exact sum lies above the middle between 1 and the next double.
            [above(two_dekkers(terms)), above(Rounding::Correct.sum(terms[0], terms[1], terms[2])), 1.0]
        }),
    },
    Erratum {
        place: "MS 4.1",
        printed: "p = point(gamma, s).",
        right: "p = point(s, gamma).",
        proof: Proof::Words("The segment comes first where point is defined, on the same page."),
    },
    Erratum {
        place: "MS 4.1",
        printed: "The last line of the sagitta has sin((gamma + alpha)/2) - sin(delta/2).",
        right: "It is their product; the sagitta is (L/2) tan(delta/2).",
        proof: Proof::Numbers("sagitta of an arc of 20 degrees whose chord is 1 long and horizontal", sagitta),
    },
    Erratum {
        place: "MS 4.1",
        printed: "|sin gamma| >= 1/2.",
        right: "Not true, and not needed.",
        proof: Proof::Words("An arc with a vertical chord has gamma = 0 or 180 degrees, and sin gamma = 0."),
    },
    Erratum {
        place: "MS 4.1",
        printed: "An arc that is replaced by its secant is within eps/2 of it.",
        right: "1.40 eps with angles in [0, 2 pi); 0.18 eps with axis and offset.",
        proof: Proof::Claim("M11 printed"),
    },
    Erratum {
        place: "MS 4.1",
        printed: "A line that is split at a horizontal and a vertical moves by eps at most.",
        right: "By 4 eps with angles in [0, 2 pi), 3 eps in (-pi, pi]; with axis and offset none is split.",
        proof: Proof::Claim("M12 printed"),
    },
    Erratum {
        place: "MS 4.2",
        printed: "cot phi is well-conditioned.",
        right: "Not near 180 and 360 degrees in radians; with axis and offset it is.",
        proof: Proof::Numbers("how far the head of the line from (0, 0) to (1e-8, -1) moves, in eps", || {
            let moved = |error: fn(&[f64]) -> Option<f64>| error(&[0.0, 0.0, 1e-8, -1.0]).unwrap_or(f64::NAN);
            let [.., realized_line] = ANGLES;
            [moved(REALIZED_IN_RADIANS.error), moved(realized_line.error), 0.0]
        }),
    },
    Erratum {
        place: "MS 4.2, 6.1",
        printed: "Theorems 1 and 3 bound vertical distances.",
        right: "End points of sums have rounded abscissas: on steep pieces only a Hausdorff distance is small.",
        proof: Proof::Claim("M23 printed"),
    },
    Erratum {
        place: "MS 4.3, Theorem 2",
        printed: "The region on the other side of an edge has winding number 1 or -1.",
        right: "In general position only: two opposite edges may coincide, and the next edge is needed.",
        proof: Proof::Words(
            "Two squares that share an edge, one loop each: beyond the shared edge of one, the opposite edge of the other takes the 1 back.",
        ),
    },
    Erratum {
        place: "MS 5.1",
        printed: "T segments are boundaries, moved.",
        right: "Reversed: only then is the winding number O - F - T.",
        proof: Proof::Claim("M20 printed"),
    },
    Erratum {
        place: "MS 7.2",
        printed: "When t is above the lower crust L1 + L2, the chain -L2 + t precedes L1.",
        right: "When t is below it.",
        proof: Proof::Numbers(
            "height of L1 above -L2 + t for L1 = L2 = 0, where t is 1 above, 1 below, and -t_y",
            || {
                let gap = |t: f64| 0.0 - (-0.0 + t);
                [gap(1.0), gap(-1.0), 1.0]
            },
        ),
    },
    Erratum {
        place: "MS 7.2, Lemma 3",
        printed: "f and f' are ||p|| close.",
        right: "f' is close to f; f need not be close to f', which drops an end spike.",
        proof: Proof::Claim("M31 printed"),
    },
    Erratum {
        place: "MS 7.2, Theorem 4",
        printed: "Lemma 2 applies.",
        right: "Lemma 4.",
        proof: Proof::Words(
            "The perturbations that the proof takes are those of Lemma 4; Lemma 2 speaks of the order of chains.",
        ),
    },
    Erratum {
        place: "MS 8.3",
        printed: "The monotonic algorithm takes 42% less time on average.",
        right: "42% is the reduction of the summed time; the mean of the 18 reductions is 37%.",
        proof: Proof::Numbers("mean reduction in Table 1, percent, and the mean by adding the ratios", || {
            let [kinetic, monotonic] = [0, 1].map(|i| TIMES.iter().map(|row| row[i] + row[i + 2]).sum::<f64>());
            let reductions: Vec<f64> =
                TIMES.iter().flat_map(|row| [1.0 - row[1] / row[0], 1.0 - row[3] / row[2]]).collect();
            let ratios: f64 = TIMES.iter().map(|row| row[1] / row[0] + row[3] / row[2]).sum();
            let mean = reductions.iter().sum::<f64>() / reductions.len() as f64;
            [100.0 * (1.0 - monotonic / kinetic), 100.0 * mean, 100.0 * (1.0 - ratios / 18.0)]
        }),
    },
    Erratum {
        place: "MS 8.3",
        printed: "Robustness takes 11% of the time at most.",
        right: "5% at most by the table, 6.3% if times are rounded to milliseconds.",
        proof: Proof::Numbers("greatest T_f/T in Table 1, percent, and by its logarithm", || {
            let all = || TIMES.iter().zip(&ROBUSTNESS).flat_map(|(t, f)| (0..4).map(move |i| f[i] / t[i]));
            let by_log = all().filter(|r| *r > 0.0).map(log).fold(f64::NEG_INFINITY, f64::max);
            [11.0, 100.0 * all().fold(0.0, f64::max), 100.0 * libm::exp(by_log)]
        }),
    },
    Erratum {
        place: "FH 2",
        printed: "The sum is a part of the arrangement of mn segments.",
        right: "2mn: every edge of each with every vertex of the other.",
        proof: Proof::Words("Two triangles: 3 edges of each with 3 vertices of the other are 18 segments, not 9."),
    },
    Erratum {
        place: "FH 2",
        printed: "The union of all P_i + Q_j for one j has complexity O(n |Q_j|).",
        right: "O(m |Q_j|), m being the vertices of P.",
        proof: Proof::Words(
            "A convex P with 100 vertices and a triangle Q_1 = Q: the sum has 103 edges, n |Q_j| = 9 and m |Q_j| = 300.",
        ),
    },
];

/// Printed, corrected, and from three points of the sum: -2 times the direction from 0 to 90 degrees has its centre on the left.
fn backward_radius() -> [f64; 3] {
    let at = |angle: f64| [-2.0 * cos(angle), -2.0 * sin(angle)];
    let [tail, head] = [at(0.0), at(FRAC_PI_2)];
    let chord = [head[0] - tail[0], head[1] - tail[1]];
    let to_centre = [-tail[0], -tail[1]];
    let left = chord[0] * to_centre[1] - chord[1] * to_centre[0];
    [-1.0 + -1.0, -(-1.0 + -1.0), 2.0 * left.signum()]
}

/// The second form, the first form, and cos 30 - 1.
fn second_form() -> [f64; 3] {
    let degrees = f64::to_radians;
    let (theta, alpha, gamma, delta) = (degrees(30.0), 0.0, degrees(45.0), degrees(45.0));
    let half = sin((theta + alpha) / 2.0);
    // h_x - t_x is -1.
    let second = -half / (2.0 * sin(gamma) * cos(delta / 2.0));
    let first = -half * sin((theta - alpha) / 2.0) / (sin(gamma) * sin(delta));
    [second, first, cos(theta) - 1.0]
}

/// With a difference, with a product, and from the circle itself.
fn sagitta() -> [f64; 3] {
    let (gamma, delta) = (FRAC_PI_2, 10.0_f64.to_radians());
    let (middle, half) = (sin(gamma - delta / 2.0), sin(delta / 2.0));
    let below = 2.0 * sin(gamma) * cos(delta / 2.0) * middle;
    let radius = 0.5 / sin(delta);
    debug_assert!((0.5 * tan(delta / 2.0) - radius * (1.0 - cos(delta))).abs() < 1e-12);
    [(middle - half) / below, middle * half / below, radius * (1.0 - cos(delta))]
}

#[cfg(test)]
mod tests {
    use super::super::registry::named;
    use super::*;

    #[test]
    fn every_erratum_is_shown() {
        for erratum in ERRATA {
            match erratum.proof {
                Proof::Numbers(_, numbers) => {
                    let [printed, right, truth] = numbers();
                    let (wrong, rest) = ((printed - truth).abs(), (right - truth).abs());
                    assert!(
                        wrong > 1e5 * rest && wrong > 0.0,
                        "{} {}: {printed} {right} {truth}",
                        erratum.place,
                        erratum.printed
                    );
                }
                Proof::Claim(id) => assert_eq!(named(id).len(), 1, "{id}"),
                Proof::Words(words) => assert!(!words.is_empty()),
            }
        }
    }
}

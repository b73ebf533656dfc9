//! Error-free transformations: a sum or product of doubles as a rounded value and its exact error (Dekker; MS 4.1 cites
//! them as reference 18), and sums of many terms as if in threefold precision.
//!
//! Exact as long as nothing overflows and no product falls below 2^-969.

/// The rounded sum and its exact error.
#[must_use]
pub fn two_sum(x: f64, y: f64) -> (f64, f64) {
    let s = x + y;
    let z = s - x;
    (s, (x - (s - z)) + (y - z))
}

/// The rounded product and its exact error.
#[must_use]
pub fn two_product(x: f64, y: f64) -> (f64, f64) {
    let p = x * y;
    (p, libm::fma(x, y, -p))
}

/// The sum of the terms, rounded about once: error at most 2^-52 |sum| + (n 2^-53)^3 times the sum of the absolute
/// values (Ogita, Rump, Oishi, *Accurate sum and dot product*, algorithm SumK with K = 3). Overwrites the terms.
#[must_use]
pub fn threefold_sum(terms: &mut [f64]) -> f64 {
    for _ in 0..2 {
        for i in 1..terms.len() {
            (terms[i], terms[i - 1]) = two_sum(terms[i], terms[i - 1]);
        }
    }
    terms.iter().sum()
}

/// The two terms of the square of `x + error`, times `scale`, to be added to a [`threefold_sum`]. `scale` is a power of
/// two or its negative, so that multiplying by it is exact.
#[must_use]
pub fn square_terms((x, error): (f64, f64), scale: f64) -> [f64; 5] {
    let (p, p_low) = two_product(x, x);
    let (m, m_low) = two_product(2.0 * x, error);
    [scale * p, scale * p_low, scale * m, scale * m_low, scale * (error * error)]
}

/// The sign of the exact sum of the terms: -1, 0 or 1.
#[must_use]
pub fn exact_sign(mut terms: Vec<f64>) -> f64 {
    // Each pass of TwoSums keeps the sum and moves weight to the last term; when nothing moves any more, the terms no
    // longer overlap and the last one outweighs the rest. As many passes as terms are enough.
    for _ in 0..terms.len() {
        let before = terms.clone();
        for i in 1..terms.len() {
            (terms[i], terms[i - 1]) = two_sum(terms[i], terms[i - 1]);
        }
        if terms == before {
            break;
        }
    }
    terms.last().map_or(0.0, |&last| if last == 0.0 { 0.0 } else { last.signum() })
}

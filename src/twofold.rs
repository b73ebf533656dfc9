//! Twofold numbers: a double and its error, as a pair (Dekker; MS 4.1 cites the sum as reference 18), and sums of many
//! terms as if in threefold precision.
//!
//! The sum and the product of two doubles are exact as long as nothing overflows and no product falls below 2^-969.

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

/// The square root of a twofold number that is not negative, to about 2^-104 of itself.
#[must_use]
pub fn twofold_sqrt((x, error): (f64, f64)) -> (f64, f64) {
    let root = libm::sqrt(x);
    if root > 0.0 { (root, (libm::fma(-root, root, x) + error) / (2.0 * root)) } else { (0.0, 0.0) }
}

/// The arc tangent of y/x for twofold numbers with 0 <= |y| <= x and x > 0, to 3 eps of itself, eps = 2^-53: the arc
/// tangent of the rounded quotient, and one linear correction for all that was rounded off before.
#[must_use]
pub fn twofold_atan((y, y_error): (f64, f64), (x, x_error): (f64, f64)) -> f64 {
    let quotient = y / x;
    let rest = (libm::fma(-quotient, x, y) + (y_error - quotient * x_error)) / x;
    libm::atan(quotient) + rest / (1.0 + quotient * quotient)
}

/// The sum of the terms as if in threefold precision: error at most 2^-105 |sum| + (n 2^-53)^3 times the sum of the
/// absolute values (Ogita, Rump, Oishi, *Accurate sum and dot product*, algorithm SumK with K = 3). Overwrites the
/// terms.
#[must_use]
pub fn threefold_sum(terms: &mut [f64]) -> (f64, f64) {
    for _ in 0..2 {
        for i in 1..terms.len() {
            (terms[i], terms[i - 1]) = two_sum(terms[i], terms[i - 1]);
        }
    }
    let Some((last, rest)) = terms.split_last() else { return (0.0, 0.0) };
    two_sum(*last, rest.iter().sum())
}

/// The terms of the square of a twofold number times `scale`, for a [`threefold_sum`]. `scale` is a power of two or its
/// negative, so that multiplying by it is exact.
#[must_use]
pub fn square_terms((x, error): (f64, f64), scale: f64) -> [f64; 5] {
    let (p, p_low) = two_product(x, x);
    let (m, m_low) = two_product(2.0 * x, error);
    [scale * p, scale * p_low, scale * m, scale * m_low, scale * (error * error)]
}

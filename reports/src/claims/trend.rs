//! The exponent of a power law with its 95% interval: least squares on logarithms.

use super::finding::Verdict;
use std::collections::BTreeMap;

/// Student's 97.5% quantiles for 1, 2, ... degrees of freedom.
const STUDENT: [f64; 30] = [
    12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131, 2.120,
    2.110, 2.101, 2.093, 2.086, 2.080, 2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042,
];

/// A fitted power law y = c x^e.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trend {
    /// The 95% interval of the exponent.
    pub exponent: [f64; 2],
    /// The constant of the fit.
    pub constant: f64,
    /// The share of the variance of log y that the fit explains.
    pub r2: f64,
}

impl Trend {
    /// The fit through points of positive coordinates; none with fewer than three abscissas.
    #[must_use]
    pub fn of(points: impl IntoIterator<Item = [f64; 2]>) -> Option<Self> {
        let positive = points.into_iter().filter(|p| p.iter().all(|c| *c > 0.0 && c.is_finite()));
        let logs: Vec<[f64; 2]> = positive.map(|p| p.map(libm::log)).collect();
        let mut abscissas: Vec<u64> = logs.iter().map(|p| p[0].to_bits()).collect();
        abscissas.sort_unstable();
        abscissas.dedup();
        (abscissas.len() > 2).then(|| fit(&logs))
    }

    /// The fit through the highest point at each abscissa.
    #[must_use]
    pub fn of_greatest(points: impl IntoIterator<Item = [f64; 2]>) -> Option<Self> {
        let mut greatest: BTreeMap<u64, f64> = BTreeMap::new();
        for [x, y] in points {
            let known = greatest.entry(x.to_bits()).or_default();
            *known = known.max(y);
        }
        Self::of(greatest.into_iter().map(|(x, y)| [f64::from_bits(x), y]))
    }

    /// Whether the values do not grow.
    #[must_use]
    pub fn no_growth(&self) -> Verdict {
        match self.exponent {
            [lo, _] if lo > 0.0 => Verdict::Refuted,
            [_, hi] if hi <= 0.0 => Verdict::Confirmed,
            _ => Verdict::Undecided,
        }
    }
}

fn fit(logs: &[[f64; 2]]) -> Trend {
    let n = logs.len() as f64;
    let mean = |of: &dyn Fn(&[f64; 2]) -> f64| logs.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(&|p| p[0]), mean(&|p| p[1]));
    let xx = mean(&|p| (p[0] - x) * (p[0] - x));
    let xy = mean(&|p| (p[0] - x) * (p[1] - y));
    let yy = mean(&|p| (p[1] - y) * (p[1] - y));
    let slope = xy / xx;
    let rest = (yy - slope * xy).max(0.0);
    let student = STUDENT.get(logs.len() - 3).copied().unwrap_or(1.96);
    let half = student * libm::sqrt(rest / (xx * (n - 2.0)));
    let r2 = if yy > 0.0 { 1.0 - rest / yy } else { 1.0 };
    Trend { exponent: [slope - half, slope + half], constant: libm::exp(y - slope * x), r2 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_is_found() {
        let law = Trend::of([1.0, 2.0, 4.0, 8.0].map(|x: f64| [x, 3.0 * x * x])).unwrap();
        assert!(law.exponent.iter().all(|e| (e - 2.0).abs() < 1e-9) && (law.constant - 3.0).abs() < 1e-9);
        assert!(law.r2 > 1.0 - 1e-12);
        assert_eq!(Trend::of([[1.0, 1.0], [2.0, 1.0], [2.0, 3.0]]), None);
    }

    #[test]
    fn the_interval_is_that_of_the_books() {
        // y = 0, 1, 1 over x = 0, 1, 2 in logarithms: slope 1/2, residual sum 1/6, standard error sqrt(1/12), t = 12.706.
        let e = libm::exp(1.0);
        let law = Trend::of([[1.0, 1.0], [e, e], [e * e, e]]).unwrap();
        let half = 12.706 * libm::sqrt(1.0 / 12.0);
        assert!((law.exponent[0] - (0.5 - half)).abs() < 1e-9 && (law.exponent[1] - (0.5 + half)).abs() < 1e-9);
    }
}

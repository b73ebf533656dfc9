//! The middle, the mean and the ends of some values.

/// Values from least to greatest; there is at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct Sorted(Vec<f64>);

impl Sorted {
    /// The values in order; `None` without any.
    pub fn new(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.sort_by(f64::total_cmp);
        (!values.is_empty()).then_some(Self(values))
    }

    /// The least.
    pub fn least(&self) -> f64 {
        self.0[0]
    }

    /// The value in the middle, the mean of the two in the middle of an even number.
    pub fn median(&self) -> f64 {
        let n = self.0.len();
        0.5 * (self.0[(n - 1) / 2] + self.0[n / 2])
    }

    /// The geometric mean; the values must be positive.
    pub fn geometric_mean(&self) -> f64 {
        libm::exp(self.0.iter().map(|value| libm::log(*value)).sum::<f64>() / self.0.len() as f64)
    }

    /// The greatest.
    pub fn greatest(&self) -> f64 {
        self.0[self.0.len() - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_are_in_the_middle() {
        let sorted = Sorted::new([9.0, 1.0, 2.0]).unwrap();
        assert_eq!((sorted.least(), sorted.median(), sorted.greatest()), (1.0, 2.0, 9.0));
        assert_eq!(Sorted::new([1.0, 9.0, 4.0, 2.0]).unwrap().median(), 3.0);
        assert_eq!(Sorted::new([]), None);
    }
}

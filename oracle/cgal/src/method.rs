//! How a sum is computed: CGAL's strategies and kernels by name, `reduced:exact` and so on.

use std::fmt::{Display, Formatter};
use std::str::FromStr;

/// A strategy of CGAL's Minkowski sum package. The order is that of the C ABI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strategy {
    /// The reduced convolution, CGAL's default.
    Reduced,
    /// The full convolution; no holes.
    Full,
    /// Convex decomposition by the small-side angle bisector heuristic; no holes.
    SmallSide,
    /// Decomposition into the fewest convex pieces; no holes.
    Optimal,
    /// Decomposition by Hertel and Mehlhorn's approximation; no holes.
    HertelMehlhorn,
    /// Decomposition by Greene's approximation; no holes.
    Greene,
    /// Vertical decomposition.
    Vertical,
    /// Triangulation.
    Triangulation,
}

impl Strategy {
    /// All of them with their names, in the order of the C ABI.
    pub const ALL: [(Self, &str); 8] = [
        (Self::Reduced, "reduced"),
        (Self::Full, "full"),
        (Self::SmallSide, "small-side"),
        (Self::Optimal, "optimal"),
        (Self::HertelMehlhorn, "hertel-mehlhorn"),
        (Self::Greene, "greene"),
        (Self::Vertical, "vertical"),
        (Self::Triangulation, "triangulation"),
    ];

    /// Whether it takes polygons with holes.
    #[must_use]
    pub fn takes_holes(self) -> bool {
        matches!(self, Self::Reduced | Self::Vertical | Self::Triangulation)
    }
}

/// A kernel: the numbers that CGAL computes with. The order is that of the C ABI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kernel {
    /// Exact, rationals behind intervals: `Exact_predicates_exact_constructions_kernel`.
    Exact,
    /// Exact, GMP rationals without a filter.
    Rational,
    /// Exact predicates on rounded coordinates: `Exact_predicates_inexact_constructions_kernel`. CGAL promises no answer.
    Inexact,
}

impl Kernel {
    /// All of them with their names, in the order of the C ABI.
    pub const ALL: [(Self, &str); 3] =
        [(Self::Exact, "exact"), (Self::Rational, "rational"), (Self::Inexact, "inexact")];
}

/// A strategy and a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Method {
    strategy: Strategy,
    kernel: Kernel,
}

impl Method {
    /// The method.
    #[must_use]
    pub fn new(strategy: Strategy, kernel: Kernel) -> Self {
        Self { strategy, kernel }
    }

    /// All methods.
    pub fn all() -> impl Iterator<Item = Self> {
        Strategy::ALL.into_iter().flat_map(|(s, _)| Kernel::ALL.into_iter().map(move |(k, _)| Self::new(s, k)))
    }

    /// The strategy.
    #[must_use]
    pub fn strategy(self) -> Strategy {
        self.strategy
    }

    /// The kernel.
    #[must_use]
    pub fn kernel(self) -> Kernel {
        self.kernel
    }
}

impl Display for Method {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let strategy = Strategy::ALL[self.strategy as usize].1;
        let kernel = Kernel::ALL[self.kernel as usize].1;
        write!(f, "{strategy}:{kernel}")
    }
}

/// A text that names no method.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("CGAL sums by {known}, not by {0}", known = Method::all().map(|m| m.to_string()).collect::<Vec<_>>().join(", "))]
pub struct NoSuchMethod(String);

impl FromStr for Method {
    type Err = NoSuchMethod;

    fn from_str(text: &str) -> Result<Self, NoSuchMethod> {
        Self::all().find(|method| method.to_string() == text).ok_or_else(|| NoSuchMethod(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_answer_to_their_names() {
        assert_eq!(Method::all().count(), 8 * 3);
        for method in Method::all() {
            assert_eq!(method.to_string().parse(), Ok(method));
        }
        assert!("optimal:real".parse::<Method>().is_err());
        assert_eq!("reduced:exact".parse::<Method>().map(Method::strategy), Ok(Strategy::Reduced));
    }

    #[test]
    fn the_tables_are_in_the_order_of_the_numbers() {
        assert!(Strategy::ALL.iter().enumerate().all(|(i, (s, _))| *s as usize == i));
        assert!(Kernel::ALL.iter().enumerate().all(|(i, (k, _))| *k as usize == i));
    }
}

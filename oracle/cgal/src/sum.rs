//! Minkowski sums: the question, and CGAL's answer as the loops it returned and the region they describe.

use crate::error::CgalError;
use crate::method::Method;
use crate::question::{Question, result};
use crate::text::{self, Loops};
use arcsum_oracle::region::ExactRegion;
use rug::Rational;
use std::time::Duration;

/// The Minkowski sum of two regions, each an outer loop and its holes in any order, the interior on the left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sum {
    /// How.
    pub method: Method,
    /// The first operand.
    pub a: Loops,
    /// The second one.
    pub b: Loops,
}

impl Question for Sum {
    type Answer = Answer;

    fn line(&self) -> String {
        format!("sum|{}|{}|{}", self.method, text::write(&self.a), text::write(&self.b))
    }

    fn read(text: &str) -> Result<Answer, CgalError> {
        let (time, loops) = result(text)?;
        Ok(Answer { loops: text::read(loops)?, time: Duration::from_nanos(time) })
    }
}

/// A sum, in input units.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Answer {
    /// The loops as they came: the interior on the left, collinear vertices and antennas kept.
    pub loops: Loops,
    /// How long CGAL took, until the result was exact; without conversions and validation.
    pub time: Duration,
}

impl Answer {
    /// The region as a regular closed set in normal form: what is wound around once. Antennas are not part of it.
    ///
    /// # Errors
    /// [`CgalError::Nonsense`] if something is wound around another number of times than 0 or 1.
    pub fn region(&self) -> Result<ExactRegion<Rational>, CgalError> {
        let wound = |inside| {
            ExactRegion::from_rings(self.loops.clone(), false, inside).map_err(|e| CgalError::Nonsense(e.to_string()))
        };
        if !wound(|w| !(0..=1).contains(&w[0]))?.is_empty() {
            return Err(CgalError::Nonsense("its loops overlap".into()));
        }
        wound(|w| w[0] == 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_that_overlap_are_no_region() {
        let region = |loops: String| Sum::read(&format!("ok 5;{loops}")).and_then(|answer| answer.region());
        let square = "0 0 4 0 4 4 0 4;";
        assert_eq!(region(square.into()).map(|r| r.area()), Ok(Rational::from(16)));
        assert_eq!(region(format!("{square}1 1 1 2 2 2 2 1;")).map(|r| r.area()), Ok(Rational::from(15)));
        for other in ["1 1 2 1 2 2 1 2;", "3 3 3 5 5 5 5 3;", "6 6 6 7 7 7;"] {
            assert!(matches!(region(format!("{square}{other}")), Err(CgalError::Nonsense(_))), "{other}");
        }
    }

    #[test]
    fn antennas_are_not_part_of_the_region() {
        let answer = Sum::read("ok 0;0 0 4 0 4 4 9 4 4 4 0 4;").expect("a square with an antenna");
        assert_eq!(answer.loops[0].len(), 6);
        assert_eq!(answer.region().map(|r| (r.vertices(), r.area())), Ok((4, Rational::from(16))));
    }
}

//! A question to CGAL, and its one line for a process of its own.

use crate::answer::Answer;
use crate::binding;
use crate::error::CgalError;
use crate::method::Method;
use crate::text::{self, Loops};
use arcsum_oracle::plain::{Bend, PlainRegion};
use arcsum_oracle::region::ring_points;

/// A question; regions are an outer loop and its holes in any order, the interior on the left.
#[derive(Clone, Debug, PartialEq)]
pub enum Question {
    /// The Minkowski sum of two regions.
    Sum(Method, Loops, Loops),
}

impl Question {
    /// Asks CGAL in this process, which it may end.
    ///
    /// # Errors
    /// When CGAL is not built in, is not asked for lack of a valid input, gives up or answers nonsense.
    pub fn ask(&self) -> Result<Answer, CgalError> {
        Answer::read(&self.raw()?)
    }

    /// The text of the answer.
    pub(crate) fn raw(&self) -> Result<String, CgalError> {
        match self {
            Self::Sum(method, a, b) => binding::sum(*method, &text::write(a), &text::write(b)),
        }
    }

    /// The question on one line.
    pub(crate) fn line(&self) -> String {
        match self {
            Self::Sum(method, a, b) => format!("sum|{method}|{}|{}", text::write(a), text::write(b)),
        }
    }

    /// The question of a line.
    pub(crate) fn read(line: &str) -> Result<Self, CgalError> {
        match line.split('|').collect::<Vec<_>>()[..] {
            ["sum", method, a, b] => {
                let method = method.parse().map_err(|_| CgalError::Refused(format!("no method {method}")))?;
                Ok(Self::Sum(method, text::read(a)?, text::read(b)?))
            }
            _ => Err(CgalError::Refused("no such question".into())),
        }
    }
}

/// The loops of a polygonal region, whose doubles are taken literally.
///
/// # Errors
/// [`CgalError::Refused`] for unbounded regions, circle segments and coordinates that are not finite.
pub fn loops(region: &PlainRegion) -> Result<Loops, CgalError> {
    let refused = |reason: &str| CgalError::Refused(reason.to_owned());
    if region.unbounded {
        return Err(refused("an unbounded region"));
    }
    if region.loops.iter().flatten().any(|corner| corner.bend != Bend::Line) {
        return Err(refused("a circle segment"));
    }
    let points = region.loops.iter().enumerate().map(|(i, ring)| ring_points(i, ring));
    points.collect::<Result<_, _>>().map_err(|e| refused(&e.to_string()))
}

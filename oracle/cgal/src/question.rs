//! Questions to CGAL, each on one line of text, and how they are answered in this process.

use crate::binding;
use crate::error::CgalError;
use crate::text::Loops;
use arcsum_oracle::boolean::Operation;
use arcsum_oracle::plain::{Bend, PlainRegion};
use arcsum_oracle::region::ring_points;

/// A question.
pub trait Question {
    /// What it is answered with.
    type Answer;

    /// The question on one line.
    fn line(&self) -> String;

    /// The answer of a text (the C ABI says how it looks).
    ///
    /// # Errors
    /// What the text says, or [`CgalError::Nonsense`].
    fn read(text: &str) -> Result<Self::Answer, CgalError>;

    /// Asks CGAL in this process, which it may end.
    ///
    /// # Errors
    /// When CGAL is not built in, is not asked for lack of a valid input, gives up or answers nonsense.
    fn ask(&self) -> Result<Self::Answer, CgalError> {
        Self::read(&respond(&self.line())?)
    }
}

/// The text of CGAL's answer to a line.
pub(crate) fn respond(line: &str) -> Result<String, CgalError> {
    let refused = |what: &str| CgalError::Refused(format!("no {what}"));
    match line.split('|').collect::<Vec<_>>()[..] {
        ["sum", method, a, b] => binding::sum(method.parse().map_err(|_| refused(method))?, a, b),
        ["offset", error, radius, region] => {
            binding::offset(region, radius, error.parse().map_err(|_| refused("error"))?)
        }
        ["offset-exact", radius, region] => binding::offset_exact(region, radius),
        ["combine", operation, a, b] => {
            let known = Operation::ALL.into_iter().find(|known| format!("{known:?}") == operation);
            binding::combine(known.ok_or_else(|| refused(operation))?, a, b)
        }
        _ => Err(refused("such question")),
    }
}

/// The time in nanoseconds and the loops of a text that holds a result.
pub(crate) fn result(text: &str) -> Result<(u64, &str), CgalError> {
    let nonsense = || CgalError::Nonsense(text.chars().take(60).collect());
    if let Some(reason) = text.strip_prefix("refused ") {
        return Err(CgalError::Refused(reason.to_owned()));
    }
    if let Some(reason) = text.strip_prefix("failed ") {
        return Err(CgalError::Failed(reason.to_owned()));
    }
    let (time, loops) = text.strip_prefix("ok ").and_then(|rest| rest.split_once(';')).ok_or_else(nonsense)?;
    Ok((time.parse().map_err(|_| nonsense())?, loops))
}

/// The loops of a polygonal region, whose doubles are taken literally.
///
/// # Errors
/// [`CgalError::Refused`] for unbounded regions, circle segments and coordinates that are not finite.
pub fn loops(region: &PlainRegion) -> Result<Loops, CgalError> {
    if region.loops.iter().flatten().any(|corner| corner.bend != Bend::Line) {
        return Err(CgalError::Refused("a circle segment".into()));
    }
    points(region)
}

/// The vertices of a bounded region.
pub(crate) fn points(region: &PlainRegion) -> Result<Loops, CgalError> {
    if region.unbounded {
        return Err(CgalError::Refused("an unbounded region".into()));
    }
    let points = region.loops.iter().enumerate().map(|(i, ring)| ring_points(i, ring));
    points.collect::<Result<_, _>>().map_err(|e| CgalError::Refused(e.to_string()))
}

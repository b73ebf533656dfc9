//! Checks of a result that need no reference.

use arcsum::region::{Curve, Region};
use arcsum::validate;

/// Why this is no region at all: a number that is not finite, or a loop that bounds nothing.
#[must_use]
pub fn nonsense(region: &Region) -> Option<String> {
    let finite = |c: Curve| match c {
        Curve::Line => true,
        Curve::Radius(v) | Curve::Bulge(v) => v.is_finite(),
    };
    if region.loops.iter().flatten().any(|n| !(n.x.is_finite() && n.y.is_finite() && finite(n.curve))) {
        return Some("the answer has a number that is not finite".into());
    }
    let lines_only = |l: &Vec<arcsum::region::Node>| l.iter().all(|n| n.curve == Curve::Line);
    let short = region.loops.iter().find(|l| l.len() < 2 || lines_only(l) && l.len() < 3)?;
    Some(format!("the answer has a loop of {} segments", short.len()))
}

/// The names of the checks the result fails. Contacts and crossings that rounding brings about count.
#[must_use]
pub fn failed_checks(region: &Region) -> Vec<String> {
    if validate::validate(region).is_ok() { Vec::new() } else { vec!["validity".into()] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{disc, polygon};

    #[test]
    fn nonsense_is_told_from_regions() {
        assert!(nonsense(&disc(1.0)).is_none());
        assert!(nonsense(&polygon(&[[0.0, 0.0], [1.0, 0.0]])).is_some());
        assert!(nonsense(&polygon(&[[0.0, 0.0], [1.0, 0.0], [0.0, f64::NAN]])).is_some());
    }
}

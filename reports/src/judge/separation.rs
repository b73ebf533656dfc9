//! The separation of a case: the lesser of those of its operands (MS 7), in unit-box lengths.

use crate::bridge::{plain, unit};
use crate::cases::Case;
use crate::row::number;
use arcsum_oracle::certified::separation::separation;
use arcsum_oracle::error::OracleError;
use serde::{Deserialize, Serialize};

/// A certified bracket of a separation, infinite if any two chains of an operand are incident.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Separation {
    /// The lower bound.
    #[serde(default, with = "number")]
    pub lo: Option<f64>,
    /// The upper bound.
    #[serde(default, with = "number")]
    pub hi: Option<f64>,
}

/// The separation of a case.
///
/// # Errors
/// [`OracleError::BadNumber`] for operands that are no regions.
pub fn measure(case: &Case) -> Result<Separation, OracleError> {
    let unit = unit(&case.a, &case.b);
    let least = separation(&plain(&case.a), unit)?.min(separation(&plain(&case.b), unit)?);
    Ok(Separation { lo: Some(least.lo()), hi: Some(least.hi()) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{disc, polygon};
    use arcsum::region::Region;

    fn measured(a: Region, b: Region) -> Separation {
        measure(&Case { name: "c".into(), family: "f".into(), a, b, seed: None, golden: None }).unwrap()
    }

    /// A hook: the first and the last of its upper chains are 1 apart, and the unit box has side 8.
    fn hook() -> Region {
        let corners = [[0.0, 0.0], [7.0, 0.0], [7.0, 1.0], [2.0, 1.0], [4.0, 2.0], [7.0, 2.0], [7.0, 3.0], [0.0, 3.0]];
        polygon(&corners)
    }

    #[test]
    fn the_lesser_separation_counts_in_the_unit_box() {
        assert_eq!(measured(disc(1.0), disc(0.5)), Separation { lo: Some(f64::INFINITY), hi: Some(f64::INFINITY) });
        let of_hook = Separation { lo: Some(0.125), hi: Some(0.125) };
        assert_eq!((measured(hook(), disc(0.5)), measured(disc(0.5), hook())), (of_hook, of_hook));
        let text = serde_json::to_string(&measured(disc(1.0), disc(0.5))).unwrap();
        assert_eq!(serde_json::from_str::<Separation>(&text).unwrap().lo, Some(f64::INFINITY));
    }
}

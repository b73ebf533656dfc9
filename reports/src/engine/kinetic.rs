//! The engine of this project: the kinetic convolution and the approximate arrangement (MS 3, 4) with default options.

use super::{Abilities, Answer, Counters, Engine, EngineError, Times};
use crate::standin::sum::{self, Audit, Options};
use arcsum::region::Region;

/// The engine `kinetic`.
#[derive(Debug, Default)]
pub struct Kinetic;

impl Engine for Kinetic {
    fn name(&self) -> &'static str {
        "kinetic"
    }

    fn version(&self) -> String {
        env!("CARGO_PKG_VERSION").to_owned()
    }

    fn abilities(&self) -> Abilities {
        Abilities::ALL
    }

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let sum = sum::sum(a, b, &Options::default()).map_err(|e| EngineError::Invalid(e.to_string()))?;
        Ok(Answer {
            region: sum.region,
            counters: counters(&sum.audit),
            times: Times {
                convolution: Some(sum.times.convolution),
                arrangement: Some(sum.times.arrangement),
                extraction: Some(sum.times.extraction),
            },
            convolution: sum.convolution,
            failed_checks: Some(failed(&sum.audit)),
        })
    }
}

fn counters(audit: &Audit) -> Counters {
    Counters {
        sums: Some(audit.sums as u64),
        vertices: Some(audit.vertices as u64),
        late: Some(audit.late as u64),
        gather: Some(audit.gather as u64),
        cells: Some(audit.faces as u64),
        ..Counters::default()
    }
}

fn failed(audit: &Audit) -> Vec<String> {
    let checks = [("euler", audit.euler_ok), ("winding", audit.winding_ok)];
    checks.into_iter().filter(|(_, held)| !held).map(|(name, _)| name.to_owned()).collect()
}

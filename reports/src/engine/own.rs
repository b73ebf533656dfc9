//! The engines of this project: the kinetic and the monotonic convolution (MS 3, 5) and the approximate arrangement.

use super::cells::cells;
use super::{Abilities, Answer, Counters, Engine, EngineError, Times};
use arcsum::region::Region;
use arcsum::sum::{Convolution, Options, Sum, sum};

/// An engine by its convolution.
#[derive(Debug)]
pub struct Own(pub Convolution);

impl Engine for Own {
    fn name(&self) -> &'static str {
        match self.0 {
            Convolution::Kinetic => "kinetic",
            Convolution::Monotonic => "monotonic",
        }
    }

    fn version(&self) -> String {
        env!("CARGO_PKG_VERSION").to_owned()
    }

    fn abilities(&self) -> Abilities {
        Abilities::ALL
    }

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let sum = sum(a, b, &Options { convolution: self.0, ..Options::default() })
            .map_err(|e| EngineError::Invalid(e.to_string()))?;
        Ok(Answer {
            counters: counters(&sum),
            times: Times {
                convolution: Some(sum.times.convolution),
                arrangement: Some(sum.times.arrangement),
                extraction: Some(sum.times.extraction),
            },
            convolution: sum.convolution_in_input_units(),
            failed_checks: Some(failed(&sum)),
            cells: Some(cells(&sum)),
            region: sum.region,
        })
    }
}

fn counters(sum: &Sum) -> Counters {
    let count = |n: usize| Some(n as u64);
    let audit = &sum.arrangement.audit;
    Counters {
        sums: count(sum.convolution.pieces.len()),
        vertices: count(audit.vertices),
        late: count(audit.late),
        gather: count(audit.gather),
        cancelled: count(audit.cancelled),
        cells: count(sum.arrangement.graph.windings.len()),
        ..Counters::default()
    }
}

/// Euler's formula, and winding numbers that agree along every edge.
fn failed(sum: &Sum) -> Vec<String> {
    let graph = &sum.arrangement.graph;
    let checks = [("euler", graph.euler().holds()), ("winding", graph.winding_conflicts == 0)];
    checks.into_iter().filter(|(_, held)| !held).map(|(name, _)| name.to_owned()).collect()
}

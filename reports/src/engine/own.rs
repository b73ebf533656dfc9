//! The engines of this project: the kinetic and the monotonic convolution (MS 3, 5) and the approximate arrangement.
//!
//! `naive-kinetic` and `naive-monotonic` are the same algorithms in plain doubles, the baseline of MS 8.3;
//! `kinetic-without-STEP` and `monotonic-without-STEP` leave out one robustness step, to see what it costs and does.
//! `kinetic-heuristic` is the kinetic one with the heuristic against falsely free points (MS 8.2). `convex` is the convex
//! convolution with its cells decided one by one, an ablation (MS 3).

use super::cells::cells;
use super::{Abilities, Answer, Counters, Engine, EngineError, Times};
use arcsum::heuristic::THRESHOLD;
use arcsum::region::Region;
use arcsum::robustness::{Robustness, Step};
use arcsum::sum::{Convolution, Options, Sum, sum};
use std::time::{Duration, Instant};

/// An engine by its convolution and robustness steps.
#[derive(Debug)]
pub struct Own {
    name: String,
    options: Options,
}

impl Own {
    /// The engine with all robustness steps.
    #[must_use]
    pub fn new(convolution: Convolution) -> Self {
        let name = match convolution {
            Convolution::Kinetic => "kinetic",
            Convolution::Monotonic => "monotonic",
            Convolution::Convex => "convex",
        };
        Self { name: name.to_owned(), options: Options { convolution, ..Options::default() } }
    }

    /// What it is asked to do.
    #[must_use]
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The engine of this name, if it is one of them.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        if name == "convex" {
            return Some(Self::new(Convolution::Convex));
        }
        let threshold = (name == "kinetic-heuristic").then_some(THRESHOLD);
        let culled = name.strip_suffix("-culled");
        let (whole, robustness) = if let Some(whole) = culled {
            (whole, Robustness::ALL)
        } else if threshold.is_some() {
            ("kinetic", Robustness::ALL)
        } else if let Some(whole) = name.strip_prefix("naive-") {
            (whole, Robustness::NONE)
        } else if let Some((whole, left_out)) = name.split_once("-without-") {
            let (step, _) = Step::ALL.into_iter().find(|(_, known)| *known == left_out)?;
            (whole, Robustness::ALL.without(step))
        } else {
            (name, Robustness::ALL)
        };
        let convolution = match whole {
            "kinetic" => Convolution::Kinetic,
            "monotonic" => Convolution::Monotonic,
            _ => return None,
        };
        Some(Self {
            name: name.to_owned(),
            options: Options { convolution, robustness, threshold, culling: culled.is_some() },
        })
    }

    /// The sum and how long it took.
    fn timed(&self, a: &Region, b: &Region) -> Result<(Sum, Duration), EngineError> {
        let start = Instant::now();
        let sum = sum(a, b, &self.options).map_err(|e| EngineError::Invalid(e.to_string()))?;
        Ok((sum, start.elapsed()))
    }
}

impl Engine for Own {
    fn name(&self) -> &str {
        &self.name
    }

    fn version(&self) -> String {
        env!("CARGO_PKG_VERSION").to_owned()
    }

    fn abilities(&self) -> Abilities {
        Abilities::ALL
    }

    fn alone(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let (sum, total) = self.timed(a, b)?;
        let times = Times { total: Some(total), ..Times::default() };
        Ok(Answer { region: sum.region, times, ..Answer::default() })
    }

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let (sum, total) = self.timed(a, b)?;
        Ok(Answer {
            counters: counters(&sum),
            times: Times {
                total: Some(total),
                convolution: Some(sum.times.convolution),
                arrangement: Some(sum.times.arrangement),
                extraction: Some(sum.times.extraction),
            },
            convolution: sum.convolution_in_input_units(),
            failed_checks: Some(failed(&sum)),
            cells: Some(cells(&sum)),
            memory: None,
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
        order_conflict: count(audit.order_conflict),
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

//! `cgal:STRATEGY:KERNEL`: CGAL's Minkowski sums of polygons, in a process of their own because CGAL can end it.
//!
//! Exact results are taken as regions, antennas and collinear vertices left out, and rounded to the nearest doubles; those
//! of the inexact kernel are taken as they come. The time is CGAL's own, until its result is exact.

use super::{Abilities, Answer, Engine, EngineError, Times};
use crate::bridge::plain;
use arcsum::region::{Node, Region};
use arcsum_cgal::child::Child;
use arcsum_cgal::error::CgalError;
use arcsum_cgal::method::{Kernel, Method};
use arcsum_cgal::question::loops;
use arcsum_cgal::sum::Sum;
use arcsum_oracle::point::Point;
use rug::Rational;
use std::time::Duration;

/// The command of this program that answers CGAL's questions.
pub const COMMAND: &str = "cgal";

/// The version of an engine that is not there.
pub const NOT_BUILT_IN: &str = "not built in";

/// Whoever measures has a shorter limit; this one is for those who have none.
const LIMIT: Duration = Duration::from_secs(600);

/// A process of this program that asks CGAL, once it is needed.
#[derive(Debug, Default)]
pub(super) struct Process(Option<Child>);

impl Process {
    /// The child that asks.
    pub(super) fn child(&mut self) -> Result<&mut Child, CgalError> {
        let child = match self.0.take() {
            Some(child) => child,
            None => {
                let program = std::env::current_exe().map_err(|e| CgalError::Died(e.to_string()))?;
                Child::new(program, &[COMMAND], LIMIT)
            }
        };
        Ok(self.0.insert(child))
    }

    /// Its number, once it is there.
    pub(super) fn id(&self) -> Option<u32> {
        self.0.as_ref().and_then(Child::process)
    }
}

/// CGAL by one method.
#[derive(Debug)]
pub struct Cgal {
    name: String,
    method: Method,
    process: Process,
}

impl Cgal {
    /// The engine of this name, if it is one of them.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let method = name.strip_prefix("cgal:")?.parse().ok()?;
        Some(Self { name: name.to_owned(), method, process: Process::default() })
    }

    /// The names of all.
    #[must_use]
    pub fn names() -> Vec<String> {
        Method::all().map(|method| format!("cgal:{method}")).collect()
    }

    fn asked(&mut self, a: &Region, b: &Region) -> Result<Answer, CgalError> {
        if !arcsum_cgal::built_in() {
            return Err(CgalError::NotBuiltIn);
        }
        let question = Sum { method: self.method, a: loops(&plain(a))?, b: loops(&plain(b))? };
        let answer = self.process.child()?.ask(&question)?;
        let region = match self.method.kernel() {
            Kernel::Inexact => rounded(&answer.loops),
            Kernel::Exact | Kernel::Rational => rounded(answer.region()?.loops()),
        };
        Ok(Answer { region, times: Times { total: Some(answer.time), ..Times::default() }, ..Answer::default() })
    }
}

/// The loops with the nearest doubles.
fn rounded(loops: &[Vec<Point<Rational>>]) -> Region {
    let node = |p: &Point<Rational>| {
        let (x, y) = p.nearest();
        Node::line(x, y)
    };
    Region { loops: loops.iter().map(|ring| ring.iter().map(node).collect()).collect(), ..Region::default() }
}

impl Engine for Cgal {
    fn name(&self) -> &str {
        &self.name
    }

    fn version(&self) -> String {
        arcsum_cgal::version().unwrap_or_else(|| NOT_BUILT_IN.to_owned())
    }

    fn abilities(&self) -> Abilities {
        let holes = self.method.strategy().takes_holes();
        Abilities { holes, ..Abilities::NONE }
    }

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        self.asked(a, b).map_err(refusal)
    }

    fn process(&self) -> Option<u32> {
        self.process.id()
    }
}

/// CGAL's error as the engine's.
pub(super) fn refusal(error: CgalError) -> EngineError {
    match error {
        CgalError::NotBuiltIn | CgalError::Refused(_) | CgalError::Nonsense(_) => {
            EngineError::Invalid(error.to_string())
        }
        CgalError::Failed(_) | CgalError::Died(_) | CgalError::Late(_) => EngineError::Crashed(error.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{polygon, rectangle, region};
    use crate::engine::registry::engine;

    #[test]
    fn all_methods_are_engines() {
        for name in Cgal::names() {
            let engine = engine(&name).unwrap();
            assert_eq!(engine.name(), name);
            assert_eq!(engine.version() == NOT_BUILT_IN, !arcsum_cgal::built_in());
        }
        assert!(Cgal::named("cgal:").is_none() && Cgal::named("cgal:optimal:real").is_none());
    }

    #[test]
    fn only_one_bounded_polygon_an_operand_is_theirs() {
        let square = polygon(&rectangle([0.0, 0.0], [3.0, 3.0]));
        let nodes = |low, high| rectangle(low, high).iter().map(|&[x, y]| Node::line(x, y)).collect::<Vec<_>>();
        let hole: Vec<Node> = nodes([1.0, 1.0], [2.0, 2.0]).into_iter().rev().collect();
        let frame = region(vec![square.loops[0].clone(), hole]);
        let two = region(vec![square.loops[0].clone(), nodes([5.0, 0.0], [6.0, 1.0])]);
        let plane = Region { unbounded: true, ..Region::default() };
        let covers = |name: &str, a: &Region| Cgal::named(name).unwrap().abilities().cover(a, &square);
        for (region, reduced, greene) in [(&square, true, true), (&frame, true, false), (&two, false, false)] {
            assert_eq!(covers("cgal:reduced:exact", region), reduced);
            assert_eq!(covers("cgal:greene:exact", region), greene);
        }
        assert!(!covers("cgal:reduced:exact", &plane));
    }
}

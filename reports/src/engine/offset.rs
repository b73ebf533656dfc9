//! `cgal:offset:exact` and `cgal:offset:approximate`: CGAL's offsets of a polygon by a disc, for cases that have one as an
//! operand, in a process of their own.
//!
//! The polygon is moved by the disc's centre first, exactly. Vertices and bulges of the answer are rounded to the nearest
//! doubles. The approximate offset is asked for with an error of at most 1e-9 of the unit box. The time is CGAL's own.

use super::cgal::{NOT_BUILT_IN, Process, refusal};
use super::{Abilities, Answer, Engine, EngineError, Times};
use crate::bridge::{plain, region, unit};
use arcsum::region::Region;
use arcsum_cgal::curved::Offset as Approximate;
use arcsum_cgal::error::CgalError;
use arcsum_cgal::offset::Offset as Exact;
use arcsum_cgal::question::loops;
use arcsum_oracle::disc::Disc;
use arcsum_oracle::plain::PlainRegion;
use std::time::Duration;

/// The names of the two engines.
pub const NAMES: [&str; 2] = ["cgal:offset:exact", "cgal:offset:approximate"];

/// How far the approximate offset may be off, in unit-box lengths.
const ERROR: f64 = 1e-9;

/// CGAL's offset, exact or approximated.
#[derive(Debug)]
pub struct Offset {
    name: &'static str,
    process: Process,
}

impl Offset {
    /// The engine of this name, if it is one of them.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        NAMES.into_iter().find(|known| *known == name).map(|name| Self { name, process: Process::default() })
    }

    fn asked(&mut self, a: &Region, b: &Region) -> Result<(PlainRegion, Duration), CgalError> {
        if !arcsum_cgal::built_in() {
            return Err(CgalError::NotBuiltIn);
        }
        let (disc, polygon) = operands(a, b).ok_or_else(|| CgalError::Refused("no operand is a disc".into()))?;
        let moved =
            |ring: &Vec<_>| ring.iter().map(|p: &arcsum_oracle::point::Point<_>| p.plus(&disc.centre)).collect();
        let (region, radius) = (loops(&polygon)?.iter().map(moved).collect(), disc.radius);
        if self.name == NAMES[0] {
            let answer = self.process.child()?.ask(&Exact { region, radius })?;
            return Ok((answer.to_plain(), answer.time));
        }
        let answer = self.process.child()?.ask(&Approximate { region, radius, error: ERROR * unit(a, b) })?;
        Ok((answer.to_plain(), answer.time))
    }
}

/// The disc of the two operands and the other one; of two discs, neither.
fn operands(a: &Region, b: &Region) -> Option<(Disc, PlainRegion)> {
    let split = |disc: &Region, other: &Region| Disc::of(&plain(disc)).map(|disc| (disc, plain(other)));
    split(b, a).or_else(|| split(a, b))
}

impl Engine for Offset {
    fn name(&self) -> &str {
        self.name
    }

    fn version(&self) -> String {
        arcsum_cgal::version().unwrap_or_else(|| NOT_BUILT_IN.to_owned())
    }

    fn abilities(&self) -> Abilities {
        Abilities { holes: true, discs_only: true, ..Abilities::NONE }
    }

    fn process(&self) -> Option<u32> {
        self.process.id()
    }

    fn sum(&mut self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let (result, time) = self.asked(a, b).map_err(refusal)?;
        Ok(Answer {
            region: region(&result),
            times: Times { total: Some(time), ..Times::default() },
            ..Answer::default()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cases::shape::{disc, polygon, rectangle};
    use crate::engine::registry::engine;

    #[test]
    fn both_are_engines_for_discs_and_polygons() {
        let (disc, square) = (disc(1.0), polygon(&rectangle([0.0, 0.0], [3.0, 3.0])));
        for name in NAMES {
            let engine = engine(name).unwrap();
            assert_eq!(engine.name(), name);
            let covers = |a, b| engine.abilities().cover(a, b);
            assert!(covers(&disc, &square) && covers(&square, &disc));
            assert!(!covers(&square, &square) && !covers(&disc, &disc));
        }
        assert!(Offset::named("cgal:offset:").is_none());
    }
}

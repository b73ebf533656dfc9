//! The ways to a sum with the engines of others: what each is given, and what becomes of its answer.

use super::curves::Curves;
use super::flat::flattened;
use super::grid::{Grid, Ring};
use super::offset::{By, offset};
use super::{EngineError, Stretch};
use crate::engine::{Answer, Times};
use arcsum::region::{Node, Region};
use std::time::Instant;

/// Rings around a result, the interior on the left; or why there are none.
pub type Outcome = Result<Vec<Ring>, EngineError>;

/// Loops of lines and bulges, the interior on the left.
pub type Loops = Vec<Vec<Node>>;

/// What an engine is given, and what makes a sum of it. The unit box is 2^`bits` wide; integers need two bits more, and a
/// sign.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    /// The union of closed cycles.
    Union {
        /// The grid.
        bits: i32,
        /// The union.
        unite: fn(&[Ring]) -> Outcome,
    },
    /// The same of operands with chords for arcs. Flattening is part of the time, not of that of a stage.
    Flat {
        /// The greatest distance of an arc from its chord, in unit-box lengths.
        sagitta: f64,
        /// The grid.
        bits: i32,
        /// The union.
        unite: fn(&[Ring]) -> Outcome,
    },
    /// The sum of two regions, each by its loops.
    Minkowski {
        /// The grid.
        bits: i32,
        /// The sum.
        sum: fn(&[Ring], &[Ring]) -> Outcome,
    },
    /// The union of closed cycles of lines and circle segments, in unit-box lengths.
    Curves(fn(&[Vec<Stretch>]) -> Result<Loops, EngineError>),
    /// The offset by the radius of a disc; its time is that of the sum.
    Offset {
        /// The size of the unit box.
        bits: i32,
        /// The offset.
        offset: By,
    },
}

impl Way {
    /// The sum of two regions this way.
    ///
    /// # Errors
    /// [`EngineError::Invalid`] when an operand is degenerate, and those of the engine.
    pub fn sum(&self, a: &Region, b: &Region) -> Result<Answer, EngineError> {
        let start = Instant::now();
        match *self {
            Self::Union { bits, unite } => united(a, b, bits, unite, start),
            Self::Flat { sagitta, bits, unite } => {
                let [a, b] = flattened(a, b, sagitta)?;
                united(&a, &b, bits, unite, start)
            }
            Self::Minkowski { bits, sum } => {
                let grid = Grid::new(a, b, bits);
                let [a, b] = grid.operands(a, b);
                let ready = Instant::now();
                let rings = sum(&a, &b)?;
                let arrangement = Some(ready.elapsed());
                Ok(answer(grid.region(&rings), Times { arrangement, ..Times::default() }, start))
            }
            Self::Curves(unite) => {
                let curves = Curves::new(a, b)?;
                let convolution = Some(start.elapsed());
                let ready = Instant::now();
                let loops = unite(&curves.cycles)?;
                let arrangement = Some(ready.elapsed());
                Ok(answer(curves.region(&loops), Times { convolution, arrangement, ..Times::default() }, start))
            }
            Self::Offset { bits, offset: by } => {
                let (region, time) = offset(a, b, bits, by)?;
                let times = Times { total: Some(time), ..Times::default() };
                Ok(Answer { region, times, ..Answer::default() })
            }
        }
    }
}

/// The union of the convolution of two polygonal regions.
fn united(
    a: &Region,
    b: &Region,
    bits: i32,
    unite: fn(&[Ring]) -> Outcome,
    start: Instant,
) -> Result<Answer, EngineError> {
    let begun = Instant::now();
    let grid = Grid::new(a, b, bits);
    let cycles = grid.cycles(a, b)?;
    let convolution = Some(begun.elapsed());
    let ready = Instant::now();
    let rings = unite(&cycles)?;
    let arrangement = Some(ready.elapsed());
    Ok(answer(grid.region(&rings), Times { convolution, arrangement, ..Times::default() }, start))
}

fn answer(region: Region, times: Times, start: Instant) -> Answer {
    let times = Times { total: Some(start.elapsed()), ..times };
    Answer { region, times, ..Answer::default() }
}

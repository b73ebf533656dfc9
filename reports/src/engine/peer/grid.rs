//! Integer coordinates: regions and the cycles of their convolution on a grid, and back.

use super::EngineError;
use super::curves::convolved;
use super::walks::walks;
use arcsum::frame::Frame;
use arcsum::region::{Node, Region};
use glam::DVec2;

/// A closed polygon: its corners on the grid, the last joined to the first.
pub type Ring = Vec<[i64; 2]>;

/// The grid of a case: integers are unit-box lengths times 2^bits.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    frames: (Frame, Frame),
    bits: i32,
}

impl Grid {
    /// The grid for the sum of two regions. Its integers stay below 3 times 2^bits.
    pub fn new(a: &Region, b: &Region, bits: i32) -> Self {
        Self { frames: Frame::pair(a, b), bits }
    }

    /// The loops of both operands, each around its own origin.
    pub fn operands(&self, a: &Region, b: &Region) -> [Vec<Ring>; 2] {
        [(a, &self.frames.0), (b, &self.frames.1)].map(|(region, frame)| {
            let ring =
                |nodes: &Vec<Node>| nodes.iter().map(|n| self.point(frame.to_unit(DVec2::new(n.x, n.y)))).collect();
            region.loops.iter().map(ring).collect()
        })
    }

    /// The kinetic convolution of two bounded polygonal regions as closed cycles; their winding number is positive inside
    /// the sum and 0 outside (memo B).
    ///
    /// # Errors
    /// [`EngineError::Invalid`] when an operand is degenerate.
    pub fn cycles(&self, a: &Region, b: &Region) -> Result<Vec<Ring>, EngineError> {
        let pieces = convolved(a, b, &self.frames)?;
        let tail = |index: usize| pieces.points[pieces.pieces[index].tail as usize];
        let ring = |walk: Vec<usize>| walk.into_iter().map(|index| self.point(tail(index))).collect();
        Ok(walks(&pieces).into_iter().map(ring).collect())
    }

    /// The region inside rings of the sum, in input units.
    pub fn region(&self, rings: &[Ring]) -> Region {
        let length = |n: i64| libm::ldexp(n as f64, -self.bits);
        let node = |&[x, y]: &[i64; 2]| {
            let p = self.frames.0.sum_to_input(&self.frames.1, DVec2::new(length(x), length(y)));
            Node::line(p.x, p.y)
        };
        Region { loops: rings.iter().map(|ring| ring.iter().map(node).collect()).collect(), ..Region::default() }
    }

    fn point(&self, p: DVec2) -> [i64; 2] {
        [p.x, p.y].map(|x| libm::rint(libm::ldexp(x, self.bits)) as i64)
    }
}

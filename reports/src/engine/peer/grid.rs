//! Integer coordinates: regions and the cycles of their convolution on a grid, and back.

use super::EngineError;
use arcsum::convolution::kinetic;
use arcsum::frame::Frame;
use arcsum::piece::Pieces;
use arcsum::region::{Node, Region};
use arcsum::smooth::{Smooth, SmoothError};
use arcsum::sum3::Rounding;
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
        let refused = |error: SmoothError| EngineError::Invalid(error.to_string());
        let a = Smooth::new(a, &self.frames.0).map_err(refused)?;
        let b = Smooth::new(b, &self.frames.1).map_err(refused)?;
        let plane = || EngineError::Invalid("the sum is the whole plane".into());
        let pieces = kinetic(&a, &b, Rounding::Correct).ok_or_else(plane)?;
        let ring = |walk: Vec<u32>| walk.into_iter().map(|v| self.point(pieces.points[v as usize])).collect();
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

/// The pieces as closed walks over their vertices. Every vertex has as many pieces in as out, so a walk can only end where
/// it began; which piece follows which does not matter to winding numbers.
fn walks(pieces: &Pieces) -> Vec<Vec<u32>> {
    let mut heads = vec![Vec::new(); pieces.points.len()];
    pieces.pieces.iter().for_each(|piece| heads[piece.tail as usize].push(piece.head));
    let mut walks = Vec::new();
    for start in 0..heads.len() {
        while let Some(mut at) = heads[start].pop() {
            let mut walk = vec![start as u32];
            while at as usize != start {
                walk.push(at);
                let next = heads[at as usize].pop();
                at = next.expect("a convolution is closed");
            }
            walks.push(walk);
        }
    }
    walks
}

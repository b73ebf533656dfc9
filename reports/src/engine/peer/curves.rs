//! The kinetic convolution as closed cycles of lines and circle segments, in doubles, for unions that take arcs.

use super::walks::walks;
use super::{EngineError, Loops};
use arcsum::convolution::kinetic;
use arcsum::frame::Frame;
use arcsum::piece::{Piece, Pieces};
use arcsum::region::{Node, Region};
use arcsum::smooth::{Smooth, SmoothError};
use arcsum::sum3::Rounding;
use glam::DVec2;

/// A line or circle segment of the convolution, in unit-box lengths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Where it begins.
    pub tail: DVec2,
    /// Where it ends, bitwise where the next one of its cycle begins.
    pub head: DVec2,
    /// Half the sweep in radians, in [-pi/4, pi/4]: positive when the centre is on the left, 0 for a line.
    pub delta: f64,
}

/// The kinetic convolution of two regions in a common frame.
pub struct Curves {
    frames: (Frame, Frame),
    /// The cycles; their winding number is positive inside the sum and 0 outside (memo B).
    pub cycles: Vec<Vec<Stretch>>,
}

impl Curves {
    /// The convolution of two bounded regions.
    ///
    /// # Errors
    /// [`EngineError::Invalid`] when an operand is degenerate.
    pub fn new(a: &Region, b: &Region) -> Result<Self, EngineError> {
        let frames = Frame::pair(a, b);
        let pieces = convolved(a, b, &frames)?;
        let stretch = |index: usize| {
            let Piece { tail, head, delta, .. } = pieces.pieces[index];
            Stretch { tail: pieces.points[tail as usize], head: pieces.points[head as usize], delta }
        };
        let cycles = walks(&pieces).into_iter().map(|walk| walk.into_iter().map(stretch).collect()).collect();
        Ok(Self { frames, cycles })
    }

    /// The region of these loops of lines and bulges around the sum, in input units. Vertices that repeat the one before them are left out.
    #[must_use]
    pub fn region(&self, loops: &Loops) -> Region {
        let to_input = |node: &Node| {
            let p = self.frames.0.sum_to_input(&self.frames.1, DVec2::new(node.x, node.y));
            Node { x: p.x, y: p.y, ..*node }
        };
        let moved = |nodes: &Vec<Node>| without_repeats(nodes.iter().map(to_input).collect());
        Region { loops: loops.iter().map(moved).collect(), ..Region::default() }
    }
}

/// The kinetic convolution of two bounded regions in their frames.
///
/// # Errors
/// [`EngineError::Invalid`] when an operand is degenerate.
pub fn convolved(a: &Region, b: &Region, frames: &(Frame, Frame)) -> Result<Pieces, EngineError> {
    let refused = |error: SmoothError| EngineError::Invalid(error.to_string());
    let a = Smooth::new(a, &frames.0).map_err(refused)?;
    let b = Smooth::new(b, &frames.1).map_err(refused)?;
    kinetic(&a, &b, Rounding::Correct).ok_or_else(|| EngineError::Invalid("the sum is the whole plane".into()))
}

/// The loop without edges of no length: of vertices at one place the last stays, whose edge leads on.
pub fn without_repeats(nodes: Vec<Node>) -> Vec<Node> {
    let same = |i: usize| {
        let next = &nodes[(i + 1) % nodes.len()];
        (nodes[i].x, nodes[i].y) == (next.x, next.y)
    };
    (0..nodes.len()).filter(|&i| !same(i)).map(|i| nodes[i]).collect()
}

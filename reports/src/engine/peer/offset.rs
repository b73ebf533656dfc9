//! The sum with a disc as an offset, in a frame of the engine's size.

use super::curves::without_repeats;
use super::{EngineError, Loops};
use crate::bridge::plain;
use arcsum::frame::Frame;
use arcsum::region::{Curve, Node, Region};
use arcsum_oracle::disc::Disc;
use glam::DVec2;
use std::time::Duration;

/// What an engine offsets by: the loops of a region, outwards, by a radius.
pub type By = fn(&Loops, f64) -> Result<Offset, EngineError>;

/// The outcome of an offset.
#[derive(Clone, Debug, PartialEq)]
pub struct Offset {
    /// The loops of lines and bulges around it.
    pub loops: Loops,
    /// How long it took.
    pub time: Duration,
}

/// The sum of two regions one of which is a disc, the unit box scaled to be 2^bits wide; and the time of the offset.
///
/// # Errors
/// [`EngineError::Invalid`] when neither is a disc, and those of the engine.
pub fn offset(a: &Region, b: &Region, bits: i32, by: By) -> Result<(Region, Duration), EngineError> {
    let (a_frame, b_frame) = Frame::pair(a, b);
    let frames = [a_frame, b_frame].map(|frame| Frame { exp: frame.exp - bits, ..frame });
    let (region, disc, which) = match [a, b].map(|region| Disc::of(&plain(region))) {
        [_, Some(disc)] => (scaled(a, &frames[0]), disc, 1),
        [Some(disc), None] => (scaled(b, &frames[1]), disc, 0),
        [None, None] => return Err(EngineError::Invalid("neither operand is a disc".into())),
    };
    let (x, y) = disc.centre.nearest();
    let centre = frames[which].to_unit(DVec2::new(x, y));
    let found = by(&region.loops, frames[which].length_to_unit(disc.radius.to_f64()))?;
    let node = |node: &Node| {
        let p = frames[0].sum_to_input(&frames[1], DVec2::new(node.x, node.y) + centre);
        Node { x: p.x, y: p.y, ..*node }
    };
    let loops = found.loops.iter().map(|nodes| without_repeats(nodes.iter().map(node).collect())).collect();
    Ok((Region { loops, ..Region::default() }, found.time))
}

/// The region in units of the frame.
fn scaled(region: &Region, frame: &Frame) -> Region {
    let node = |node: &Node| {
        let p = frame.to_unit(DVec2::new(node.x, node.y));
        let curve = match node.curve {
            Curve::Radius(r) => Curve::Radius(frame.length_to_unit(r)),
            scale_free => scale_free,
        };
        Node { x: p.x, y: p.y, curve }
    };
    Region { loops: region.loops.iter().map(|nodes| nodes.iter().map(node).collect()).collect(), ..region.clone() }
}

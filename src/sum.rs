//! The approximate Minkowski sum: normalise, convolve, arrange, extract (MS 6 and 7 with the monotonic convolution,
//! MS 4 with the kinetic one, MS 3 with the convex one).

use crate::arrangement::{Arrangement, arrange_by};
use crate::cellwise::decide;
use crate::coincide::merged;
use crate::convolution::{convex_by, kinetic_by, monotonic_by, ordered};
use crate::cull::cull;
use crate::extract::{outline, region};
use crate::frame::Frame;
use crate::heuristic::{Rejected, reject};
use crate::part::Parts;
use crate::piece::{Piece, Pieces};
use crate::region::Region;
use crate::robustness::{Robustness, Step};
use crate::smooth::{Smooth, SmoothError};
use crate::tidy::{is_curled, tidied};
use std::time::{Duration, Instant};

/// Which convolution a sum is extracted from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Convolution {
    /// All sums of boundary points with equal normals (MS 3).
    Kinetic,
    /// Crusts and moved boundaries (MS 5).
    #[default]
    Monotonic,
    /// The convexly compatible ones of these sums, an ablation (MS 3): it has no winding numbers, and its error has no
    /// bound.
    Convex,
}

/// What can be chosen about a sum.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// The convolution.
    pub convolution: Convolution,
    /// The robustness steps that are taken.
    pub robustness: Robustness,
    /// The threshold below which cells are not believed to be free (MS 8.2), in unit-box lengths; none rejects no cells.
    /// See [`crate::heuristic`].
    pub threshold: Option<f64>,
    /// Whether to leave out what lies deep inside the sum before the arrangement ([`crate::cull`]), if there is no threshold.
    /// MS do not; the sum is the same but for roundings, cells inside it are not.
    pub culling: bool,
}

/// Time of each stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Times {
    /// Normalisation and convolution.
    pub convolution: Duration,
    /// Merging, culling and arrangement.
    pub arrangement: Duration,
    /// Extraction, the heuristic, and what decides cells one by one.
    pub extraction: Duration,
}

/// A sum and how it came about.
#[derive(Clone, Debug)]
pub struct Sum {
    /// The sum, in input units.
    pub region: Region,
    /// The convolution it was extracted from, in units of `frames`; empty when the sum is the whole plane.
    pub convolution: Pieces,
    /// The frames of the two operands.
    pub frames: (Frame, Frame),
    /// The arrangement of the convolution.
    pub arrangement: Arrangement,
    /// What the heuristic did, if there was a threshold. Its connectors are in the arrangement, not in the convolution.
    pub rejected: Option<Rejected>,
    /// Time of each stage.
    pub times: Times,
}

/// Why a sum could not be formed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SumError {
    /// An operand could not be normalised.
    #[error("operand {operand}: {reason}")]
    Operand {
        /// `A` or `B`.
        operand: char,
        /// What was wrong.
        reason: SmoothError,
    },
}

/// The Minkowski sum of two valid regions. Invalid regions give an error or a meaningless region, never a panic.
///
/// # Errors
/// [`SumError::Operand`] if a segment has no geometry.
pub fn sum(a: &Region, b: &Region, options: &Options) -> Result<Sum, SumError> {
    let start = Instant::now();
    let frames = Frame::pair(a, b);
    let smooth = |region, frame, operand| {
        smooth(region, frame, options.robustness).map_err(|reason| SumError::Operand { operand, reason })
    };
    let (smooth_a, smooth_b) = (smooth(a, &frames.0, 'A')?, smooth(b, &frames.1, 'B')?);
    let pieces = match options.convolution {
        Convolution::Kinetic => kinetic_by(&smooth_a, &smooth_b, options.robustness).map(|pieces| (pieces, None)),
        Convolution::Convex => convex_by(&smooth_a, &smooth_b, options.robustness).map(|pieces| (pieces, None)),
        Convolution::Monotonic => {
            monotonic_by(&smooth_a, &smooth_b, options.robustness).map(|(pieces, order)| (pieces, Some(order)))
        }
    };
    let plane = pieces.is_none();
    let (convolution, order) = pieces.unwrap_or_else(|| (Pieces { base: [1, 0], ..Pieces::default() }, None));
    let convolved = Instant::now();
    let reduced = reduced(&convolution, options);
    let order = match &reduced {
        None => order,
        Some(Parts { pieces, origins }) => order.map(|order| order.of_parts(pieces, origins)),
    };
    let arranged = reduced.as_ref().map_or(&convolution, |parts| &parts.pieces);
    let mut arrangement = match &order {
        None => arrange_by(arranged, options.robustness),
        Some(order) => ordered::arrange(arranged, order, options.robustness),
    };
    let done = Instant::now();
    if options.convolution == Convolution::Convex && !plane {
        decide(&mut arrangement, &smooth_a, &smooth_b);
    }
    let mut with_connectors = options.threshold.map(|_| arranged.clone());
    let threshold = options.threshold.unwrap_or_default();
    let rejected = with_connectors.as_mut().map(|pieces| reject(&mut arrangement, pieces, threshold));
    let loops = outline(&arrangement, with_connectors.as_ref().unwrap_or(arranged), |w| w[0] != 0);
    let region = region(&loops, convolution.base[0] != 0 || plane, |p| frames.0.sum_to_input(&frames.1, p));
    let times = Times { convolution: convolved - start, arrangement: done - convolved, extraction: done.elapsed() };
    Ok(Sum { region, convolution, frames, arrangement, rejected, times })
}

/// What is left of a convolution when what coincides is merged and, if asked for, what lies deep inside is culled. `None` if
/// that is all of it. A convex convolution has no winding numbers to keep.
fn reduced(convolution: &Pieces, options: &Options) -> Option<Parts> {
    if options.convolution == Convolution::Convex {
        return None;
    }
    let merged = if options.robustness.takes(Step::Cuts) { merged(convolution) } else { None };
    let culls = options.culling && options.threshold.is_none();
    let left = merged.as_ref().map_or(convolution, |parts| &parts.pieces);
    match if culls { cull(left) } else { None } {
        None => merged,
        Some(culled) => Some(match &merged {
            None => culled,
            Some(merged) => merged.refined(culled),
        }),
    }
}

/// Smooths an operand, tidied if need be: results of the engine have loops that cross, fold or curl by a rounding. An operand
/// that cannot be helped is taken, or refused, as it is.
fn smooth(region: &Region, frame: &Frame, robustness: Robustness) -> Result<Smooth, SmoothError> {
    let smooth = |region: &Region| Smooth::by(region, frame, robustness);
    let plain = smooth(region);
    if plain.is_ok() && !is_curled(region) {
        return plain;
    }
    tidied(region).and_then(|(tidied, _)| smooth(&tidied).ok()).map_or(plain, Ok)
}

impl Sum {
    /// Cells of negative winding number. The sum takes them in, as MS 4 does; there are none in exact arithmetic.
    #[must_use]
    pub fn negative_cells(&self) -> usize {
        self.arrangement.graph.windings.iter().filter(|w| w[0] < 0).count()
    }

    /// The convolution in input units, each segment as x0, y0, x1, y1 and its bulge.
    #[must_use]
    pub fn convolution_in_input_units(&self) -> Vec<[f64; 5]> {
        let segment = |piece: &Piece| {
            let [p, q] = [piece.tail, piece.head]
                .map(|v| self.frames.0.sum_to_input(&self.frames.1, self.convolution.points[v as usize]));
            [p.x, p.y, q.x, q.y, libm::tan(0.25 * piece.a.turn_to(piece.b))]
        };
        self.convolution.pieces.iter().map(segment).collect()
    }
}

//! The abscissas at which the vertical order of a set of curves may change, gathered in thin strips.
//!
//! Between neighbouring strips no two curves meet, except those that share a carrier to within the zone.

use std::cmp::Ordering;
use std::sync::Arc;

use rug::Float;

use super::curve::Curve;
use super::meet::{LIMIT, Meeting, meet};
use super::precision::Precision;
use super::real::Real;
use super::vector::Vector;
use crate::boxes::{Boxes, Extent};
use crate::error::OracleError;

/// Slabs between strips are wider than two to this power; closer strips are joined. Products of three differences of
/// doubles near 1 are larger, so strips are joined where something is degenerate only.
const SLAB: i32 = -190;

/// A piece of a boundary.
#[derive(Clone, Debug)]
pub struct Span {
    /// The piece.
    pub curve: Arc<Curve>,
    /// Boxes around its start and its end. Where pieces follow one another these boxes have a point in common; the pieces
    /// themselves may miss each other by less.
    pub ends: [Vector; 2],
}

impl From<&Arc<Curve>> for Span {
    /// A piece that meets its neighbours exactly.
    fn from(curve: &Arc<Curve>) -> Self {
        let piece = curve.at(LIMIT);
        Self { curve: Arc::clone(curve), ends: [piece.from.clone(), piece.to.clone()] }
    }
}

/// Neighbouring strips and what happens in them.
pub struct Strips {
    /// Lower and upper abscissa of each, from left to right, disjoint.
    pub ends: Vec<[Float; 2]>,
    /// For each strip, the curves that start, end or meet others in it, each once.
    pub involved: Vec<Vec<usize>>,
    /// For each curve, the strips in which its left and its right end lie. Equal for an upright curve.
    pub spans: Vec<[usize; 2]>,
}

/// An interval of abscissas and what happens there.
struct Event {
    ends: [Float; 2],
    kind: Kind,
}

/// A curve ends, or two curves meet: perhaps only near the end of one, beyond the strip in which it ends.
enum Kind {
    End(usize),
    Contact([usize; 2]),
}

impl Strips {
    /// The strips of these curves; `None` if some pair of curves is undecided.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn new(pieces: &[&Span]) -> Result<Option<Self>, OracleError> {
        let curves: Vec<Arc<Curve>> = pieces.iter().map(|piece| Arc::clone(&piece.curve)).collect();
        let Some(mut events) = contacts(&curves)? else { return Ok(None) };
        for (i, piece) in pieces.iter().enumerate() {
            events.extend(piece.ends.each_ref().map(|end| Event { ends: end.x.floats(LIMIT), kind: Kind::End(i) }));
        }
        events.sort_by(|a, b| a.ends[0].partial_cmp(&b.ends[0]).unwrap_or(Ordering::Equal));
        let mut strips = Self { ends: Vec::new(), involved: Vec::new(), spans: vec![[usize::MAX, 0]; curves.len()] };
        for event in events {
            strips.add(event);
        }
        for involved in &mut strips.involved {
            involved.sort_unstable();
            involved.dedup();
        }
        Ok(Some(strips))
    }

    /// Adds an event that starts at or after all earlier ones.
    fn add(&mut self, event: Event) {
        let gap = Float::with_val(LIMIT.bits(), Float::i_exp(1, SLAB));
        match self.ends.last_mut() {
            Some(last) if event.ends[0] <= Float::with_val(LIMIT.bits(), &last[1] + &gap) => {
                if event.ends[1] > last[1] {
                    last[1] = event.ends[1].clone();
                }
            }
            _ => {
                self.ends.push(event.ends.clone());
                self.involved.push(Vec::new());
            }
        }
        let strip = self.ends.len() - 1;
        match event.kind {
            Kind::Contact(curves) => self.involved[strip].extend(curves),
            Kind::End(curve) => {
                self.involved[strip].push(curve);
                let span = &mut self.spans[curve];
                *span = [span[0].min(strip), span[1].max(strip)];
            }
        }
    }

    /// The abscissa in the middle between a strip and the next one.
    #[must_use]
    pub fn middle(&self, strip: usize) -> Real {
        let sum = Float::with_val(LIMIT.bits(), &self.ends[strip][1] + &self.ends[strip + 1][0]);
        Real::from(sum / 2u32)
    }

    /// The width of a strip, rounded up.
    #[must_use]
    pub fn width(&self, strip: usize) -> f64 {
        let [left, right] = self.ends[strip].clone().map(Real::from);
        (right - left).hi()
    }

    /// Whether a curve reaches from this strip to the next.
    #[must_use]
    pub fn reaches_on(&self, curve: usize, strip: usize) -> bool {
        let [first, last] = self.spans[curve];
        first <= strip && strip < last
    }
}

/// The places where two curves meet.
fn contacts(curves: &[Arc<Curve>]) -> Result<Option<Vec<Event>>, OracleError> {
    let extents: Vec<Extent> = curves.iter().map(|curve| Extent { ends: curve.rough().bounds() }).collect();
    let boxes = Boxes::new(&extents)?;
    let mut events = Vec::new();
    let mut decided = true;
    for (i, curve) in curves.iter().enumerate() {
        let mut visit = |j: usize| {
            if j <= i || matches!(meet(curve.rough(), curves[j].rough(), Precision::DOUBLE), Meeting::Apart) {
                return;
            }
            match meet(curve.at(LIMIT), curves[j].at(LIMIT), LIMIT) {
                Meeting::Apart => {}
                Meeting::Unclear => decided = false,
                Meeting::Contacts { contacts, .. } => events.extend(
                    contacts
                        .iter()
                        .map(|contact| Event { ends: contact.place.x.floats(LIMIT), kind: Kind::Contact([i, j]) }),
                ),
            }
        };
        boxes.visit(&extents[i], &mut visit);
    }
    Ok(decided.then_some(events))
}

//! The chains of a stored boundary: maximal runs of spans in one direction (MS 2, with [`Up`] for the vertical).
//!
//! A span is a line, or what lies of a circle segment between two points where it turns back. The pieces into which the
//! engine cuts a circle segment at axis normals make one span again where one of them is short: the rounded point of
//! such a cut says nothing about the direction of a short piece. Spans parallel to the direction are left out, since
//! step 4 puts them back.

use std::cmp::Ordering;
use std::f64::consts::FRAC_PI_4;
use std::ops::Range;

use super::error::RealizeError;
use super::stored::StoredPiece;
use super::track::{Mark, Track};
use super::up::Up;
use crate::certified::precision::Precision;

/// A run of spans, each starting where the one before it ends.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The loop.
    pub ring: usize,
    /// Whether it runs to the right: a lower chain.
    pub rightward: bool,
    /// Its spans in order.
    pub spans: Vec<Span>,
}

/// A part of the boundary on one line or circle.
#[derive(Clone, Debug)]
pub struct Span {
    /// The pieces of the loop that make up the line or circle segment.
    pub pieces: Range<usize>,
    /// The ends, and the cuts between them.
    pub marks: Vec<Mark>,
    /// Whether it runs to the right.
    pub rightward: bool,
}

/// The chains of a loop, in its order.
///
/// # Errors
/// [`RealizeError`] if the pieces are no loop.
pub fn chains(ring: usize, pieces: &[StoredPiece], up: Up, precision: Precision) -> Result<Vec<Chain>, RealizeError> {
    check(ring, pieces)?;
    let track = Track { pieces, up, precision };
    let mut spans: Vec<Option<Span>> = Vec::new();
    for group in groups(pieces) {
        spans.extend(track.spans(ring, group)?);
    }
    let direction = |i: usize| spans[i % spans.len()].as_ref().map(|span| span.rightward);
    let first = (0..spans.len()).find(|&i| direction(i).is_some() && direction(i + spans.len() - 1) != direction(i));
    let first = first.ok_or(RealizeError::Turnless { ring })?;
    spans.rotate_left(first);
    let mut chains: Vec<Chain> = Vec::new();
    let mut broken = true;
    for span in spans {
        match (span, chains.last_mut()) {
            (None, _) => broken = true,
            (Some(span), Some(chain)) if !broken && chain.rightward == span.rightward => chain.spans.push(span),
            (Some(span), _) => {
                broken = false;
                chains.push(Chain { ring, rightward: span.rightward, spans: vec![span] });
            }
        }
    }
    if chains.len() < 2 { Err(RealizeError::Turnless { ring }) } else { Ok(chains) }
}

/// Whether the numbers are usable and the pieces meet end to end.
fn check(ring: usize, pieces: &[StoredPiece]) -> Result<(), RealizeError> {
    for (piece, this) in pieces.iter().enumerate() {
        let before = &pieces[(piece + pieces.len() - 1) % pieces.len()];
        let numbers = [this.tail.0, this.tail.1, this.head.0, this.head.1, this.radius];
        let angles = [this.start, this.end].into_iter().chain(this.stops.iter().map(|stop| stop.angle));
        let straight = this.radius != 0.0 || this.start == this.end;
        let usable = numbers.iter().all(|x| x.is_finite()) && angles.into_iter().all(|a| a.offset.abs() <= FRAC_PI_4);
        if !(usable && straight) {
            return Err(RealizeError::BadNumber { ring, piece });
        }
        if before.head != this.tail {
            return Err(RealizeError::Open { ring, piece });
        }
    }
    Ok(())
}

/// The pieces of one line or circle segment each.
fn groups(pieces: &[StoredPiece]) -> Vec<Range<usize>> {
    let mut groups: Vec<Range<usize>> = Vec::new();
    for (i, piece) in pieces.iter().enumerate() {
        match groups.last_mut() {
            Some(group) if goes_on(&pieces[i - 1], piece) => group.end = i + 1,
            _ => groups.push(i..i + 1),
        }
    }
    groups
}

/// Whether a piece continues the circle segment of the one before it and one of them is shorter than an eighth of a
/// turn. Pieces between two cuts are quarters, so no more than half a circle comes together.
fn goes_on(before: &StoredPiece, piece: &StoredPiece) -> bool {
    let arcs = !before.is_line() && !piece.is_line();
    let one = before.edge == piece.edge && before.end == piece.start;
    arcs && one && before.sweep().min(piece.sweep()) < FRAC_PI_4
}

impl Track<'_> {
    /// The spans of a line or circle segment; `None` for a line parallel to the direction.
    fn spans(&self, ring: usize, group: Range<usize>) -> Result<Vec<Option<Span>>, RealizeError> {
        if self.pieces[group.start].is_line() {
            let marks = vec![Mark::Tail(group.start), Mark::Head(group.start)];
            let rightward = match self.normal(marks[0]).y.sign() {
                None | Some(Ordering::Equal) => return Ok(vec![None]),
                Some(sign) => sign == Ordering::Less,
            };
            return Ok(vec![Some(Span { pieces: group, marks, rightward })]);
        }
        let mut spans = Vec::new();
        let mut marks: Vec<Mark> = Vec::new();
        let all = self.marks(&group);
        for (i, &mark) in all.iter().enumerate() {
            marks.push(mark);
            if i > 0 && (i + 1 == all.len() || self.turns(mark)) {
                let rightward = self.rightward(&marks).ok_or(RealizeError::BadNumber { ring, piece: group.start })?;
                spans.push(Some(Span { pieces: group.clone(), marks, rightward }));
                marks = vec![mark];
            }
        }
        Ok(spans)
    }

    /// The ends of a circle segment and between them the cuts at axis normals and where it turns back.
    fn marks(&self, group: &Range<usize>) -> Vec<Mark> {
        let mut marks = Vec::new();
        for i in group.clone() {
            marks.push(Mark::Tail(i));
            let ends = [Mark::Tail(i), Mark::Head(i)].map(|mark| self.normal(mark).y.sign());
            if let [Some(Ordering::Less), Some(Ordering::Greater)] | [Some(Ordering::Greater), Some(Ordering::Less)] =
                ends
            {
                marks.push(Mark::Turn(i));
            }
        }
        marks.push(Mark::Head(group.end - 1));
        marks
    }

    /// Whether a circle segment is parallel to the direction at a mark.
    pub fn turns(&self, mark: Mark) -> bool {
        matches!(mark, Mark::Turn(_)) || self.normal(mark).y.sign() == Some(Ordering::Equal)
    }

    /// Whether the part of a circle segment between these marks runs to the right; `None` if it does so in part.
    fn rightward(&self, marks: &[Mark]) -> Option<bool> {
        let heights: Vec<_> = marks.iter().map(|&mark| self.normal(mark).y).collect();
        let some = |sign: Ordering| heights.iter().any(|y| y.sign() == Some(sign));
        match (some(Ordering::Less), some(Ordering::Greater)) {
            (true, true) => None,
            (false, false) => {
                // Half a circle from one turning point to the other, without a cut: its middle is left or right of
                // the start.
                let left = self.pieces[marks[0].piece()].radius > 0.0;
                Some(self.normal(marks[0]).x.is_positive() != left)
            }
            (below, _) => Some(below),
        }
    }
}

//! Coinciding lines: of those that lie on each other, along an axis, one is left, with the net weight, before the convolution
//! is arranged (ours).
//!
//! The sweep merges what coincides, too, where it begins (memo C2). Teeth on a grid make so many copies of one line that this
//! is most of its work. Along an axis nothing is rounded, so the map is the same, whoever merges.

use crate::arrangement::curve::by_size;
use crate::part::{Parts, part};
use crate::piece::{Piece, Pieces};
use std::cmp::Ordering;

/// A line along an axis.
#[derive(Clone, Copy, Debug)]
struct Line {
    upright: bool,
    /// The coordinate that its points share.
    at: f64,
    /// The other coordinate of its left or lower end, and the vertex.
    from: (f64, u32),
    /// That of its right or upper end.
    to: (f64, u32),
    /// By how much the winding number is higher on the left of the way from the one to the other.
    weight: i32,
    piece: u32,
}

/// Merges the lines along axes that overlap: one part of one of them from where the net weight changes to where it changes
/// again, or where the one ends; nothing where they cancel. `None` if no lines overlap.
#[must_use]
pub fn merged(pieces: &Pieces) -> Option<Parts> {
    let lines = lines(pieces);
    let mut is_merged = vec![false; pieces.pieces.len()];
    let mut stretches = Vec::new();
    for bundle in bundles(&lines) {
        bundle.iter().for_each(|line| is_merged[line.piece as usize] = true);
        merge(bundle, &mut stretches);
    }
    if stretches.is_empty() && !is_merged.contains(&true) {
        return None;
    }
    let count = is_merged.iter().filter(|is_merged| !**is_merged).count() + stretches.len();
    let (mut all, mut origins) = (Vec::with_capacity(count), Vec::with_capacity(count));
    for (index, piece) in pieces.pieces.iter().enumerate().filter(|(index, _)| !is_merged[*index]) {
        all.push(*piece);
        origins.push(Some(index as u32));
    }
    for stretch in &stretches {
        all.push(stretch.part(pieces));
        origins.push(Some(stretch.line.piece));
    }
    Some(Parts { pieces: Pieces { points: pieces.points.clone(), pieces: all, base: pieces.base }, origins })
}

/// The lines along axes, those that may overlap next to each other, by their beginnings.
fn lines(pieces: &Pieces) -> Vec<Line> {
    let line = |(index, piece): (usize, &Piece)| {
        let [p, q] = [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
        let upright = p.x == q.x;
        if piece.delta != 0.0 || p == q || !(upright || p.y == q.y) {
            return None;
        }
        let (at, p, q) = if upright { (p.x, p.y, q.y) } else { (p.y, p.x, q.x) };
        let (tail, head) = ((p, piece.tail), (q, piece.head));
        let (from, to, weight) = if p < q { (tail, head, piece.weight) } else { (head, tail, -piece.weight) };
        Some(Line { upright, at, from, to, weight, piece: index as u32 })
    };
    let mut lines: Vec<Line> = pieces.pieces.iter().enumerate().filter_map(line).collect();
    lines.sort_unstable_by(|l, m| {
        let by_place = l.upright.cmp(&m.upright).then_with(|| order(l.at, m.at));
        by_place.then_with(|| order(l.from.0, m.from.0)).then(l.piece.cmp(&m.piece))
    });
    lines
}

/// The order of numbers, of which 0 and -0 are one.
fn order(x: f64, y: f64) -> Ordering {
    by_size(x + 0.0, y + 0.0)
}

/// The runs of two lines or more in which each overlaps one before it.
fn bundles(lines: &[Line]) -> Vec<&[Line]> {
    let (mut bundles, mut start, mut reach) = (Vec::new(), 0, f64::NEG_INFINITY);
    for (i, line) in lines.iter().enumerate() {
        let first = &lines[start];
        let overlaps = first.upright == line.upright && first.at == line.at && line.from.0 < reach;
        if !overlaps {
            bundles.push(&lines[start..i]);
            (start, reach) = (i, f64::NEG_INFINITY);
        }
        reach = reach.max(line.to.0);
    }
    bundles.push(&lines[start..]);
    bundles.retain(|bundle| bundle.len() > 1);
    bundles
}

/// A part of a line, with the net weight of all that lie on it.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    line: Line,
    from: u32,
    to: u32,
    weight: i32,
}

impl Stretch {
    /// The part, in the direction of the whole.
    fn part(&self, pieces: &Pieces) -> Piece {
        let whole = &pieces.pieces[self.line.piece as usize];
        let forward = whole.tail == self.line.from.1;
        let ([tail, head], weight) =
            if forward { ([self.from, self.to], self.weight) } else { ([self.to, self.from], -self.weight) };
        Piece { weight, ..part(&pieces.points, whole, tail, head) }
    }
}

/// Adds what a bundle comes to.
fn merge(bundle: &[Line], stretches: &mut Vec<Stretch>) {
    let ends = |line: &Line| [(line.from, line.weight), (line.to, -line.weight)];
    let mut stops: Vec<((f64, u32), i32)> = bundle.iter().flat_map(ends).collect();
    stops.sort_by(|s, t| order(s.0.0, t.0.0));
    let mut coming = bundle.iter().peekable();
    let (mut longest, mut weight, mut open) = (bundle[0], 0, None::<Stretch>);
    for same in stops.chunk_by(|s, t| s.0.0 == t.0.0) {
        let (at, vertex) = same[0].0;
        weight += same.iter().map(|stop| stop.1).sum::<i32>();
        while let Some(line) = coming.next_if(|line| line.from.0 == at) {
            longest = if line.to.0 > longest.to.0 { *line } else { longest };
        }
        if open.is_some_and(|open| open.weight == weight && open.line.to.0 > at) {
            continue;
        }
        stretches.extend(open.take().map(|open| Stretch { to: vertex, ..open }));
        open = (weight != 0).then_some(Stretch { line: longest, from: vertex, to: vertex, weight });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::piece::Source;
    use glam::DVec2;

    /// Lines between points on the integers.
    fn pieces(lines: &[[i32; 4]]) -> Pieces {
        let points: Vec<DVec2> = lines
            .iter()
            .flat_map(|[x, y, u, v]| [[*x, *y], [*u, *v]])
            .map(|[x, y]| DVec2::new(x.into(), y.into()))
            .collect();
        let piece = |i: usize| Piece::between(&points, 2 * i as u32, 2 * i as u32 + 1, Source::default());
        Pieces { pieces: (0..lines.len()).map(piece).collect(), points, base: [0; 2] }
    }

    /// The ends and weights of what is left, and where it comes from.
    fn left(lines: &[[i32; 4]]) -> Vec<([i32; 4], i32, u32)> {
        let Some(Parts { pieces, origins }) = merged(&pieces(lines)) else { return Vec::new() };
        let of = |(piece, origin): (&Piece, &Option<u32>)| {
            let [p, q] = [piece.tail, piece.head].map(|v| pieces.points[v as usize]);
            assert_eq!(Piece::between(&pieces.points, piece.tail, piece.head, Source::default()).a, piece.a);
            ([p.x as i32, p.y as i32, q.x as i32, q.y as i32], piece.weight, origin.expect("a part"))
        };
        pieces.pieces.iter().zip(&origins).map(of).collect()
    }

    #[test]
    fn copies_add_up_and_opposites_cancel() {
        assert_eq!(left(&[[0, 1, 4, 1], [0, 1, 4, 1]]), [([0, 1, 4, 1], 2, 0)]);
        assert_eq!(left(&[[0, 1, 4, 1], [0, 0, 1, 1], [4, 1, 0, 1]]), [([0, 0, 1, 1], 1, 1)]);
        assert_eq!(left(&[[2, 5, 2, 0], [2, 1, 2, 7]]), [([2, 1, 2, 0], 1, 0), ([2, 5, 2, 7], 1, 1)]);
    }

    #[test]
    fn an_overlap_is_cut_where_the_weight_changes() {
        let found = left(&[[0, 0, 3, 0], [2, 0, 5, 0], [7, 0, 5, 0]]);
        // What only touches stays whole.
        assert_eq!(found, [([7, 0, 5, 0], 1, 2), ([0, 0, 2, 0], 1, 0), ([2, 0, 3, 0], 2, 1), ([3, 0, 5, 0], 1, 1)]);
    }

    #[test]
    fn nothing_is_done_where_nothing_overlaps() {
        assert!(
            merged(&pieces(&[[0, 0, 3, 0], [3, 0, 5, 0], [0, 1, 3, 1], [0, 0, 0, 1], [1, 1, 2, 2], [1, 1, 2, 2]]))
                .is_none()
        );
        assert!(merged(&Pieces::default()).is_none());
    }
}

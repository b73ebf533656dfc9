//! From boundary edges to the normal form of a region: simple loops, interior on the left, in canonical order.
//!
//! At a point where several loops meet (a pinch) each incoming edge is continued by the next edge clockwise, which
//! bounds the same sector of the interior: loops touch there but never cross. A loop that comes back to a point is then
//! split there, so every loop is simple. Two loops of one region can therefore share points, never edges. The result
//! does not depend on the order of the splits: drawn slightly apart at its pinches a loop is a simple closed curve, its
//! returns are disjoint chords on the outside of the interior, and disjoint chords do not interleave. Collinear vertices
//! are dropped, loops begin at their lexicographic minimum and are sorted.

use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap};

use crate::arrange::Edge;
use crate::boxes::{Boxes, Extent};
use crate::error::OracleError;
use crate::graph::Graph;
use crate::number::Number;
use crate::point::{Place, Point, cross_sign, dot_sign, orient};

/// The loops of the region whose boundary these edges are: edges with the interior on their left that meet only at
/// ends, or with an end on the inside of an edge.
///
/// # Errors
/// [`OracleError::Inconsistent`] if the edges do not close up.
pub fn loops<Q: Number>(edges: Vec<Edge<Q>>) -> Result<Vec<Vec<Point<Q>>>, OracleError> {
    let mut graph = Graph::new(edges);
    graph.split_at_touches()?;
    let mut rings = Vec::new();
    for walk in graph.walks()? {
        rings.extend(split_at_returns(walk));
    }
    let mut loops: Vec<_> = rings.iter().map(|ring| graph.normal_ring(ring)).filter(|ring| ring.len() > 2).collect();
    loops.sort();
    Ok(loops)
}

impl<Q: Number> Graph<Q> {
    /// Cuts the edges that pass straight through a place where others end, so that they take part in the pairing there:
    /// a hole that touches the inside of an edge at two places cuts the interior in two.
    fn split_at_touches(&mut self) -> Result<(), OracleError> {
        let ends = |&(a, b): &(usize, usize)| Extent::around([&self.places[a], &self.places[b]]);
        let boxes = Boxes::new(&self.edges.iter().filter_map(ends).collect::<Vec<_>>())?;
        let mut cuts: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (touch, place) in self.places.iter().enumerate() {
            let spot = Extent::around([place]);
            boxes.visit(&spot.expect("one place has an extent"), |e| {
                if self.passes_through(self.edges[e], touch) {
                    cuts.entry(e).or_default().push(touch);
                }
            });
        }
        for (edge, mut at) in cuts {
            let (tail, head) = self.edges[edge];
            at.sort_by(|&p, &q| self.places[p].order(&self.places[q]));
            if self.places[tail].order(&self.places[head]).is_gt() {
                at.reverse();
            }
            at.push(head);
            self.edges[edge] = (tail, at[0]);
            self.edges.extend(at.windows(2).map(|pair| (pair[0], pair[1])));
        }
        Ok(())
    }

    fn passes_through(&self, (tail, head): (usize, usize), place: usize) -> bool {
        let (a, b, p) = (&self.places[tail], &self.places[head], &self.places[place]);
        place != tail && place != head && orient(a, b, p).is_eq() && dot_sign(a, p, p, b).is_gt()
    }

    /// Follows the boundary: closed walks as lists of places.
    fn walks(&self) -> Result<Vec<Vec<usize>>, OracleError> {
        let mut leaving = vec![Vec::new(); self.places.len()];
        self.edges.iter().enumerate().for_each(|(e, &(tail, _))| leaving[tail].push(e));
        let mut used = vec![false; self.edges.len()];
        let mut walks = Vec::new();
        for start in 0..self.edges.len() {
            let mut walk = Vec::new();
            let mut edge = start;
            while !used[edge] {
                used[edge] = true;
                let (tail, head) = self.edges[edge];
                walk.push(tail);
                edge = *leaving[head]
                    .iter()
                    .min_by(|&&e, &&f| self.clockwise(head, tail, self.edges[e].1, self.edges[f].1))
                    .ok_or(OracleError::Inconsistent("boundary edges do not close up"))?;
            }
            if edge != start {
                return Err(OracleError::Inconsistent("boundary edges join"));
            }
            if !walk.is_empty() {
                walks.push(walk);
            }
        }
        Ok(walks)
    }

    /// Which of the directions from `centre` to p and to q comes first clockwise after the one to `from`.
    fn clockwise(&self, centre: usize, from: usize, p: usize, q: usize) -> Ordering {
        if p == q {
            return Ordering::Equal;
        }
        let [centre, from, p, q] = [centre, from, p, q].map(|i| &self.places[i]);
        // 0 within half a turn, 1 straight on, 2 beyond, 3 back along the incoming edge.
        let sector = |to: &Place<Q>| match cross_sign(centre, from, centre, to) {
            Ordering::Less => 0,
            Ordering::Equal if dot_sign(centre, from, centre, to).is_lt() => 1,
            Ordering::Equal => 3,
            Ordering::Greater => 2,
        };
        let turn = || cross_sign(centre, p, centre, q);
        sector(p).cmp(&sector(q)).then_with(turn)
    }

    /// The ring without collinear vertices, from its lexicographic minimum on.
    fn normal_ring(&self, ring: &[usize]) -> Vec<Point<Q>> {
        let place = |i: usize| &self.places[ring[i % ring.len()]];
        let turns = |&i: &usize| orient(place(i + ring.len() - 1), place(i), place(i + 1)).is_ne();
        let mut corners: Vec<usize> = (0..ring.len()).filter(turns).collect();
        let lowest = (0..corners.len()).min_by(|&i, &j| place(corners[i]).order(place(corners[j])));
        corners.rotate_left(lowest.unwrap_or(0));
        corners.into_iter().map(|i| place(i).exact.clone()).collect()
    }
}

/// Splits a closed walk into closed walks that visit no place twice.
fn split_at_returns(walk: Vec<usize>) -> Vec<Vec<usize>> {
    let mut rings = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    let mut position: HashMap<usize, usize> = HashMap::new();
    for place in walk {
        if let Some(&first) = position.get(&place) {
            open[first + 1..].iter().for_each(|p| {
                position.remove(p);
            });
            rings.push(open.split_off(first));
            position.remove(&place);
        }
        position.insert(place, open.len());
        open.push(place);
    }
    rings.push(open);
    rings
}

#[cfg(test)]
mod tests {
    use super::{loops, split_at_returns};
    use crate::arrange::Edge;
    use crate::point::Point;
    use crate::region::ring_edges;
    use rug::Rational;

    fn ring(corners: &[(i32, i32)]) -> Vec<Point<Rational>> {
        corners.iter().map(|&(x, y)| Point { x: Rational::from(x), y: Rational::from(y) }).collect()
    }

    fn edges(rings: &[&[(i32, i32)]]) -> Vec<Edge<Rational>> {
        let close = |corners: &&[(i32, i32)]| {
            ring_edges(&ring(corners)).map(|(a, b)| (a.clone(), b.clone())).collect::<Vec<_>>()
        };
        rings.iter().flat_map(close).collect()
    }

    #[test]
    fn a_walk_is_split_at_every_return() {
        assert_eq!(split_at_returns(vec![0, 1, 2, 1, 3, 0, 4]), [vec![1, 2], vec![0, 1, 3], vec![0, 4]]);
    }

    #[test]
    fn a_checkerboard_becomes_touching_squares() {
        // Two crossing diagonally placed unit squares given as one figure of eight.
        let eight: &[(i32, i32)] = &[(0, 0), (1, 0), (1, 1), (2, 1), (2, 2), (1, 2), (1, 1), (0, 1)];
        let expected = [ring(&[(0, 0), (1, 0), (1, 1), (0, 1)]), ring(&[(1, 1), (2, 1), (2, 2), (1, 2)])];
        assert_eq!(loops(edges(&[eight])).expect("closed"), expected);
    }

    #[test]
    fn a_pinch_on_the_inside_of_an_edge_is_paired_like_one_at_a_vertex() {
        // A hole touches the edge x = 2 from the left and an island touches it from the right, both at (2, 1); the
        // second description cuts the edge there.
        let (hole, island): (&[_], &[_]) = (&[(2, 1), (1, 0), (1, 2)], &[(2, 1), (3, 0), (3, 2)]);
        let whole: &[_] = &[(-2, -2), (2, -2), (2, 4), (-2, 4)];
        let cut: &[_] = &[(-2, -2), (2, -2), (2, 1), (2, 4), (-2, 4)];
        let first = loops(edges(&[whole, hole, island])).expect("closed");
        assert_eq!(first, loops(edges(&[cut, hole, island])).expect("closed"));
        assert_eq!(first, [ring(whole), ring(&[(1, 0), (1, 2), (2, 1)]), ring(island)]);
    }

    #[test]
    fn touching_squares_around_a_gap_stay_squares() {
        // Four squares that touch in a ring: not an outer loop with a hole, since no interior connects them.
        let squares = [(0, 1), (1, 0), (1, 2), (2, 1)].map(|(x, y)| [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]);
        let rings: Vec<&[(i32, i32)]> = squares.iter().map(|square| &square[..]).collect();
        assert_eq!(loops(edges(&rings)).expect("closed"), squares.map(|square| ring(&square)));
        // Their complement has two pieces, the gap and the rest of the plane, so its loops are those of the pieces.
        let holes = squares.map(|[a, b, c, d]| [a, d, c, b]);
        let rings: Vec<&[(i32, i32)]> = holes.iter().map(|hole| &hole[..]).collect();
        let (outer, inner) = (
            [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3), (2, 2), (3, 2), (3, 1), (2, 1), (2, 0), (1, 0), (1, 1)],
            [(1, 1), (2, 1), (2, 2), (1, 2)],
        );
        assert_eq!(loops(edges(&rings)).expect("closed"), [ring(&outer), ring(&inner)]);
    }

    #[test]
    fn a_hole_that_touches_an_edge_twice_cuts_the_interior() {
        let square: &[_] = &[(0, 0), (4, 0), (4, 4), (0, 4)];
        let hole: &[_] = &[(0, 2), (2, 4), (2, 2)];
        let (corner, rest): (&[_], &[_]) =
            (&[(0, 2), (2, 4), (0, 4)], &[(0, 0), (4, 0), (4, 4), (2, 4), (2, 2), (0, 2)]);
        assert_eq!(loops(edges(&[square, hole])).expect("closed"), [ring(rest), ring(corner)]);
    }

    #[test]
    fn open_edges_are_refused() {
        let mut open = edges(&[&[(0, 0), (1, 0), (1, 1)]]);
        open.pop();
        assert!(loops(open).is_err());
    }
}

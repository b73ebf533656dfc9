//! Whether the stretches of a boundary close up: where some arrive, as many leave.
//!
//! Stretches meet in places, the clusters at their ends. Places nearer to each other than a few clusters count as one, since
//! a stretch may be swallowed by a cluster of its own curve while its neighbours are not. A boundary that misses a longer
//! stretch or has one too many is out of balance at the ends of it.

use super::boundary::{Boundary, Edge};
use super::real::Real;
use super::vector::Vector;
use super::walk::CLUSTER;
use crate::boxes::{Boxes, Extent};
use crate::error::OracleError;

impl Boundary {
    /// Checks that as many edges arrive at every place as leave it, places with undecided stretches aside.
    ///
    /// # Errors
    /// [`OracleError::Inconsistent`] if not; [`OracleError::BadNumber`] for places too large to index.
    pub fn check_closed(&self) -> Result<(), OracleError> {
        if self.edges.is_empty() {
            return Ok(());
        }
        let edges = || self.edges.iter().chain(&self.undecided);
        let places: Vec<&Vector> = edges().flat_map(|edge: &Edge| &edge.ends).collect();
        let groups = groups(&places)?;
        let mut balance = vec![0i64; places.len()];
        let mut open = vec![false; places.len()];
        for edge in 0..places.len() / 2 {
            let [start, end] = [groups[2 * edge], groups[2 * edge + 1]];
            if edge < self.edges.len() {
                balance[start] += 1;
                balance[end] -= 1;
            } else {
                open[start] = true;
                open[end] = true;
            }
        }
        if balance.iter().zip(open).any(|(&balance, open)| balance != 0 && !open) {
            return Err(OracleError::Inconsistent("the boundary of a sum does not close up"));
        }
        Ok(())
    }
}

impl Boundary {
    /// The number of loops, if no two of them touch and nothing is undecided.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for places too large to index.
    pub fn loops(&self) -> Result<Option<usize>, OracleError> {
        if !self.undecided.is_empty() {
            return Ok(None);
        }
        if self.edges.is_empty() {
            return Ok(Some(0));
        }
        let places: Vec<&Vector> = self.edges.iter().flat_map(|edge| &edge.ends).collect();
        let groups = groups(&places)?;
        let mut leaving = vec![None; places.len()];
        for edge in 0..self.edges.len() {
            if leaving[groups[2 * edge]].replace(edge).is_some() {
                return Ok(None);
            }
        }
        let mut passed = vec![false; self.edges.len()];
        let mut loops = 0;
        for start in 0..self.edges.len() {
            loops += usize::from(!passed[start]);
            let mut next = Some(start);
            while let Some(edge) = next.filter(|&edge| !passed[edge]) {
                passed[edge] = true;
                next = leaving[groups[2 * edge + 1]];
            }
        }
        Ok(Some(loops))
    }
}

/// For every place the number of its group: those it overlaps, directly or by others.
fn groups(places: &[&Vector]) -> Result<Vec<usize>, OracleError> {
    let extents: Vec<_> = places.iter().map(|place| extent(place)).collect();
    let boxes = Boxes::new(&extents)?;
    let mut groups = vec![usize::MAX; places.len()];
    for first in 0..places.len() {
        let mut reached = if groups[first] == usize::MAX { vec![first] } else { Vec::new() };
        while let Some(place) = reached.pop() {
            groups[place] = first;
            boxes.visit(&extents[place], |other| {
                if groups[other] == usize::MAX && overlap(places[place], places[other]) {
                    groups[other] = first;
                    reached.push(other);
                }
            });
        }
    }
    Ok(groups)
}

fn extent(place: &Vector) -> Extent {
    let [low, high] = [|c: &Real| (c.lo() - reach()).next_down(), |c: &Real| (c.hi() + reach()).next_up()];
    Extent { ends: [low(&place.x), low(&place.y), high(&place.x), high(&place.y)] }
}

/// The distance within which places count as one.
fn reach() -> f64 {
    f64::from(CLUSTER + 2).exp2()
}

fn overlap(a: &Vector, b: &Vector) -> bool {
    let near = |a: &Real, b: &Real| !(a + reach()).is_below(b) && !(b + reach()).is_below(a);
    near(&a.x, &b.x) && near(&a.y, &b.y)
}

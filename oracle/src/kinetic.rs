//! The kinetic convolution of two polygonal regions as the papers state it, in exact arithmetic (MS 3; memo B2): what
//! statements about it are tested with. For sums there is [`crate::convolve`], which leaves out what is not needed.
//!
//! The winding number around t is the Euler characteristic of A ∩ (t-B) if all loops take part (memo fact 6). It is positive
//! on the sum and 0 elsewhere once holes are filled that cannot matter.

use crate::arrange::boundaries;
use crate::convolve::{Ties, sum_segments};
use crate::curves::Curves;
use crate::error::{Budget, OracleError};
use crate::locate::Locator;
use crate::number::Number;
use crate::parts::{Part, Ring, parts};
use crate::point::{Place, Point};
use crate::region::ExactRegion;

/// Which holes take part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holes {
    /// All of them.
    All,
    /// Those in which a component of the other region may lie (memo A8).
    Fitting,
}

/// The kinetic convolution of two regions of which one is bounded.
pub struct Kinetic<Q> {
    curves: Curves<Q>,
    base: i32,
    forward: Vec<[Point<Q>; 2]>,
    backward: Vec<[Point<Q>; 2]>,
}

impl<Q: Number> Kinetic<Q> {
    /// Convolves; `None` if both regions are unbounded, or if holes are left out and the sum is the plane.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn new(a: &ExactRegion<Q>, b: &ExactRegion<Q>, holes: Holes, ties: Ties) -> Result<Option<Self>, OracleError> {
        if a.unbounded() && b.unbounded() {
            return Ok(None);
        }
        let mut all = Self { curves: Curves::default(), base: 0, forward: Vec::new(), backward: Vec::new() };
        let (parts_a, parts_b) = (parts(a)?, parts(b)?);
        for x in &parts_a {
            for y in &parts_b {
                let (rings_x, rings_y) = (rings(x, y, holes), rings(y, x, holes));
                if rings_x.is_empty() || rings_y.is_empty() {
                    return Ok(None);
                }
                all.base += match (x.unbounded(), y.unbounded()) {
                    (true, _) => characteristic(&rings_y),
                    (_, true) => characteristic(&rings_x),
                    _ => 0,
                };
                for ring in &rings_x {
                    rings_y.iter().try_for_each(|other| all.add(ring, other, ties))?;
                }
            }
        }
        Ok(Some(all))
    }

    fn add(&mut self, a: &Ring<Q>, b: &Ring<Q>, ties: Ties) -> Result<(), OracleError> {
        sum_segments(a, b, ties, |ends, left| {
            let [from, to] = ends.map(|(i, j)| a[i].exact.plus(&b[j].exact));
            let segment = if left { [from, to] } else { [to, from] };
            let [tail, head] = segment.each_ref().map(|p| self.curves.place(p.clone()));
            self.curves.segment(tail, head, 0);
            if left {
                self.forward.push(segment)
            } else {
                self.backward.push(segment)
            }
            Ok(())
        })
    }

    /// The sum segments at convex corners, which are convexly compatible (MS 5).
    #[must_use]
    pub fn forward(&self) -> &[[Point<Q>; 2]] {
        &self.forward
    }

    /// The sum segments at reflex corners, which are not.
    #[must_use]
    pub fn backward(&self) -> &[[Point<Q>; 2]] {
        &self.backward
    }

    /// Winding numbers of points.
    ///
    /// # Errors
    /// [`OracleError::BadNumber`] for coordinates too large for doubles.
    pub fn locator(&self) -> Result<Locator<Q>, OracleError> {
        let mut edges = Vec::new();
        let mut places: Vec<Place<Q>> = Vec::new();
        for segment in self.curves.segments() {
            let (tail, head) =
                if segment.weight > 0 { (segment.tail, segment.head) } else { (segment.head, segment.tail) };
            for _ in 0..segment.weight.abs() {
                edges.push((places.len(), places.len() + 1));
                places.extend([self.curves.at(tail).clone(), self.curves.at(head).clone()]);
            }
        }
        Locator::of_edges(places, edges, self.base)
    }

    /// The closure of the points whose winding numbers are these; the convolution must be closed ([`Ties::FIRST_A`]).
    ///
    /// # Errors
    /// [`OracleError::Inconsistent`] if it is not.
    pub fn region(&self, inside: fn(&[i32; 1]) -> bool) -> Result<ExactRegion<Q>, OracleError> {
        let [edges] = boundaries(&self.curves, [self.base], [inside], Budget::NONE)?;
        ExactRegion::from_edges(edges, inside(&[self.base]))
    }
}

/// The loops of a component that take part.
fn rings<'a, Q: Number>(part: &'a Part<Q>, other: &'a Part<Q>, holes: Holes) -> Vec<&'a Ring<Q>> {
    match holes {
        Holes::All => part.outer.iter().chain(&part.holes).collect(),
        Holes::Fitting => part.rings_against(other).collect(),
    }
}

/// The Euler characteristic of a bounded component with these loops.
fn characteristic<Q>(rings: &[&Ring<Q>]) -> i32 {
    2 - rings.len() as i32
}

/// How many components a region has, and how many holes. Loops that touch count as separate.
#[must_use]
pub fn topology<Q: Number>(region: &ExactRegion<Q>) -> [i32; 2] {
    let (loops, holes) = (region.loops().len() as i32, region.holes() as i32);
    [loops - holes + i32::from(region.unbounded()), holes]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plain::{Bend, Corner, PlainRegion};
    use rug::Rational;

    fn square(side: f64) -> Vec<Corner> {
        let corners = [(-side, -side), (side, -side), (side, side), (-side, side)];
        corners.map(|(x, y)| Corner { x, y, bend: Bend::Line }).to_vec()
    }

    fn region(loops: Vec<Vec<Corner>>) -> ExactRegion<Rational> {
        ExactRegion::from_plain(&PlainRegion { loops, unbounded: false }).expect("finite")
    }

    fn winding(a: &ExactRegion<Rational>, b: &ExactRegion<Rational>, holes: Holes, ties: Ties) -> Option<i32> {
        let kinetic = Kinetic::new(a, b, holes, ties).expect("finite").expect("no plane");
        let origin = Point::from_f64(0.0625, 0.03125).expect("finite");
        kinetic.locator().expect("finite").winding(&Place::from(origin))
    }

    #[test]
    fn a_covered_hole_counts_unless_it_is_filled() {
        let mut hole = square(1.0);
        hole.reverse();
        let (ring, plate, pin) =
            (region(vec![square(3.0), hole]), region(vec![square(2.0)]), region(vec![square(0.5)]));
        assert_eq!(winding(&ring, &plate, Holes::All, Ties::FIRST_A), Some(0));
        assert_eq!(winding(&ring, &plate, Holes::Fitting, Ties::FIRST_A), Some(1));
        assert_eq!(winding(&ring, &pin, Holes::Fitting, Ties::FIRST_A), Some(0));
        assert_eq!(topology(&ring), [1, 1]);
        // The complement of the ring, far away and in its hole.
        let outside = ring.complement().expect("finite");
        assert_eq!(topology(&outside), [2, 1]);
        assert_eq!(winding(&outside, &pin, Holes::All, Ties::FIRST_A), Some(1));
    }

    #[test]
    fn without_ties_parallel_edges_count_twice() {
        let (a, b) = (region(vec![square(3.0)]), region(vec![square(2.0)]));
        assert_eq!(winding(&a, &b, Holes::All, Ties::FIRST_A), Some(1));
        assert_eq!(winding(&a, &b, Holes::All, Ties::BOTH), Some(2));
    }

    #[test]
    fn its_region_is_the_sum() {
        let (a, b) = (region(vec![square(3.0)]), region(vec![square(2.0)]));
        let kinetic = Kinetic::new(&a, &b, Holes::Fitting, Ties::FIRST_A).expect("finite").expect("no plane");
        assert_eq!(kinetic.region(|w| w[0] > 0).expect("closed"), region(vec![square(5.0)]));
        assert_eq!((kinetic.forward().len(), kinetic.backward().len()), (8, 0));
    }
}

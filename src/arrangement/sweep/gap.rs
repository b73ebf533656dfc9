//! Gaps between neighbours in the status: the faces they belong to and the trapezoids they leave behind (memo C3).

use super::{Sweep, add};
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::status::{DOWN, NOWHERE, Place, UP};
use crate::arrangement::trapezoid::Trapezoid;

impl<M: CrossingModule> Sweep<'_, M> {
    /// Gives the gaps of a block their faces and asserts the winding numbers above it.
    pub(super) fn fill_gaps(&mut self, places: &[Place], under: u32, over: u32) {
        let Some((&top, inner)) = places.split_last() else {
            self.faces.join(under, over);
            return;
        };
        let mut winding = self.faces.winding(under);
        for &place in inner {
            winding = add(winding, self.weight_at(place));
            self.gap[place as usize] = self.faces.add(winding);
        }
        self.gap[top as usize] = over;
        self.faces.expect(over, add(winding, self.weight_at(top)));
    }

    fn weight_at(&self, place: Place) -> [i32; 2] {
        self.curves[self.status.curve(place) as usize].weight
    }

    /// The face below a place.
    pub(super) fn face_below(&self, place: Place) -> u32 {
        let below = self.status.near(place, DOWN);
        if below == NOWHERE { 0 } else { self.gap[below as usize] }
    }

    /// Begins an edge of the curve at a place, and the trapezoid above it.
    pub(super) fn open_edge(&mut self, place: Place) {
        let (below, above) = (self.face_below(place), self.gap[place as usize]);
        let curve = self.status.curve(place);
        self.edge_of[curve as usize] = self.graph.open(curve, below, above);
        self.since_now(place);
    }

    /// Begins the trapezoid above a place.
    pub(super) fn since_now(&mut self, place: Place) {
        if place != NOWHERE {
            self.since[place as usize] = self.now.x;
        }
    }

    /// Ends the trapezoid above a place.
    pub(super) fn close_gap(&mut self, place: Place) {
        if place == NOWHERE {
            return;
        }
        let (top, from) = (self.status.near(place, UP), self.since[place as usize]);
        if top != NOWHERE && from < self.now.x {
            self.trapezoids.push(Trapezoid {
                face: self.gap[place as usize],
                from,
                to: self.now.x,
                bottom: self.status.curve(place),
                top: self.status.curve(top),
            });
        }
    }
}

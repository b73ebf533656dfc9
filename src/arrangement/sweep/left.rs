//! What a sweep without gathering does with curves that end at a vertex but lie beyond strangers: each is taken out where it
//! is (MS 8.3). The faces on its two sides become one, whatever their winding numbers: a conflict, and counted as such.

use super::Sweep;
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::status::{DOWN, NOWHERE, Place};
use crate::robustness::Step;

impl<M: CrossingModule> Sweep<'_, M> {
    /// The places of ending curves that are not in the block; none when they have been gathered.
    pub(super) fn left_out(&self, ending: &[u32], block: &[Place]) -> Vec<Place> {
        if self.robustness.takes(Step::Gather) || ending.len() == block.len() {
            return Vec::new();
        }
        ending.iter().map(|curve| self.status.place(*curve)).filter(|place| !block.contains(place)).collect()
    }

    /// The places below those left out, which get new neighbours above.
    pub(super) fn neighbours_of(&self, left: &[Place]) -> Vec<Place> {
        left.iter().map(|place| self.status.near(*place, DOWN)).filter(|below| !left.contains(below)).collect()
    }

    /// Ends the curves left out at the current vertex.
    pub(super) fn take_out(&mut self, left: &[Place]) {
        for &place in left {
            let below = self.status.near(place, DOWN);
            self.close_gap(below);
            self.close_gap(place);
            self.graph.close(self.edge_of[self.status.curve(place) as usize]);
            self.faces.join(self.face_below(place), self.gap[place as usize]);
            self.status.remove(place);
            self.since_now(below);
            self.audit.left += 1;
        }
    }

    /// Whether some curve holds the place.
    pub(super) fn is_held(&self, place: Place) -> bool {
        place != NOWHERE && self.status.place(self.status.curve(place)) == place
    }
}

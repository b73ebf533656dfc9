//! What a sweep without gathering does with curves that end at a vertex but lie beyond strangers: each is taken out where it
//! is (MS 8.3). The faces on its two sides become one, whatever their winding numbers: a conflict, and counted as such.

use super::Sweep;
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::status::{DOWN, NOWHERE, Place};

impl<M: CrossingModule> Sweep<'_, M> {
    /// Ends those curves at the current vertex that are still active, and makes neighbours of those around them.
    pub(super) fn take_out(&mut self, ending: &[u32]) {
        for &curve in ending {
            let place = self.status.place(curve);
            if place != NOWHERE {
                self.work.push(self.status.near(place, DOWN));
                self.take_out_at(place);
                self.audit.apart += 1;
            }
        }
        let status = &self.status;
        self.work.retain(|place| *place != NOWHERE && status.place(status.curve(*place)) == *place);
        self.restore();
    }

    fn take_out_at(&mut self, place: Place) {
        let below = self.status.near(place, DOWN);
        self.close_gap(below);
        self.close_gap(place);
        self.graph.close(self.edge_of[self.status.curve(place) as usize]);
        self.faces.join(self.face_below(place), self.gap[place as usize]);
        self.status.remove(place);
        self.since_now(below);
    }
}

//! Swaps of neighbours: each is a vertex of the planar map (memo C2).

use super::{Sweep, add};
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::status::{DOWN, Place};
use glam::DVec2;

impl<M: CrossingModule> Sweep<'_, M> {
    /// Exchanges two neighbours at a new vertex: where they cross, or else where both are near the current point.
    pub(super) fn swap(&mut self, lower: Place, upper: Place, at: Option<DVec2>) {
        let below = self.status.near(lower, DOWN);
        for place in [below, lower, upper] {
            self.close_gap(place);
        }
        let (f, g) = (self.status.curve(lower), self.status.curve(upper));
        if !self.refused.is_empty() {
            self.refused.remove(&[f, g]);
        }
        self.graph.begin_vertex(at.unwrap_or_else(|| self.near_both(f, g)));
        self.graph.close(self.edge_of[g as usize]);
        self.graph.close(self.edge_of[f as usize]);
        self.status.exchange(lower, upper);
        let under = self.face_below(lower);
        let winding = add(self.faces.winding(under), self.curves[g as usize].weight);
        self.gap[lower as usize] = self.faces.add(winding);
        self.open_edge(lower);
        self.open_edge(upper);
        self.since_now(below);
    }

    /// The current abscissa, and the ordinate nearest to the current one where two curves meet or are closest there, up to
    /// rounding of x. Among curves that rise by much within a few units in the last place of x, neighbours in the status may
    /// be far from an event in y.
    fn near_both(&self, f: u32, g: u32) -> DVec2 {
        let (f, g) = (self.heights_now(f), self.heights_now(g));
        let (p, q) = (f.0.max(g.0), f.1.min(g.1));
        DVec2::new(self.now.x, self.now.y.clamp(p.min(q), p.max(q)))
    }

    /// The ordinates of a curve at the current abscissa up to rounding.
    fn heights_now(&self, curve: u32) -> (f64, f64) {
        let curve = &self.curves[curve as usize];
        if curve.is_vertical() {
            return curve.y_range();
        }
        let tolerance = self.module.tolerance();
        let [p, q] = [-tolerance, tolerance].map(|d| curve.y_at((self.now.x + d).clamp(curve.left.x, curve.right.x)));
        (p.min(q), p.max(q))
    }
}

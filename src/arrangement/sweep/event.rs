//! Crossing events: what the sweep has queued, and how neighbours are kept in the order of the crossing module (memo C2).

use super::Sweep;
use crate::arrangement::cross::{CrossingModule, Crossings};
use crate::arrangement::curve::compare;
use crate::arrangement::moment::Moment;
use crate::arrangement::status::{DOWN, NOWHERE, Place, UP};
use crate::robustness::Step;
use glam::DVec2;
use std::cmp::{Ordering, Reverse};

/// A crossing to come, of two curves that were neighbours in this order when it was queued.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Event {
    pub(super) moment: Moment,
    lower: u32,
    upper: u32,
    /// Whether they may have to stay as they are: the module is asked again when the time comes.
    asks: bool,
    /// Whether the moment is where they cross, too. Moved into the time when both are active it need not be: on steep curves the
    /// place may then be far in y.
    in_place: bool,
}

impl Eq for Event {}

impl PartialOrd for Event {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Event {
    fn cmp(&self, other: &Self) -> Ordering {
        self.moment.compare(&other.moment).then(self.lower.cmp(&other.lower)).then(self.upper.cmp(&other.upper))
    }
}

impl<M: CrossingModule> Sweep<'_, M> {
    /// A crossing event, with the next vertex.
    pub(super) fn cross(&mut self, event: Event, next_vertex: DVec2) {
        let (lower, upper) = (self.status.place(event.lower), self.status.place(event.upper));
        let adjacent = lower != NOWHERE && upper != NOWHERE && self.status.near(lower, UP) == upper;
        if !adjacent {
            self.audit.stale += 1;
            return;
        }
        let Moment { at, low } = event.moment;
        (self.now, self.low) = (at, low);
        if at == next_vertex && self.passes(event.lower) && self.passes(event.upper) {
            self.joined.extend([event.lower, event.upper]);
            return;
        }
        // The upper one is about to go below.
        let asks = event.asks || !self.agrees(false, event.lower, event.upper);
        if self.robustness.takes(Step::LateSwaps) && asks && self.settled(lower).is_ok() {
            self.audit.stale += 1;
            return;
        }
        self.audit.crossings += 1;
        self.swap(lower, upper, event.in_place.then_some(at));
        self.work.extend([self.status.near(lower, DOWN), upper]);
        // Lines do not cross again.
        if asks || ![event.lower, event.upper].iter().all(|curve| self.curves[*curve as usize].is_line()) {
            self.work.push(lower);
        }
        self.restore();
    }

    /// Whether a curve is a line through the current point.
    pub(super) fn passes(&self, curve: u32) -> bool {
        let curve = &self.curves[curve as usize];
        curve.is_line() && self.robustness.takes(Step::Cuts) && curve.side(self.now) == 0.0
    }

    /// What the module says about two curves, whichever comes first.
    pub(super) fn crossings(&self, f: u32, g: u32) -> Crossings {
        let (first, second) = (&self.curves[f.min(g) as usize], &self.curves[f.max(g) as usize]);
        let answer = self.module.cross(first, second);
        if f < g { answer } else { answer.exchanged() }
    }

    /// Whether the curve at a place and the one above it agree with the module just after the current event. If so, their
    /// next crossing is queued; if not, the answer is where they cross, if that is now.
    fn settled(&mut self, lower: Place) -> Result<(), Option<DVec2>> {
        let upper = self.status.near(lower, UP);
        if upper == NOWHERE {
            return Ok(());
        }
        let (f, g) = (self.status.curve(lower), self.status.curve(upper));
        let answer = self.crossings(f, g);
        let (mut below, mut place) = (answer.below, None);
        let now = Moment { at: self.now, low: self.low };
        for (i, &crossing) in answer.points().iter().enumerate() {
            let moment = self.while_active(crossing, f, g);
            if moment.compare(&now).is_gt() {
                if below {
                    // Both crossings at one moment leave the order as it is.
                    let again = answer.points().get(i + 1).map(|next| self.while_active(*next, f, g));
                    let asks = again.is_some_and(|next| next.compare(&moment).is_le());
                    let in_place = moment == crossing;
                    self.queue.push(Reverse(Event { moment, lower: f, upper: g, asks, in_place }));
                    self.audit.queued += 1;
                }
                break;
            }
            below = !below;
            // On steep curves the place may be far in y though it is late by no more than a rounding of x.
            let place_now = moment == crossing && (moment.at.x - now.at.x).abs() <= self.module.tolerance();
            place = place_now.then_some(moment.at);
        }
        let ordered = if below { Ok(()) } else { Err(place) };
        if self.agrees(below, f, g) { ordered } else { self.settled_by_knowledge(below, ordered, f, g) }
    }

    /// The same where knowledge may say something else than geometry.
    fn settled_by_knowledge(
        &mut self,
        below: bool,
        ordered: Result<(), Option<DVec2>>,
        f: u32,
        g: u32,
    ) -> Result<(), Option<DVec2>> {
        let known = self.known(f, g);
        // As long as geometry says what knowledge can only confirm, the next crossing is soon enough to ask again.
        if known.until.is_finite() && known.only != Some(below) {
            let curve = &self.curves[f as usize];
            let at = DVec2::new(known.until, curve.y_at(known.until.min(curve.end.x)));
            let moment = Moment::from(at);
            self.queue.push(Reverse(Event { moment, lower: f, upper: g, asks: true, in_place: true }));
        }
        match self.overruled(known, below, f, g) {
            Some(true) => {
                self.audit.cancelled += usize::from(self.refused.insert([f, g]));
                Ok(())
            }
            Some(false) => Err(None),
            None => ordered,
        }
    }

    /// The moment of a crossing, moved into the time when both curves are active.
    fn while_active(&self, crossing: Moment, f: u32, g: u32) -> Moment {
        let (f, g) = (&self.curves[f as usize], &self.curves[g as usize]);
        let x = crossing.at.x;
        if f.start.x.max(g.start.x) < x && x < f.end.x.min(g.end.x) {
            return crossing;
        }
        let start = if compare(f.start, g.start).is_ge() { f.start } else { g.start };
        let end = if compare(f.end, g.end).is_le() { f.end } else { g.end };
        crossing.max(Moment::from(start)).min(Moment::from(end))
    }

    /// Swaps neighbours until all agree with the module again, beginning with those at the places to be looked at.
    pub(super) fn restore(&mut self) {
        while let Some(lower) = self.work.pop() {
            if lower == NOWHERE {
                continue;
            }
            let Err(at) = self.settled(lower) else { continue };
            if !self.robustness.takes(Step::LateSwaps) {
                continue;
            }
            let upper = self.status.near(lower, UP);
            self.audit.late += 1;
            self.swap(lower, upper, at);
            self.work.extend([self.status.near(lower, DOWN), lower, upper]);
        }
    }
}

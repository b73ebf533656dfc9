//! Strangers: active curves between those that end at a vertex, which are swapped out first (memo C2).

use super::Sweep;
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::status::{DOWN, NOWHERE, Place, UP};
use crate::robustness::Step;

impl<M: CrossingModule> Sweep<'_, M> {
    /// Brings the places of the ending curves together by swapping strangers out towards the nearer side. Lines among the
    /// strangers that pass through the point are no strangers: they end here, too, or an exact meeting of several would come
    /// out as several vertices. Returns the places around all that was touched.
    pub(super) fn gather(&mut self, ending: &mut Vec<u32>) -> [Place; 2] {
        if ending.len() == 1 || !self.robustness.takes(Step::Gather) {
            let any = self.status.place(ending[0]);
            return [DOWN, UP].map(|side| self.status.near(any, side));
        }
        for curve in ending.iter() {
            self.is_ending[*curve as usize] = true;
        }
        let range = self.range_of(ending);
        for curve in range.iter().map(|place| self.status.curve(*place)) {
            if !self.is_ending[curve as usize] && self.passes(curve) {
                self.is_ending[curve as usize] = true;
                ending.push(curve);
            }
        }
        let around = [self.status.near(range[0], DOWN), self.status.near(range[range.len() - 1], UP)];
        if range.len() > ending.len() {
            self.swap_strangers_out(&range, ending.len());
        }
        for curve in ending {
            self.is_ending[*curve as usize] = false;
        }
        around
    }

    /// The places from the lowest to the highest ending curve.
    fn range_of(&self, ending: &[u32]) -> Vec<Place> {
        let middle = self.status.place(ending[0]);
        let mut found = 1;
        let mut reach = [vec![], vec![]];
        let mut ends = [middle; 2];
        while found < ending.len() {
            for side in [DOWN, UP] {
                if ends[side] != NOWHERE {
                    ends[side] = self.status.near(ends[side], side);
                }
                if ends[side] != NOWHERE {
                    reach[side].push(ends[side]);
                    found += usize::from(self.is_ending_at(ends[side]));
                }
            }
        }
        for places in &mut reach {
            while places.last().is_some_and(|p| !self.is_ending_at(*p)) {
                places.pop();
            }
        }
        let [down, up] = reach;
        down.into_iter().rev().chain([middle]).chain(up).collect()
    }

    fn is_ending_at(&self, place: Place) -> bool {
        self.is_ending[self.status.curve(place) as usize]
    }

    fn swap_strangers_out(&mut self, range: &[Place], ending: usize) {
        let (mut bottom, mut top) = (0, range.len());
        let mut passed = 0;
        for i in 0..range.len() {
            if self.is_ending_at(range[i]) {
                passed += 1;
            } else if 2 * passed <= ending {
                for j in (bottom..i).rev() {
                    self.gather_swap(range[j], range[j + 1]);
                }
                bottom += 1;
            }
        }
        for i in (bottom..range.len()).rev() {
            if !self.is_ending_at(range[i]) {
                for j in i + 1..top {
                    self.gather_swap(range[j - 1], range[j]);
                }
                top -= 1;
            }
        }
    }

    /// Moves the ending curves, which are together, to where those that start at the vertex are known to belong, as if these
    /// were put in one by one (MS 7.1). Returns the places around all that was touched.
    pub(super) fn move_into_order(
        &mut self,
        ending: &mut Vec<u32>,
        starting: &[u32],
        around: [Place; 2],
    ) -> [Place; 2] {
        if !self.robustness.takes(Step::Gather) {
            return around;
        }
        match self.stray(ending, starting) {
            [NOWHERE, NOWHERE] => around,
            [below, NOWHERE] => self.move_beyond(ending, below, UP, around),
            [NOWHERE, above] => self.move_beyond(ending, above, DOWN, around),
            _ => around,
        }
    }

    /// The highest curve above those that end here that is known to be below one that starts here, and the lowest one below
    /// them that is known to be above one. A line cut here is no such curve: it is taken out and goes on among those that start.
    fn stray(&mut self, ending: &[u32], starting: &[u32]) -> [Place; 2] {
        let block = self.status.place(ending[0]);
        let mut related = std::mem::take(&mut self.related);
        let mut stray = [NOWHERE; 2];
        for &new in starting {
            self.active_related(new, &mut related);
            for &place in &related {
                let curve = self.status.curve(place);
                let side = self.status.compare(place, block);
                if side.is_eq() || ending.contains(&curve) || !self.is_placed(side.is_gt(), curve, new) {
                    continue;
                }
                let found = &mut stray[if side.is_gt() { DOWN } else { UP }];
                if *found == NOWHERE || self.status.compare(*found, place) == side.reverse() {
                    *found = place;
                }
            }
        }
        self.related = related;
        stray
    }

    /// Moves the ending curves up, or down, beyond the curve at a place. Lines on the way that pass through the point end
    /// here, too.
    fn move_beyond(&mut self, ending: &mut Vec<u32>, bound: Place, side: usize, mut around: [Place; 2]) -> [Place; 2] {
        around[side] = self.status.near(bound, side);
        let mut block: Vec<Place> = ending.iter().map(|curve| self.status.place(*curve)).collect();
        block.sort_unstable_by(|p, q| self.status.compare(*p, *q));
        if side == DOWN {
            block.reverse();
        }
        while let next = self.status.near(block[block.len() - 1], side)
            && next != around[side]
        {
            let curve = self.status.curve(next);
            block.push(next);
            if self.passes(curve) {
                ending.push(curve);
                continue;
            }
            for pair in block.windows(2).rev() {
                let [lower, upper] = if side == UP { [pair[0], pair[1]] } else { [pair[1], pair[0]] };
                self.gather_swap(lower, upper);
            }
            block.remove(0);
        }
        around
    }

    fn gather_swap(&mut self, lower: Place, upper: Place) {
        self.audit.gather += 1;
        let (f, g) = (self.status.curve(lower), self.status.curve(upper));
        let conflicts = self.known(f, g).below == Some(true) && self.is_borne_out(true, f, g);
        self.audit.order_conflict += usize::from(conflicts);
        self.swap(lower, upper, None);
    }
}

//! Vertices: the curves that end there are taken out as one block of places, and those that start there put in, sorted by
//! direction (memo C2).

use super::Sweep;
use crate::arrangement::cross::CrossingModule;
use crate::arrangement::curve::{by_normal_at_start, order_at_start};
use crate::arrangement::status::{DOWN, NOWHERE, Place, UP};
use std::cmp::Ordering;

/// What a vertex works on. The lists are kept from vertex to vertex so that they need not grow again.
#[derive(Clone, Debug, Default)]
pub(super) struct Block {
    /// The curves that start there.
    starting: Vec<u32>,
    /// The curves that end there.
    ending: Vec<u32>,
    /// The places that the block takes, from bottom to top.
    places: Vec<Place>,
}

impl<M: CrossingModule> Sweep<'_, M> {
    /// A vertex, at the current point.
    pub(super) fn vertex(&mut self, vertex: u32) {
        let mut block = std::mem::take(&mut self.block);
        let Block { starting, ending, .. } = &mut block;
        self.vertices.starting(vertex, starting);
        self.vertices.ending(vertex, ending);
        ending.append(&mut self.joined);
        ending.retain(|c| self.status.place(*c) != NOWHERE);
        ending.sort_unstable();
        ending.dedup();
        if !starting.is_empty() || !ending.is_empty() {
            self.exchange(vertex, &mut block);
        }
        self.block = block;
    }

    /// Takes out what ends at the vertex and puts in what starts there.
    fn exchange(&mut self, vertex: u32, block: &mut Block) {
        let Block { starting, ending, places } = block;
        self.sort_by_direction(starting);
        let mut around = if ending.is_empty() {
            let (around, hit) = self.locate(starting);
            ending.extend(hit.map(|place| self.status.curve(place)));
            around
        } else {
            let around = self.gather(ending);
            self.move_into_order(ending, starting, around)
        };
        let below = self.absorb(&mut around, ending, places);
        let apart = places.len() < ending.len();
        let known = starting.len();
        self.cut(ending, vertex, starting);
        if starting.len() > known {
            self.sort_by_direction(starting);
        }
        self.merge(starting);
        self.replace(places, below, starting);
        if apart {
            self.take_out(ending);
        }
        self.restore_between(around);
    }

    /// Sorts curves that start at the current vertex upwards; ties by index.
    fn sort_by_direction(&self, starting: &mut [u32]) {
        if starting.len() < 2 {
            return;
        }
        let lines = starting.iter().all(|c| self.curves[*c as usize].is_line());
        let order = if lines { order_at_start } else { by_normal_at_start };
        starting.sort_unstable_by(|f, g| order(&self.curves[*f as usize], &self.curves[*g as usize]).then(f.cmp(g)));
        self.sort_by_knowledge(starting);
    }

    /// Moves curves below those that they are known to be below.
    fn sort_by_knowledge(&self, starting: &mut [u32]) {
        for i in 1..starting.len() {
            let lowest = (0..i).find(|&j| self.placed(starting[j], starting[i]) == Some(false));
            if let Some(lowest) = lowest {
                starting[lowest..=i].rotate_right(1);
            }
        }
    }

    /// Where the current point lies in the status when nothing ends there: the places around it, and the line it hits. What is
    /// known about the order of the new curves goes before distances (MS 7.1).
    fn locate(&mut self, starting: &[u32]) -> ([Place; 2], Option<Place>) {
        let tolerance = self.module.tolerance();
        let bounds = self.bounds(starting);
        self.status.search(|curve| {
            if let Some(outside) = self.outside(curve, bounds) {
                return outside;
            }
            let distance = self.module.above(self.now, &self.curves[curve as usize]);
            if distance == 0.0 && self.passes(curve) {
                return Ordering::Equal;
            }
            if distance.abs() <= tolerance {
                // Too close to tell: go where the new curves go, if they agree.
                let lowest = self.crossings(curve, starting[0]).below;
                let highest = self.crossings(curve, starting[starting.len() - 1]).below;
                if lowest == highest {
                    return if lowest { Ordering::Greater } else { Ordering::Less };
                }
            }
            if distance >= 0.0 { Ordering::Greater } else { Ordering::Less }
        })
    }

    /// The highest active curve that is known to be below some curve that starts here, and the lowest one above.
    fn bounds(&mut self, starting: &[u32]) -> [Place; 2] {
        let mut related = std::mem::take(&mut self.related);
        let mut bounds = [NOWHERE; 2];
        for &new in starting {
            self.active_related(new, &mut related);
            for &place in &related {
                let Some(below) = self.placed(self.status.curve(place), new) else { continue };
                let (side, further) = if below { (DOWN, Ordering::Less) } else { (UP, Ordering::Greater) };
                if bounds[side] == NOWHERE || self.status.compare(bounds[side], place) == further {
                    bounds[side] = place;
                }
            }
        }
        self.related = related;
        bounds
    }

    /// The places of the active curves about whose order with one that starts here something may be known.
    pub(super) fn active_related(&self, new: u32, found: &mut Vec<Place>) {
        found.clear();
        self.related_pieces(new, found);
        // As there are those that other pieces were merged into, a piece may have several curves, of which one is active.
        if self.guises.is_empty() {
            found.iter_mut().for_each(|piece| *piece = self.status.place(self.curve_of[*piece as usize]));
        } else {
            let curves: Vec<u32> = found.iter().flat_map(|piece| self.curves_of(*piece)).collect();
            found.clear();
            found.extend(curves.into_iter().map(|curve| self.status.place(curve)));
        }
        found.retain(|place| *place != NOWHERE);
    }

    /// On which side of a curve new ones go if it is not strictly between the bounds.
    fn outside(&self, curve: u32, bounds: [Place; 2]) -> Option<Ordering> {
        let place = self.status.place(curve);
        let [low, high] = bounds;
        if low != NOWHERE && self.status.compare(place, low).is_le() {
            return Some(Ordering::Greater);
        }
        (high != NOWHERE && self.status.compare(place, high).is_ge()).then_some(Ordering::Less)
    }

    /// Finds the places of the block, the lines next to it that pass through the point included, which end there, too. Moves
    /// `around` out of it. Returns the place below.
    fn absorb(&self, around: &mut [Place; 2], ending: &mut Vec<u32>, places: &mut Vec<Place>) -> Place {
        places.clear();
        let Some(&any) = ending.first() else { return around[DOWN] };
        places.push(self.status.place(any));
        for side in [UP, DOWN] {
            places.reverse();
            while let next = self.status.near(places[places.len() - 1], side)
                && next != NOWHERE
                && self.joins(next, ending)
            {
                places.push(next);
            }
        }
        places.reverse();
        for (side, end) in [(DOWN, places[0]), (UP, places[places.len() - 1])] {
            if places.contains(&around[side]) {
                around[side] = self.status.near(end, side);
            }
        }
        self.status.near(places[0], DOWN)
    }

    fn joins(&self, place: Place, ending: &mut Vec<u32>) -> bool {
        let curve = self.status.curve(place);
        if ending.contains(&curve) {
            return true;
        }
        let passes = self.passes(curve);
        if passes {
            ending.push(curve);
        }
        passes
    }

    /// Takes the block's curves out and puts the starting ones in, at a new vertex.
    fn replace(&mut self, places: &mut Vec<Place>, below: Place, starting: &[u32]) {
        if places.is_empty() && starting.is_empty() {
            return;
        }
        self.close_gap(below);
        self.graph.begin_vertex(self.now);
        for &place in places.iter().rev() {
            self.close_gap(place);
            self.graph.close(self.edge_of[self.status.curve(place) as usize]);
        }
        let under = if below == NOWHERE { 0 } else { self.gap[below as usize] };
        let over = places.last().map_or(under, |p| self.gap[*p as usize]);
        self.put(places, below, starting);
        self.fill_gaps(places, under, over);
        for &place in places.iter() {
            self.open_edge(place);
        }
        self.since_now(below);
        self.audit.longest_status = self.audit.longest_status.max(self.status.size());
    }

    /// Makes the block's places hold these curves, adding and removing places as needed.
    fn put(&mut self, places: &mut Vec<Place>, below: Place, starting: &[u32]) {
        for place in places.drain(starting.len().min(places.len())..) {
            self.status.remove(place);
        }
        for (place, curve) in places.iter().zip(starting) {
            self.status.replace(*place, *curve);
        }
        for curve in &starting[places.len()..] {
            let top = places.last().copied().unwrap_or(below);
            places.push(self.status.insert_above(top, *curve));
        }
        let size = places.iter().map(|p| *p as usize + 1).max().unwrap_or(0);
        if self.gap.len() < size {
            self.gap.resize(size, 0);
            self.since.resize(size, 0.0);
        }
    }

    /// Checks all neighbours strictly between two places, and those with them.
    fn restore_between(&mut self, around: [Place; 2]) {
        let mut place = if around[DOWN] == NOWHERE { self.status.extreme(DOWN) } else { around[DOWN] };
        while place != NOWHERE && place != around[UP] {
            self.work.push(place);
            place = self.status.near(place, UP);
        }
        self.restore();
    }
}

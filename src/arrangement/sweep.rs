//! The approximate arrangement sweep (MS reference 5; memo C2).
//!
//! Events come in lexicographic order; time never runs backwards. Neighbours in the status always agree with the crossing
//! module: a pair that does not is swapped on the spot (a late swap). A vertex is handled as one block: the curves that end
//! there are gathered, taken out, and replaced by those that start there, sorted by direction. At a fixed event a pair is
//! swapped at most once, because after the swap it agrees with the module, whose answer for a pair at an event is fixed;
//! hence the sweep ends for any module, honest or not.
//!
//! Lines that pass exactly through a vertex are cut there, and coinciding lines are merged with their net weight, so that
//! integer input gives the exact map.

use super::audit::Audit;
use super::cross::{CrossingModule, Crossings};
use super::curve::{Curve, by_normal_at_start, compare, order_at_start};
use super::faces::Faces;
use super::graph::Graph;
use super::moment::Moment;
use super::status::{DOWN, NOWHERE, Place, Status, UP};
use super::trapezoid::Trapezoid;
use super::vertices::Vertices;
use crate::piece::Pieces;
use glam::DVec2;
use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

/// A crossing to come, of two curves that were neighbours in this order when it was queued.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Event {
    moment: Moment,
    lower: u32,
    upper: u32,
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

/// The running sweep.
pub(super) struct Sweep<'m, M> {
    module: &'m M,
    curves: Vec<Curve>,
    vertices: Vertices,
    status: Status,
    queue: BinaryHeap<Reverse<Event>>,
    /// Where the sweep is.
    now: DVec2,
    /// What rounding took from the abscissa of `now`.
    low: f64,
    /// Lines found to cross exactly at a vertex still to come.
    joined: Vec<u32>,
    /// Open edge of each active curve.
    edge_of: Vec<u32>,
    /// Face above each place.
    gap: Vec<u32>,
    /// Where the trapezoid above each place began.
    since: Vec<f64>,
    /// Curves ending at the vertex under way.
    is_ending: Vec<bool>,
    faces: Faces,
    graph: Graph,
    trapezoids: Vec<Trapezoid>,
    audit: Audit,
}

impl<'m, M: CrossingModule> Sweep<'m, M> {
    pub(super) fn new(pieces: &Pieces, module: &'m M) -> Self {
        let (vertices, curves) = Vertices::new(pieces);
        let audit = Audit { curves: curves.len(), ..Audit::default() };
        Self {
            module,
            edge_of: vec![u32::MAX; curves.len()],
            is_ending: vec![false; curves.len()],
            curves,
            vertices,
            status: Status::new(),
            queue: BinaryHeap::new(),
            now: DVec2::NEG_INFINITY,
            low: 0.0,
            joined: Vec::new(),
            gap: Vec::new(),
            since: Vec::new(),
            faces: Faces::new(pieces.base),
            graph: Graph::new(),
            trapezoids: Vec::new(),
            audit,
        }
    }

    pub(super) fn run(mut self) -> (Graph, Vec<Trapezoid>, Audit) {
        for vertex in 0..self.vertices.points.len() as u32 {
            let point = self.vertices.points[vertex as usize];
            while let Some(&Reverse(event)) = self.queue.peek()
                && event.moment.compare(&Moment::from(point)).is_le()
            {
                self.queue.pop();
                self.cross(event, point);
            }
            (self.now, self.low) = (point, 0.0);
            self.vertex(vertex);
        }
        self.audit.vertices = self.graph.points.len();
        let number = self.graph.finish(self.faces, self.curves);
        for trapezoid in &mut self.trapezoids {
            trapezoid.face = number[trapezoid.face as usize];
        }
        (self.graph, self.trapezoids, self.audit)
    }

    // ---- crossings ----

    /// A crossing event, with the next vertex.
    fn cross(&mut self, event: Event, next_vertex: DVec2) {
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
        if self.settled(lower).is_ok() {
            self.audit.stale += 1;
            return;
        }
        self.audit.crossings += 1;
        self.swap(lower, upper, Some(at));
        self.restore(vec![self.status.near(lower, DOWN), lower, upper]);
    }

    /// Whether a curve is a line through the current point.
    fn passes(&self, curve: u32) -> bool {
        let curve = &self.curves[curve as usize];
        curve.is_line() && curve.side(self.now) == 0.0
    }

    fn crossings(&self, f: u32, g: u32) -> Crossings {
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
        for &crossing in answer.points() {
            let moment = self.while_active(crossing, f, g);
            if moment.compare(&now).is_gt() {
                if below {
                    self.queue.push(Reverse(Event { moment, lower: f, upper: g }));
                    self.audit.queued += 1;
                }
                break;
            }
            below = !below;
            // On steep curves the place may be far in y though it is late by no more than a rounding of x.
            let place_now = (moment.at.x - now.at.x).abs() <= self.module.tolerance();
            place = place_now.then_some(moment.at);
        }
        if below { Ok(()) } else { Err(place) }
    }

    /// The moment of a crossing, moved into the time when both curves are active.
    fn while_active(&self, crossing: Moment, f: u32, g: u32) -> Moment {
        let (f, g) = (&self.curves[f as usize], &self.curves[g as usize]);
        let start = if compare(f.start, g.start).is_ge() { f.start } else { g.start };
        let end = if compare(f.right, g.right).is_le() { f.right } else { g.right };
        crossing.max(Moment::from(start)).min(Moment::from(end))
    }

    /// Swaps neighbours until all agree with the module again.
    fn restore(&mut self, mut work: Vec<Place>) {
        while let Some(lower) = work.pop() {
            if lower == NOWHERE {
                continue;
            }
            let Err(at) = self.settled(lower) else { continue };
            let upper = self.status.near(lower, UP);
            self.audit.late += 1;
            self.swap(lower, upper, at);
            work.extend([self.status.near(lower, DOWN), lower, upper]);
        }
    }

    /// Exchanges two neighbours at a new vertex: where they cross, or else where both are near the current point.
    fn swap(&mut self, lower: Place, upper: Place, at: Option<DVec2>) {
        let below = self.status.near(lower, DOWN);
        for place in [below, lower, upper] {
            self.close_gap(place);
        }
        let (f, g) = (self.status.curve(lower), self.status.curve(upper));
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

    // ---- vertices ----

    fn vertex(&mut self, vertex: u32) {
        let (mut starting, mut ending) = (Vec::new(), Vec::new());
        self.vertices.starting(vertex, &mut starting);
        self.vertices.ending(vertex, &mut ending);
        ending.append(&mut self.joined);
        ending.retain(|c| self.status.place(*c) != NOWHERE);
        ending.sort_unstable();
        ending.dedup();
        self.sort_by_direction(&mut starting);
        let mut around = if ending.is_empty() {
            if starting.is_empty() {
                return;
            }
            let (around, hit) = self.locate(&starting);
            ending.extend(hit.map(|place| self.status.curve(place)));
            around
        } else {
            self.gather(&mut ending)
        };
        let block = self.absorb(&mut around, &mut ending);
        self.cut(&ending, vertex, &mut starting);
        self.sort_by_direction(&mut starting);
        self.merge(&mut starting);
        self.replace(block, &starting);
        self.restore_between(around);
    }

    /// Sorts curves that start at the current vertex upwards; ties by index.
    fn sort_by_direction(&self, starting: &mut [u32]) {
        let lines = starting.iter().all(|c| self.curves[*c as usize].is_line());
        let order = if lines { order_at_start } else { by_normal_at_start };
        starting.sort_unstable_by(|f, g| order(&self.curves[*f as usize], &self.curves[*g as usize]).then(f.cmp(g)));
    }

    /// Where the current point lies in the status when nothing ends there: the places around it, and the line it hits.
    fn locate(&self, starting: &[u32]) -> ([Place; 2], Option<Place>) {
        let tolerance = self.module.tolerance();
        self.status.search(|curve| {
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

    /// Brings the places of the ending curves together by swapping strangers out towards the nearer side. Lines among the
    /// strangers that pass through the point are no strangers: they end here, too, or an exact meeting of several would come
    /// out as several vertices. Returns the places around all that was touched.
    fn gather(&mut self, ending: &mut Vec<u32>) -> [Place; 2] {
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

    fn gather_swap(&mut self, lower: Place, upper: Place) {
        self.audit.gather += 1;
        self.swap(lower, upper, None);
    }

    /// Adds the lines next to the block that pass through the point to those that end. Moves `around` out of the block.
    fn absorb(&self, around: &mut [Place; 2], ending: &mut Vec<u32>) -> Block {
        let Some(&any) = ending.first() else {
            return Block { places: Vec::new(), below: around[DOWN] };
        };
        let mut places = vec![self.status.place(any)];
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
        let below = self.status.near(places[0], DOWN);
        Block { places, below }
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

    /// Cuts the lines that go on beyond the vertex; their remainders start there.
    fn cut(&mut self, ending: &[u32], vertex: u32, starting: &mut Vec<u32>) {
        for &curve in ending {
            if self.curves[curve as usize].last != vertex {
                let rest = self.curves[curve as usize].from_vertex(vertex, self.now);
                starting.push(self.add_curve(rest));
                self.vertices.register_end(starting[starting.len() - 1], &rest);
                self.audit.cut += 1;
            }
        }
    }

    fn add_curve(&mut self, curve: Curve) -> u32 {
        self.curves.push(curve);
        self.edge_of.push(u32::MAX);
        self.is_ending.push(false);
        (self.curves.len() - 1) as u32
    }

    /// Merges neighbours among the starting curves that coincide into one of net weight. What cancels disappears.
    fn merge(&mut self, starting: &mut Vec<u32>) {
        let mut kept: Vec<u32> = Vec::with_capacity(starting.len());
        let mut rest = starting.as_slice();
        while let Some(&first) = rest.first() {
            let bundled = 1 + rest.windows(2).take_while(|pair| self.coincide(pair[0], pair[1])).count();
            let (bundle, others) = rest.split_at(bundled);
            rest = others;
            kept.extend(if bundled == 1 { Some(first) } else { self.merge_bundle(bundle) });
        }
        *starting = kept;
    }

    fn coincide(&self, f: u32, g: u32) -> bool {
        let (f, g) = (&self.curves[f as usize], &self.curves[g as usize]);
        if f.last == g.last {
            return f.delta == g.delta;
        }
        let (short, long) = if compare(f.right, g.right).is_lt() { (f, g) } else { (g, f) };
        short.is_line() && long.is_line() && short.is_vertical() == long.is_vertical() && long.side(short.right) == 0.0
    }

    /// Makes a chain of curves that coincide from the current vertex on: one piece from each of their ends to the next, with
    /// the weight of all that reach that far. Returns the first piece; the others start later. So a vertex never has to
    /// merge more than one curve for all that have been merged before.
    fn merge_bundle(&mut self, bundle: &[u32]) -> Option<u32> {
        let mut chain = bundle.to_vec();
        chain.sort_unstable_by(|f, g| compare(self.curves[*f as usize].right, self.curves[*g as usize].right));
        let mut weight = chain.iter().fold([0; 2], |sum, c| add(sum, self.curves[*c as usize].weight));
        let (mut vertex, mut start) = (self.curves[bundle[0] as usize].first, self.now);
        let mut first = None;
        for curve in chain {
            let Curve { last, right, weight: own, .. } = self.curves[curve as usize];
            self.audit.merged += 1;
            if last != vertex && weight != [0; 2] {
                let mut piece = self.curves[curve as usize].from_vertex(vertex, start);
                piece.weight = weight;
                self.curves[curve as usize] = piece;
                if start == self.now {
                    first = Some(curve);
                } else {
                    self.vertices.register_start(curve, &piece);
                }
            }
            weight = [weight[0] - own[0], weight[1] - own[1]];
            (vertex, start) = (last, right);
        }
        first
    }

    /// Takes the block's curves out and puts the starting ones in, at a new vertex.
    fn replace(&mut self, block: Block, starting: &[u32]) {
        let Block { mut places, below } = block;
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
        self.put(&mut places, below, starting);
        self.fill_gaps(&places, under, over);
        for &place in &places {
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

    /// Gives the gaps of a block their faces and asserts the winding numbers above it.
    fn fill_gaps(&mut self, places: &[Place], under: u32, over: u32) {
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

    /// Checks all neighbours strictly between two places, and those with them.
    fn restore_between(&mut self, around: [Place; 2]) {
        let mut work = Vec::new();
        let mut place = if around[DOWN] == NOWHERE { self.status.extreme(DOWN) } else { around[DOWN] };
        while place != NOWHERE && place != around[UP] {
            work.push(place);
            place = self.status.near(place, UP);
        }
        self.restore(work);
    }

    // ---- faces and trapezoids ----

    fn face_below(&self, place: Place) -> u32 {
        let below = self.status.near(place, DOWN);
        if below == NOWHERE { 0 } else { self.gap[below as usize] }
    }

    fn open_edge(&mut self, place: Place) {
        let (below, above) = (self.face_below(place), self.gap[place as usize]);
        let curve = self.status.curve(place);
        self.edge_of[curve as usize] = self.graph.open(curve, below, above);
        self.since_now(place);
    }

    fn since_now(&mut self, place: Place) {
        if place != NOWHERE {
            self.since[place as usize] = self.now.x;
        }
    }

    /// Ends the trapezoid above a place.
    fn close_gap(&mut self, place: Place) {
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

/// The places of a vertex block from bottom to top, and the place below it.
struct Block {
    places: Vec<Place>,
    below: Place,
}

fn add(v: [i32; 2], w: [i32; 2]) -> [i32; 2] {
    [v[0] + w[0], v[1] + w[1]]
}

//! The boundary of what closed curves wind around (memo D, I2), exactly and without an arrangement data structure.
//!
//! Each segment is walked from tail to head. The winding numbers just left of its start come from one ray; after that
//! they change only where another segment comes in from the left, and the difference between left and right changes
//! only where segments lie on top of each other. Along the way it is always known whether the segment separates inside
//! from outside, so no point is ever computed except the ends of boundary pieces. Coincident segments are reported once,
//! by the first of them.
//!
//! Several layers of curves keep separate winding numbers, so that a Boolean operation is a predicate on them.

use std::cell::OnceCell;
use std::cmp::Ordering;

use crate::boxes::{Boxes, Extent};
use crate::error::{Budget, OracleError};
use crate::interval::Interval;
use crate::number::Number;
use crate::point::{Place, Point, area_exact, area_interval, cross_sign, dot_sign, orient};
use crate::region::{ExactRegion, ring_edges};

/// A directed piece of boundary, the inside on its left.
pub type Edge<Q> = (Point<Q>, Point<Q>);

/// A directed segment between two places, of positive length.
#[derive(Clone, Copy, Debug)]
struct Segment {
    tail: usize,
    head: usize,
    layer: usize,
}

/// Closed curves in layers: every place is the head of as many segments of a layer as it is the tail of.
pub struct Curves<Q> {
    places: Vec<Place<Q>>,
    segments: Vec<Segment>,
}

impl<Q: Number> Default for Curves<Q> {
    fn default() -> Self {
        Self { places: Vec::new(), segments: Vec::new() }
    }
}

impl<Q: Number> Curves<Q> {
    /// Adds a place and returns its index.
    pub fn place(&mut self, point: Point<Q>) -> usize {
        self.places.push(Place::from(point));
        self.places.len() - 1
    }

    /// Adds a segment between two places given by their index; one of no length is left out.
    pub fn segment(&mut self, tail: usize, head: usize, layer: usize) {
        if self.places[tail].order(&self.places[head]) != Ordering::Equal {
            self.segments.push(Segment { tail, head, layer });
        }
    }

    /// Adds a closed polyline.
    pub fn ring(&mut self, ring: impl IntoIterator<Item = Point<Q>>, layer: usize) {
        let numbers: Vec<usize> = ring.into_iter().map(|point| self.place(point)).collect();
        ring_edges(&numbers).for_each(|(&tail, &head)| self.segment(tail, head, layer));
    }

    /// The boundaries of regions, one layer each.
    #[must_use]
    pub fn of_regions<const L: usize>(regions: [&ExactRegion<Q>; L]) -> Self {
        let mut curves = Self::default();
        for (layer, region) in regions.into_iter().enumerate() {
            region.loops().iter().for_each(|ring| curves.ring(ring.iter().cloned(), layer));
        }
        curves
    }

    /// The number of segments.
    #[must_use]
    pub fn len(&self) -> usize {
        self.segments.len()
    }

    /// Whether there are no segments.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.segments.is_empty()
    }
}

/// The boundaries of R regions: region k is where `inside[k]` holds for the winding numbers of the L layers, which far
/// away are `base`. Each boundary is a set of directed edges with the region on the left that meet only at ends, except
/// that an end may touch the inside of an edge.
///
/// # Errors
/// [`OracleError::TooCostly`] beyond the budget, [`OracleError::BadNumber`] for coordinates too large for doubles.
pub fn boundaries<Q: Number, const L: usize, const R: usize>(
    curves: &Curves<Q>,
    base: [i32; L],
    inside: [fn(&[i32; L]) -> bool; R],
    budget: Budget,
) -> Result<[Vec<Edge<Q>>; R], OracleError> {
    budget.check_segments(curves.len())?;
    let extents: Vec<Extent> = curves.segments.iter().filter_map(|s| curves.extent(s)).collect();
    let boxes = Boxes::new(&extents)?;
    let walker = Walker { curves, extents, boxes, base, inside };
    let mut edges = std::array::from_fn(|_| Vec::new());
    let mut meetings = 0;
    for s in 0..curves.len() {
        meetings += walker.walk(s, &mut edges);
        budget.check_meetings(meetings)?;
    }
    Ok(edges)
}

impl<Q: Number> Curves<Q> {
    fn extent(&self, s: &Segment) -> Option<Extent> {
        Extent::around([&self.places[s.tail], &self.places[s.head]])
    }
}

struct Walker<'a, Q, const L: usize, const R: usize> {
    curves: &'a Curves<Q>,
    extents: Vec<Extent>,
    boxes: Boxes,
    base: [i32; L],
    inside: [fn(&[i32; L]) -> bool; R],
}

/// Where on a segment something happens.
#[derive(Clone, Copy)]
enum Spot {
    Crossing { other: usize },
    Place { index: usize },
}

/// Something that happens at a spot strictly inside a segment.
struct Event<Q> {
    spot: Spot,
    /// Interval around the parameter, 0 at the tail and 1 at the head.
    near: Interval,
    exact: OnceCell<Q>,
    change: Change,
}

/// A change of what is known along a segment.
#[derive(Clone, Copy)]
struct Change {
    layer: usize,
    /// Added to the winding number on the left.
    left: i32,
    /// Added to the winding number on the left less that on the right.
    step: i32,
    /// Added to the number of earlier segments on top of this one.
    covers: i32,
}

/// What is known just after a spot.
struct State<const L: usize> {
    left: [i32; L],
    step: [i32; L],
    covers: i32,
}

impl<const L: usize> State<L> {
    fn apply(&mut self, change: Change) {
        self.left[change.layer] += change.left;
        self.step[change.layer] += change.step;
        self.covers += change.covers;
    }
}

/// A piece of boundary under way: where it began and whether it runs along the segment or against it.
struct Run<Q> {
    start: Point<Q>,
    forward: bool,
}

impl<Q: Number, const L: usize, const R: usize> Walker<'_, Q, L, R> {
    fn ends(&self, s: usize) -> (&Place<Q>, &Place<Q>) {
        let segment = &self.curves.segments[s];
        (&self.curves.places[segment.tail], &self.curves.places[segment.head])
    }

    /// Walks one segment and returns the number of segments it was compared with.
    fn walk(&self, s: usize, edges: &mut [Vec<Edge<Q>>; R]) -> u64 {
        let segment = &self.curves.segments[s];
        let mut state = State { left: [0; L], step: [0; L], covers: 0 };
        state.step[segment.layer] = 1;
        let mut events = Vec::new();
        let mut meetings = 0;
        self.boxes.visit(&self.extents[s], |r| {
            meetings += 1;
            if r != s {
                self.meet(s, r, &mut state, &mut events);
            }
        });
        state.left = self.winding_left_of_tail(s);
        events.sort_by(|a, b| self.compare(s, a, b));
        self.emit(s, state, &events, edges);
        meetings
    }

    /// Follows the events in order and emits the boundary pieces of each region.
    fn emit(&self, s: usize, mut state: State<L>, events: &[Event<Q>], edges: &mut [Vec<Edge<Q>>; R]) {
        let (tail, head) = self.ends(s);
        let mut runs: [Option<Run<Q>>; R] = std::array::from_fn(|_| None);
        self.switch(&state, &mut runs, edges, || tail.exact.clone());
        let mut k = 0;
        while k < events.len() {
            let here = &events[k];
            while k < events.len() && self.compare(s, here, &events[k]) == Ordering::Equal {
                state.apply(events[k].change);
                k += 1;
            }
            self.switch(&state, &mut runs, edges, || self.locate(s, here));
        }
        for (run, edges) in runs.into_iter().zip(edges) {
            edges.extend(run.map(|run| run.finish(head.exact.clone())));
        }
    }

    /// Ends and begins runs where the state asks for it.
    fn switch(
        &self,
        state: &State<L>,
        runs: &mut [Option<Run<Q>>; R],
        edges: &mut [Vec<Edge<Q>>; R],
        here: impl Fn() -> Point<Q>,
    ) {
        let right = std::array::from_fn(|layer| state.left[layer] - state.step[layer]);
        for ((run, inside), edges) in runs.iter_mut().zip(self.inside).zip(edges) {
            let forward = match (inside(&state.left), inside(&right)) {
                (true, false) if state.covers == 0 => Some(true),
                (false, true) if state.covers == 0 => Some(false),
                _ => None,
            };
            if forward == run.as_ref().map(|run| run.forward) {
                continue;
            }
            edges.extend(run.take().map(|run| run.finish(here())));
            *run = forward.map(|forward| Run { start: here(), forward });
        }
    }

    /// The winding numbers at a point q infinitesimally ahead of the tail of s and, by far less, to its left: a ray
    /// from q in the direction of +x.
    fn winding_left_of_tail(&self, s: usize) -> [i32; L] {
        let (tail, head) = self.ends(s);
        let q_above = match head.compare_y(tail) {
            Ordering::Equal => head.order(tail) == Ordering::Greater,
            climb => climb == Ordering::Greater,
        };
        let below = |p: &Place<Q>| match p.compare_y(tail) {
            Ordering::Equal => q_above,
            order => order == Ordering::Less,
        };
        let mut winding = self.base;
        let ray = Extent { ends: [tail.x.lo(), tail.y.lo(), f64::INFINITY, tail.y.hi()] };
        self.boxes.visit(&ray, |r| {
            let (from, to) = self.ends(r);
            let climbs = below(from);
            if climbs == below(to) {
                return;
            }
            if self.q_is_left_of(s, r, climbs) == climbs {
                winding[self.curves.segments[r].layer] += if climbs { 1 } else { -1 };
            }
        });
        winding
    }

    /// Whether the point q of [`Self::winding_left_of_tail`] is left of r, which climbs or falls past its height.
    fn q_is_left_of(&self, s: usize, r: usize, climbs: bool) -> bool {
        let ((tail, head), (from, to)) = (self.ends(s), self.ends(r));
        if self.extents[r].ends[0] > tail.x.hi() {
            return climbs;
        }
        orient(from, to, tail)
            .then_with(|| cross_sign(from, to, tail, head))
            .then_with(|| dot_sign(from, to, tail, head))
            .is_gt()
    }

    /// Notes what r does to the walk along s.
    fn meet(&self, s: usize, r: usize, state: &mut State<L>, events: &mut Vec<Event<Q>>) {
        let side_of_tail = self.side(s, self.curves.segments[r].tail);
        let side_of_head = self.side(s, self.curves.segments[r].head);
        let left = match (side_of_tail, side_of_head) {
            (Ordering::Equal, Ordering::Equal) => return self.overlap(s, r, state, events),
            (Ordering::Greater, Ordering::Greater) => return,
            // It comes in from the left, so that walking on one gets to its left side.
            (Ordering::Greater, _) => 1,
            (_, Ordering::Greater) => -1,
            _ => return,
        };
        let before = self.side(r, self.curves.segments[s].tail);
        let after = self.side(r, self.curves.segments[s].head);
        if before == after || before == Ordering::Equal || after == Ordering::Equal {
            return;
        }
        let ((a, b), (c, d)) = (self.ends(s), self.ends(r));
        let (from, to) = (area_interval(c, d, a), area_interval(c, d, b));
        let change = Change { layer: self.curves.segments[r].layer, left, step: 0, covers: 0 };
        events.push(Event {
            spot: Spot::Crossing { other: r },
            near: from / (from - to),
            exact: OnceCell::new(),
            change,
        });
    }

    /// The side of s on which a place lies.
    fn side(&self, s: usize, place: usize) -> Ordering {
        let segment = &self.curves.segments[s];
        if place == segment.tail || place == segment.head {
            return Ordering::Equal;
        }
        let (tail, head) = self.ends(s);
        orient(tail, head, &self.curves.places[place])
    }

    /// Notes what a segment r on the line of s does to the walk.
    fn overlap(&self, s: usize, r: usize, state: &mut State<L>, events: &mut Vec<Event<Q>>) {
        let ((tail, head), (from, to)) = (self.ends(s), self.ends(r));
        let segment = &self.curves.segments[r];
        let same = dot_sign(tail, head, from, to).is_gt();
        let (first, last) = if same { (segment.tail, segment.head) } else { (segment.head, segment.tail) };
        let beyond = |start: &Place<Q>, p: usize| dot_sign(start, &self.curves.places[p], tail, head);
        if beyond(tail, last).is_le() || beyond(head, first).is_ge() {
            return;
        }
        let on = Change { layer: segment.layer, left: 0, step: if same { 1 } else { -1 }, covers: i32::from(r < s) };
        let off = Change { step: -on.step, covers: -on.covers, ..on };
        if beyond(tail, first).is_gt() {
            events.push(self.event_at_place(s, first, on));
        } else {
            state.apply(on);
        }
        if beyond(head, last).is_lt() {
            events.push(self.event_at_place(s, last, off));
        }
    }

    fn event_at_place(&self, s: usize, index: usize, change: Change) -> Event<Q> {
        let (tail, head) = self.ends(s);
        let ((ux, uy), (vx, vy)) = (tail.step(head), tail.step(&self.curves.places[index]));
        let near = (ux * vx + uy * vy) / (ux.square() + uy.square());
        Event { spot: Spot::Place { index }, near, exact: OnceCell::new(), change }
    }

    fn compare(&self, s: usize, a: &Event<Q>, b: &Event<Q>) -> Ordering {
        if std::ptr::eq(a, b) {
            return Ordering::Equal;
        }
        a.near.compare(b.near).unwrap_or_else(|| self.parameter(s, a).cmp(self.parameter(s, b)))
    }

    /// The exact parameter of an event on s.
    fn parameter<'e>(&self, s: usize, event: &'e Event<Q>) -> &'e Q {
        event.exact.get_or_init(|| {
            let (a, b) = self.ends(s);
            match event.spot {
                Spot::Crossing { other } => {
                    let (c, d) = self.ends(other);
                    let from = area_exact(&c.exact, &d.exact, &a.exact);
                    let to = area_exact(&c.exact, &d.exact, &b.exact);
                    from.over(&from.minus(&to))
                }
                Spot::Place { index } => {
                    let run = b.exact.minus(&a.exact);
                    let part = self.curves.places[index].exact.minus(&a.exact);
                    part.dot(&run).over(&run.dot(&run))
                }
            }
        })
    }

    fn locate(&self, s: usize, event: &Event<Q>) -> Point<Q> {
        let (a, b) = self.ends(s);
        match event.spot {
            Spot::Crossing { .. } => a.exact.toward(&b.exact, self.parameter(s, event)),
            Spot::Place { index } => self.curves.places[index].exact.clone(),
        }
    }
}

impl<Q> Run<Q> {
    fn finish(self, end: Point<Q>) -> Edge<Q> {
        if self.forward { (self.start, end) } else { (end, self.start) }
    }
}

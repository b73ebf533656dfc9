//! A walk along a segment, or the part of it that may bound something ([`crate::arrange`]).

use std::cell::OnceCell;
use std::cmp::Ordering;

use crate::arrange::{Edge, Field};
use crate::interval::Interval;
use crate::number::Number;
use crate::point::{Place, Point, area_exact, area_interval, dot_sign};

/// A walk.
pub(crate) struct Walk<'a, Q, const L: usize> {
    field: &'a Field<'a, Q, L>,
    /// Position of the segment.
    index: usize,
    /// Numbers of the places where the walk begins and ends.
    ends: [usize; 2],
    tail: &'a Place<Q>,
    head: &'a Place<Q>,
}

/// Where on a walk something happens.
#[derive(Clone, Copy)]
enum Spot {
    Crossing { other: usize },
    Place { index: usize },
}

/// Something that happens at a spot strictly inside a walk.
struct Event<Q> {
    spot: Spot,
    /// Interval around the parameter, 0 at the tail and 1 at the head.
    near: Interval,
    exact: OnceCell<Q>,
    change: Change,
}

/// A change of what is known along a walk.
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

    /// Ends and begins runs where the state asks for it.
    fn switch<Q, const R: usize>(
        &self,
        inside: [fn(&[i32; L]) -> bool; R],
        runs: &mut [Option<Run<Q>>; R],
        edges: &mut [Vec<Edge<Q>>; R],
        here: impl Fn() -> Point<Q>,
    ) {
        let right = std::array::from_fn(|layer| self.left[layer] - self.step[layer]);
        for ((run, inside), edges) in runs.iter_mut().zip(inside).zip(edges) {
            let forward = match (inside(&self.left), inside(&right)) {
                (true, false) if self.covers == 0 => Some(true),
                (false, true) if self.covers == 0 => Some(false),
                _ => None,
            };
            if forward == run.as_ref().map(|run| run.forward) {
                continue;
            }
            edges.extend(run.take().map(|run| run.finish(here())));
            *run = forward.map(|forward| Run { start: here(), forward });
        }
    }
}

/// A piece of boundary under way: where it began and whether it runs along the segment or against it.
struct Run<Q> {
    start: Point<Q>,
    forward: bool,
}

impl<'a, Q: Number, const L: usize> Walk<'a, Q, L> {
    /// The walk along a segment between two places on it.
    pub(crate) fn new(field: &'a Field<'a, Q, L>, index: usize, ends: [usize; 2]) -> Self {
        let [tail, head] = ends.map(|number| field.place(number));
        Self { field, index, ends, tail, head }
    }

    /// Finds the pieces of boundary of each region on the way and returns the number of segments looked at.
    pub(crate) fn follow<const R: usize>(
        &self,
        inside: [fn(&[i32; L]) -> bool; R],
        edges: &mut [Vec<Edge<Q>>; R],
    ) -> u64 {
        let own = &self.field.segments[self.index];
        let (left, passed) = self.field.winding_left_of(self.tail, self.head);
        let mut state = State { left, step: [0; L], covers: 0 };
        state.step[own.layer] = own.weight;
        let mut events = Vec::new();
        let met = self.field.visit_near(self.ends, |other| {
            if other != self.index {
                self.meet(other, &mut state, &mut events);
            }
        });
        events.sort_by(|a, b| self.compare(a, b));
        self.emit(inside, state, &events, edges);
        passed + met
    }

    /// Follows the events in order and emits the boundary pieces of each region.
    fn emit<const R: usize>(
        &self,
        inside: [fn(&[i32; L]) -> bool; R],
        mut state: State<L>,
        events: &[Event<Q>],
        edges: &mut [Vec<Edge<Q>>; R],
    ) {
        let mut runs: [Option<Run<Q>>; R] = std::array::from_fn(|_| None);
        state.switch(inside, &mut runs, edges, || self.tail.exact.clone());
        let mut k = 0;
        while k < events.len() {
            let (here, first) = (&events[k], k);
            while k < events.len() && self.compare(here, &events[k]) == Ordering::Equal {
                state.apply(events[k].change);
                k += 1;
            }
            if k > first + 1 {
                // Other boundary may pass straight through here even if nothing changes for this walk.
                cut(&mut runs, edges, || self.locate(here));
            }
            state.switch(inside, &mut runs, edges, || self.locate(here));
        }
        for (run, edges) in runs.into_iter().zip(edges) {
            edges.extend(run.map(|run| run.finish(self.head.exact.clone())));
        }
    }

    /// Notes what another segment does to the walk.
    fn meet(&self, other: usize, state: &mut State<L>, events: &mut Vec<Event<Q>>) {
        let segment = &self.field.segments[other];
        let side = |place: usize| self.field.side(self.ends, place);
        let left = match (side(segment.tail), side(segment.head)) {
            (Ordering::Equal, Ordering::Equal) => return self.overlap(other, state, events),
            (Ordering::Greater, Ordering::Greater) => return,
            // It comes in from the left, so that walking on one gets to its left side.
            (Ordering::Greater, _) => segment.weight,
            (_, Ordering::Greater) => -segment.weight,
            _ => return,
        };
        let [before, after] = self.ends.map(|place| self.field.side([segment.tail, segment.head], place));
        if before == after || before == Ordering::Equal || after == Ordering::Equal {
            return;
        }
        let (c, d) = self.field.ends(other);
        let (from, to) = (area_interval(c, d, self.tail), area_interval(c, d, self.head));
        let change = Change { layer: segment.layer, left, step: 0, covers: 0 };
        events.push(Event { spot: Spot::Crossing { other }, near: from / (from - to), exact: OnceCell::new(), change });
    }

    /// Notes what another segment on the same line does to the walk.
    fn overlap(&self, other: usize, state: &mut State<L>, events: &mut Vec<Event<Q>>) {
        let ((tail, head), (from, to)) = ((self.tail, self.head), self.field.ends(other));
        let segment = &self.field.segments[other];
        let same = dot_sign(tail, head, from, to).is_gt();
        let (first, last) = if same { (segment.tail, segment.head) } else { (segment.head, segment.tail) };
        let beyond = |start: &Place<Q>, p: usize| dot_sign(start, self.field.place(p), tail, head);
        if beyond(tail, last).is_le() || beyond(head, first).is_ge() {
            return;
        }
        let step = if same { segment.weight } else { -segment.weight };
        let covers = i32::from(other < self.index && segment.exposed.is_some());
        let on = Change { layer: segment.layer, left: 0, step, covers };
        let off = Change { step: -on.step, covers: -on.covers, ..on };
        if beyond(tail, first).is_gt() {
            events.push(self.event_at_place(first, on));
        } else {
            state.apply(on);
        }
        if beyond(head, last).is_lt() {
            events.push(self.event_at_place(last, off));
        }
    }

    fn event_at_place(&self, index: usize, change: Change) -> Event<Q> {
        let (tail, head) = (self.tail, self.head);
        let ((ux, uy), (vx, vy)) = (tail.step(head), tail.step(self.field.place(index)));
        let near = (ux * vx + uy * vy) / (ux.square() + uy.square());
        Event { spot: Spot::Place { index }, near, exact: OnceCell::new(), change }
    }

    fn compare(&self, a: &Event<Q>, b: &Event<Q>) -> Ordering {
        if std::ptr::eq(a, b) {
            return Ordering::Equal;
        }
        a.near.compare(b.near).unwrap_or_else(|| self.parameter(a).cmp(self.parameter(b)))
    }

    /// The exact parameter of an event.
    fn parameter<'e>(&self, event: &'e Event<Q>) -> &'e Q {
        event.exact.get_or_init(|| {
            let (a, b) = (self.tail, self.head);
            match event.spot {
                Spot::Crossing { other } => {
                    let (c, d) = self.field.ends(other);
                    let from = area_exact(&c.exact, &d.exact, &a.exact);
                    let to = area_exact(&c.exact, &d.exact, &b.exact);
                    from.over(&from.minus(&to))
                }
                Spot::Place { index } => {
                    let run = b.exact.minus(&a.exact);
                    let part = self.field.place(index).exact.minus(&a.exact);
                    part.dot(&run).over(&run.dot(&run))
                }
            }
        })
    }

    fn locate(&self, event: &Event<Q>) -> Point<Q> {
        let (a, b) = (self.tail, self.head);
        match event.spot {
            Spot::Crossing { .. } => a.exact.toward(&b.exact, self.parameter(event)),
            Spot::Place { index } => self.field.place(index).exact.clone(),
        }
    }
}

/// Ends all runs.
fn cut<Q, const R: usize>(runs: &mut [Option<Run<Q>>; R], edges: &mut [Vec<Edge<Q>>; R], here: impl Fn() -> Point<Q>) {
    for (run, edges) in runs.iter_mut().zip(edges) {
        edges.extend(run.take().map(|run| run.finish(here())));
    }
}

impl<Q> Run<Q> {
    fn finish(self, end: Point<Q>) -> Edge<Q> {
        if self.forward { (self.start, end) } else { (end, self.start) }
    }
}

//! The kinetic convolution: the sums of all pairs of boundary points with equal rightward normals (MS 3; memo B).
//!
//! A sweep over the angle keeps the curved segments of both regions whose angles contain the current one. Every overlapping
//! pair is met once, so the time is O((n+m) log(n+m) + K) for K sum segments. Angles are compared by value alone; at equal
//! angles a vertex of A comes before one of B (memo fact 7), so intervals of A are [low, high) and those of B (low, high].
//! That all comparisons follow one total order is what closes the convolution, however wrong the angles are.

use super::sums::{Placed, Sums};
use crate::angle::Ang;
use crate::chain::{Chain, Chains, Link};
use crate::smooth::{Kind, Smooth};

/// What happens at an angle, in this order: the order is the tie rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Stage {
    LinesOfA,
    Ends,
    Starts,
    LinesOfB,
}

/// An event of the sweep over the angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Event {
    angle: Ang,
    stage: Stage,
    operand: usize,
    index: usize,
}

/// Adds the convolution of two sequences of segments and turns.
pub fn convolve(sums: &mut Sums, sides: [Side; 2]) {
    let mut events: Vec<Event> = Vec::new();
    for (operand, side) in sides.iter().enumerate() {
        side.events(operand, &mut events);
    }
    events.sort_unstable();
    Sweep { active: [Active::new(&sides[0]), Active::new(&sides[1])], sides, sums }.run(&events);
}

/// The segments of one operand.
pub struct Side<'a> {
    segs: Vec<Placed<'a>>,
}

impl<'a> Side<'a> {
    /// Those of some loops.
    pub fn of_loops(region: &'a Smooth, loops: &[usize]) -> Self {
        let segs = loops.iter().flat_map(|&l| {
            let segs = region.loops[l].segs.iter().enumerate();
            segs.map(move |(i, seg)| Placed { seg, of_loop: l as u32, index: i as u32 })
        });
        Self { segs: segs.collect() }
    }

    /// Those of all smoothed chains of one kind.
    pub fn of_chains(chains: &'a Chains, upper: bool) -> Self {
        let links = |chain: &'a Chain| {
            let of_loop = chain.of_loop as u32;
            // A turn is found by its vertex, so those at the ends need no place.
            let placed =
                move |link: &'a Link| Placed { seg: &link.seg, of_loop, index: link.index.unwrap_or(0) as u32 };
            chain.links.iter().map(placed)
        };
        Self { segs: chains.chains.iter().filter(|chain| chain.upper == upper).flat_map(links).collect() }
    }

    fn events(&self, operand: usize, events: &mut Vec<Event>) {
        for (index, placed) in self.segs.iter().enumerate() {
            let event = |angle, stage| Event { angle, stage, operand, index };
            if placed.seg.kind == Kind::Line {
                let stage = if operand == 0 { Stage::LinesOfA } else { Stage::LinesOfB };
                events.push(event(placed.seg.a, stage));
            } else {
                let (low, high) = interval(placed);
                events.extend([event(low, Stage::Starts), event(high, Stage::Ends)]);
            }
        }
    }
}

/// The angle interval of a curved segment, counter-clockwise.
fn interval(placed: &Placed) -> (Ang, Ang) {
    let seg = placed.seg;
    if seg.delta > 0.0 { (seg.a, seg.b) } else { (seg.b, seg.a) }
}

/// The curved segments of one operand that contain the current angle: arcs and turns apart, because two turns have no sum.
struct Active {
    arcs: Vec<usize>,
    turns: Vec<usize>,
    /// Where a segment stands in its list, `usize::MAX` if it does not.
    slot: Vec<usize>,
}

impl Active {
    /// The segments that contain the angle just below 360 degrees, or end there.
    fn new(side: &Side) -> Self {
        let mut active = Self { arcs: Vec::new(), turns: Vec::new(), slot: vec![usize::MAX; side.segs.len()] };
        for (index, placed) in side.segs.iter().enumerate() {
            if placed.seg.kind != Kind::Line {
                let (low, high) = interval(placed);
                if low > high {
                    active.insert(index, placed);
                }
            }
        }
        active
    }

    fn list(&mut self, placed: &Placed) -> &mut Vec<usize> {
        if placed.seg.kind == Kind::Turn { &mut self.turns } else { &mut self.arcs }
    }

    fn insert(&mut self, index: usize, placed: &Placed) {
        let list = self.list(placed);
        list.push(index);
        self.slot[index] = list.len() - 1;
    }

    fn remove(&mut self, index: usize, placed: &Placed) {
        let slot = std::mem::replace(&mut self.slot[index], usize::MAX);
        if slot == usize::MAX {
            return;
        }
        let list = self.list(placed);
        list.swap_remove(slot);
        if let Some(&moved) = list.get(slot) {
            self.slot[moved] = slot;
        }
    }
}

struct Sweep<'s, 'a, 'r> {
    sides: [Side<'a>; 2],
    active: [Active; 2],
    sums: &'s mut Sums<'r>,
}

impl Sweep<'_, '_, '_> {
    fn run(mut self, events: &[Event]) {
        for event in events {
            let placed = self.sides[event.operand].segs[event.index];
            match event.stage {
                Stage::LinesOfA => self.line(0, placed),
                Stage::LinesOfB => self.line(1, placed),
                Stage::Ends => self.active[event.operand].remove(event.index, &placed),
                Stage::Starts => {
                    self.start(event.operand, placed, event.angle);
                    self.active[event.operand].insert(event.index, &placed);
                }
            }
        }
    }

    fn line(&mut self, operand: usize, line: Placed) {
        let (segs, active) = (&self.sides[1 - operand].segs, &self.active[1 - operand]);
        for &other in active.arcs.iter().chain(&active.turns) {
            if operand == 0 {
                self.sums.line_of_a(line, segs[other]);
            } else {
                self.sums.line_of_b(line, segs[other]);
            }
        }
    }

    /// A curved segment begins: it shares angles with all active ones of the other operand from here on.
    fn start(&mut self, operand: usize, new: Placed, angle: Ang) {
        let (segs, active) = (&self.sides[1 - operand].segs, &self.active[1 - operand]);
        let turns: &[usize] = if new.seg.kind == Kind::Turn { &[] } else { &active.turns };
        let end = |placed: &Placed| {
            let (_, high) = interval(placed);
            (high <= angle, high)
        };
        for &other in active.arcs.iter().chain(turns) {
            let other = segs[other];
            let (_, high) = end(&new).min(end(&other));
            let (x, y) = if operand == 0 { (new, other) } else { (other, new) };
            self.sums.curved(x, y, angle, high);
        }
    }
}

//! The kinetic convolution by walking the fiber product (memo B2): an independent second way to the same sum segments.
//!
//! A pair of boundary points with equal normals moves along both boundaries at once. The walk follows it from pair of
//! segments to pair of segments until it is back: where one boundary turns back in angle, so does the walk on the other.

use arcsum::angle::Ang;
use arcsum::smooth::{Kind, Seg};
use std::collections::HashSet;

/// A sum segment: the places of its summands in the two loops, and the ends of the shared angles, `low` to `high`
/// counter-clockwise. Lines have equal ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Shared {
    /// Place in the loop of A.
    pub a: usize,
    /// Place in the loop of B.
    pub b: usize,
    /// Least shared angle.
    pub low: Ang,
    /// Greatest shared angle.
    pub high: Ang,
}

/// A position on the circle of angles after the perturbation that puts A before B: the angle, then whose vertex it is.
type Key = (Ang, u8);

fn low(seg: &Seg, whose: u8) -> Key {
    (if seg.delta > 0.0 { seg.a } else { seg.b }, whose)
}

fn high(seg: &Seg, whose: u8) -> Key {
    (if seg.delta > 0.0 { seg.b } else { seg.a }, whose)
}

/// Whether `x` lies in the half-open way from `from` to `to`, counter-clockwise: from included.
fn between(from: Key, x: Key, to: Key) -> bool {
    if from <= to { from <= x && x < to } else { from <= x || x < to }
}

/// Where two curved segments begin to share angles, if they do: at one or two places.
fn meetings(a: &Seg, b: &Seg) -> Vec<Key> {
    let ((la, ha), (lb, hb)) = ((low(a, 0), high(a, 0)), (low(b, 1), high(b, 1)));
    let mut out = Vec::new();
    if between(lb, la, hb) {
        out.push(la);
    }
    if between(la, lb, ha) {
        out.push(lb);
    }
    out
}

/// A walk's state: two curved segments and where their shared angles begin.
type State = (usize, usize, Key);

/// All sum segments of two loops, and whether every walk came back to its start.
#[must_use]
pub fn convolution(a: &[Seg], b: &[Seg]) -> (Vec<Shared>, bool) {
    let mut seen: HashSet<State> = HashSet::new();
    let (mut out, mut closed) = (Vec::new(), true);
    for (i, x) in a.iter().enumerate().filter(|(_, s)| s.kind != Kind::Line) {
        for (j, y) in b.iter().enumerate().filter(|(_, s)| s.kind != Kind::Line) {
            for begin in meetings(x, y) {
                if !seen.contains(&(i, j, begin)) {
                    closed &= Walk { a, b, seen: &mut seen, out: &mut out }.run((i, j, begin));
                }
            }
        }
    }
    out.sort_unstable();
    (out, closed)
}

struct Walk<'w> {
    a: &'w [Seg],
    b: &'w [Seg],
    seen: &'w mut HashSet<State>,
    out: &'w mut Vec<Shared>,
}

impl Walk<'_> {
    /// Walks from a state, first towards growing angles, until the state comes back.
    fn run(&mut self, start: State) -> bool {
        let (mut state, mut growing) = (start, true);
        let limit = 4 * self.a.len() * self.b.len() + 4;
        for _ in 0..limit {
            self.visit(state);
            (state, growing) = self.step(state, growing);
            if state == start && growing {
                return true;
            }
        }
        false
    }

    fn end(&self, (i, j, begin): State) -> Key {
        let (ha, hb) = (high(&self.a[i], 0), high(&self.b[j], 1));
        if between(begin, ha, hb) { ha } else { hb }
    }

    fn visit(&mut self, state: State) {
        if self.seen.insert(state) {
            let (a, b, begin) = state;
            let (x, y) = (self.a[a].kind, self.b[b].kind);
            let shared = Shared { a, b, low: begin.0, high: self.end(state).0 };
            if (x, y) != (Kind::Turn, Kind::Turn) && shared.low != shared.high {
                self.out.push(shared);
            }
        }
    }

    /// Leaves a pair at the end of its shared angles towards which the walk goes.
    fn step(&mut self, state: State, growing: bool) -> (State, bool) {
        let (i, j, begin) = state;
        let at = if growing { self.end(state) } else { begin };
        if at.1 == 0 {
            let (i, growing) =
                leave(self.a, i, growing, |line| self.out.push(Shared { a: line, b: j, low: at.0, high: at.0 }));
            (self.state(i, j, at, growing), growing)
        } else {
            let (j, growing) =
                leave(self.b, j, growing, |line| self.out.push(Shared { a: i, b: line, low: at.0, high: at.0 }));
            (self.state(i, j, at, growing), growing)
        }
    }

    /// The state of a pair entered at `at`: that is where its shared angles begin if the walk goes on upwards, else where
    /// they end.
    fn state(&self, i: usize, j: usize, at: Key, growing: bool) -> State {
        if growing {
            return (i, j, at);
        }
        let (la, lb) = (low(&self.a[i], 0), low(&self.b[j], 1));
        // Going down from `at`, the nearer of the two lower ends comes first.
        let begin = if between(la, lb, at) { lb } else { la };
        (i, j, begin)
    }
}

/// Leaves a curved segment at its upper (growing) or lower end, passing the lines there. Returns the next curved segment
/// and whether the angle grows along it.
fn leave(segs: &[Seg], from: usize, growing: bool, mut line: impl FnMut(usize)) -> (usize, bool) {
    let n = segs.len();
    // Along a convex segment the angle grows with the traversal.
    let forwards = (segs[from].delta > 0.0) == growing;
    let mut at = from;
    loop {
        at = if forwards { (at + 1) % n } else { (at + n - 1) % n };
        if segs[at].kind != Kind::Line {
            return (at, (segs[at].delta > 0.0) == forwards);
        }
        line(at);
    }
}

//! Chains and turning points: where a boundary turns back in x (MS 2; memo E1).
//!
//! A loop falls into upper chains, whose normals point up and which run to the left, and lower chains, whose normals point
//! down. A vertical goes with its two neighbours if these agree; else it is upper when it goes up. So chains are weakly
//! x-monotone, and two of them meet at every turning point. A chain is smoothed with turns from the direction of its
//! tail's vertical ray to its first normal, and from its last normal to that of its head's.

use crate::angle::Ang;
use crate::smooth::{Kind, Seg, Smooth};

/// A smoothed chain.
#[derive(Clone, Debug)]
pub struct Chain {
    /// Its loop, an index of [`Smooth::loops`].
    pub of_loop: usize,
    /// Whether the region lies below it.
    pub upper: bool,
    /// Its segments and turns in the order of traversal.
    pub links: Vec<Link>,
}

/// A segment or turn of a chain.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// What it is.
    pub seg: Seg,
    /// Its place in its loop; none for the turns at the ends of the chain.
    pub index: Option<usize>,
}

/// A vertex where an upper and a lower chain meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Turning {
    /// The vertex, an index of [`Smooth::points`].
    pub vertex: u32,
    /// Whether both chains have it as their left end.
    pub left: bool,
    /// Whether the lower chain is above the upper one there.
    pub concave: bool,
    /// The upper chain.
    pub upper: usize,
    /// The lower chain.
    pub lower: usize,
}

/// The chains of some loops and the points where they meet.
#[derive(Clone, Debug, Default)]
pub struct Chains {
    /// The chains.
    pub chains: Vec<Chain>,
    /// The turning points.
    pub turnings: Vec<Turning>,
    /// For each chain the turning points at its left and at its right end.
    pub ends: Vec<[usize; 2]>,
    /// The chain of each segment of each loop, and the lower and the upper chain of each vertex.
    of_segment: Vec<Vec<usize>>,
    of_vertex: Vec<[usize; 2]>,
}

/// No chain.
const NONE: usize = usize::MAX;

impl Chain {
    /// The first vertex.
    #[must_use]
    pub fn tail(&self) -> u32 {
        self.links[0].seg.tail
    }

    /// The last vertex.
    #[must_use]
    pub fn head(&self) -> u32 {
        self.links[self.links.len() - 1].seg.head
    }
}

impl Chains {
    /// The chains of these loops of a region.
    #[must_use]
    pub fn new(region: &Smooth, loops: &[usize]) -> Self {
        let mut all = Self {
            of_segment: vec![Vec::new(); region.loops.len()],
            of_vertex: vec![[NONE; 2]; region.points.len()],
            ..Self::default()
        };
        for &of_loop in loops {
            all.of_segment[of_loop] = vec![NONE; region.loops[of_loop].segs.len()];
            all.add(of_loop, &region.loops[of_loop].segs);
        }
        all
    }

    /// The chain of a segment, given by its loop and its place there.
    #[must_use]
    pub fn of_segment(&self, of_loop: usize, index: usize) -> usize {
        self.of_segment[of_loop][index]
    }

    /// The upper or lower chain that passes or ends at a vertex; there is one.
    #[must_use]
    pub fn of_vertex(&self, vertex: u32, upper: bool) -> usize {
        self.of_vertex[vertex as usize][usize::from(upper)]
    }

    fn add(&mut self, of_loop: usize, segs: &[Seg]) {
        let labels = labels(segs);
        let n = segs.len();
        let starts: Vec<usize> = (0..n)
            .filter(|&i| {
                let Some(upper) = labels[i] else { return false };
                (1..=n).find_map(|k| labels[(i + n - k) % n]).is_some_and(|before| before != upper)
            })
            .collect();
        let first = self.chains.len();
        for (k, &start) in starts.iter().enumerate() {
            let end = starts[(k + 1) % starts.len()];
            let length = (end + n - start - 1) % n + 1;
            let mut run: Vec<usize> = (0..length).map(|i| (start + i) % n).collect();
            // What comes after the last segment is the turn at the turning point.
            while run.last().is_some_and(|&i| segs[i].kind == Kind::Turn) {
                run.pop();
            }
            let upper = labels[start] == Some(true);
            for &i in &run {
                self.of_segment[of_loop][i] = first + k;
                for vertex in [segs[i].tail, segs[i].head] {
                    self.of_vertex[vertex as usize][usize::from(upper)] = first + k;
                }
            }
            self.chains.push(Chain { of_loop, upper, links: smoothed(segs, &run, upper) });
            let after = first + (k + 1) % starts.len();
            self.turnings.push(turning(segs, end, upper, first + k, after));
            // The turning point at the head has the chain's number, that at the tail the one before.
            let (head, tail) = (first + k, first + (k + starts.len() - 1) % starts.len());
            self.ends.push(if upper { [head, tail] } else { [tail, head] });
        }
    }
}

/// Whether each line or arc belongs to an upper chain; none for turns.
fn labels(segs: &[Seg]) -> Vec<Option<bool>> {
    let is_vertical = |s: &Seg| s.kind == Kind::Line && (s.a == Ang::RIGHT || s.a == Ang::LEFT);
    let points_up = |angle: Ang| Ang::RIGHT < angle && angle < Ang::LEFT;
    let own = |s: &Seg| (s.kind != Kind::Turn && !is_vertical(s)).then(|| points_up(s.a) || points_up(s.b));
    let own: Vec<Option<bool>> = segs.iter().map(own).collect();
    let n = segs.len();
    let near = |i: usize, step: usize| (1..n).find_map(|k| own[(i + k * step) % n]);
    (0..n)
        .map(|i| match segs[i].kind {
            Kind::Line if is_vertical(&segs[i]) => {
                let (before, after) = (near(i, n - 1)?, near(i, 1)?);
                Some(if before == after { before } else { segs[i].a == Ang::RIGHT })
            }
            _ => own[i],
        })
        .collect()
}

/// The links of a chain with the turns at its ends.
fn smoothed(segs: &[Seg], run: &[usize], upper: bool) -> Vec<Link> {
    let (from, to) = if upper { (Ang::RIGHT, Ang::LEFT) } else { (Ang::LEFT, Ang::RIGHT) };
    let (first, last) = (segs[run[0]], segs[run[run.len() - 1]]);
    let links = run.iter().map(|&i| Link { seg: segs[i], index: Some(i) });
    let tail = end_turn(first.tail, from, first.a, first.edge);
    let head = end_turn(last.head, last.b, to, last.edge);
    tail.into_iter().chain(links).chain(head).collect()
}

/// A counter-clockwise turn of at most 180 degrees, if it turns at all.
fn end_turn(vertex: u32, a: Ang, b: Ang, edge: u32) -> Option<Link> {
    let seg = Seg { kind: Kind::Turn, tail: vertex, head: vertex, a, b, delta: a.turn_to(b).abs() / 2.0, r: 0.0, edge };
    (a != b).then_some(Link { seg, index: None })
}

/// The turning point before the segment at `next`, where a chain ends and another starts.
fn turning(segs: &[Seg], next: usize, upper: bool, chain: usize, after: usize) -> Turning {
    let before = &segs[(next + segs.len() - 1) % segs.len()];
    let concave = match before.kind {
        Kind::Turn => before.delta < 0.0,
        // No turn: the chains go over into each other on a vertical.
        _ => before.b == if upper { Ang::RIGHT } else { Ang::LEFT },
    };
    let (upper_chain, lower_chain) = if upper { (chain, after) } else { (after, chain) };
    Turning { vertex: segs[next].tail, left: upper, concave, upper: upper_chain, lower: lower_chain }
}

//! The monotonic convolution: the crusts of all pairs of chains, and the boundaries moved by concave turning points
//! (MS 5; memo E).
//!
//! Its winding number is O - F - T: the pairs of facing chains that overlap, less those that do face, less the concave
//! turning points inside the other region. It is positive where the regions overlap and 0 where they do not, if the fill
//! rule has made their overlap simply connected. The moved boundaries, T segments, run backwards (memo fact 8). Where a crust
//! runs along one, the two cancel. That is known from what the pieces are sums of, never from coordinates.

use super::buckets::into_buckets;
use super::cancelled::Cancelled;
use super::crust::{Rule, crust};
use super::fill::Filled;
use super::kinetic::{Side, convolve};
use super::order::{Group, Kind, Order, Role};
use super::sums::{Placed, Summand, Sums, Taken};
use crate::arrangement::cross::CrossingModule;
use crate::chain::{Chain, Chains, Turning};
use crate::part::part;
use crate::piece::Piece;
use crate::smooth::Kind as SegKind;
use glam::DVec2;

/// The monotonic convolution of two components.
pub struct Monotonic<'s, 'a, M> {
    sums: &'s mut Sums<'a>,
    order: &'s mut Order,
    rule: Rule,
    module: &'s M,
    chains: [Chains; 2],
    /// The stretches of crusts that lie on moved boundaries.
    cancelled: Cancelled,
}

impl<'s, 'a, M: CrossingModule> Monotonic<'s, 'a, M> {
    /// Makes ready for two components.
    pub fn new(sums: &'s mut Sums<'a>, order: &'s mut Order, filled: &Filled, (rule, module): (Rule, &'s M)) -> Self {
        let (a, b) = sums.regions();
        let chains = [Chains::new(a, &filled.a), Chains::new(b, &filled.b)];
        order.begin(chains.each_ref().map(|chains| chains.turnings.len()));
        Self { sums, order, rule, module, chains, cancelled: Cancelled::default() }
    }

    /// Adds their convolution.
    pub fn convolve(mut self) {
        self.crusts(true);
        self.crusts(false);
        for operand in 0..2 {
            for turning in 0..self.chains[operand].turnings.len() {
                if self.chains[operand].turnings[turning].concave {
                    self.move_by(operand, turning);
                }
            }
        }
    }

    /// Adds the crusts of all pairs of upper, or lower, chains.
    fn crusts(&mut self, upper: bool) {
        let first = self.sums.len();
        self.sums.forward_only = true;
        convolve(self.sums, self.chains.each_ref().map(|chains| Side::of_chains(chains, upper)));
        self.sums.forward_only = false;
        let taken = self.sums.take_from(first);
        let kind = |operand: usize| {
            let chains = self.chains[operand].chains.iter().enumerate();
            chains.filter(|(_, chain)| chain.upper == upper).map(|(i, _)| i).collect::<Vec<_>>()
        };
        let (of_a, of_b) = (kind(0), kind(1));
        let (firsts, sorted) = self.by_pair(&taken, upper);
        let width = self.chains[1].chains.len();
        for &i in &of_a {
            for &j in &of_b {
                let [start, end] = [0, 1].map(|next| firsts[i * width + j + next] as usize);
                self.crust([i, j], &taken, &sorted[start..end]);
            }
        }
    }

    /// The sum segments that run forward, by the pair of chains that they are sums of: where those of each pair start, and
    /// all of them.
    fn by_pair(&mut self, taken: &Taken, upper: bool) -> (Vec<u32>, Vec<u32>) {
        let points: &[DVec2] = self.sums.points();
        let forward: Vec<bool> = taken.pieces.iter().map(|piece| self.rule.takes(piece, points, upper)).collect();
        let width = self.chains[1].chains.len();
        let pair = |k: usize| {
            let [i, j] = [0, 1].map(|operand| self.chain_of(operand, taken.summands[k][operand], upper));
            i * width + j
        };
        let pairs: Vec<(usize, u32)> =
            (0..forward.len()).filter(|&k| forward[k]).map(|k| (pair(k), k as u32)).collect();
        into_buckets(self.chains[0].chains.len() * width, &pairs)
    }

    /// The chain of one kind that a summand belongs to.
    fn chain_of(&self, operand: usize, summand: Summand, upper: bool) -> usize {
        match summand {
            Summand::Vertex(vertex) => self.chains[operand].of_vertex(vertex, upper),
            Summand::Segment(of_loop, index) => self.chains[operand].of_segment(of_loop as usize, index as usize),
        }
    }

    /// Adds the crust of two chains, but for what cancels.
    fn crust(&mut self, [i, j]: [usize; 2], taken: &Taken, own: &[u32]) {
        let (a, b) = (&self.chains[0].chains[i], &self.chains[1].chains[j]);
        let crust = crust(self.sums, [a, b], taken, own, self.module);
        let (upper, closer) = (a.upper, [Summand::Vertex(a.tail()), Summand::Vertex(b.tail())]);
        let kind = if upper { Kind::UpperCrust } else { Kind::LowerCrust };
        let roles = [true, false].map(|left| {
            let turnings = [self.turning_of(0, i, left), self.turning_of(1, j, left)];
            (self.group(turnings), kind)
        });
        for span in &crust.spans {
            let summands = taken.summands[span.piece];
            let Some((operand, turning)) = self.concave_end([i, j], summands) else {
                let piece = crust.piece(self.sums.points(), taken, span);
                self.push(piece, summands, &roles);
                continue;
            };
            let ends = [span.left, span.right];
            self.cancelled.push(summands, ends);
            let left = self.chains[operand].turnings[turning].left;
            let range = ends.map(|v| self.sums.points()[v as usize].x);
            self.order.cancel((roles[usize::from(!left)].0, moved(1 - operand, upper)), range);
        }
        let closers: Vec<Piece> = crust.closers(self.sums.points()).collect();
        for piece in closers {
            self.push(piece, closer, &roles);
        }
    }

    /// The concave turning point, at an end of one of two chains, that is a summand of a piece of their crust.
    fn concave_end(&self, chains: [usize; 2], summands: [Summand; 2]) -> Option<(usize, usize)> {
        (0..2).find_map(|operand| {
            let Summand::Vertex(vertex) = summands[operand] else { return None };
            let turning = [true, false].map(|left| self.turning_of(operand, chains[operand], left)).into_iter();
            let is_it = |t: &usize| {
                let turning = &self.chains[operand].turnings[*t];
                turning.vertex == vertex && turning.concave
            };
            turning.into_iter().find(is_it).map(|turning| (operand, turning))
        })
    }

    /// Adds the boundary of one region, run backwards, moved by a turning point of the other, but for what cancels.
    fn move_by(&mut self, operand: usize, turning: usize) {
        let Turning { vertex, left, .. } = self.chains[operand].turnings[turning];
        let other = 1 - operand;
        for chain in 0..self.chains[other].chains.len() {
            let mut turnings = [turning; 2];
            turnings[other] = self.turning_of(other, chain, left);
            let role = (self.group(turnings), moved(other, self.chains[other].chains[chain].upper));
            let first = self.sums.len();
            segments(&self.chains[other].chains[chain], |placed| {
                if operand == 0 {
                    self.sums.reversed_by_vertex_of_a(vertex, placed);
                } else {
                    self.sums.reversed_by_vertex_of_b(placed, vertex);
                }
            });
            let Taken { pieces, summands } = self.sums.take_from(first);
            for (piece, summands) in pieces.into_iter().zip(summands) {
                self.push_rest(&piece, summands, role);
            }
        }
    }

    /// Adds what is left of a moved segment between the stretches that crusts run along.
    fn push_rest(&mut self, piece: &Piece, summands: [Summand; 2], role: Role) {
        let x = |v: u32, sums: &mut Sums| sums.points()[v as usize].x;
        // A segment with stretches of a crust on it is not vertical.
        let rightward = x(piece.tail, self.sums) < x(piece.head, self.sums);
        let (mut from, right) = if rightward { (piece.tail, piece.head) } else { (piece.head, piece.tail) };
        let mut next = self.cancelled.first(&summands);
        loop {
            let gone = next.map(|index| self.cancelled.stretches[index as usize]);
            let to = gone.map_or(right, |stretch| stretch.ends[0]);
            if from != to {
                let (tail, head) = if rightward { (from, to) } else { (to, from) };
                let rest = part(self.sums.points(), piece, tail, head);
                self.push(rest, summands, &[role]);
            }
            let Some(stretch) = gone else { break };
            (from, next) = (stretch.ends[1], stretch.next);
        }
    }

    fn push(&mut self, piece: Piece, summands: [Summand; 2], roles: &[Role]) {
        let [p, q] = [piece.tail, piece.head].map(|v| self.sums.points()[v as usize].x);
        self.sums.push(piece, summands);
        self.order.push([p.min(q), p.max(q)], roles);
    }

    /// The turning point at an end of a chain.
    fn turning_of(&self, operand: usize, chain: usize, left: bool) -> usize {
        self.chains[operand].ends[chain][usize::from(!left)]
    }

    /// The pair of two turning points of one handedness.
    fn group(&mut self, turnings: [usize; 2]) -> u32 {
        let Self { chains, sums, .. } = self;
        self.order.group(turnings, || group(sums, chains, turnings))
    }
}

/// What a pair of two turning points is like.
fn group(sums: &Sums, chains: &[Chains; 2], turnings: [usize; 2]) -> Group {
    let [p, q] = [0, 1].map(|operand| chains[operand].turnings[turnings[operand]]);
    // The ends of the chains that are not at the turning points.
    let far = |operand: usize, chain: usize| {
        let chain = &chains[operand].chains[chain];
        if chain.upper == p.left { chain.tail() } else { chain.head() }
    };
    let (a, b) = ([p.lower, p.upper].map(|c| far(0, c)), [q.lower, q.upper].map(|c| far(1, c)));
    let shorter = |operand: usize, [u, v]: [u32; 2]| {
        let x = |vertex: u32| sums.region(operand).points[vertex as usize].x;
        if (x(u) < x(v)) == p.left { u } else { v }
    };
    let common = [shorter(0, a), shorter(1, b)];
    let x = |p: u32, q: u32| sums.corner_x(p, q);
    let ends =
        [x(a[0], b[0]), x(a[1], b[1]), x(a[0], q.vertex), x(a[1], q.vertex), x(p.vertex, b[0]), x(p.vertex, b[1])];
    let (concave, common) = ([p.concave, q.concave], x(common[0], common[1]));
    Group { left: p.left, turnings, concave, x: x(p.vertex, q.vertex), ends, common }
}

/// The kind of a chain of one region moved by a turning point of the other.
fn moved(operand: usize, upper: bool) -> Kind {
    match (operand, upper) {
        (0, false) => Kind::LowerOfA,
        (0, true) => Kind::UpperOfA,
        (_, false) => Kind::LowerOfB,
        (_, true) => Kind::UpperOfB,
    }
}

/// The lines and arcs of a chain.
fn segments(chain: &Chain, mut each: impl FnMut(Placed)) {
    for link in &chain.links {
        if let Some(index) = link.index.filter(|_| link.seg.kind != SegKind::Turn) {
            each(Placed { seg: &link.seg, of_loop: chain.of_loop as u32, index: index as u32 });
        }
    }
}

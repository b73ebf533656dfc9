//! The convolution order: what the chains of two regions say about the order of their sum segments (MS 7.1; memo E6).
//!
//! Two turning points of one handedness, p1 of A and p2 of B, where the chains U1, L1 and U2, L2 meet, have up to six kinds
//! of segments that share the end p1+p2: the crusts U1+U2 and L1+L2, and, where a turning point is concave, the chains of the
//! other region moved by it. Rounding may swap those of different kinds, though no perturbation of the regions does. The
//! sweep keeps them in this order instead.
//!
//! Rules 1 to 3 of MS hold wherever both segments run. Rule 4, L1+L2 <= U1+U2, does not: its proof needs a point above L2 and
//! below U2 at some abscissa v, and one of L1 and U1 at x - v, so it reaches only as far as the shorter chain of each pair.
//! Beyond, the crusts may cross (see [`crate::errata`]).

use super::stab::{Range, Ranges};
use crate::arrangement::curve::Curve;
use crate::arrangement::known::Known;
use crate::piece::Pieces;
use std::sync::OnceLock;

/// A kind of segment at a pair of turning points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// L1+L2.
    LowerCrust,
    /// U1+U2.
    UpperCrust,
    /// L1+p2.
    LowerOfA,
    /// U1+p2.
    UpperOfA,
    /// p1+L2.
    LowerOfB,
    /// p1+U2.
    UpperOfB,
}

/// Where a rule holds, besides that both segments are there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum When {
    /// Everywhere.
    Always,
    /// Where the turning point of this operand is convex, or concave.
    Turning { operand: usize, concave: bool },
    /// Where both are convex, as far as a lower and an upper chain of each reach.
    Convex,
    /// Where the turning point of this operand alone is convex, as far as segments of these kinds reach.
    While { operand: usize, kinds: [Kind; 2] },
    /// Where both are concave and a crust runs along segments of this kind.
    Along(Kind),
}

/// A row of the order table: the first kind is below the second.
type Row = (Kind, Kind, When);

/// The order table. Each row can be switched off.
const TABLE: [Row; 19] = {
    use Kind::{LowerCrust, LowerOfA, LowerOfB, UpperCrust, UpperOfA, UpperOfB};
    [
        (LowerCrust, LowerOfA, When::Always),
        (LowerCrust, LowerOfB, When::Always),
        (UpperOfA, UpperCrust, When::Always),
        (UpperOfB, UpperCrust, When::Always),
        (LowerOfA, UpperOfA, When::Turning { operand: 0, concave: false }),
        (UpperOfA, LowerOfA, When::Turning { operand: 0, concave: true }),
        (LowerOfB, UpperOfB, When::Turning { operand: 1, concave: false }),
        (UpperOfB, LowerOfB, When::Turning { operand: 1, concave: true }),
        (LowerCrust, UpperCrust, When::Convex),
        (LowerCrust, UpperCrust, When::While { operand: 0, kinds: [LowerOfA, UpperOfA] }),
        (LowerCrust, UpperOfA, When::While { operand: 0, kinds: [LowerOfA, LowerOfA] }),
        (LowerOfA, UpperCrust, When::While { operand: 0, kinds: [UpperOfA, UpperOfA] }),
        (LowerCrust, UpperCrust, When::While { operand: 1, kinds: [LowerOfB, UpperOfB] }),
        (LowerCrust, UpperOfB, When::While { operand: 1, kinds: [LowerOfB, LowerOfB] }),
        (LowerOfB, UpperCrust, When::While { operand: 1, kinds: [UpperOfB, UpperOfB] }),
        (UpperOfA, LowerOfB, When::Along(UpperOfB)),
        (UpperOfA, LowerOfB, When::Along(LowerOfA)),
        (UpperOfB, LowerOfA, When::Along(UpperOfA)),
        (UpperOfB, LowerOfA, When::Along(LowerOfB)),
    ]
};

/// The number of rows of the order table.
pub const ROWS: usize = TABLE.len();

/// A pair of turning points.
#[derive(Clone, Debug)]
pub struct Group {
    /// Whether the chains begin at them, from left to right.
    pub left: bool,
    /// Their places among the turning points of the two components.
    pub turnings: [usize; 2],
    /// Whether each is concave.
    pub concave: [bool; 2],
    /// The abscissa of their sum.
    pub x: f64,
    /// Where the segments of each kind end that begin there, by the order of [`Kind`].
    pub ends: [f64; 6],
    /// The same for the sum of the shorter chains of each operand.
    pub common: f64,
}

/// The rows about each two kinds of segments, in either order, [`ROWS`] where there are no more of them.
const ROWS_OF: [[[usize; 3]; 6]; 6] = {
    let mut rows = [[[ROWS; 3]; 6]; 6];
    let mut row = 0;
    while row < ROWS {
        let (lower, upper) = (TABLE[row].0 as usize, TABLE[row].1 as usize);
        let mut slot = 0;
        while rows[lower][upper][slot] != ROWS {
            slot += 1;
        }
        rows[lower][upper][slot] = row;
        rows[upper][lower][slot] = row;
        row += 1;
    }
    rows
};

/// Whether some row says that the first of two kinds is below the second, and whether some row says the opposite.
const SAYS: [[[bool; 2]; 6]; 6] = {
    let mut says = [[[false; 2]; 6]; 6];
    let mut row = 0;
    while row < ROWS {
        let (lower, upper) = (TABLE[row].0 as usize, TABLE[row].1 as usize);
        says[lower][upper][0] = true;
        says[upper][lower][1] = true;
        row += 1;
    }
    says
};

/// A pair of turning points with the stretches where a crust runs along a moved chain.
#[derive(Clone, Debug)]
struct Members {
    group: Group,
    along: Vec<(Kind, [f64; 2])>,
}

/// What a piece is at a pair of turning points.
pub type Role = (u32, Kind);

/// The order of the pieces of a convolution.
#[derive(Clone, Debug, Default)]
pub struct Order {
    groups: Vec<Members>,
    /// The group of each pair of turning points of the two components under way, `u32::MAX` if there is none yet.
    index: Vec<u32>,
    /// How many turning points the second component has.
    width: usize,
    roles: Vec<Role>,
    /// Where the roles of each piece end.
    ends: Vec<u32>,
    /// A bit or more a piece: two pieces without a common bit have no common group.
    marks: Vec<u64>,
    /// The abscissas of the pieces with their groups.
    members: Vec<(usize, Range)>,
    /// The same, once somebody has asked for them.
    ranges: OnceLock<Ranges>,
    /// A row of the order table that is not used, for tests that show what it is good for.
    pub without: Option<usize>,
}

impl Order {
    /// Makes ready for two components with so many turning points.
    pub fn begin(&mut self, turnings: [usize; 2]) {
        self.width = turnings[1];
        self.index.clear();
        self.index.resize(turnings[0] * turnings[1], u32::MAX);
    }

    /// The group of two turning points of these components, made if it is new.
    pub fn group(&mut self, turnings: [usize; 2], make: impl FnOnce() -> Group) -> u32 {
        let index = &mut self.index[turnings[0] * self.width + turnings[1]];
        if *index == u32::MAX {
            *index = self.groups.len() as u32;
            self.groups.push(Members { group: make(), along: Vec::new() });
        }
        *index
    }

    /// Gives the next piece, between these abscissas, its roles.
    pub fn push(&mut self, range: [f64; 2], roles: &[Role]) {
        let piece = self.ends.len() as u32;
        let [from, to] = range;
        self.members.extend(roles.iter().map(|(group, _)| (*group as usize, Range { from, to, item: piece })));
        self.marks.push(roles.iter().fold(0, |marks, (group, _)| marks | mark(*group)));
        self.roles.extend_from_slice(roles);
        self.ends.push(self.roles.len() as u32);
    }

    /// The order of parts of the pieces, given for each part its piece, if it is part of one.
    #[must_use]
    pub fn of_parts(&self, pieces: &Pieces, origins: &[Option<u32>]) -> Self {
        let mut order = Self { groups: self.groups.clone(), without: self.without, ..Self::default() };
        for (part, origin) in pieces.pieces.iter().zip(origins) {
            let [p, q] = [part.tail, part.head].map(|v| pieces.points[v as usize].x);
            order.push([p.min(q), p.max(q)], origin.map_or(&[], |piece| self.roles(piece)));
        }
        order
    }

    /// Notes that a crust runs along a moved chain of this kind between two abscissas.
    pub fn cancel(&mut self, (group, kind): Role, range: [f64; 2]) {
        self.groups[group as usize].along.push((kind, range));
    }

    /// What a piece is at the pairs of turning points that it belongs to.
    #[must_use]
    pub fn roles(&self, piece: u32) -> &[Role] {
        let start = if piece == 0 { 0 } else { self.ends[piece as usize - 1] };
        &self.roles[start as usize..self.ends[piece as usize] as usize]
    }

    /// A pair of turning points by its number.
    #[must_use]
    pub fn group_of(&self, (group, _): Role) -> &Group {
        &self.groups[group as usize].group
    }

    /// Adds the pieces at this abscissa with an end at the same sum of turning points as this one.
    pub fn related(&self, piece: u32, x: f64, found: &mut Vec<u32>) {
        let ranges = self.ranges.get_or_init(|| Ranges::new(self.groups.len(), &self.members));
        for (group, _) in self.roles(piece) {
            ranges.holding(*group as usize, x, found);
        }
    }

    /// Whether nothing is known about two pieces, wherever they are, but that the first is below the second, or else above.
    #[must_use]
    #[inline]
    pub fn agrees(&self, below: bool, f: u32, g: u32) -> bool {
        // Most neighbours have nothing to do with each other.
        self.marks[f as usize] & self.marks[g as usize] == 0 || self.agrees_on_related(below, f, g)
    }

    fn agrees_on_related(&self, below: bool, f: u32, g: u32) -> bool {
        let (of_f, of_g) = (self.roles(f), self.roles(g));
        let opposite = usize::from(below);
        let objects = |(group, kind): &Role| {
            let same = of_g.iter().filter(|(other, _)| other == group);
            same.into_iter().any(|(_, other)| SAYS[*kind as usize][*other as usize][opposite])
        };
        !of_f.iter().any(objects)
    }

    /// Whether one curve is below another just right of an abscissa, up to which both are active.
    #[must_use]
    pub fn known(&self, f: &Curve, g: &Curve, x: f64) -> Known {
        let (of_f, of_g) = (self.roles(f.piece), self.roles(g.piece));
        if !of_f.iter().any(|(group, _)| of_g.iter().any(|(other, _)| group == other)) {
            return Known::NOTHING;
        }
        let vertical = f.is_vertical() || g.is_vertical();
        // A vertical is compared only with what passes it: where two segments begin, end or jump at one abscissa, the rules
        // speak of what comes before and of what comes after, not of what is between.
        let silent = |curve: &Curve| match (vertical, curve.is_vertical()) {
            (false, _) => curve.end.x <= x,
            (true, false) => curve.start.x >= x || curve.end.x <= x,
            (true, true) => f.is_vertical() && g.is_vertical(),
        };
        let mut known = Known::NOTHING;
        if silent(f) || silent(g) {
            return known;
        }
        for (group, kind) in of_f {
            for (_, other) in of_g.iter().filter(|(same, _)| same == group) {
                let here = self.groups[*group as usize].known([*kind, *other], x, vertical, self.without);
                known = known.and(here);
            }
        }
        known
    }
}

/// The bit of a group.
fn mark(group: u32) -> u64 {
    1 << (group % 64)
}

impl Members {
    fn known(&self, [f, g]: [Kind; 2], x: f64, vertical: bool, without: Option<usize>) -> Known {
        let mut known = Known::NOTHING;
        for &row in ROWS_OF[f as usize][g as usize].iter().take_while(|row| **row < ROWS) {
            let (lower, _, when) = TABLE[row];
            let below = lower == f;
            if Some(row) == without {
                continue;
            }
            let Some(range) = self.range(when, x) else { continue };
            let [from, to] = self.common(range, [f, g]);
            // A vertical where some segment begins joins what comes before it with what comes after, and a rule speaks of
            // the latter only. At the sum of the turning points all begin.
            let begun = from < x || from == x && (self.group.left || !vertical);
            if from < to && x < to {
                let change = [from, from.next_up(), to].into_iter().find(|change| x < *change);
                let until = change.unwrap_or(f64::INFINITY);
                known = known.and(Known { below: begun.then_some(below), until, only: Some(below) });
            }
        }
        known
    }

    /// The abscissas at which a rule holds, as far as it knows: of several ranges the first that is not over yet.
    fn range(&self, when: When, x: f64) -> Option<[f64; 2]> {
        let Group { concave, common, ends, .. } = self.group;
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY];
        match when {
            When::Always => Some(everywhere),
            When::Turning { operand, concave: kind } => (concave[operand] == kind).then_some(everywhere),
            When::Convex => (concave == [false; 2]).then(|| self.up_to(common)),
            When::While { operand, kinds } => (!concave[operand] && concave[1 - operand])
                .then(|| kinds.map(|kind| self.up_to(ends[kind as usize])).into_iter().fold(everywhere, both)),
            When::Along(kind) => {
                let ranges =
                    self.along.iter().filter(|(of, range)| *of == kind && x < range[1]).map(|(_, range)| *range);
                ranges.min_by(|r, s| r[0].total_cmp(&s[0])).filter(|_| concave == [true; 2])
            }
        }
    }

    /// The part of a range in which segments of two kinds run.
    fn common(&self, range: [f64; 2], kinds: [Kind; 2]) -> [f64; 2] {
        kinds.map(|kind| self.up_to(self.group.ends[kind as usize])).into_iter().fold(range, both)
    }

    /// The abscissas between the sum of the turning points and another.
    fn up_to(&self, end: f64) -> [f64; 2] {
        if self.group.left { [self.group.x, end] } else { [end, self.group.x] }
    }
}

/// What two ranges have in common.
fn both(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].min(b[1])]
}

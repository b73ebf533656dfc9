//! The winding number of the monotonic convolution of polygons by definition: O - F - T (MS 5; memo E), in exact arithmetic
//! and without the engine.

use arcsum::region::Region;
use arcsum_oracle::chains::{Chain, Point, chains, concave, convolved, edges, rings, winding};
use arcsum_reports::bridge::plain;
use rug::Rational;

/// A connected polygon: its outer ring, then its holes.
type Part = Vec<Vec<Point>>;

/// What a monotonic convolution is made of.
#[derive(Clone, Debug)]
pub struct Monotone {
    pairs: Vec<[Side; 2]>,
}

/// One operand of a pair.
#[derive(Clone, Debug)]
struct Side {
    rings: Part,
    chains: Vec<Chain>,
    concave: Vec<Point>,
}

/// O, F and T at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// O: pairs of upper chains at the abscissa.
    pub overlapping: i32,
    /// F: pairs of chains of one kind with the point outside of their crust.
    pub facing: i32,
    /// T: the winding number of the boundaries moved by concave turning points.
    pub turnings: i32,
}

impl Counts {
    /// M = O - F - T.
    #[must_use]
    pub fn winding(self) -> i32 {
        self.overlapping - self.facing - self.turnings
    }
}

impl Monotone {
    /// The pairs of parts of two bounded polygons, the holes that no partner fits into filled (memo A8).
    #[must_use]
    pub fn new(a: &Region, b: &Region) -> Self {
        let (all_a, all_b) = (parts(&rings(&plain(a))), parts(&rings(&plain(b))));
        let pair = |p: &Part, q: &Part| [Side::new(filled(p, q)), Side::new(filled(q, p))];
        Self { pairs: all_a.iter().flat_map(|p| all_b.iter().map(move |q| pair(p, q))).collect() }
    }

    /// O, F and T at a point on no crust and no moved boundary.
    #[must_use]
    pub fn counts(&self, t: &Point) -> Counts {
        self.pairs.iter().fold(Counts::default(), |counts, [a, b]| {
            let (overlapping, facing) = crusts(a, b, t);
            let moved = |by: &Side, of: &Side| by.concave.iter().map(|p| of.moved(p, t)).sum::<i32>();
            Counts {
                overlapping: counts.overlapping + overlapping,
                facing: counts.facing + facing,
                turnings: counts.turnings + moved(a, b) + moved(b, a),
            }
        })
    }
}

/// How many pairs of upper chains there are at the abscissa of a point, and how many pairs of either kind have it outside.
fn crusts(a: &Side, b: &Side, t: &Point) -> (i32, i32) {
    let (mut overlapping, mut facing) = (0, 0);
    for (p, q) in a.chains.iter().flat_map(|p| b.chains.iter().map(move |q| (p, q))) {
        let crust = (p.upper == q.upper).then(|| convolved(&p.path, &q.path, &t[0], p.upper)).flatten();
        if let Some(y) = crust {
            overlapping += i32::from(p.upper);
            facing += i32::from(if p.upper { y < t[1] } else { y > t[1] });
        }
    }
    (overlapping, facing)
}

impl Side {
    fn new(rings: Part) -> Self {
        let by_ring: Vec<Vec<Chain>> = rings.iter().map(|ring| chains(ring)).collect();
        let concave = by_ring.iter().flat_map(|chains| concave(chains)).collect();
        Self { chains: by_ring.concat(), rings, concave }
    }

    /// The winding number of a point in the boundary moved by another.
    fn moved(&self, by: &Point, t: &Point) -> i32 {
        let t = [0, 1].map(|i| Rational::from(&t[i] - &by[i]));
        winding(self.rings.iter().flat_map(|ring| edges(ring)), &t)
    }
}

/// The connected parts of a polygon: every hole goes to the smallest outer ring around it.
fn parts(rings: &[Vec<Point>]) -> Vec<Part> {
    let (outer, holes): (Vec<_>, Vec<_>) = rings.iter().cloned().partition(|ring| area(ring) > 0);
    let mut parts: Vec<Part> = outer.into_iter().map(|ring| vec![ring]).collect();
    parts.sort_by_key(|part| area(&part[0]));
    for hole in holes {
        let inside = beside(&hole);
        let home = parts.iter_mut().find(|part| winding(edges(&part[0]), &inside) != 0);
        home.expect("holes lie in outer rings").push(hole);
    }
    parts
}

/// Twice the area of a ring, negative for holes.
fn area(ring: &[Point]) -> Rational {
    let cross = |[p, q]: [&Point; 2]| Rational::from(&p[0] * &q[1]) - Rational::from(&p[1] * &q[0]);
    edges(ring).map(cross).fold(Rational::new(), |sum, x| sum + x)
}

/// A point just left of the middle of the first edge, inside a polygon of small integers.
fn beside(ring: &[Point]) -> Point {
    let way = [0, 1].map(|i| Rational::from(&ring[1][i] - &ring[0][i]));
    let middle = |i: usize| Rational::from(&ring[0][i] + &ring[1][i]) / 2;
    [middle(0) - Rational::from(&way[1] / 10_000), middle(1) + Rational::from(&way[0] / 10_000)]
}

/// A part without the holes that another does not fit into.
fn filled(part: &Part, partner: &Part) -> Part {
    let fits = |hole: &Vec<Point>| {
        let (room, needed) = (size(hole), size(&partner[0]));
        room[0] >= needed[0] && room[1] >= needed[1]
    };
    part.iter().enumerate().filter(|(i, ring)| *i == 0 || fits(ring)).map(|(_, ring)| ring.clone()).collect()
}

/// Width and height.
fn size(ring: &[Point]) -> Point {
    [0, 1].map(|i| {
        let coordinates = || ring.iter().map(|p| &p[i]);
        let (least, most) = (coordinates().min().expect("corners"), coordinates().max().expect("corners"));
        Rational::from(most - least)
    })
}
